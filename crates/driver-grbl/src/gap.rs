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

/// The line is there again.
pub(crate) fn begins_gap(grbl: &mut Grbl) {
    grbl.hearing.clear();
    match grbl.phase {
        Phase::Ready | Phase::Gap => {
            grbl.out.clear();
            grbl.phase = Phase::Gap;
            grbl.gap = Gap { looked_s: f64::NEG_INFINITY, ..Gap::default() };
        }
        Phase::Silent | Phase::Asked => grbl.phase = Phase::Silent,
        Phase::Stopping | Phase::Resetting | Phase::Stopped => grbl.out.push(at_once::ASK),
    }
}

/// Asks until it stands, then for its modes.
pub(crate) fn looks_through_gap(grbl: &mut Grbl, now_s: f64) {
    if now_s - grbl.gap.looked_s > ASK_S {
        grbl.gap.looked_s = now_s;
        grbl.out.push(at_once::ASK);
    }
    let stands = grbl.gap.idle_s.is_some_and(|since_s| now_s - since_s > STANDS_S);
    match grbl.gap.asked_s {
        None if stands => {
            grbl.gap.asked_s = Some(now_s);
            grbl.told.forgets_modes();
            grbl.out.extend(format!("{REFUSED}\n$G\n").bytes());
        }
        Some(asked_s) if now_s - asked_s > ANSWER_S => is_gone(grbl, "it does not answer a line"),
        _ => {}
    }
}

/// It answers a line: one that was sent before the line was lost, or one that it is asked now.
pub(crate) const fn answers_in_gap(grbl: &mut Grbl) {
    grbl.gap.answers += grbl.gap.asked_s.is_some() as usize;
}

/// A report came.
pub(crate) fn reports_in_gap(grbl: &mut Grbl, now_s: f64) {
    match grbl.doing {
        Doing::Idle => grbl.gap.idle_s = grbl.gap.idle_s.or(Some(now_s)),
        Doing::Alarm(number) => grbl.alarm(number.unwrap_or(0)),
        _ => grbl.gap = Gap { looked_s: grbl.gap.looked_s, ..Gap::default() },
    }
    let has_said_all = grbl.gap.answers >= ASKED && grbl.told.has_modes();
    if has_said_all && grbl.doing == Doing::Idle {
        closes_gap(grbl, now_s);
    }
}

/// It stands, and has told all that it knows: goes on behind what it has made.
fn closes_gap(grbl: &mut Grbl, now_s: f64) {
    if grbl.has_moved && grbl.told.has_no_feed() {
        return is_gone(grbl, "it was reset meanwhile");
    }
    match made_in_gap(grbl) {
        Err(why) => is_gone(grbl, why),
        Ok(last) => {
            let rest = std::mem::take(&mut grbl.pending).into_iter().rev();
            let is_left = |line: &Line| line.ticket.is_none_or(|ticket| ticket > last);
            rest.filter(is_left).for_each(|line| grbl.queue.push_front(line));
            // The line behind an arc may be lost that ends its ways.
            grbl.queue.push_front(Line { text: "G90".into(), ticket: None });
            grbl.flights.made(last, now_s);
            (grbl.phase, grbl.asked_s) = (Phase::Ready, now_s);
        }
    }
}

/// Returns the last order that is known to be made: the machine stands at its end, and at the end of no other that it
/// has not answered. What is switched behind it is switched once more, which changes nothing.
fn made_in_gap(grbl: &Grbl) -> Result<Ticket, &'static str> {
    let place = grbl.position();
    let sent = grbl.pending.iter().filter_map(|line| line.ticket).max().unwrap_or_default();
    let mut end = grbl.flights.answered_end().unwrap_or((grbl.done, grbl.planned));
    if let Some(first) = grbl.flights.unanswered().next() {
        end.1 = first.from;
    }
    let mut ends = vec![end];
    for flight in grbl.flights.unanswered().take_while(|it| it.sent.ticket <= sent) {
        match flight.sent.order {
            Order::Move { to, .. } | Order::Jog { to, .. } | Order::Arc { to, .. } => {
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
    ends.retain(|(_, end)| is_same(grbl, place, *end));
    match *ends.as_slice() {
        [(ticket, _)] => Ok(ticket),
        [] => Err("it stands at the end of none of the moves that were sent"),
        _ => Err("it stands where several of the moves that were sent end"),
    }
}

/// Two places are on the same steps.
fn is_same(grbl: &Grbl, a: Axes, b: Axes) -> bool {
    a.minus(b).0.iter().enumerate().all(|(axis, apart)| {
        let steps = grbl.told.steps(axis);
        let step_mm = if steps > 0.0 { 1.0 / steps } else { 0.0 };
        apart.abs() <= 0.5 * step_mm + ROUNDED_MM
    })
}

fn is_gone(grbl: &mut Grbl, why: &'static str) {
    let _ = grbl.trouble.get_or_insert(Trouble::Gap { why });
    grbl.phase = Phase::Ready;
    grbl.pending.clear();
    grbl.fail();
}
