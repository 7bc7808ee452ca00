//! The order of cutting with the least time between the cuts.
//!
//! ```text
//!  Drawing ─► Site: a Stop a shape, ─► first tour ─► improve ─► ways ─► polish ─► Trip
//!             the Ways to cut it       (nearest)     (local     (best  (exact places
//!                                                     search)   places) of contours)
//!                                 up to 12 stops: exact, by subsets
//! ```
//!
//! What is sought is a round trip from a place through every shape and back: seconds of rapids with
//! acceleration, of lifts and of tool changes. What lies within a closed shape is cut before it, always. A
//! closed shape may be entered anywhere when starts may move, an open one at either end when turning it
//! changes nothing but the direction. The problem is the travelling salesman's with neighbourhoods and
//! precedence; nothing that is tried makes a tour longer, so more tries are never worse.
//!
//! No clock and no chance: the same drawing gives the same order. How long is searched is told as a number
//! of tries.

mod dice;
mod exact;
mod exchange;
mod first;
mod improve;
mod map;
mod near;
mod polish;
mod rapids;
mod search;
mod site;
mod tour;
mod ways;

pub use rapids::{Rapids, Travelled};
pub use search::Search;

use crate::Drawing;
use kerf_geom::Point2;
use site::Site;
use tour::Tour;

/// Up to so many shapes every order is compared.
pub const EXACT_STOPS: usize = 12;

/// An order of cutting.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Trip {
    /// The shapes of the groups that are on, in the order of cutting.
    pub order: Vec<usize>,
    /// New starts of shapes; the others begin where they did.
    pub starts: Vec<(usize, Point2)>,
}

/// The fewest and the most tries when nothing is said, up to 1,000 shapes: the most take about a second for
/// these.
const TRIES: (u32, u32) = (2_000, 8_000);
/// Tries for each shape when nothing is said.
const TRIES_PER_STOP: u32 = 100;
/// A try takes longer with more shapes: tries times shapes are no more than this.
const MOST_WORK: u32 = 8_000_000;

/// Seeks the trip with the least time between the cuts.
pub(crate) fn trip(drawing: &Drawing, search: &Search) -> Trip {
    let site = Site::of(drawing, search);
    let mut tour = if site.stops() <= EXACT_STOPS {
        exact::tour(&site)
    } else {
        let mut tour = first::tour(&site);
        ways::choose(&mut tour);
        match search.tries.unwrap_or_else(|| deserved(site.stops())) {
            0 => {}
            tries => improve::improve(&mut tour, tries),
        }
        ways::choose(&mut tour);
        tour
    };
    polish::polish(&mut tour, drawing);
    told(&tour)
}

/// Returns the number of tries that so many shapes deserve.
fn deserved(stops: usize) -> u32 {
    let stops = u32::try_from(stops).unwrap_or(u32::MAX).max(1);
    stops.saturating_mul(TRIES_PER_STOP).clamp(TRIES.0, TRIES.1).min(MOST_WORK / stops)
}

fn told(tour: &Tour) -> Trip {
    let site = tour.site;
    let order = tour.shapes().map(|stop| site.shape(stop)).collect();
    let starts = tour.shapes().filter(|stop| site.is_free(*stop));
    Trip { order, starts: starts.map(|stop| (site.shape(stop), tour.ends(stop).enter)).collect() }
}

/// Measures how far and how long the head travels between the cuts of a drawing as it is, from a place and back.
pub fn travelled(drawing: &Drawing, from: Point2, rapids: &Rapids) -> Travelled {
    let cut = drawing.shapes.iter().filter(|shape| drawing.settings(shape.group).on);
    let mut sum = Travelled::default();
    let (mut at, mut tool) = (from, None);
    for shape in cut {
        let next = drawing.settings(shape.group).tool;
        let leave =
            if shape.is_closed() { shape.start() } else { shape.path.end().unwrap_or_default() };
        sum.leg(rapids, at.distance(shape.start()), tool.is_some_and(|tool| tool != next));
        sum.lifts(rapids);
        (at, tool) = (leave, Some(next));
    }
    sum.leg(rapids, at.distance(from), false);
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Shape;
    use kerf_geom::Polyarc;

    /// Circles and places with `few` shapes, which both the exact way and the search can do.
    fn random(few: usize, seed: u64) -> Drawing {
        let mut dice = dice::Dice::new(seed);
        let mut place = |wide| dice.below(wide) as f64;
        let circle = |at, radius| Shape::flat(Polyarc::circle(at, radius));
        Drawing::of((0..few).map(|n| {
            let at = Point2::new(place(300), place(300));
            if n % 3 == 0 { Shape::point(at) } else { circle(at, 4.0 + place(20)) }
        }))
    }

    #[test]
    fn many_shapes_are_not_searched_for_ever() {
        let all = [13, 1000, 20_000, 1_000_000, usize::MAX].map(deserved);
        assert_eq!(all, [2000, 8000, 400, 8, 0]);
    }

    /// The search finds the best tour of few shapes nearly always, although it does not compare all.
    #[test]
    fn the_search_is_as_good_as_the_exact_way() {
        let found = (0..40).filter(|seed| {
            let search = Search { starts: true, ..Search::default() };
            let drawing = random(9, *seed);
            let site = Site::of(&drawing, &search);
            let mut tour = first::tour(&site);
            improve::improve(&mut tour, 2000);
            ways::choose(&mut tour);
            tour.seconds() <= exact::tour(&site).seconds() + 1e-9
        });
        let found = found.count();
        assert!(found >= 38, "{found} of 40");
    }
}
