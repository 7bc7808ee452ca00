//! Plans of the `optimal` model that are left on the way: stops, holds and overrides of the feed.

use kerf_motion::{Model, Move, Mover, Optimal, OptimalPlanner, Plan, Planner, Replanner, Retimed};
use kerf_program::{At, Axes, Dynamics, Feed, Line, MoveKind, Settings};
use proptest::prelude::*;

const STEP_S: f64 = 1e-3;

/// A hold stands after so long, seconds.
const LATEST_S: f64 = 1.0;

fn dynamics(jerk: Option<f64>) -> Dynamics {
    Dynamics {
        speed_mm_s: Axes::splat(200.0),
        accel_mm_s2: Axes::splat(500.0),
        jerk_mm_s3: jerk.map(Axes::splat),
        tolerance_mm: 0.02,
    }
}

/// A wavy path with a corner now and then, at 100 mm/s.
fn path(seed: u64, count: usize) -> Vec<Move> {
    let mut seed = seed;
    let mut random = move || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (seed >> 40) as f64 / (1u64 << 24) as f64
    };
    let mut settings = Settings::default();
    settings.speeds.cut.xy = 100.0;
    settings.speeds.cut.z = 100.0;
    let mut mover = Mover::new(Axes::default(), &settings);
    let mut heading = 0.0f64;
    let mut moves = Vec::new();
    while moves.len() < count {
        heading += if random() < 0.05 { 2.0 } else { 0.3 } * (random() - 0.5);
        let way = if random() < 0.2 { 20.0 } else { 1.0 } * (0.2 + random());
        let dz = 0.3 * (random() - 0.5);
        let to = mover.position().plus(Axes::xyz(way * heading.cos(), way * heading.sin(), dz));
        let line = Line { kind: MoveKind::Cut, to, feed: Feed::Axis };
        moves.extend(mover.line(At::default(), &line));
    }
    moves
}

#[derive(Clone, Copy, Debug)]
enum Turn {
    Hold,
    Feed(f32),
}

/// A piece of plan that was run, and from when on it slowed for a hold.
struct Piece {
    plan: Plan,
    holds_s: Option<f64>,
}

/// Runs a stack through moments, each told since the last one.
fn run(moves: &[Move], dynamics: &Dynamics, turns: &[(f64, Turn)]) -> Vec<Piece> {
    let mut planner = Retimed::new(OptimalPlanner::new(dynamics));
    moves.iter().for_each(|m| planner.push(*m));
    let (mut pieces, mut done_s, mut turns) = (Vec::new(), 0.0, turns.iter().peekable());
    while let Some(piece) = planner.take().or_else(|| planner.finish()) {
        let (begin_s, end_s) = (piece.span_s(0).0, piece.duration_s());
        let Some((t_s, turn)) = turns.next_if(|(t_s, _)| done_s + t_s < end_s) else {
            pieces.push(Piece { plan: piece, holds_s: None });
            continue;
        };
        let at_s = begin_s.max(done_s + t_s);
        let (made, stop) = match turn {
            Turn::Hold => planner.stop(piece, at_s, true),
            Turn::Feed(share) => planner.feed(piece, at_s, *share),
        }
        .unwrap();
        assert!(stop.begin_s >= at_s - 1e-9 && stop.end_s >= stop.begin_s, "{stop:?}");
        // Whoever asks for a hold gets it: whatever the plan is about, it takes not much longer than
        // axes at 100 mm/s need.
        let waited_s = stop.end_s - at_s;
        assert!(matches!(turn, Turn::Feed(_)) || waited_s < LATEST_S, "stood after {waited_s} s");
        let holds_s = matches!(turn, Turn::Hold).then_some(at_s);
        pieces.push(Piece { plan: made, holds_s });
        done_s = 0.0;
    }
    pieces
}

/// Samples of position, velocity and acceleration, a step apart, over all pieces, and whether the
/// machine slows for a hold then.
fn samples(pieces: &[Piece]) -> Vec<([Axes; 3], bool)> {
    let mut all = Vec::new();
    for Piece { plan, holds_s } in pieces {
        let (from, to) = (plan.span_s(0).0, plan.duration_s());
        let steps = ((to - from) / STEP_S).floor() as usize;
        for t_s in (0..=steps).map(|k| from + k as f64 * STEP_S) {
            let state = plan.at(t_s);
            let holds = holds_s.is_some_and(|holds_s| t_s > holds_s - STEP_S);
            all.push(([state.position, state.velocity, state.acceleration], holds));
        }
    }
    all
}

fn most(axes: Axes) -> f64 {
    axes.0.iter().fold(0.0, |most, v| v.abs().max(most))
}

fn check(moves: &[Move], jerk: Option<f64>, turns: &[(f64, Turn)]) {
    check_with(moves, &dynamics(jerk), turns);
}

fn check_with(moves: &[Move], dynamics: &Dynamics, turns: &[(f64, Turn)]) {
    let pieces = run(moves, dynamics, turns);
    let all = samples(&pieces);
    let (speed, accel) = (dynamics.speed_mm_s, dynamics.accel_mm_s2);
    let free = Axes::splat(f64::INFINITY);
    let jerk = dynamics.jerk_mm_s3.unwrap_or(free);
    let keeps = |values: Axes, limits: Axes, slack: f64, more: f64| {
        values.0.iter().zip(limits.0).all(|(value, limit)| value.abs() <= limit * slack + more)
    };
    for (i, ([_, velocity, acceleration], _)) in all.iter().enumerate() {
        assert!(keeps(*velocity, speed, 1.001, 0.0), "{velocity:?} at {i}");
        assert!(keeps(*acceleration, accel, 1.02, 0.0), "{acceleration:?} at {i} of {turns:?}");
    }
    for (i, both) in all.windows(2).enumerate() {
        let ((before, holds), (after, _)) = (both[0], both[1]);
        let change = |what: usize| after[what].minus(before[what]);
        let way = change(0);
        assert!(keeps(way, speed, STEP_S * 1.01, 1e-6), "a jump of {way:?} mm at {i} of {turns:?}");
        let gain = change(1);
        assert!(
            keeps(gain, accel, STEP_S * 1.05, 1e-3),
            "a jump of {gain:?} mm/s at {i} of {turns:?}"
        );
        // A hold that would have to wait for the limit of jerk brakes at once.
        let jerk = if holds { free } else { jerk };
        let push = change(2);
        assert!(
            keeps(push, jerk, STEP_S * 1.05, 0.5),
            "a jump of {push:?} mm/s² at {i} of {turns:?}"
        );
    }
    let end = all.last().unwrap().0[0].minus(moves.last().unwrap().to);
    assert!(most(end) < 0.2, "{end:?}");
    let (way, made): (f64, f64) = (
        moves.iter().map(|m| m.length_mm).sum(),
        pieces.iter().flat_map(|piece| piece.plan.moves()).map(|m| m.length_mm).sum(),
    );
    assert!((way - made).abs() < 1e-6 * way, "{made} of {way} mm");
}

/// Limits that differ from axis to axis.
fn limits(jerks: std::ops::Range<f64>) -> impl Strategy<Value = Dynamics> {
    let each = |range: std::ops::Range<f64>| {
        prop::array::uniform3(range).prop_map(|[x, y, z]| Axes::xyz(x, y, z))
    };
    let tolerance = prop::sample::select(vec![0.005, 0.02, 0.1]);
    (each(40.0..300.0), each(300.0..1500.0), each(jerks), tolerance).prop_map(
        |(speed_mm_s, accel_mm_s2, jerk, tolerance_mm)| {
            let others = |mut all: Axes| {
                (3..all.0.len()).for_each(|k| all.0[k] = all.0[0]);
                all
            };
            Dynamics {
                speed_mm_s: others(speed_mm_s),
                accel_mm_s2: others(accel_mm_s2),
                jerk_mm_s3: Some(others(jerk)),
                tolerance_mm,
            }
        },
    )
}

fn turns() -> impl Strategy<Value = Vec<(f64, Turn)>> {
    let turn = prop_oneof![Just(Turn::Hold), (0.2f32..1.9).prop_map(Turn::Feed)];
    prop::collection::vec((0.0..3.0f64, turn), 1..4)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn without_a_limit_of_jerk_every_limit_holds_and_nothing_jumps(
        seed in any::<u64>(), turns in turns()
    ) {
        check(&path(seed, 150), None, &turns);
    }

    #[test]
    fn limits_that_differ_from_axis_to_axis_hold(
        seed in any::<u64>(), limits in limits(1.0..2.0), turns in turns()
    ) {
        check_with(&path(seed, 120), &Dynamics { jerk_mm_s3: None, ..limits }, &turns);
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 6, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn with_a_limit_of_jerk_as_well(seed in any::<u64>(), turns in turns()) {
        check(&path(seed, 60), Some(10_000.0), &turns);
    }

    #[test]
    fn limits_of_jerk_that_differ_from_axis_to_axis_hold(
        seed in any::<u64>(), limits in limits(4_000.0..30_000.0), turns in turns()
    ) {
        check_with(&path(seed, 60), &limits, &turns);
    }

    #[test]
    fn across_pieces_of_plan_with_jerk(seed in any::<u64>(), turns in turns()) {
        check(&path(seed, 300), Some(10_000.0), &turns);
    }

    #[test]
    fn across_pieces_of_plan(seed in any::<u64>(), turns in turns()) {
        check(&path(seed, 2500), None, &turns);
    }
}

#[test]
fn a_hold_takes_no_longer_than_the_axes_need() {
    let moves = path(1, 1).into_iter().map(|mut m| {
        (m.from, m.to, m.length_mm) = (Axes::default(), Axes::xyz(400.0, 0.0, 0.0), 400.0);
        m
    });
    let moves: Vec<Move> = moves.collect();
    let mut planner = Retimed::new(OptimalPlanner::new(&dynamics(None)));
    moves.iter().for_each(|m| planner.push(*m));
    let piece = planner.finish().unwrap();
    let (_, stop) = planner.stop(piece, 2.0, true).unwrap();
    assert!((stop.end_s - stop.begin_s - 0.2).abs() < 5e-3, "{stop:?}");
}

/// A hold cannot keep the limit of jerk where the plan slows as steeply as it can; nobody waits for it.
#[test]
fn a_hold_under_a_limit_of_jerk_comes_at_once_and_is_mostly_smooth() {
    let jerk = 10_000.0;
    let mut planner = Retimed::new(OptimalPlanner::new(&dynamics(Some(jerk))));
    path(7, 300).iter().for_each(|m| planner.push(*m));
    let (mut holds, mut smooth) = (0, 0);
    while let Some(piece) = planner.take().or_else(|| planner.finish()) {
        let mut t_s = piece.span_s(0).0;
        while t_s < piece.duration_s() {
            let (made, stop) = planner.clone().stop(piece.clone(), t_s, true).unwrap();
            assert!(stop.end_s - t_s < LATEST_S, "at {t_s} s: stood after {} s", stop.end_s - t_s);
            let slows = [Piece { plan: made, holds_s: Some(t_s) }];
            let push = |both: &[([Axes; 3], bool)]| most(both[1].0[2].minus(both[0].0[2]));
            let kept =
                samples(&slows).windows(2).all(|both| push(both) <= jerk * STEP_S * 1.05 + 0.5);
            (holds, smooth) = (holds + 1, smooth + usize::from(kept));
            t_s += 0.083;
        }
    }
    assert!(holds > 100 && smooth * 5 > holds * 3, "{smooth} of {holds} kept the limit");
}

#[test]
fn half_the_feed_takes_twice_the_time_and_more_feed_less() {
    let moves = path(3, 150);
    for jerk in [None, Some(20_000.0)] {
        let seconds = |turns: &[(f64, Turn)]| -> f64 {
            let pieces = run(&moves, &dynamics(jerk), turns);
            pieces.iter().map(|p| p.plan.duration_s() - p.plan.span_s(0).0).sum()
        };
        let plain = seconds(&[]);
        let [slow, same, fast] = [0.2, 1.0, 1.9].map(|share| seconds(&[(0.3, Turn::Feed(share))]));
        assert!(slow > 2.0 * plain && fast < plain, "{slow} {plain} {fast}");
        assert!((same - plain).abs() < 0.02 * plain, "{same} {plain}");
    }
}

#[test]
fn the_path_after_a_hold_is_the_path_without() {
    let moves = path(5, 150);
    let dynamics = dynamics(None);
    let plain = Optimal { dynamics: &dynamics }.plan(moves.clone());
    let line: Vec<Axes> = (0..=(plain.duration_s() * 2e4) as usize)
        .map(|k| plain.at(k as f64 / 2e4).position)
        .collect();
    let held = run(&moves, &dynamics, &[(0.7, Turn::Hold), (0.31, Turn::Hold), (0.5, Turn::Hold)]);
    let mut near = 0;
    for ([place, ..], _) in samples(&held) {
        let off = |k: usize| most(line[k].minus(place));
        // The nearest place lies behind the last one.
        while near + 1 < line.len() && off(near + 1) <= off(near) {
            near += 1;
        }
        assert!(off(near) < 0.006, "{place:?} is off by {}", off(near));
    }
}

#[test]
fn another_feed_just_before_a_stand_keeps_the_limits() {
    for seed in [4u64, 10] {
        let turns = [(2.47835, Turn::Hold), (1.38107, Turn::Feed(1.888)), (2.64457, Turn::Hold)];
        check(&path(seed * 7919 + 3, 60), Some(10_000.0), &turns);
    }
}

/// Overrides are answered in motion, also where the plan brakes as steeply as it can: there the new feed
/// waits for the next slow place, not the machine for a new plan.
#[test]
fn another_feed_under_a_limit_of_jerk_never_brings_the_machine_to_a_stand() {
    let moves = path(21, 80);
    let dynamics = dynamics(Some(10_000.0));
    let speeds = |turns: &[(f64, Turn)]| -> Vec<f64> {
        let all = samples(&run(&moves, &dynamics, turns));
        let v = |velocity: Axes| velocity.0.iter().map(|v| v * v).sum::<f64>().sqrt();
        all.into_iter().map(|([_, velocity, _], _)| v(velocity)).collect()
    };
    let within = |v: &[f64]| {
        let inner = &v[300..v.len() - 500];
        inner.iter().copied().fold(f64::INFINITY, f64::min)
    };
    let plain = speeds(&[]);
    let least = within(&plain);
    assert!(least > 1.0, "the path itself has no stand: {least}");
    for t_s in (1..plain.len() / 200).map(|k| k as f64 * 200.0 * STEP_S) {
        let v = speeds(&[(t_s, Turn::Feed(0.5))]);
        let slowest = within(&v);
        assert!(slowest > 0.4 * least, "{slowest} mm/s after an override at {t_s} s, not {least}");
        let later = v.get((t_s / STEP_S) as usize + 2000..).unwrap_or_default();
        let fastest = later.iter().copied().fold(0.0, f64::max);
        assert!(fastest <= 50.0 * 1.001, "{fastest} mm/s two seconds after an override at {t_s} s");
    }
}
