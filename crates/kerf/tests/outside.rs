//! How other software starts Kerf, passes commands in, and reads what became of it: the start-up line,
//! the system log, the registry.

#![allow(clippy::unwrap_used, clippy::expect_used, non_snake_case)]

mod shop;

use shop::console::Console;
use shop::{Did, Shop};

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
fn sbp_ctl_reg_ucommand() {
    let shop = shop();
    shop.kerf("registry set ShopBot/UserData/uCommand MX,9").exits(0);
    shop.kerf("run a.sbp --quiet").exits(0);
    shop.kerf("sysvars").says("  1             2  ");
    // While a file runs it waits for its end.
    let mut command = shop.command();
    let args = ["send", "--pace", "real", "PAUSE 2", "MX,3"];
    let running = command.args(args).stdout(std::process::Stdio::piped()).spawn().unwrap();
    std::thread::sleep(std::time::Duration::from_millis(900));
    shop.kerf("registry set ShopBot/UserData/uCommand MX,7").exits(0);
    let output = running.wait_with_output().unwrap();
    assert!(output.status.success());
    shop.kerf("sysvars").says("  1             7  ");
    shop.kerf("registry get uCommand").exits(1);
}

#[test]
fn sbp_ctl_reg() {
    let shop = shop();
    shop.kerf("reg set ShopBot/UserData/uValue 17").exits(0);
    assert_eq!(shop.kerf("reg get ShopBot/UserData/uValue").exits(0).out(), "17\n");
    assert_eq!(shop.kerf("reg get ShopBot/UserData/Status").exits(0).out(), "0\n");
}

#[test]
fn sbp_ctl_reg_paths() {
    let shop = shop();
    for key in ["uAppPath", "uUsrPath"] {
        let told = shop.kerf(&format!("registry get ShopBot/UserData/{key}")).exits(0).out();
        let folder = std::path::Path::new(told.trim_end());
        assert!(folder.is_absolute() && folder.is_dir(), "{key} {told}");
    }
}

#[test]
fn sbp_ctl_reg_paths__of_a_server() {
    let shop = shop();
    let console = Console::begin(&shop, &[]);
    let get = |key: &str| shop.kerf(&format!("registry get {key} --server {}", console.url));
    for key in ["uAppPath", "uUsrPath"] {
        let told = get(key).exits(0).out();
        let folder = std::path::Path::new(told.trim_end());
        assert!(folder.is_absolute() && folder.is_dir(), "{key} {told}");
    }
    assert_eq!(get("SpindleStatus").exits(0).out(), "0\n");
}

/// Waits until the file that other programs watch has these lines.
fn until_told(shop: &Shop, lines: &[&str]) {
    let file = shop.file("data").join("registry.txt");
    until(&lines.join(" "), || {
        let text = std::fs::read_to_string(&file).unwrap_or_default();
        lines.iter().all(|line| text.lines().any(|told| told == *line))
    });
}

#[test]
fn what_others_watch_is_true_of_a_machine_that_stands_and_after_a_kill() {
    let shop = shop();
    shop.write("wait.sbp", b"SO,2,1\nMSGBOX(Wait)\n");
    let mut console = Console::begin(&shop, &[]);
    console.carry_out("SO,3,1");
    until_told(&shop, &["Status=0", "OutPutSwitches=4"]);
    until("the same by HTTP", || console.ask("GET /api/registry/OutPutSwitches", "") == 4);
    console.carry_out("FP,wait.sbp");
    until_told(&shop, &["Status=9", "OutPutSwitches=6"]);
    console.child.kill().unwrap();
    console.child.wait().unwrap();
    let console = Console::begin(&shop, &[]);
    until_told(&shop, &["Status=0", "OutPutSwitches=0"]);
    drop(console);
}

#[test]
fn nobody_sets_what_the_machine_tells() {
    let shop = shop();
    shop.kerf("registry set ShopBot/UserData/Status 7")
        .exits(2)
        .complains("the machine tells Status");
    std::fs::write(shop.file("data").join("registry.in"), "Status=3\n=5\nuValue=8\n").unwrap();
    shop.kerf("send MX,1 --quiet").exits(0);
    assert_eq!(shop.kerf("registry get uValue").exits(0).out(), "8\n");
    let text = std::fs::read_to_string(shop.file("data").join("registry.txt")).unwrap();
    assert_eq!(text.matches("Status=").count(), 1, "{text}");
    assert!(text.lines().all(|line| !line.starts_with('=')), "{text}");
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

#[cfg(unix)]
#[test]
fn sbp_ctl_api__the_command_line_goes_through_it() {
    let shop = shop();
    shop.write("ask.sbp", b"INPUT \"How far?\" &x\nPRINT \"going to \"; &x\nMX,&x\nGetUsrVal &u\nPRINT &u\nPAUSE\nMY,1\n");
    shop.write("answers.txt", b"3\nOK\n");
    shop.write("long.sbp", b"MX,4000\n");
    shop.write("wrong.sbp", b"QQ,1\n");
    let console = Console::begin(&shop, &[]);
    let on = |what: &str| shop.kerf(&format!("{what} --server {}", console.url));
    on("registry set ShopBot/UserData/uValue a|b").exits(0);
    on("registry get uValue").exits(0).says("a|b\n");
    on("registry get").says("uValue=a|b").says("Status=0");
    on("registry get nothing").exits(1).complains("nothing has no value");
    on("run ask.sbp --answers answers.txt").exits(1).complains("arm it first");
    on("run ask.sbp --answers answers.txt --arm").exits(0).says("going to 3\n").says("a|b\n");
    let at = console.ask("GET /api/state", "")["motion"]["at"]["working"].clone();
    assert!(
        (at[0].as_f64().unwrap() - 76.2).abs() < 1e-6
            && (at[1].as_f64().unwrap() - 25.4).abs() < 1e-6
    );
    on("run wrong.sbp --arm").exits(1);
    on("run nowhere.sbp --arm").exits(1);
    on("registry set uValue").exits(0);
    on("registry get uValue").exits(1);
    // Ctrl-C stops the machine of the server; nobody answers whether it goes on.
    let mut command = shop.command();
    let url = &console.url;
    let mut running = command.args(["run", "long.sbp", "--arm", "--server", url]).spawn().unwrap();
    while console.ask("GET /api/state", "")["machine"]["state"] != "running" {
        assert!(running.try_wait().unwrap().is_none(), "it ended by itself");
        std::thread::sleep(std::time::Duration::from_millis(20));
    }
    let id = nix::unistd::Pid::from_raw(running.id() as i32);
    nix::sys::signal::kill(id, nix::sys::signal::Signal::SIGINT).unwrap();
    assert_eq!(running.wait().unwrap().code(), Some(3));
    assert_eq!(console.ask("GET /api/state", "")["job"]["ended"], "stopped");
}

#[cfg(unix)]
#[test]
fn a_script_whose_server_was_started_anew_does_not_wait_for_ever() {
    use nix::sys::signal::{Signal, kill};
    let shop = shop();
    shop.write("wait.sbp", b"MX,1\nPAUSE 500\n");
    let mut console = Console::begin(&shop, &[]);
    let address = console.url.strip_prefix("http://").unwrap().to_owned();
    let mut command = shop.command();
    command.args(["run", "wait.sbp", "--arm", "--server", &console.url]);
    let mut running = command.stderr(std::process::Stdio::piped()).spawn().unwrap();
    until("the run", || console.ask("GET /api/state", "")["job"]["run"] == 1);
    std::thread::sleep(std::time::Duration::from_millis(300));
    // It looks away while that happens, as one does that waits for an answer at a terminal.
    let id = nix::unistd::Pid::from_raw(running.id() as i32);
    kill(id, Signal::SIGSTOP).unwrap();
    console.child.kill().unwrap();
    console.child.wait().unwrap();
    let anew = Console::begin(&shop, &["--listen", &address]);
    kill(id, Signal::SIGCONT).unwrap();
    let mut over = None;
    until("its end", || {
        over = over.or(running.try_wait().unwrap());
        over.is_some()
    });
    assert_eq!(over.unwrap().code(), Some(1));
    drop(anew);
}

#[test]
fn a_server_heeds_what_it_is_told_of_a_run_and_the_rest_is_refused() {
    let shop = shop();
    shop.write("one.sbp", b"MX,1\nPRINT %(1)\n");
    shop.write("down.sbp", b"PRINT %(3)\nMX,1\n");
    let lines = ["draw", "--do", "line 0,0 100,0; line 100,50 0,50", "-o", "lines.rsg"];
    Did::of(shop.command().args(lines).output().unwrap()).exits(0);
    shop.kerf("toolpath lines.rsg -o lines.rsm").exits(0);
    let console = Console::begin(&shop, &[]);
    let on = |what: &str| shop.kerf(&format!("{what} --arm --quiet --server {}", console.url));
    // FP's parameters, in the unit that a person reads, and line by line.
    on("run one.sbp --proportion 3,1,1 --repeat 2").exits(0).says("3\n3\n");
    on("run down.sbp --plunge -0.25 --repeat 2").exits(0).says("-0.25\n-0.5\n");
    shop.write("steps", b"step=Quit\n");
    assert_eq!(on("run one.sbp --step --answers steps").exits(3).out(), "? MX,1 → Quit\n");
    assert_eq!(on("run one.sbp --step").exits(0).out(), "? MX,1 → Run (default)\n1\n");
    // A job from another shape on, beside itself.
    let moves = || console.ask("GET /api/state", "")["job"]["summary"]["moves"].clone();
    on("run lines.rsm").exits(0);
    let whole = moves();
    on("run lines.rsm --from-line 2").exits(0);
    assert!(moves().as_u64() < whole.as_u64(), "{} of {whole}", moves());
    on("run lines.rsm --from-line 3").exits(1).complains("the paths 1 to 2");
    on("run lines.rsm --offset-job 5").exits(0);
    let bounds = console.ask("GET /api/state", "")["job"]["summary"]["bounds"].clone();
    assert_eq!(bounds[0][1].as_f64().map(f64::round), Some(-5.0), "{bounds}");
    // Nobody would heed the rest.
    for (option, name) in [
        ("--hold-at 1 --resume-at 2", "--hold-at, --resume-at are"),
        ("--override 50@1", "--override is"),
        ("--config sim", "--config is"),
        ("--data elsewhere", "--data is"),
        ("--input 3@1=1", "--input is"),
        ("--set N=2", "--set is"),
        ("--units mm", "--units is"),
        ("--trace t", "--trace is"),
        ("--allow-errors", "--allow-errors is"),
        ("--ramps optimal", "--ramps is"),
        ("--driver grbl:nowhere", "--driver is"),
        ("--from-line 2", "--from-line begins a part file only here"),
        ("--offset-job 1", "only a job is offset"),
    ] {
        on(&format!("run one.sbp {option}")).exits(2).complains(name);
    }
    on("run lines.rsm --tabs").exits(2).complains("--tabs is of part files");
    on("run lines.rsm --repeat 2").exits(2).complains("job.repeats");
    let send = |what: &str| shop.kerf(&format!("send {what} --server {}", console.url));
    send("UD --start fresh").exits(2).complains("--start is not heeded");
    send("--again").exits(2).complains("--again is not heeded");
}

/// Where the server believes the machine to stand, X in inches.
fn served_x(console: &Console) -> f64 {
    let at = console.ask("GET /api/state", "")["motion"]["at"]["working"][0].clone();
    at.as_f64().unwrap() / 25.4
}

#[cfg(unix)]
fn until(what: &str, mut holds: impl FnMut() -> bool) {
    let begun = std::time::Instant::now();
    while !holds() {
        assert!(begun.elapsed().as_secs() < 20, "{what}");
        std::thread::sleep(std::time::Duration::from_millis(20));
    }
}

#[cfg(unix)]
#[test]
fn what_another_kerf_does_beside_a_server_is_where_the_machine_stands() {
    let shop = shop();
    let console = Console::begin(&shop, &[]);
    let state = || console.ask("GET /api/state", "");
    console.carry_out("MX,1");
    until("the server's own move", || (served_x(&console) - 1.0).abs() < 1e-9);
    until("idle", || state()["machine"]["state"] == "idle");
    shop.kerf("send MX,4").exits(0);
    until("the other's move", || (served_x(&console) - 4.0).abs() < 1e-9);
    assert_eq!(state()["machine"]["armed"], false, "whoever armed it looks first");
    // From there it goes on, also at once.
    shop.kerf("send MX,5").exits(0);
    console.carry_out("MY,2");
    until("the move along Y", || {
        state()["motion"]["at"]["working"][1].as_f64().is_some_and(|y| (y - 50.8).abs() < 1e-6)
    });
    until("idle", || state()["machine"]["state"] == "idle");
    shop.write("x.sbp", b"PRINT %(1);\" \";%(2)\n");
    shop.kerf("run x.sbp --quiet").exits(0).says("5 2\n");
    // One that is killed in motion leaves it in doubt here, too.
    let mut other = shop.command().args(["send", "--pace", "real", "MX,500"]).spawn().unwrap();
    std::thread::sleep(std::time::Duration::from_millis(700));
    other.kill().unwrap();
    other.wait().unwrap();
    until("the doubt", || state()["machine"]["why"].to_string().contains("not verified"));
}

#[test]
fn sbp_ext_tr__stands_above_an_added_tool() {
    let shop = shop();
    let ini = "[R]\nName = Ruler\nCommand = echo > ran.txt\n[Q]\nName = Quick\nCommand = echo > ran.txt\n";
    shop.write("data/virtualtools.ini", ini.as_bytes());
    shop.kerf("send TR,12000 --allow-shell --trace -").exits(0).says("\"rpm\":12000");
    assert!(!shop.file("ran.txt").exists());
    shop.kerf("send TQ --allow-shell").exits(0);
    assert!(shop.file("ran.txt").exists(), "another letter is the tool's");
}

#[test]
fn sbp_ctl_addin() {
    let shop = shop();
    std::fs::create_dir_all(shop.file("data")).unwrap();
    let kerf = shop.command().get_program().to_string_lossy().into_owned();
    // The tool runs beside the machine and sends it commands.
    let ini = format!(
        "[Q]\nName = Stepper\nWait = 0\nCommand = sleep .3; {kerf} send MX,2 2> sent.txt; echo\n"
    );
    shop.write("data/virtualtools.ini", ini.as_bytes());
    let console = Console::begin(&shop, &["--allow-shell"]);
    let send = |what: &str| {
        let mut command = shop.command();
        Did::of(command.args(["send", what, "--server", &console.url]).output().unwrap())
    };
    send("MX,1").exits(1).complains("disarmed");
    let commands = console.ask("GET /api/commands", "");
    assert!(commands.to_string().contains("Stepper"), "it is in the menu");
    console.carry_out("TQ");
    let begun = std::time::Instant::now();
    let x = || console.ask("GET /api/state", "")["motion"]["at"]["working"][0].as_f64().unwrap();
    while (x() - 50.8).abs() > 1e-6 {
        let sent = std::fs::read_to_string(shop.file("sent.txt")).unwrap_or_default();
        assert!(begun.elapsed().as_secs() < 20, "it never moved: {sent}");
        std::thread::sleep(std::time::Duration::from_millis(50));
    }
    drop(console);
}

#[cfg(unix)]
#[test]
fn a_server_that_is_to_end_stops_its_machine_first() {
    use nix::sys::signal::{Signal, kill};
    shop::hear_hangups();
    for signal in [Signal::SIGTERM, Signal::SIGHUP, Signal::SIGINT] {
        let shop = shop();
        shop.write("long.sbp", b"JZ,1\nMS,1,1\nMX,5000\n");
        let mut console = Console::begin(&shop, &[]);
        console.carry_out("FP,long.sbp");
        let state = || console.ask("GET /api/state", "");
        while state()["motion"]["at"]["working"][0].as_f64().unwrap() < 30.0 {}
        kill(nix::unistd::Pid::from_raw(console.child.id() as i32), signal).unwrap();
        assert_eq!(console.child.wait().unwrap().code(), Some(0), "{signal}");
        let log = shop.read("data/SbSys.log");
        assert!(log.contains("NORMAL,Total Time"), "{signal}: {log}");
        let did = shop.kerf("run rel.sbp --quiet");
        assert!(
            !did.err().contains("not verified"),
            "{signal}: where it stands is known: {}",
            did.err()
        );
    }
}

#[test]
fn a_terminal_that_has_gone_is_no_panic() {
    let shop = shop();
    let (gone, stderr) = std::io::pipe().unwrap();
    drop(gone);
    let status = shop.command().args(["run", "nowhere.sbp"]).stderr(stderr).status().unwrap();
    assert_eq!(status.code(), Some(2));
}

#[test]
fn what_a_server_runs_is_told_as_any_run_is() {
    let shop = shop();
    shop.write("good.sbp", b"MX,1\nMY,2\nJZ,.5\n");
    shop.write("bad.sbp", b"MX,1\nQQ,3\nM23,1\n");
    shop.write("stops.sbp", b"MX,1\nPAUSE 1\nMX,&none\n");
    shop.write("outer.sbp", b"MX,1\nFP,stops.sbp\n");
    shop.write("warns.sbp", b"MX,1\nGOTO A\nA:\nA:\n");
    let console = Console::begin(&shop, &[]);
    let on = |what: &str| shop.kerf(&format!("{what} --server {}", console.url));
    // The same words as here.
    let did = on("run good.sbp --arm");
    did.exits(0).says("ran to its end after").says("3 lines, 3 moves, 0 arcs\n");
    assert_eq!(did.out(), shop.kerf("run good.sbp --data other").out());
    assert_eq!(did.err(), "");
    assert_eq!(on("run good.sbp --arm --quiet").exits(0).out(), "");
    // Mistakes are shown with their place and the mend, and nothing starts.
    let did = on("run bad.sbp --arm");
    did.exits(1)
        .complains("error[S002]: unknown command QQ")
        .complains("bad.sbp:2:1")
        .complains("2 | QQ,3");
    did.complains("help: a command has two letters").complains("bad.sbp:3:1");
    assert!(!did.out().contains("after"), "{}", did.out());
    // An error of the run too, also that of a file that the file calls.
    for name in ["stops.sbp", "outer.sbp"] {
        let did = on(&format!("run {name} --arm"));
        did.exits(1).says("FAILED after").complains("error[R001]: variable &NONE has no value");
        did.complains("stops.sbp:3:4").complains("3 | MX,&none").complains("help: assign it");
        assert_eq!(did.err().matches("R001").count(), 1, "{}", did.err());
    }
    on("run warns.sbp --arm").exits(0).complains("warning[W001]").complains("warns.sbp:4:");
}
