//! Tabs in number and place on any path of lines and arcs.

use crate::common::{IN, nearest};
use kerf_cut::*;
use kerf_geom::Point2;
use kerf_program::settings::Tabs;
use kerf_program::{MoveKind, Settings};
use proptest::prelude::*;
use std::f64::consts::TAU;

/// Millimetres; what sums of lengths up to some metres may be off.
const NEAR_MM: f64 = 1e-6;

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
