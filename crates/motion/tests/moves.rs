//! Commands become moves: speeds, lengths, arcs, feeds, and the effects of VS, VU and VR on them.

use crate::shop::{joints, near, peaks, vs};
use kerf_motion::{Move, Mover, Path, Plan, plan_stack};
use kerf_program::settings::MM_PER_INCH as INCH;
use kerf_program::{Arc, At, Axes, Axis, Feed, Line, MoveKind, Settings};
use std::f64::consts::{PI, TAU};

fn seconds(plan: &Plan) -> f64 {
    plan.duration_s()
}

#[test]
fn speed_is_that_of_the_tip_in_xy() {
    let no_ramps = |s: &mut Settings| s.ramps.cut.xy = 100.0 * INCH;
    let plan = vs(2.0, 1.0).set(no_ramps).m3(3.0, 4.0, 0.0).plan();
    near(&[seconds(&plan)], &[2.5], 1e-9);
    near(&plan.at(1.0).velocity.first3().map(|v| v / INCH), &[1.2, 1.6, 0.0], 1e-9);
    let circle = vs(2.0, 1.0).set(no_ramps).arc(2.0, 0.0, 360.0, false).plan();
    near(&[seconds(&circle)], &[TAU], 1e-9);
    let velocity = circle.at(1.0).velocity.first3();
    near(&[velocity[0].hypot(velocity[1]) / INCH], &[2.0], 1e-9);
}

#[test]
fn without_xy_the_slowest_axis_governs() {
    let plan = vs(4.0, 0.5).mz(-2.0).plan();
    near(&peaks(&plan), &[0.5], 1e-9);
    let mut settings = Settings::default();
    settings.speeds.cut.z = 1.0;
    settings.speeds.cut.b = 30.0;
    let mut mover = Mover::new(Axes::default(), &settings);
    let line =
        Line { kind: MoveKind::Cut, to: Axes([0.0, 0.0, 2.0, 0.0, 90.0, 0.0]), feed: Feed::Axis };
    let made = mover.line(At::default(), &line).unwrap();
    assert_eq!((made.length_mm, made.speed_mm_s), (90.0, 30.0), "B needs 3 s, Z only 2");
}

#[test]
fn a_steep_move_ramps_as_its_z_may() {
    // Z goes five times as far as X: from rest it may jump to .4 in/s, and X to a fifth of that.
    let plan = vs(4.0, 9.0).m3(1.0, 0.0, -5.0).plan();
    near(
        &[plan.moves()[0].ramp_mm_s / INCH, plan.moves()[0].accel_mm_s2 / INCH],
        &[0.08, 2.8],
        1e-9,
    );
    near(&plan.at(0.0).velocity.first3().map(|v| v / INCH), &[0.08, 0.0, -0.4], 1e-9);
}

#[test]
fn feeds_along_the_path_and_by_time() {
    let plan = vs(1.0, 0.1).g1(3.0, 0.0, -4.0, 2.0).plan();
    near(&[plan.moves()[0].length_mm / INCH, peaks(&plan)[0]], &[5.0, 2.0], 1e-9);
    let mut mover = Mover::new(Axes::default(), &Settings::default());
    let line = Line { kind: MoveKind::Cut, to: Axes::xyz(30.0, 0.0, 40.0), feed: Feed::Time(10.0) };
    assert_eq!(mover.line(At::default(), &line).unwrap().speed_mm_s, 5.0);
    let turn = Line { to: Axes([30.0, 0.0, 40.0, 0.0, 90.0, 0.0]), feed: Feed::Path(9.0), ..line };
    let made = mover.line(At::default(), &turn).unwrap();
    assert_eq!((made.length_mm, made.speed_mm_s), (90.0, 9.0));
}

#[test]
fn along_the_path_a_plunge_after_a_cut_is_passed_at_ramp_speed() {
    let plan =
        vs(1.0, 0.1).g1(3.0, 0.0, 0.0, 2.0).g1(3.0, 0.0, -1.0, 2.0).g1(9.0, 0.0, -1.0, 2.0).plan();
    near(&joints(&plan), &[0.4; 4], 1e-9);
}

#[test]
fn along_the_path_a_change_of_xy_speed_alone_counts() {
    let stiff = |s: &mut Settings| s.ramps.cut.z = 9.0 * INCH;
    let plan = vs(1.0, 0.1).set(stiff).g1(3.0, 0.0, 0.0, 2.0).g1(3.0, 0.0, -1.0, 2.0).plan();
    near(&joints(&plan)[1..2], &[0.4], 1e-9);
}

#[test]
fn bends_on_both_sides_of_a_plunge_do_not_add_up() {
    let stack = vs(3.0, 1.0).mx(9.0).ray(30.0, 0.05).mz(-1.0).ray(30.0, 0.05).ray(60.0, 9.0);
    let reached = (0.16f64 + 28.0 * 0.05).sqrt();
    near(&joints(&stack.plan()), &[0.4, reached, 0.4, 0.4, reached, 0.4], 1e-9);
}

#[test]
fn each_axis_stops_and_starts_at_its_own_ramp_speed() {
    let soft = |s: &mut Settings| s.ramps.cut.z = 0.2 * INCH;
    let plan = vs(2.0, 1.0).set(soft).mx(4.0).mz(-1.0).plan();
    let ends: Vec<f64> = plan.iter().flat_map(|s| [s.v_entry / INCH, s.v_exit / INCH]).collect();
    near(&ends, &[0.4, 0.4, 0.2, 0.2], 1e-9);
}

#[test]
fn a_tangent_arc_is_entered_and_left_at_full_speed() {
    for sweep in [90.0, -90.0] {
        let stack = vs(2.0, 1.0).mx(4.0).arc(4.0, sweep / 90.0, sweep, false).ray(sweep, 4.0);
        near(&joints(&stack.plan()), &[0.4, 2.0, 2.0, 0.4], 1e-9);
    }
}

#[test]
fn xy_and_z_alone_meet_at_ramp_speed() {
    let plan = vs(2.0, 1.0).mx(4.0).mz(-1.0).mz(-2.0).mx(0.0).plan();
    near(&joints(&plan), &[0.4, 0.4, 1.0, 0.4, 0.4], 1e-9);
}

#[test]
fn a_speed_change_in_a_stack_is_blended() {
    let slow = |s: &mut Settings| s.speeds.cut.xy = INCH;
    let plan = vs(2.0, 1.0).mx(5.0).set(slow).mx(10.0).plan();
    near(&joints(&plan), &[0.4, 1.0, 0.4], 1e-9);
    near(&peaks(&plan), &[2.0, 1.0], 1e-9);
}

#[test]
fn the_step_interval_divider_makes_everything_slower() {
    let divided = |s: &mut Settings| s.resolution.divider = 4;
    near(&[seconds(&vs(0.2, 1.0).set(divided).mx(1.0).plan())], &[20.0], 1e-9);
    let once = seconds(&vs(2.0, 1.0).mx(4.0).plan());
    near(&[seconds(&vs(2.0, 1.0).set(divided).mx(4.0).plan())], &[4.0 * once], 1e-9);
}

#[test]
fn without_resolution_shifting_jogs_are_capped_at_16_inches() {
    let fast = |s: &mut Settings| {
        s.speeds.jog.xy = 20.0 * INCH;
        s.speeds.cut.xy = 20.0 * INCH;
        s.resolution.no_shift = true;
    };
    let plan = vs(2.0, 1.0).set(fast).j3(90.0, 0.0, 0.0).mx(0.0).plan();
    near(&peaks(&plan), &[16.0, 20.0], 1e-9);
}

#[test]
fn small_circles_run_at_ramp_speed_and_others_may_not() {
    let circle = |radius: f64, small| vs(2.0, 1.0).arc(0.0, radius, 360.0, small).plan();
    let small = circle(0.1, true);
    near(&[peaks(&small)[0], seconds(&small)], &[0.4, 0.2 * PI / 0.4], 1e-9);
    near(&[peaks(&circle(0.15, false))[0], peaks(&circle(0.2, false))[0]], &[2.0; 2], 1e-9);
}

#[test]
fn arcs_slow_as_the_curves_they_are() {
    let through = |speed, sweep: f64, radius: f64| {
        let stack = vs(speed, 1.0).mx(9.0).arc(9.0, radius, sweep, false);
        peaks(&stack.ray(sweep, 9.0).plan())[1]
    };
    // .15 in of a radius of 1 in turn by 8.6°; the rule as for a corner.
    near(&[through(10.0, 90.0, 1.0)], &[6.5 - 6.1 * (8.594367 - 5.0) / 38.0], 1e-5);
    near(
        &[through(3.0, 45.0, 0.2), through(3.0, 45.0, 0.24), through(3.0, 45.0, 1.0)],
        &[0.4, 0.4, 3.0],
        1e-9,
    );
    near(&[through(3.0, 40.0, 0.24), through(10.0, 360.0, 1.0)], &[1.71974, 5.92301], 1e-4);
}

#[test]
fn short_arcs_add_up() {
    let mut stack = vs(3.0, 1.0).mx(9.0);
    for k in 0..3 {
        let (sin, cos) = (30.0 * f64::from(k)).to_radians().sin_cos();
        let [x, y, _] = stack.here();
        stack = stack.arc(x - 0.05 * sin, y + 0.05 * cos, 30.0, false);
    }
    near(&peaks(&stack.ray(90.0, 9.0).plan())[1..4], &[0.4; 3], 1e-9);
}

#[test]
fn an_arc_runs_where_it_should_and_ends_where_it_is_told() {
    let mut mover = Mover::new(Axes::xyz(10.0, 0.0, 0.0), &Settings::default());
    let arc = Arc {
        kind: MoveKind::Cut,
        centre: [0.0, 0.0],
        sweep_rad: -PI,
        to: Axes::xyz(-10.02, 0.0, -2.0),
        feed: Feed::Axis,
        chords: 8,
        small: false,
    };
    let made = mover.arc(At::default(), &arc).unwrap();
    near(&[made.length_mm], &[10.0 * PI], 1e-9);
    near(&made.position(0.5).first3(), &[-0.01, -10.0, -1.0], 1e-9);
    near(&made.derivative(0.0).first3(), &[-0.02, -10.0 * PI, -2.0], 1e-9);
    assert_eq!(made.position(1.0), arc.to);
    let (a, b) = made.split(0.25);
    near(&a.to.first3(), &b.from.first3(), 0.0);
    near(&b.position(1.0 / 3.0).first3(), &made.position(0.5).first3(), 1e-9);
    near(&[a.length_mm + b.length_mm], &[made.length_mm], 1e-9);
}

#[test]
fn an_arc_is_parted_with_its_chords_and_shifted_with_its_centre() {
    let mut mover = Mover::new(Axes::xyz(10.0, 0.0, 0.0), &Settings::default());
    let arc = Arc {
        kind: MoveKind::Cut,
        centre: [0.0, 0.0],
        sweep_rad: PI,
        to: Axes::xyz(-10.0, 0.0, 0.0),
        feed: Feed::Axis,
        chords: 40,
        small: false,
    };
    let mut made = mover.arc(At::default(), &arc).unwrap();
    let chords = |part: Move| match part.path {
        Path::Arc { chords, .. } => chords,
        _ => 0,
    };
    let (before, after) = made.split(0.25);
    assert_eq!([before, after].map(chords), [10, 30]);
    made.shift(Axes::xyz(1.0, 2.0, 3.0));
    near(&made.position(0.5).first3(), &[1.0, 12.0, 3.0], 1e-9);
}

#[test]
fn an_arc_without_radius_is_a_straight_move() {
    let mut mover = Mover::new(Axes::default(), &Settings::default());
    let to = Axes::xyz(0.0, 0.0, -1.0);
    let arc = Arc {
        kind: MoveKind::Cut,
        centre: [0.0, 0.0],
        sweep_rad: TAU,
        to,
        feed: Feed::Axis,
        chords: 8,
        small: false,
    };
    let made = mover.arc(At::default(), &arc).unwrap();
    assert_eq!((made.to, made.arc()), (to, None));
    assert!(mover.arc(At::default(), &arc).is_none(), "nothing moves any more");
    assert_eq!(mover.position()[Axis::Z], -1.0);
}

#[test]
fn a_jog_inside_a_stack_is_a_stop_on_both_sides() {
    let mut settings = Settings::default();
    settings.ramps.jog.xy = 1.2 * INCH;
    let mut mover = Mover::new(Axes::default(), &settings);
    let kinds = [MoveKind::Cut, MoveKind::Jog, MoveKind::Cut];
    let moves = (1..)
        .zip(kinds)
        .filter_map(|(k, kind)| {
            let to = Axes::xyz(100.0 * f64::from(k), 0.0, 0.0);
            mover.line(At::default(), &Line { kind, to, feed: Feed::Axis })
        })
        .collect();
    let plan = plan_stack(moves, &settings.ramps);
    let ends: Vec<f64> = plan.iter().flat_map(|s| [s.v_entry / INCH, s.v_exit / INCH]).collect();
    near(&ends, &[0.4, 0.4, 1.2, 1.2, 0.4, 0.4], 1e-9);
}
