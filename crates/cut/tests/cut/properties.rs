//! Properties of every cut: shapes on their circles, turned and mirrored alike.

use crate::common::origin;
use kerf_cut::*;
use kerf_geom::{Point2, Vec2, clock_to_vec};
use proptest::prelude::*;
use std::f64::consts::TAU;

/// Millimetres; what sums and roots of sizes up to a metre may be off.
const NEAR_MM: f64 = 1e-6;

fn turn() -> impl Strategy<Value = Direction> {
    prop_oneof![Just(Direction::Clockwise), Just(Direction::Counter)]
}

fn side() -> impl Strategy<Value = Side> {
    prop_oneof![Just(Side::Out), Just(Side::In), Just(Side::True)]
}

fn proportion() -> impl Strategy<Value = f64> {
    prop_oneof![Just(1.0), Just(-1.0), 0.25..4.0, -4.0..-0.25]
}

prop_compose! {
    fn circles()(
        diameter_mm in 20.0..500.0,
        side in side(),
        turn in turn(),
        begin in -800.0..800.0,
        sweep in 1.0..359.0,
        x in proportion(),
        y in proportion(),
    ) -> Circle {
        Circle {
            side,
            turn,
            begin_deg: Some(begin),
            end_deg: Some(begin + turn.sign() * sweep),
            proportion: [x, y],
            ..Circle::new(diameter_mm)
        }
    }
}

fn xy(place: [f64; 3]) -> Point2 {
    Point2::new(place[0], place[1])
}

fn end(cut: &Cut) -> Point2 {
    xy(cut.steps.last().unwrap().to())
}

/// Every place where a step ends, and the middle of every arc.
fn places(from: [f64; 3], steps: &[Step]) -> Vec<Point2> {
    let mut at = xy(from);
    let mut found = Vec::new();
    for step in steps {
        if let Step::Arc { centre: [x, y], sweep_rad, .. } = *step {
            let centre = Point2::new(x, y);
            found.push(centre + (at - centre).rotated(sweep_rad / 2.0));
        }
        at = xy(step.to());
        found.push(at);
    }
    found
}

/// The point of a clock angle relative to the centre, worked out the long way.
fn arm(circle: &Circle, clock_deg: f64, cutter_mm: f64) -> Vec2 {
    let [a, b] = circle.proportion.map(|p| p * circle.diameter_mm / 2.0);
    let unit = clock_to_vec(clock_deg);
    let normal = Vec2::new(unit.x / a, unit.y / b);
    let offset = match circle.side {
        Side::Out => cutter_mm / 2.0,
        Side::In => -cutter_mm / 2.0,
        Side::True => 0.0,
    };
    unit.scaled(a, b) + normal * (offset / normal.length())
}

proptest! {
    #[test]
    fn a_path_keeps_to_its_curve_and_ends_where_the_formula_says(c in circles()) {
        let context = origin();
        let Ok(cut) = circle(&c, &context) else {
            prop_assert!(c.side == Side::In, "only the inside may lack room");
            return Ok(());
        };
        let (begin, last) = (c.begin_deg.unwrap(), c.end_deg.unwrap());
        let centre = Point2::default() - arm(&c, begin, context.cutter_mm);
        let want = centre + arm(&c, last, context.cutter_mm);
        prop_assert!(end(&cut).distance(want) < NEAR_MM);
        let n = cut.steps.len();
        let round = c.proportion[0].abs() == c.proportion[1].abs();
        prop_assert_eq!(matches!(cut.steps[0], Step::Arc { .. }), round);
        let sweep = (last - begin).abs();
        for (i, place) in places(context.start, &cut.steps).iter().enumerate().skip(1) {
            let share = if round { 1.0 } else { (i + 1) as f64 / n as f64 };
            let clock = begin + c.turn.sign() * sweep * share;
            let want = centre + arm(&c, clock, context.cutter_mm);
            prop_assert!(place.distance(want) < NEAR_MM, "{place:?} {want:?}");
        }
    }

    #[test]
    fn chords_are_no_longer_than_the_resolution(c in circles()) {
        let Ok(cut) = circle(&c, &origin()) else { return Ok(()) };
        let mut at = Point2::default();
        for step in &cut.steps {
            let to = xy(step.to());
            if matches!(step, Step::Line { .. }) {
                prop_assert!(at.distance(to) <= origin().circle_mm * (1.0 + 1e-9));
            }
            at = to;
        }
    }

    #[test]
    fn turning_the_angles_turns_the_path(c in circles(), by in -360.0..360.0) {
        let plain = Circle { proportion: [1.0, 1.0], ..c };
        let shift = |a: Option<f64>| a.map(|a| a + by);
        let turned = Circle {
            begin_deg: shift(plain.begin_deg),
            end_deg: shift(plain.end_deg),
            ..plain.clone()
        };
        let (one, other) = (circle(&plain, &origin()).unwrap(), circle(&turned, &origin()).unwrap());
        let (one, other) = (places([0.0; 3], &one.steps), places([0.0; 3], &other.steps));
        for (p, q) in one.iter().zip(&other) {
            let p = (*p - Point2::default()).rotated(-f64::to_radians(by));
            prop_assert!((Point2::default() + p).distance(*q) < NEAR_MM);
        }
    }

    #[test]
    fn the_mirror_image_goes_the_other_way_round(c in circles()) {
        let mirror = Circle { proportion: [-c.proportion[0], c.proportion[1]], ..c.clone() };
        let (Ok(one), Ok(other)) = (circle(&c, &origin()), circle(&mirror, &origin())) else {
            return Ok(());
        };
        let (here, there) = (places([0.0; 3], &one.steps), places([0.0; 3], &other.steps));
        for (p, q) in here.iter().zip(&there) {
            prop_assert!(p.distance(Point2::new(-q.x, q.y)) < NEAR_MM);
        }
        if let (Step::Arc { sweep_rad: s, .. }, Step::Arc { sweep_rad: t, .. }) =
            (one.steps[0], other.steps[0])
        {
            prop_assert!((s + t).abs() < 1e-12);
        }
        let heading = (one.heading_deg + other.heading_deg).rem_euclid(360.0);
        prop_assert!(heading.min(360.0 - heading) < 1e-6);
    }

    #[test]
    fn a_centred_circle_is_the_same_circle_carried_there(
        c in circles(), x in -500.0..500.0, y in -500.0..500.0
    ) {
        let Ok(cut) = point_circle([x, y], &c, &origin()) else { return Ok(()) };
        let context = Context { start: cut.steps[0].to(), ..origin() };
        let same = circle(&c, &context).unwrap();
        prop_assert!(end(&cut).distance(end(&same)) < NEAR_MM);
        prop_assert_eq!(cut.steps.len(), same.steps.len() + 1);
    }

    #[test]
    fn an_arch_spans_and_rises_as_it_says(
        length in 1.0..500.0, height in 1.0..500.0, align in -360.0..360.0, turn in turn()
    ) {
        let shape = Arch { turn, alignment_deg: align, ..Arch::new(length, height) };
        let cut = arch(&shape, &origin()).unwrap();
        let along = Vec2::new(length * turn.sign(), 0.0).rotated(-f64::to_radians(align));
        let rise = Vec2::new(0.0, height).rotated(-f64::to_radians(align));
        let start = Point2::default();
        let all = places([0.0; 3], &cut.steps);
        prop_assert!(all[0].distance(start + along * 0.5 + rise) < NEAR_MM);
        prop_assert!(all[1].distance(start + along) < NEAR_MM);
        let Step::Arc { sweep_rad, .. } = cut.steps[0] else { panic!("an arch is an arc") };
        prop_assert_eq!(sweep_rad < 0.0, turn == Direction::Clockwise);
    }

    #[test]
    fn an_arc_to_a_rounded_end_is_a_true_arc_or_closed(
        i in -100.0..100.0f64, j in -100.0..100.0f64, sweep in 0.01..6.27, turn in turn(),
        off_x in -0.1..0.1, off_y in -0.1..0.1
    ) {
        prop_assume!(i.hypot(j) > 1.0);
        let centre = Vec2::new(i, j);
        let true_end = centre + (-centre).rotated(-turn.sign() * sweep);
        let given = Point2::new(true_end.x + off_x, true_end.y + off_y);
        let ends = [Some(given.x), Some(given.y)];
        let shape = ArcTo { turn, ..ArcTo::new(ends, [Some(i), Some(j)]) };
        let (cut, _) = arc_to(&shape, None, &origin()).unwrap();
        prop_assert_eq!(end(&cut), given);
        let Step::Arc { centre: c, to, .. } = cut.steps[0] else { panic!("an arc") };
        let c = Point2::new(c[0], c[1]);
        prop_assert!((c.distance(Point2::default()) - c.distance(xy(to))).abs() < SAME);
        prop_assert!(cut.steps.len() == 1 || xy(to).distance(given) <= ARC_TOLERANCE_MM * 1.01);
        let middle = places([0.0; 3], &cut.steps)[0];
        let radius = centre.length();
        prop_assert!(((middle - Point2::default() - centre).length() - radius).abs() < 0.3);
    }

    #[test]
    fn a_diameter_gives_half_a_turn_at_most(
        x in -100.0..100.0f64, y in -100.0..100.0f64, larger in 1.0..20.0, turn in turn()
    ) {
        prop_assume!(x.hypot(y) > 0.1);
        let diameter = x.hypot(y) * larger;
        let shape = ArcTo {
            diameter_mm: Some(diameter),
            turn,
            ..ArcTo::new([Some(x), Some(y)], [None, None])
        };
        let (cut, _) = arc_to(&shape, None, &origin()).unwrap();
        let Step::Arc { centre, sweep_rad, .. } = cut.steps[0] else { panic!("an arc") };
        prop_assert!(sweep_rad.abs() < TAU / 2.0 + 1e-6);
        prop_assert!((centre[0].hypot(centre[1]) * 2.0 - diameter).abs() < NEAR_MM);
        prop_assert_eq!(sweep_rad < 0.0, turn == Direction::Clockwise);
    }

    #[test]
    fn a_rectangle_has_its_size_on_its_side(
        x in 10.0..500.0, y in 10.0..500.0, side in side(), turn in turn(), corner in 1u8..=4
    ) {
        let corner = Corner::from_number(corner).unwrap();
        let shape = Rectangle { side, turn, corner, ..Rectangle::new(x, y) };
        let cut = rectangle(&shape, &origin()).unwrap();
        let all = places([0.0; 3], &cut.steps);
        let grow = match side { Side::Out => 6.35, Side::In => -6.35, Side::True => 0.0 };
        let area: f64 = (0..4)
            .map(|i| (all[i] - Point2::default()).cross(all[(i + 1) % 4] - Point2::default()))
            .sum::<f64>() / 2.0;
        prop_assert!((area.abs() - (x + grow) * (y + grow)).abs() < 1e-6);
        prop_assert_eq!(area < 0.0, turn == Direction::Clockwise);
        prop_assert_eq!(all[3], Point2::default());
    }
}

/// Distance below which the crate takes two places as the same, mm.
const SAME: f64 = 2.6e-4;
