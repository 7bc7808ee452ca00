//! Flow of a program: jumps, subroutines, conditions, ON INPUT, PAUSE.

use kerf_ledger::{Run, run, sbp};

/// Time at which X 4 is reached on the way from 0 to 10 with default ramps and speed, seconds.
///
/// From 0.4 in/s at 14 in/s² to 2 in/s: 0.1142857 s over 0.1371429 in; the rest at 2 in/s.
const AT_X4_S: f64 = 1.6 / 14.0 + (4.0 - 3.84 / 28.0) / 2.0;

/// Runs while an input changes at the time the tool passes X 4.
fn pressed_at_x4(input: u8, program: &str) -> Run {
    sbp(program).input(input, AT_X4_S, true).run()
}

#[test]
fn sbp_flow_endall() {
    sbp("FP,B.sbp ⏎ MY,2").file("b.sbp", "VS,4 ⏎ MX,1 ⏎ ENDALL").run().ends_at([1.0, 0.0]);
    sbp("FP,B.sbp ⏎ MY,2").file("b.sbp", "MX,1 ⏎ END ALL").run().ends_at([1.0, 0.0]);
    sbp("PRINT %(71)").file("b.sbp", "VS,4 ⏎ ENDALL").after("FP,B.sbp").run().prints(&["2"]);
}

#[test]
fn sbp_flow_goto_missing() {
    run("GOTO Nowhere ⏎ MX,1").fails(1, "R005").says("NOWHERE").visits::<3>(&[]);
    // Not taken, not an error.
    run("IF 1 = 2 THEN GOTO Nowhere ⏎ MX,1").ends_at([1.0]);
}

#[test]
fn sbp_flow_return_stray() {
    run("MX,1 ⏎ RETURN").fails(2, "R006");
    sbp("GOSUB A ⏎ END ⏎ A: ⏎ FP,b.sbp ⏎ RETURN").file("b.sbp", "RETURN").run().fails(1, "R006");
}

#[test]
fn sbp_flow_fall_into_sub() {
    run("MX,1 ⏎ A: ⏎ MY,2 ⏎ RETURN").fails(4, "R006").visits(&[[1.0, 0.0], [1.0, 2.0]]);
    run("MX,1 ⏎ END ⏎ A: ⏎ MY,2 ⏎ RETURN").ends_at([1.0, 0.0]);
}

#[test]
fn sbp_flow_oninput_on() {
    pressed_at_x4(3, "ON INPUT(3,1) GOTO Hit ⏎ MX,10 ⏎ END ⏎ Hit: ⏎ MY,1").ends_at([4.0, 1.0]);
}

#[test]
fn sbp_flow_oninput_off() {
    sbp("PAUSE 1 ⏎ ON INPUT(3,0) &hit=1 ⏎ MX,10 ⏎ PRINT &hit")
        .input(3, 0.0, true)
        .input(3, 1.0 + AT_X4_S, false)
        .run()
        .prints(&["1"])
        .stands_at([4.0]);
}

#[test]
fn sbp_flow_oninput_ramped() {
    pressed_at_x4(3, "ON INPUT(3,3) GOTO Hit ⏎ MX,10 ⏎ END ⏎ Hit: ⏎ MY,1").ends_at([4.1371, 1.0]);
}

#[test]
fn sbp_flow_oninput_action() {
    pressed_at_x4(2, "ON INPUT(2,1) VA, 0.0 ⏎ MX,10 ⏎ PRINT %(1)").prints(&["0"]);
    pressed_at_x4(2, "ON INPUT(2,1) GOSUB S ⏎ MX,10 ⏎ MY,2 ⏎ END ⏎ S: ⏎ MZ,1 ⏎ RETURN")
        .ends_at([4.0, 2.0, 1.0]);
}

#[test]
fn sbp_flow_oninput_resume() {
    pressed_at_x4(3, "ON INPUT(3,1) &hit=1 ⏎ MX,10 ⏎ MY,2").ends_at([4.0, 2.0]);
}

#[test]
fn sbp_flow_oninput_autoclear() {
    let twice = |program: &str| {
        sbp(program).input(3, 1.0, true).input(3, 2.0, false).input(3, 3.0, true).run()
    };
    twice("&n=0 ⏎ ON INPUT(3,1) &n=&n+1 ⏎ MX,10 ⏎ MY,10 ⏎ PRINT &n").prints(&["1"]);
    twice("&n=0 ⏎ ON INPUT(3,1) &n=&n+1 ⏎ MX,10 ⏎ ON INPUT(3,1) &n=&n+1 ⏎ MY,10 ⏎ PRINT &n")
        .prints(&["2"]);
}

#[test]
fn sbp_flow_oninput_clear() {
    pressed_at_x4(3, "ON INPUT(3,1) GOTO Hit ⏎ ON INPUT(3,1) ⏎ MX,10 ⏎ END ⏎ Hit: ⏎ MY,1")
        .ends_at([10.0, 0.0]);
}

#[test]
fn sbp_flow_oninput_edge() {
    sbp("PAUSE 1 ⏎ ON INPUT(3,1) GOTO Hit ⏎ MX,10 ⏎ END ⏎ Hit: ⏎ MY,1")
        .input(3, 0.0, true)
        .run()
        .ends_at([10.0, 0.0]);
}

#[test]
fn sbp_flow_oninput_scope() {
    sbp("ON INPUT(3,1) GOTO Hit ⏎ FP,b.sbp ⏎ END ⏎ Hit: ⏎ MY,1")
        .file("b.sbp", "MX,10")
        .input(3, AT_X4_S, true)
        .run()
        .ends_at([4.0, 1.0]);
}

#[test]
fn sbp_flow_oninput_many() {
    let program = "&a=0 ⏎ &b=0 ⏎ &c=0 ⏎ ON INPUT(2,1) &a=1 ⏎ ON INPUT(2,0) &b=1 ⏎ \
        ON INPUT(3,1) &c=1 ⏎ MX,10 ⏎ MY,10 ⏎ MX,0 ⏎ MY,0 ⏎ PRINT &a;&b;&c";
    sbp(program)
        .input(2, 1.0, true)
        .input(2, 2.0, false)
        .input(3, 3.0, true)
        .run()
        .prints(&["111"]);
    run("ON INPUT(13,1) &a=1").status("failed");
}

#[test]
fn sbp_flow_oninput_many__at_the_same_instant() {
    let armed = "ON INPUT(3,1) &a=1 ⏎ ON INPUT(5,1) &b=2";
    let check = |program: &str, expected: &str| {
        let program = format!("&a=0 ⏎ &b=0 ⏎ {armed} ⏎ {program} ⏎ PRINT &a;&b");
        sbp(&program).input(3, 2.0, true).input(5, 2.0, true).run().prints(&[expected]);
    };
    check("MX,10", "12");
    check("PAUSE 5", "12");
    check("ON INPUT(3,1) ⏎ MX,10", "02");
    // The second one changes while the machine slows down for the first.
    let ramped = "&a=0 ⏎ &b=0 ⏎ ON INPUT(3,3) &a=1 ⏎ ON INPUT(5,1) &b=2 ⏎ MX,10 ⏎ PRINT &a;&b";
    sbp(ramped).input(3, 2.0, true).input(5, 2.02, true).run().prints(&["12"]);
    // One that had changed before is not told again.
    let before = "&b=0 ⏎ MX,5 ⏎ ON INPUT(3,1) &a=1 ⏎ ON INPUT(5,1) &b=2 ⏎ MX,10 ⏎ PRINT &a;&b";
    sbp(before).input(5, 1.0, true).input(3, 4.0, true).run().prints(&["10"]);
    let subs = "ON INPUT(3,1) GOSUB A ⏎ ON INPUT(5,1) GOSUB B ⏎ MX,10 ⏎ PRINT &t ⏎ END ⏎ \
        A: ⏎ &t = &t & \"a\" ⏎ RETURN ⏎ B: ⏎ &t = &t & \"b\" ⏎ RETURN";
    let both = sbp(&format!("&t = \"\" ⏎ {subs}")).input(3, 2.0, true).input(5, 2.0, true).run();
    let printed: Vec<_> = both.events("print").map(|told| told["text"].clone()).collect();
    assert!(["ab", "ba"].iter().any(|order| printed == [*order]), "{both}");
}

#[test]
fn sbp_flow_oninput_abbrev() {
    pressed_at_x4(3, "&t=3 ⏎ ON INP(&t,1) GOTO Hit ⏎ MX,10 ⏎ END ⏎ Hit: ⏎ MY,1")
        .ends_at([4.0, 1.0]);
}

#[test]
fn sbp_flow_pause_timed() {
    let run = run("MX,1 ⏎ PAUSE 3 ⏎ MY,1");
    let times: Vec<(f64, f64)> = run
        .events("move")
        .map(|m| (m["t0"].as_f64().unwrap(), m["t1"].as_f64().unwrap()))
        .collect();
    assert!((times[1].0 - times[0].1 - 3.0).abs() < 0.001, "{run}");
    kerf_ledger::run("PAUSE .25").lasts(0.25);
    kerf_ledger::run("PAUSE,2").lasts(2.0);
}

#[test]
fn sbp_flow_pause_plain_msg() {
    run("' Is the Vacuum Pump on? ⏎ PAUSE").asks(&["Is the Vacuum Pump on?"]);
    run("MX,1 ⏎ PAUSE").asks(&["Continue?"]);
    run("MX,1 'note ⏎ PAUSE").asks(&["Continue?"]);
}

#[test]
fn sbp_flow_pause_cancel() {
    sbp("FP,b.sbp ⏎ MX,9")
        .file("b.sbp", "MX,1 ⏎ PAUSE ⏎ MX,2")
        .answers(&["Cancel"])
        .run()
        .stands_at([1.0])
        .status("stopped")
        .says("terminated by the user");
}

#[test]
fn sbp_flow_pause_until() {
    let run = sbp("PAUSE UNTIL 5, 1 ⏎ MX,1").input(5, 2.0, true).run();
    run.ends_at([1.0]);
    let start = run.events("move").next().unwrap()["t0"].as_f64().unwrap();
    assert!((start - 2.0).abs() < 0.01, "{run}");
}

#[test]
fn sbp_flow_pause_until_0() {
    let run = sbp("PAUSE UNTIL 5, 0 ⏎ MX,1").input(5, 0.0, true).input(5, 2.0, false).run();
    run.ends_at([1.0]);
    kerf_ledger::run("PAUSE UNTIL 5, 0 ⏎ MX,1").ends_at([1.0]);
}

#[test]
fn sbp_flow_warning_off() {
    let lights = |program: &str| -> Vec<(bool, f64)> {
        let run = run(program);
        let lights = run.is_ok().events("light");
        lights.map(|e| (e["on"] == true, e["t"].as_f64().unwrap())).collect()
    };
    let lit = lights("MX,1 ⏎ WARNING OFF ⏎ PAUSE 2 ⏎ MX,2");
    assert_eq!(lit.iter().map(|l| l.0).collect::<Vec<_>>(), [true, false, true, false]);
    assert!((lit[2].1 - lit[1].1 - 2.0).abs() < 1e-6, "dark for the pause: {lit:?}");
    let kept = lights("MX,1 ⏎ PAUSE 2 ⏎ MX,2");
    assert_eq!(kept.len(), 2, "without it the light stays on: {kept:?}");
}
