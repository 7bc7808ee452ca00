//! Times of other controllers, against measured ones and against their published formulas.
//!
//! The programs: R1 a rectangle, R4 a zigzag, R6 a Hilbert curve; 100 mm/s, 500 mm/s² and 200 mm/s
//! an axis.

use kerf_motion::controllers::{Controller, Grbl, Link, LinuxCnc, Release};
use kerf_motion::{Move, Mover};
use kerf_program::{Arc, At, Axes, Feed, Line, MoveKind, Settings};

const AXES_MM_S: Axes = Axes::splat(200.0);
const ACCEL: Axes = Axes::splat(500.0);

fn mover(start: Axes) -> Mover {
    Mover::new(start, &Settings::default())
}

/// Straight moves at 100 mm/s.
fn cuts(points: &[[f64; 2]]) -> Vec<Move> {
    let place = |p: &[f64; 2]| Axes::xyz(p[0], p[1], 0.0);
    let mut mover = mover(place(&points[0]));
    let line = |p| Line { kind: MoveKind::Cut, to: place(p), feed: Feed::Path(100.0) };
    points[1..].iter().filter_map(|p| mover.line(At::default(), &line(p))).collect()
}

fn rectangle() -> Vec<Move> {
    cuts(&[[0.0, 0.0], [200.0, 0.0], [200.0, 100.0], [0.0, 100.0], [0.0, 0.0]])
}

fn zigzag() -> Vec<Move> {
    let step = 5.0 * std::f64::consts::FRAC_1_SQRT_2;
    let points = (0..=100).map(|k| [f64::from(k) * step, f64::from(k % 2) * step]);
    cuts(&points.collect::<Vec<_>>())
}

/// A Hilbert curve of order 5 with steps of 1 mm.
fn hilbert() -> Vec<Move> {
    const SIDE: u32 = 32;
    let point = |index: u32| {
        let (mut x, mut y, mut rest, mut s) = (0, 0, index, 1);
        while s < SIDE {
            let rx = 1 & (rest / 2);
            let ry = 1 & (rest ^ rx);
            if ry == 0 {
                if rx == 1 {
                    (x, y) = (s - 1 - x, s - 1 - y);
                }
                (x, y) = (y, x);
            }
            (x, y) = (x + s * rx, y + s * ry);
            (rest, s) = (rest / 4, s * 2);
        }
        [f64::from(x), f64::from(y)]
    };
    cuts(&(0..SIDE * SIDE).map(point).collect::<Vec<_>>())
}

/// A circle of 50 mm in so many chords.
fn chords(n: u32) -> Vec<Move> {
    let point = |k: u32| {
        let (sin, cos) = (f64::from(k) * std::f64::consts::TAU / f64::from(n)).sin_cos();
        [50.0 * cos, 50.0 * sin]
    };
    cuts(&(0..=n).map(point).collect::<Vec<_>>())
}

fn circle() -> Vec<Move> {
    let start = Axes::xyz(50.0, 0.0, 0.0);
    let arc = Arc {
        kind: MoveKind::Cut,
        centre: [0.0, 0.0],
        sweep_rad: std::f64::consts::TAU,
        to: start,
        feed: Feed::Path(100.0),
        chords: 64,
        small: false,
    };
    mover(start).arc(At::default(), &arc).into_iter().collect()
}

fn grbl(deviation: f64) -> Grbl {
    Grbl { junction_deviation_mm: deviation, link: None, ..Grbl::new(AXES_MM_S, ACCEL) }
}

fn linuxcnc(blend_mm: f64) -> LinuxCnc {
    LinuxCnc {
        release: Release::V2_10,
        speed_mm_s: AXES_MM_S,
        accel_mm_s2: ACCEL,
        blend_mm,
        same_line_mm: blend_mm,
    }
}

fn total(controller: &dyn Controller, run: &[Move]) -> f64 {
    controller.seconds(run).into_iter().sum()
}

#[track_caller]
fn near(got: f64, expected: f64, percent: f64) {
    assert!((got / expected - 1.0).abs() <= 0.01 * percent, "{got} is not {expected}");
}

#[test]
fn the_same_hilbert_curve_takes_56_seconds_on_one_and_74_on_the_other() {
    let run = hilbert();
    let length: f64 = run.iter().map(|m| m.length_mm).sum();
    assert!((length / 100.0 - 10.23).abs() < 1e-9);
    near(total(&grbl(0.05), &run), 56.036, 0.1);
    near(total(&linuxcnc(0.05), &run), 73.653, 0.1);
}

#[test]
fn grbl_passes_corners_by_its_formula() {
    near(total(&grbl(0.05), &rectangle()), 6.694, 0.1);
    near(total(&grbl(0.05), &zigzag()), 14.784, 0.1);
}

#[test]
fn linuxcnc_takes_what_the_real_one_takes() {
    for (blend, run, measured) in [
        (0.05, rectangle(), 6.790),
        (0.01, rectangle(), 6.798),
        (0.05, zigzag(), 17.111),
        (0.01, zigzag(), 17.020),
        (0.01, hilbert(), 78.748),
        (0.05, chords(2000), 3.386),
        (0.05, circle(), 3.544),
    ] {
        near(total(&linuxcnc(blend), &run), measured, 1.0);
    }
}

#[test]
fn linuxcnc_before_2_10_makes_the_last_leg_with_half_the_acceleration() {
    for (blend, run, measured) in [
        (0.05, rectangle(), 6.977),
        (0.01, rectangle(), 6.992),
        (0.05, zigzag(), 17.171),
        (0.01, zigzag(), 17.086),
        (0.01, hilbert(), 78.779),
    ] {
        let older = LinuxCnc { release: Release::V2_9, ..linuxcnc(blend) };
        near(total(&older, &run), measured, 0.1);
    }
}

#[test]
fn linuxcnc_before_2_10_makes_arcs_of_all_of_a_path_of_short_chords() {
    // Arcs have half the acceleration along them.
    let older = LinuxCnc { release: Release::V2_9, ..linuxcnc(0.01) };
    near(total(&older, &chords(2000)), 3.511, 1.0);
}

#[test]
fn linuxcnc_stops_at_corners_where_nothing_may_be_rounded() {
    near(total(&linuxcnc(0.0), &rectangle()), 6.800, 0.01);
    near(total(&linuxcnc(0.0), &zigzag()), 16.818, 0.1);
}

#[test]
fn linuxcnc_slows_by_the_acceleration_of_z_only_what_moves_in_z() {
    let weak_z = LinuxCnc { accel_mm_s2: Axes::xyz(500.0, 500.0, 300.0), ..linuxcnc(0.05) };
    for flat in [zigzag(), hilbert(), circle()] {
        assert_eq!(total(&weak_z, &flat), total(&linuxcnc(0.05), &flat));
    }
    let mut upright = zigzag();
    for step in &mut upright {
        for place in [&mut step.from, &mut step.to] {
            place.0.swap(1, 2);
        }
    }
    assert!(total(&weak_z, &upright) > 1.05 * total(&linuxcnc(0.05), &upright));
}

#[test]
fn a_short_look_ahead_slows_short_segments() {
    let run = chords(2000);
    let far = Grbl { blocks: 100_000, ..grbl(0.05) };
    near(total(&far, &run), 3.341, 0.1);
    // 15 chords of 0.157 mm are all the room there is to brake: 48 mm/s.
    let speed = (2.0 * 500.0 * 15.0 * 100.0 * std::f64::consts::PI / 2000.0).sqrt();
    near(total(&grbl(0.05), &run), 100.0 * std::f64::consts::PI / speed, 3.0);
}

#[test]
fn a_slow_link_slows_what_needs_more_lines_than_it_brings() {
    let run = chords(2000);
    let slow = Grbl { blocks: 100, ..grbl(0.05) };
    let fed = Grbl { link: Some(Link::default()), ..slow.clone() };
    // About 16 bytes a line, 11520 bytes a second.
    assert!(total(&slow, &run) < 4.0);
    let seconds = total(&fed, &run);
    assert!((2.6..8.0).contains(&seconds) && seconds >= total(&slow, &run), "{seconds}");
    let slower = Grbl { link: Some(Link { baud: 9600.0, buffer: 128 }), ..slow };
    assert!(total(&slower, &run) > 30.0);
    // Where lines are long the link does not matter.
    let fed = Grbl { link: Some(Link::default()), ..grbl(0.05) };
    near(total(&fed, &rectangle()), total(&grbl(0.05), &rectangle()), 0.1);
}

/// Half circles and lines in turn; the words of an arc are as long in either direction.
fn waves(sweep_rad: f64) -> Vec<Move> {
    let mut mover = mover(Axes::default());
    let feed = Feed::Path(100.0);
    (0..20)
        .filter_map(|k| {
            let x = 10.0 * f64::from(k);
            let (centre, to) = ([x + 5.0, 0.0], Axes::xyz(x + 10.0, 0.0, 0.0));
            if k % 2 == 0 {
                return mover.line(At::default(), &Line { kind: MoveKind::Cut, to, feed });
            }
            let (kind, chords) = (MoveKind::Cut, 16);
            let arc = Arc { kind, centre, sweep_rad, to, feed, chords, small: false };
            mover.arc(At::default(), &arc)
        })
        .collect()
}

#[test]
fn arcs_in_either_direction_are_words_of_their_own() {
    let slow = Grbl { link: Some(Link { baud: 300.0, buffer: 128 }), ..grbl(0.05) };
    let [right, left] = [-1.0, 1.0].map(|way| total(&slow, &waves(way * std::f64::consts::PI)));
    assert!(right > 10.0, "the link decides: {right}");
    near(left, right, 0.01);
}

#[test]
fn arcs_become_chords_on_board() {
    // One line, so the link does not matter; look-ahead does.
    let far = Grbl { blocks: 100_000, ..grbl(0.01) };
    near(total(&far, &circle()), 3.341, 1.0);
    assert!(total(&grbl(0.01), &circle()) >= total(&far, &circle()));
}

#[test]
fn every_move_has_its_share_of_the_time() {
    let run = rectangle();
    for seconds in [grbl(0.01).seconds(&run), linuxcnc(0.05).seconds(&run)] {
        assert_eq!(seconds.len(), 4);
        assert!(seconds[0] > 2.0 && seconds[1] > 1.0 && seconds[1] < 1.5, "{seconds:?}");
    }
    assert!(grbl(0.01).seconds(&[]).is_empty() && linuxcnc(0.05).seconds(&[]).is_empty());
}
