//! The machine of a run and the operator's requests, looked at in turns.
//!
//! ```text
//!  Runner ── pass(from, to) ──► Drive ─┬─ take ─────► Requests: STOP, hold, feed, a switch
//!                                │     └─ advance ──► Machine: reached, inputs, faults
//!                                └──── under_way ───► Sink: pages see it move
//! ```

use crate::requests::{OperatorRequest, Requests};
use kerf_machine::driver::Override;
use kerf_machine::{Driven, Fault, Going, News};
use kerf_model::contact;
use kerf_motion::Move;
use kerf_program::settings::IoModes;
use kerf_program::{Axes, Axis};
use kerf_trace::{Doing, Event, Sink};
use std::collections::VecDeque;
use std::time::{Duration, Instant};

/// Time limit for the last moves of a machine that is wanted stopped: longer than what is sent ahead takes.
const PATIENCE: Duration = Duration::from_secs(2);

/// Interval at which a program that computes without moving looks at the machine.
const GLANCE: Duration = Duration::from_millis(4);

/// News on the way, from either side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Heard {
    /// The operator wants something.
    Operator(OperatorRequest),
    /// The machine tells that an input changed.
    Input {
        /// Its number.
        number: u8,
        /// Its contact is closed from now on.
        on: bool,
    },
}

/// The machine and the requests.
pub(crate) struct Drive<'a> {
    machine: Driven,
    requests: &'a mut dyn Requests,
    /// Requests that were taken while something else came first, in order.
    kept: VecDeque<(f64, OperatorRequest)>,
    /// Machine time that has passed: a run that heard of something in the middle of a move asks again from its beginning.
    reached_s: f64,
    /// The machine was stopped on its way and has slowed down along the plan.
    braked: bool,
    fault: Option<Fault>,
    looked: Option<Instant>,
    begun: Instant,
    in_real_time: bool,
}

impl<'a> Drive<'a> {
    /// A run begins at a moment of machine time.
    pub fn new(machine: Driven, requests: &'a mut dyn Requests, now_s: f64) -> Self {
        machine.borrow_mut().begin();
        machine.borrow_mut().feed(1.0);
        for turned in [Override::Rapid(100), Override::Spindle(100)] {
            machine.borrow_mut().turn(turned);
        }
        let (kept, braked, fault, looked) = (VecDeque::new(), false, None, None);
        let (begun, in_real_time) = (Instant::now(), machine.borrow().in_real_time());
        let reached_s = now_s;
        Self { machine, requests, kept, reached_s, braked, fault, looked, begun, in_real_time }
    }

    /// Lets machine time go on from one moment to another, unless an input, a fault or the operator comes before; returns
    /// that moment and what comes. A fault is told by [`Drive::fault`]. What the operator asks for in the very moment in
    /// which an input changes comes first.
    pub fn pass(
        &mut self,
        from_s: f64,
        to_s: f64,
        doing: &Doing<'_>,
        sink: &mut dyn Sink,
    ) -> Option<(f64, Heard)> {
        if doing.machine.draws() {
            // What is only drawn takes no time, and no machine makes it.
            let request = self.take(from_s, to_s);
            sink.under_way(doing, from_s, to_s);
            return request.map(operator);
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
        if due.is_some_and(|(at_s, _)| at_s <= from_s) {
            // What is asked for now waits for no machine.
            return due.map(operator);
        }
        let until_s = due.map_or(to_s, |(at_s, _)| at_s.next_down().max(from_s));
        match self.pass_until(from_s, until_s, doing, sink) {
            Err(Fails) => None,
            Ok(None) => due.map(operator),
            Ok(first) => {
                self.kept.extend(due);
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
    ) -> Result<Option<(f64, Heard)>, Fails> {
        let mut now_s = from_s;
        loop {
            if let Some(turned) = self.requests.turned(now_s) {
                self.machine.borrow_mut().turn(turned);
            }
            let mut machine = self.machine.borrow_mut();
            let News { reached_s, input } = match &doing.going {
                Some(going) => machine.advance(going, now_s, until_s),
                None => machine.stand(now_s, until_s),
            };
            let (text, fails) = (machine.tells(), machine.fault().is_some());
            drop(machine);
            // A machine that is followed may tell a moment before the one that it told last.
            let before_s = std::mem::replace(&mut now_s, reached_s.min(until_s));
            self.reached_s = now_s;
            sink.under_way(doing, before_s, now_s);
            if let Some(text) = text {
                sink.event(&Event::Message { text: text.into(), t: now_s });
            }
            if self.fault.is_some() || fails && self.notes_fault() {
                return Err(Fails);
            }
            if let Some(input) = input {
                return Ok(Some((now_s, moved(input, &doing.machine.settings().io))));
            }
            if reached_s >= until_s {
                return Ok(None);
            }
            if let Some(request) = self.requests.take(now_s, now_s) {
                return Ok(Some(operator(request)));
            }
        }
    }

    /// Goes once more, in no time, through what happened up to a moment; returns the next input that changed on the way.
    pub fn repeat(&mut self, to_s: f64, io: &IoModes) -> Option<(f64, Heard)> {
        let News { reached_s, input } = self.machine.borrow_mut().passed(to_s);
        Some((reached_s, moved(input?, io)))
    }

    /// Returns `true` if the machine tells its inputs again when a run is gone through once more.
    pub fn repeats(&self) -> bool {
        self.machine.borrow().facts().repeats
    }

    /// Takes the first request from one moment to another; one that was kept comes first.
    fn take(&mut self, from_s: f64, to_s: f64) -> Option<(f64, OperatorRequest)> {
        let is_due = self.kept.front().is_some_and(|(at_s, _)| *at_s <= to_s);
        let kept = if is_due { self.kept.pop_front() } else { None };
        let kept = kept.map(|(at_s, request)| (at_s.max(from_s), request));
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
            if self.is_to_stop() {
                let since = *stopped.get_or_insert_with(Instant::now);
                if since.elapsed() > PATIENCE {
                    self.machine.borrow_mut().give_up();
                }
            }
        }
    }

    /// Keeps what the operator asks for, and tells whether anything of it stops the machine.
    fn is_to_stop(&mut self) -> bool {
        self.kept.extend(self.requests.take(0.0, 0.0));
        let ends = [OperatorRequest::Stop, OperatorRequest::Hold, OperatorRequest::End];
        self.kept.iter().any(|(_, request)| ends.contains(request))
    }

    /// Notes what went wrong; tells whether anything has.
    fn notes_fault(&mut self) -> bool {
        if self.fault.is_none() {
            let machine = self.machine.borrow();
            let Some(fault) = machine.fault() else { return false };
            self.fault = Some(fault.clone());
        }
        self.fault.is_some()
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
            if self.is_to_stop() {
                self.kept.clear();
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

    /// Returns `true` if the machine passes corners at a speed of its own.
    pub fn plans_corners(&self) -> bool {
        self.machine.borrow().facts().plans_corners
    }

    /// Returns `true` if another feed waits while inputs are watched.
    pub fn feed_waits(&self) -> bool {
        self.machine.borrow().facts().feed_waits
    }

    /// Returns `true` if the machine holds on its path and goes on from there by itself.
    pub fn holds(&self) -> bool {
        self.machine.borrow().facts().holds
    }

    /// Has such a machine hold; tells the moment of the plan at which it stands, seconds of machine time.
    pub fn hold(&mut self, going: &Going<'_>) -> Option<f64> {
        let stands_s = self.machine.borrow_mut().hold(going);
        self.notes_fault();
        stands_s
    }

    /// Has such a machine go on.
    pub fn goes_on(&mut self) {
        self.machine.borrow_mut().go_on();
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

    /// Returns the lowest and the highest place that an axis reaches, machine frame, where the machine tells.
    pub fn reach(&self, axis: Axis) -> Option<(f64, f64)> {
        self.machine.borrow().reach(axis)
    }

    /// Returns the fault for which the machine does nothing more.
    pub const fn fault(&self) -> Option<&Fault> {
        self.fault.as_ref()
    }

    /// Returns `true` if it takes the time of the world.
    pub const fn in_real_time(&self) -> bool {
        self.in_real_time
    }

    /// Returns the seconds of the world since the run began, on a real machine. A simulated one takes its own time.
    pub fn taken_s(&self) -> Option<f64> {
        (!self.repeats()).then(|| self.begun.elapsed().as_secs_f64())
    }
}

/// The machine has a fault.
struct Fails;

/// A pin that a controller reports: active is what its own wiring makes of it, a run counts in contacts.
fn moved((number, active): (u8, bool), io: &IoModes) -> Heard {
    Heard::Input { number, on: contact(number, active, io) }
}

const fn operator((at_s, request): (f64, OperatorRequest)) -> (f64, Heard) {
    (at_s, Heard::Operator(request))
}

#[cfg(test)]
mod tests {
    use super::*;
    use kerf_machine::Actuator;
    use kerf_machine::driver::Facts;
    use std::cell::RefCell;
    use std::rc::Rc;

    /// A machine that never finishes until it is halted or given up, as one held at its own controls.
    #[derive(Default)]
    struct Held {
        facts: Facts,
        ended: bool,
    }

    impl kerf_machine::Machine for Held {
        fn name(&self) -> &str {
            "held"
        }

        fn facts(&self) -> &Facts {
            &self.facts
        }

        fn in_real_time(&self) -> bool {
            true
        }

        fn refuses(&self, _: &Move) -> Option<String> {
            None
        }

        fn begin(&mut self) {}

        fn begin_plan(&mut self) {}

        fn set(&mut self, _: &Actuator) {}

        fn advance(&mut self, _: &Going<'_>, from_s: f64, _: f64) -> News {
            News { reached_s: from_s, input: None }
        }

        fn stand(&mut self, _: f64, until_s: f64) -> News {
            News { reached_s: until_s, input: None }
        }

        fn look(&mut self) {}

        fn settle(&mut self) -> bool {
            !self.ended
        }

        fn home(&mut self) {}

        fn halt(&mut self) {
            self.ended = true;
        }

        fn place(&mut self) -> Option<Axes> {
            None
        }

        fn stop(&mut self, _: &Going<'_>) -> Option<f64> {
            None
        }

        fn feed(&mut self, _: f32) {}

        fn give_up(&mut self) {
            self.ended = true;
        }

        fn fault(&self) -> Option<&Fault> {
            None
        }
    }

    /// Requests that come one behind the other.
    struct Queue(Vec<OperatorRequest>);

    impl Requests for Queue {
        fn take(&mut self, from_s: f64, _: f64) -> Option<(f64, OperatorRequest)> {
            self.0.pop().map(|request| (from_s, request))
        }
    }

    #[test]
    fn a_stop_behind_another_feed_is_heard_by_a_machine_that_is_held() {
        let asked = || Queue(vec![OperatorRequest::Stop, OperatorRequest::Feed(0.5)]);
        let (mut requests, machine) = (asked(), Rc::new(RefCell::new(Held::default())));
        let mut drive = Drive::new(machine.clone(), &mut requests, 0.0);
        assert_eq!(drive.home(), None);
        assert!(machine.borrow().ended, "going home is halted");

        let (mut requests, machine) = (asked(), Rc::new(RefCell::new(Held::default())));
        let mut drive = Drive::new(machine.clone(), &mut requests, 0.0);
        drive.stands();
        assert!(machine.borrow().ended, "it is given up");
        let kept = [drive.take(1.0, 1.0), drive.take(1.0, 1.0), drive.take(1.0, 1.0)];
        let told = kept.map(|request| request.map(|(_, request)| request));
        let all = [Some(OperatorRequest::Feed(0.5)), Some(OperatorRequest::Stop), None];
        assert_eq!(told, all, "nothing that was asked for is lost");
    }
}
