//! Requests of pages for a machine that runs, from the threads that hear them to the one that drives.
//!
//! Who holds the lock of the [`Hub`](crate::hub::Hub) may take that of the link, never the other way round. A stop takes
//! neither: it is counted in [`Arrived`], and wakes the machine's thread.

use super::arrived::{Arrived, StopCount};
use super::planned::Planned;
use crate::clock::Clock;
use crate::people::Grip;
use kerf_control::OperatorRequest;
use kerf_journal::Press;
use kerf_machine::driver::Override;
use std::collections::VecDeque;
use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError};
use std::thread::{self, Thread};
use std::time::Duration;

/// Longest time without a sign of the held key before a jog ends.
pub const DEAD_MAN: Duration = Duration::from_millis(250);

/// Carries what pages want; whoever waits for it is woken.
#[derive(Debug)]
pub struct Link {
    arrived: Arc<Arrived>,
    clock: Clock,
    wanted: Mutex<Wanted>,
    /// The thread that waits for what is wanted: that of the machine.
    waits: OnceLock<Thread>,
    /// Variables that are shown while programs run.
    watched: Mutex<Vec<String>>,
    /// The plan of a run that began without one, with its number.
    plan: Mutex<Option<(u32, Planned)>>,
}

/// Requests of pages.
#[derive(Debug, Default)]
pub struct Wanted {
    /// Stops so far, those while nothing ran included.
    arrived: Arc<Arrived>,
    /// The clock by which a held key ends.
    clock: Clock,
    /// Number of heard stops that end what runs.
    heard: u64,
    /// Stop, though nobody has pressed it: Kerf ends.
    ends: bool,
    /// Kerf ends: what runs is stopped, nobody answers any more, nothing else begins.
    pub leaves: bool,
    /// The run was told to stop, and ramps down.
    stopping: bool,
    /// Hold.
    hold: bool,
    /// Go on after a hold.
    pub resume: bool,
    /// A new feed override.
    pub feed: Option<f32>,
    /// Overrides of rapid moves and of the spindle that were asked for, in order.
    pub turns: VecDeque<Override>,
    /// The number of the question that is open: nobody has answered it yet, but for a jog.
    question: Option<u32>,
    /// Its answer.
    answer: Option<String>,
    /// The jog that is made.
    pub jog: Option<Held>,
    /// A stop came while nothing ran, and nobody has seen to it yet.
    rests: bool,
    /// A chore was begun last: it moves nothing, and is over in a moment.
    chore: bool,
    /// The tool is in for which the controller waits.
    pub tool_in: bool,
    /// Switches that are moved: by what runs, or else before the next thing begins.
    pub presses: VecDeque<Press>,
}

/// A key that is held.
#[derive(Clone, Copy, Debug)]
pub struct Held {
    /// Its jog.
    pub seq: u64,
    /// Whose.
    pub client: u32,
    /// Moment when it was held last, as whoever holds it says.
    renewed: Duration,
    /// It was let go.
    pub released: bool,
    /// The run was told so, and ramps down.
    ending: bool,
}

impl Held {
    /// A key that was held at a moment.
    pub const fn pressed(client: u32, Grip { seq, at }: Grip) -> Self {
        Self { seq, client, renewed: at, released: false, ending: false }
    }

    /// It is still held, or was. Whether that counts: nothing keeps a jog going that is over.
    pub fn renew(&mut self, client: u32, Grip { seq, at }: Grip, now: Duration) -> bool {
        let counts = self.seq == seq && self.client == client && !self.is_over(now);
        if counts {
            self.renewed = self.renewed.max(at);
        }
        counts
    }

    /// Returns `true` if nobody holds the key any more.
    pub const fn is_over(&self, now: Duration) -> bool {
        self.released || now.saturating_sub(self.renewed).as_nanos() > DEAD_MAN.as_nanos()
    }
}

impl Wanted {
    /// Returns what the run is to do now, once. A jog ends at whatever is wanted.
    pub fn request(&mut self) -> Option<OperatorRequest> {
        if let Some(held) = &mut self.jog {
            let halts = self.arrived.stops().halts();
            let stop = halts != self.heard || self.ends;
            let over = held.is_over(self.clock.now()) || stop || self.hold;
            let told = std::mem::replace(&mut held.ending, over);
            if stop {
                self.arrived.hear(halts);
            }
            return if over && !told { Some(OperatorRequest::End) } else { self.pressed() };
        }
        if self.is_to_stop() && !std::mem::replace(&mut self.stopping, true) {
            self.arrived.hear(self.arrived.stops().halts());
            return Some(OperatorRequest::Stop);
        }
        if std::mem::take(&mut self.hold) {
            return Some(OperatorRequest::Hold);
        }
        self.pressed().or_else(|| self.feed.take().map(OperatorRequest::Feed))
    }

    /// Returns `true` once where somebody has said that the tool is in.
    pub const fn takes_tool(&mut self) -> bool {
        std::mem::replace(&mut self.tool_in, false)
    }

    /// Drops the hold that is wanted, because the machine stands already and waits for a person.
    pub const fn stands(&mut self) {
        self.hold = false;
    }

    /// A stop is wanted that was not heard.
    pub fn is_to_stop(&self) -> bool {
        self.ends || self.arrived.stops().halts() != self.heard
    }

    /// A question is open from now on; one that is asked again is the same.
    pub fn ask(&mut self, question: u32) {
        if self.question.replace(question) != Some(question) {
            self.answer = None;
        }
    }

    /// Answers a question. Whether that counts: it is open, and nobody was faster.
    pub fn give(&mut self, question: u32, words: String) -> bool {
        let counts = self.question == Some(question) && self.answer.is_none();
        if counts {
            self.answer = Some(words);
        }
        counts
    }

    /// The answer to the open question.
    pub const fn given(&mut self) -> Option<String> {
        self.answer.take()
    }

    /// Closes the question: no answer counts any more, and the tool stays.
    pub fn close(&mut self) {
        (self.question, self.answer, self.jog) = (None, None, None);
    }

    /// A switch that is moved.
    fn pressed(&mut self) -> Option<OperatorRequest> {
        self.presses.pop_front().map(|Press { number, on }| OperatorRequest::Input { number, on })
    }

    /// Returns `true` if a stop is wanted, which is heard now.
    pub fn hear_stop(&mut self) -> bool {
        let stop = self.is_to_stop();
        (self.stopping, self.ends) = (false, false);
        self.heard = self.arrived.stops().halts();
        self.arrived.hear(self.heard);
        stop
    }

    /// Returns `true` if a stop came while nothing ran, which is heard now. `stands` where nothing has begun.
    pub fn hear_stop_at_rest(&mut self, stands: bool) -> bool {
        let now = stands && !self.leaves && self.hear_stop();
        std::mem::take(&mut self.rests) || now
    }

    /// Returns `true` if whoever waits for somebody is to give up: a stop is wanted, and heard now, or Kerf ends.
    pub fn gives_up(&mut self) -> bool {
        self.hear_stop() || self.leaves
    }
}

impl Default for Link {
    fn default() -> Self {
        let (arrived, clock) = (Arc::<Arrived>::default(), Clock::default());
        let wanted = Wanted { arrived: arrived.clone(), clock: clock.clone(), ..Wanted::default() };
        let (wanted, waits, watched) = (Mutex::new(wanted), OnceLock::new(), Mutex::default());
        Self { arrived, clock, wanted, waits, watched, plan: Mutex::default() }
    }
}

impl Link {
    /// Locks what is wanted.
    pub fn lock(&self) -> MutexGuard<'_, Wanted> {
        self.wanted.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Wants something.
    pub fn want<T>(&self, change: impl FnOnce(&mut Wanted) -> T) -> T {
        let result = change(&mut self.lock());
        self.wake();
        result
    }

    /// Wakes whoever waits, to look again at what is wanted, and for orders.
    pub fn wake(&self) {
        if let Some(thread) = self.waits.get() {
            thread.unpark();
        }
    }

    /// The clock of the server.
    pub const fn clock(&self) -> &Clock {
        &self.clock
    }

    /// Stops, and what the machine's thread has heard of them.
    pub fn arrived(&self) -> &Arrived {
        &self.arrived
    }

    /// The thread that calls this drives the machine: it is woken from now on.
    pub fn wakes_this_thread(&self) {
        // There is one for a server.
        drop(self.waits.set(thread::current()));
    }

    /// Variables that are shown while programs run.
    pub fn watched(&self) -> Vec<String> {
        self.watched.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// Shows other variables from now on.
    pub fn watch(&self, names: Vec<String>) {
        *self.watched.lock().unwrap_or_else(PoisonError::into_inner) = names;
    }

    /// The plan of a run is known by now.
    pub fn plans(&self, run: u32, planned: Planned) {
        *self.plan.lock().unwrap_or_else(PoisonError::into_inner) = Some((run, planned));
    }

    /// The plan that a run got since it began.
    pub fn plan_of(&self, run: u32) -> Option<Planned> {
        let mut plan = self.plan.lock().unwrap_or_else(PoisonError::into_inner);
        plan.take_if(|(of, _)| *of == run).map(|(_, planned)| planned)
    }

    /// Waits until something is wanted, or a time has passed.
    pub fn wait<'a>(
        &'a self,
        wanted: MutexGuard<'a, Wanted>,
        most: Duration,
    ) -> MutexGuard<'a, Wanted> {
        drop(wanted);
        // What is wanted from here on has woken this thread before it sleeps.
        thread::park_timeout(most);
        self.lock()
    }

    /// Stops what runs, and what was asked for and has not begun yet. Waits for nobody.
    pub fn stop(&self) -> StopCount {
        let stops = self.arrived.halt();
        self.wake();
        stops
    }

    /// Stops what runs; nothing begins before the machine is disarmed. Waits for nobody.
    pub fn disarm(&self) -> StopCount {
        let stops = self.arrived.disarm();
        self.wake();
        stops
    }

    /// Holds what runs. What was asked for and has not begun yet does not begin.
    pub fn hold(&self) {
        self.want(|wanted| {
            wanted.hold = true;
            wanted.arrived.forestall();
        });
    }

    /// Kerf ends.
    pub fn leave(&self) {
        self.want(|wanted| {
            (wanted.ends, wanted.leaves) = (true, true);
            wanted.arrived.forestall();
        });
    }

    /// Keeps what was asked for and has not begun yet from beginning; what runs goes on.
    pub fn forestall(&self) {
        self.arrived.forestall();
        self.wake();
    }

    /// Returns the number of stops that have come.
    pub fn stops(&self) -> StopCount {
        self.arrived.stops()
    }

    /// Wants something, unless a stop has come since a moment.
    pub fn want_since<T>(
        &self,
        since: StopCount,
        change: impl FnOnce(&mut Wanted) -> T,
    ) -> Option<T> {
        let may = |wanted: &Wanted| wanted.arrived.stops() == since && !wanted.arrived.disarms();
        self.want(|wanted| may(wanted).then(|| change(wanted)))
    }

    /// A run begins, for as long as a key is held where it is a jog: what was wanted of the one before is forgotten,
    /// but for switches that it did not move any more. Not where a stop has come since the moment, if there is one.
    pub fn begin(&self, since: Option<StopCount>, jog: Option<Held>) -> bool {
        let mut wanted = self.lock();
        let (leaves, stops) = (wanted.leaves, self.arrived.stops());
        let begins = since.is_none_or(|since| since == stops && !self.arrived.disarms());
        if begins {
            let presses = std::mem::take(&mut wanted.presses);
            let (arrived, heard) = (self.arrived.clone(), stops.halts());
            let clock = self.clock.clone();
            let rests = wanted.rests || wanted.heard != heard;
            let chore = since.is_none();
            let anew =
                Wanted { arrived, clock, heard, jog, leaves, rests, chore, ..Wanted::default() };
            *wanted = Wanted { ends: leaves, presses, ..anew };
        }
        begins
    }

    /// Returns `true` if what was begun last moves nothing, as a change of the folder.
    pub fn does_chore(&self) -> bool {
        self.lock().chore
    }

    /// The page of a jog has gone, or released the key.
    pub fn release(&self, is_it: impl Fn(&Held) -> bool) {
        self.want(|wanted| {
            if let Some(held) = wanted.jog.as_mut().filter(|held| is_it(held)) {
                held.released = true;
            }
        });
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn what_arrived_before_a_stop_does_not_begin() {
        let stops: [fn(&Link); 5] = [
            |link| _ = link.stop(),
            |link| _ = link.disarm(),
            Link::hold,
            Link::forestall,
            Link::leave,
        ];
        for stop in stops {
            let link = Link::default();
            let arrived = link.stops();
            assert!(link.begin(Some(arrived), None), "nothing has come yet");
            stop(&link);
            assert!(!link.begin(Some(arrived), None));
            assert_eq!(link.want_since(arrived, |_| ()), None);
            if link.arrived().disarms() {
                assert!(!link.begin(Some(link.stops()), None), "it is not disarmed yet");
                link.arrived().disarmed();
            }
            assert!(link.begin(Some(link.stops()), None), "asked for anew");
            assert!(!link.begin(Some(arrived), None), "the stop was not forgotten");
        }
    }

    #[test]
    fn a_stop_behind_the_beginning_is_heard() {
        let link = Link::default();
        assert!(link.begin(Some(link.stops()), None));
        link.stop();
        assert_eq!(link.lock().request(), Some(OperatorRequest::Stop));
    }

    #[test]
    fn a_stop_at_rest_is_heard_at_rest_and_not_by_what_begins_behind_it() {
        let link = Link::default();
        link.stop();
        assert!(link.begin(Some(link.stops()), None));
        assert_eq!(link.lock().request(), None);
        assert!(link.lock().hear_stop_at_rest(false));
        assert!(!link.lock().hear_stop_at_rest(false), "once");
        link.stop();
        assert!(!link.lock().hear_stop_at_rest(false), "what runs hears it");
        assert_eq!(link.lock().request(), Some(OperatorRequest::Stop));
        link.lock().hear_stop();
        link.stop();
        assert!(link.lock().hear_stop_at_rest(true));
    }

    #[test]
    fn a_key_that_was_held_when_the_computer_slept_is_held_no_longer() {
        let link = Link::default();
        let sign = |seq| Grip { seq, at: link.clock().now() };
        assert!(link.begin(None, Some(Held::pressed(3, sign(1)))));
        assert_eq!(link.lock().request(), None);
        link.clock().forward(Duration::from_secs(3600));
        let renews = |wanted: &mut Wanted| {
            wanted.jog.as_mut().unwrap().renew(3, sign(1), link.clock().now())
        };
        assert!(!link.want(renews), "no sign makes up for an hour");
        assert_eq!(link.lock().request(), Some(OperatorRequest::End));
        assert_eq!(link.lock().request(), None, "told once");
    }

    #[test]
    fn a_jog_ends_at_a_stop_and_when_kerf_ends() {
        for ends in [|link: &Link| _ = link.stop(), Link::leave] {
            let link = Link::default();
            let at = link.clock().now();
            assert!(link.begin(None, Some(Held::pressed(3, Grip { seq: 1, at }))));
            assert_eq!(link.lock().request(), None, "it is held");
            ends(&link);
            assert_eq!(link.lock().request(), Some(OperatorRequest::End));
        }
    }

    #[test]
    fn a_switch_that_a_run_left_is_not_lost_to_the_next() {
        let link = Link::default();
        let press = Press { number: 4, on: false };
        link.want(|wanted| wanted.presses.push_back(press));
        assert!(link.begin(None, None));
        assert_eq!(link.lock().request(), Some(OperatorRequest::Input { number: 4, on: false }));
    }
}
