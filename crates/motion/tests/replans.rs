//! Plans that are left on the way: stops, holds and overrides of the feed at random moments.

use crate::walk::moves;
use kerf_motion::{Move, Plan, Planner, Replanner, ShopBotPlanner, Span, plan_stack, planner};
use kerf_program::{Axes, Dynamics, MoveKind, Settings};
use proptest::prelude::*;
use std::iter;

/// Act of the operator at a time since the last such moment, seconds.
#[derive(Clone, Copy, Debug)]
enum Turn {
    Hold,
    Feed(f32),
}

/// Pieces of plan that were made; each with true if the machine stands at its end.
struct Made {
    pieces: Vec<(Plan, bool)>,
}

/// Runs a stack through the moments.
fn run(moves: &[Move], turns: &[(f64, Turn)]) -> Made {
    let mut planner = ShopBotPlanner::new(&Settings::default().ramps);
    moves.iter().for_each(|m| planner.push(*m));
    let (mut pieces, mut done_s, mut turns) = (Vec::new(), 0.0, turns.iter().peekable());
    while let Some(piece) = planner.take().or_else(|| planner.finish()) {
        let end_s = piece.duration_s();
        let Some((t_s, turn)) = turns.next_if(|(t_s, _)| done_s + t_s < end_s) else {
            pieces.push((piece, false));
            continue;
        };
        let at_s = piece.span_s(0).0.max(done_s + t_s);
        let before = piece.at(at_s);
        let (made, stop) = match turn {
            Turn::Hold => planner.stop(piece, at_s, true),
            Turn::Feed(share) => planner.feed(piece, at_s, *share),
        }
        .unwrap();
        // Until then everything is as it was planned.
        let same = made.at(stop.begin_s.min(at_s)).position.minus(before.position);
        assert!(same.0.iter().all(|d| d.abs() < 1e-6), "{same:?}");
        pieces.push((made, matches!(turn, Turn::Hold)));
        done_s = 0.0;
    }
    Made { pieces }
}

impl Made {
    fn spans(&self) -> impl Iterator<Item = Span<'_>> {
        self.pieces.iter().flat_map(|(plan, _)| plan.iter())
    }

    fn seconds(&self) -> f64 {
        self.spans().map(|s| s.t1_s - s.t0_s).sum()
    }
}

fn at_most(a: f64, b: f64) -> bool {
    a <= b * (1.0 + 1e-6) + 1e-6
}

/// The rules that hold whatever the operator does.
fn check(moves: &[Move], turns: &[(f64, Turn)]) {
    let made = run(moves, turns);
    let way = |m: &Move| m.length_mm;
    let (all, got): (f64, f64) =
        (moves.iter().map(way).sum(), made.spans().map(|s| way(s.made)).sum());
    assert!((all - got).abs() < 1e-6 * all, "{got} of {all} mm");
    assert_eq!(made.spans().last().unwrap().made.to, moves.last().unwrap().to);
    let spans: Vec<Span<'_>> = made.spans().collect();
    for s in &spans {
        let rise = s.v_peak.powi(2) - s.v_entry.powi(2);
        let fall = s.v_peak.powi(2) - s.v_exit.powi(2);
        let needed = (rise + fall) / (2.0 * s.made.accel_mm_s2);
        assert!(at_most(needed, s.made.length_mm), "{s:?}");
        assert!(at_most(s.v_peak, 2.0 * s.made.speed_mm_s), "{s:?}");
    }
    let stands: Vec<bool> = made
        .pieces
        .iter()
        .flat_map(|(plan, stands)| {
            let inside = plan.moves().len().saturating_sub(1);
            iter::repeat_n(false, inside).chain(iter::once(*stands).take(plan.moves().len()))
        })
        .collect();
    for (pair, stands) in spans.windows(2).zip(stands) {
        let (a, b) = (&pair[0], &pair[1]);
        let rests = |v: f64, m: &Move| at_most(v, m.ramp_mm_s.min(m.speed_mm_s * 2.0));
        let jog = a.made.kind == MoveKind::Jog || b.made.kind == MoveKind::Jog;
        let smooth = (a.v_exit - b.v_entry).abs() < 1e-6 && !stands;
        assert!(
            rests(a.v_exit, a.made) && rests(b.v_entry, b.made) || smooth && !jog,
            "{a:?} {b:?}"
        );
    }
}

/// A thousand moves, tiny ones first, smooth and rough.
fn program(seed: u64) -> Vec<Move> {
    moves(3000, seed).split_off(1900)
}

fn turns() -> impl Strategy<Value = Vec<(f64, Turn)>> {
    let turn = prop_oneof![Just(Turn::Hold), (0.1f32..2.0).prop_map(Turn::Feed)];
    prop::collection::vec((0.0..20.0f64, turn), 1..6)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn holds_and_overrides_keep_speed_continuous_and_ramps_in_their_limits(
        seed in any::<u64>(), turns in turns()
    ) {
        check(&program(seed), &turns);
    }

    #[test]
    fn a_feed_that_does_not_change_changes_nothing(seed in any::<u64>(), t_s in 0.0..60.0f64) {
        let moves = program(seed);
        let whole = plan_stack(moves.clone(), &Settings::default().ramps);
        let made = run(&moves, &[(t_s, Turn::Feed(1.0))]);
        let (a, b) = (whole.duration_s(), made.seconds());
        // An arc that is left on its way is two, each with its bend in its own middle: a tight curve may reach a move
        // less far, or farther.
        prop_assert!((a - b).abs() <= 1e-2 * a, "{a} {b}");
    }
}

#[test]
fn half_the_feed_takes_twice_the_time_on_a_long_line() {
    let line = &moves(1, 1)[..];
    let mut line = line[0];
    (line.to, line.from) = (line.to, line.to);
    line.from.0[0] -= 1000.0;
    line.length_mm = 1000.0;
    let v = line.speed_mm_s;
    let made = run(&[line], &[(5.0, Turn::Feed(0.5))]);
    let expected = 5.0 + (1000.0 - 5.0 * v) / (0.5 * v);
    assert!((made.seconds() - expected).abs() < 1.0, "{} {expected}", made.seconds());
    let faster = run(&[line], &[(5.0, Turn::Feed(2.0))]);
    assert!(faster.spans().last().unwrap().v_peak > 1.99 * v);
}

/// On a smoothed path a piece ends in motion: a stop near its end brakes into the next one.
#[test]
fn a_stop_of_the_fastest_motion_runs_on_beyond_its_piece() {
    let dynamics = Dynamics {
        speed_mm_s: Axes::splat(150.0),
        accel_mm_s2: Axes::splat(700.0),
        jerk_mm_s3: None,
        tolerance_mm: 0.05,
    };
    let settings = Settings { dynamics: Some(dynamics), ..Settings::default() };
    let moves = moves(4000, 5);
    for early_s in [0.0, 1e-3, 0.02, 0.5] {
        let mut planner = planner(&settings);
        moves.iter().for_each(|m| planner.push(*m));
        let piece = planner.take().unwrap();
        let t_s = piece.duration_s() - early_s;
        let before = piece.at(t_s - 1e-9);
        let (made, stop) = planner.stop(piece, t_s, true).unwrap();
        let after = made.at(t_s + 1e-9);
        let gap = |a: Axes, b: Axes| a.minus(b).0.into_iter().map(f64::abs).fold(0.0, f64::max);
        assert!(gap(before.position, after.position) < 1e-5);
        assert!(gap(before.velocity, after.velocity) < 1e-3, "{early_s}");
        let last = made.at(stop.end_s - 1e-6);
        assert!(gap(last.velocity, Axes::default()) < 1e-2, "{:?}", last.velocity);
        assert!(gap(last.position, stop.position) < 1e-6);
        let rest: Vec<Plan> = iter::from_fn(|| planner.finish()).collect();
        let (first, last) = (&rest[0], &rest[rest.len() - 1]);
        assert!(gap(first.at(0.0).position, stop.position) < 1e-9);
        assert!(gap(last.at(last.duration_s()).position, moves[moves.len() - 1].to) < 1e-9);
    }
}
