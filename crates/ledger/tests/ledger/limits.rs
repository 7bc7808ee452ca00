//! Limits and stops.

use kerf_ledger::{Run, run, sbp};
use kerf_model::CABLE;

/// Time at which `MX,10` at the default speed passes X 4: .13714 in of ramp in .11429 s, then 2 in/s.
const AT_X4: f64 = 0.114_285_714 + (4.0 - 0.137_142_857) / 2.0;

/// End of a ramped stop that begins at X 4.
const RAMPED: f64 = 4.137_142_857;

fn stops(run: &Run) -> Vec<&str> {
    run.events("stop").map(|e| e["by"].as_str().unwrap()).collect()
}

#[test]
fn sbp_lim_sf_preview() {
    let run = run("VL,0,10,0,10 ⏎ SF,1 ⏎ SP ⏎ MX,12 ⏎ MX,5 ⏎ MY,60 ⏎ SM");
    run.is_ok().asks(&[]).errs(4, "M001").errs(6, "M001").stands_at([0.0, 0.0]);
}

#[test]
fn sbp_lim_switch_stop() {
    let run = sbp("VN,,,,,1 ⏎ MX,10 ⏎ MY,1").input(2, AT_X4, true).run();
    run.status("limit").stands_at([4.0]).says("limit input 2");
    assert_eq!(stops(&run), ["limit"], "{run}");
}

#[test]
fn sbp_lim_switch_options() {
    let go_on = sbp("VN,,,,,1 ⏎ MX,10 ⏎ MX,0").answers(&["Continue"]);
    go_on.input(2, AT_X4, true).input(2, 3.0, false).input(2, 6.0, true).run().ends_at([0.0]);
    let quit = sbp("VN,,,,,1 ⏎ MX,10").answers(&["End"]).input(2, AT_X4, true).run();
    quit.status("limit").stands_at([4.0]);
}

#[test]
fn sbp_lim_switch_off() {
    sbp("VN,0,,,,1 ⏎ MX,10").input(2, AT_X4, true).run().ends_at([10.0]);
    let handler = "VN,0,,,,1 ⏎ ON INPUT(2,1) GOTO HIT ⏎ MX,10 ⏎ END ⏎ HIT: ⏎ PRINT %(1)";
    sbp(handler).input(2, AT_X4, true).run().prints(&["4"]).ends_at([4.0]);
}

#[test]
fn sbp_val_vn_limits() {
    let program = |active: u8| format!("VN,{active},,,,1 ⏎ MX,10");
    sbp(&program(1)).input(2, AT_X4, true).run().stands_at([4.0]);
    sbp(&program(0)).input(2, AT_X4, true).run().stands_at([10.0]);
}

#[test]
fn sbp_val_vn_inmode_std() {
    sbp("MX,10 ⏎ PRINT %(55)").input(5, AT_X4, true).run().ends_at([10.0]).prints(&["1"]);
    let handler = "ON INPUT(5,1) &hit=1 ⏎ MX,10 ⏎ PRINT &hit";
    sbp(handler).input(5, AT_X4, true).run().ends_at([4.0]).prints(&["1"]);
}

#[test]
fn sbp_lim_stop_input() {
    let program = "VN,,,,,,,4 ⏎ SO,1,1 ⏎ SO,2,1 ⏎ SO,3,1 ⏎ MX,10";
    let run = sbp(program).input(5, AT_X4, false).run();
    run.status("stopped").stands_at([RAMPED]).says("stop input 5");
    run.switches(1, &[(true, "program"), (false, "stop")]);
    run.switches(2, &[(true, "program"), (false, "stop")]);
    run.switches(3, &[(true, "program"), (false, "end")]);
    // Until it is released nothing moves.
    let open = sbp("VN,,,,,,,4 ⏎ MX,10").input(5, 0.0, false).run();
    open.status("stopped").stands_at([0.0]).says("stop input 5");
}

#[test]
fn sbp_lim_stop_input__resumed_when_it_is_released() {
    let program = "VN,,,,,,,4 ⏎ SO,1,1 ⏎ SO,2,1 ⏎ MZ,-.5 ⏎ MX,10 ⏎ MY,1";
    let at = AT_X4 + 0.75;
    let stopped = || sbp(program).input(5, at, false);
    let refused = stopped().answers(&["Resume", "Quit"]).run();
    let message = "stop input 5 is active: nothing moves before it is released";
    refused.status("stopped").shows(&[message]);
    assert_eq!(refused.location()[2], -0.5, "nothing moved: {refused}");
    let goes_on = stopped().input(5, at + 1.0, true).answers(&["hold=Resume"]).run();
    goes_on.ends_at([10.0, 1.0, -0.5]);
    let around = (true, "mode");
    goes_on.switches(1, &[(true, "program"), (false, "stop"), around, (false, "end")]);
    let heights = goes_on.events("move").map(|m| m["to"]["z"].as_f64().unwrap());
    assert_eq!(heights.collect::<Vec<_>>(), [-0.5, -0.5, 1.0, -0.5, -0.5, -0.5], "{goes_on}");
    let states = goes_on.events("state").map(|e| e["state"].as_str().unwrap());
    assert_eq!(states.collect::<Vec<_>>(), ["blocked", "paused", "running"], "{goes_on}");
}

#[test]
fn a_stop_input_counts_while_a_program_waits() {
    let program = "VN,,,,,,,3 ⏎ SO,1,1 ⏎ PAUSE 3 ⏎ MX,1";
    let stopped = sbp(program).input(5, 1.0, true);
    stopped.clone().run().status("stopped").switches(1, &[(true, "program"), (false, "stop")]);
    let goes_on = stopped.input(5, 2.0, false).answers(&["hold=Resume"]).run();
    goes_on.ends_at([1.0]);
}

#[test]
fn a_limit_is_a_state_of_its_own() {
    let states = |answer: &str| -> Vec<String> {
        let case = sbp("VN,,,,,1 ⏎ MX,10").answers(&[answer]).input(2, AT_X4, true);
        let run = case.run();
        run.events("state").map(|e| e["state"].as_str().unwrap().to_owned()).collect()
    };
    assert_eq!(states("Continue"), ["limit", "running"]);
    assert_eq!(states("End"), ["limit", "alarm"]);
}

#[test]
fn sbp_lim_estop_alpha() {
    let cut = sbp("SO,1,1 ⏎ SO,2,1 ⏎ MX,10").alpha().input(4, AT_X4, false).run();
    cut.status("stopped").stands_at([4.0]).says("emergency stop");
    cut.switches(1, &[(true, "program"), (false, "stop")]);
    cut.switches(2, &[(true, "program"), (false, "stop")]);
    let off: Vec<f64> = cut
        .events("motors")
        .filter(|e| e["on"] == false)
        .map(|e| e["t"].as_f64().unwrap())
        .collect();
    assert_eq!(off.len(), 1, "{cut}");
    assert!((off[0] - AT_X4 - 5.0).abs() < 1e-6, "{cut}");
    for output in cut.events("output").filter(|e| e["on"] == false) {
        assert!((output["t"].as_f64().unwrap() - AT_X4).abs() < 1e-6, "at once: {cut}");
    }
    assert_eq!(cut.end()["verify"], serde_json::json!(["X", "Y", "Z"]));
}

#[test]
fn sbp_lim_error_driver() {
    let lost = sbp("SO,3,1 ⏎ MX,10 ⏎ MX,0").input(CABLE, AT_X4, false).run();
    lost.status("failed").stands_at([RAMPED]).says("not connected");
    lost.switches(3, &[(true, "program"), (false, "stop")]);
    let states = lost.events("state").map(|e| e["state"].as_str().unwrap());
    assert_eq!(states.collect::<Vec<_>>(), ["not connected", "alarm"], "{lost}");
    assert_eq!(lost.end()["verify"], serde_json::json!(["X", "Y", "Z"]));
    // Without it nothing moves; connected again it stands where it is believed to be.
    sbp("MX,10").input(CABLE, 0.0, false).run().fails(1, "M005").stands_at([0.0]);
    let again = sbp("PAUSE 1 ⏎ MX,10").input(CABLE, 0.5, true).run();
    again.ends_at([10.0]);
}

#[test]
fn sbp_lim_stop4() {
    let run = sbp("MX,10").input(4, AT_X4, false).run();
    run.status("stopped").stands_at([4.0]);
    assert_eq!(stops(&run), ["stop"], "{run}");
    let case = sbp("MX,10").input(4, AT_X4, false).input(4, 9.0, true);
    case.answers(&["hold=Resume"]).run().ends_at([10.0, 0.0, 0.0]);
}

#[test]
fn sbp_val_vn_in4() {
    run("MX,10").ends_at([10.0]);
    sbp("MX,10").input(4, AT_X4, false).run().status("stopped").stands_at([4.0]);
    sbp("VN,,1 ⏎ MX,10").input(4, AT_X4, true).run().status("stopped").stands_at([4.0]);
}

#[test]
fn sbp_lim_stop_nc() {
    let run = sbp("MX,10").input(4, 0.0, false).run();
    run.status("stopped").stands_at([0.0]).says("stop input 4").says("stop circuit open");
}

#[test]
fn sbp_lim_stop_key() {
    let run = sbp("MZ,-.5 ⏎ MX,10").stopped_at(0.75 + AT_X4).run();
    let visited: Vec<_> = run.events("move").map(|m| m["to"]["z"].as_f64().unwrap()).collect();
    assert_eq!(visited, [-0.5, -0.5, 1.0], "{run}");
    run.status("stopped");
    assert_eq!(stops(&run), ["operator"], "{run}");
    let stood = run.events("move").nth(1).unwrap()["to"]["x"].as_f64().unwrap();
    assert!(stood < 10.0 && run.location()[0] == stood, "{run}");
    sbp("MX,10").stopped_at(AT_X4).run().stands_at([RAMPED, 0.0, 1.0]);
}

#[test]
fn sbp_lim_stop_quit() {
    let nested = sbp("VS,4 ⏎ FP,b.sbp ⏎ MY,1").file("b.sbp", "MX,10").stopped_at(1.0).run();
    nested.status("stopped");
    assert_eq!(nested.events("move").count(), 2, "the cut and the lift: {nested}");
    // Quit brings the settings back as the end of the file does.
    let speed = || sbp("PRINT %(71)");
    speed().after("VS,4 ⏎ MX,10").run().prints(&["2"]);
    speed().after_stop("VS,4 ⏎ PRINT %(71) ⏎ MX,10", 1.0).run().prints(&["2"]);
    speed().after_stop("VS,4 ⏎ SV ⏎ MX,10", 1.0).run().prints(&["4"]);
}

/// VN with a mode for output 3, its 17th value.
fn output3(mode: u8) -> String {
    format!("VN{}{mode}", ",".repeat(17))
}

#[test]
fn sbp_val_vn_outmode2() {
    let program = &format!("{} ⏎ SO,3,1 ⏎ MX,10", output3(2));
    run(program).switches(3, &[(true, "program"), (false, "end")]);
    let stopped = || sbp(program).stopped_at(1.0);
    stopped().run().switches(3, &[(true, "program"), (false, "stop")]);
    let resumed = [(true, "program"), (false, "stop"), (true, "mode"), (false, "end")];
    stopped().answers(&["hold=Resume"]).run().ends_at([10.0]).switches(3, &resumed);
    // One that was off stays off.
    let off = &format!("{} ⏎ MX,10", output3(2));
    sbp(off).stopped_at(1.0).answers(&["hold=Resume"]).run().ends_at([10.0]).switches(3, &[]);
}

#[test]
fn sbp_val_vn_outmode3() {
    let set = &output3(3);
    sbp("MX,10").after(set).run().switches(3, &[(true, "mode"), (false, "end")]);
}

#[test]
fn sbp_val_vn_outmode5() {
    let set = &output3(5);
    sbp("MX,10").after(set).run().switches(3, &[(true, "mode"), (false, "end")]);
    // A stop switches it off before the end of the file would.
    let at_start = sbp("MX,10").after(set).stopped_at(1.0).run();
    at_start.switches(3, &[(true, "mode"), (false, "stop")]);
    let resumed = sbp("MX,10").after(set).stopped_at(1.0).answers(&["hold=Resume"]).run();
    let switched = [(true, "mode"), (false, "stop"), (true, "mode"), (false, "end")];
    resumed.ends_at([10.0]).switches(3, &switched);
}

#[test]
fn sbp_lim_sf() {
    run("VL,0,10 ⏎ SF,1 ⏎ MX,12").stands_at([0.0]);
    run("VL,0,10 ⏎ SF,1 ⏎ SF,0 ⏎ MX,12").ends_at([12.0]);
    run("SF").fails(1, "S010");
}

#[test]
fn sbp_lim_sf_dialog() {
    let case = sbp("VL,0,10 ⏎ SF,1 ⏎ MX,12 ⏎ MY,1");
    case.clone().answers(&["Continue"]).run().ends_at([12.0, 1.0]);
    case.answers(&["End"]).run().stands_at([0.0, 0.0]).status("limit");
}

#[test]
fn sbp_lim_sf_base() {
    let limited = "VA,0,,,,,5 ⏎ VL,0,10 ⏎ SF,1 ⏎";
    run(&format!("{limited} MX,4")).ends_at([4.0]);
    run(&format!("{limited} MX,6")).stands_at([0.0]).status("limit");
    // A file that is run relative to where the tool is.
    let offset =
        |within: &str| sbp("M2,4,0 ⏎ VL,0,5 ⏎ SF,1 ⏎ FP,in.sbp,,,,,2").file("in.sbp", within).run();
    offset("MX,.5").ends_at([4.5]);
    offset("MX,2").stands_at([4.0]).status("limit");
}

#[test]
fn sbp_lim_sf_temp() {
    sbp("VL,0,10 ⏎ MX,12").after("SF,1 ⏎ SV").run().stands_at([0.0]);
    sbp("VL,0,10 ⏎ MX,12").after("SF,1").run().ends_at([12.0]);
    let on = sbp("VL,0,10 ⏎ MX,12").after("SF,1 ⏎ SV");
    on.after("VL,0,10 ⏎ SF,0 ⏎ MX,12 ⏎ MX,0").run().stands_at([0.0]).status("limit");
}

#[test]
fn sbp_val_vn_in12() {
    let machine = |program: &str| sbp(program).interlock(12);
    let open = |program: &str| machine(program).input(12, 99.0, false).run();
    open("MX,10").status("stopped").stands_at([0.0]).says("enclosure open");
    open("SO,1,1 ⏎ PAUSE 1").status("stopped").says("enclosure open").switches(1, &[]);
    open("SO,3,1 ⏎ PAUSE 1").is_ok().switches(3, &[(true, "program"), (false, "end")]);
    machine("SO,1,1 ⏎ MX,10").run().ends_at([10.0]);
    // Opened while it cuts.
    let opened = machine("SO,1,1 ⏎ MX,10").input(12, AT_X4, true).run();
    opened.status("stopped").stands_at([RAMPED]).says("enclosure open");
    opened.switches(1, &[(true, "program"), (false, "stop")]);
    // Without the setting input 12 is free.
    sbp("SO,1,1 ⏎ MX,10").input(12, 99.0, false).run().ends_at([10.0]);
}

#[test]
fn sbp_val_vn_prs() {
    // As a PRS is wired: inputs 2 and 3 normally closed limits of X and Y.
    let prs = |input: u8| sbp("VN,,,,,2,2 ⏎ MX,10").input(input, AT_X4, false).run();
    for input in [2, 3] {
        prs(input).status("limit").stands_at([4.0]).says(&format!("limit input {input}"));
    }
    // As a PRT is: input 3 normally open.
    let prt = sbp("VN,,,,,,1 ⏎ MX,10").input(3, AT_X4, true).run();
    prt.status("limit").stands_at([4.0]).says("limit input 3");
}
