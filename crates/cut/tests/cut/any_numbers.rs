//! No panic and no flood of steps for any numbers whatever.

use crate::common::{IN, origin};
use kerf_cut::*;
use kerf_program::MoveKind;
use kerf_program::settings::Tabs;
use proptest::prelude::*;

fn turn() -> impl Strategy<Value = Direction> {
    prop_oneof![Just(Direction::Clockwise), Just(Direction::Counter)]
}

fn side() -> impl Strategy<Value = Side> {
    prop_oneof![Just(Side::Out), Just(Side::In), Just(Side::True)]
}

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
