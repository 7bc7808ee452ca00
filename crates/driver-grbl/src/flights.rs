//! Orders that were handed to the controller and are not done.
//!
//! A move leaves the planner when the last of it is cut into step segments, which is a moment before the
//! last step: [`SEGMENTS_S`].

use kerf_machine::driver::{Axes, Order, Sent, Ticket, way_mm};
use std::collections::VecDeque;

/// Longest duration of the row of step segments, seconds: six segments of 10 ms, and some of it for the
/// line.
const SEGMENTS_S: f64 = 0.1;

/// Orders that are done and kept in mind.
const KEPT: usize = 32;

/// An order under way.
#[derive(Clone, Copy, Debug)]
pub struct Flight {
    /// The order.
    pub sent: Sent,
    /// Place where it begins.
    pub from: Axes,
    /// Moves that the planner makes of it.
    pub blocks: usize,
    /// Lines of it that are not answered.
    pub lines: usize,
    /// Since when it is out of the planner.
    cut_s: Option<f64>,
}

/// All of them, the oldest first.
#[derive(Clone, Debug, Default)]
pub struct Flights {
    open: VecDeque<Flight>,
    /// Those that were done last: reports come late now and then, and tell a place on one of them.
    made: VecDeque<Flight>,
}

impl Flights {
    /// One more.
    pub fn push(&mut self, sent: Sent, from: Axes, blocks: usize, lines: usize) {
        self.open.push_back(Flight { sent, from, blocks, lines, cut_s: None });
    }

    /// A line of an order was answered with `ok`; tells whether all of it was.
    pub fn answered(&mut self, ticket: Ticket) -> bool {
        let flight = self.open.iter_mut().find(|flight| flight.sent.ticket == ticket);
        flight.is_some_and(|flight| {
            flight.lines = flight.lines.saturating_sub(1);
            flight.lines == 0
        })
    }

    /// Returns `true` if an order is a move.
    pub fn moves(&self, ticket: Ticket) -> bool {
        let is_move = |order| matches!(order, Order::Move { .. } | Order::Jog { .. });
        let moves = |flight: &Flight| is_move(flight.sent.order);
        self.open.iter().any(|flight| flight.sent.ticket == ticket && moves(flight))
    }

    /// Returns the orders of which lines are not answered.
    pub fn unanswered(&self) -> impl Iterator<Item = &Flight> {
        self.open.iter().filter(|flight| flight.lines > 0)
    }

    /// Returns the last order that was answered, and its end where it is a move.
    pub fn answered_end(&self) -> Option<(Ticket, Axes)> {
        let last = self.open.iter().rfind(|flight| flight.lines == 0)?;
        Some((last.sent.ticket, last.sent.order.to().unwrap_or(last.from)))
    }

    /// The machine stands: everything up to an order is made.
    pub fn made(&mut self, last: Ticket, now_s: f64) {
        for flight in self.open.iter_mut().take_while(|flight| flight.sent.ticket <= last) {
            (flight.lines, flight.cut_s) = (0, Some(now_s));
        }
    }

    /// Another line belongs to the newest order, and a move of the planner.
    pub fn extends(&mut self, blocks: usize) {
        if let Some(flight) = self.open.back_mut() {
            flight.lines += 1;
            flight.blocks += blocks;
            flight.cut_s = None;
        }
    }

    /// Returns the order at whose end the probe changes, if it is under way.
    pub fn probing(&self) -> Option<Sent> {
        let probes = |flight: &&Flight| matches!(flight.sent.order, Order::Probe { .. });
        self.open.iter().find(probes).map(|flight| flight.sent)
    }

    /// Returns `true` if it goes home, or is about to.
    pub fn goes_home(&self) -> bool {
        self.open.iter().any(|flight| flight.sent.order == Order::Home)
    }

    /// The planner has so many moves left; everything before them is out of it.
    pub fn left(&mut self, blocks: usize, now_s: f64) {
        let mut behind: usize =
            self.open.iter().filter(|flight| flight.lines == 0).map(|flight| flight.blocks).sum();
        for flight in self.open.iter_mut().take_while(|flight| flight.lines == 0) {
            behind -= flight.blocks;
            if behind < blocks {
                return;
            }
            flight.cut_s.get_or_insert(now_s);
        }
    }

    /// An order is being made: everything before it is out of the planner.
    pub fn come_to(&mut self, ticket: Ticket, now_s: f64) {
        let before = |flight: &&mut Flight| flight.sent.ticket < ticket && flight.lines == 0;
        for flight in self.open.iter_mut().take_while(before) {
            flight.cut_s.get_or_insert(now_s);
        }
    }

    /// The machine is held: what is in the row of step segments is not made meanwhile.
    pub fn waits(&mut self, now_s: f64) {
        self.open
            .iter_mut()
            .filter_map(|flight| flight.cut_s.as_mut())
            .for_each(|cut_s| *cut_s = now_s);
    }

    /// Returns the least distance of a place from the ways of all of them, and of those made last, mm; nothing where none is under
    /// way, or one has no way that is known.
    pub fn distance_mm(&self, place: Axes) -> Option<f64> {
        if self.open.is_empty() {
            return None;
        }
        let far = |flight: &Flight| match flight.sent.order {
            Order::Move { to, .. } | Order::Jog { to, .. } | Order::Probe { to, .. } => {
                Some(off_way_mm(flight.from, to, place))
            }
            Order::Output { .. } | Order::Spindle { .. } => Some(way_mm(flight.from, place)),
            Order::Home | Order::Unlock => None,
        };
        let all: Option<Vec<f64>> = self.open.iter().map(far).collect();
        all?.into_iter().chain(self.made.iter().filter_map(far)).reduce(f64::min)
    }

    /// The next one that is done: out of the planner and of the row of segments, or all of them when the
    /// controller stands with nothing left.
    pub fn done(&mut self, stands: bool, now_s: f64) -> Option<Flight> {
        let first = self.open.front()?;
        let over = first.cut_s.is_some_and(|cut_s| now_s - cut_s > SEGMENTS_S);
        let over = over || (stands && first.lines == 0 && first.cut_s.is_some());
        // What is last is over when the machine says that it stands.
        if !(over && (stands || self.open.len() > 1)) {
            return None;
        }
        let done = self.open.pop_front();
        self.made.extend(done);
        if self.made.len() > KEPT {
            self.made.pop_front();
        }
        done
    }

    /// Returns `true` if all are done.
    pub fn is_empty(&self) -> bool {
        self.open.is_empty()
    }

    /// Forgets all.
    pub fn clear(&mut self) {
        self.open.clear();
        self.made.clear();
    }
}

/// Returns the distance of a place from a straight way, mm.
fn off_way_mm(from: Axes, to: Axes, place: Axes) -> f64 {
    let way = to.minus(from);
    let square: f64 = way.0.iter().map(|v| v * v).sum();
    let along: f64 = place.minus(from).0.iter().zip(way.0).map(|(a, b)| a * b).sum();
    let share = if square > 0.0 { (along / square).clamp(0.0, 1.0) } else { 1.0 };
    way_mm(from.zip(to, |from, to| from + (to - from) * share), place)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_before_the_line_that_it_makes_is_out_of_the_planner() {
        let mut flights = Flights::default();
        let place = |n| Axes::xyz(f64::from(n), 0.0, 0.0);
        for n in 1..=4 {
            let order = Order::Move { to: place(n), speed_mm_s: 1.0 };
            flights.push(Sent { ticket: n, order }, place(n - 1), 1, 1);
            flights.answered(n);
        }
        flights.come_to(3, 1.0);
        assert!(flights.done(false, 1.0).is_none(), "it is in the row of segments");
        let mut done = || flights.done(false, 1.2).map(|flight| flight.sent.ticket);
        assert_eq!([done(), done(), done()], [Some(1), Some(2), None]);
    }
}
