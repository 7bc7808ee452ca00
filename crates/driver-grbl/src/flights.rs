//! Orders that were handed to the controller and are not done.
//!
//! A move leaves the planner when the last of it is cut into step segments, which is a moment before the
//! last step: [`SEGMENTS_S`].

use kerf_machine::driver::{Axes, Order, Sent, Ticket, way_mm};
use std::collections::VecDeque;
use std::f64::consts::TAU;

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

/// A place that is nearer to a way than this lies on it, mm.
const ON_MM: f64 = 0.03;

/// A place that is farther from a way than this does not lie on it, mm: a corner is cut by less.
const OFF_MM: f64 = 0.2;

impl Flight {
    /// Returns the distance of a place from its way, mm; nothing where its way is not known.
    fn distance_mm(&self, place: Axes) -> Option<f64> {
        match self.sent.order {
            Order::Move { to, .. } | Order::Jog { to, .. } | Order::Probe { to, .. } => {
                Some(off_way_mm(self.from, to, place))
            }
            Order::Arc { to, centre, sweep_rad, .. } => {
                Some(off_arc_mm(self.from, to, centre, sweep_rad, place))
            }
            Order::Output { .. } | Order::Spindle { .. } => Some(way_mm(self.from, place)),
            Order::Home | Order::Unlock => None,
        }
    }
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
        let probes = |order| matches!(order, Order::Probe { .. });
        let moves =
            |flight: &Flight| flight.sent.order.to().is_some() && !probes(flight.sent.order);
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

    /// The machine is at a place: where it lies on the way of an order, and on that of none before it, those are out of the
    /// planner. An arc is not answered before the last of it is in the planner.
    pub fn passes(&mut self, place: Axes, now_s: f64) {
        let mut before = 0;
        for flight in &self.open {
            match flight.distance_mm(place) {
                Some(far_mm) if far_mm > OFF_MM => before += 1,
                Some(far_mm) if far_mm < ON_MM => break,
                _ => return,
            }
        }
        if before < self.open.len() {
            let answered = |flight: &&mut Flight| flight.lines == 0;
            for flight in self.open.iter_mut().take(before).take_while(answered) {
                flight.cut_s.get_or_insert(now_s);
            }
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
        let far = |flight: &Flight| flight.distance_mm(place);
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

/// Returns the radius of an arc that begins at a place, mm.
pub fn radius_mm(from: Axes, centre: [f64; 2]) -> f64 {
    (from.0[0] - centre[0]).hypot(from.0[1] - centre[1])
}

/// Returns the distance of a place from an arc, mm.
fn off_arc_mm(from: Axes, to: Axes, centre: [f64; 2], sweep_rad: f64, place: Axes) -> f64 {
    let angle = |at: Axes| (at.0[1] - centre[1]).atan2(at.0[0] - centre[0]);
    let turned = (angle(place) - angle(from)) * sweep_rad.signum();
    let share = turned.rem_euclid(TAU) / sweep_rad.abs();
    let ends = way_mm(from, place).min(way_mm(to, place));
    if share > 1.0 {
        return ends;
    }
    let (sine, cosine) = (angle(from) + share * sweep_rad).sin_cos();
    let radius_mm = radius_mm(from, centre);
    let mut on = from.zip(to, |from, to| from + (to - from) * share);
    (on.0[0], on.0[1]) = (centre[0] + radius_mm * cosine, centre[1] + radius_mm * sine);
    ends.min(way_mm(on, place))
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
    use std::f64::consts::PI;

    #[test]
    fn what_lies_before_the_way_on_which_it_is_is_out_of_the_planner() {
        let mut flights = Flights::default();
        let far = Axes::xyz(10.0, 0.0, 0.0);
        let order = Order::Move { to: far, speed_mm_s: 1.0 };
        flights.push(Sent { ticket: 1, order }, Axes::default(), 1, 1);
        flights.answered(1);
        let (to, centre) = (Axes::xyz(20.0, 0.0, 2.0), [15.0, 0.0]);
        let order = Order::Arc { to, centre, sweep_rad: -PI, speed_mm_s: 1.0 };
        flights.push(Sent { ticket: 2, order }, far, 9, 2);
        for corner in [Axes::xyz(10.001, 0.05, 0.0), Axes::xyz(15.0, -5.0, 1.0)] {
            flights.passes(corner, 1.0);
            assert!(flights.done(false, 1.2).is_none(), "{corner:?}");
        }
        flights.passes(Axes::xyz(15.0, 5.0, 1.0), 2.0);
        assert_eq!(flights.done(false, 2.2).map(|flight| flight.sent.ticket), Some(1));
        assert!(flights.done(false, 2.2).is_none());
    }

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
