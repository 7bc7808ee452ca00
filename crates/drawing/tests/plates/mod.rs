//! Plates of parts with holes, and plates of holes to drill, each made from a seed.
#![allow(dead_code)]

use kerf_drawing::{Drawing, Shape};
use kerf_geom::{Point2, Polyarc, Vec2};

/// A small generator of numbers that look random (SplitMix64), the same on every machine.
pub struct Dice(u64);

impl Dice {
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15).wrapping_add(0x1234_5678_9ABC_DEF1))
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * ((self.next() >> 11) as f64 / (1u64 << 53) as f64)
    }

    pub fn whole(&mut self, low: u64, high: u64) -> u64 {
        low + self.next() % (high - low + 1)
    }

    pub fn shuffle<T>(&mut self, list: &mut [T]) {
        for n in (1..list.len()).rev() {
            list.swap(n, self.whole(0, n as u64) as usize);
        }
    }
}

/// Distance of neighbouring parts, millimetres.
const PITCH_MM: f64 = 85.0;

/// A plate of so many contours: parts in rows, in the order in which someone happened to draw them, each
/// with two to six holes that were drawn before it.
pub fn plate(contours: usize, seed: u64) -> Drawing {
    let mut dice = Dice::new(seed);
    let parts = (contours as f64 / 5.0).ceil() as usize;
    let columns = (parts as f64).sqrt().ceil() as usize;
    let mut cells: Vec<usize> = (0..parts).collect();
    dice.shuffle(&mut cells);
    let mut shapes = Vec::new();
    for (n, cell) in cells.iter().enumerate() {
        let corner =
            Vec2::new((cell % columns) as f64 * PITCH_MM, (cell / columns) as f64 * PITCH_MM);
        let left = contours - shapes.len();
        let later = parts - n - 1;
        // As many holes as leave two to six for each of the parts to come.
        let low = (left - 1).saturating_sub(later * 7).clamp(2, 6);
        let high = left.saturating_sub(1 + later * 3).clamp(low, 6);
        let holes = dice.whole(low as u64, high as u64) as usize;
        part(&mut dice, Point2::default() + corner, holes, &mut shapes);
    }
    Drawing::of(shapes)
}

fn part(dice: &mut Dice, corner: Point2, holes: usize, shapes: &mut Vec<Shape>) {
    let (wide, high) = (dice.between(46.0, 77.0), dice.between(46.0, 77.0));
    let spare = Vec2::new(PITCH_MM - wide, PITCH_MM - high);
    let low = corner + Vec2::new(dice.between(0.0, spare.x), dice.between(0.0, spare.y));
    let (mut placed, mut largest): (Vec<(Point2, f64)>, f64) = (Vec::new(), 6.0);
    while placed.len() < holes {
        let radius = dice.between(2.0, largest);
        let edge = radius + 3.0;
        let by = Vec2::new(dice.between(edge, wide - edge), dice.between(edge, high - edge));
        if placed.iter().all(|(other, r)| other.distance(low + by) > r + radius + 2.0) {
            placed.push((low + by, radius));
        }
        // Where there is no room, holes become small.
        largest = 2.0 + (largest - 2.0) * 0.98;
    }
    shapes.extend(placed.into_iter().map(|(at, radius)| Shape::flat(hole(dice, at, radius))));
    shapes.push(Shape::flat(outline(dice, low, Vec2::new(wide, high))));
}

/// A round or a square hole, clockwise.
fn hole(dice: &mut Dice, at: Point2, radius: f64) -> Polyarc {
    let half = Vec2::new(radius * 0.7, radius * 0.7);
    let path = match dice.whole(0, 2) {
        0 => Polyarc::rectangle(at + half * -1.0, at + half),
        _ => Polyarc::circle(at, radius),
    };
    path.reversed()
}

fn outline(dice: &mut Dice, low: Point2, size: Vec2) -> Polyarc {
    match dice.whole(0, 1) {
        0 => Polyarc::rectangle(low, low + size),
        _ => Polyarc::rounded_rectangle(low, low + size, 8.0),
    }
}

/// Places to drill on a plate of a square metre.
pub fn drilled(places: usize, seed: u64) -> Drawing {
    let mut dice = Dice::new(seed);
    let mut place = || Point2::new(dice.between(0.0, 1000.0), dice.between(0.0, 1000.0));
    Drawing::of((0..places).map(|_| Shape::point(place())))
}
