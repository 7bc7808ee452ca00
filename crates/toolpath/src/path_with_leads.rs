//! Closed paths with leads, as they stand in a job: one open path that touches itself where the leads meet it.
//!
//! ```text
//!           ┌───────────┐
//!           │           │        lead-in, then all round from P to P, then lead-out
//!           │           │
//!      in ╲ │           │
//!          ╲P───────────┘
//!           ╲ out
//! ```
//!
//! The path beside such a one is the closed path beside its closed part, with the same leads at its start.

use crate::lead::with_leads;
use kerf_geom::{Polyarc, Segment, Transform2, Vec2, tol};

/// The most segments of a lead: an arc of more than half a turn has two.
const LONGEST_LEAD: usize = 2;

/// Greatest deviation of leads from tangential, radians: they are drawn exactly and then written with digits.
const TANGENT_RAD: f64 = 1e-4;

/// A closed path, and the leads that come to it and go away from it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Led {
    pub closed: Polyarc,
    lead_in: Option<Polyarc>,
    lead_out: Option<Polyarc>,
}

/// The closed path in an open one that is nothing but this and its leads.
pub(crate) fn with_leads_of(path: &Polyarc) -> Option<Led> {
    let last = path.vertices.len().checked_sub(1).filter(|_| !path.closed)?;
    let ends = |before: usize| {
        (last.saturating_sub(LONGEST_LEAD)..=last).map(move |after| (before, after))
    };
    let splits = (0..=LONGEST_LEAD.min(last)).rev().flat_map(ends);
    // The longest leads first: those of a corner may end where they began.
    splits
        .filter(|split| *split != (0, last))
        .find_map(|(before, after)| split(path, before, after))
}

fn split(path: &Polyarc, before: usize, after: usize) -> Option<Led> {
    let (all, last) = (&path.vertices, path.vertices.len() - 1);
    if after < before + 2 || all[before].at.distance(all[after].at) > tol::SAME_PLACE_MM {
        return None;
    }
    let closed = Polyarc { vertices: all[before..after].to_vec(), closed: true };
    let lead_in = (before > 0).then(|| Polyarc::open(all[..=before].to_vec()));
    let lead_out = (after < last).then(|| Polyarc::open(all[after..].to_vec()));
    let comes = lead_in.as_ref().is_none_or(|lead| is_lead(lead) && meets(lead, &closed));
    let goes = lead_out.as_ref().is_none_or(|lead| is_lead(lead) && meets(&closed, lead));
    (comes && goes).then_some(Led { closed, lead_in, lead_out })
}

/// Returns `true` if a path is one arc.
fn is_lead(path: &Polyarc) -> bool {
    let mut arcs = path.segments().map(|segment| match segment {
        Segment::Arc { centre, .. } => Some(centre),
        Segment::Line { .. } => None,
    });
    let first = arcs.next().flatten();
    let same = |centre: Option<_>| {
        centre.zip(first).is_some_and(|(a, b): (kerf_geom::Point2, _)| a.distance(b) < 1e-3)
    };
    first.is_some() && arcs.all(same)
}

/// Returns `true` if one path goes on in the direction in which another ends.
fn meets(path: &Polyarc, next: &Polyarc) -> bool {
    let (end, start) = (end_of(path), start_of(next));
    end.cross(start).atan2(end.dot(start)).abs() < TANGENT_RAD
}

fn start_of(path: &Polyarc) -> Vec2 {
    path.segment(0).direction(0.0)
}

fn end_of(path: &Polyarc) -> Vec2 {
    path.segment(path.segment_count() - 1).direction(1.0)
}

impl Led {
    /// Another closed path with these leads at its start.
    pub fn again(&self, ring: &Polyarc) -> Polyarc {
        let (Some(from), Some(to)) = (self.closed.start(), ring.start()) else {
            return ring.clone();
        };
        let laid = |lead: &Polyarc, old: Vec2, new: Vec2| {
            let turn = old.cross(new).atan2(old.dot(new));
            lead.similar(&Transform2::turned(from, turn).then(&Transform2::moved(to - from)))
        };
        let lead_in =
            self.lead_in.as_ref().map(|lead| laid(lead, start_of(&self.closed), start_of(ring)));
        let lead_out =
            self.lead_out.as_ref().map(|lead| laid(lead, end_of(&self.closed), end_of(ring)));
        with_leads(ring, lead_in, lead_out)
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use crate::{job, offset_job};
    use kerf_drawing::{Editor, script};
    use kerf_geom::{Point2, Polyarc};
    use std::sync::Arc;

    /// Returns the paths that are cut of the clauses when the whole job is offset.
    fn offset(clauses: &str, by_mm: f64) -> Vec<Arc<Polyarc>> {
        let mut editor = Editor::default();
        for (_, op) in script(clauses).unwrap() {
            editor.apply(&op).unwrap();
        }
        let (job, _) = job(&editor.drawing).unwrap();
        let beside = offset_job(&job.machine_job("".into()), by_mm).unwrap();
        beside.shapes.iter().map(|shape| shape.path.clone()).collect()
    }

    /// A job that is offset is the job of a drawing whose groups have so much more offset.
    #[track_caller]
    fn check(shape: &str, settings: &str, by_mm: f64) {
        let found = offset(&format!("{shape}; set black {settings}"), by_mm);
        let made = offset(&format!("{shape}; set black offset={by_mm} {settings}"), 0.0);
        assert_eq!(found.len(), made.len());
        for (found, made) in found.iter().zip(&made) {
            let far = |a: &Polyarc, b: &Polyarc| {
                let places =
                    a.segments().flat_map(|s| [0.0, 0.3, 0.7, 1.0].map(|share| s.at(share)));
                places.map(|at| b.nearest(at).map_or(f64::MAX, |(_, far)| far)).fold(0.0, f64::max)
            };
            assert!((found.length() - made.length()).abs() < 1e-6, "{found:?}\n{made:?}");
            assert!(far(found, made) < 1e-6 && far(made, found) < 1e-6, "{found:?}\n{made:?}");
            let ends = |path: &Polyarc| [path.start(), path.end()].map(Option::unwrap);
            let apart = |n: usize| Point2::distance(ends(found)[n], ends(made)[n]);
            assert!(apart(0) < 1e-6 && apart(1) < 1e-6);
        }
    }

    #[test]
    fn closed_paths_keep_their_leads_beside_themselves() {
        let square = "rect 10,10 100,100";
        for shape in [square, "circle 50,50 40", "line 0,0 80,10,0.5 40,60 close"] {
            for leads in [
                "lead-in=5,90 lead-out=5,90",
                "lead-in=5,90",
                "lead-out=5,270",
                "lead-in=3,200 lead-out=2,45",
            ] {
                for by_mm in [1.0, 3.0] {
                    check(shape, leads, by_mm);
                }
            }
        }
        // Leads on the left.
        check(square, "lead-in=-5,90 lead-out=-5,90", 2.0);
    }

    #[test]
    fn leads_stay_on_their_side_when_a_job_is_offset_to_the_other() {
        let square = "rect 10,10 100,100; set black lead-in=5,90 lead-out=5,90";
        let [path] = offset(square, -2.0).try_into().unwrap();
        let core: f64 = 4.0 * 86.0;
        let leads = 2.0 * 5.0 * std::f64::consts::FRAC_PI_2;
        assert!((path.length() - core - leads).abs() < 1e-6, "{path:?}");
        // They begin and end on the right, outside.
        assert!(path.start().unwrap().y < 12.0 && path.end().unwrap().x < 12.0, "{path:?}");
    }

    #[test]
    fn a_closed_path_with_a_stem_that_is_no_lead_has_none() {
        let stem = Polyarc::lines(
            [(0.0, 0.0), (10.0, 0.0), (20.0, 0.0), (20.0, 9.0), (10.0, 0.0)]
                .map(|(x, y)| Point2::new(x, y)),
            false,
        );
        assert_eq!(super::with_leads_of(&stem), None);
    }
}
