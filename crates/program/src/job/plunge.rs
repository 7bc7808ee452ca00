//! Ways down into the material other than straight.
//!
//! ```text
//!  ZSurface ─╮   ╭─    ramp: down along the path, to and fro near       helix: round a circle beside
//!             ╲ ╱      its start, or round it when it is short          the path's start
//!  depth       ╰──►
//! ```
//!
//! Every way down ends where the path begins. A ramp cuts nothing that the path does not cut, so it fits
//! wherever the path does; a helix needs room.

use kerf_geom::{Polyarc, PolyarcPlace, Segment, Vertex};
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;
use std::fmt;

/// Way in which the tool goes down into the material.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Plunge {
    /// Straight down.
    #[default]
    Straight,
    /// Down along the path.
    Ramp {
        /// Steepness, degrees below the level.
        angle_deg: f64,
    },
    /// Down round a circle that touches the path at its start.
    Helix {
        /// Radius of the circle, millimetres. It lies to the right of travel, to the left when the radius is
        /// negative.
        radius_mm: f64,
        /// Steepness, degrees below the level.
        angle_deg: f64,
    },
}

/// A way down that would go round more often is made steeper: the angle does not suit a path that short.
const MOST_ROUNDS: f64 = 1000.0;

/// A way down that is made steeper than was asked; its message tells a person.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TooFlat {
    /// Steepness that was asked for, degrees below the level.
    pub asked_deg: f64,
    /// Steepness in fact, rounded up to three digits: a way this steep is as it was asked.
    pub least_deg: f64,
}

impl fmt::Display for TooFlat {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { asked_deg, least_deg } = self;
        write!(
            f,
            "at {asked_deg} degrees it would go down in more than {MOST_ROUNDS} rounds: it goes down at {least_deg} \
             degrees instead"
        )
    }
}

/// A part of a way down: the height is that of its end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slope {
    /// Path of the part in the plane.
    pub segment: Segment,
    /// The height at its end, millimetres.
    pub z_mm: f64,
}

impl Plunge {
    /// The way from a height down to another one, both in millimetres, ending at the start of the path;
    /// nothing for a straight one, and upwards.
    pub fn slopes(self, path: &Polyarc, from_mm: f64, to_mm: f64) -> Vec<Slope> {
        let drop = from_mm - to_mm;
        if drop <= 0.0 || path.segment_count() == 0 {
            return Vec::new();
        }
        let way = match self {
            Self::Straight => Vec::new(),
            Self::Ramp { angle_deg } => ramp(path, drop / steepness(angle_deg)),
            Self::Helix { radius_mm, angle_deg } => {
                let turn = 2.0 * PI * radius_mm.abs() * steepness(angle_deg);
                helix(path, radius_mm, (drop / turn).ceil())
            }
        };
        falling(&way, from_mm, to_mm)
    }

    /// Returns the angles if the way down by a height in millimetres would go round too often.
    pub fn too_flat(self, path: &Polyarc, drop_mm: f64) -> Option<TooFlat> {
        let (asked_deg, round_mm) = match self {
            Self::Straight => return None,
            Self::Ramp { angle_deg } if path.closed => (angle_deg, path.length()),
            Self::Ramp { angle_deg } => (angle_deg, 2.0 * path.length()),
            Self::Helix { radius_mm, angle_deg } => (angle_deg, 2.0 * PI * radius_mm.abs()),
        };
        let longest_mm = MOST_ROUNDS * round_mm;
        let flat = longest_mm > 0.0 && drop_mm > longest_mm * steepness(asked_deg) * (1.0 + 1e-9);
        flat.then(|| TooFlat { asked_deg, least_deg: digits_up((drop_mm / longest_mm).atan()) })
    }
}

/// An angle in degrees, rounded up to three digits.
fn digits_up(rad: f64) -> f64 {
    let degrees = rad.to_degrees();
    let digits = 10f64.powf(2.0 - degrees.log10().floor());
    (degrees * digits).ceil() / digits
}

fn steepness(angle_deg: f64) -> f64 {
    angle_deg.to_radians().tan()
}

/// Round a closed path as often as it takes if that is at least once, else to and fro along its beginning.
fn ramp(path: &Polyarc, length: f64) -> Vec<Segment> {
    let once = path.length();
    if path.closed && length >= once {
        let rounds = (length / once).ceil().min(MOST_ROUNDS) as usize;
        return (0..rounds).flat_map(|_| path.segments()).collect();
    }
    let trips = (0.5 * length / once).ceil().clamp(1.0, MOST_ROUNDS);
    let reach = (0.5 * length / trips).min(once);
    let start = path.start().map(|at| PolyarcPlace { segment: 0, share: 0.0, at });
    let there = match (start, path.place_after(reach)) {
        (Some(start), Some(end)) => path.between(&start, &end),
        _ => path.clone(),
    };
    let back = there.reversed();
    (0..trips as usize).flat_map(|_| there.segments().chain(back.segments())).collect()
}

/// Full turns of a circle that touches the path at its start.
fn helix(path: &Polyarc, radius_mm: f64, turns: f64) -> Vec<Segment> {
    let turns = turns.clamp(1.0, MOST_ROUNDS) as usize;
    let circle = helix_circle(path, radius_mm);
    circle.iter().flat_map(|circle| (0..turns).flat_map(|_| circle.segments())).collect()
}

/// The circle of a helix, from the path's start to it.
pub fn helix_circle(path: &Polyarc, radius_mm: f64) -> Option<Polyarc> {
    let first = path.segments().next()?;
    let across = first.direction(0.0).left() * (-2.0 * radius_mm);
    let bulge = -radius_mm.signum();
    let start = first.start();
    Some(Polyarc::closed(vec![Vertex { at: start, bulge }, Vertex { at: start + across, bulge }]))
}

/// Heights along a way in proportion to its length.
fn falling(way: &[Segment], from: f64, to: f64) -> Vec<Slope> {
    let whole: f64 = way.iter().map(Segment::length).sum();
    let mut gone = 0.0;
    let slope = |segment: &Segment| {
        gone += segment.length();
        let z_mm = if whole > 0.0 { from + (to - from) * (gone / whole) } else { to };
        Slope { segment: *segment, z_mm }
    };
    let mut slopes: Vec<Slope> = way.iter().map(slope).collect();
    slopes.last_mut().into_iter().for_each(|last| last.z_mm = to);
    slopes
}

#[cfg(test)]
mod tests {
    use super::*;
    use kerf_geom::Point2;

    fn p(x: f64, y: f64) -> Point2 {
        Point2::new(x, y)
    }

    /// Down by 1 mm, never steeper than that, from the start of the path and back to it.
    fn check(plunge: Plunge, path: &Polyarc, angle_deg: f64, length: f64) {
        let found = plunge.slopes(path, 0.0, -1.0);
        let mut z = 0.0;
        let mut at = path.start().unwrap_or_default();
        for Slope { segment, z_mm } in &found {
            assert!(segment.start().distance(at) < 1e-9);
            let steep = (z - z_mm) / segment.length();
            assert!(steep <= steepness(angle_deg) + 1e-9 && steep > 0.0, "{steep}");
            (z, at) = (*z_mm, segment.end());
        }
        assert!((z + 1.0).abs() < 1e-12 && Some(at) == path.start(), "{z} {at:?}");
        let long: f64 = found.iter().map(|slope| slope.segment.length()).sum();
        assert!((long - length).abs() < 1e-6, "{long}");
    }

    fn degrees(drop: f64, length: f64) -> f64 {
        (drop / length).atan().to_degrees()
    }

    #[test]
    fn ramps_go_to_and_fro_or_round() {
        let square = Polyarc::rectangle(p(0., 0.), p(10., 10.));
        for (wanted, length) in [(15.0, 15.0), (39.0, 39.0), (95.0, 120.0), (40.0, 40.0)] {
            let angle_deg = degrees(1.0, wanted);
            check(Plunge::Ramp { angle_deg }, &square, angle_deg, length);
        }
        let line = Polyarc::lines([p(0., 0.), p(10., 0.), p(10., 3.)], false);
        for wanted in [6.0, 26.0, 100.0] {
            let angle_deg = degrees(1.0, wanted);
            check(Plunge::Ramp { angle_deg }, &line, angle_deg, wanted);
        }
    }

    #[test]
    fn helices_lie_to_the_right() {
        let line = Polyarc::lines([p(0., 0.), p(10., 0.)], false);
        let angle_deg = degrees(1.0, 3.0 * 4.0 * PI);
        check(Plunge::Helix { radius_mm: 2.0, angle_deg }, &line, angle_deg, 3.0 * 4.0 * PI);
        let bounds = |radius| helix_circle(&line, radius).map(|circle| circle.bounds());
        assert!(bounds(2.0).is_some_and(|b| b.max.y.abs() < 1e-9 && (b.min.y + 4.0).abs() < 1e-9));
        assert!(bounds(-2.0).is_some_and(|b| b.min.y.abs() < 1e-9 && (b.max.y - 4.0).abs() < 1e-9));
    }

    #[test]
    fn what_would_go_round_too_often_is_steeper_and_told() {
        let square = Polyarc::rectangle(p(0., 0.), p(10., 10.));
        let line = Polyarc::lines([p(0., 0.), p(10., 0.)], false);
        let (ramp, helix) = (
            |angle_deg| Plunge::Ramp { angle_deg },
            |angle_deg| Plunge::Helix { radius_mm: 2.0, angle_deg },
        );
        let cases: [(&dyn Fn(f64) -> Plunge, _, f64); 3] =
            [(&ramp, &square, 40.0), (&ramp, &line, 20.0), (&helix, &line, 4.0 * PI)];
        for (plunge, path, round) in cases {
            let longest = |angle_deg: f64| -> f64 {
                let slopes = plunge(angle_deg).slopes(path, 0.0, -1.0);
                slopes.iter().map(|slope| slope.segment.length()).sum()
            };
            let least_deg = degrees(1.0, 1000.0 * round);
            assert!((longest(0.5 * least_deg) - 1000.0 * round).abs() < 1e-6);
            let told = plunge(0.5 * least_deg).too_flat(path, 1.0).expect("too flat");
            assert_eq!(told.asked_deg, 0.5 * least_deg);
            assert!((1.0..1.01).contains(&(told.least_deg / least_deg)), "{told:?}");
            assert_eq!(plunge(least_deg).too_flat(path, 1.0), None);
            assert_eq!(plunge(told.least_deg).too_flat(path, 1.0), None);
            // As told, no steeper.
            assert!(plunge(0.99 * least_deg).too_flat(path, 1.0).is_some());
        }
        assert_eq!(Plunge::Straight.too_flat(&line, 1.0), None);
    }

    #[test]
    fn nothing_slopes_upwards() {
        let line = Polyarc::lines([p(0., 0.), p(10., 0.)], false);
        assert_eq!(Plunge::Ramp { angle_deg: 2.0 }.slopes(&line, 0.0, 3.0), []);
    }
}
