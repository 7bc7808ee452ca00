//! Random regions with random tools, and the look at what became of them.
#![allow(clippy::unwrap_used)]

use crate::check::{look, look_within};
use crate::families::{self, Dice};
use kerf_geom::{Bounds2, Point2, Polyarc, Transform2, Vec2};
use kerf_pocket::{Cutter, SMALLEST_MM2};

/// A region, a tool and an overlap made from a seed.
pub fn random_case(seed: u64) -> (Vec<Polyarc>, Cutter) {
    let mut dice = Dice::new(seed.wrapping_mul(77).wrapping_add(5));
    let outer = match seed % 5 {
        0 => families::skyline(seed).0,
        1 => families::filleted(seed).0,
        2 => families::polyarc(seed).0,
        3 => families::comb(seed).0.reversed(),
        _ => families::smooth(seed, 200).0,
    };
    let size = outer.bounds().size();
    let small = size.x.min(size.y);
    let diameter = small * dice.between(0.02, 0.2);
    let overlap = diameter * dice.one_of(&[0.0, 0.02, 0.1, 0.3, 0.6]);
    let holes = holes(&mut dice, &outer, small);
    let mut region = vec![outer];
    region.extend(holes);
    (region, Cutter::new(diameter, overlap).unwrap())
}

/// A few holes that neither cross the outer contour nor each other.
fn holes(dice: &mut Dice, outer: &Polyarc, small: f64) -> Vec<Polyarc> {
    let bounds = outer.bounds();
    let mut found: Vec<Polyarc> = Vec::new();
    for _ in 0..dice.whole(0, 12) {
        let at = Point2::new(
            dice.between(bounds.min.x, bounds.max.x),
            dice.between(bounds.min.y, bounds.max.y),
        );
        let size = small * dice.between(0.01, 0.15);
        let corner = Vec2::new(size, size * dice.between(0.3, 1.0));
        let hole = match dice.whole(0, 2) {
            0 => Polyarc::circle(at, size),
            1 => Polyarc::rectangle(at - corner, at + corner),
            _ => Polyarc::rounded_rectangle(at - corner, at + corner, size * 0.25),
        };
        let hole = hole.similar(&Transform2::turned(at, dice.between(0.0, 3.0)));
        let apart = |other: &Polyarc| {
            other.crossings(&hole).is_empty() && !other.contains(&hole) && !hole.contains(other)
        };
        if outer.crossings(&hole).is_empty() && outer.contains(&hole) && found.iter().all(apart) {
            found.push(hole.reversed());
        }
    }
    found
}

/// Looks with a fine grid where a coarse one finds something that may be too much, and in the end only round
/// the place: in a sheet of 120 mm one place of 700 along its side stands for 0.03 mm².
pub fn check_cleared(name: &str, region: &[Polyarc], paths: &[Polyarc], cutter: &Cutter) {
    let smallest = SMALLEST_MM2.min(1e-3 * cutter.diameter_mm().powi(2));
    let mut seen = look(region, paths, cutter.radius_mm(), 150);
    if seen.largest_mm2 > smallest {
        seen = look(region, paths, cutter.radius_mm(), 700);
    }
    if seen.largest_mm2 > smallest {
        let around =
            Bounds2::of(seen.largest_at, seen.largest_at).grown(2.2 * cutter.radius_mm() + 0.5);
        let cell = (smallest.sqrt() / 8.0).max(cutter.radius_mm() / 200.0);
        seen = look_within(region, paths, cutter.radius_mm(), (around, cell));
    }
    assert!(seen.largest_mm2 <= 1.2 * smallest, "{name}: {seen:?}");
    assert!(seen.out_mm < 2e-4, "{name}: {seen:?}");
}

/// As many random regions as usual, from the first; `SEEDS` and `FROM` try others.
pub fn seeds(usual: u64) -> std::ops::Range<u64> {
    let number = |name, or| std::env::var(name).map_or(or, |text| text.parse().unwrap());
    let from = number("FROM", 0);
    from..from + number("SEEDS", usual)
}
