//! The pace of a run on a machine: moves are handed over ahead of time, and a move is made when the machine has made it.

use crate::journal::Hurry;
use crate::pace::{Doing, Pace, Wish};
use kerf_machine::{Driven, Fault, Going, News};
use kerf_motion::Move;
use kerf_program::settings::IoModes;
use kerf_sim::contact;
use std::time::{Duration, Instant};

/// The last moves of a piece of plan that does not end at a stand are not waited for, as long as this,
/// seconds: the next piece is planned meanwhile, and the machine does not stop between them.
const LEAD_S: f64 = 0.5;

/// Time that one look takes when nothing comes.
const NAP: Duration = Duration::from_millis(4);

/// Time limit for the last moves of a machine that is wanted stopped: longer than what is sent ahead takes.
pub(super) const PATIENCE: Duration = Duration::from_secs(2);

/// Lets the machine decide how machine time passes; what the operator wants comes from another pace.
pub struct Steers<'a> {
    machine: Driven,
    operator: &'a mut dyn Pace,
    /// Wish of the operator that came while something else came first.
    kept: Option<(f64, Wish)>,
    /// It was stopped on the way: what is left of the plan is made already.
    braked: bool,
    failure: Option<Fault>,
    looked: Instant,
    /// Moment of machine time at which it stands, and since when: an input on the way does not begin it anew.
    stood: Option<(f64, Instant)>,
    /// Wiring of the inputs.
    io: IoModes,
}

impl<'a> Steers<'a> {
    /// The run on a machine; the operator stops it through a pace that does not wait.
    pub fn new(machine: Driven, operator: &'a mut dyn Pace) -> Self {
        let (kept, failure, looked) = (None, None, Instant::now());
        let io = IoModes::default();
        Self { machine, operator, kept, braked: false, failure, looked, stood: None, io }
    }

    /// Returns the wish of the operator up to a moment.
    fn wish(&mut self, from_s: f64, to_s: f64) -> Option<(f64, Wish)> {
        let kept = self.kept.take().map(|(at_s, wish)| (at_s.max(from_s), wish));
        kept.or_else(|| self.operator.pass(from_s, to_s))
    }

    /// A pin that the controller reports: active is what its own wiring makes of it, the machine counts in contacts.
    fn moved(&self, (number, active): (u8, bool)) -> Wish {
        Wish::Input { number, on: contact(number, active, &self.io) }
    }

    /// Waits until what was handed over is made. What the operator wants meanwhile is heard afterwards. Somebody may hold
    /// the machine at its controller: when the operator wants it stopped and it does not come to an end, it is given up.
    fn settle(&mut self) {
        let mut stopped: Option<Instant> = None;
        while self.machine.borrow().is_busy() {
            // An input that changes now is told as soon as the machine stands.
            self.machine.borrow_mut().work(NAP);
            self.kept = self.kept.take().or_else(|| self.operator.pass(0.0, 0.0));
            if matches!(self.kept, Some((_, Wish::Stop | Wish::Hold | Wish::End))) {
                let since = *stopped.get_or_insert_with(Instant::now);
                if since.elapsed() > PATIENCE {
                    self.machine.borrow_mut().give_up();
                }
            }
        }
    }

    /// Notices what went wrong.
    fn note(&mut self) {
        if self.failure.is_none() {
            self.failure = self.machine.borrow().fault().cloned();
        }
    }

    /// The controller makes the moves of a plan up to a moment. Something may come before.
    fn make(&mut self, going: Going<'_>, until_s: f64) -> Option<(f64, Wish)> {
        // What is known to be made already is not waited for.
        if self.machine.borrow_mut().reached_s(&going) >= until_s {
            return None;
        }
        loop {
            let News { reached_s, input } = self.machine.borrow_mut().advance(&going, NAP);
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
            let input = self.machine.borrow_mut().look(NAP);
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
            self.machine.borrow_mut().work(Duration::ZERO);
            self.note();
        }
        self.wish(now_s, now_s)
    }
}

/// Returns `true` if the run goes on without waiting for the machine.
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
        self.machine.borrow_mut().begin_plan();
    }

    fn brake(&mut self, going: Going<'_>) -> Option<f64> {
        let stands_s = self.machine.borrow_mut().stop(&going)?;
        self.braked = true;
        self.note();
        Some(stands_s)
    }

    fn stands(&mut self) {
        self.settle();
        self.braked = false;
        self.note();
    }

    fn refuses(&self, made: &Move) -> Option<String> {
        self.machine.borrow().refuses(made)
    }

    fn failure(&self) -> Option<&Fault> {
        self.failure.as_ref()
    }
}
