//! Stops inside a plan, resuming, and the times at which Z passes a value.

use crate::shop::{joints, near, peaks, vs};
use kerf_motion::{Model, Optimal, Pass, Plan, Stop};
use kerf_program::settings::MM_PER_INCH as INCH;
use kerf_program::{Axes, Axis, Dynamics, Settings};

/// A stop that begins where a move's share is reached.
fn stop_at(plan: &Plan, index: usize, share: f64, ramped: bool) -> Stop {
    plan.stop(plan.time_at_share(index, share), ramped).unwrap()
}

fn x(stop: &Stop) -> f64 {
    stop.position[Axis::X] / INCH
}

#[test]
fn a_ramped_stop_slows_down_to_ramp_speed() {
    let plan = vs(2.0, 1.0).mx(10.0).plan();
    let stop = stop_at(&plan, 0, 0.4, true);
    near(&[x(&stop), stop.end_s - stop.begin_s], &[4.0 + 1.92 / 14.0, 1.6 / 14.0], 1e-9);
    let (done, rest) = plan.cut(&stop);
    near(&[peaks(&done)[0], done.duration_s()], &[2.0, stop.end_s], 1e-9);
    near(&joints(&done), &[0.4; 2], 1e-9);
    near(&[done.at(99.0).position[Axis::X]], &[stop.position[Axis::X]], 1e-9);
    assert_eq!(done.at(stop.end_s).path_speed_mm_s, 0.0);
    near(&[rest[0].from[Axis::X] / INCH, rest[0].to[Axis::X] / INCH], &[x(&stop), 10.0], 1e-9);
}

#[test]
fn an_immediate_stop_stands_where_it_began() {
    let plan = vs(2.0, 1.0).mx(10.0).plan();
    let stop = stop_at(&plan, 0, 0.4, false);
    near(&[x(&stop), stop.end_s - stop.begin_s], &[4.0, 0.0], 1e-9);
    let (done, rest) = plan.cut(&stop);
    near(&[done.duration_s(), done.iter().last().unwrap().v_exit / INCH], &[stop.end_s, 2.0], 1e-9);
    assert_eq!((done.moves().len(), rest.len()), (1, 1));
}

#[test]
fn a_stop_while_speeding_up_turns_at_once() {
    let plan = vs(2.0, 1.0).mx(10.0).plan();
    let stop = plan.stop(0.05, true).unwrap();
    // .05 s up and .05 s down, from and to .4 in/s.
    near(&[stop.end_s, x(&stop)], &[0.1, 0.1 * (0.4 + 0.5 * 0.7)], 1e-9);
    let (done, _) = plan.cut(&stop);
    near(&[peaks(&done)[0]], &[1.1], 1e-9);
}

#[test]
fn a_ramped_stop_runs_on_through_joints_but_not_round_a_full_corner() {
    let straight = vs(2.0, 1.0).mx(4.0).mx(4.05).mx(8.0).plan();
    let stop = stop_at(&straight, 0, 1.0 - 0.01, true);
    near(&[x(&stop)], &[3.96 + 1.92 / 14.0], 1e-9);
    assert_eq!(stop.move_index, 2);
    let (done, rest) = straight.cut(&stop);
    assert_eq!((done.moves().len(), rest.len()), (3, 1));
    near(&[done.time_at_share(2, 1.0)], &[stop.end_s], 1e-9);

    let corner = vs(2.0, 1.0).mx(4.0).m3(4.0, 4.0, 0.0).plan();
    let stop = stop_at(&corner, 0, 1.0 - 0.005, true);
    assert_eq!((stop.move_index, stop.share), (0, 1.0));
    let (done, rest) = corner.cut(&stop);
    assert_eq!((done.moves().len(), rest.len()), (1, 1));
}

/// Whoever is asked while the machine brakes how much of a move is made tells the same of every model: the
/// share that [`Stop::part`] names is one of the move as it was planned.
#[test]
fn shares_of_a_cut_plan_lead_to_where_it_is() {
    let moves = vs(2.0, 1.0).mx(4.0).mx(8.0).plan().moves().to_vec();
    let dynamics = Dynamics { tolerance_mm: 0.0, ..Dynamics::usual(&Settings::default().speeds) };
    let jerky = Dynamics { jerk_mm_s3: Some(Axes::splat(5000.0)), ..dynamics };
    let plans = [
        vs(2.0, 1.0).mx(4.0).mx(8.0).plan(),
        Optimal { dynamics: &dynamics }.plan(moves.clone()),
        Optimal { dynamics: &jerky }.plan(moves.clone()),
    ];
    for plan in plans {
        let stop = stop_at(&plan, 1, 0.3, true);
        let (cut, _) = plan.clone().cut(&stop);
        for n in 0..10 {
            let at = cut.at(stop.begin_s + (stop.end_s - stop.begin_s) * f64::from(n) / 10.0);
            let share = at.share * stop.part(at.move_index);
            let there = moves[at.move_index].position(share);
            near(&[there[Axis::X]], &[at.position[Axis::X]], 1e-6);
        }
    }
}

#[test]
fn a_stop_before_the_start_and_after_the_end() {
    let plan = vs(2.0, 1.0).mx(4.0).mx(8.0).plan();
    let (done, rest) = plan.clone().cut(&plan.stop(-1.0, true).unwrap());
    assert_eq!((done.moves().len(), done.duration_s(), rest.len()), (0, 0.0, 2));
    let (done, rest) = plan.clone().cut(&plan.stop(1e9, true).unwrap());
    assert_eq!((done.moves().len(), rest.len()), (2, 0));
    near(&[done.duration_s()], &[plan.duration_s()], 1e-12);
}

#[test]
fn a_stop_between_two_moves_leaves_the_second_whole() {
    let plan = vs(2.0, 1.0).j3(4.0, 0.0, 0.0).j3(8.0, 0.0, 0.0).plan();
    let stop = plan.stop(plan.span_s(1).0, true).unwrap();
    assert_eq!((stop.move_index, stop.share), (1, 0.0));
    let (done, rest) = plan.clone().cut(&stop);
    assert_eq!((done.moves(), &rest[..]), (&plan.moves()[..1], &plan.moves()[1..]));
    near(&[done.at(99.0).position[Axis::X] / INCH], &[4.0], 1e-9);
}

/// Passes of Z in the moves `MZ,.5 → -.3 → .1 → .5`, which start at .5.
fn check_pass(value: f64, from_s: f64, expected: Option<(bool, usize)>) {
    let plan = vs(2.0, 1.0).mz(0.5).mz(-0.3).mz(0.1).mz(0.5).plan();
    let pass = plan.time_when_axis_passes(Axis::Z, value * INCH, from_s);
    assert_eq!(pass.map(|p| (p.upward, p.move_index)), expected, "{value} from {from_s}");
    if let Some(Pass { t_s, .. }) = pass {
        near(&[plan.at(t_s).position[Axis::Z] / INCH], &[value], 1e-9);
        assert!(t_s >= from_s);
    }
}

#[test]
fn z_passes_a_value_on_its_way_down_and_up() {
    check_pass(0.05, 0.0, Some((true, 0)));
    check_pass(0.05, 0.7, Some((false, 1)));
    check_pass(0.05, 1.7, Some((true, 2)));
    check_pass(0.05, 9.0, None);
    // Reaching is not passing: up to .1 and standing there, then on.
    check_pass(0.1, 1.3, Some((true, 3)));
    check_pass(0.5, 0.0, Some((false, 1)));
    check_pass(-0.3, 0.0, Some((true, 2)));
    check_pass(0.6, 0.0, None);
}

#[test]
fn x_and_y_are_not_watched() {
    let plan = vs(2.0, 1.0).mx(4.0).plan();
    assert_eq!(plan.time_when_axis_passes(Axis::X, 1.0, 0.0), None);
}
