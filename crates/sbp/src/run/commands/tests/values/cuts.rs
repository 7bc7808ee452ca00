//! Values that show in what is cut: tabs, cutter, overlap, plunge.
#![allow(clippy::unwrap_used)]

use super::{called, settings};
use crate::testing::run;
use kerf_program::Command;

/// Working heights in inches that straight moves reach, with the X they reach them at.
fn profile(text: &str) -> Vec<[f64; 2]> {
    let ran = run(text);
    assert!(ran.error.is_none(), "{text}: {:?}", ran.error);
    ran.moves().into_iter().map(|(_, [x, _, z])| [x, z]).collect()
}

/// A tab at depth -.5 with the factory values: up, flat, down from `x` on.
fn tab(x: f64) -> Vec<[f64; 2]> {
    vec![[x, -0.5], [x + 0.5, -0.4], [x + 1.5, -0.4], [x + 2.0, -0.5]]
}

fn tabs_at(starts: &[f64]) -> Vec<[f64; 2]> {
    starts.iter().flat_map(|x| tab(*x)).collect()
}

/// The corners of tabs among the corners of a path.
fn tab_corners(text: &str) -> Vec<[f64; 2]> {
    let path = profile(text);
    let high = |p: &[f64; 2]| (p[1] + 0.4).abs() < 1e-6;
    let mut corners = Vec::new();
    for window in path.windows(2).filter(|w| high(&w[0]) != high(&w[1])) {
        corners.extend_from_slice(window);
    }
    corners
}

#[test]
fn sbp_val_vb_on_off() {
    let text = "MZ,-.5⏎VB,,,,,1⏎MX,20⏎VB,,,,,0⏎MX,40";
    assert_eq!(tab_corners(text), tabs_at(&[4.0, 10.0, 16.0]));
    assert!(!settings(text).tabs.on, "the state ends with the file");
}

#[test]
fn tabs_of_a_series_are_counted_and_started_where_told() {
    assert_eq!(tab_corners("MZ,-.5⏎VB,,,,,1,2⏎MX,40"), tabs_at(&[4.0, 10.0]));
    assert_eq!(tab_corners("MZ,-.5⏎VB,,,,,1,,1⏎MX,20"), tabs_at(&[1.0, 7.0, 13.0]));
    let again = "MZ,-.5⏎VB,,,,,1,1⏎MX,20⏎VB,,,,,1,1⏎MX,40";
    assert_eq!(tab_corners(again), tabs_at(&[4.0, 24.0]), "each series counts its own");
}

#[test]
fn sbp_val_vb_lastpass() {
    let part = "MZ,-.5\nMX,20\nJZ,1\nJX,0";
    let ran = called("FP,part.sbp,,,,3,,,1", part);
    let highs = ran.moves().iter().filter(|(_, p)| (p[2] + 0.4).abs() < 1e-6).count();
    assert_eq!(highs, 6, "three tabs, on the last of three passes: {:?}", ran.moves());
}

/// Centre and end of each arc in inches of the machine frame.
fn arcs(text: &str) -> Vec<([f64; 2], [f64; 3])> {
    let ran = run(text);
    assert!(ran.error.is_none(), "{text}: {:?}", ran.error);
    let inches = |v: f64| (v / 25.4 * 1e6).round() / 1e6;
    let of = |c: &kerf_program::Sourced| match &c.command {
        Command::Arc(arc) => Some((arc.centre.map(inches), arc.to.first3().map(inches))),
        _ => None,
    };
    ran.commands.iter().filter_map(of).collect()
}

#[test]
fn sbp_val_vc_diam() {
    assert_eq!(arcs("VC,.5⏎CC,4,O")[0].0, [0.0, -2.25]);
    assert_eq!(arcs("CC,4,O")[0].0, [0.0, -2.125]);
    assert_eq!(run("VC,.5⏎&d=%(23)").variable("d"), "0.5");
}

#[test]
fn sbp_val_vc_overlap() {
    let step = |text: &str| {
        let arcs = arcs(text);
        let radius = |i: usize| arcs[i].1[1] - arcs[i].0[1];
        ((radius(0) - radius(1)) * 1e6).round() / 1e6
    };
    assert_eq!(step("CC,4,T,1,,,,,,,2"), 0.225);
    assert_eq!(step("VC,,,,,,50⏎CC,4,T,1,,,,,,,2"), 0.125);
    run("VC,,,,,,100").fails_with("less than 100");
}

#[test]
fn sbp_val_vc_plungedir() {
    let down = arcs("VC,,,,,+⏎CC,4,T,1,0,360,.25");
    assert_eq!(down[0].1[2], 0.25, "deeper is positive");
    let warned = |text: &str| {
        let ran = run(text);
        ran.commands.iter().any(|c| matches!(&c.command, Command::Diagnostic(_)))
    };
    assert!(warned("CC,4,T,1,0,360,.25") && !warned("VC,,,,,+⏎CC,4,T,1,0,360,.25"));
    assert!(warned("VC,,,,,+⏎CC,4,T,1,0,360,-.25") && !warned("CC,4,T,1,0,360,-.25"));
}
