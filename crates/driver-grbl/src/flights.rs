//! Orders that were handed to the controller and are not done.
//!
//! A move leaves the planner when the last of it is cut into step segments, which is a moment before the
//! last step: [`SEGMENTS_S`].

use kerf_machine::driver::{Order, Sent, Ticket};
use std::collections::VecDeque;

/// Longest duration of the row of step segments, seconds: six segments of 10 ms, and some of it for the
/// line.
const SEGMENTS_S: f64 = 0.1;

/// An order under way.
#[derive(Clone, Copy, Debug)]
pub struct Flight {
    /// The order.
    pub sent: Sent,
    /// Moves that the planner makes of it.
    pub blocks: usize,
    /// Lines of it that are not answered.
    pub lines: usize,
    /// Since when it is out of the planner.
    cut_s: Option<f64>,
}

/// All of them, the oldest first.
#[derive(Clone, Debug, Default)]
pub struct Flights(VecDeque<Flight>);

impl Flights {
    /// One more.
    pub fn push(&mut self, sent: Sent, blocks: usize, lines: usize) {
        self.0.push_back(Flight { sent, blocks, lines, cut_s: None });
    }

    /// A line of an order was answered with `ok`; tells whether all of it was.
    pub fn answered(&mut self, ticket: Ticket) -> bool {
        let flight = self.0.iter_mut().find(|flight| flight.sent.ticket == ticket);
        flight.is_some_and(|flight| {
            flight.lines = flight.lines.saturating_sub(1);
            flight.lines == 0
        })
    }

    /// Another line belongs to the newest order, and a move of the planner.
    pub fn extends(&mut self, blocks: usize) {
        if let Some(flight) = self.0.back_mut() {
            flight.lines += 1;
            flight.blocks += blocks;
            flight.cut_s = None;
        }
    }

    /// Returns the order at whose end the probe changes, if it is under way.
    pub fn probing(&self) -> Option<Sent> {
        let probes = |flight: &&Flight| matches!(flight.sent.order, Order::Probe { .. });
        self.0.iter().find(probes).map(|flight| flight.sent)
    }

    /// Returns `true` if it goes home, or is about to.
    pub fn goes_home(&self) -> bool {
        self.0.iter().any(|flight| flight.sent.order == Order::Home)
    }

    /// The planner has so many moves left; everything before them is out of it.
    pub fn left(&mut self, blocks: usize, now_s: f64) {
        let mut behind: usize =
            self.0.iter().filter(|flight| flight.lines == 0).map(|flight| flight.blocks).sum();
        for flight in self.0.iter_mut().take_while(|flight| flight.lines == 0) {
            behind -= flight.blocks;
            if behind < blocks {
                return;
            }
            flight.cut_s.get_or_insert(now_s);
        }
    }

    /// The next one that is done: out of the planner and of the row of segments, or all of them when the
    /// controller stands with nothing left.
    pub fn done(&mut self, stands: bool, now_s: f64) -> Option<Flight> {
        let first = self.0.front()?;
        let over = first.cut_s.is_some_and(|cut_s| now_s - cut_s > SEGMENTS_S);
        let over = over || (stands && first.lines == 0 && first.cut_s.is_some());
        // What is last is over when the machine says that it stands.
        if over && (stands || self.0.len() > 1) { self.0.pop_front() } else { None }
    }

    /// Returns `true` if all are done.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Forgets all.
    pub fn clear(&mut self) {
        self.0.clear();
    }
}
