//! The curve through given places: a cubic spline whose parameter is the length of the chords.
//!
//! At each place the two cubics beside it agree in direction and curvature; at an end without a tangent the
//! curvature is zero (the natural spline). With h the lengths of the chords and m the derivatives:
//!
//! ```text
//!  hᵢ mᵢ₋₁ + 2 (hᵢ₋₁ + hᵢ) mᵢ + hᵢ₋₁ mᵢ₊₁ = 3 (hᵢ dᵢ₋₁ + hᵢ₋₁ dᵢ)      d = chord / h
//!  2 m₀ + m₁ = 3 d₀                                                  at a free end
//! ```

use super::map::Vec3;
use kerf_geom::tol::SAME_PLACE_MM;

/// Each sweep halves what is wrong at least, as the middle counts twice what stands beside it.
const SWEEPS: usize = 64;

/// A cubic B-spline: knots and control points.
pub(super) struct Cubic {
    pub knots: Vec<f64>,
    pub points: Vec<Vec3>,
}

/// The spline through places, open or closed, with the directions of its ends where they are known; nothing
/// for fewer than two different places.
pub(super) fn through(places: &[Vec3], closed: bool, ends: [Option<Vec3>; 2]) -> Option<Cubic> {
    let mut places = places.to_vec();
    if closed {
        places.extend(places.first().copied());
    }
    places.dedup_by(|b, a| length(minus(*b, *a)) <= SAME_PLACE_MM);
    if places.len() < 2 {
        return None;
    }
    let chords: Vec<f64> = places.windows(2).map(|ab| length(minus(ab[1], ab[0]))).collect();
    let returns = closed && places.len() > 3;
    let derivatives = derivatives(&places, &chords, returns, ends.map(|end| end.and_then(unit)));
    Some(cubic(&places, &chords, &derivatives))
}

fn derivatives(
    places: &[Vec3],
    chords: &[f64],
    returns: bool,
    ends: [Option<Vec3>; 2],
) -> Vec<Vec3> {
    let last = places.len() - 1;
    let slope = |chord: usize| scaled(minus(places[chord + 1], places[chord]), 1.0 / chords[chord]);
    let mut found = vec![Vec3::default(); places.len()];
    let free = |slope: Vec3, beside: Vec3| scaled(minus(scaled(slope, 3.0), beside), 0.5);
    for _ in 0..SWEEPS {
        for place in 0..=last {
            let (left, right) = match place {
                0 if returns => (last - 1, 0),
                n if n == last && returns => (last - 1, 0),
                0 => {
                    found[0] = ends[0].unwrap_or_else(|| free(slope(0), found[1]));
                    continue;
                }
                n if n == last => {
                    found[n] = ends[1].unwrap_or_else(|| free(slope(n - 1), found[n - 1]));
                    continue;
                }
                n => (n - 1, n),
            };
            let (before, after) = (found[left], found[right + 1]);
            let (h, k) = (chords[left], chords[right]);
            let wanted = plus(scaled(slope(left), 3.0 * k), scaled(slope(right), 3.0 * h));
            let beside = plus(scaled(before, k), scaled(after, h));
            found[place] = scaled(minus(wanted, beside), 0.5 / (h + k));
        }
    }
    found
}

/// Each cubic by its four control points; knots that are threefold let them hang together.
fn cubic(places: &[Vec3], chords: &[f64], derivatives: &[Vec3]) -> Cubic {
    let (mut knots, mut points) = (vec![0.0; 4], vec![places[0]]);
    let mut at = 0.0;
    for (n, chord) in chords.iter().enumerate() {
        at += chord;
        knots.extend([at; 3]);
        points.push(plus(places[n], scaled(derivatives[n], chord / 3.0)));
        points.push(minus(places[n + 1], scaled(derivatives[n + 1], chord / 3.0)));
        points.push(places[n + 1]);
    }
    knots.push(at);
    Cubic { knots, points }
}

fn plus(a: Vec3, b: Vec3) -> Vec3 {
    Vec3::new(a.x + b.x, a.y + b.y, a.z + b.z)
}

fn minus(a: Vec3, b: Vec3) -> Vec3 {
    Vec3::new(a.x - b.x, a.y - b.y, a.z - b.z)
}

fn scaled(a: Vec3, by: f64) -> Vec3 {
    Vec3::new(a.x * by, a.y * by, a.z * by)
}

fn length(a: Vec3) -> f64 {
    (a.x * a.x + a.y * a.y + a.z * a.z).sqrt()
}

fn unit(a: Vec3) -> Option<Vec3> {
    let size = length(a);
    (size > 0.0 && size.is_finite()).then(|| scaled(a, 1.0 / size))
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn flat(places: &[(f64, f64)]) -> Vec<Vec3> {
        places.iter().map(|(x, y)| Vec3::new(*x, *y, 0.0)).collect()
    }

    #[test]
    fn two_places_are_a_line_and_one_is_nothing() {
        let line = through(&flat(&[(0.0, 0.0), (0.0, 0.0), (9.0, 3.0)]), false, [None; 2]).unwrap();
        assert_eq!(line.points.len(), 4);
        let near = |a: Vec3, x: f64, y: f64| assert!(length(minus(a, Vec3::new(x, y, 0.0))) < 1e-9);
        near(line.points[1], 3.0, 1.0);
        near(line.points[2], 6.0, 2.0);
        assert!(through(&flat(&[(1.0, 1.0), (1.0, 1.0)]), false, [None; 2]).is_none());
    }

    #[test]
    fn a_circle_is_met_square_to_its_radius_and_tangents_are_kept() {
        // Steps of equal chords on a circle: the derivatives are unit tangents nearly.
        let angles = (0..=36).map(|n| f64::from(n) * 10f64.to_radians());
        let round: Vec<Vec3> =
            angles.map(|a| Vec3::new(50.0 * a.cos(), 50.0 * a.sin(), 0.0)).collect();
        let circle = through(&round, true, [None; 2]).unwrap();
        for third in circle.points.chunks(3).take(36) {
            let [at, control, ..] = third else { panic!("three are wanted") };
            let turn = at.x * (control.x - at.x) + at.y * (control.y - at.y);
            assert!(turn.abs() < 1e-6, "the derivative is square to the radius: {turn}");
        }
        let up = Vec3::new(0.0, 5.0, 0.0);
        let bent = through(&flat(&[(0.0, 0.0), (10.0, 0.0)]), false, [Some(up), Some(up)]).unwrap();
        assert!((bent.points[1].y - 10.0 / 3.0).abs() < 1e-9 && bent.points[1].x.abs() < 1e-9);
    }
}
