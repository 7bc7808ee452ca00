//! The planner that a controller tells by its settings: times by it are those that the controller takes.

use crate::shared::shared;
use crate::wire::{Wire, run};
use kerf_driver_grbl::fake::Fake;
use kerf_machine::driver::planners::Controller;
use kerf_machine::driver::{Axes, Link, Order, Wired};
use kerf_motion::{Move, Mover};
use kerf_program::{At, Feed, Line, MoveKind, Settings};
use std::fs;

const SPEED_MM_S: f64 = 60.0;

/// A wave of short legs with a sharp corner at every seventh.
fn places() -> Vec<Axes> {
    let place = |n: i32| {
        let (along, across) = (f64::from(n) * 1.5, f64::from(n % 7 * (7 - n % 7)));
        Axes::xyz(along, across * 0.6, -0.1 * f64::from(n % 2))
    };
    (1..=70).map(place).collect()
}

/// A spiral of chords so short that a dozen of them are made while the segments of the next are cut.
fn spiral() -> Vec<Axes> {
    let place = |n: i32| {
        let turned_rad = f64::from(n) * 0.05;
        let radius_mm = 2.0 + 0.6 * turned_rad;
        Axes::xyz(radius_mm * turned_rad.cos() - 2.0, radius_mm * turned_rad.sin(), 0.0)
    };
    (1..=900).map(place).collect()
}

fn moves(places: &[Axes], speed_mm_s: f64) -> Vec<Move> {
    let mut mover = Mover::new(Axes::default(), &Settings::default());
    let line = |to| Line { kind: MoveKind::Cut, to, feed: Feed::Path(speed_mm_s) };
    places.iter().filter_map(|to| mover.line(At::default(), &line(*to))).collect()
}

/// Seconds from the first motion of a controller to the last.
fn taken_s(link: &mut Link<Wire>, places: &[Axes], speed_mm_s: f64) -> f64 {
    for to in places {
        link.order(Order::Move { to: *to, speed_mm_s });
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

/// Seconds that are told and taken.
fn told_and_taken(settings: &[(u16, f64)], places: &[Axes], speed_mm_s: f64) -> [f64; 2] {
    let mut link = Link::new(Wire::new(Fake::new(settings)));
    let facts = link.driver().grbl.facts().cloned().unwrap();
    let told_s: f64 = facts.planner.unwrap().seconds(&moves(places, speed_mm_s)).iter().sum();
    [told_s, taken_s(&mut link, places, speed_mm_s)]
}

#[test]
fn the_time_by_the_settings_of_a_controller_is_the_one_that_it_takes() {
    for settings in [
        &[][..],
        &[(11, 0.05), (120, 900.0), (121, 250.0), (122, 100.0)],
        &[(11, 0.002), (110, 2400.0), (121, 800.0)],
    ] {
        let [told_s, taken_s] = told_and_taken(settings, &places(), SPEED_MM_S);
        assert!(
            (told_s / taken_s - 1.0).abs() < 0.02,
            "{settings:?}: {told_s} told, {taken_s} taken"
        );
    }
}

#[test]
fn a_controller_looks_no_farther_ahead_than_its_planner_holds() {
    let settings = [(120, 500.0), (121, 500.0), (110, 12_000.0), (111, 12_000.0)];
    let [told_s, taken_s] = told_and_taken(&settings, &spiral(), 150.0);
    assert!((told_s / taken_s - 1.0).abs() < 0.02, "{told_s} told, {taken_s} taken");
}

#[test]
fn the_reference_programs_take_as_long_as_is_told() {
    let Some(folder) = shared("anchors/motion") else {
        println!("skipped: the reference programs are not at hand");
        return;
    };
    let each = |first: u16, value: f64| (0..3).map(move |axis| (first + axis, value));
    let settings: Vec<_> = each(110, 12_000.0).chain(each(120, 500.0)).collect();
    for name in ["R1_rect", "R2_circle2000", "R3_spiral2000", "R4_zigzag90_5mm", "R7_mixed"] {
        let text = fs::read_to_string(folder.join(name).with_extension("xyz")).unwrap();
        let places: Vec<Axes> = text.lines().map(place).collect();
        let [told_s, taken_s] = told_and_taken(&settings, &places, 100.0);
        println!("{name}: {told_s:.3} s told, {taken_s:.3} s taken");
        assert!((told_s / taken_s - 1.0).abs() < 0.02, "{name}: {told_s} told, {taken_s} taken");
    }
}

fn place(line: &str) -> Axes {
    let mut numbers = line.split_whitespace().map(|word| word.parse().unwrap());
    let mut next = || numbers.next().unwrap();
    Axes::xyz(next(), next(), next())
}
