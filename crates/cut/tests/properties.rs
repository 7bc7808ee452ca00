//! What holds for every cut: shapes on their circles, turned and mirrored alike, tabs in number and
//! place, and no panic and no flood for any numbers whatever.
#![allow(clippy::unwrap_used)]

mod common;
use common::{IN, nearest, origin};
use kerf_cut::*;
use kerf_geom::{Point2, Vec2, clock_to_vec};
use kerf_program::settings::Tabs;
use kerf_program::{MoveKind, Settings};
use proptest::prelude::*;
use std::f64::consts::TAU;

/// Millimetres; what sums and roots of sizes up to a metre may be off.
const NEAR_MM: f64 = 1e-6;

fn turn() -> impl Strategy<Value = Turn> {
    prop_oneof![Just(Turn::Clockwise), Just(Turn::Counter)]
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
        prop_assert_eq!(sweep_rad < 0.0, turn == Turn::Clockwise);
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
        prop_assert_eq!(sweep_rad < 0.0, turn == Turn::Clockwise);
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
        prop_assert_eq!(area < 0.0, turn == Turn::Clockwise);
        prop_assert_eq!(all[3], Point2::default());
    }
}

/// What the crate takes as the same place, mm.
const SAME: f64 = 2.6e-4;

fn any_number() -> impl Strategy<Value = f64> {
    prop_oneof![
        proptest::num::f64::ANY,
        -100.0..100.0,
        prop_oneof![Just(0.0), Just(1.0), Just(-1.0), Just(1e-300), Just(1e300), Just(1e6)]
    ]
}

fn any_pair() -> impl Strategy<Value = [f64; 2]> {
    [any_number(), any_number()]
}

fn any_passes() -> impl Strategy<Value = Passes> {
    let count = prop_oneof![0u32..5, Just(1_000_000_000), any::<u32>()];
    (any_number(), count, 0u8..5, any::<bool>(), any::<bool>()).prop_map(
        |(plunge_mm, repetitions, feature, no_pull_up, from_zero)| Passes {
            plunge_mm,
            repetitions,
            feature: Feature::from_number(feature).unwrap(),
            no_pull_up,
            from_zero,
        },
    )
}

fn any_context() -> impl Strategy<Value = Context> {
    let numbers = proptest::collection::vec(any_number(), 12);
    (numbers, any::<u16>()).prop_map(|(n, odd)| {
        // Each value is the usual one most of the time, so that all checks are reached.
        let pick =
            |i: usize, usual: f64| if odd >> i & 1 == 1 && odd & 7 == 0 { n[i] } else { usual };
        let usual = origin();
        Context {
            start: [pick(3, 0.0), pick(4, 0.0), pick(5, 0.0)],
            zero_z: pick(6, 0.0),
            safe_z: (odd & 24 != 24).then(|| pick(7, IN)),
            cutter_mm: pick(8, usual.cutter_mm),
            overlap_percent: pick(9, 10.0),
            circle_mm: pick(10, usual.circle_mm),
            small_circle_mm: pick(11, usual.small_circle_mm),
            scale: [pick(3, 1.0), pick(4, 1.0), pick(5, 1.0)],
            ..usual
        }
    })
}

/// Either an error or a finite path of bounded size.
fn is_bounded(result: &Result<Cut, CutError>) -> bool {
    result.as_ref().err().is_none_or(|e| !e.to_string().is_empty())
        && result.as_ref().ok().is_none_or(|cut| {
            let all = || cut.steps.iter().flat_map(Step::to);
            cut.steps.len() <= MAX_STEPS && all().all(|v| v.abs() <= MAX_LENGTH_MM)
        })
}

proptest! {
    #[test]
    fn no_numbers_make_a_circle_panic(
        n in [any_number(), any_number(), any_number()], proportion in any_pair(), centre in any_pair(),
        side in side(), turn in turn(), passes in any_passes(), context in any_context()
    ) {
        let shape = Circle {
            diameter_mm: n[0],
            side,
            turn,
            begin_deg: (n[1] != 0.0).then_some(n[1]),
            end_deg: (n[2] != 0.0).then_some(n[2]),
            proportion,
            passes,
        };
        prop_assert!(is_bounded(&circle(&shape, &context)));
        prop_assert!(is_bounded(&point_circle(centre, &shape, &context)));
    }

    #[test]
    fn no_numbers_make_an_arc_panic(
        n in [any_number(), any_number(), any_number()], proportion in any_pair(), end in any_pair(),
        side in side(), turn in turn(), passes in any_passes(), context in any_context()
    ) {
        let by_centre = ArcTo {
            diameter_mm: None,
            end: end.map(Some),
            centre_offset: [Some(n[0]), Some(n[1])],
            side,
            turn,
            proportion,
            passes,
        };
        let by_diameter = ArcTo { diameter_mm: Some(n[2]), ..by_centre.clone() };
        for shape in [by_centre, by_diameter] {
            prop_assert!(is_bounded(&arc_to(&shape, None, &context).map(|(cut, _)| cut)));
        }
        let plain = Passes { feature: Feature::Plain, ..passes };
        let shape = Arch {
            length_mm: n[0],
            height_mm: n[1],
            side,
            turn,
            alignment_deg: n[2],
            proportion,
            passes: plain,
        };
        prop_assert!(is_bounded(&arch(&shape, &context)));
    }

    #[test]
    fn no_numbers_make_a_rectangle_panic(
        size in any_pair(), side in side(), turn in turn(), corner in 1u8..=4,
        passes in any_passes(), context in any_context()
    ) {
        let shape = Rectangle {
            length_x_mm: size[0],
            length_y_mm: size[1],
            side,
            turn,
            corner: Corner::from_number(corner).unwrap(),
            passes,
        };
        prop_assert!(is_bounded(&rectangle(&shape, &context)));
    }

    #[test]
    fn no_numbers_make_tabs_panic(
        n in proptest::collection::vec(any_number(), 6), count in any::<Option<u32>>(),
        safe_z in any::<Option<f64>>(), places in proptest::collection::vec(
            ([any_number(), any_number(), any_number()], any::<bool>(), any_number()), 1..12)
    ) {
        let tabs = Tabs {
            up_mm: n[0], next_mm: n[1], size_mm: n[2], lead_mm: n[3], on: true, count,
            start_mm: (n[4] != 0.0).then_some(n[4]),
        };
        let mut tabber = Tabber::new(&tabs, safe_z);
        prop_assert!(Tabber::<u32>::check(&tabs).is_ok() || !tabber.active());
        let (mut at, mut out) = ([0.0; 3], Vec::new());
        for (i, (to, arc, bend)) in places.iter().enumerate() {
            let step = if *arc {
                Step::Arc { centre: [*bend, 0.0], sweep_rad: *bend, to: *to, chords: 7, small: false }
            } else {
                Step::Line { kind: if *bend > 90.0 { MoveKind::Jog } else { MoveKind::Cut }, to: *to }
            };
            tabber.push(at, step, i, &mut out);
            at = *to;
        }
        tabber.path_end(&mut out);
        prop_assert!(out.len() <= places.len() * 1_000_000);
        prop_assert!(out.windows(2).all(|w| w[0].0 <= w[1].0), "the order is kept");
    }
}

/// A path of lines and arcs below Safe-Z, and its corners.
fn tabbed_path() -> impl Strategy<Value = Vec<Step>> {
    let corner = ([-200.0..200.0, -200.0..200.0, -10.0..0.0f64], any::<bool>());
    proptest::collection::vec(corner, 1..10).prop_map(|corners| {
        let mut from = Point2::default();
        let mut steps = Vec::new();
        for (to, round) in corners {
            let end = Point2::new(to[0], to[1]);
            let middle = from.midpoint(end);
            steps.push(if round {
                let (centre, sweep_rad) = ([middle.x, middle.y], TAU / 2.0);
                Step::Arc { centre, sweep_rad, to, chords: 100, small: false }
            } else {
                Step::Line { kind: MoveKind::Cut, to }
            });
            from = end;
        }
        steps
    })
}

fn filtered(tabber: &mut Tabber<usize>, steps: &[Step]) -> Vec<(usize, Step)> {
    let (mut at, mut out) = ([0.0; 3], Vec::new());
    for (i, step) in steps.iter().enumerate() {
        tabber.push(at, *step, i, &mut out);
        at = step.to();
    }
    tabber.path_end(&mut out);
    out
}

proptest! {
    #[test]
    fn tabs_are_as_many_as_fit_and_change_nothing_but_z(
        steps in tabbed_path(), next in 5.0..80.0, size in 1.0..30.0, lead in 0.5..15.0
    ) {
        let tabs = Tabs {
            next_mm: next, size_mm: size, lead_mm: lead, ..Settings::default().tabs
        };
        let out = filtered(&mut Tabber::new(&tabs, Some(IN)), &steps);
        let mut at = [0.0; 3];
        let total: f64 = steps.iter().map(|s| { let l = s.length(at); at = s.to(); l }).sum();
        let (length, period) = (size + 2.0 * lead, size + 2.0 * lead + next);
        let room = (total - next - length) / period;
        prop_assume!((room - room.round()).abs() > 1e-6);
        let fit = if room < 0.0 { 0 } else { room.floor() as usize + 1 };
        // At the end of each piece: the height over the programmed path.
        let (mut tops, mut raised, mut at) = (0, false, [0.0; 3]);
        for (line, piece) in &out {
            let origin = if *line == 0 { [0.0; 3] } else { steps[line - 1].to() };
            let to = piece.to();
            let (off, share) = nearest(origin, &steps[*line], [to[0], to[1]]);
            prop_assert!(off < NEAR_MM, "{to:?} is beside step {line}");
            let height = to[2] - origin[2] - (steps[*line].to()[2] - origin[2]) * share;
            prop_assert!((-1e-5..tabs.up_mm + 1e-5).contains(&height), "{height}");
            let top = height > tabs.up_mm - 1e-5;
            tops += usize::from(top && !raised);
            raised = top;
            at = to;
        }
        prop_assert_eq!(tops, fit);
        prop_assert_eq!(at, steps.last().unwrap().to());
    }

    #[test]
    fn a_saved_filter_goes_on_alike(steps in tabbed_path(), cut in 0usize..10) {
        let tabs = Settings::default().tabs;
        let cut = cut.min(steps.len());
        let (mut whole, mut out) = (Tabber::new(&tabs, Some(IN)), Vec::new());
        let mut at = [0.0; 3];
        for (i, step) in steps.iter().enumerate() {
            if i == cut {
                whole = serde_json::from_str(&serde_json::to_string(&whole).unwrap()).unwrap();
            }
            whole.push(at, *step, i, &mut out);
            at = step.to();
        }
        whole.path_end(&mut out);
        let want = filtered(&mut Tabber::new(&tabs, Some(IN)), &steps);
        let near = |a: &(usize, Step), b: &(usize, Step)| {
            a.0 == b.0 && (0..3).all(|i| (a.1.to()[i] - b.1.to()[i]).abs() < NEAR_MM)
        };
        prop_assert!(out.len() == want.len() && out.iter().zip(&want).all(|(a, b)| near(a, b)));
    }

    #[test]
    fn without_tabs_the_stream_is_untouched(steps in tabbed_path()) {
        let tabs = Tabs { count: Some(0), ..Settings::default().tabs };
        let out = filtered(&mut Tabber::new(&tabs, Some(IN)), &steps);
        let plain: Vec<_> = out.iter().map(|p| p.1).collect();
        prop_assert_eq!(plain, steps);
    }
}
