//! The planner that a controller tells by its settings: times by it are those that the controller takes.

use crate::wire::{Wire, run};
use kerf_driver_grbl::fake::Fake;
use kerf_machine::driver::planners::Controller;
use kerf_machine::driver::{Axes, Link, Order, Wired};
use kerf_motion::{Move, Mover};
use kerf_program::{At, Feed, Line, MoveKind, Settings};

const SPEED_MM_S: f64 = 60.0;

/// A wave of short legs with a sharp corner at every seventh.
fn places() -> Vec<Axes> {
    let place = |n: i32| {
        let (along, across) = (f64::from(n) * 1.5, f64::from(n % 7 * (7 - n % 7)));
        Axes::xyz(along, across * 0.6, -0.1 * f64::from(n % 2))
    };
    (1..=70).map(place).collect()
}

fn moves() -> Vec<Move> {
    let mut mover = Mover::new(Axes::default(), &Settings::default());
    let line = |to| Line { kind: MoveKind::Cut, to, feed: Feed::Path(SPEED_MM_S) };
    places().into_iter().filter_map(|to| mover.line(At::default(), &line(to))).collect()
}

/// Seconds from the first motion of a controller to the last.
fn taken_s(link: &mut Link<Wire>) -> f64 {
    for to in places() {
        link.order(Order::Move { to, speed_mm_s: SPEED_MM_S });
    }
    let (mut before, mut moved_s) = (Axes::default(), Vec::new());
    run(link, 0.0, |link, now_s| {
        let place = link.driver().fake.position();
        if place != before {
            moved_s.push(now_s);
        }
        before = place;
    });
    moved_s.last().unwrap() - moved_s.first().unwrap()
}

#[test]
fn the_time_by_the_settings_of_a_controller_is_the_one_that_it_takes() {
    for settings in [
        &[][..],
        &[(11, 0.05), (120, 900.0), (121, 250.0), (122, 100.0)],
        &[(11, 0.002), (110, 2400.0), (121, 800.0)],
    ] {
        let mut link = Link::new(Wire::new(Fake::new(settings)));
        let facts = link.driver().grbl.facts().cloned().unwrap();
        let told_s: f64 = facts.planner.unwrap().seconds(&moves()).iter().sum();
        let taken_s = taken_s(&mut link);
        assert!(
            (told_s / taken_s - 1.0).abs() < 0.02,
            "{settings:?}: {told_s} told, {taken_s} taken"
        );
    }
}
