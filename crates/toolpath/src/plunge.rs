//! Ways down into the material other than straight.
//!
//! ```text
//!  ZSurface ─╮   ramp: down along the path; a closed one is       helix: round a circle beside the
//!             ╲  followed on until it was cut all the way         path's start, then along the path
//!  depth       ╰──►  round at its depth
//! ```
//!
//! A ramp on an open path goes to and fro near its start. Nothing is cut that the path does not cut, so a ramp
//! fits wherever the path does; a helix needs room.

use crate::lead::{Side, lead_in};
use kerf_drawing::{Lead, Plunge};
use kerf_geom::{Place, Polyarc, Segment};
use std::f64::consts::PI;

/// A ramp that would go round more often is made steeper: the angle does not suit a path that short.
const MOST_ROUNDS: f64 = 1000.0;

/// A part of a way down: the height is that of its end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Slope {
    pub segment: Segment,
    pub z: f64,
}

/// How a pass begins and goes on.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Descent {
    /// From the height before to that of the pass; nothing for a straight plunge.
    pub slopes: Vec<Slope>,
    /// What is then cut at the height of the pass.
    pub level: Polyarc,
}

/// The way from the height of the pass before to that of the next one, both in millimetres.
pub(crate) fn descent(plunge: Plunge, path: &Polyarc, side: Side, from: f64, to: f64) -> Descent {
    let straight = || Descent { slopes: Vec::new(), level: path.clone() };
    let drop = from - to;
    if drop <= 0.0 || path.segment_count() == 0 {
        return straight();
    }
    match plunge {
        Plunge::Straight => straight(),
        Plunge::Ramp { angle_deg } if path.closed => round(path, drop / slope(angle_deg), from, to),
        Plunge::Ramp { angle_deg } => to_and_fro(path, drop / slope(angle_deg), from, to),
        Plunge::Helix { radius_mm, angle_deg } => {
            let turn = 2.0 * PI * radius_mm.abs() * slope(angle_deg);
            helix(path, side, radius_mm, (drop / turn).ceil(), from, to).unwrap_or_else(straight)
        }
    }
}

fn slope(angle_deg: f64) -> f64 {
    angle_deg.to_radians().tan()
}

/// Round a closed path as far as it takes, and then round it at depth from there.
fn round(path: &Polyarc, length: f64, from: f64, to: f64) -> Descent {
    let once = path.length();
    let length = length.min(MOST_ROUNDS * once);
    let mut way: Vec<Segment> = Vec::new();
    (0..(length / once) as usize).for_each(|_| way.extend(path.segments()));
    let rest = length % once;
    let end = path.place_after(rest).filter(|place| (place.segment, place.share) > (0, 0.0));
    let start = path.start().map(|at| Place { segment: 0, share: 0.0, at });
    if let (Some(start), Some(end)) = (start, end) {
        way.extend(path.between(&start, &end).segments());
    }
    let level = end.map_or_else(|| path.clone(), |place| path.started_at(&place));
    Descent { slopes: falling(&way, from, to), level }
}

/// To and fro along the beginning of an open path until it is deep enough, back at its start.
fn to_and_fro(path: &Polyarc, length: f64, from: f64, to: f64) -> Descent {
    let trips = (0.5 * length / path.length()).ceil().clamp(1.0, MOST_ROUNDS);
    let reach = (0.5 * length / trips).min(path.length());
    let start = path.start().map(|at| Place { segment: 0, share: 0.0, at });
    let there = match (start, path.place_after(reach)) {
        (Some(start), Some(end)) => path.between(&start, &end),
        _ => path.clone(),
    };
    let back = there.reversed();
    let trip = || there.segments().chain(back.segments());
    let way: Vec<Segment> = (0..trips as usize).flat_map(|_| trip()).collect();
    Descent { slopes: falling(&way, from, to), level: path.clone() }
}

/// Full turns of a circle that touches the path at its start, on the side of a lead.
fn helix(
    path: &Polyarc,
    side: Side,
    radius: f64,
    turns: f64,
    from: f64,
    to: f64,
) -> Option<Descent> {
    let circle = circle(path, side, radius)?;
    let turns = turns.clamp(1.0, MOST_ROUNDS) as usize;
    let way: Vec<Segment> = (0..turns).flat_map(|_| circle.segments()).collect();
    Some(Descent { slopes: falling(&way, from, to), level: path.clone() })
}

/// The circle of a helix, from the path's start to it.
pub(crate) fn circle(path: &Polyarc, side: Side, radius_mm: f64) -> Option<Polyarc> {
    let first = path.segments().next()?;
    let lead = Lead { radius_mm, angle_deg: 180.0 };
    let half = lead_in(lead, first.start(), first.direction(0.0), side)?;
    let vertex =
        |n: usize| kerf_geom::Vertex { at: half.vertices[n].at, bulge: half.vertices[0].bulge };
    Some(Polyarc::closed(vec![vertex(1), vertex(0)]))
}

/// Heights along a way in proportion to its length.
fn falling(way: &[Segment], from: f64, to: f64) -> Vec<Slope> {
    let whole: f64 = way.iter().map(Segment::length).sum();
    let mut gone = 0.0;
    let slope = |segment: &Segment| {
        gone += segment.length();
        let z = if whole > 0.0 { from + (to - from) * (gone / whole) } else { to };
        Slope { segment: *segment, z }
    };
    let mut slopes: Vec<Slope> = way.iter().map(slope).collect();
    slopes.last_mut().into_iter().for_each(|last| last.z = to);
    slopes
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use kerf_geom::Point2;

    fn p(x: f64, y: f64) -> Point2 {
        Point2::new(x, y)
    }

    /// Down by 1 mm; the slope's steepness is told against length, and where it begins and ends.
    fn check(plunge: Plunge, path: &Polyarc, angle_deg: f64, end: Point2) {
        let found = descent(plunge, path, Side::Right, 0.0, -1.0);
        let mut z = 0.0;
        let mut at = path.start().unwrap();
        for Slope { segment, z: to } in &found.slopes {
            assert!(segment.start().distance(at) < 1e-9);
            let steep = (z - to) / segment.length();
            assert!(steep <= slope(angle_deg) + 1e-9 && steep > 0.0, "{steep}");
            (z, at) = (*to, segment.end());
        }
        assert!((z + 1.0).abs() < 1e-12 && at.distance(end) < 1e-9, "{z} {at:?}");
        assert!(found.level.start().unwrap().distance(at) < 1e-9);
        assert!((found.level.length() - path.length()).abs() < 1e-9);
    }

    #[test]
    fn a_ramp_goes_round_a_closed_path() {
        let square = Polyarc::rectangle(p(0., 0.), p(10., 10.));
        let angle = (1.0_f64 / 15.0).atan().to_degrees();
        check(Plunge::Ramp { angle_deg: angle }, &square, angle, p(10., 5.));
        let angle = (1.0_f64 / 95.0).atan().to_degrees();
        check(Plunge::Ramp { angle_deg: angle }, &square, angle, p(10., 5.));
        let angle = (1.0_f64 / 40.0).atan().to_degrees();
        check(Plunge::Ramp { angle_deg: angle }, &square, angle, p(0., 0.));
    }

    #[test]
    fn a_ramp_goes_to_and_fro_on_an_open_path() {
        let line = Polyarc::lines([p(0., 0.), p(10., 0.), p(10., 3.)], false);
        check(Plunge::Ramp { angle_deg: 10.0 }, &line, 10.0, p(0., 0.));
        check(Plunge::Ramp { angle_deg: 0.5 }, &line, 0.5, p(0., 0.));
    }

    #[test]
    fn a_helix_comes_back_to_the_start() {
        let line = Polyarc::lines([p(0., 0.), p(10., 0.)], false);
        check(Plunge::Helix { radius_mm: 2.0, angle_deg: 2.0 }, &line, 2.0, p(0., 0.));
        let circle = circle(&line, Side::Right, 2.0).unwrap();
        assert!(circle.bounds().max.y.abs() < 1e-9 && circle.signed_area() < 0.0);
        let other = super::circle(&line, Side::Right, -2.0).unwrap();
        assert!(other.bounds().min.y.abs() < 1e-9 && other.signed_area() > 0.0);
    }

    #[test]
    fn nothing_slopes_upwards() {
        let line = Polyarc::lines([p(0., 0.), p(10., 0.)], false);
        let found = descent(Plunge::Ramp { angle_deg: 2.0 }, &line, Side::Right, 0.0, 3.0);
        assert_eq!(found, Descent { slopes: Vec::new(), level: line });
    }
}
