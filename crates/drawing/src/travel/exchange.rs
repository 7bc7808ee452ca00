//! Changes of a tour, what they gain, and whether precedence allows them.
//!
//! ```text
//!  swap    … p [A A A] [B B] n …   ─►   … p [B B] [A A A] n …      both keep their direction
//!  turn    … p [A B C] n …         ─►   … p [C B A] n …
//!  shift   a stop goes elsewhere, and may be cut another way
//! ```
//!
//! Swapping neighbours is the exchange of three legs that keeps directions (Gambardella and Dorigo 2000,
//! for orders with precedence). Only swaps and turns with a new leg to a near stop are looked at.

use super::tour::Tour;

/// A change of a tour. Places are those of the order, ends included.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Exchange {
    /// The stops after `middle` come before those from `first` on.
    Swap { first: usize, middle: usize, last: usize },
    /// A part is run through backwards.
    Turn { first: usize, last: usize },
    /// A stop goes between the stop `after` and its next, cut this way.
    Shift { stop: usize, after: usize, way: usize },
}

/// Less is rounding, seconds.
pub(super) const LEAST_GAIN_S: f64 = 1e-9;
/// Stops at the end of a part that may end elsewhere although nothing near is there.
const SHORT: usize = 3;
/// Longer parts are not turned: it costs more than other changes do, and gains no more.
const LONGEST_TURN: usize = 100;

/// The change at a stop that gains most, and what it gains, seconds.
pub(super) fn best(tour: &Tour, near: &[Vec<usize>], stop: usize) -> Option<(f64, Exchange)> {
    let mut seeker = Seeker { tour, near, gain_s: LEAST_GAIN_S, best: None };
    let onward = tour.leg(stop, tour.next(stop));
    for other in &near[stop] {
        let saved = onward - tour.leg(stop, *other);
        if saved > 0.0 {
            seeker.swaps_forward(stop, *other, saved);
            seeker.swaps_back(stop, *other, saved);
            seeker.turn_to(stop, *other);
        }
        seeker.turn_from(stop, *other);
    }
    if stop != tour.site.home() {
        seeker.shifts(stop);
    }
    seeker.best.map(|exchange| (seeker.gain_s, exchange))
}

struct Seeker<'a, 'b> {
    tour: &'a Tour<'b>,
    near: &'a [Vec<usize>],
    gain_s: f64,
    best: Option<Exchange>,
}

impl Seeker<'_, '_> {
    fn offer(&mut self, gain_s: f64, exchange: Exchange) {
        if gain_s > self.gain_s && allowed(self.tour, &exchange) {
            (self.gain_s, self.best) = (gain_s, Some(exchange));
        }
    }

    fn swap(&mut self, first: usize, middle: usize, last: usize) {
        let gain = swap_gain(self.tour, first, middle, last);
        self.offer(gain, Exchange::Swap { first, middle, last });
    }

    /// Swaps after which `other`, now later, follows the stop. Of the three legs that come and go, the
    /// first two must gain: else the same swap is found from another of its stops.
    fn swaps_forward(&mut self, stop: usize, other: usize, saved: f64) {
        let tour = self.tour;
        let (first, second) = (tour.place(stop) + 1, tour.place(other));
        if second <= first {
            return;
        }
        let (middle, end) = (second - 1, tour.len() - 1);
        (second..=end.min(middle + SHORT)).for_each(|last| self.swap(first, middle, last));
        let saved = saved + tour.leg(tour.at(middle), other);
        for after in self.near[tour.at(middle)].iter().chain([&tour.site.home()]) {
            let last = if *after == tour.site.home() { end } else { tour.place(*after) - 1 };
            if last > middle && tour.leg(tour.at(middle), *after) < saved {
                self.swap(first, middle, last);
            }
        }
    }

    /// Swaps after which `other`, now earlier, follows the stop.
    fn swaps_back(&mut self, stop: usize, other: usize, saved: f64) {
        let tour = self.tour;
        let (first, last) = (tour.place(other), tour.place(stop));
        if first >= last {
            return;
        }
        (first..last.min(first + SHORT)).for_each(|middle| self.swap(first, middle, last));
        let before = tour.at(first - 1);
        let saved = saved + tour.leg(before, other);
        for next in &self.near[before] {
            let middle = tour.place(*next) - 1;
            if (first..last).contains(&middle) && tour.leg(before, *next) < saved {
                self.swap(first, middle, last);
            }
        }
    }

    /// The part from the stop's next to `other` is turned: `other` follows the stop.
    fn turn_to(&mut self, stop: usize, other: usize) {
        let (first, last) = (self.tour.place(stop) + 1, self.tour.place(other));
        if last > first && last - first < LONGEST_TURN {
            self.offer(turn_gain(self.tour, first, last), Exchange::Turn { first, last });
        }
    }

    /// The part from the stop to the one before `other` is turned: the stop comes before `other`.
    fn turn_from(&mut self, stop: usize, other: usize) {
        let (first, last) = (self.tour.place(stop), self.tour.place(other) - 1);
        if first > 0 && last > first && last - first < LONGEST_TURN {
            self.offer(turn_gain(self.tour, first, last), Exchange::Turn { first, last });
        }
    }

    /// The stop goes before or after each of its neighbours, cut the best way.
    fn shifts(&mut self, stop: usize) {
        let tour = self.tour;
        let (before, after) = (tour.previous(stop), tour.next(stop));
        let present = tour.through(before, stop, &tour.ends(stop), after);
        let freed = present - tour.leg(before, after);
        for other in &self.near[stop] {
            // No detour is shorter than none: what is freed is the most that can be gained.
            if freed <= self.gain_s {
                return;
            }
            for left in [*other, tour.previous(*other)] {
                if left != stop && left != before {
                    self.shift(stop, left, freed);
                }
            }
        }
    }

    fn shift(&mut self, stop: usize, after: usize, freed: f64) {
        let tour = self.tour;
        let next = tour.next(after);
        let freed = freed + tour.leg(after, next);
        if freed - tour.least_through(after, stop, next) <= self.gain_s {
            return;
        }
        for (way, ends) in tour.site.ways(stop).iter().enumerate() {
            let gain = freed - tour.through(after, stop, ends, next);
            self.offer(gain, Exchange::Shift { stop, after, way });
        }
    }
}

pub(super) fn swap_gain(tour: &Tour, first: usize, middle: usize, last: usize) -> f64 {
    let (p, a, b) = (tour.at(first - 1), tour.at(first), tour.at(middle));
    let (c, d, n) = (tour.at(middle + 1), tour.at(last), tour.at(last + 1));
    tour.leg(p, a) + tour.leg(b, c) + tour.leg(d, n)
        - tour.leg(p, c)
        - tour.leg(d, a)
        - tour.leg(b, n)
}

/// Returns the seconds that turning a part gains: only stops that may be turned are turned, so that the legs within
/// stay as long as they are.
fn turn_gain(tour: &Tour, first: usize, last: usize) -> f64 {
    let (p, a, b, n) = (tour.at(first - 1), tour.at(first), tour.at(last), tour.at(last + 1));
    let turned = [tour.ends(a), tour.ends(b)];
    let tools = |from: usize, to: usize| [tour.site.stop(from).tool, tour.site.stop(to).tool];
    tour.leg(p, a) + tour.leg(b, n)
        - tour.site.seconds(tour.ends(p).leave, turned[1].leave, tools(p, b))
        - tour.site.seconds(turned[0].enter, tour.ends(n).enter, tools(a, n))
}

/// Tells whether what lies inside still comes first.
pub(super) fn allowed(tour: &Tour, exchange: &Exchange) -> bool {
    match *exchange {
        Exchange::Swap { first, middle, last } => swap_allowed(tour, first, middle, last),
        Exchange::Turn { first, last } => turn_allowed(tour, first, last),
        Exchange::Shift { stop, after, .. } => {
            let [first, middle, last] = shift_as_swap(tour, stop, after);
            swap_allowed(tour, first, middle, last)
        }
    }
}

/// The swap that puts a stop after another one.
pub(super) fn shift_as_swap(tour: &Tour, stop: usize, after: usize) -> [usize; 3] {
    let (from, to) = (tour.place(stop), tour.place(after));
    if to > from { [from, from, to] } else { [to + 1, from - 1, from] }
}

/// Nothing of the first part may lie in something of the second. It is enough to look at direct parents:
/// who stands between two parts of a nest stands between them in the order too.
fn swap_allowed(tour: &Tour, first: usize, middle: usize, last: usize) -> bool {
    let site = tour.site;
    let within = |stop: &usize, from: usize, to: usize| (from..=to).contains(&tour.place(*stop));
    if middle - first <= last - middle {
        let mut parents = tour.part(first, middle).iter().filter_map(|n| site.stop(*n).parent);
        !parents.any(|parent| within(&parent, middle + 1, last))
    } else {
        let mut children = tour.part(middle + 1, last).iter().flat_map(|n| &site.stop(*n).children);
        !children.any(|child| within(child, first, middle))
    }
}

fn turn_allowed(tour: &Tour, first: usize, last: usize) -> bool {
    let free = |n: &usize| {
        let stop = tour.site.stop(*n);
        let waits = |parent: usize| (first..=last).contains(&tour.place(parent));
        stop.turnable && !stop.parent.is_some_and(waits)
    };
    tour.part(first, last).iter().all(free)
}
