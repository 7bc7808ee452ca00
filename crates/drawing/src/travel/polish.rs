//! The best places of all, not only those that were tried: closed contours are entered wherever the way
//! from the cut before and to the next one is least.

use super::site::CutEnds;
use super::tour::Tour;
use crate::Drawing;
use kerf_geom::{Point2, Segment};

/// Number of times that all contours are gone over; each time only gains.
const ROUNDS: usize = 8;
/// Steps of the search within a segment: the width shrinks by the golden section each time.
const STEPS: usize = 40;
/// Less than this is no reason to leave a vertex, seconds.
const WORTH_S: f64 = 1e-6;
/// (√5 − 1) / 2.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

pub(super) fn polish(tour: &mut Tour, drawing: &Drawing) {
    let stops: Vec<usize> = tour.shapes().filter(|n| tour.site.stop(*n).free).collect();
    for _ in 0..ROUNDS {
        let mut gained = 0.0;
        for stop in &stops {
            let shape = &drawing.shapes[tour.site.shape(*stop)];
            gained += settle(tour, *stop, shape.path.segments());
        }
        if gained < WORTH_S {
            break;
        }
    }
}

/// Lets a contour begin where the legs before and after it are least. Returns the seconds gained.
fn settle(tour: &mut Tour, stop: usize, segments: impl Iterator<Item = Segment>) -> f64 {
    let (before, after) = (tour.previous(stop), tour.next(stop));
    let through =
        |place: Point2| tour.through(before, stop, &CutEnds { enter: place, leave: place }, after);
    let present = through(tour.ends(stop).enter);
    let (mut least, mut found) = (present - WORTH_S, None);
    for segment in segments {
        for place in [segment.start(), best_of(&segment, &through)] {
            let seconds = through(place);
            if seconds < least {
                (least, found) = (seconds - WORTH_S, Some(place));
            }
        }
    }
    let Some(place) = found else { return 0.0 };
    let gained = present - through(place);
    tour.set_ends(stop, CutEnds { enter: place, leave: place });
    gained
}

/// The place of a segment from which a sum of two legs is least, by the golden section: along a line the sum
/// of two distances has one valley.
fn best_of(segment: &Segment, seconds: &impl Fn(Point2) -> f64) -> Point2 {
    let (mut low, mut high) = (0.0, 1.0);
    let inner = |low: f64, high: f64| (high - GOLDEN * (high - low), low + GOLDEN * (high - low));
    let (mut a, mut b) = inner(low, high);
    let (mut at_a, mut at_b) = (seconds(segment.at(a)), seconds(segment.at(b)));
    for _ in 0..STEPS {
        if at_a <= at_b {
            (high, b, at_b) = (b, a, at_a);
            a = inner(low, high).0;
            at_a = seconds(segment.at(a));
        } else {
            (low, a, at_a) = (a, b, at_b);
            b = inner(low, high).1;
            at_b = seconds(segment.at(b));
        }
    }
    segment.at(0.5 * (low + high))
}
