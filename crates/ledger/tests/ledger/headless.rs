//! The halves without a screen of rows that a console completes, and rows about whole files.

use kerf_ledger::{Run, at, run, sbp};

/// Lines of UV about a V command after a program.
fn shows(program: &str, letters: &str) -> String {
    let run = run(&format!("{program} ⏎ UV"));
    let told = run.is_ok().events("message").last().expect("UV tells").clone();
    let text = told["text"].as_str().expect("text");
    text.lines().find(|line| line.starts_with(letters)).unwrap_or_default().to_owned()
}

/// The value of a parameter that UV shows, counted from 1.
fn value(program: &str, letters: &str, position: usize) -> String {
    shows(program, letters).split(',').nth(position).unwrap_or_default().to_owned()
}

fn question(run: &Run, kind: &str) -> usize {
    run.events("ask").filter(|ask| ask["kind"] == kind).count()
}

#[test]
fn sbp_lang_ext() {
    let mine = "VS,3,2 ⏎ PRINT %(71);\" \";%(73)";
    sbp("FP,mine.sbd").file("mine.sbd", mine).run().is_ok().prints(&["3 2"]);
    sbp("FP,mine").file("mine.sbp", mine).run().is_ok().prints(&["3 2"]);
}

#[test]
fn sbp_lang_var_case__listed_once() {
    let run = run("&MyVar=1 ⏎ &MYVAR=&myvar+1 ⏎ UL");
    run.is_ok().shows(&["&MYVAR = 2"]);
}

#[test]
fn sbp_cmd_sl__leaves_nothing() {
    sbp("&a=1 ⏎ MSGBOX(t,0,x) ⏎ SL ⏎ UL").run().is_ok().shows(&["no variables"]);
}

#[test]
fn sbp_io_print_suppress() {
    run("PRINT \"a\" ⏎ VD,,,,,,,0 ⏎ PRINT \"b\"").prints(&["a", "b"]);
}

#[test]
fn sbp_io_play_missing() {
    run("PLAY nofile.wav ⏎ MX,1").ends_at([1.0]).warns(1, "W020");
    sbp("PLAY ding.wav ⏎ MX,1").file("ding.wav", "x").run().ends_at([1.0]).is_silent();
}

#[test]
fn sbp_file_fp_savedformats() {
    for text in ["MX,1\nMY,2\n", "MX,1\r\nMY,2\r\n", "MX,1\r\nMY,2\r\n\u{1a}", "\u{feff}MX,1\nMY,2"]
    {
        sbp("FP,part.sbp").file("part.sbp", text).run().ends_at([1.0, 2.0]);
    }
}

#[test]
fn sbp_file_fe() {
    let run = sbp("FE,part.sbp ⏎ MX,1").file("part.sbp", "MX,2").run();
    assert_eq!(question(&run, "editor"), 1, "{run}");
    run.ends_at([1.0]).asks(&["part.sbp"]);
}

#[test]
fn sbp_val_vd_comments() {
    assert_eq!(value("VD,,,,,,,1", "VD", 7), "1");
    run("VD,,,,,,,1 ⏎ 'a ⏎ MX,1 ⏎ 'b").shows(&["a", "b"]);
}

#[test]
fn sbp_val_vd_fixed() {
    assert_eq!(
        (value("", "VD", 8), value("VD,,,,,,,,.05", "VD", 8)),
        ("0.1".into(), "0.05".into())
    );
}

#[test]
fn sbp_val_vd_remote() {
    assert_eq!((value("", "VD", 9), value("VD,,,,,,,,,2", "VD", 9)), ("0".into(), "2".into()));
}

/// The keypad with a pendant: X+ for a second, X- and Y+ from 4 s on, the key that closes at 6 s.
fn by_pendant(remote: u8, fast: bool) -> Run {
    let case = sbp(&format!("VD,,,,,,,,,{remote} ⏎ SK ⏎ MZ,1"));
    let case = if fast { case.input(11, 0.5, true) } else { case };
    let keys = [(5, 1.0, true), (5, 2.0, false), (6, 4.0, true), (7, 4.5, true), (12, 6.0, true)];
    keys.into_iter().fold(case, |case, (key, at_s, on)| case.input(key, at_s, on)).run()
}

#[test]
fn sbp_val_vd_remote__inputs_are_keys_while_the_keypad_is_open() {
    let run = by_pendant(1, false);
    assert_eq!(question(&run, "keypad"), 1, "{run}");
    let moves: Vec<_> = run.events("move").collect();
    let to = |n: usize, axis: &str| moves[n]["to"][axis].as_f64().expect("a number");
    // Forth, back, and with the second key on the way across.
    assert!(to(0, "x") > 1.0 && to(0, "y") == 0.0, "{run}");
    let last = moves.len() - 2;
    assert!(to(last, "x") < to(0, "x") - 1.0 && to(last, "y") > 0.5, "{run}");
    assert_eq!(to(last + 1, "z"), 1.0, "{run}");
    assert!(run.seconds() > 6.0, "{run}");
    let fast = by_pendant(1, true);
    let far = fast.events("move").next().expect("a move")["to"]["x"].as_f64();
    assert!(far > Some(1.5 * to(0, "x")), "jog speed while its key is held: {fast}");
}

#[test]
fn sbp_val_vd_remote__without_it_inputs_move_nothing() {
    for remote in [0, 2] {
        by_pendant(remote, false).ends_at([0.0, 0.0, 1.0]);
    }
}

#[test]
fn sbp_val_vd_partlog() {
    assert_eq!((value("", "VD", 10), value("VD,,,,,,,,,,0", "VD", 10)), ("1".into(), "0".into()));
}

#[test]
fn sbp_val_vd_syslog() {
    assert_eq!((value("", "VD", 11), value("VD,,,,,,,,,,,0", "VD", 11)), ("1".into(), "0".into()));
}

#[test]
fn sbp_val_vd_msgscreen() {
    let line = shows("VD,,,,,,,,,,,,1440,720,7200,3600", "VD");
    assert!(line.contains(",1440,720,7200,3600,"), "{line}");
}

#[test]
fn sbp_io_print_window_pos() {
    let line = shows("VD,,,,,,,,,,,,1000,2000,6000,4000", "VD");
    assert!(line.contains(",1000,2000,6000,4000,"), "{line}");
}

#[test]
fn sbp_val_vd_progress() {
    let set = "VD,,,,,,,,,,,,,,,,,1";
    assert_eq!((value("", "VD", 17), value(set, "VD", 17)), ("0".into(), "1".into()));
}

#[test]
fn sbp_val_vd_display() {
    let set = "VD,,,,,,,,,,,,,,,,,,0";
    assert_eq!((value("", "VD", 18), value(set, "VD", 18)), ("1".into(), "0".into()));
}

#[test]
fn sbp_val_vi_port() {
    assert_eq!(value("VI,3", "VI", 1), "3");
    run("VI,17").status("failed");
    let mapped = |program: &str| {
        sbp(program).settings(|s| {
            s.controller.ports[2] = "/dev/ttyUSB0".into();
            s.controller.ports[3] = "sim".into();
        })
    };
    mapped("MX,1").run().ends_at([1.0]);
    mapped("VI,4 ⏎ MX,1").run().ends_at([1.0]);
    let elsewhere = mapped("VI,3 ⏎ MX,1").run();
    elsewhere.fails(2, "M005").says("port 3, /dev/ttyUSB0").stands_at([0.0]);
}

#[test]
fn sbp_val_vi_speed() {
    assert_eq!(value("", "VI", 9), "5");
    for code in ["2", "3", "4", "5"] {
        assert_eq!(value(&format!("VI,,,,,,,,,{code}"), "VI", 9), code);
    }
    run("VI,,,,,,,,,9").status("failed");
    for (code, baud) in [("2", 115_200), ("3", 230_400), ("4", 460_800), ("5", 921_600)] {
        let case = sbp(&format!("VI,3,,,,,,,,{code} ⏎ MX,1"));
        let run = case.settings(|s| s.controller.ports[2] = "/dev/ttyUSB0".into()).run();
        run.fails(2, "M005").says(&format!("/dev/ttyUSB0, {baud} baud"));
    }
}

#[test]
fn sbp_cmd_z_confirm() {
    let zeroed = at([1.0, 2.0], "ZX");
    zeroed.ends_at([0.0, 2.0]).asks(&[]);
}

#[test]
fn sbp_cmd_home_immediate() {
    at([1.0, 2.0], "MH").stands_at([0.0, 0.0]).asks(&[]);
    at([1.0, 2.0], "JH").stands_at([0.0, 0.0]).asks(&[]);
}
