//! The log of a part file, and taking up a run that ended early.

use crate::shop::Shop;

const PART: &str = "MX,1\nMX,2\nMX,3\nMX,4\nMX,5\n";

fn shop() -> Shop {
    Shop::new(&[("parts/a.sbp", PART)])
}

/// The log, times left out.
fn log(shop: &Shop, file: &str) -> Vec<String> {
    let text = shop.read(file);
    let still = |(i, field): (usize, &str)| match i {
        2 | 3 => field.chars().map(|c| if c.is_ascii_digit() { '0' } else { c }).collect(),
        _ => field.to_owned(),
    };
    let line = |line: &str| line.split(',').enumerate().map(still).collect::<Vec<_>>().join(",");
    text.lines().map(line).collect()
}

#[test]
fn sbp_log_part() {
    let shop = shop();
    shop.kerf("run parts/a.sbp --data d --start kept").exits(0);
    shop.kerf("run parts/a.sbp --data d --start kept --repeat 2 --proportion 2,2,1").exits(0);
    let expected = [
        "a.sbp,MOVE,00:00:00,0000-00-00,00:00:03,1,1,1,0,1",
        "COMPLETED",
        "a.sbp,MOVE,00:00:00,0000-00-00,00:00:14,2,2,1,0,2",
        "COMPLETED",
    ];
    assert_eq!(log(&shop, "parts/a.log"), expected);
    // So does a file that a typed line runs.
    shop.kerf("send FP,a.sbp,2,.5,1,2,1 --data d --parts parts").exits(0);
    let typed = log(&shop, "parts/a.log").split_off(4);
    assert!(typed[0].ends_with(",2,0.5,1,1,2") && typed.len() == 2, "{typed:?}");
}

#[test]
fn sbp_log_part_preview() {
    let shop = shop();
    shop.kerf("send SP FP,a.sbp --data d --parts parts").exits(0);
    let log = log(&shop, "parts/a.log");
    assert!(log[0].starts_with("a.sbp,PREVIEW,") && log.len() == 2, "{log:?}");
    for looks in ["preview parts/a.sbp -o a.svg", "time parts/a.sbp", "check parts/a.sbp"] {
        shop.kerf(looks).exits(0);
    }
    assert_eq!(self::log(&shop, "parts/a.log").len(), 2, "looking leaves nothing");
}

#[test]
fn sbp_log_part_terminated() {
    let ends = |program: &str, options: &str, code: i32| {
        let shop = Shop::new(&[
            ("parts/a.sbp", program),
            ("parts/b.sbp", PART),
            ("cancel", "pause=Cancel\n"),
        ]);
        shop.kerf(&format!("run parts/a.sbp --data d {options}")).exits(code);
        log(&shop, "parts/a.log").pop().unwrap()
    };
    assert_eq!(ends(PART, "--stop-at 1.7", 3), "TERMINATED,4,user");
    assert_eq!(ends("MX,1\nMX,&none\n", "", 1), "TERMINATED,2,error");
    assert_eq!(ends("MX,1\nFP,b.sbp\n", "--stop-at 2", 3), "TERMINATED,2,user");
    assert_eq!(ends("VL,0,3\nSF,1\nJX,1\nJX,4\n", "", 3), "TERMINATED,4,limit");
    assert_eq!(ends("MX,4\nMX,1\n", "--input 4@1=1", 3), "TERMINATED,1,input");
}

#[test]
fn sbp_flow_pause_cancel() {
    let shop = Shop::new(&[
        ("parts/a.sbp", "MX,1\nVS,9\nPAUSE\nMX,2\n"),
        ("parts/b.sbp", "FP,a.sbp\nMX,9\n"),
        ("cancel", "pause=Cancel\n"),
    ]);
    let run = |file: &str| {
        shop.kerf(&format!("run parts/{file}.sbp --data d --answers cancel")).exits(3);
        log(&shop, &format!("parts/{file}.log")).pop().unwrap()
    };
    assert_eq!((run("a"), run("b")), ("TERMINATED,3,user".into(), "TERMINATED,1,user".into()));
    shop.write("parts/speed.sbp", b"PRINT %(71)\n");
    shop.kerf("run parts/speed.sbp --data d").exits(0).says("2\n");
}

#[test]
fn sbp_lang_unknown_cmd() {
    let shop = Shop::new(&[("parts/a.sbp", "SO,3,1\nMX,1\nQQ,1\nMX,2\n")]);
    let run = shop.kerf("run parts/a.sbp --data d --allow-errors");
    run.exits(1).complains("QQ");
    assert_eq!(log(&shop, "parts/a.log")[1], "TERMINATED,3,error");
    let told = || shop.read("d/SbSys.log").matches(",error in line 3,sim,").count();
    assert_eq!(told(), 1, "{}", shop.read("d/SbSys.log"));
    // A file that is refused at its beginning is told of, too.
    let refused = shop.kerf("run parts/a.sbp --data d");
    refused.exits(1).complains("unknown command QQ").complains("a.sbp:3:1");
    assert_eq!(told(), 2);
    shop.kerf("check parts/a.sbp").exits(1);
    assert_eq!(told(), 2, "looking leaves nothing");
}

#[test]
fn sbp_val_vd_partlog() {
    let shop = shop();
    shop.write("parts/off.sbp", b"VD,,,,,,,,,,0\nMX,1\n");
    shop.kerf("run parts/off.sbp --data d").exits(0);
    assert_eq!(log(&shop, "parts/off.log").len(), 2, "the run that turns it off is logged");
    shop.kerf("run parts/a.sbp --data d").exits(0);
    assert!(!shop.file("parts/a.log").exists());
    shop.kerf("send VD,,,,,,,,,,1 --data d").exits(0);
    shop.kerf("run parts/a.sbp --data d").exits(0);
    assert_eq!(log(&shop, "parts/a.log").len(), 2);
}

#[test]
fn sbp_file_fg_lastline() {
    let shop = shop();
    shop.write("last", b"last\nRun\n");
    shop.kerf("run parts/a.sbp --data d --stop-at 1.7").exits(3);
    let taken_up = shop.kerf("send FG,a.sbp --parts parts --data d --answers last");
    taken_up.exits(0).says("? MX,1 → last").says("? MX,4 → Run").says("2 moves");
    shop.kerf("run parts/a.sbp --data d --from-line last").exits(2).complains("in its log");
    shop.kerf("run parts/a.sbp --data d --stop-at 1.7 --start fresh").exits(3);
}

#[test]
fn a_run_begins_at_a_line() {
    let shop = shop();
    shop.kerf("run parts/a.sbp --start fresh --from-line 4").exits(0).says("2 lines, 2 moves");
    shop.kerf("run parts/a.sbp --from-line 9").exits(2).complains("has 5 lines");
    shop.kerf("run parts/a.sbp --from-line first").exits(2).complains("number of a line");
    assert!(!shop.file("parts/a.log").exists(), "a fresh start leaves nothing");
}

#[test]
fn a_run_is_stepped_through() {
    let shop = shop();
    shop.write("answers", b"Step\n5\nStep\n");
    let run = shop.kerf("run parts/a.sbp --step --answers answers");
    run.exits(0).says("? MX,1 → Step\n? MX,2 → 5\n? MX,5 → Step\n").says("2 moves");
}

#[test]
fn a_folder_that_cannot_be_written_stops_no_run() {
    let shop = shop();
    std::fs::create_dir(shop.file("parts/a.log")).unwrap();
    shop.kerf("run parts/a.sbp --data d")
        .exits(0)
        .complains("the log of parts/a.sbp cannot be written");
}
