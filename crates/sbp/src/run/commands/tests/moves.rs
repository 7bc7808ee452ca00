//! Moves and jogs, by the rows of the ledger.
#![allow(clippy::unwrap_used)]

use crate::testing::{rows, run, run_with};
use crate::{Session, testing::FakeHost};
use kerf_program::{Axis, Command, Independent, MoveKind};

rows! {
    sbp_cmd_mx: "MX,2.5" => "at 2.5,0,0,0,0,0; last cut", "MX,1⏎SR⏎MX,2.5" => "at 3.5,0,0", "MX" => "error value expected";
    sbp_cmd_my: "MY,2.5" => "at 0,2.5,0,0,0,0; last cut", "MY,1⏎SR⏎MY,2.5" => "at 0,3.5,0", "MY" => "error value expected";
    sbp_cmd_mz: "MZ,2.5" => "at 0,0,2.5,0,0,0; last cut", "MZ,1⏎SR⏎MZ,2.5" => "at 0,0,3.5", "MZ" => "error value expected";
    sbp_cmd_ma: "VD,,4⏎MA,2.5" => "at 0,0,0,2.5,0,0; last cut", "VD,,4⏎MA,1⏎SR⏎MA,2.5" => "at 0,0,0,3.5", "MA" => "error value expected", "MA,1" => "error A axis not active";
    sbp_cmd_mb: "VD,,5⏎MB,2.5" => "at 0,0,0,0,2.5,0; last cut", "VD,,5⏎MB,1⏎SR⏎MB,2.5" => "at 0,0,0,0,3.5", "MB" => "error value expected";
    sbp_cmd_jx: "JX,2.5" => "at 2.5,0,0; last jog", "JX,1⏎SR⏎JX,2.5" => "at 3.5,0,0";
    sbp_cmd_jy: "JY,2.5" => "at 0,2.5,0; last jog", "JY,1⏎SR⏎JY,2.5" => "at 0,3.5,0";
    sbp_cmd_jz: "JZ,2.5" => "at 0,0,2.5; last jog", "JZ,1⏎SR⏎JZ,2.5" => "at 0,0,3.5";
    sbp_cmd_ja: "VD,,4⏎JA,2.5" => "at 0,0,0,2.5; last jog", "VD,,4⏎JA,1⏎SR⏎JA,2.5" => "at 0,0,0,3.5";
    sbp_cmd_jb: "VD,,5⏎JB,2.5" => "at 0,0,0,0,2.5; last jog", "VD,,5⏎JB,1⏎SR⏎JB,2.5" => "at 0,0,0,0,3.5";
    sbp_cmd_rotary_units: "VD,,5,,,2⏎MB,90" => "5=90; at 0,0,0,0,90", "VD,,5,,,2⏎MB,90⏎VD,,,1" => "5=90; 25=1";
    sbp_cmd_m2: "M2,1,2" => "at 1,2,0; moves 1; last cut";
    sbp_cmd_m3: "M3,1,2,3" => "at 1,2,3; moves 1; last cut";
    sbp_cmd_m4: "VD,,4⏎M4,1,2,3,4" => "at 1,2,3,4; moves 1; last cut";
    sbp_cmd_m5: "VD,,5⏎M5,1,2,3,4,5" => "at 1,2,3,4,5; moves 1; last cut";
    sbp_cmd_j2: "J2,1,2" => "at 1,2,0; moves 1; last jog";
    sbp_cmd_j3: "J3,1,2,3" => "at 1,2,3; moves 1; last jog";
    sbp_cmd_j4: "VD,,4⏎J4,1,2,3,4" => "at 1,2,3,4; moves 1; last jog";
    sbp_cmd_j5: "VD,,5⏎J5,1,2,3,4,5" => "at 1,2,3,4,5; moves 1; last jog";
    sbp_cmd_c_axis: "VD,,6⏎MC,90" => "144=90; 145=0", "VD,,6⏎JC,90⏎ZC⏎MC,5" => "144=5; 145=90",
        "VD,,6⏎M6,1,2,3,4,5,6⏎J6,,,,,,7" => "at 1,2,3,4,5,7", "VD,,6⏎M6,1,2,3,4,5,6⏎Z6" => "at 0,0,0,0,0,0", "MC,1" => "error C axis not active";
    sbp_cmd_multi_blank: "M3,1,2,3⏎M3,,5" => "at 1,5,3", "M3,1,2,3⏎J3,,,1" => "at 1,2,1", "M2,1,2⏎M2,4" => "at 4,2",
        "M2,1,2⏎M2" => "at 1,2; moves 1; warning no location", "M2,1,2⏎M2,%(1)" => "at 1,2; moves 1; no warning";
    sbp_cmd_multi_relative: "M3,1,2,3⏎SR⏎M3,1,,-1" => "at 2,2,2", "M3,1,2,3⏎SR⏎M3,1,,-1⏎M3,1,,-1" => "at 3,2,1";
    sbp_cmd_abs_same: "M2,3,7⏎M2,3,7" => "at 3,7; moves 1; no warning",
        "M2,6,7⏎VD,,,1⏎M2,152.4,177.8⏎M2,%(1),%(2)" => "at 152.4,177.8; moves 1";

    sbp_cmd_mh_high: "M3,5,4,2⏎MH" => "at 0,0,2; moves 2";
    sbp_cmd_home_relative: "M3,5,4,2⏎SR⏎MH" => "at 0,0,2; 21=1", "M3,5,4,2⏎SR⏎JH" => "at 0,0,2; 21=1";
    sbp_cmd_home_safez_off: "VC,,,,OFF⏎M3,5,4,-.5⏎MH" => "at 0,0,-.5; 28=; warning Safe-Z is off";
    sbp_cmd_home_safea: "VD,,4⏎M4,5,4,-.5,-.5⏎JH" => "at 0,0,1,1; moves 3; last jog", "VD,,4,,2⏎M4,5,4,-.5,-.5⏎JH" => "at 0,0,1,-.5";

    sbp_cmd_md_abs: "MD,10,90" => "at 10,0", "MD,10,45" => "at 7.0711,7.0711", "MD,10,180" => "at 0,-10", "MD,5,202.5" => "at -1.9134,-4.6194",
        "MX,1⏎SR⏎MD,10,90" => "at 11,0", "MX,1⏎MD,10,90" => "at 11,0";
    sbp_cmd_md_rel_r: "MX,5⏎MD,4,90R" => "at 5,-4", "MY,1⏎MD,4,45R" => "at 2.8284,3.8284";
    sbp_cmd_md_rel_l: "MX,5⏎MD,4,90L" => "at 5,4", "MX,5⏎MD,4,30l" => "at 8.4641,2";
    sbp_cmd_md_rel_first: "MD,4,90L" => "at 4,0", "MD,4,90R" => "at 4,0";
    sbp_cmd_md_rel_arc: "CC,4,T,1,0,90⏎MD,1,90L" => "at 3,-2", "MX,5⏎MZ,-.2⏎MD,1,90R" => "at 5,-1,-.2";
    sbp_cmd_md_clock: "MD,10,3:00" => "at 10,0", "MD,10,1:30" => "at 7.0711,7.0711", "MD,10,12:00" => "at 0,10", "MD,10,7:30" => "at -7.0711,-7.0711",
        "MD,1,13:00" => "error is not a direction";
    sbp_cmd_md_z_abs: "MD,10,90,-.5" => "at 10,0,-.5; moves 1", "MZ,-1⏎SR⏎MD,10,90,-.5" => "at 10,0,-.5";
    sbp_cmd_md_z_ud: "MZ,-.5⏎MD,10,90,.25U" => "at 10,0,-.25", "MZ,-.5⏎MD,10,90,.25U⏎MD,10,90,.25D" => "at 20,0,-.5",
        "MD,1,0,.25X" => "error no change of Z";
    sbp_cmd_md_err: "MD,10" => "error angle expected", "MD,,90" => "error length expected", "MD,-2,90" => "at -2,0";

    an_indexer_takes_what_makes_sense: "VD,,5⏎MI,B,1,30,2,.5" => "error exclude each other", "MI,Z,,,2" => "error distance expected",
        "MI,Z,,,31,.1" => "warning fast", "VD,,5⏎MI" => "error rotary speed or frequency", "MI,B,1,3" => "error B axis not active";
    an_axis_that_moves_by_itself_takes_no_moves: "VD,,5⏎MI,B,1,30⏎MX,1⏎MB,5" => "error B axis is moving by itself; at 1,0,0";
    sbp_cmd_ms: "MS,3,1,2,50" => "71=3; 72=3; 73=1; 74=2; 75=50", "MS,3,1,2,50⏎MS,,.5" => "71=3; 73=.5; 74=2", "MS,0" => "error greater than 0", "MS,,-1" => "error greater than 0";
    sbp_cmd_js: "JS,8,4" => "76=8; 77=8; 78=4", "VS,,,,,8,4" => "76=8; 77=8; 78=4";
    sbp_cmd_speed_units: "VD,,,1⏎MS,50.8" => "71=50.8", "VD,,,1⏎MS,50.8⏎VD,,,0" => "71=2", "VD,,5⏎MS,,,,30⏎VD,,,1" => "75=30";
}

fn kinds(program: &str) -> Vec<(MoveKind, [f64; 3])> {
    run(program).moves()
}

#[test]
fn sbp_cmd_mh_low() {
    let from = (MoveKind::Cut, [5.0, 4.0, -0.5]);
    let (up, home) = ([5.0, 4.0, 1.0], [0.0, 0.0, 1.0]);
    assert_eq!(kinds("M3,5,4,-.5⏎MH"), [from, (MoveKind::Cut, up), (MoveKind::Cut, home)]);
}

#[test]
fn sbp_cmd_jh() {
    let from = (MoveKind::Cut, [5.0, 4.0, -0.5]);
    let (up, home) = ([5.0, 4.0, 1.0], [0.0, 0.0, 1.0]);
    assert_eq!(kinds("M3,5,4,-.5⏎JH"), [from, (MoveKind::Jog, up), (MoveKind::Jog, home)]);
    run("M3,5,4,2⏎JH").ends_at(0.0, 0.0, 2.0);
    assert_eq!(kinds("M3,5,4,2⏎JH").len(), 2);
}

#[test]
fn sbp_cmd_md_compass() {
    let points = "N NNE NE ENE E ESE SE SSE S SSW SW WSW W WNW NW NNW";
    for (point, place) in points.split(' ').zip(0..) {
        let degrees = 22.5 * f64::from(place);
        let (x, y) = (10.0 * degrees.to_radians().sin(), 10.0 * degrees.to_radians().cos());
        run(&format!("MD,10,{point}")).ends_at(x, y, 0.0);
    }
    run("MD,5,ssw").ends_at(-1.9134, -4.6194, 0.0);
    run("MD,5,NNX").fails_with("'NNX' is not a direction");
}

fn motions(program: &str) -> Vec<(Axis, Independent)> {
    let ran = run(program);
    let of = |c: &kerf_program::Sourced| match c.command {
        Command::Independent { axis, motion } => Some((axis, motion)),
        _ => None,
    };
    ran.commands.iter().filter_map(of).collect()
}

#[test]
fn an_indexer_turns_either_way_in_units_of_its_axis() {
    use Independent::{Oscillate, Rotate};
    assert_eq!(motions("VD,,5⏎MI,B,1,30"), [(Axis::B, Rotate(30.0))]);
    assert_eq!(motions("VD,,5⏎MI,,,30"), [(Axis::B, Rotate(30.0))]);
    assert_eq!(motions("VD,,5⏎MI,B,-1,30"), [(Axis::B, Rotate(-30.0))]);
    assert_eq!(motions("VD,,4⏎MI,A,1,2"), [(Axis::A, Rotate(50.8))]);
    let swing = Oscillate { frequency_hz: 2.0, distance: 12.7 };
    assert_eq!(motions("MI,Z,,,2,.5"), [(Axis::Z, swing)]);
}

#[test]
fn an_indexer_runs_until_it_is_stopped() {
    let flag = |program: &str| run(&format!("VD,,5⏎{program}⏎&on=%(123)")).variable("on");
    assert_eq!(flag("MI,B,1,30⏎MX,5"), "1");
    assert_eq!(flag("MI,B,1,30⏎MI,B,1,0"), "0");
    assert_eq!(flag("MI,Z,,,2,.5⏎MI,Z,,,0"), "0");
    assert_eq!(flag("MI,B,1,30⏎MO"), "0");
    let after = run("VD,,5⏎MI,B,1,30").session;
    assert!(after.independent.contains(Axis::B), "the end of a file does not stop it");
    assert_eq!(run_with("&on=%(123)", FakeHost::default(), after).variable("on"), "1");
}

#[test]
fn after_an_indexer_stops_its_axis_is_where_the_machine_says() {
    let host = FakeHost { strays_to: Some([0.0, 0.0, 0.0, 0.0, 300.0, 0.0]), ..Default::default() };
    let ran = run_with("VD,,5⏎MI,B,1,30⏎MI,B,1,0⏎&b=%(5)⏎MB,310", host, Session::default());
    assert_eq!(ran.variable("b"), "300");
    assert_eq!(ran.session.position[Axis::B], 310.0);
}

#[test]
fn motors_off_switches_outputs_off() {
    let ran = run("MX,3⏎SO,3,1⏎SO,5,1⏎MO⏎MX,4");
    assert!(ran.commands.iter().any(|c| c.command == Command::MotorsOff));
    assert_eq!(ran.host.outputs, [false; 13]);
    ran.ends_at(4.0, 0.0, 0.0);
}

#[test]
fn sbp_cmd_mo_zero() {
    let off = |text: &str| run(text).commands.iter().any(|c| c.command == Command::MotorsOff);
    assert!(off("M0") && off("MO") && off("mo"));
}

#[test]
fn relative_moves_and_turns_see_the_proportions_of_the_file() {
    let host = |text: &str| {
        let mut host = FakeHost::default();
        host.files.insert("part.sbp".into(), text.into());
        host
    };
    let run = |call: &str, part: &str| run_with(call, host(part), Session::default());
    run("FP,part.sbp,2,3", "MD,1,90\nMD,1,90L").ends_at(2.0, 3.0, 0.0);
    run("FP,part.sbp,-1,1", "MD,1,90\nMD,1,90L").ends_at(-1.0, 1.0, 0.0);
    run("FP,part.sbp,2,3,4", "SR\nM3,1,1,1\nM3,1,1,1").ends_at(4.0, 6.0, 8.0);
    run("M3,10,4,.5⏎FP,part.sbp,,,,,1", "MD,1,90,-.2").ends_at(11.0, 4.0, 0.3);
    run("M3,10,4,.5⏎FP,part.sbp,,,,,1", "MX,5\nMZ,.1\nMH").ends_at(10.0, 4.0, 1.0);
    run("M2,10,4⏎FP,part.sbp,2,2,,,2", "VO,1,1,1\nM2,1,1\nMD,1,90\nMH\nVO,2\nMH")
        .ends_at(10.0, 4.0, 1.0);
}

#[test]
fn sbp_cmd_mi_limits() {
    let speeds = kerf_program::Axes([100.0, 100.0, 50.0, 50.0, 90.0, 90.0]);
    let refuses = |text: &str| {
        let mut session = Session::default();
        session.settings.dynamics = Some(kerf_program::Dynamics {
            speed_mm_s: speeds,
            accel_mm_s2: kerf_program::Axes::splat(500.0),
            jerk_mm_s3: None,
            tolerance_mm: 0.01,
        });
        let ran = run_with(&format!("VD,,5⏎{text}"), FakeHost::default(), session);
        ran.error.map(|e| e.message)
    };
    let without = || {
        let mut session = Session::default();
        session.settings.controller.independent = false;
        run_with("VD,,5⏎MI,B,1,9", FakeHost::default(), session)
    };
    without().fails_with("not supported by this controller");
    let b = Some("B axis moves 90 units a second at most".to_owned());
    assert_eq!((refuses("MI,B,1,91"), refuses("MI,B,-1,91")), (b.clone(), b));
    assert_eq!(refuses("MI,B,1,90"), None);
    let unknown = |text: &str| run(&format!("VD,,5⏎{text}"));
    unknown("MI,B,1,99999").fails_with("B axis moves 600 units a second at most");
    assert!(unknown("MI,B,1,600").error.is_none());
    let z = Some("Z axis moves 1.968504 units a second at most".to_owned());
    assert_eq!((refuses("MI,Z,,,2,.32"), refuses("MI,Z,,,2,.31")), (z, None));
}
