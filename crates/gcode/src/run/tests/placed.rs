//! Files that FP lays elsewhere, scales or mirrors: what counts as the file, and what as the machine.

use crate::Options;
use crate::testing::{FakeHost, Ran, metric, run_with};
use kerf_program::Tool;
use kerf_program::{Axes, Command};

/// Runs a program as FP calls it, with a tool of length 40 and G28 at 100, 200, 300.
fn placed(text: &str, proportion: [f64; 3], zero: [f64; 3]) -> Ran {
    let mut session = metric();
    session
        .state
        .tools
        .insert(1, Tool { diameter_mm: 2.0, offset: Axes::xyz(0.0, 0.0, 40.0), ..Tool::default() });
    session.state.home[0] = Axes::xyz(100.0, 200.0, 300.0);
    let options = Options { proportion, temporary_zero_mm: zero, ..Options::default() };
    run_with(&format!("G21 F100⏎{text}"), FakeHost::default(), session, options)
}

#[track_caller]
fn check(text: &str, proportion: [f64; 3], zero: [f64; 3], expected: &str) {
    let ran = placed(text, proportion, zero);
    assert!(ran.error.is_none(), "{text}: {:?}", ran.error);
    assert_eq!(ran.path(), expected, "{text}");
}

/// Ends, sweeps and centres of the motion.
fn motion(ran: &Ran) -> Vec<([f64; 3], f64, [f64; 2])> {
    let motion = ran.commands.iter().filter_map(|c| match &c.command {
        Command::Line(line) => Some((line.to.first3(), 0.0, [0.0; 2])),
        Command::Arc(arc) => Some((arc.to.first3(), arc.sweep_rad, arc.centre)),
        _ => None,
    });
    motion.collect()
}

/// The mirrored file makes the mirror image of each motion.
#[track_caller]
fn check_image(text: &str) {
    let usual = placed(text, [1.0; 3], [0.0; 3]);
    assert!(usual.error.is_none(), "{text}: {:?}", usual.error);
    let usual = motion(&usual);
    assert!(usual.len() > 2, "{text}");
    for by in [[-1.0, 1.0, 1.0], [1.0, -1.0, 1.0], [-1.0, -1.0, 1.0], [1.0, 1.0, -1.0]] {
        let ran = placed(text, by, [0.0; 3]);
        assert!(ran.error.is_none(), "{text} {by:?}: {:?}", ran.error);
        let images = motion(&ran);
        assert_eq!(images.len(), usual.len(), "{text} {by:?}");
        for ((to, sweep, centre), (image, turned, middle)) in usual.iter().zip(&images) {
            let near = |a: f64, b: f64| (a - b).abs() < 1e-9;
            let same = (0..3).all(|i| near(to[i] * by[i], image[i]))
                && (0..2).all(|i| near(centre[i] * by[i], middle[i]))
                && near(sweep * by[0] * by[1], *turned);
            assert!(same, "{text} {by:?}: {to:?} {sweep} became {image:?} {turned}");
        }
    }
}

#[test]
fn what_is_turned_is_turned_the_other_way_in_a_mirror() {
    check_image("G10 L2 P0 R30⏎G1 X10 Y0⏎G2 X20 Y10 I10⏎G1 Y20⏎G3 X25 Y25 R5");
    check_image("#5230=30⏎G54⏎G1 X10 Y0⏎G1 X[#5230] Y5⏎X5");
    check_image("G10 L2 P0 R30⏎G1 X10⏎G10 L20 P0 X3 Y4⏎G1 X0⏎Y0⏎G92 X7⏎G1 X9 Y9");
}

#[test]
fn polar_places_arcs_and_planes_are_mirrored() {
    check_image("G1 @10 ^30⏎@20⏎^90⏎G91 @5⏎^15");
    check_image("G1 X10 Y10⏎G2 X20 Y20 R10⏎G3 X25 Y15 R-5⏎G3 X30 Y20 I5 J0 P2⏎G2 I3");
    check_image("G18 G1 X5 Z5⏎G2 X10 Z0 I5 K0⏎G19 G3 Y5 Z5 J0 K5⏎G17 G1 X0");
    check_image("G41.1 D2 G1 X10 Y10⏎Y30⏎G2 X20 Y40 I10⏎G1 X40⏎G40 X60 Y0");
}

#[test]
fn cycles_drill_the_other_way_in_a_mirror() {
    check_image("G0 Z10⏎G98 G81 X1 Y1 R2 Z-5⏎X3⏎G99 X5⏎R4 X7⏎G98 R3 X8");
    check_image("G0 Z10⏎G91 G81 X1 Y1 R-2 Z-5 L3⏎G90 G80");
    check_image("G0 Z10⏎G73 X1 R2 Z-5 Q1.5⏎G83 X2 R2 Z-5 Q1.5⏎G85 X3 R2 Z-5⏎G89 X4 R2 Z-5");
    check_image("G18 G0 Y9⏎G81 Y-5 R2 X3⏎Z3⏎G19 G80 G0 X9⏎G83 X-5 R3 Q2 Y1");
}

#[test]
fn places_of_the_machine_stay_where_they_are() {
    let (twice, there) = ([-2.0, 2.0, 0.5], [10.0, 20.0, 0.0]);
    check("G0 X1 Y1 Z2⏎G53 G0 X1 Y1 Z2", twice, there, "J8,22,1 J1,1,2");
    // The place on the way is one of the file.
    check("G0 X1 Y1 Z2⏎G28 Z8", twice, there, "J8,22,1 J8,22,4 J8,22,300");
    check("G0 X1⏎G28", twice, there, "J8,0,0 J100,200,300");
    // So are tool lengths, and zeros that G10 L2 sets.
    check("G43 H1 G0 X1 Y1 Z2⏎G49 Z2", twice, there, "J8,22,41 J8,22,1");
    check("G10 L2 P0 X5⏎G0 X1", twice, there, "J13,0,0");
}
