//! The parameters of FP: proportions, repetitions, offset, plunge, tabs.

use super::{host_with, run_files};
use crate::testing::{Ran, run_with};
use crate::{Session, Status};
use kerf_program::Axes;

/// A session with the tool somewhere, inches.
pub(super) fn tool_at(x: f64, y: f64, z: f64) -> Session {
    Session { position: Axes::xyz(x * 25.4, y * 25.4, z * 25.4), ..Session::default() }
}

/// The ends of all moves, inches.
pub(super) fn path(ran: &Ran) -> Vec<[f64; 3]> {
    ran.moves().into_iter().map(|m| m.1).collect()
}

#[test]
fn sbp_file_fp_params() {
    let spec = crate::table::find("FP").unwrap();
    let read = spec.params.iter().filter(|p| p.kind != crate::table::Kind::Obsolete);
    assert_eq!(read.count(), 9);
    run_files("FP,part.sbp", &[("part.sbp", "M2,1,2")]).ended(Status::Ok).ends_at(1.0, 2.0, 0.0);
}

#[test]
fn sbp_file_fp_proportion() {
    let ran = run_files("FP,part.sbp,2,3,.5 ⏎ MZ,1", &[("part.sbp", "M3,1,2,-.5")]);
    assert_eq!(path(&ran), [[2.0, 6.0, -0.25], [2.0, 6.0, 1.0]]);
}

#[test]
fn sbp_file_fp_zpasses() {
    let ran = run_files(
        "FP,p.sbp,,,.5 ⏎ FP,p.sbp,,,.85 ⏎ FP,p.sbp,,,1",
        &[("p.sbp", "MZ,-1 ⏎ MX,5 ⏎ MZ,.2 ⏎ MX,0")],
    );
    let z: Vec<_> = path(&ran).iter().map(|p| p[2]).collect();
    assert_eq!(z, [-0.5, -0.5, 0.1, 0.1, -0.85, -0.85, 0.17, 0.17, -1.0, -1.0, 0.2, 0.2]);
}

#[test]
fn sbp_file_fp_reps() {
    let mut relative = Session::default();
    relative.settings.distance = kerf_program::settings::Distance::Relative;
    let host = host_with(&[("part.sbp", "MX,1")]);
    run_with("FP,part.sbp,,,,3", host, relative).ended(Status::Ok).ends_at(3.0, 0.0, 0.0);
    run_files("FP,part.sbp,,,,0", &[("part.sbp", "MX,1")]).ended(Status::Ok).ends_at(1.0, 0.0, 0.0);
    for reps in ["-1", "1.5"] {
        run_files(&format!("FP,part.sbp,,,,{reps}"), &[("part.sbp", "MX,1")])
            .fails_at(1, "repetitions");
    }
}

#[test]
fn sbp_file_fp_offset0() {
    for call in ["FP,part.sbp", "FP,part.sbp,,,,,0"] {
        let ran = run_with(call, host_with(&[("part.sbp", "M2,1,0")]), tool_at(10.0, 4.0, 0.0));
        ran.ended(Status::Ok).ends_at(1.0, 0.0, 0.0);
    }
}

#[test]
fn sbp_file_fp_offset1() {
    let host = host_with(&[("part.sbp", "M3,1,0,-.2")]);
    run_with("FP,part.sbp,,,,,1", host, tool_at(10.0, 4.0, 0.5))
        .ended(Status::Ok)
        .ends_at(11.0, 4.0, 0.3);
}

#[test]
fn sbp_file_fp_offset2() {
    let host = host_with(&[("part.sbp", "M3,1,0,-.2")]);
    run_with("FP,part.sbp,,,,,2", host, tool_at(10.0, 4.0, 0.5))
        .ended(Status::Ok)
        .ends_at(11.0, 4.0, -0.2);
}

#[test]
fn sbp_file_fp_offset_commas() {
    let host = || host_with(&[("mypart.sbp", "MX,1")]);
    let offset = run_with("FP, MYPART.SBP , , , , , 2", host(), tool_at(10.0, 4.0, 0.0));
    assert_eq!(path(&offset), [[11.0, 4.0, 0.0]]);
    let repeated = run_with("FP, MYPART.SBP , , , , 2", host(), tool_at(10.0, 4.0, 0.0));
    assert_eq!(path(&repeated), [[1.0, 4.0, 0.0]]);
    assert_eq!(repeated.session.position, Axes::xyz(25.4, 4.0 * 25.4, 0.0));
}

#[test]
fn sbp_file_fp_allparts() {
    let master = [10, 20, 30, 40].map(|x| format!("M2,{x},4 ⏎ FP,MYPART.SBP,,,,,2")).join(" ⏎ ");
    let ran = run_files(&master, &[("mypart.sbp", "M2,1,0 ⏎ M2,0,0")]);
    let visited: Vec<_> = path(&ran).iter().map(|p| p[0]).collect();
    assert_eq!(visited, [10.0, 11.0, 10.0, 20.0, 21.0, 20.0, 30.0, 31.0, 30.0, 40.0, 41.0, 40.0]);
}

#[test]
fn sbp_file_fp_offset_scale() {
    let host = host_with(&[("part.sbp", "M2,1,1")]);
    run_with("FP,part.sbp,2,3,,,2", host, tool_at(10.0, 4.0, 0.0)).ends_at(12.0, 7.0, 0.0);
}

#[test]
fn sbp_file_fp_nested_compose() {
    let files = [("a.sbp", "M2,1,0 ⏎ FP,in.sbp,3,3,,,2 ⏎ M2,2,1"), ("in.sbp", "M2,1,1")];
    let ran = run_with("FP,a.sbp,2,2,,,2", host_with(&files), tool_at(10.0, 0.0, 0.0));
    assert_eq!(path(&ran), [[12.0, 0.0, 0.0], [18.0, 6.0, 0.0], [14.0, 2.0, 0.0]]);
}

const TEMPLATE: (&str, &str) = ("t.sbp", "M2,1,0 ⏎ M2,1,1 ⏎ M2,0,0");

/// The heights of all moves of a call from (5,5,z).
fn heights(call: &str, z: f64) -> Vec<f64> {
    let ran = run_with(call, host_with(&[TEMPLATE]), tool_at(5.0, 5.0, z));
    ran.ended(Status::Ok);
    path(&ran).iter().map(|p| p[2]).collect()
}

#[test]
fn sbp_file_fp_plunge() {
    let expected = [-0.25, -0.25, -0.25, -0.25, -0.5, -0.5, -0.5, -0.5, 0.0];
    assert_eq!(heights("FP,t.sbp,,,,2,2,-.25", 0.0), expected);
    let ran = run_with("FP,t.sbp,,,,,2,.25", host_with(&[TEMPLATE]), Session::default());
    assert!(ran.told().contains("lifts the tool"), "{}", ran.told());
}

#[test]
fn a_plunge_is_added_as_given_and_follows_the_proportion_of_its_caller() {
    let mut plus = tool_at(5.0, 5.0, 0.0);
    plus.settings.cutter.plunge = kerf_program::settings::PlungeSign::Plus;
    let ran = run_with("FP,t.sbp,,,,,2,.25", host_with(&[TEMPLATE]), plus);
    assert_eq!(path(&ran)[0][2], 0.25);
    assert_eq!(ran.told(), "");
    let files = [TEMPLATE, ("a.sbp", "FP,t.sbp,,,,,2,-.25")];
    let ran = run_files("FP,a.sbp,,,2", &files);
    assert_eq!(path(&ran)[0][2], -0.5);
}

#[test]
fn sbp_file_fp_plunge_zmoves() {
    for line in ["MZ,-1", "M3,1,1,-1", "JZ,&z", "J3,1,,-1", "IF 1=1 THEN MZ,-1"] {
        let ran = run_files("&z=1 ⏎ FP,t.sbp,,,,,,-.25", &[("t.sbp", line)]);
        ran.ended(Status::Ok);
        assert!(ran.told().contains("has Z moves"), "{line}");
    }
    let flat = run_files("FP,t.sbp,,,,,2,-.25", &[TEMPLATE]);
    assert_eq!(flat.told(), "");
}

#[test]
fn sbp_file_fp_from0() {
    let expected = [0.0, -0.25, -0.25, -0.25, -0.25, -0.5, -0.5, -0.5, -0.5, 0.5];
    assert_eq!(heights("FP,t.sbp,,,,2,2,-.25,,1", 0.5), expected);
}

#[test]
fn sbp_file_template_2d() {
    let ran = run_files("MZ,-.3 ⏎ FP,t.sbp,,,,,2", &[TEMPLATE]);
    assert!(path(&ran).iter().all(|p| p[2] == -0.3));
    ran.ends_at(0.0, 0.0, -0.3);
}

#[test]
fn sbp_file_fp_offset_home() {
    let host = || host_with(&[("p.sbp", "MX,5 ⏎ JH")]);
    let ran = run_with("FP,p.sbp,,,,,2", host(), tool_at(10.0, 4.0, 0.5));
    ran.ended(Status::Ok).ends_at(10.0, 4.0, 1.0);
    let ran = run_with("FP,p.sbp", host(), tool_at(10.0, 4.0, 0.5));
    ran.ended(Status::Ok).ends_at(0.0, 0.0, 1.0);
}

#[test]
fn sbp_file_fp_offset_sysvar() {
    let host = host_with(&[("p.sbp", "MX,1 ⏎ PRINT %(1) ⏎ PRINT (%(1)-%(61))/%(66)")]);
    let text = "FP,p.sbp,2,,,,2 ⏎ PRINT %(61), %(66)";
    let ran = run_with(text, host, tool_at(10.0, 4.0, 0.0));
    assert_eq!(ran.printed(), "12\n1\n0     1\n");
}

/// The XZ places of all moves, inches.
fn profile(ran: &Ran) -> Vec<[f64; 2]> {
    path(ran).into_iter().map(|[x, _, z]| [x, z]).collect()
}

/// A cut to X 20 at Z -.5 with the tabs of the VB defaults.
const TABBED: [[f64; 2]; 13] = [
    [4.0, -0.5],
    [4.5, -0.4],
    [5.5, -0.4],
    [6.0, -0.5],
    [10.0, -0.5],
    [10.5, -0.4],
    [11.5, -0.4],
    [12.0, -0.5],
    [16.0, -0.5],
    [16.5, -0.4],
    [17.5, -0.4],
    [18.0, -0.5],
    [20.0, -0.5],
];

#[test]
fn sbp_file_fp_tab() {
    let ran = run_files("FP,t.sbp,,,,2,,,1", &[("t.sbp", "MZ,-.5 ⏎ MX,20 ⏎ JZ,1 ⏎ JX,0")]);
    ran.ended(Status::Ok).ends_at(0.0, 0.0, 1.0);
    let plain = [[0.0, -0.5], [20.0, -0.5], [20.0, 1.0], [0.0, 1.0], [0.0, -0.5]];
    let expected: Vec<_> =
        plain.into_iter().chain(TABBED).chain([[20.0, 1.0], [0.0, 1.0]]).collect();
    assert_eq!(profile(&ran), expected);
}

#[test]
fn sbp_file_fp_tab_subfiles() {
    let files = [("master.sbp", "JX,0 ⏎ MZ,-.5 ⏎ FP,sub.sbp ⏎ JZ,1"), ("sub.sbp", "MX,20")];
    let ran = run_files("FP,master.sbp,,,,2,,,1 ⏎ JX,0 ⏎ MZ,-.5 ⏎ MX,20", &files);
    let steps = profile(&ran);
    // Not on the first of two repetitions, and not after the master's end.
    let tabbed: Vec<_> = steps.windows(TABBED.len()).filter(|w| *w == TABBED).collect();
    assert_eq!(tabbed.len(), 1, "{steps:?}");
    assert_eq!(&steps[..3], [[0.0, -0.5], [20.0, -0.5], [20.0, 1.0]]);
    assert_eq!(&steps[steps.len() - 2..], [[0.0, -0.5], [20.0, -0.5]]);
}

#[test]
fn the_return_of_z_after_plunges_gets_no_tabs() {
    let ran = run_files("FP,t.sbp,,,,,,-.5,1", &[("t.sbp", "MX,20")]);
    let expected: Vec<_> = [[0.0, -0.5]].into_iter().chain(TABBED).chain([[20.0, 0.0]]).collect();
    assert_eq!(profile(&ran), expected);
}

#[test]
fn the_temporary_zero_of_a_file_does_not_count_the_tool_offset_twice() {
    // The air drill stands 5 in to the right; the drawing's 0,0 stays where the spindle was.
    let ran = run_files("M2,10,4 ⏎ VO,1,5 ⏎ MX,10 ⏎ FP,p.sbp,,,,,2", &[("p.sbp", "M2,1,0")]);
    ran.ended(Status::Ok);
    assert_eq!(path(&ran).last(), Some(&[16.0, 4.0, 0.0]));
}
