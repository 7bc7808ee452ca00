//! Motors: channels, steps, power (VI, VU, MO), and axes that move by themselves (MI).

use kerf_ledger::{run, sbp};
use kerf_program::Axis;
use serde_json::json;

#[test]
fn sbp_val_vi_channels() {
    // The motor of channel 1 turns with Y; so does the slave of an axis on two channels.
    run("VI,,,,,Y,X ⏎ PRINT %(36);%(37) ⏎ MY,1").prints(&["YX"]).steps(&[400, 0, 0]);
    sbp("VI,,,,,X,X,Y,Z ⏎ MX,2").axes(4).run().status("failed");
    run("VI,,,,,X,X,Y,Z ⏎ MX,2").steps(&[800, 800, 0]);
    run("VI,,,,,X,X ⏎ MX,2").status("failed").says("Y would have no driver channel");
    run("MX,2 ⏎ MY,1").steps(&[800, 400, 0]);
    run("VI,,,,,Q").status("failed");
}

#[test]
fn sbp_val_vi_axis_switch() {
    let swapped = sbp("VI,,,,,,,A,Z ⏎ MZ,-.5").axes(4).run();
    swapped.ends_at([0.0, 0.0, -0.5]).steps(&[0, 0, 0, -200]);
    sbp("VI,,,,,,,A,Z ⏎ MA,.25").axes(4).run().steps(&[0, 0, 100, 0]);
}

#[test]
fn sbp_val_vi_enable() {
    let off = sbp("VI,,,,,,,,,,,,0 ⏎ MX,5 ⏎ SO,1,1 ⏎ PRINT %(101)").run();
    off.ends_at([5.0]).steps(&[0]).switches(1, &[]).prints(&["0"]);
    // What is on goes off; at the end of the file steps and outputs are given again.
    run("SO,3,1 ⏎ VI,,,,,,,,,,,,0").switches(3, &[(true, "program"), (false, "program")]);
    let next = sbp("SO,3,1 ⏎ MX,6").after("VI,,,,,,,,,,,,0 ⏎ MX,5").run();
    next.ends_at([6.0]).steps(&[400]).switches(3, &[(true, "program"), (false, "end")]);
}

#[test]
fn sbp_val_vu_unit() {
    run("VU,400 ⏎ MX,1").steps(&[400]);
    run("VU,800 ⏎ MX,1").steps(&[800]);
    run("VU,400 ⏎ MX,1 ⏎ VU,800 ⏎ MX,2").steps(&[1200]);
    run("VU,-400 ⏎ MX,1").steps(&[-400]);
    // Zeroing turns no motor, and no way adds up to more than half a step of error.
    run("MX,1 ⏎ ZX ⏎ MX,1 ⏎ MX,0").steps(&[400]);
    run("&i=0 ⏎ L: ⏎ &i=&i+1 ⏎ MX,&i/3000 ⏎ IF &i<1000 THEN GOTO L").steps(&[133]);
}

#[test]
fn sbp_val_vu_indexer() {
    sbp("VU,,,,,,,,,13.8889 ⏎ MB,360").axes(5).run().steps(&[0, 0, 0, 0, 5000]);
    sbp("VU,,,,,,,,,13.8889 ⏎ MB,-90").axes(5).run().steps(&[0, 0, 0, 0, -1250]);
}

#[test]
fn sbp_val_vu_resm() {
    let run = run("VU,,,,,,,,,,5 ⏎ MX,2 ⏎ JX,4 ⏎ MX,5");
    let jog = run.ends_at([5.0]).steps(&[2000]).events("move").nth(1).unwrap();
    let told: Vec<_> = run.events("resolution").collect();
    assert_eq!(told.len(), 2, "{run}");
    assert_eq!((&told[0]["multipliers"][0], &told[0]["t"]), (&5.into(), &jog["t0"]), "{run}");
    assert_eq!((&told[1]["multipliers"][0], &told[1]["t"]), (&1.into(), &jog["t1"]), "{run}");
}

#[test]
fn sbp_val_vu_noshift() {
    let jog = |program: &str| {
        let run = run(program);
        let speed = run.is_ok().events("move").next().unwrap()["speed"].as_f64().unwrap();
        (speed, run.events("diag").any(|d| d["severity"] == "warning"))
    };
    let shift = ",".repeat(16);
    assert_eq!(jog("JS,20 ⏎ JX,40"), (20.0, false));
    assert_eq!(jog(&format!("JS,20 ⏎ VU{shift}1 ⏎ JX,40")), (16.0, true));
    assert_eq!(jog(&format!("VU{shift}1 ⏎ VS,,,,,20 ⏎ JX,40")), (16.0, true));
    assert_eq!(jog(&format!("VU{shift}1 ⏎ JS,16 ⏎ JX,40")), (16.0, false));
    // Without shifting there are no coarser steps.
    let run = run("VU,,,,,,,,,,5,,,,,,1 ⏎ JX,4");
    assert_eq!(run.events("resolution").count(), 0, "{run}");
}

#[test]
fn sbp_cmd_mo() {
    let run = run("SO,1,1 ⏎ SO,5,1 ⏎ MX,2 ⏎ MO ⏎ PRINT %(101);%(105);%(1) ⏎ MX,3");
    run.ends_at([3.0]).prints(&["002"]).steps(&[1200]);
    run.switches(1, &[(true, "program"), (false, "stop")]);
    run.switches(5, &[(true, "program"), (false, "stop")]);
    let power: Vec<_> = run.events("motors").map(|e| (&e["on"], &e["t"])).collect();
    let moves: Vec<_> = run.events("move").collect();
    let expected = [(&false.into(), &moves[0]["t1"]), (&true.into(), &moves[1]["t0"])];
    assert_eq!(power, expected, "{run}");
    // The location is kept, but nobody knows whether the tool was pushed: until it is set anew.
    let verify = |program: &str| run_verify(program);
    assert_eq!(verify("MX,2 ⏎ MO ⏎ MX,3"), ["X", "Y", "Z"]);
    assert_eq!(verify("MO ⏎ ZX ⏎ VA,,5"), ["Z"]);
    assert_eq!(verify("MX,2"), [""; 0]);
}

fn run_verify(program: &str) -> Vec<String> {
    let run = run(program);
    let axes = run.is_ok().end()["verify"].as_array().cloned().unwrap_or_default();
    axes.iter().map(|axis| axis.as_str().unwrap().to_owned()).collect()
}

#[test]
fn sbp_cmd_mi_rotate() {
    let run = sbp("MI,B,1,30 ⏎ MX,5 ⏎ PRINT %(123)").axes(5).run();
    let turns = run.is_ok().prints(&["1"]).events("independent").next().unwrap();
    assert_eq!((&turns["axis"], &turns["speed"]), (&"B".into(), &30.into()), "{run}");
    // The motor turns all the time, and X moves as it does alone.
    let steps = (run.seconds() * 30.0 * 5000.0 / 360.0).round() as i64;
    run.lasts(sbp("MX,5").run().seconds()).steps(&[2000, 0, 0, 0, steps]);
    // A blank axis is B, a blank direction clockwise.
    let turned = "MI,,,30 ⏎ PAUSE 4 ⏎ MX,5 ⏎ PAUSE 6-2.591428571 ⏎ PRINT %(5)";
    sbp(turned).axes(5).run().prints(&["300"]).steps(&[2000, 0, 0, 0, 4167]);
}

#[test]
fn sbp_cmd_mi_direction() {
    let turned = |direction: &str| {
        sbp(&format!("MI,B,{direction},30 ⏎ PAUSE 10 ⏎ MI,B,1,0 ⏎ PRINT %(5)")).axes(5).run()
    };
    turned("-1").prints(&["-300"]).steps(&[0, 0, 0, 0, -4167]);
    turned("1").prints(&["300"]).steps(&[0, 0, 0, 0, 4167]);
    turned("").prints(&["300"]);
    // Where it stopped is where its next move begins.
    let on = sbp("MI,B,-1,30 ⏎ PAUSE 10 ⏎ MI,B,1,0 ⏎ MB,-270").axes(5).run();
    on.ends_at([0.0, 0.0, 0.0, 0.0, -270.0]).steps(&[0, 0, 0, 0, -3750]);
}

#[test]
fn sbp_cmd_mi_oscillate() {
    let run = run("MI,Z,,,2,.5 ⏎ MX,5");
    let swings = run.is_ok().events("independent").next().unwrap();
    assert_eq!((&swings["frequency"], &swings["distance"]), (&2.into(), &0.5.into()), "{run}");
    // After an eighth of a second, a quarter of a cycle, it is at its peak, X moving or not.
    let at = |program: &str, seconds: f64| {
        let program = format!("MI,Z,,,2,.5 ⏎ {program} ⏎ PAUSE {seconds} ⏎ PRINT %(3)");
        let run = sbp(&program).run();
        let place = run.is_ok().events("print").next().unwrap()["text"].as_str().unwrap();
        (place.parse::<f64>().unwrap() * 1e4).round() / 1e4
    };
    assert_eq!((at("", 0.125), at("", 0.25), at("", 0.375), at("", 0.5)), (0.25, 0.0, -0.25, 0.0));
    let moving = sbp("MX,5").run().seconds();
    assert_eq!((at("MX,5", 3.125 - moving), at("MX,5", 3.375 - moving)), (0.25, -0.25));
    sbp("MI,Z,,,2,.5 ⏎ PAUSE .125 ⏎ MI,Z,,,0 ⏎ MX,5").run().steps(&[2000, 0, 100]);
    kerf_ledger::run("MI,Z,1,5,2,.5").fails(1, "R009").says("exclude each other");
    kerf_ledger::run("MI,Z,,,31,.01").warns(1, "W014");
}

#[test]
fn sbp_cmd_mi_stop() {
    let stopped = |program: &str| {
        let run = sbp(program).axes(5).run();
        let last = run.is_ok().events("independent").last().cloned();
        last.is_some_and(|e| e["speed"] == 0 && e["frequency"] == 0)
    };
    assert!(stopped("MI,B,1,30 ⏎ PAUSE 1 ⏎ MI,B,1,0"));
    assert!(stopped("MI,Z,,,2,.5 ⏎ PAUSE 1 ⏎ MI,Z,,,0"));
    assert!(stopped("MI,B,1,30 ⏎ PAUSE 1 ⏎ MO"));
    assert!(!stopped("MI,B,1,30 ⏎ PAUSE 1"));
    sbp("MI,B,1,30 ⏎ MI,B,1,0 ⏎ PRINT %(123)").axes(5).run().prints(&["0"]);
    // The end of a file does not stop it, an emergency stop does.
    let next = "PRINT %(123) ⏎ PAUSE 10 ⏎ PRINT %(5)";
    sbp(next).axes(5).after("MI,B,1,30 ⏎ END").run().prints(&["1", "300"]);
    let emergency = sbp("MI,B,1,30 ⏎ MX,10").axes(5).input(4, 1.0, false).run();
    emergency.status("stopped").steps(&[763, 0, 0, 0, 417]);
    let last = emergency.events("independent").last().cloned().unwrap();
    assert_eq!((&last["speed"], &last["t"]), (&0.into(), &1.into()), "{emergency}");
}

#[test]
fn sbp_cmd_mo_handmove() {
    let pushed = |program: &str| sbp(program).pushed(Axis::X, 2.0, 1.0).run();
    let free = pushed("MX,1 ⏎ MO ⏎ PAUSE 3 ⏎ PRINT %(1)");
    free.ends_at([1.0]).prints(&["1"]);
    assert_eq!(free.end()["astray"], json!({"x": 1}), "{free}");
    assert_eq!(free.events("handmove").next().expect("a push")["by"], 1, "{free}");
    let held = pushed("MX,1 ⏎ PAUSE 3");
    assert_eq!((&held.end()["astray"], held.events("handmove").count()), (&json!(null), 1));
    // Where the tool is sent, it misses by as much.
    let on = pushed("MX,1 ⏎ MO ⏎ PAUSE 3 ⏎ MX,5").ends_at([5.0]).end()["astray"].clone();
    assert_eq!(on, json!({"x": 1}));
    let spec = kerf_sbp::table::find("MO").expect("MO");
    assert!(spec.doc.contains("by hand") && spec.doc.contains("voltage"), "{}", spec.doc);
}

#[test]
fn sbp_cmd_st_lost() {
    let told = run("MX,1 ⏎ MO ⏎ UD").is_ok().events("message").last().expect("UD").to_string();
    assert!(told.contains("position not verified: X Y Z"), "{told}");
    let zeroed = run("MO ⏎ ZT ⏎ UD").is_ok().events("message").last().expect("UD").to_string();
    assert!(!zeroed.contains("not verified"), "{zeroed}");
    let drawn = run("SP ⏎ MO ⏎ SM ⏎ UD").is_ok().events("message").last().expect("UD").to_string();
    assert!(!drawn.contains("not verified"), "nothing was switched off: {drawn}");
    let program = "MX,1 ⏎ ZX ⏎ MO ⏎ PAUSE 3 ⏎ ST ⏎ UD";
    let pushed = sbp(program).pushed(Axis::X, 2.0, 1.0).run();
    pushed.ends_at([1.0]);
    let told = pushed.events("message").last().expect("UD").to_string();
    assert!(told.contains("position not verified: X"), "{told}");
    assert_eq!(pushed.end()["astray"], json!({"x": 1}), "the tool stands at 2");
}
