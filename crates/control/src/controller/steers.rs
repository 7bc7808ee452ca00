//! The pace of a run on a controller: moves are handed over ahead of time, and a move is made when the
//! controller has made it.

use super::lacks::out_of_reach;
use super::{Connection, Shared};
use crate::journal::Hurry;
use crate::pace::{Doing, Failure, Going, Pace, Wish};
use kerf_motion::Move;
use kerf_program::settings::IoModes;
use kerf_sim::contact;
use std::cell::RefMut;
use std::time::{Duration, Instant};

/// The last moves of a piece of plan that does not end at a stand are not waited for, as long as this,
/// seconds: the next piece is planned meanwhile, and the machine does not stop between them.
const LEAD_S: f64 = 0.5;

/// How long one look takes when nothing comes.
const NAP: Duration = Duration::from_millis(4);

/// Lets the controller decide how machine time passes; what the operator wants comes from another pace.
pub struct Steers<'a> {
    shared: Shared,
    operator: &'a mut dyn Pace,
    /// What the operator wanted while something else came first.
    kept: Option<(f64, Wish)>,
    /// It was stopped on the way: what is left of the plan is made already.
    braked: bool,
    failure: Option<Failure>,
    looked: Instant,
    /// When it began to stand at a moment of machine time: an input on the way does not begin it anew.
    stood: Option<(f64, Instant)>,
    /// How the inputs are wired.
    io: IoModes,
}

impl<'a> Steers<'a> {
    /// The run on a controller; the operator stops it through a pace that does not wait.
    pub fn new(shared: Shared, operator: &'a mut dyn Pace) -> Self {
        let (kept, failure, looked) = (None, None, Instant::now());
        let io = IoModes::default();
        Self { shared, operator, kept, braked: false, failure, looked, stood: None, io }
    }

    /// What the operator wants by a moment.
    fn wish(&mut self, from_s: f64, to_s: f64) -> Option<(f64, Wish)> {
        let kept = self.kept.take().map(|(at_s, wish)| (at_s.max(from_s), wish));
        kept.or_else(|| self.operator.pass(from_s, to_s))
    }

    /// A pin that the controller reports: active is what its own wiring makes of it, the machine counts in contacts.
    fn moved(&self, (number, active): (u8, bool)) -> Wish {
        Wish::Input { number, on: contact(number, active, &self.io) }
    }

    /// What was handed over is made. What the operator wants meanwhile is heard afterwards.
    fn settle(&mut self) {
        let (operator, kept) = (&mut self.operator, &mut self.kept);
        self.shared.borrow_mut().settle(|| {
            *kept = kept.take().or_else(|| operator.pass(0.0, 0.0));
            matches!(kept, Some((_, Wish::Stop | Wish::Hold | Wish::End)))
        });
    }

    /// Notices what went wrong.
    fn note(&mut self) {
        if self.failure.is_none() {
            self.failure = self.shared.borrow().failure().cloned();
        }
    }

    /// The controller makes the moves of a plan up to a moment. Something may come before.
    fn make(&mut self, going: Going<'_>, until_s: f64) -> Option<(f64, Wish)> {
        // What is known to be made already is not waited for.
        if reached_s(&mut self.shared.borrow_mut(), going) >= until_s {
            return None;
        }
        loop {
            let (reached_s, input) = {
                let mut connection = self.shared.borrow_mut();
                hand_over(&mut connection, going);
                connection.look(NAP);
                (reached_s(&mut connection, going), connection.input())
            };
            self.note();
            if self.failure.is_some() {
                return None;
            }
            if let Some(input) = input {
                return Some((reached_s.min(until_s), self.moved(input)));
            }
            if reached_s >= until_s || leads(going, until_s) {
                return None;
            }
            if let Some((_, wish)) = self.operator.pass(reached_s, reached_s) {
                return Some((reached_s.min(until_s), wish));
            }
        }
    }

    /// Nothing moves for a while.
    fn stand(&mut self, from_s: f64, to_s: f64) -> Option<(f64, Wish)> {
        self.settle();
        let wish = self.wish(from_s, to_s);
        let until_s = wish.map_or(to_s, |(at_s, _)| at_s);
        let before = self.stood.filter(|(at_s, _)| *at_s == from_s);
        let (_, began) = *self.stood.insert(before.unwrap_or_else(|| (from_s, Instant::now())));
        loop {
            let now_s = from_s + began.elapsed().as_secs_f64();
            self.shared.borrow_mut().look(NAP);
            let input = self.shared.borrow_mut().input();
            self.note();
            if self.failure.is_some() {
                return None;
            }
            if let Some(input) = input {
                self.kept = wish;
                return Some((now_s.min(until_s), self.moved(input)));
            }
            if now_s >= until_s {
                return wish;
            }
            if let Some((_, wish)) = self.operator.pass(now_s, now_s) {
                return Some((now_s, wish));
            }
        }
    }

    /// A look in passing, not too often: programs compute without moving.
    fn glance(&mut self, now_s: f64) -> Option<(f64, Wish)> {
        if self.looked.elapsed() > NAP {
            self.looked = Instant::now();
            self.shared.borrow_mut().look(Duration::ZERO);
            self.note();
        }
        self.wish(now_s, now_s)
    }
}

/// Hands over moves as long as there is room and nothing else has to be done before them.
fn hand_over(connection: &mut RefMut<'_, Connection>, going: Going<'_>) {
    connection.row.come_to(going.index);
    let moves = going.plan.moves();
    while connection.has_room() && connection.row.next() < moves.len().min(going.until) {
        let made = moves[connection.row.next()];
        connection.hand(&made);
    }
}

/// The moment of the plan to which the controller has come within a move; no bound once it is made.
fn reached_s(connection: &mut RefMut<'_, Connection>, going: Going<'_>) -> f64 {
    let (done, place) = (connection.done(), connection.place());
    let share = connection.row.share(going.index, done, place);
    if share >= 1.0 {
        return f64::INFINITY;
    }
    going.t0_s + going.plan.time_at_share(going.index, share)
}

/// Whether the run goes on without waiting for the controller.
fn leads(going: Going<'_>, until_s: f64) -> bool {
    let plan = going.plan;
    let last = plan.span(plan.moves().len().saturating_sub(1));
    // A ramp ends at its own speed, which is a stand all the same.
    let goes_on = last.is_some_and(|last| last.v_exit > 1.001 * last.made.ramp_mm_s);
    goes_on && going.t0_s + plan.duration_s() - until_s < LEAD_S
}

impl Pace for Steers<'_> {
    fn pass(&mut self, from_s: f64, to_s: f64) -> Option<(f64, Wish)> {
        if to_s > from_s { self.stand(from_s, to_s) } else { self.glance(from_s) }
    }

    fn watch(&mut self, from_s: f64, to_s: f64, doing: &Doing<'_>) -> Option<(f64, Wish)> {
        if doing.machine.draws() {
            return self.operator.pass(from_s, to_s);
        }
        self.io = doing.machine.settings().io;
        let Some(going) = doing.going else { return self.pass(from_s, to_s) };
        if self.braked || self.failure.is_some() {
            return None;
        }
        let wish = self.wish(from_s, to_s);
        let until_s = wish.map_or(to_s, |(at_s, _)| at_s);
        match self.make(going, until_s) {
            Some(first) => {
                self.kept = wish;
                Some(first)
            }
            None if self.failure.is_some() => None,
            None => wish,
        }
    }

    fn is_real(&self) -> bool {
        true
    }

    fn hurry(&self) -> Option<Hurry> {
        self.operator.hurry()
    }

    fn heard(&mut self) {
        self.operator.heard();
    }

    fn resumes(&mut self, held_s: f64) -> Option<f64> {
        self.operator.resumes(held_s)
    }

    fn follows(&mut self) {
        self.shared.borrow_mut().row.begin();
    }

    fn brake(&mut self, going: Going<'_>) -> Option<f64> {
        let mut connection = self.shared.borrow_mut();
        // The end of the piece before is made: what it belongs to is told already.
        while connection.done() < connection.row.before && connection.is_busy() {
            connection.look(NAP);
        }
        let done = connection.done();
        if connection.failure().is_none() {
            connection.stop();
        }
        let place = connection.place()?;
        let (index, share) = connection.row.locate(done, place).unwrap_or((going.index, 0.0));
        connection.row = Default::default();
        drop(connection);
        self.braked = true;
        self.note();
        Some(going.t0_s + going.plan.time_at_share(index, share))
    }

    fn stands(&mut self) {
        self.settle();
        self.braked = false;
        self.note();
    }

    fn refuses(&self, made: &Move) -> Option<String> {
        let connection = self.shared.borrow();
        let why = out_of_reach(connection.facts(), made.from, made.to, connection.offset())?;
        Some(format!("{} {why}", connection.name()))
    }

    fn failure(&self) -> Option<&Failure> {
        self.failure.as_ref()
    }
}
