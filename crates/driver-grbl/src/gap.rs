//! A gap in the line: the cable was out, the network down. What the controller has got of the lines that it did not answer is
//! found by where it stands when it has made everything it has.
//!
//! ```text
//!  line is back ─► ask until it is idle ─► end half a line ─► $G ─► where does it stand?
//!                                                                   at the end of one way only: the rest is sent again
//!                                                                   else: the work ends, the place is told
//! ```
//!
//! Nothing but the character `?` is sent while it moves. A line of which it has got only the beginning is made one that it
//! refuses, never one that leads elsewhere.

use crate::at_once;
use crate::driver::{Grbl, Line, Phase};
use crate::report::Doing;
use kerf_machine::driver::{Axes, Order, Ticket, Trouble};

/// The end of every half line: a word without its number is refused, with all that stands before it.
const REFUSED: &str = "E";

/// Lines that it is asked then: that end, and its modes.
const ASKED: usize = 2;

/// It is asked so often where it is, seconds.
const ASK_S: f64 = 0.1;

/// It stands when it has said so for this long, seconds: what was under way to it is read by then.
const STANDS_S: f64 = 0.4;

/// It answers within this while it stands, seconds.
const ANSWER_S: f64 = 2.0;

/// Rounding of a place on its way through a line and a report, mm, beside half a step.
const ROUNDED_MM: f64 = 0.0016;

/// The search for what was lost.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Gap {
    /// Since when it stands, and when it was asked last.
    idle_s: Option<f64>,
    looked_s: f64,
    /// The moment at which it was asked for its modes, and the number of lines that it has answered since.
    asked_s: Option<f64>,
    answers: usize,
}

impl Grbl {
    /// The line is there again.
    pub(crate) fn begins_gap(&mut self) {
        self.hearing.clear();
        match self.phase {
            Phase::Ready | Phase::Gap => {
                self.out.clear();
                self.phase = Phase::Gap;
                self.gap = Gap { looked_s: f64::NEG_INFINITY, ..Gap::default() };
            }
            Phase::Silent | Phase::Asked => self.phase = Phase::Silent,
            Phase::Stopping | Phase::Resetting | Phase::Stopped => self.out.push(at_once::ASK),
        }
    }

    /// Asks until it stands, then for its modes.
    pub(crate) fn looks_through_gap(&mut self, now_s: f64) {
        if now_s - self.gap.looked_s > ASK_S {
            self.gap.looked_s = now_s;
            self.out.push(at_once::ASK);
        }
        let stands = self.gap.idle_s.is_some_and(|since_s| now_s - since_s > STANDS_S);
        match self.gap.asked_s {
            None if stands => {
                self.gap.asked_s = Some(now_s);
                self.told.forgets_modes();
                self.out.extend(format!("{REFUSED}\n$G\n").bytes());
            }
            Some(asked_s) if now_s - asked_s > ANSWER_S => {
                self.is_gone("it does not answer a line")
            }
            _ => {}
        }
    }

    /// It answers a line: one that was sent before the line was lost, or one that it is asked now.
    pub(crate) const fn answers_in_gap(&mut self) {
        self.gap.answers += self.gap.asked_s.is_some() as usize;
    }

    /// A report came.
    pub(crate) fn reports_in_gap(&mut self, now_s: f64) {
        match self.doing {
            Doing::Idle => self.gap.idle_s = self.gap.idle_s.or(Some(now_s)),
            Doing::Alarm(number) => self.alarm(number.unwrap_or(0)),
            _ => self.gap = Gap { looked_s: self.gap.looked_s, ..Gap::default() },
        }
        let has_said_all = self.gap.answers >= ASKED && self.told.has_modes();
        if has_said_all && self.doing == Doing::Idle {
            self.closes_gap(now_s);
        }
    }

    /// It stands, and has told all that it knows: goes on behind what it has made.
    fn closes_gap(&mut self, now_s: f64) {
        if self.has_moved && self.told.has_no_feed() {
            return self.is_gone("it was reset meanwhile");
        }
        match self.made_in_gap() {
            Err(why) => self.is_gone(why),
            Ok(last) => {
                let rest = std::mem::take(&mut self.pending).into_iter().rev();
                let is_left = |line: &Line| line.ticket.is_none_or(|ticket| ticket > last);
                rest.filter(is_left).for_each(|line| self.queue.push_front(line));
                self.flights.made(last, now_s);
                (self.phase, self.asked_s) = (Phase::Ready, now_s);
            }
        }
    }

    /// Returns the last order that is known to be made: the machine stands at its end, and at the end of no other that it
    /// has not answered. What is switched behind it is switched once more, which changes nothing.
    fn made_in_gap(&self) -> Result<Ticket, &'static str> {
        let place = self.position();
        let sent = self.pending.iter().filter_map(|line| line.ticket).max().unwrap_or_default();
        let mut end = self.flights.answered_end().unwrap_or((self.done, self.planned));
        if let Some(first) = self.flights.unanswered().next() {
            end.1 = first.from;
        }
        let mut ends = vec![end];
        for flight in self.flights.unanswered().take_while(|it| it.sent.ticket <= sent) {
            match flight.sent.order {
                Order::Move { to, .. } | Order::Jog { to, .. } => {
                    ends.push((flight.sent.ticket, to))
                }
                Order::Output { .. } | Order::Spindle { .. } => {}
                Order::Probe { .. } | Order::Home | Order::Unlock => {
                    return Err("it was at something that is not begun twice");
                }
            }
        }
        // A move without a way ends where the one before it does: it is made again, which moves nothing.
        ends.dedup_by(|next, before| next.1 == before.1);
        ends.retain(|(_, end)| self.is_same(place, *end));
        match *ends.as_slice() {
            [(ticket, _)] => Ok(ticket),
            [] => Err("it stands at the end of none of the moves that were sent"),
            _ => Err("it stands where several of the moves that were sent end"),
        }
    }

    /// Two places are on the same steps.
    fn is_same(&self, a: Axes, b: Axes) -> bool {
        a.minus(b).0.iter().enumerate().all(|(axis, apart)| {
            let steps = self.told.steps(axis);
            let step_mm = if steps > 0.0 { 1.0 / steps } else { 0.0 };
            apart.abs() <= 0.5 * step_mm + ROUNDED_MM
        })
    }

    fn is_gone(&mut self, why: &'static str) {
        let _ = self.trouble.get_or_insert(Trouble::Gap { why });
        self.phase = Phase::Ready;
        self.pending.clear();
        self.fail();
    }
}
