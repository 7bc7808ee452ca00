//! Step times: never more than half a step from where the axis should be.

use kerf_motion::{Model, Move, Mover, Optimal, Plan, Profiler, Step, Stepper, plan_stack};
use kerf_program::{AXES, Arc, At, Axes, Feed, Line, MoveKind, RampModel, Settings};
use proptest::prelude::*;

/// Steps for a millimetre or a degree; two motors turn the other way.
const PER_UNIT: Axes = Axes([40.0, -40.0, 100.0, 25.0, 13.9, -11.1]);

/// A line, or an arc with the other axes along.
#[derive(Clone, Copy, Debug)]
enum Made {
    Line([f64; AXES]),
    Arc(f64, f64, [f64; AXES]),
}

fn made() -> impl Strategy<Value = Made> {
    let way = || prop::array::uniform6(-4.0..4.0f64);
    prop_oneof![
        way().prop_map(Made::Line),
        (0.05..5.0f64, -7.0..7.0f64, way()).prop_map(|(r, sweep, way)| Made::Arc(r, sweep, way)),
    ]
}

fn moves(all: &[Made]) -> Vec<Move> {
    let mut mover = Mover::new(Axes::default(), &Settings::default());
    let mut moves = Vec::new();
    for made in all {
        let from = mover.position();
        moves.extend(match *made {
            Made::Line(way) => {
                let line = Line { kind: MoveKind::Cut, to: from.plus(Axes(way)), feed: Feed::Axis };
                mover.line(At::default(), &line)
            }
            Made::Arc(radius, sweep_rad, way) => {
                let centre = [from.0[0] - radius, from.0[1]];
                let (sin, cos) = sweep_rad.sin_cos();
                let mut to = from.plus(Axes(way));
                (to.0[0], to.0[1]) = (centre[0] + radius * cos, centre[1] + radius * sin);
                let (kind, feed, chords, small) = (MoveKind::Cut, Feed::Axis, 8, false);
                mover.arc(At::default(), &Arc { kind, centre, sweep_rad, to, feed, chords, small })
            }
        });
    }
    moves
}

fn plan(moves: Vec<Move>, model: RampModel) -> Plan {
    let settings = Settings::default();
    let dynamics = &settings.axis_dynamics();
    match model {
        RampModel::Shopbot => plan_stack(moves, &settings.ramps),
        RampModel::Profiler => Profiler { dynamics, smoothing: &settings.smoothing }.plan(moves),
        RampModel::Optimal => Optimal { dynamics }.plan(moves),
    }
}

/// Follows a motion and asserts that no motor is ever more than half a step off.
#[track_caller]
fn check(end_s: f64, place: impl Fn(f64) -> Axes) -> Vec<Step> {
    let mut stepper = Stepper::new(PER_UNIT, place(0.0));
    let mut counts = stepper.made();
    let steps = stepper.follow(0.0, end_s, &place);
    let mut next = steps.iter().peekable();
    // At odd times between the slices, and just before and after each step.
    for k in 0..4000 {
        let t_s = end_s * (f64::from(k) + 0.37) / 4000.0;
        while let Some(step) = next.next_if(|step| step.t_s <= t_s) {
            counts[step.axis] += if step.forward { 1 } else { -1 };
        }
        let wanted = place(t_s).zip(PER_UNIT, |p, n| p * n).0;
        for (axis, (made, wanted)) in counts.iter().zip(wanted).enumerate() {
            let off = (*made as f64 - wanted).abs();
            assert!(off <= 0.5 + 1e-4, "axis {axis} is {off} steps off at {t_s}");
        }
    }
    assert!(steps.windows(2).all(|pair| pair[0].t_s <= pair[1].t_s));
    each_is_where_its_half_is_passed(&steps, Stepper::new(PER_UNIT, place(0.0)).made(), &place);
    let last = place(end_s).zip(PER_UNIT, |p, n| (p * n).round()).0.map(|n| n as i64);
    let off = stepper.made().into_iter().zip(last).map(|(a, b)| (a - b).abs()).max();
    assert!(off <= Some(1), "{:?} {last:?}", stepper.made());
    steps
}

/// Asserts that no step is more than 2 ns of its motor's way from the half that it passes.
#[track_caller]
fn each_is_where_its_half_is_passed(
    steps: &[Step],
    mut counts: [i64; AXES],
    place: impl Fn(f64) -> Axes,
) {
    for Step { t_s, axis, forward } in steps.iter().copied() {
        let sign = if forward { 1 } else { -1 };
        let half = counts[axis] as f64 + 0.5 * f64::from(sign);
        counts[axis] += i64::from(sign);
        let at = |t_s: f64| place(t_s).0[axis] * PER_UNIT.0[axis];
        let (off, way) = ((at(t_s) - half).abs(), (at(t_s + 2e-9) - at(t_s - 2e-9)).abs());
        assert!(off <= way + 2e-8, "axis {axis} is {off} steps from its half at {t_s}");
    }
}

#[test]
fn a_millimetre_makes_its_steps_at_even_times() {
    let steps = check(1.0, |t_s| Axes::xyz(t_s, 0.0, 0.0));
    assert_eq!(steps.len(), 40);
    for (k, step) in steps.iter().enumerate() {
        assert!((step.t_s - (k as f64 + 0.5) / 40.0).abs() < 2e-9 && step.forward);
    }
}

#[test]
fn an_axis_that_swings_beside_the_others_is_followed_round_its_turns() {
    // 40 Hz and a quarter of a step more than nothing; 10 mm across in between.
    for distance in [0.02, 0.4, 10.0] {
        let steps = check(0.5, |t_s| {
            let swing = 0.5 * distance * (std::f64::consts::TAU * 40.0 * t_s).sin();
            Axes([20.0 * t_s, -20.0 * t_s, swing, 0.0, 30.0 * t_s, 0.0])
        });
        let z = steps.iter().filter(|s| s.axis == 2).count();
        // So many each way, 20 times to and fro.
        let expected = 20.0 * 4.0 * (0.5 * distance * 100.0 + 0.5).floor();
        assert!((z as f64 - expected).abs() <= 4.0, "{z} is not {expected}");
    }
}

/// An axis that stands at a half makes no step there, whatever rounding makes of its place.
#[test]
fn an_axis_that_stands_between_two_steps_makes_none() {
    let half = 511.5 / PER_UNIT.0[0];
    for from in [half - 1e-4, half + 1e-4] {
        let mut stepper = Stepper::new(PER_UNIT, Axes::xyz(from, 0.0, 0.0));
        let made = stepper.made();
        let noise = |t_s: f64| 1e-13 * (1e4 * t_s).sin();
        let stands = |t_s: f64| Axes::xyz(half + noise(t_s), 0.0, 5.0 * t_s);
        let steps = stepper.follow(0.0, 1.0, stands);
        assert!(steps.iter().all(|step| step.axis == 2), "{from}");
        stepper.sketch(0.0, 1.0, |t_s| Axes::xyz(half + noise(t_s), 0.0, 5.0 - 5.0 * t_s));
        assert_eq!(stepper.made()[0], made[0], "{from}");
    }
}

#[test]
fn nothing_adds_up_over_many_short_moves() {
    let ways = vec![Made::Line([0.003, -0.0017, 0.0, 0.0, 0.0, 0.0]); 1000];
    let plan = plan(moves(&ways), RampModel::Profiler);
    let mut stepper = Stepper::new(PER_UNIT, Axes::default());
    let mut steps = Vec::new();
    // Move by move, as it is made.
    for span in plan.iter() {
        steps.extend(stepper.follow(span.t0_s, span.t1_s, |t_s| plan.at(t_s).position));
    }
    assert_eq!(stepper.made()[..2], [120, 68]);
    assert_eq!(steps.len(), 188);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn no_motor_is_ever_more_than_half_a_step_off(
        all in prop::collection::vec(made(), 1..6),
        model in prop_oneof![
            Just(RampModel::Shopbot), Just(RampModel::Profiler), Just(RampModel::Optimal)
        ],
    ) {
        let plan = plan(moves(&all), model);
        check(plan.duration_s(), |t_s| plan.at(t_s).position);
    }
}

#[test]
fn an_axis_that_is_found_to_be_elsewhere_is_counted_anew_without_a_step() {
    let mut stepper = Stepper::new(PER_UNIT, Axes::default());
    let place = |x: f64| Axes::xyz(x, 0.0, 0.0);
    assert_eq!(stepper.follow(0.0, 1.0, |t_s| place(10.0 * t_s)).len(), 400);
    assert_eq!(stepper.stands(place(10.0 + 0.4 / 40.0)), Vec::<usize>::new(), "rounding");
    assert_eq!((stepper.stands(place(0.0)), stepper.made()[0]), (vec![0], 0));
    assert_eq!(stepper.follow(1.0, 2.0, |t_s| place(t_s - 1.0)).len(), 40);
}
