//! The machine of a run and the operator's requests, looked at in turns.
//!
//! ```text
//!  Runner ── pass(from, to) ──► Drive ─┬─ take ─────► Requests: STOP, hold, feed, a switch
//!                                │     └─ advance ──► Machine: reached, inputs, faults
//!                                └──── under_way ───► Sink: pages see it move
//! ```

use crate::requests::{OperatorRequest, Requests};
use kerf_machine::{Driven, Fault, Going, News};
use kerf_motion::Move;
use kerf_program::Axes;
use kerf_program::settings::IoModes;
use kerf_sim::contact;
use kerf_trace::{Doing, Sink};
use std::time::{Duration, Instant};

/// Time limit for the last moves of a machine that is wanted stopped: longer than what is sent ahead takes.
const PATIENCE: Duration = Duration::from_secs(2);

/// A program that computes and does not move looks at the machine this often.
const GLANCE: Duration = Duration::from_millis(4);

/// The machine and the requests.
pub(crate) struct Drive<'a> {
    machine: Driven,
    requests: &'a mut dyn Requests,
    /// Request that was taken while something else came first.
    kept: Option<(f64, OperatorRequest)>,
    /// Machine time that has passed: a run that heard of something in the middle of a move asks again from its beginning.
    reached_s: f64,
    /// It was stopped on the way: what is left of the plan is made already.
    braked: bool,
    fault: Option<Fault>,
    looked: Option<Instant>,
}

impl<'a> Drive<'a> {
    /// A run begins at a moment of machine time.
    pub fn new(machine: Driven, requests: &'a mut dyn Requests, now_s: f64) -> Self {
        machine.borrow_mut().begin();
        machine.borrow_mut().feed(1.0);
        let (kept, braked, fault, looked) = (None, false, None, None);
        Self { machine, requests, kept, reached_s: now_s, braked, fault, looked }
    }

    /// Lets machine time go on from one moment to another, unless an input, a fault or the operator comes before; returns
    /// that moment and what comes. A fault is told by [`Drive::fault`].
    pub fn pass(
        &mut self,
        from_s: f64,
        to_s: f64,
        doing: &Doing<'_>,
        sink: &mut dyn Sink,
    ) -> Option<(f64, OperatorRequest)> {
        if doing.machine.draws() {
            // What is only drawn takes no time, and no machine makes it.
            let request = self.take(from_s, to_s);
            sink.under_way(doing, from_s, to_s);
            return request;
        }
        if doing.going.is_some() && self.braked {
            // The way to the stand is made already.
            sink.under_way(doing, from_s, to_s);
            return None;
        }
        if doing.going.is_some() && self.fault.is_some() {
            return None;
        }
        let from_s = from_s.max(self.reached_s);
        let to_s = to_s.max(from_s);
        if doing.going.is_none() {
            self.comes_to_rest(to_s > from_s);
        }
        let due = self.take(from_s, to_s);
        let until_s = due.map_or(to_s, |(at_s, _)| at_s);
        match self.pass_until(from_s, until_s, doing, sink) {
            Err(Fails) => None,
            Ok(None) => due,
            Ok(first) => {
                self.kept = due;
                first
            }
        }
    }

    fn pass_until(
        &mut self,
        from_s: f64,
        until_s: f64,
        doing: &Doing<'_>,
        sink: &mut dyn Sink,
    ) -> Result<Option<(f64, OperatorRequest)>, Fails> {
        let mut now_s = from_s;
        loop {
            let News { reached_s, input } = {
                let mut machine = self.machine.borrow_mut();
                match &doing.going {
                    Some(going) => machine.advance(going, now_s, until_s),
                    None => machine.stand(now_s, until_s),
                }
            };
            // A machine that is followed may tell a moment before the one that it told last.
            let before_s = std::mem::replace(&mut now_s, reached_s.min(until_s));
            self.reached_s = now_s;
            sink.under_way(doing, before_s, now_s);
            if self.notes_fault() {
                return Err(Fails);
            }
            if let Some(input) = input {
                return Ok(Some((now_s, moved(input, &doing.machine.settings().io))));
            }
            if reached_s >= until_s {
                return Ok(None);
            }
            if let Some(request) = self.requests.take(now_s, now_s) {
                return Ok(Some(request));
            }
        }
    }

    /// Takes the first request from one moment to another; one that was kept comes first.
    fn take(&mut self, from_s: f64, to_s: f64) -> Option<(f64, OperatorRequest)> {
        let kept = self.kept.take().map(|(at_s, request)| (at_s.max(from_s), request));
        kept.or_else(|| self.requests.take(from_s, to_s))
    }

    /// Waits until everything is made where time is to pass; a program that only computes looks in passing, and not too
    /// often.
    fn comes_to_rest(&mut self, passes: bool) {
        if passes {
            self.settle();
        } else if self.looked.is_none_or(|at| at.elapsed() > GLANCE) {
            self.looked = Some(Instant::now());
            self.machine.borrow_mut().look();
            self.notes_fault();
        }
    }

    /// Waits until what the machine has is made. What the operator asks for meanwhile is heard afterwards. Somebody may hold
    /// the machine at its controller: when the operator wants it stopped and it does not come to an end, it is given up.
    fn settle(&mut self) {
        let mut stopped: Option<Instant> = None;
        while self.machine.borrow_mut().settle() {
            self.kept = self.kept.take().or_else(|| self.requests.take(0.0, 0.0));
            let ends = [OperatorRequest::Stop, OperatorRequest::Hold, OperatorRequest::End];
            if self.kept.is_some_and(|(_, request)| ends.contains(&request)) {
                let since = *stopped.get_or_insert_with(Instant::now);
                if since.elapsed() > PATIENCE {
                    self.machine.borrow_mut().give_up();
                }
            }
        }
    }

    /// Notes what went wrong; tells whether anything has.
    fn notes_fault(&mut self) -> bool {
        if self.fault.is_none() {
            self.fault = self.machine.borrow().fault().cloned();
        }
        self.fault.is_some()
    }

    /// Another plan, or another piece of it, is about to be followed.
    pub fn follows(&mut self) {
        self.machine.borrow_mut().begin_plan();
    }

    /// The machine is to stop on its way. One that slows down by itself tells the moment of the plan at which it stands,
    /// seconds of machine time.
    pub fn brake(&mut self, going: &Going<'_>) -> Option<f64> {
        let stands_s = self.machine.borrow_mut().stop(going)?;
        (self.braked, self.reached_s) = (true, stands_s);
        self.notes_fault();
        Some(stands_s)
    }

    /// Everything that was planned is handed over: the machine comes to a stand.
    pub fn stands(&mut self) {
        self.settle();
        self.braked = false;
        self.notes_fault();
    }

    /// Returns `true` if the machine finds home by itself.
    pub fn homes(&self) -> bool {
        self.machine.borrow().facts().homes
    }

    /// Has such a machine go home with all axes that can, and tells where it stands then; nothing where it was stopped or
    /// has a [fault](Drive::fault).
    pub fn home(&mut self) -> Option<Axes> {
        self.machine.borrow_mut().home();
        while self.machine.borrow_mut().settle() {
            let request = self.take(0.0, 0.0);
            if matches!(
                request,
                Some((_, OperatorRequest::Feed(_) | OperatorRequest::Input { .. }))
            ) {
                self.kept = request;
            } else if request.is_some() {
                self.machine.borrow_mut().halt();
                self.notes_fault();
                return None;
            }
        }
        if self.notes_fault() {
            return None;
        }
        self.machine.borrow_mut().place()
    }

    /// Returns `true` if the machine changes the speed of moves by itself: the plan stays what it is.
    pub fn overrides(&self) -> bool {
        self.machine.borrow().facts().overrides
    }

    /// Returns `true` if a stop of the machine switches its outputs off.
    pub fn stop_switches_off(&self) -> bool {
        self.machine.borrow().facts().stop_switches_off
    }

    /// Has such a machine make cuts at this share of their speed.
    pub fn feed(&mut self, share: f32) {
        self.machine.borrow_mut().feed(share);
    }

    /// The stop that was taken is answered by a question, which takes no machine time.
    pub fn heard(&mut self) {
        self.requests.heard();
        self.machine.borrow_mut().begin();
    }

    /// The machine is held since a moment: returns when the operator resumes, nothing when the run is to end.
    pub fn resumes(&mut self, held_s: f64) -> Option<f64> {
        let resumes_s = self.requests.resumes(held_s);
        self.machine.borrow_mut().begin();
        resumes_s
    }

    /// Returns in words why the machine cannot make a move; asked before anything of its stack moves.
    pub fn refuses(&self, mv: &Move) -> Option<String> {
        self.machine.borrow().refuses(mv)
    }

    /// Returns the fault for which the machine does nothing more.
    pub const fn fault(&self) -> Option<&Fault> {
        self.fault.as_ref()
    }

    /// Returns `true` if it takes the time of the world.
    pub fn is_real(&self) -> bool {
        self.machine.borrow().is_real()
    }
}

/// The machine has a fault.
struct Fails;

/// A pin that a controller reports: active is what its own wiring makes of it, a run counts in contacts.
fn moved((number, active): (u8, bool), io: &IoModes) -> OperatorRequest {
    OperatorRequest::Input { number, on: contact(number, active, io) }
}
