//! Short moves that lie on one line within the tolerance of arcs are one line to the controller.

use crate::bench::Bench;
use crate::events;
use crate::shop::Shop;
use std::f64::consts::TAU;

/// A circle of chords, in inches.
const RADIUS: f64 = 2.0;
const CHORDS: u32 = 1200;

#[test]
fn short_moves_on_one_line_are_sent_as_one() {
    let place = |n: u32| {
        let angle = TAU * f64::from(n) / f64::from(CHORDS);
        format!("M2,{:.6},{:.6}\n", RADIUS * angle.cos(), RADIUS * angle.sin())
    };
    let moves: String = (1..=CHORDS).map(place).collect();
    let text = format!("MS,3,3\nJ2,{RADIUS},0\nSO,1,1\n{moves}SO,1,0\n");
    let (shop, bench) = (Shop::new(&[("circle.sbp", &text)]), Bench::new(&[]));
    bench.run(&shop, "run circle.sbp").exits(0);
    let lines = bench.look(|fake| fake.lines.clone());
    let count = lines.iter().filter(|line| line.starts_with("G53")).count();
    assert!(count < 500, "{count} lines for {CHORDS} moves");
    let cut = bench.look(|fake| fake.cut.clone());
    let off =
        |place: &kerf_machine::driver::Axes| (place.0[0].hypot(place.0[1]) - 25.4 * RADIUS).abs();
    let worst_mm = cut.iter().map(off).fold(0.0, f64::max);
    assert!(worst_mm < 0.005, "{worst_mm} mm off the circle");
    let made = events(&shop, "move").len();
    assert_eq!(made, 1 + CHORDS as usize, "the jog and every move are told");
}
