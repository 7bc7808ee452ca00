//! Outputs and spindles.

use kerf_ledger::{run, sbp};
use kerf_model::STALL;

#[test]
fn sbp_out_so() {
    run("SO,3,1 ⏎ PRINT %(103) ⏎ SO,3,0 ⏎ PRINT %(103)")
        .switches(3, &[(true, "program"), (false, "program")])
        .prints(&["1", "0"]);
    run("SO,3,1 ⏎ SO,3 ⏎ PRINT %(103)").prints(&["0"]);
}

#[test]
fn sbp_out_so_range() {
    run("SO,12,1 ⏎ PRINT %(139)").prints(&["1"]);
    run("SO,13,1").fails(1, "R009");
    let eight = |program: &str| sbp(program).settings(|s| s.controller.outputs = 8).run();
    eight("SO,8,1").is_ok();
    eight("SO,9,1").fails(1, "R009").says("this controller has 8 outputs");
}

#[test]
fn sbp_out_so4_m4() {
    run("SO,4,-4 ⏎ MX,5").switches(4, &[]);
    run("SO,4,-4 ⏎ SO,4,1 ⏎ PRINT %(104)").prints(&["1"]);
}

#[test]
fn sbp_out_so4_manual() {
    let run = run("SO,4,1 ⏎ PRINT %(104) ⏎ SO,4,-4 ⏎ SO,4,1 ⏎ PRINT %(104)");
    run.says("output 4 is automatic").prints(&["0", "1"]);
    assert!(run.events("diag").all(|d| d["severity"] == "warning"), "{run}");
}

#[test]
fn sbp_out_so4_mode() {
    let run = run("SW,0 ⏎ MX,5");
    let motion = run.events("move").next().unwrap().clone();
    let switched: Vec<_> = run.events("output").filter(|e| e["n"] == 4).collect();
    assert_eq!(switched.len(), 2, "{run}");
    assert_eq!((&switched[0]["on"], &switched[0]["t"]), (&true.into(), &motion["t0"]), "{run}");
    assert_eq!((&switched[1]["on"], &switched[1]["t"]), (&false.into(), &motion["t1"]), "{run}");
    sbp("SW,0 ⏎ MX,5 ⏎ PRINT %(109)").run().prints(&["-1"]);
}

#[test]
fn sbp_out_warn_set() {
    let start =
        |program: &str| run(program).is_ok().events("move").next().unwrap()["t0"].as_f64().unwrap();
    assert!((start("SW,.5 ⏎ MX,1") - 0.5).abs() < 1e-6);
    assert!(start("SW,0 ⏎ MX,1").abs() < 1e-6);
    run("SW,-1").fails(1, "R009");
}

#[test]
fn sbp_out_warn_file() {
    let starts = |program: &str| -> Vec<f64> {
        let run = run(program);
        run.is_ok().events("move").map(|m| m["t0"].as_f64().unwrap()).collect()
    };
    let once = starts("SW,2 ⏎ MX,1 ⏎ MX,2");
    assert!((once[0] - 2.0).abs() < 1e-6, "{once:?}");
    let plain = starts("SW,0 ⏎ MX,1 ⏎ MX,2");
    assert!((once[1] - once[0] - (plain[1] - plain[0])).abs() < 1e-6, "{once:?} {plain:?}");
    // After the operator was asked it comes again.
    for asks in ["PAUSE", "MSGBOX(hi)", "INPUT \"how far\" &a"] {
        let again = starts(&format!("SW,2 ⏎ MX,1 ⏎ {asks} ⏎ MX,2"));
        let plain = starts(&format!("SW,0 ⏎ MX,1 ⏎ {asks} ⏎ MX,2"));
        assert!((again[1] - plain[1] - 4.0).abs() < 1e-6, "{asks}: {again:?} {plain:?}");
    }
}

#[test]
fn sbp_ext_tr() {
    let run = sbp("TR,12000,1").run();
    let spindle = run.events("spindle").next().expect("a spindle event");
    assert!(spindle["rpm"] == 12000.0 && spindle["n"] == 1, "{run}");
    let second = sbp("TR,9000,2").run();
    assert_eq!(second.events("spindle").next().expect("a spindle event")["n"], 2, "{second}");
}

#[test]
fn sbp_ext_tr__without_a_device_the_operator_sets_it() {
    let by_hand = |text: &str| sbp(text).settings(|s| s.spindle_device = false);
    let run = by_hand("TR,12000,1 ⏎ MX,1").answers(&["OK"]).run();
    run.asks(&["Set spindle 1 to 12000 rpm."]).ends_at([1.0]);
    assert_eq!(run.events("spindle").next().expect("it is stored all the same")["rpm"], 12000.0);
    let refused = by_hand("TR,9000,2 ⏎ MX,1").answers(&["Cancel"]).run();
    refused.asks(&["Set spindle 2 to 9000 rpm."]).stands_at([0.0]);
    assert!(refused.events("spindle").next().is_none(), "{refused}");
    // Headless the default counts; with a device nobody is asked.
    by_hand("TR,9000").run().asks(&["Set spindle 1 to 9000 rpm."]);
    sbp("TR,9000").run().asks(&[]);
}

/// Times at which the light is switched, s, and to what.
fn lights(run: &kerf_ledger::Run) -> Vec<(f64, bool)> {
    let light = |e: &serde_json::Value| (e["t"].as_f64().unwrap(), e["on"].as_bool().unwrap());
    run.events("light").map(light).collect()
}

#[test]
fn sbp_out_so4_m2() {
    let stopped = |mode: i8| sbp(&format!("SO,4,{mode} ⏎ MX,10")).stopped_at(1.0).run();
    stopped(-2).switches(4, &[(true, "motion"), (false, "stop")]);
    stopped(-1).switches(4, &[(true, "motion"), (false, "motion")]);
    let ends = |mode: i8| {
        let run = stopped(mode);
        let off = run.events("output").filter(|e| e["n"] == 4).last().cloned().unwrap();
        run.seconds() - off["t"].as_f64().unwrap()
    };
    assert!(ends(-2) > 0.1, "off before the tool is lifted");
    assert_eq!(ends(-1), 0.0, "on until the end");
}

#[test]
fn sbp_out_warn_zero() {
    let run = run("SW,0 ⏎ MX,1");
    let made = run.events("move").next().unwrap().clone();
    let (start, end) = (made["t0"].as_f64().unwrap(), made["t1"].as_f64().unwrap());
    assert_eq!((start, lights(&run)), (0.0, vec![(0.0, true), (end, false)]), "{run}");
}

#[test]
fn sbp_out_warn_end() {
    let three = run("SW,2 ⏎ MX,1 ⏎ PRINT 1 ⏎ MX,2 ⏎ PAUSE 1 ⏎ MX,3");
    assert_eq!(lights(&three), [(0.0, true), (three.seconds(), false)], "{three}");
    let off = run("SW,2 ⏎ MX,1 ⏎ WARNING OFF ⏎ PAUSE 1 ⏎ MX,2");
    let states: Vec<bool> = lights(&off).into_iter().map(|(_, on)| on).collect();
    assert_eq!(states, [true, false, true, false], "{off}");
    let dark = lights(&off)[2].0 - lights(&off)[1].0;
    assert!((dark - 1.0).abs() < 1e-9, "{off}");
}

#[test]
fn sbp_out_spindle() {
    let program = "SetSpindleStatus, 1 ⏎ SO,1,1 ⏎ SO,2,1 ⏎ MX,10";
    let run = sbp(program).input(4, 1.0, false).run();
    run.status("stopped");
    let kinds: Vec<_> = run.events("ask").map(|e| e["kind"].as_str().unwrap()).collect();
    assert_eq!(kinds, ["hold"], "whoever set the status is not asked about spindles: {run}");
    run.switches(1, &[(true, "program"), (false, "stop")]);
    run.switches(2, &[(true, "program"), (false, "stop")]);
    assert_eq!(run.stored("SpindleStatus").as_deref(), Some("0"), "{run}");
}

/// Percents of the laser with their times.
fn burns(run: &kerf_ledger::Run) -> Vec<(f64, f64)> {
    let number = |e: &serde_json::Value, key: &str| e[key].as_f64().unwrap();
    run.is_ok().events("pwm").map(|e| (number(e, "t"), number(e, "percent"))).collect()
}

#[test]
fn sbp_val_vh_laser() {
    // Ramp speed .4 of 2 in/s: 20 + 60·.2 = 32 %, up to 80 at full speed, 20 at rest.
    let run = run("VN,,,2 ⏎ VH,1,,20,80 ⏎ MX,5 ⏎ VH,0");
    let end = run.seconds();
    let expected = [
        (0.0, 20.0),
        (0.0, 32.0),
        (0.114_285_714, 80.0),
        (end - 0.114_285_714, 80.0),
        (end, 32.0),
        (end, 20.0),
        (end, 0.0),
    ];
    let burns = burns(&run);
    let expected: Vec<_> = expected.into_iter().filter(|e| e.0 != end - 0.114_285_714).collect();
    assert_eq!(burns.len(), expected.len(), "{run}");
    for (got, want) in burns.iter().zip(&expected) {
        assert!((got.0 - want.0).abs() < 1e-6 && (got.1 - want.1).abs() < 1e-6, "{got:?} {run}");
    }
}

#[test]
fn sbp_val_vh_laser_preset() {
    let percents = |program: &str| -> Vec<f64> {
        burns(&run(program)).into_iter().map(|(_, percent)| percent).collect()
    };
    assert_eq!(percents("VN,,,2 ⏎ VH,0,,20,80 ⏎ VH,1 ⏎ VH,0"), [20.0, 0.0]);
    assert_eq!(percents("VN,,,2 ⏎ VH,0,,20,80 ⏎ MX,1"), [0.0; 0]);
}

#[test]
fn sbp_val_vh_laser_test() {
    let run = run("VN,,,2 ⏎ VH,1,,35,0 ⏎ MX,5");
    let percents: Vec<f64> = burns(&run).into_iter().map(|(_, percent)| percent).collect();
    assert_eq!((percents[0], percents.iter().copied().fold(99.0, f64::min)), (35.0, 0.0), "{run}");
}

#[test]
fn sbp_val_vh_freq() {
    let khz = |program: &str| run(program).events("pwm").next().unwrap()["khz"].as_f64().unwrap();
    assert_eq!(khz("VN,,,2 ⏎ VH,1,,20,80"), 5.4);
    assert_eq!(khz("VN,,,2 ⏎ VH,1,,20,80,10"), 10.0);
}

#[test]
fn sbp_out_so4_m3() {
    let stalls = |mode: i8| {
        let case = sbp(&format!("SO,4,{mode} ⏎ MX,10")).input(STALL, 1.0, true);
        let run = case.run();
        run.status("failed").says("stalled");
        run
    };
    stalls(-3).switches(4, &[(true, "motion"), (false, "stop")]);
    // In mode -2 only the panic bar does: it stays on until the warning ends.
    stalls(-2).switches(4, &[(true, "motion"), (false, "motion")]);
    let stopped = sbp("SO,4,-3 ⏎ MX,10").stopped_at(1.0).run();
    stopped.switches(4, &[(true, "motion"), (false, "stop")]);
    assert_eq!(stalls(-3).end()["verify"], serde_json::json!(["X", "Y", "Z"]));
}

#[test]
fn sbp_out_pwm() {
    let laser = "VN,,,2 ⏎ VH,1,,20,80,5.4 ⏎ MX,2";
    let run = sbp(laser).run();
    let pwm: Vec<_> = run.is_ok().events("pwm").collect();
    assert!(pwm.iter().all(|e| e["channel"] == 1 && e["khz"] == 5.4), "{run}");
    assert!(pwm.iter().any(|e| e["percent"] == 80.0), "{run}");
    let without = sbp(laser).settings(|s| s.controller.pwm = false).run();
    without.status("failed").says("no PWM on this controller");
    sbp("VH,0,,20,80").settings(|s| s.controller.pwm = false).run().is_ok();
}

/// The machine as it is shipped: a line typed right after the installation.
#[test]
fn sbp_out_warn_default() {
    let router = kerf_machine::profile::profile("router-96x48").unwrap();
    let router = kerf_machine::file::read(&"router".into(), router.text).unwrap();
    let run = sbp("MX,1").settings(|s| *s = router.program.clone()).typed().run();
    assert_eq!(lights(&run)[0], (0.0, true), "{run}");
    let first = run.events("move").next().unwrap();
    assert!((first["t0"].as_f64().unwrap() - 2.0).abs() < 1e-9, "{run}");
    let output = run.events("output").next().unwrap();
    assert_eq!((&output["n"], &output["on"]), (&4.into(), &true.into()));
    assert_eq!(output["t"].as_f64(), Some(0.0));
}
