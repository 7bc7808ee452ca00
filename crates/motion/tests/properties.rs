//! Properties of any stack, whatever the moves, feeds and settings.

use kerf_motion::{Move, Mover, Plan, plan_stack};
use kerf_program::settings::MM_PER_INCH;
use kerf_program::{Arc, At, Axes, Axis, Feed, Line, MoveKind, Settings};
use proptest::prelude::*;

/// One command, relative to where the one before ended.
#[derive(Clone, Debug)]
enum Step {
    Line(Feed, MoveKind, [f64; 4]),
    Arc { radius: f64, from_rad: f64, sweep_rad: f64, dz: f64, small: bool },
    Speed(f64),
}

fn size() -> impl Strategy<Value = f64> {
    prop_oneof![Just(0.0), -0.5..0.5, -20.0..20.0, -1e-3..1e-3, -1e6..1e6]
}

fn step() -> impl Strategy<Value = Step> {
    let kind = prop_oneof![8 => Just(MoveKind::Cut), 1 => Just(MoveKind::Jog)];
    let feed = prop_oneof![
        6 => Just(Feed::Axis),
        2 => (1e-3..1e3).prop_map(Feed::Path),
        1 => (1e-3..10.0).prop_map(Feed::Time),
    ];
    let a = prop_oneof![3 => Just(0.0), 1 => size()];
    let to = (size(), size(), size(), a);
    prop_oneof![
        8 => (feed, kind, to).prop_map(|(f, k, to)| Step::Line(f, k, to.into())),
        3 => (1e-3..50.0, -9.0..9.0, -14.0..14.0, size(), any::<bool>()).prop_map(
            |(radius, from_rad, sweep_rad, dz, small)| Step::Arc {
                radius, from_rad, sweep_rad, dz, small
            }
        ),
        1 => (1.0..400.0).prop_map(Step::Speed),
    ]
}

fn steps() -> impl Strategy<Value = Vec<Step>> {
    prop::collection::vec(step(), 1..40)
}

fn make(steps: &[Step], settings: &mut Settings, idle: bool) -> Vec<Move> {
    let mut mover = Mover::new(Axes::default(), settings);
    let mut moves = Vec::new();
    for step in steps {
        let here = mover.position();
        match *step {
            Step::Speed(v) => {
                settings.speeds.cut.xy = v;
                mover.settings(settings);
            }
            Step::Line(feed, kind, [x, y, z, a]) => {
                let to = here.plus(Axes([x, y, z, a, 0.0, 0.0]));
                moves.extend(mover.line(At::default(), &Line { kind, to, feed }));
            }
            Step::Arc { radius, from_rad, sweep_rad, dz, small } => {
                let centre =
                    [here.0[0] - radius * from_rad.cos(), here.0[1] - radius * from_rad.sin()];
                let mut to = here;
                to.0[0] = centre[0] + radius * (from_rad + sweep_rad).cos();
                to.0[1] = centre[1] + radius * (from_rad + sweep_rad).sin();
                to.0[2] += dz;
                let arc = Arc {
                    kind: MoveKind::Cut,
                    centre,
                    sweep_rad,
                    to,
                    feed: Feed::Axis,
                    chords: 9,
                    small,
                };
                moves.extend(mover.arc(At::default(), &arc));
            }
        }
        if idle {
            let line = Line { kind: MoveKind::Jog, to: mover.position(), feed: Feed::Axis };
            moves.extend(mover.line(At::default(), &line));
        }
    }
    moves
}

fn plan(steps: &[Step]) -> Plan {
    let mut settings = Settings::default();
    let moves = make(steps, &mut settings, false);
    plan_stack(moves, &settings.ramps)
}

/// Not more, but for rounding.
fn at_most(a: f64, b: f64) -> bool {
    a <= b + 1e-9 * b.abs() + 1e-9
}

/// Angles are kept to seven digits.
fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-6 * a
}

fn distance(a: Axes, b: Axes) -> f64 {
    a.minus(b).0.iter().map(|d| d * d).sum::<f64>().sqrt()
}

/// The total way along the reference lengths.
fn way(moves: &[Move]) -> f64 {
    moves.iter().map(|m| m.length_mm).sum()
}

/// A random walk in XY with lines only, which can be cut up and turned round.
fn walk() -> impl Strategy<Value = Vec<(f64, f64, f64)>> {
    let way = prop_oneof![3 => -0.5..0.5f64, 1 => -20.0..20.0f64];
    prop::collection::vec((way.clone(), way, -0.1..0.1f64), 1..40)
}

/// The walk with each line cut into so many parts.
fn walk_in_parts(walk: &[(f64, f64, f64)], parts: u32) -> Vec<Axes> {
    let mut here = Axes::default();
    let mut places = vec![here];
    for (dx, dy, dz) in walk {
        for k in 1..=parts {
            let s = f64::from(k) / f64::from(parts);
            places.push(here.plus(Axes::xyz(dx * s, dy * s, dz * s)));
        }
        here = here.plus(Axes::xyz(*dx, *dy, *dz));
    }
    places
}

fn time_through(places: &[Axes]) -> f64 {
    let mut settings = Settings::default();
    settings.speeds.cut.xy = 4.0 * MM_PER_INCH;
    let mut mover = Mover::new(places[0], &settings);
    let line = |to: &Axes| Line { kind: MoveKind::Cut, to: *to, feed: Feed::Axis };
    let moves = places.iter().filter_map(|to| mover.line(At::default(), &line(to))).collect();
    plan_stack(moves, &settings.ramps).duration_s()
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn no_move_is_faster_than_asked_or_steeper_than_its_ramp(steps in steps()) {
        for s in plan(&steps).iter() {
            prop_assert!(at_most(s.v_peak, s.made.speed_mm_s), "{s:?}");
            prop_assert!(s.v_entry <= s.v_peak && s.v_exit <= s.v_peak);
            let rise = s.v_peak.powi(2) - s.v_entry.powi(2);
            let fall = s.v_peak.powi(2) - s.v_exit.powi(2);
            let needed = (rise + fall) / (2.0 * s.made.accel_mm_s2);
            prop_assert!(at_most(needed, s.made.length_mm * (1.0 + 1e-6)), "{s:?}");
            let least_s = s.made.length_mm / s.made.speed_mm_s;
            prop_assert!(at_most(least_s, (s.t1_s - s.t0_s) * (1.0 + 1e-9)));
        }
    }

    #[test]
    fn speed_is_continuous_or_ramp_speed_on_both_sides(steps in steps()) {
        let plan = plan(&steps);
        let spans: Vec<_> = plan.iter().collect();
        let rests = |v: f64, m: &Move| at_most(v, m.ramp_mm_s);
        if let (Some(first), Some(last)) = (spans.first(), spans.last()) {
            prop_assert!(rests(first.v_entry, first.made) && rests(last.v_exit, last.made));
        }
        for pair in spans.windows(2) {
            let (a, b) = (&pair[0], &pair[1]);
            let stands = rests(a.v_exit, a.made) && rests(b.v_entry, b.made);
            let cuts = a.made.kind == MoveKind::Cut && b.made.kind == MoveKind::Cut;
            prop_assert!(stands || (cuts && a.v_exit == b.v_entry), "{a:?} {b:?}");
        }
    }

    #[test]
    fn positions_join_and_follow_from_speed(steps in steps(), at in 0.0..1.0f64) {
        let plan = plan(&steps);
        for s in plan.iter() {
            let end = plan.at(s.t1_s).position;
            prop_assert!(distance(end, s.made.to) <= 1e-6 * (1.0 + s.made.length_mm));
        }
        let (t, dt) = (at * plan.duration_s(), 1e-6 * plan.duration_s());
        let (a, b) = (plan.at(t), plan.at(t + dt));
        if !plan.moves().is_empty() && a.move_index == b.move_index {
            // Constant acceleration in between, or the peak: the mean speed is between the two.
            let made = &plan.moves()[a.move_index];
            let went = (b.share - a.share) * made.length_mm;
            let mean = 0.5 * (a.path_speed_mm_s + b.path_speed_mm_s) * dt;
            let slack = made.accel_mm_s2 * dt * dt + 1e-9 * made.length_mm;
            prop_assert!((went - mean).abs() <= slack || b.path_speed_mm_s == 0.0);
        }
    }

    #[test]
    fn time_and_share_are_inverse(steps in steps(), at in 0.0..1.0f64) {
        let plan = plan(&steps);
        let t = at * plan.duration_s();
        let state = plan.at(t);
        let back = plan.time_at_share(state.move_index, state.share);
        prop_assert!((back - t).abs() <= 1e-6 * (1.0 + plan.duration_s()), "{t} {back}");
    }

    #[test]
    fn moves_to_where_the_tool_stands_change_nothing(steps in steps()) {
        let (mut a, mut b) = (Settings::default(), Settings::default());
        let plain = plan_stack(make(&steps, &mut a, false), &a.ramps);
        prop_assert_eq!(plain, plan_stack(make(&steps, &mut b, true), &b.ramps));
    }

    #[test]
    fn a_line_cut_into_parts_takes_the_same_time(walk in walk(), parts in 2u32..5) {
        let whole = time_through(&walk_in_parts(&walk, 1));
        let cut = time_through(&walk_in_parts(&walk, parts));
        prop_assert!(close(whole, cut), "{whole} {cut}");
    }

    #[test]
    fn the_way_back_and_the_mirror_image_take_the_same_time(walk in walk()) {
        let there = walk_in_parts(&walk, 1);
        let mut back = there.clone();
        back.reverse();
        let mut mirrored = there.clone();
        mirrored.iter_mut().for_each(|p| p[Axis::X] = -p[Axis::X]);
        let time = time_through(&there);
        for other in [time_through(&back), time_through(&mirrored)] {
            prop_assert!(close(time, other), "{time} {other}");
        }
    }

    #[test]
    fn a_stop_ends_on_the_path_and_leaves_the_rest(
        steps in steps(), at in -0.1..1.1f64, ramped in any::<bool>()
    ) {
        let plan = plan(&steps);
        let t = at * plan.duration_s();
        let Some(stop) = plan.stop(t, ramped) else {
            prop_assert!(plan.moves().is_empty());
            return Ok(());
        };
        prop_assert!(stop.begin_s <= stop.end_s);
        prop_assert!(ramped || stop.begin_s == stop.end_s);
        let all = way(plan.moves());
        let before = plan.at(t);
        let (done, rest) = plan.clone().cut(&stop);
        prop_assert!((way(done.moves()) + way(&rest) - all).abs() <= 1e-9 * all);
        prop_assert!((done.duration_s() - stop.end_s).abs() <= 1e-9 * (1.0 + stop.end_s));
        if let Some(first) = rest.first() {
            prop_assert!(distance(first.from, stop.position) <= 1e-9 * (1.0 + all));
        }
        if let Some(last) = done.moves().last() {
            prop_assert!(distance(last.to, stop.position) <= 1e-9 * (1.0 + all));
            let same = done.at(t.min(stop.begin_s)).position;
            prop_assert!(distance(same, before.position) <= 1e-6 * (1.0 + all));
            // The profile that was cut still covers its way in its time.
            let index = done.moves().len() - 1;
            let took = done.time_at_share(index, 1.0);
            prop_assert!((took - stop.end_s).abs() <= 1e-6 * (1.0 + stop.end_s), "{took} {stop:?}");
        }
    }
}

#[test]
fn numbers_beyond_reason_are_refused_and_nothing_hangs() {
    let settings = Settings::default();
    let mut mover = Mover::new(Axes::default(), &settings);
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300, -1e13] {
        for axis in Axis::ALL {
            let mut to = Axes::splat(1.0);
            to[axis] = bad;
            let line = Line { kind: MoveKind::Cut, to, feed: Feed::Axis };
            assert!(mover.line(At::default(), &line).is_none(), "{bad} {axis:?}");
        }
        for (centre, sweep_rad) in [([bad, 0.0], 1.0), ([1.0, 0.0], bad)] {
            let to = Axes::splat(1.0);
            let (kind, feed, chords) = (MoveKind::Cut, Feed::Axis, 1);
            let arc = Arc { kind, centre, sweep_rad, to, feed, chords, small: false };
            assert!(mover.arc(At::default(), &arc).is_none(), "{bad}");
        }
    }
    assert_eq!(mover.position(), Axes::default());
}

#[test]
fn settings_and_feeds_without_sense_still_give_a_finite_plan() {
    for bad in [f64::NAN, 0.0, -1.0, f64::INFINITY, 1e300] {
        let mut settings = Settings::default();
        settings.speeds.cut.xy = bad;
        settings.ramps.cut.xy = bad;
        settings.ramps.cut_rate_mm = bad;
        settings.ramps.min_distance_mm = bad;
        settings.ramps.slow_corner_percent = bad;
        settings.ramps.threshold_3d_percent = bad;
        let mut mover = Mover::new(Axes::default(), &settings);
        let mut moves = Vec::new();
        for (k, feed) in
            [Feed::Axis, Feed::Path(bad), Feed::Time(bad), Feed::Axis].iter().enumerate()
        {
            let to = Axes::xyz(1.0 + k as f64, (k * k) as f64, 0.1 * k as f64);
            moves.extend(mover.line(At::default(), &Line { kind: MoveKind::Cut, to, feed: *feed }));
        }
        let plan = plan_stack(moves, &settings.ramps);
        assert_eq!(plan.moves().len(), 4);
        assert!(plan.duration_s().is_finite() && plan.duration_s() > 0.0, "{bad} {plan:?}");
        let middle = plan.at(plan.duration_s() / 2.0).position;
        assert!(middle.0.iter().all(|v| v.is_finite()), "{bad}");
        assert!(plan.stop(plan.duration_s() / 3.0, true).is_some());
    }
}

#[test]
fn an_empty_plan_takes_no_time() {
    let plan = plan_stack(Vec::new(), &Settings::default().ramps);
    assert_eq!((plan.duration_s(), plan.index_at(1.0), plan.span_s(3)), (0.0, None, (0.0, 0.0)));
    assert!(plan.stop(0.0, true).is_none());
}
