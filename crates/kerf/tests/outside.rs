//! Other software starts Kerf and reads what became of it: the start-up line, the system log.

use crate::shop::console::Console;
use crate::shop::{Did, Shop};

const PART: &str = "SA\nMX,1\nMX,2\n";

fn shop() -> Shop {
    let shop = Shop::new(&[("a.sbp", PART), ("rel.sbp", "M2,1,0\n"), ("fails.sbp", "MX,&none\n")]);
    shop.kerf("send SW,0 --quiet").exits(0);
    std::fs::remove_file(shop.file("data/SbSys.log")).unwrap();
    shop
}

fn sb3(shop: &Shop, line: &str) -> Did {
    Did::of(shop.command().args(["sb3", line]).output().unwrap())
}

/// The lines of the system log, digits of times and dates and check numbers left out.
fn log(shop: &Shop) -> Vec<String> {
    let text = shop.read("data/SbSys.log");
    let still = |item: &str| {
        let digits =
            |text: &str| text.chars().map(|c| if c.is_ascii_digit() { '0' } else { c }).collect();
        let moment = item.contains(':')
            || item.contains('-') && item.len() == 10 && !item.starts_with("kerf")
            || item.starts_with('~');
        if moment { digits(item) } else { item.to_owned() }
    };
    text.lines().map(|line| line.split(',').map(still).collect::<Vec<_>>().join(",")).collect()
}

fn tail() -> String {
    format!("00:00:00,0000-00-00,,sim,kerf-{},,,,,,,~0000000", env!("CARGO_PKG_VERSION"))
}

fn path(shop: &Shop, name: &str) -> String {
    std::fs::canonicalize(shop.file(name)).unwrap().display().to_string()
}

#[test]
fn sbp_log_sys_file() {
    let shop = shop();
    shop.kerf("send SP FP,a.sbp").exits(0);
    let a = path(&shop, "a.sbp");
    let expected = [
        format!("NFP,CUT,,,,,,{}", tail()),
        format!("NFP,PREVIEW,,,,,,{}", tail()),
        format!("{a},PREVIEW,00:00:00,{}", tail()),
        format!("NORMAL,Total Time,00:00:00,{}", tail()),
    ];
    assert_eq!(log(&shop), expected);
    shop.kerf("send UV --quiet")
        .exits(0)
        .says(&format!("settings and logs: {}", path(&shop, "data")));
}

#[test]
fn sbp_log_sys_start() {
    let shop = shop();
    shop.kerf("send UV --quiet").exits(0);
    let first = shop.read("data/SbSys.log").lines().next().unwrap().to_owned();
    assert_eq!(first.split(',').count(), 19, "{first}");
    assert!(first.starts_with("NFP,CUT,,,,,,"), "{first}");
    sb3(&shop, "a.sbp,1,4,,2").exits(0);
    assert_eq!(log(&shop)[2], format!("StartFile,CUT,1,4,,2,,{}", tail()));
}

#[test]
fn sbp_log_sys_partline() {
    let shop = shop();
    shop.write("outer.sbp", b"MX,.5\nFP,a.sbp\nPAUSE 3\n");
    shop.kerf("run outer.sbp --quiet").exits(0);
    let raw = shop.read("data/SbSys.log");
    let line = raw.lines().nth(1).unwrap();
    assert!(line.starts_with(&format!("{},CUT,00:00:04,", path(&shop, "outer.sbp"))), "{line}");
    assert_eq!(line.split(',').count(), 15, "{line}");
    assert_eq!(raw.lines().count(), 3, "the file that was called has no line of its own\n{raw}");
}

#[test]
fn sbp_log_sys_close() {
    let shop = shop();
    shop.kerf("run a.sbp --quiet").exits(0);
    sb3(&shop, "a.sbp,,4,,2").exits(0);
    let log = log(&shop);
    assert_eq!(log[2], format!("NORMAL,Total Time,00:00:00,{}", tail()));
    assert_eq!(log[5], format!("CLOSE2,Total Time,00:00:00,{}", tail()));
}

#[test]
fn sbp_log_sys_future() {
    let shop = shop();
    shop.kerf("registry set Operator Ann").exits(0);
    shop.kerf("registry set Serial 17").exits(0);
    shop.kerf("run a.sbp --quiet").exits(0);
    let log = log(&shop);
    assert!(log.iter().all(|line| line.contains(",17,Ann,,,,,~")), "{log:#?}");
}

#[test]
fn sbp_log_sys_check() {
    let shop = shop();
    shop.kerf("run a.sbp --quiet").exits(0);
    shop.kerf("log verify").exits(0);
    let edited = shop.read("data/SbSys.log").replace("CUT,00:00", "CUT,09:00");
    shop.write("data/SbSys.log", edited.as_bytes());
    shop.kerf("log verify").exits(1).says("SbSys.log:2: was changed");
    shop.kerf("log show").exits(0).says("CUT,09:00");
}

#[test]
fn sbp_val_vd_syslog() {
    let shop = shop();
    shop.kerf("send VD,,,,,,,,,,,0 --quiet").exits(0);
    let before = log(&shop).len();
    shop.kerf("run a.sbp --quiet").exits(0);
    assert_eq!(log(&shop).len(), before);
}

#[test]
fn sbp_cmd_uv() {
    let shop = shop();
    shop.kerf("settings load metric-2440x1220 --quiet").exits(0);
    let shown = shop.kerf("settings show").exits(0).out();
    let told = shop.kerf("send UV --quiet").exits(0).out();
    for letters in ["VD", "VB", "VC", "VI", "VL", "VN", "VH", "VP", "VR", "VS", "VU", "FS"] {
        let line = shown.lines().find(|line| line.starts_with(&format!("{letters},")));
        let line = line.unwrap_or_else(|| panic!("{letters} in {shown}"));
        assert!(told.contains(line), "{line} in {told}");
    }
    assert!(shown.starts_with("VD,,3,1,"), "in millimetres: {shown}");
    assert!(shown.lines().any(|line| line.starts_with("FS,/")), "the part folder: {shown}");
}

#[test]
fn sbp_cmd_us__at_the_command_line() {
    let shop = shop();
    shop.kerf("send VS,3,1.5 --quiet").exits(0);
    shop.kerf("settings save mine --quiet").exits(0);
    let before = shop.kerf("settings show").out();
    shop.kerf("send VS,1 --quiet").exits(0);
    shop.kerf("settings load mine --quiet").exits(0);
    assert_eq!(shop.kerf("settings show").out(), before);
    shop.kerf("settings list").exits(0).says("mine.sbd").says("simulated-96x48.sbd");
    shop.kerf("run data/settings/mine.sbd --quiet").exits(0);
}

#[test]
fn sbp_cmd_ud__problem_log() {
    let shop = shop();
    shop.kerf("run fails.sbp --quiet").exits(1);
    shop.kerf("registry set uValue seven").exits(0);
    let told = shop.kerf("send UD --quiet");
    told.exits(0)
        .says("uValue: seven")
        .says("last error: fails.sbp:1:")
        .says("inputs on")
        .says("port: ")
        .says("driver: simulated")
        .says("firmware: ");
    let kept = shop.read("data/problem.log");
    assert!(kept.contains("last error: fails.sbp:1:") && kept.contains("\nVS,"), "{kept}");
}

#[test]
fn sbp_ctl_sb3__as_a_command() {
    let shop = shop();
    sb3(&shop, "a.sbp,3,4,,2,0,2").exits(0).says("2 moves");
    shop.kerf("send UD --quiet").says("port: 3");
    for wrong in ["a.sbp,,8", "a.sbp,,4,,3", "a.sbp,,4,,,4", "a.sbp,,4,,,,3", "", "none.sbp,,6"] {
        sb3(&shop, wrong).exits(2);
    }
}

#[test]
fn sbp_ctl_sb3_file__names_with_blanks() {
    let shop = shop();
    shop.write("my part.sbp", PART.as_bytes());
    sb3(&shop, "\"my part.sbp\",,4").exits(0).says("2 moves");
    sb3(&shop, "my part.sbp,,4").exits(0).says("ran to its end");
}

#[test]
fn sbp_ctl_sb3_file__the_console_opens_nothing_beside_the_part_folder() {
    let shop = shop();
    std::fs::create_dir_all(shop.file("parts")).unwrap();
    let console = |line: &str| {
        let args = ["sb3", line, "--console", "--parts", "parts", "--listen", "127.0.0.1:0"];
        Did::of(shop.command().args(args).output().unwrap())
    };
    console("a.sbp,,6").exits(2).complains("is not in the part folder");
    console("none.sbp,,6").exits(2).complains("none.sbp, nor parts");
}

#[test]
fn sbp_ctl_sb3_port__is_kept() {
    let shop = shop();
    sb3(&shop, "a.sbp,5,4,,2").exits(0);
    sb3(&shop, "a.sbp,,4,,2").exits(0);
    shop.kerf("send UD --quiet").says("port: 5");
    sb3(&shop, "a.sbp,sim,4,,2").exits(0);
    sb3(&shop, "a.sbp,17,4").exits(2).complains("port is 1 to 16");
}

#[test]
fn sbp_ctl_sb3_open1() {
    let shop = shop();
    for (open, mode) in [("1", "CUT"), ("2", "PREVIEW"), ("3", "PREVIEW")] {
        let did = sb3(&shop, &format!("a.sbp,,{open}"));
        did.exits(3).complains("needs the console; nothing has moved");
        let log = log(&shop);
        assert_eq!(log[log.len() - 2], format!("StartFile,{mode},,{open},,,,{}", tail()));
        shop.kerf("registry get uPartFile").says(&path(&shop, "a.sbp"));
    }
    shop.kerf("sysvars").says("  1             0  ");
}

#[test]
fn sbp_ctl_sb3_open4() {
    let shop = shop();
    sb3(&shop, "a.sbp,,4").exits(0).says("ran to its end");
    shop.kerf("sysvars").says("  1             2  ");
    assert_eq!(log(&shop)[0], format!("StartFile,CUT,,4,,,,{}", tail()));
}

#[test]
fn sbp_ctl_sb3_open5() {
    let shop = shop();
    sb3(&shop, "a.sbp,,5").exits(0).says("2 moves");
    shop.kerf("sysvars").says("  1             0  ");
    assert_eq!(log(&shop)[0], format!("StartFile,PREVIEW,,5,,,,{}", tail()));
}

#[test]
fn sbp_ctl_sb3_open6() {
    let shop = shop();
    sb3(&shop, "a.sbp,,6").exits(0);
    assert_eq!(log(&shop)[0], format!("StartFile,CUT,,6,,,,{}", tail()));
    shop.kerf("sysvars").says("  1             0  ");
    shop.kerf("registry get uPartFile").says(&path(&shop, "a.sbp"));
    let get = ["send", "--quiet", "GetPartFileName, &f", "PRINT &f"];
    Did::of(shop.command().args(get).output().unwrap()).says(&path(&shop, "a.sbp"));
}

#[test]
fn sbp_ctl_sb3_timing() {
    let shop = shop();
    sb3(&shop, "a.sbp,,4,anything,2").exits(0);
    assert_eq!(log(&shop)[0], format!("StartFile,CUT,,4,anything,2,,{}", tail()));
}

#[test]
fn sbp_ctl_sb3_close2() {
    let shop = shop();
    sb3(&shop, "a.sbp,,4,,2").exits(0);
    sb3(&shop, "fails.sbp,,4,,2").exits(1);
    let stopped = shop.command().args(["sb3", "a.sbp,,4,,2", "--stop-at", ".2"]).output().unwrap();
    Did::of(stopped).exits(3);
}

#[test]
fn sbp_ctl_sb3_close1() {
    let shop = shop();
    let closes = shop.command().args(["sb3", "a.sbp,,4,,1", "--yes"]).output().unwrap();
    Did::of(closes).exits(0);
    assert_eq!(log(&shop)[2], format!("CLOSE1,Total Time,00:00:00,{}", tail()));
}

#[test]
fn sbp_flow_exit_shopbot__closes_with_a_line_in_the_log() {
    let shop = shop();
    shop.write("x.sbp", b"SO,3,1\nMX,1\nEXIT SHOPBOT\nMX,5\n");
    sb3(&shop, "x.sbp,,4").exits(0).says("ended by the program").says("1 move,");
    assert_eq!(log(&shop).last().unwrap(), &format!("NORMAL,Total Time,00:00:00,{}", tail()));
    shop.kerf("sysvars").says("  1             1  ");
}

#[test]
fn sbp_ctl_sb3_offset() {
    let shop = shop();
    shop.kerf("send M2,10,4 --quiet").exits(0);
    sb3(&shop, "rel.sbp,,4,,,,2").exits(0);
    shop.kerf("sysvars").says("  1            11  ").says("  2             4  ");
    sb3(&shop, "rel.sbp,,1,,,,2").exits(3);
    sb3(&shop, "rel.sbp,,4").exits(0);
    shop.kerf("sysvars").says("  1             1  ").says("  2             0  ");
}

#[test]
fn sbp_flow_exit_shopbot__may_end_the_server() {
    let shop = shop();
    shop.write("x.sbp", b"SO,3,1\nMX,1\nEXIT SHOPBOT\nMX,5\n");
    let mut console = Console::begin(&shop, &["--exit-with-program"]);
    console.carry_out("FP,x.sbp");
    assert_eq!(console.child.wait().unwrap().code(), Some(0));
    assert_eq!(log(&shop).last().unwrap(), &format!("NORMAL,Total Time,00:00:00,{}", tail()));
    shop.kerf("sysvars").says("  1             1  ");
}
