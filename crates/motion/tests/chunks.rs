//! The plan of a stack that is read in parts is the plan of the whole stack.

use crate::walk::moves;
use kerf_motion::{
    Model, Move, Mover, Optimal, OptimalPlanner, Plan, Planner, Profiler, ProfilerPlanner,
    ShopBotPlanner, Span, plan_stack,
};
use kerf_program::settings::Ramps;
use kerf_program::{AXES, At, Axes, Dynamics, Feed, Line, MoveKind, Settings, Smoothing};
use proptest::prelude::*;

/// The pieces that come out when so many moves are pushed between two looks, 0 for none at all.
fn pieces(planner: &mut dyn Planner, moves: &[Move], at_once: usize) -> Vec<Plan> {
    let mut pieces = Vec::new();
    for (i, made) in moves.iter().enumerate() {
        planner.push(*made);
        if at_once > 0 && i % at_once == 0 {
            pieces.extend(planner.take());
        }
    }
    pieces.extend(planner.finish());
    pieces
}

fn spans(pieces: &[Plan]) -> Vec<Span<'_>> {
    let all = pieces.iter().flat_map(Plan::iter);
    all.enumerate().map(|(index, span)| Span { index, ..span }).collect()
}

fn check(moves: &[Move], ramps: &Ramps, at_once: usize) -> usize {
    let whole = [plan_stack(moves.to_vec(), ramps)];
    agree(&whole, &pieces(&mut ShopBotPlanner::new(ramps), moves, at_once), at_once)
}

/// The same for the `profiler` model.
fn check_profiler(moves: &[Move], smoothing: &Smoothing, at_once: usize) -> usize {
    let dynamics = &Settings::default().axis_dynamics();
    let whole = [Profiler { dynamics, smoothing }.plan(moves.to_vec())];
    let mut planner = ProfilerPlanner::new(dynamics, smoothing);
    agree(&whole, &pieces(&mut planner, moves, at_once), at_once)
}

/// Checks that the pieces agree with the whole; tells the number of pieces.
fn agree(whole: &[Plan], pieces: &[Plan], at_once: usize) -> usize {
    let (expected, found) = (spans(whole), spans(pieces));
    assert_eq!(found.len(), expected.len());
    for (found, expected) in found.iter().zip(&expected) {
        assert_eq!(found, expected, "every {at_once}");
    }
    pieces.len()
}

#[test]
fn pieces_make_the_plan_of_the_whole_stack() {
    for (seed, min_distance_mm) in [(1, 3.81), (2, 0.0), (3, 40.0)] {
        let ramps = Ramps { min_distance_mm, ..Settings::default().ramps };
        let moves = moves(60_000, seed);
        for at_once in [0, 1, 1000, 7777] {
            let count = check(&moves, &ramps, at_once);
            assert!((at_once == 0 && count == 1) || count > 4, "{count} pieces");
        }
    }
}

#[test]
fn pieces_of_smoothed_sections_make_the_plan_of_the_whole_stack() {
    for (seed, factor) in [(1, 0.6), (2, 0.0), (3, 8.0)] {
        let smoothing = Smoothing { factor, stop_angle_deg: 4.0, ..Smoothing::default() };
        let moves = moves(30_000, seed);
        for at_once in [0, 1, 7777] {
            let count = check_profiler(&moves, &smoothing, at_once);
            assert!((at_once == 0 && count == 1) || count > 2, "{count} pieces");
        }
    }
}

#[test]
fn a_stack_without_an_end_is_planned_with_bounded_memory() {
    let ramps = Settings::default().ramps;
    let mut planner = ShopBotPlanner::new(&ramps);
    let (mut pushed, mut taken) = (0, 0);
    for made in moves(200_000, 9) {
        planner.push(made);
        pushed += 1;
        taken += planner.take().map_or(0, |plan| plan.moves().len());
        assert!(pushed - taken <= 10_000, "{pushed} pushed, {taken} taken");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 16, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_plan_does_not_depend_on_how_the_input_was_chunked(
        seed in any::<u64>(), at_once in 1usize..5000, min_distance_mm in 0.0..20.0f64
    ) {
        let ramps = Ramps { min_distance_mm, ..Settings::default().ramps };
        check(&moves(20_000, seed), &ramps, at_once);
    }
}

/// The same for the `optimal` model, whose pieces end in the middle of corners: to the last digits
/// but a few, since a piece tells its times from another node.
fn check_optimal(moves: &[Move], dynamics: &Dynamics, at_once: usize) -> usize {
    let whole = Optimal { dynamics }.plan(moves.to_vec());
    let pieces = pieces(&mut OptimalPlanner::new(dynamics), moves, at_once);
    let (mut index, mut begun_s) = (0, 0.0);
    for piece in &pieces {
        for (k, made) in piece.moves().iter().enumerate() {
            assert_eq!(*made, whole.moves()[index + k]);
        }
        let end_s = piece.duration_s();
        for k in 0..=2000 {
            let t_s = begun_s + (end_s - begun_s) * f64::from(k) / 2000.0;
            let (found, expected) = (piece.at(t_s), whole.at(t_s));
            for axis in 0..AXES {
                let off = |f: Axes, e: Axes| (f.0[axis] - e.0[axis]).abs();
                assert!(off(found.position, expected.position) < 1e-8, "{at_once} at {t_s}");
                let first = k > 0 && k < 2000;
                assert!(
                    !first || off(found.velocity, expected.velocity) < 1e-5,
                    "{at_once} at {t_s}"
                );
            }
        }
        index += piece.moves().len();
        let expected_s = whole.span_s(index - 1).1;
        assert!((end_s - expected_s).abs() < 1e-9 * end_s.max(1.0), "{end_s} {expected_s}");
        begun_s = end_s;
    }
    assert_eq!(index, moves.len());
    pieces.len()
}

#[test]
fn pieces_of_the_fastest_motion_make_the_plan_of_the_whole_stack() {
    let dynamics = Dynamics {
        speed_mm_s: Axes::splat(150.0),
        accel_mm_s2: Axes::splat(700.0),
        jerk_mm_s3: None,
        tolerance_mm: 0.02,
    };
    for (seed, tolerance_mm) in [(1, 0.02), (2, 0.3), (3, 0.0)] {
        let moves = moves(12_000, seed);
        for at_once in [0, 1, 1000, 7777] {
            let count = check_optimal(&moves, &Dynamics { tolerance_mm, ..dynamics }, at_once);
            assert!(at_once % 1000 > 1 || (at_once == 0 && count == 1) || count > 4, "{count}");
        }
    }
}

#[test]
fn with_a_limit_of_jerk_pieces_end_where_the_machine_stands() {
    let dynamics = Dynamics {
        speed_mm_s: Axes::splat(150.0),
        accel_mm_s2: Axes::splat(700.0),
        jerk_mm_s3: Some(Axes::splat(20_000.0)),
        tolerance_mm: 0.0,
    };
    let moves = moves(600, 4);
    assert!(check_optimal(&moves, &dynamics, 1) > 5);
    assert_eq!(check_optimal(&moves, &dynamics, 0), 1);
}

/// A raster of half-millimetre moves over a hilly surface: nowhere a stand.
fn raster(count: u32) -> impl Iterator<Item = Move> {
    let settings = Settings::default();
    let mut mover = Mover::new(Axes::default(), &settings);
    (1..=count).filter_map(move |k| {
        let (row, place) = (k / 400, k % 400);
        let along = f64::from(if row % 2 == 0 { place } else { 400 - place });
        let (x, y) = (along * 0.5, f64::from(row) + (along * 0.05).sin());
        let to = Axes::xyz(x, y, 3.0 * (x * 0.1).sin() * (y * 0.07).cos());
        mover.line(At::default(), &Line { kind: MoveKind::Cut, to, feed: Feed::Path(60.0) })
    })
}

#[test]
fn with_a_limit_of_jerk_a_path_without_a_stand_is_planned_in_pieces() {
    let dynamics = Dynamics {
        speed_mm_s: Axes::splat(150.0),
        accel_mm_s2: Axes::splat(700.0),
        jerk_mm_s3: Some(Axes::splat(20_000.0)),
        tolerance_mm: 0.02,
    };
    let moves: Vec<Move> = raster(1500).collect();
    assert!(check_optimal(&moves, &dynamics, 1) > 10);
    assert!(check_optimal(&moves, &dynamics, 100) > 10);
    let mut planner = OptimalPlanner::new(&dynamics);
    let (mut pushed, mut taken, mut end_s) = (0, 0, 0.0);
    for made in raster(6000) {
        planner.push(made);
        pushed += 1;
        if let Some(piece) = planner.take() {
            taken += piece.moves().len();
            let takes_s = piece.duration_s() - end_s;
            assert!(takes_s < 3.0, "a piece of {takes_s} s");
            end_s = piece.duration_s();
            let state = piece.at(end_s - 1e-9);
            assert!(state.path_speed_mm_s > 1.0, "stands at {:?}", state.position);
        }
        assert!(pushed - taken <= 400, "{pushed} pushed, {taken} taken");
    }
}
