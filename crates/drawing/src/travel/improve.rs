//! Local search, kicked again and again.
//!
//! A tour that no change of [`super::exchange`] makes shorter gets two random neighbouring parts swapped,
//! is improved again around them, and is kept if it is no longer than before (iterated local search; the
//! segments are short, as in Johnson and McGeoch's chapter on the travelling salesman, so that a kick is
//! repaired nearby).

use super::dice::Dice;
use super::exchange::{Exchange, LEAST_GAIN_S, allowed, best, shift_as_swap, swap_gain};
use super::near::neighbours;
use super::tour::Tour;

/// The longest part that a kick swaps.
const LONGEST_KICK: usize = 30;
/// Seed of the numbers without pattern; any will do.
const SEED: u64 = 4;

/// Makes a tour shorter by so many tries.
pub(super) fn improve(tour: &mut Tour, tries: u32) {
    let stops = tour.len();
    let mut search = Search {
        near: neighbours(tour.site),
        kept: tour.part(0, stops - 1).to_vec(),
        tour,
        queue: Vec::new(),
        queued: vec![false; stops],
        ways: Vec::new(),
        touched: None,
        gained_s: 0.0,
    };
    (0..stops).rev().for_each(|stop| search.look_at(stop));
    search.descend();
    search.keep();
    let mut dice = Dice::new(SEED);
    for _ in 0..tries {
        search.attempt(&mut dice);
    }
}

struct Search<'a, 'b> {
    tour: &'a mut Tour<'b>,
    near: Vec<Vec<usize>>,
    /// Stops round which something has changed.
    queue: Vec<usize>,
    queued: Vec<bool>,
    /// The order to return to.
    kept: Vec<usize>,
    /// The ways to return to, latest last.
    ways: Vec<(usize, usize)>,
    /// The part of the order that is not as it was kept.
    touched: Option<(usize, usize)>,
    /// Seconds since it was kept.
    gained_s: f64,
}

impl Search<'_, '_> {
    fn attempt(&mut self, dice: &mut Dice) {
        if !self.kick(dice) {
            return;
        }
        self.descend();
        if self.gained_s >= 0.0 { self.keep() } else { self.give_back() }
    }

    /// Swaps two neighbouring parts at random, and two more nearby: one swap alone would be found and
    /// taken back. Nothing if precedence forbids it.
    fn kick(&mut self, dice: &mut Dice) -> bool {
        let stops = self.tour.len();
        let first = 1 + dice.below(stops - 1);
        let longest = LONGEST_KICK.min(stops / 3).max(1);
        let near = (first + dice.below(2 * longest)).saturating_sub(longest).max(1);
        let kicked = self.swap_at(first, longest, dice);
        let kicked = self.swap_at(near, longest, dice) || kicked;
        self.cut_otherwise(first, dice) || kicked
    }

    /// Takes any way through the stop at a place.
    fn cut_otherwise(&mut self, place: usize, dice: &mut Dice) -> bool {
        let tour = &*self.tour;
        let stop = tour.at(place);
        let ways = tour.site.ways(stop);
        let (before, after, way) = (tour.previous(stop), tour.next(stop), dice.below(ways.len()));
        if way == tour.way(stop) {
            return false;
        }
        self.gained_s += tour.through(before, stop, &tour.ends(stop), after)
            - tour.through(before, stop, &ways[way], after);
        self.set_way(stop, way);
        [before, after].into_iter().for_each(|stop| self.look_at(stop));
        true
    }

    fn swap_at(&mut self, first: usize, longest: usize, dice: &mut Dice) -> bool {
        let middle = first + dice.below(longest);
        let last = middle + 1 + dice.below(longest);
        let exchange = Exchange::Swap { first, middle, last };
        if last >= self.tour.len() || !allowed(self.tour, &exchange) {
            return false;
        }
        let gain = swap_gain(self.tour, first, middle, last);
        self.make(gain, exchange);
        true
    }

    /// Makes changes until none gains anything.
    fn descend(&mut self) {
        while let Some(stop) = self.queue.pop() {
            self.queued[stop] = false;
            self.choose_way(stop);
            if let Some((gain, exchange)) = best(self.tour, &self.near, stop) {
                self.make(gain, exchange);
                self.look_at(stop);
            }
        }
    }

    fn make(&mut self, gain_s: f64, exchange: Exchange) {
        self.gained_s += gain_s;
        match exchange {
            Exchange::Swap { first, middle, last } => self.swap(first, middle, last),
            Exchange::Turn { first, last } => self.turn(first, last),
            Exchange::Shift { stop, after, way } => {
                let [first, middle, last] = shift_as_swap(self.tour, stop, after);
                self.swap(first, middle, last);
                self.set_way(stop, way);
            }
        }
    }

    fn swap(&mut self, first: usize, middle: usize, last: usize) {
        let joints = [first - 1, first, middle, middle + 1, last, last + 1];
        joints.into_iter().for_each(|place| self.look_at(self.tour.at(place)));
        self.tour.swap(first, middle, last);
        self.touch(first, last);
    }

    fn turn(&mut self, first: usize, last: usize) {
        let joints = [first - 1, first, last, last + 1];
        joints.into_iter().for_each(|place| self.look_at(self.tour.at(place)));
        for place in first..=last {
            let stop = self.tour.at(place);
            // The two ways of an open shape are its directions.
            let ends = self.tour.ends(stop);
            if ends.enter != ends.leave && self.tour.site.ways(stop).len() == 2 {
                self.set_way(stop, 1 - self.tour.way(stop));
            }
        }
        self.tour.turn(first, last);
        self.touch(first, last);
    }

    /// Takes the best way through a stop where it stands.
    fn choose_way(&mut self, stop: usize) {
        let tour = &*self.tour;
        if tour.site.ways(stop).len() < 2 {
            return;
        }
        let (before, after) = (tour.previous(stop), tour.next(stop));
        let present = tour.through(before, stop, &tour.ends(stop), after);
        let mut least = (present - LEAST_GAIN_S, None);
        for (n, way) in tour.site.ways(stop).iter().enumerate() {
            let seconds = tour.through(before, stop, way, after);
            if seconds < least.0 {
                least = (seconds, Some(n));
            }
        }
        if let (seconds, Some(way)) = least {
            self.gained_s += present - seconds;
            self.set_way(stop, way);
            self.look_at(before);
            self.look_at(after);
        }
    }

    fn set_way(&mut self, stop: usize, way: usize) {
        self.ways.push((stop, self.tour.way(stop)));
        self.tour.set_way(stop, way);
    }

    fn look_at(&mut self, stop: usize) {
        if !std::mem::replace(&mut self.queued[stop], true) {
            self.queue.push(stop);
        }
    }

    fn touch(&mut self, first: usize, last: usize) {
        let (from, to) = self.touched.unwrap_or((first, last));
        self.touched = Some((from.min(first), to.max(last)));
    }

    fn keep(&mut self) {
        if let Some((from, to)) = self.touched.take() {
            self.kept[from..=to].copy_from_slice(self.tour.part(from, to));
        }
        self.ways.clear();
        self.gained_s = 0.0;
    }

    fn give_back(&mut self) {
        if let Some((from, to)) = self.touched.take() {
            self.tour.refill(from, &self.kept[from..=to]);
        }
        while let Some((stop, way)) = self.ways.pop() {
            self.tour.set_way(stop, way);
        }
        self.gained_s = 0.0;
    }
}
