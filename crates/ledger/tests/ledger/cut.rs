//! Cut commands as lines of a program: what their geometry tests leave open.

use kerf_ledger::{Run, at, run, sbp};
use serde_json::Value;

/// Centre, direction, sweep and end of each arc.
fn arcs(run: &Run) -> Vec<([f64; 2], String, f64, [f64; 2])> {
    let round = |v: &Value| (v.as_f64().unwrap() * 1e4).round() / 1e4;
    let arc = |e: &Value| {
        (
            [round(&e["centre"]["x"]), round(&e["centre"]["y"])],
            e["dir"].as_str().unwrap().to_owned(),
            round(&e["sweep"]),
            [round(&e["to"]["x"]), round(&e["to"]["y"])],
        )
    };
    run.is_ok().events("arc").map(arc).collect()
}

#[track_caller]
fn is_one_arc(run: &Run, centre: [f64; 2], dir: &str, sweep: f64, to: [f64; 2]) {
    assert_eq!(arcs(run), [(centre, dir.to_owned(), sweep, to)], "{run}");
}

#[test]
fn sbp_cut_cc_params() {
    let run = run("CC,4,T,1,0,360,-.1,2,1,1,0,1,0");
    run.ends_at([0.0, 0.0, -0.2]);
    assert_eq!(run.events("arc").count(), 2, "{run}");
}

#[test]
fn sbp_cut_cc_diam_req() {
    run("CC").fails(1, "S010").visits::<3>(&[]);
    run("CC,0").fails(1, "R013").visits::<3>(&[]);
    run("CC,-2").fails(1, "R013").visits::<3>(&[]);
}

#[test]
fn sbp_cut_cc_dir() {
    is_one_arc(&run("CC,4,T,-1"), [0.0, -2.0], "ccw", 360.0, [0.0, 0.0]);
    is_one_arc(&run("CC,4,T,"), [0.0, -2.0], "cw", 360.0, [0.0, 0.0]);
    run("CC,4,T,2").fails(1, "R009");
}

#[test]
fn sbp_cut_cc_true() {
    is_one_arc(&run("CC,4,t"), [0.0, -2.0], "cw", 360.0, [0.0, 0.0]);
    is_one_arc(&run("CC,4,,"), [0.0, -2.0], "cw", 360.0, [0.0, 0.0]);
    is_one_arc(&run("CC,4,o"), [0.0, -2.125], "cw", 360.0, [0.0, 0.0]);
    run("CC,4,Q").status("failed");
}

#[test]
fn sbp_cut_cc_feature_range() {
    run("CC,4,,,,,,,,,5").fails(1, "R009");
}

#[test]
fn sbp_cut_cc_tab_file() {
    let tabbed = sbp("FP,circ.sbp,,,,,,,1").file("circ.sbp", "CC,12,T,1,0,360,-.5").run();
    let plain = sbp("FP,circ.sbp").file("circ.sbp", "CC,12,T,1,0,360,-.5").run();
    let heights = |run: &Run| run.events("arc").filter(|a| a["to"]["z"] == -0.4).count();
    assert!(heights(&tabbed) > 0, "{tabbed}");
    assert_eq!(heights(&plain), 0, "{plain}");
}

#[test]
fn sbp_cut_cc_small() {
    let speed = |program: &str| {
        let run = run(program);
        let arc = run.events("arc").next().unwrap();
        let seconds = arc["t1"].as_f64().unwrap() - arc["t0"].as_f64().unwrap();
        run.end()["cut"].as_f64().unwrap() / seconds
    };
    assert!((speed("CC,.2") - 0.4).abs() < 0.01, "{}", speed("CC,.2"));
    assert!(speed("CC,.3") > 0.5, "{}", speed("CC,.3"));
}

#[test]
fn sbp_cut_cp_params() {
    run("CP,4").fails(1, "S010");
    run("CP,4,1").fails(1, "S010");
    is_one_arc(&run("CP,4,10,10"), [10.0, 10.0], "cw", 360.0, [10.0, 12.0]);
}

#[test]
fn sbp_cut_cp_nolift() {
    at([0.0, 0.0, -0.1], "CP,4,10,10").visits(&[[10.0, 12.0, -0.1], [10.0, 12.0, -0.1]]);
}

#[test]
fn sbp_cut_cr_params() {
    run("CR").fails(1, "S010");
    run("CR,10").visits(&[[0.0, 10.0], [10.0, 10.0], [10.0, 0.0], [0.0, 0.0]]);
}

#[test]
fn sbp_cut_cr_feature_range() {
    run("CR,2,1,,,,,,3").fails(1, "R009");
}

#[test]
fn sbp_cut_ca_params() {
    run("CA,10").fails(1, "S010");
    is_one_arc(&run("CA,10,2.5"), [5.0, -3.75], "cw", 106.2602, [10.0, 0.0]);
}

#[test]
fn sbp_cut_scaled_file() {
    let extent = |part: &str| {
        let run = sbp("VC,.25 ⏎ FP,circ.sbp,2,1").file("circ.sbp", part).run();
        let bounds = run.is_ok().end()["bounds"].clone();
        let size = |axis: &str| {
            bounds["max"][axis].as_f64().unwrap() - bounds["min"][axis].as_f64().unwrap()
        };
        (size("x"), size("y"))
    };
    let near = |a: (f64, f64), b: (f64, f64)| (a.0 - b.0).abs() < 2e-3 && (a.1 - b.1).abs() < 2e-3;
    assert!(near(extent("CC,4"), (8.0, 4.0)), "{:?}", extent("CC,4"));
    assert!(near(extent("CC,4,O"), (8.25, 4.25)), "{:?}", extent("CC,4,O"));
}

#[test]
fn sbp_cut_check_limits() {
    let run = at([9.0, 5.0], "VL,0,10,0,10 ⏎ SF,1 ⏎ CC,4");
    run.visits::<3>(&[]);
    run.status("limit").stands_at([9.0, 5.0]);
    let asked: Vec<_> = run.events("ask").map(|ask| &ask["kind"]).collect();
    assert_eq!(asked, ["limit"], "{run}");
    // It ends where it began: what counts is the path, which at X 8 reaches just to the limit.
    at([8.0, 5.0], "VL,0,10,0,10 ⏎ SF,1 ⏎ CC,4").is_ok();
}

#[test]
fn sbp_cut_seg_stack() {
    // At the default speed and ramps: one speed all around, a ramp only at the ends.
    let (length_in, ramp_s, ramp_in) = (std::f64::consts::PI * 8.0, 1.6 / 14.0, 3.84 / 28.0);
    run("CC,8").is_ok().lasts(2.0 * ramp_s + (length_in - 2.0 * ramp_in) / 2.0);
}
