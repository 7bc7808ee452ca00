//! The parameters of the Cut commands reach the geometry; refusals move nothing.

use crate::testing::{Ran, run};
use kerf_program::{Arc, Command};

fn arcs(ran: &Ran) -> Vec<Arc> {
    let arc = |c: &kerf_program::Sourced| match c.command {
        Command::Arc(a) => Some(a),
        _ => None,
    };
    ran.commands.iter().filter_map(arc).collect()
}

/// Runs a program with one arc; checks its end, centre and sweep (clockwise positive) in inches and degrees.
#[track_caller]
fn arc(text: &str, end: (f64, f64), centre: (f64, f64), clockwise: f64) {
    let ran = run(text);
    let made = arcs(&ran);
    assert_eq!(made.len(), 1, "{text}: {:?}", ran.error);
    let [x, y] = made[0].centre.map(|v| v / 25.4);
    let near = |a: f64, b: f64| (a - b).abs() < 5e-4;
    assert!(near(x, centre.0) && near(y, centre.1), "{text}: centre {x},{y}");
    assert!(near(-made[0].sweep_rad.to_degrees(), clockwise), "{text}: {}", made[0].sweep_rad);
    ran.ends_at(end.0, end.1, ran.location().0[2]);
}

#[test]
fn parameters_reach_the_geometry() {
    arc("CC,4", (0.0, 0.0), (0.0, -2.0), 360.0);
    arc("CC,4,T,-1,90,-180", (-2.0, -2.0), (-2.0, 0.0), -270.0);
    arc("CC,4,O,1,90,180", (-2.125, -2.125), (-2.125, 0.0), 90.0);
    arc("CP,4,10,10,T,-1,90,180", (10.0, 8.0), (10.0, 10.0), -270.0);
    arc("CG,,2,-2,0,-2,T,1", (2.0, -2.0), (0.0, -2.0), 90.0);
    arc("CG,4,2,-2,9,9,T,-1", (2.0, -2.0), (2.0, 0.0), -90.0);
    arc("CA,10,2.5,I", (9.8, 0.0), (4.9, -3.675), 106.2602);
}

#[test]
fn sbp_cut_cp_relative() {
    arc("M2,5,5 ⏎ SR ⏎ CP,4,10,10", (15.0, 17.0), (15.0, 15.0), 360.0);
}

#[test]
fn sbp_cut_cg_modal() {
    let ran = run("CG,,2,-2,0,-2 ⏎ M2,0,0 ⏎ CG,,2,-2");
    assert_eq!(arcs(&ran).len(), 2);
    assert_eq!(arcs(&ran)[0].centre, arcs(&ran)[1].centre);
    run("CG,,2,-2").fails_with("centre");
}

#[test]
fn sbp_cut_relative_mode() {
    for shape in ["CC,4", "CR,10,5", "CA,10,2.5"] {
        let absolute = run(&format!("M2,1,1 ⏎ {shape}"));
        let relative = run(&format!("M2,1,1 ⏎ SR ⏎ {shape}"));
        assert_eq!(absolute.location(), relative.location(), "{shape}");
        assert_eq!(
            (absolute.moves(), arcs(&absolute)),
            (relative.moves(), arcs(&relative)),
            "{shape}"
        );
    }
}

/// Checks that programs fail with these texts and leave the tool where it is.
#[track_caller]
fn refuses(cases: &[(&str, &str)]) {
    for (text, part) in cases {
        run(text).fails_with(part).ends_at(0.0, 0.0, 0.0);
    }
}

/// Checks that two programs give the same moves, arcs and end.
#[track_caller]
fn same(a: &str, b: &str) {
    let (first, second) = (run(a), run(b));
    assert!(first.error.is_none(), "{a}: {:?}", first.error);
    assert_eq!((first.moves(), arcs(&first)), (second.moves(), arcs(&second)), "{a} / {b}");
    assert_eq!(first.location(), second.location());
}

#[test]
fn sbp_cut_cc_diam_req() {
    let positive = "must be positive";
    refuses(&[("CC", "diameter expected"), ("CC,0", positive), ("CC,-2", positive)]);
    refuses(&[("CC,.2,I", "cutter larger than hole")]);
}

#[test]
fn sbp_cut_cc_dir() {
    arc("CC,4,T,-1,,270", (-2.0, -2.0), (0.0, -2.0), -90.0);
    refuses(&[("CC,4,T,2", "one of 1, -1")]);
    same("CC,4,T", "CC,4,T,1");
}

#[test]
fn sbp_cut_cc_true() {
    same("CC,4,T", "CC,4,,");
    same("CC,4,o", "CC,4,O");
    refuses(&[("CC,4,X", "one of O, I, T")]);
}

#[test]
fn sbp_cut_cc_params() {
    let ran = run("CC,4,T,1,0,360,-.1,2,1,1,0,1,0");
    assert_eq!(arcs(&ran).len(), 2);
    let heights: Vec<_> = ran.moves().iter().map(|m| m.1[2]).collect();
    assert_eq!(heights, [-0.1, -0.2]);
    ran.ends_at(0.0, 0.0, -0.2);
    same("CC,4", "CC,4,T,1,,,0,1,1,1,0,0,0");
    let wrong = [("CC,4,,,,,-.1,1.5", "whole number"), ("CC,4,,,,,-.1,0", "at least 1")];
    refuses(&wrong);
}

#[test]
fn sbp_cut_cc_feature_range() {
    refuses(&[("CC,4,,,,,,,,,5", "0-4"), ("CC,4,,,,,,,,,-1", "0-4")]);
    refuses(&[("CC,4,T,1,0,90,0,1,1,1,2", "full circle")]);
}

#[test]
fn sbp_cut_cp_params() {
    same("CP,4,1,2", "CP,4,1,2,T,1,,,0,1,1,1,0,0,0");
    refuses(&[("CP,4", "centre expected"), ("CP,4,1", "centre expected"), ("CP", "diameter")]);
}

#[test]
fn sbp_cut_cp_nolift() {
    let warned = |text: &str| {
        let ran = run(text);
        ran.commands.iter().any(|c| matches!(&c.command, Command::Diagnostic(_)))
    };
    assert!(warned("MZ,-.1 ⏎ CP,4,10,10"));
    assert!(!warned("CP,4,10,10"));
    assert_eq!(run("MZ,-.1 ⏎ CP,4,10,10").moves()[1].1, [10.0, 12.0, -0.1]);
}

#[test]
fn the_end_of_a_g_code_circle_must_be_possible() {
    refuses(&[
        ("CG,4", "end point"),
        ("CG,2,2,-2", "diameter"),
        ("CG,,3,-3,0,-2", "not on the circle"),
    ]);
}

#[test]
fn sbp_cut_cr_params() {
    same("CR,10", "CR,10,10,T,1,4,0,1,0,0");
    refuses(&[
        ("CR", "length x expected"),
        ("CR,-10,5", "positive"),
        ("CR,4,4,T,1,5", "one of 1, 2, 3, 4"),
    ]);
}

#[test]
fn sbp_cut_cr_feature_range() {
    refuses(&[("CR,2,1,,,,,,3", "0-2")]);
}

#[test]
fn sbp_cut_ca_params() {
    same("CA,10,2.5", "CA,10,2.5,T,1,0,0,1,1,1,0,0,0");
    refuses(&[("CA,10", "height expected"), ("CA,10,0", "positive"), ("CA,0,1", "positive")]);
}

#[test]
fn sbp_cut_cc_tab_file() {
    let by_file = with_file("FP,circ.sbp,,,,,,,1", "CC,12,T,1,0,360,-.5");
    same_arcs(&by_file, &run("CC,12,T,1,0,360,-.5,1,1,1,1"));
    assert!(arcs(&by_file).len() > 10);
}

#[test]
fn sbp_cut_scaled_file() {
    let ran = with_file("FP,circ.sbp,2,1", "CC,4");
    let far = |axis: usize| ran.moves().iter().fold(0.0f64, |m, p| m.max(p.1[axis].abs()));
    assert!((far(0) - 4.0).abs() < 1e-3 && (far(1) - 4.0).abs() < 1e-3, "{} {}", far(0), far(1));
    same_arcs(&with_file("FP,circ.sbp,2,2", "CC,4,O"), &run("CC,8,O"));
}

fn with_file(text: &str, circ: &str) -> Ran {
    let mut host = crate::testing::FakeHost::default();
    host.files.insert("circ.sbp".into(), circ.into());
    crate::testing::run_with(text, host, crate::Session::default())
}

#[track_caller]
fn same_arcs(a: &Ran, b: &Ran) {
    assert_eq!((a.moves(), arcs(a)), (b.moves(), arcs(b)), "{:?} {:?}", a.error, b.error);
}

#[test]
fn sbp_cut_cc_from0() {
    let z = |text: &str| run(text).moves().iter().map(|m| m.1[2]).collect::<Vec<_>>();
    assert_eq!(z("MZ,.5 ⏎ CC,4,T,1,0,360,-.25,2,1,1,0,0,1"), [0.5, 0.0, -0.25, -0.5, 0.5]);
    assert_eq!(z("MZ,.5 ⏎ CC,4,T,1,0,360,-.25,2"), [0.5, 0.25, 0.0, 0.5]);
}

#[test]
fn sbp_cut_cc_tab() {
    let ran = run("CC,12,T,1,0,360,-.5,2,1,1,1");
    let made = arcs(&ran);
    // First pass whole; on the second six tabs at 4, 10 … 34, each up, flat, down.
    assert!((made[0].sweep_rad.abs() - std::f64::consts::TAU).abs() < 1e-9);
    let z: Vec<_> = made[1..].iter().map(|a| (a.to.0[2] / 25.4 * 1e6).round() / 1e6).collect();
    assert_eq!(z[..5], [-1.0, -0.9, -0.9, -1.0, -1.0]);
    assert_eq!(z.iter().filter(|z| **z == -0.9).count(), 12);
    let first = made[1].sweep_rad.abs() * 6.0;
    assert!((first - 4.0).abs() < 1e-6, "{first}");
}

#[test]
fn plunges_are_added_to_z_and_lifts_are_told_of() {
    let told = |ran: &Ran| {
        ran.commands.iter().any(
            |c| matches!(&c.command, Command::Diagnostic(d) if d.code == kerf_diag::Code::Lifts),
        )
    };
    let up = run("CC,4,T,1,0,360,.25,1,1,1,0,1");
    assert!(told(up.ends_at(0.0, 0.0, 0.25)));
    assert!(!told(run("CC,4,T,1,0,360,-.25,1,1,1,0,1").ends_at(0.0, 0.0, -0.25)));
}

#[test]
fn sbp_cut_cc_pullup_height() {
    run("MZ,.5 ⏎ CC,4,T,1,0,360,-.75").ends_at(0.0, 0.0, 0.5);
    assert!(run("CC,4").moves().is_empty());
}

#[test]
fn sbp_cut_cc_nopullup() {
    run("MZ,.2 ⏎ CC,4,T,1,0,360,-.3,1,1,1,0,1").ends_at(0.0, 0.0, -0.1);
    run("MZ,.2 ⏎ CC,4,T,1,0,360,-.3").ends_at(0.0, 0.0, 0.2);
}

#[test]
fn vb_tabs_hold_for_the_last_pass_of_a_cut_only() {
    let ran = run("VB,,,,,1 ⏎ CR,10,6,T,1,4,-.5,2");
    let high = ran.moves().iter().filter(|m| (m.1[2] + 0.9).abs() < 1e-6).count();
    assert!(high >= 10, "{:?} {:?}", ran.moves(), ran.error);
    assert!(!ran.moves().iter().any(|m| (m.1[2] + 0.4).abs() < 1e-6));
}
