//! Rings: known answers, and what must hold for every region.
#![allow(clippy::unwrap_used)]

mod check;
#[path = "../../geom/tests/families/mod.rs"]
mod families;

use check::look;
use families::Dice;
use kerf_geom::{Point2, Polyarc, Transform2, Vec2};
use kerf_pocket::{Cutter, SMALLEST_MM2, Way, rings};

fn p(x: f64, y: f64) -> Point2 {
    Point2::new(x, y)
}

#[test]
fn a_rectangle_is_cleared_by_one_path() {
    let region = [Polyarc::rectangle(p(0., 0.), p(100., 60.))];
    let cutter = Cutter::new(5.0, 0.1).unwrap();
    let paths = rings(&region, &cutter, Way::default()).unwrap();
    assert_eq!(paths.len(), 1);
    check_cleared("rectangle", &region, &paths, &cutter);
}

/// A region, a tool and an overlap made from a seed.
fn random_case(seed: u64) -> (Vec<Polyarc>, Cutter) {
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
        let at =
            p(dice.between(bounds.min.x, bounds.max.x), dice.between(bounds.min.y, bounds.max.y));
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

/// Looks with a fine grid where a coarse one finds something that may be too much.
fn check_cleared(name: &str, region: &[Polyarc], paths: &[Polyarc], cutter: &Cutter) {
    let smallest = SMALLEST_MM2.min(1e-3 * cutter.diameter_mm().powi(2));
    let mut seen = look(region, paths, cutter.radius_mm(), 300);
    if seen.largest_mm2 > smallest {
        seen = look(region, paths, cutter.radius_mm(), 2000);
    }
    assert!(seen.largest_mm2 <= 1.2 * smallest, "{name}: {seen:?}");
    assert!(seen.out_mm < 2e-4, "{name}: {seen:?}");
}

/// How many random regions are tried, and with which the trials begin; more of them by hand.
fn seeds() -> std::ops::Range<u64> {
    let number = |name, or| std::env::var(name).map_or(or, |text| text.parse().unwrap());
    let from = number("FROM", 0);
    from..from + number("SEEDS", 40)
}

#[test]
fn random_regions_are_cleared() {
    for seed in seeds() {
        let (region, cutter) = random_case(seed);
        let way = Way { climb: seed % 2 == 0, outward: seed % 3 == 0 };
        let paths = rings(&region, &cutter, way).unwrap_or_else(|e| panic!("{seed}: {e}"));
        check_cleared(&format!("seed {seed}"), &region, &paths, &cutter);
    }
}
