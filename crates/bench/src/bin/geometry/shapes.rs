//! The shapes that are offset.

use crate::families::{Dice, gear, noisy_10_000, smooth_10_000};
use kerf_geom::{Point2, Polyarc, Vec2};

/// Shapes and by how much they are offset; positive is outside.
pub struct Case {
    pub name: &'static str,
    pub contours: Vec<Polyarc>,
    pub distance: f64,
}

pub fn cases() -> Vec<Case> {
    let one = |name, shape: Polyarc, distance| Case { name, contours: vec![shape], distance };
    vec![
        one("gear of 200 segments +1.5", gear(), 1.5),
        one("gear of 200 segments −1.5", gear(), -1.5),
        Case { name: "1,000 small shapes +1", contours: small(), distance: 1.0 },
        Case { name: "1,000 small shapes −1", contours: small(), distance: -1.0 },
        one("smooth 10,000-gon −2", smooth_10_000(), -2.0),
        one("smooth 10,000-gon +2", smooth_10_000(), 2.0),
        one("noisy 10,000-gon +2", noisy_10_000(), 2.0),
    ]
}

/// Circles, rounded rectangles, slots and Ls, each in its own place.
fn small() -> Vec<Polyarc> {
    let mut dice = Dice::new(4);
    let shape = |k: usize| {
        let at = Point2::new((k % 40) as f64 * 30.0, (k / 40) as f64 * 30.0);
        let (w, h) = (dice.between(6.0, 20.0), dice.between(6.0, 20.0));
        match k % 4 {
            0 => Polyarc::circle(at, w * 0.5),
            1 => Polyarc::rounded_rectangle(at, at + Vec2::new(w, h), 2.0),
            2 => Polyarc::rounded_rectangle(at, at + Vec2::new(w + 4.0, 5.0), 2.5),
            _ => {
                let corners = [(0., 0.), (w, 0.), (w, 3.), (3., 3.), (3., h), (0., h)];
                Polyarc::lines(corners.map(|(x, y)| at + Vec2::new(x, y)), true)
            }
        }
    };
    (0..1000).map(shape).collect()
}
