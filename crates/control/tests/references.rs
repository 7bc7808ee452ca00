//! The reference programs R1 to R7 on a fake board, in simulated time: the numbers of
//! docs/how-boards-with-step-queues-are-driven.md.
//!
//! `cargo test -p kerf-control --test all -- references --nocapture` makes R7, `PROGRAM=R3` another one, `PROGRAM=all` all
//! of them; `ERROR_US=5` with steps up to 5 µs from their moments.

use crate::queued::{Shop, machine};
use crate::shared;
use kerf_driver_klipper::fake::Faults;
use kerf_machine::{Going, Machine};
use kerf_motion::{Model, Move, Mover, Optimal, Plan, Stepper};
use kerf_program::{At, Axes, Dynamics, Feed, Line, MoveKind, Settings};
use std::path::{Path, PathBuf};

/// Limits of the axes of the reference programs.
fn dynamics() -> Dynamics {
    Dynamics {
        speed_mm_s: Axes::splat(200.0),
        accel_mm_s2: Axes::splat(500.0),
        jerk_mm_s3: Some(Axes::splat(10_000.0)),
        tolerance_mm: 0.01,
    }
}

fn files() -> Vec<PathBuf> {
    let only = std::env::var("PROGRAM").unwrap_or_else(|_| "R7".into());
    let Some(folder) = shared::shared("anchors/motion") else {
        println!("skipped: no reference programs");
        return Vec::new();
    };
    let entries = std::fs::read_dir(folder).unwrap();
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    files.retain(|file| {
        let name = file.file_name().unwrap().to_string_lossy();
        name.ends_with(".xyz") && (only == "all" || name.starts_with(&only))
    });
    files.sort();
    files
}

/// Moves of a program, from where it begins.
fn moves(file: &Path) -> Vec<Move> {
    let text = std::fs::read_to_string(file).unwrap();
    let place = |line: &str| {
        let v: Vec<f64> = line.split_whitespace().map(|word| word.parse().unwrap()).collect();
        Axes::xyz(v[0], v[1], v[2])
    };
    let places: Vec<Axes> = text.lines().map(place).collect();
    let mut mover = Mover::new(places[0], &Settings::default());
    let line = |to: &Axes| Line { kind: MoveKind::Cut, to: *to, feed: Feed::Path(100.0) };
    places[1..].iter().filter_map(|to| mover.line(At::default(), &line(to))).collect()
}

/// Farthest that a step is from its moment, µs.
fn allowed_us() -> f64 {
    std::env::var("ERROR_US").map_or(machine().board.error_us, |us| us.parse().unwrap())
}

/// Makes a plan; returns the clock of the board at its beginning and its end.
fn make(shop: &mut Shop, plan: &Plan) -> [f64; 2] {
    let t0_s = 10.0;
    shop.queued.begin();
    shop.queued.is_at(plan.at(0.0).position);
    shop.queued.begin_plan();
    let until = plan.moves().len();
    let mut clocks = [0.0; 2];
    for index in 0..until {
        let going = Going { plan, index, t0_s, until, part: 1.0, watches: &[] };
        let end_s = t0_s + plan.span_s(index).1;
        while shop.queued.advance(&going, t0_s, end_s).reached_s < end_s {
            assert_eq!(shop.queued.fault(), None);
            if let Some(clock) = shop.queued.clock_at(t0_s) {
                clocks = [clock, shop.queued.clock_at(t0_s + plan.duration_s()).unwrap()];
            }
        }
    }
    while shop.queued.settle() {}
    shop.queued.close(true, || false);
    assert_eq!(shop.queued.fault(), None);
    clocks
}

fn check(file: &Path) {
    let plan = Optimal { dynamics: &dynamics() }.plan(moves(file));
    let per_unit = machine().program.resolution.steps_per_unit;
    let mut machine = machine();
    machine.board.error_us = allowed_us();
    let mut shop = Shop::of(&machine, 3, Faults::default(), |_| {});
    let sent = shop.world.borrow().there.bytes;
    let [begin, end] = make(&mut shop, &plan);
    let world = shop.world.borrow();
    let lasts_s = plan.duration_s();
    let rate = (end - begin) / lasts_s;
    let mut stepper = Stepper::new(per_unit, plan.at(0.0).position);
    let planned = stepper.follow(0.0, lasts_s, |t_s| plan.at(t_s).position);
    let (mut worst_us, mut count, mut last) = (0.0_f64, 0, 0);
    for axis in 0..3 {
        let made = &world.fake.steppers[&(axis as u8)].made;
        let own: Vec<_> = planned.iter().filter(|step| step.axis == axis).collect();
        assert_eq!(made.len(), own.len(), "axis {axis}");
        for ((clock, forward), step) in made.iter().zip(own) {
            assert_eq!(*forward, step.forward);
            let off = *clock as f64 - (begin + step.t_s * rate);
            worst_us = worst_us.max(off.abs() / 12.0);
        }
        count += made.len();
        last = last.max(made.last().map_or(0, |(clock, _)| *clock));
    }
    let first =
        (0..3).filter_map(|axis| world.fake.steppers[&axis].made.first()).map(|m| m.0).min();
    let span = |a: f64, b: f64| (b - a) / 12e6;
    let made_s = span(first.unwrap() as f64, last as f64);
    let planned_s = planned.last().unwrap().t_s - planned[0].t_s;
    let kb_s = (world.there.bytes - sent) as f64 / lasts_s / 1e3;
    eprintln!(
        "| {} | {lasts_s:.3} | {:+.4} | {count} | {worst_us:.2} | {kb_s:.2} | {} |",
        file.file_stem().unwrap().to_string_lossy(),
        (made_s / planned_s - 1.0) * 100.0,
        world.fake.most_places
    );
    let [commands, deadlines] =
        ["queue_step", "trsync_set_timeout"].map(|name| world.fake.ran[name]);
    eprintln!(
        "  {commands} commands of steps, {deadlines} deadlines, {} frames",
        world.there.frames
    );
    assert!((made_s / planned_s - 1.0).abs() < 1e-3, "{made_s} {planned_s}");
    assert!(worst_us <= allowed_us() + 0.1, "{worst_us}");
}

#[test]
fn references_are_made_as_foretold() {
    files().iter().for_each(|file| check(file));
}
