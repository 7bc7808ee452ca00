//! Regions combined: union, intersection, difference, exclusive or.
//!
//! A region is a set of contours; what has an odd number of them around it belongs to it (so the
//! direction of contours does not matter). Every contour is cut where it meets another; each slice
//! knows by its left and right side whether the result lies there, and stays if it lies on exactly one.
//!
//! ```text
//!   A ┌─────────┐            slice   left right    union  A−B
//!     │    ┌────┼────┐       A in B  both both      –      yes, turned
//!     └────┼────┘  B │       A out   A    –         yes    yes
//!          └─────────┘       B in A  A+B  A         –      yes, turned
//! ```

use crate::stitch::{Strand, Turn, stitch};
use crate::{BoxTree, GeomError, Indexed, Point2, Polyarc, Segment, tol};

/// Ways to combine two regions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Combine {
    /// Places that belong to one or the other.
    Union,
    /// Places that belong to both.
    Intersection,
    /// Places that belong to the first and not to the second.
    Difference,
    /// Places that belong to exactly one.
    Xor,
}

impl Combine {
    fn holds(self, first: bool, second: bool) -> bool {
        match self {
            Self::Union => first || second,
            Self::Intersection => first && second,
            Self::Difference => first && !second,
            Self::Xor => first != second,
        }
    }
}

/// The boundary of the combined region: outer contours counter-clockwise, holes clockwise. Contours that
/// touch at a place come out as separate contours.
///
/// # Errors
/// Open contours, numbers that are not finite, and a boundary that does not close.
///
/// ```
/// use kerf_geom::{Combine, Point2, Polyarc, combine};
/// let square = Polyarc::rectangle(Point2::new(0.0, 0.0), Point2::new(10.0, 10.0));
/// let circle = Polyarc::circle(Point2::new(10.0, 5.0), 3.0);
/// let bitten = combine(&[square], &[circle], Combine::Difference)?;
/// let area: f64 = bitten.iter().map(Polyarc::signed_area).sum();
/// assert!((area - (100.0 - 4.5 * std::f64::consts::PI)).abs() < 1e-9);
/// # Ok::<(), kerf_geom::GeomError>(())
/// ```
pub fn combine(
    first: &[Polyarc],
    second: &[Polyarc],
    how: Combine,
) -> Result<Vec<Polyarc>, GeomError> {
    let contours = prepared(first.iter().chain(second))?;
    let (a, b) = contours.split_at(first.len());
    let regions = [Indexed::new(a), Indexed::new(b)];
    let odd = |region: &Indexed, place| region.winding(place) % 2 != 0;
    boundary(&contours, |at| how.holds(odd(&regions[0], at), odd(&regions[1], at)))
}

/// The boundary of what lies in an outer contour, one that runs counter-clockwise, and in no hole:
/// overlapping outer contours become one, holes are taken away wherever they lie. As [`combine`] gives it.
///
/// # Errors
/// As [`combine`].
pub fn outline(contours: &[Polyarc]) -> Result<Vec<Polyarc>, GeomError> {
    let contours = prepared(contours.iter())?;
    let outer = Indexed::new(contours.iter().filter(|contour| contour.signed_area() > 0.0));
    let holes = Indexed::new(contours.iter().filter(|contour| contour.signed_area() <= 0.0));
    boundary(&contours, |at| outer.winding(at) > 0 && holes.winding(at) == 0)
}

fn prepared<'a>(contours: impl Iterator<Item = &'a Polyarc>) -> Result<Vec<Polyarc>, GeomError> {
    let ready = |(contour, path): (usize, &Polyarc)| {
        path.check()?;
        if !path.closed {
            return Err(GeomError::Open { contour });
        }
        Ok(path.tidied().with_short_arcs())
    };
    contours.enumerate().map(ready).collect()
}

/// The boundary of the places that belong to a region whose edges lie on contours.
fn boundary(
    contours: &[Polyarc],
    belongs: impl Fn(Point2) -> bool,
) -> Result<Vec<Polyarc>, GeomError> {
    let mut kept = Vec::new();
    for slice in slices(contours) {
        kept.extend(oriented(slice, &belongs));
    }
    let strands: Vec<Strand> = kept.iter().map(strand).collect();
    // The result lies to the left; turning left where there is a choice parts what only touches.
    let stitched = stitch(&strands, Turn::Left, false);
    let loops = stitched.loops.iter().filter_map(|way| contour(way, &kept)).collect();
    match stitched.open.first().and_then(|way| way.first()) {
        Some(&loose) if kept[loose].length() > LOOSE_MM => {
            Err(GeomError::Unclosed { at: kept[loose].at(0.5) })
        }
        _ => Ok(loops),
    }
}

/// Distance to the side of a slice at which its regions are asked for: contours nearer to each other than this
/// are not told apart.
const ASIDE_MM: f64 = 10.0 * tol::SAME_PLACE_MM;

/// A left-over strand shorter than this is where contours all but coincide, not a missing boundary.
const LOOSE_MM: f64 = 1e-4;

/// All contours cut where they meet each other or themselves.
fn slices(contours: &[Polyarc]) -> Vec<Segment> {
    let segments: Vec<Segment> = contours.iter().flat_map(Polyarc::segments).collect();
    let boxes = segments.iter().map(|s| s.bounds().grown(tol::CONTACT_MM));
    let tree = BoxTree::new(boxes);
    let mut cuts: Vec<(usize, f64)> = Vec::new();
    tree.own_pairs(|a, b| {
        for c in segments[a].meet(&segments[b]).iter() {
            cuts.extend([(a, c.on_first), (b, c.on_second)]);
        }
    });
    cuts.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let mut next = 0;
    let mut slices = Vec::with_capacity(segments.len() + cuts.len());
    for (number, segment) in segments.iter().enumerate() {
        let own = cuts[next..].iter().take_while(|c| c.0 == number).count();
        let shares = cuts[next..next + own].iter().map(|c| c.1).chain([1.0]);
        next += own;
        let mut from = 0.0;
        for share in shares {
            if (share - from) * segment.length() > tol::SAME_PLACE_MM {
                slices.push(segment.part(from, share));
                from = share;
            }
        }
    }
    slices
}

/// A slice with the result on its left; nothing when the result lies on both sides or on none.
fn oriented(slice: Segment, holds: impl Fn(Point2) -> bool) -> Option<Segment> {
    let (middle, along) = (slice.at(0.5), slice.direction(0.5));
    let aside = ASIDE_MM.min(slice.length() * 0.1);
    match (holds(middle + along.left() * aside), holds(middle - along.left() * aside)) {
        (true, false) => Some(slice),
        (false, true) => Some(slice.reversed()),
        _ => None,
    }
}

fn strand(segment: &Segment) -> Strand {
    let (start, end, middle) = (segment.start(), segment.end(), segment.at(0.5));
    let look = (1e-3 / segment.length()).min(1.0);
    let leaves = (segment.at(look) - start).normalized().unwrap_or_default();
    Strand { start, end, middle, leaves, arrives: segment.direction(1.0), sure: true }
}

/// A closed contour of slices, stretches of one line or circle made one; nothing when it encloses nothing.
fn contour(way: &[usize], kept: &[Segment]) -> Option<Polyarc> {
    let segments: Vec<Segment> = way.iter().map(|&k| kept[k]).collect();
    let path = Polyarc::from_segments(&segments, true).merged();
    let thin = path.signed_area().abs() <= path.length() * tol::SAME_PLACE_MM;
    (!thin).then_some(path)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    fn p(x: f64, y: f64) -> Point2 {
        Point2::new(x, y)
    }

    fn square(x: f64, y: f64, side: f64) -> Polyarc {
        Polyarc::rectangle(p(x, y), p(x + side, y + side))
    }

    fn check(a: &[Polyarc], b: &[Polyarc], expected: [(usize, f64); 4]) {
        let hows = [Combine::Union, Combine::Intersection, Combine::Difference, Combine::Xor];
        for (how, (count, area)) in hows.into_iter().zip(expected) {
            let turned: Vec<Polyarc> = b.iter().map(Polyarc::reversed).collect();
            for b in [b, &turned] {
                let found = combine(a, b, how).expect("a region");
                let sum: f64 = found.iter().map(Polyarc::signed_area).sum();
                assert!(
                    (sum - area).abs() < 1e-6 && found.len() == count,
                    "{how:?} {sum} {found:?}"
                );
            }
        }
    }

    #[test]
    fn overlapping_touching_nested_equal() {
        let a = [square(0., 0., 10.)];
        check(&a, &[square(5., 5., 10.)], [(1, 175.), (1, 25.), (1, 75.), (2, 150.)]);
        check(&a, &[square(10., 0., 10.)], [(1, 200.), (0, 0.), (1, 100.), (1, 200.)]);
        check(&a, &[square(10., 10., 10.)], [(2, 200.), (0, 0.), (1, 100.), (2, 200.)]);
        check(&a, &[square(2., 2., 3.)], [(1, 100.), (1, 9.), (2, 91.), (2, 91.)]);
        check(&a, &[square(0., 0., 10.)], [(1, 100.), (1, 100.), (0, 0.), (0, 0.)]);
        check(&a, &[square(0., 2., 5.)], [(1, 100.), (1, 25.), (1, 75.), (1, 75.)]);
        check(&a, &[square(30., 2., 5.)], [(2, 125.), (0, 0.), (1, 100.), (2, 125.)]);
        check(&a, &[], [(1, 100.), (0, 0.), (1, 100.), (1, 100.)]);
    }

    #[test]
    fn arcs_on_the_same_circle() {
        let a = [Polyarc::circle(p(0., 0.), 5.)];
        let half =
            Polyarc::closed(vec![crate::Vertex::new(5., 0., 1.), crate::Vertex::new(-5., 0., 0.)]);
        check(&a, &[half], [(1, 25. * PI), (1, 12.5 * PI), (1, 12.5 * PI), (1, 12.5 * PI)]);
        let inner = Polyarc::circle(p(2., 0.), 3.);
        check(&a, &[inner], [(1, 25. * PI), (1, 9. * PI), (1, 16. * PI), (1, 16. * PI)]);
    }

    #[test]
    fn holes_stay_holes() {
        let ring = [Polyarc::circle(p(0., 0.), 10.), Polyarc::circle(p(0., 0.), 5.)];
        let found =
            combine(&ring, &[square(0., -20., 40.)], Combine::Difference).expect("a region");
        let area: f64 = found.iter().map(Polyarc::signed_area).sum();
        assert!((area - 37.5 * PI).abs() < 1e-9 && found.len() == 1);
    }

    #[test]
    fn an_outline_joins_what_overlaps_and_takes_holes_away() {
        let hole = square(8., -5., 20.).reversed();
        let found = outline(&[square(0., 0., 10.), square(5., 5., 10.), hole]).expect("a region");
        let sum: f64 = found.iter().map(Polyarc::signed_area).sum();
        assert!((sum - (80. + 15.)).abs() < 1e-9 && found.len() == 1, "{sum} {found:?}");
    }

    #[test]
    fn open_contours_are_refused() {
        let open = Polyarc::lines([p(0., 0.), p(1., 0.)], false);
        let refused = combine(&[square(0., 0., 1.)], &[open], Combine::Union);
        assert_eq!(refused, Err(GeomError::Open { contour: 1 }));
    }
}
