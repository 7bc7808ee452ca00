//! Stretches of one line or one circle made one segment again.

use super::Polyarc;
use crate::{Segment, tol};

impl Polyarc {
    /// The same path with as few vertices as it needs: neighbours on one line, or on one circle and
    /// together no more than half of it, become one. The start of a closed path may move.
    #[must_use]
    pub fn merged(&self) -> Self {
        let mut segments: Vec<Segment> = Vec::with_capacity(self.segment_count());
        for segment in self.segments() {
            match segments.last().and_then(|last| one(last, &segment)) {
                Some(both) => {
                    segments.pop();
                    segments.push(both);
                }
                None => segments.push(segment),
            }
        }
        if let (true, [first, .., last]) = (self.closed, segments.as_slice())
            && segments.len() > 2
            && let Some(both) = one(last, first)
        {
            segments[0] = both;
            segments.pop();
        }
        if segments.is_empty() { self.clone() } else { Self::from_segments(&segments, self.closed) }
    }
}

/// The one segment that two are parts of, if they are: what lies between its ends passes the joint
/// within [`tol::CONTACT_MM`].
fn one(first: &Segment, second: &Segment) -> Option<Segment> {
    let (start, joint, end) = (first.start(), first.end(), second.end());
    let near = |s: &Segment| s.distance(joint) <= tol::CONTACT_MM;
    match (first, second) {
        (Segment::Line { .. }, Segment::Line { .. }) => {
            let both = Segment::line(start, end);
            let onward = first.direction(0.0).dot(second.direction(0.0)) > 0.0;
            (onward && near(&both)).then_some(both)
        }
        (
            Segment::Arc { centre: c, radius: r, sweep_rad: a, .. },
            Segment::Arc { centre: d, radius: s, sweep_rad: b, .. },
        ) => {
            let circle = c.distance(*d) <= tol::CONTACT_MM && (r - s).abs() <= tol::CONTACT_MM;
            let half = (a + b).abs() <= std::f64::consts::PI + 1e-9;
            let both = Segment::bulged(start, end, (0.25 * (a + b)).tan());
            (circle && half && a * b > 0.0 && near(&both)).then_some(both)
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Point2;

    #[test]
    fn what_was_split_is_whole_again() {
        let shape = Polyarc::rounded_rectangle(Point2::new(0., 0.), Point2::new(60., 20.), 4.0);
        let mut split = shape.clone();
        for k in 1..9 {
            let place = split.place_after(f64::from(k) * 15.3).expect("a place");
            split = split.with_vertex_at(&place).0;
        }
        assert!(split.vertices.len() > shape.vertices.len() + 6);
        let merged = split.merged();
        assert_eq!(merged.vertices.len(), shape.vertices.len());
        assert!((merged.signed_area() - shape.signed_area()).abs() < 1e-9);
        let circle = Polyarc::circle(Point2::new(0., 0.), 5.0);
        assert_eq!(circle.merged().vertices.len(), 2);
    }
}
