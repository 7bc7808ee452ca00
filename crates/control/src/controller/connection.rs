//! The connection to a controller: a driver, the line it hangs on, and the clock of the world.

use super::driven::LEAD_S;
use super::lacks::no_output;
use super::line_log::LineLog;
use super::lost::Lost;
use super::ordered_outputs::OrderedOutputs;
use super::row::Row;
use super::socket::{Ends, Opens};
use super::stopwatch::Stopwatch;
use super::turned::Turned;
use crate::learned::Learned;
use kerf_machine::driver::planners::{Grbl, OwnPlanner};
use kerf_machine::driver::{
    CardJob, Changed, Driver, Facts, Hold, Link, LinkNews, LinkState, Order, Signal, Ticket,
    Trouble, Wired,
};
use kerf_machine::{Fault, Machine};
use kerf_program::{At, Axes};
use kerf_transport::{Line, LineError};
use std::collections::{BTreeSet, VecDeque};
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Time that one look at the line takes when nothing comes.
pub(super) const NAP: Duration = Duration::from_millis(4);

/// Time limit for a controller's greeting, seconds; what is silent for longer is no controller.
const GREETING_S: f64 = 8.0;

/// Time limit for slowing the machine down and resetting its controller, seconds.
const STOPPING_S: f64 = 10.0;

/// Interval at which a machine that slows down is asked if it stands, seconds: its spindle goes off then.
const STANDS_S: f64 = 0.04;

/// Time limit for putting a setting back, seconds: writing one takes some milliseconds.
const PUTTING_S: f64 = 2.0;

/// Time limit for homing, seconds.
const HOMING_S: f64 = 300.0;

/// Interval at which an idle controller is asked for its state, seconds.
const ASK_S: f64 = 0.2;

/// Interval at which the controller is asked while a run watches an input that only its reports tell, seconds.
const LOOK_S: f64 = 0.02;

/// Stands in for a line that was taken away.
struct Closed;

impl Line for Closed {
    fn read(&mut self, _: &mut [u8], _: Duration) -> Result<usize, LineError> {
        Err(LineError::Closed)
    }

    fn write(&mut self, _: &[u8]) -> Result<(), LineError> {
        Err(LineError::Closed)
    }
}

/// Time limit for the last moves of a machine that is to stop, seconds: longer than what was sent ahead takes.
const PATIENCE_S: f64 = 2.0;

/// A connection to a controller.
pub struct Connection {
    pub(super) name: String,
    pub(super) link: Link<Box<dyn Wired>>,
    pub(super) line: Box<dyn Line>,
    /// Record of the bytes on the line.
    pub(super) log: Arc<LineLog>,
    pub(super) since: Instant,
    pub(super) facts: Facts,
    /// A place of the machine less that of the controller.
    pub(super) offset: Axes,
    pub(super) row: Row,
    /// The last order that is done.
    pub(super) done: Ticket,
    /// Orders given and not done.
    pub(super) open: usize,
    pub(super) outputs: OrderedOutputs,
    pub(super) rpm: Option<f64>,
    pub(super) turned: Turned,
    pub(super) inputs: VecDeque<(u8, bool)>,
    /// Inputs that are active.
    pub(super) active: BTreeSet<u8>,
    /// The order that ends where the probe changes, under way.
    pub(super) probing: Option<Ticket>,
    /// The move of the plan that a contact ended, and the share of it at which it stands.
    pub(super) contact: Option<(usize, f64)>,
    /// An input is watched that is only looked at now and then.
    pub(super) looks_often: bool,
    pub(super) asked_s: f64,
    /// The last moment of machine time that was told while nothing moves, and the world's time then.
    pub(super) stood: Option<(f64, Instant)>,
    pub(super) failure: Option<Fault>,
    /// A setting of the controller that was changed, and is put back.
    pub(super) owed: Option<Changed>,
    /// The line itself is gone.
    pub(super) dead: bool,
    /// Opens the line once more, where it was lost on the way.
    pub(super) opens: Option<Opens>,
    pub(super) lost: Option<Lost>,
    /// The run is over, and what it leaves on is meant to be.
    pub(super) closed: bool,
    /// The time that the run under way takes.
    pub(super) stopwatch: Stopwatch,
    /// The factor that runs on it have shown.
    pub(super) learned: Learned,
}

impl Connection {
    /// Speaks to a controller until it has told who it is.
    ///
    /// # Errors
    /// Nobody answers, or something that is no such controller, or one that cannot be driven as it is set.
    pub fn open(name: &str, driver: Box<dyn Wired>, line: Box<dyn Line>) -> Result<Self, String> {
        Self::new(name, driver, line, Arc::default()).greeted()
    }

    /// The same; of a controller that runs a file from its card, and tells nothing of itself before that is over, it is
    /// enough that it runs.
    ///
    /// # Errors
    /// As [`Connection::open`].
    pub fn open_beside_card(
        name: &str,
        driver: Box<dyn Wired>,
        line: Box<dyn Line>,
        log: Arc<LineLog>,
    ) -> Result<Self, String> {
        let mut connection = Self::new(name, driver, line, log);
        while connection.now_s() < GREETING_S && !connection.dead {
            connection.carry(NAP);
            if connection.link.driver().card_job().is_some() {
                return Ok(connection);
            }
            if connection.link.driver().facts().is_some() {
                break;
            }
        }
        connection.greeted()
    }

    /// The same, with the record of what passes; what may go on from a run that has no end is stopped first.
    ///
    /// # Errors
    /// As [`Connection::open`].
    pub fn open_logged(
        name: &str,
        (driver, line): (Box<dyn Wired>, Box<dyn Line>),
        log: Arc<LineLog>,
        is_abandoned: bool,
    ) -> Result<Self, String> {
        let mut connection = Self::new(name, driver, line, log);
        if is_abandoned {
            connection.link.stop(0.0);
        }
        connection.greeted()
    }

    fn new(name: &str, driver: Box<dyn Wired>, line: Box<dyn Line>, log: Arc<LineLog>) -> Self {
        log.link(&format!("{name}: the line is open"));
        Self {
            log,
            name: name.to_owned(),
            link: Link::new(driver),
            line,
            since: Instant::now(),
            facts: Facts::default(),
            offset: Axes::default(),
            row: Row::default(),
            done: 0,
            open: 0,
            outputs: OrderedOutputs::default(),
            rpm: None,
            turned: Turned::default(),
            inputs: VecDeque::new(),
            active: BTreeSet::new(),
            probing: None,
            contact: None,
            looks_often: false,
            asked_s: 0.0,
            stood: None,
            failure: None,
            owed: None,
            dead: false,
            opens: None,
            lost: None,
            closed: false,
            stopwatch: Stopwatch::default(),
            learned: Learned::default(),
        }
    }

    /// Waits until it has told who it is.
    fn greeted(mut self) -> Result<Self, String> {
        while self.now_s() < GREETING_S && !self.dead {
            self.carry(NAP);
            if let Some(trouble @ Trouble::Unfit { .. }) = self.link.driver().trouble() {
                return Err(format!("{}: {trouble}", self.name));
            }
            if self.hears_facts() {
                self.owed = self.link.driver().changed();
                self.link.restart(self.now_s());
                return Ok(self);
            }
        }
        match (self.failure.take(), self.link.driver().waits()) {
            (Some(failure), _) => Err(failure.message),
            (None, Some(why)) => Err(format!("{}: {why}", self.name)),
            (None, None) => Err(format!(
                "{} does not answer: is it switched on, is this its port, and its rate?",
                self.name
            )),
        }
    }

    /// Learns what it has told of itself so far; tells whether that is all. Its settings may be others than before.
    pub(super) fn hears_facts(&mut self) -> bool {
        let Some(facts) = self.link.driver().facts().cloned() else { return false };
        self.facts = Facts { leads_s: LEAD_S, ..facts };
        self.feeds_planner();
        true
    }

    /// Moves come to its planner no faster than its line takes them.
    fn feeds_planner(&mut self) {
        let Some(baud) = self.line.rate() else { return };
        if let Some(OwnPlanner::Grbl(Grbl { link: Some(link), .. })) = &mut self.facts.planner {
            link.baud = f64::from(baud);
        }
    }

    /// Tells whether it has a card with files that it runs by itself.
    ///
    /// # Errors
    /// It has none, for a reason.
    pub fn has_card(&mut self) -> Result<(), &'static str> {
        self.link.driver().has_card()
    }

    /// Returns the file that it runs from its card, whoever has begun it.
    pub fn card_job(&mut self) -> Option<CardJob> {
        self.link.driver().card_job()
    }

    /// Returns the setting of the controller that was changed to drive it.
    pub const fn changed(&self) -> Option<Changed> {
        self.owed
    }

    /// Takes over a setting that an unfinished run left changed: it is put back after this run.
    pub const fn owes(&mut self, changed: Changed) {
        if self.owed.is_none() {
            self.owed = Some(changed);
        }
    }

    /// Puts back what was changed in the controller; tells whether that is done.
    pub fn put_back(&mut self) -> bool {
        let until_s = self.now_s() + PUTTING_S;
        while let Some(changed) = self.owed {
            if self.dead || self.now_s() > until_s {
                return false;
            }
            if self.link.driver().puts_back(changed) {
                self.owed = None;
            }
            self.tend(NAP);
        }
        true
    }

    /// A place of the machine less that of the controller.
    pub const fn offset(&self) -> Axes {
        self.offset
    }

    /// Tells why it takes no orders: it is locked until it is homed.
    pub fn locked(&mut self) -> Option<String> {
        match self.link.driver().trouble() {
            Some(trouble @ Trouble::Locked { .. }) => Some(format!("{}: {trouble}", self.name)),
            _ => None,
        }
    }

    /// Goes home with all axes that can.
    ///
    /// # Errors
    /// It does not get there.
    pub fn go_home(&mut self, is_stopped: impl Fn() -> bool) -> Result<(), String> {
        self.does(Order::Home, "get home", is_stopped)
    }

    /// Takes orders after an alarm although nobody has homed it.
    ///
    /// # Errors
    /// It stays locked.
    pub fn unlock(&mut self) -> Result<(), String> {
        self.does(Order::Unlock, "unlock", || false)
    }

    /// Has it do something before a run.
    fn does(
        &mut self,
        order: Order,
        what: &str,
        is_stopped: impl Fn() -> bool,
    ) -> Result<(), String> {
        let until_s = self.now_s() + HOMING_S;
        self.order(order);
        while self.open > 0 && self.failure.is_none() && self.now_s() < until_s {
            self.tend(NAP);
            if is_stopped() {
                self.stop_at_once();
                return Err(format!("{} was stopped before it could {what}", self.name));
            }
        }
        match self.failure.take() {
            Some(failure) => Err(failure.message),
            None if self.open > 0 => Err(format!("{} did not {what}", self.name)),
            None => Ok(()),
        }
    }

    /// Returns where it stands in its own machine frame.
    pub fn stands(&mut self) -> Axes {
        self.link.driver().stands().map_or(Axes::default(), |standing| standing.position)
    }

    /// The machine is where it stands: from here on places are counted so.
    pub fn is_at(&mut self, place: Axes) {
        self.offset = place.minus(self.stands());
    }

    /// Outputs were left on, as far as anybody knows: whatever each is switched to is ordered.
    pub fn was_left_on(&mut self, outputs: u32) {
        self.outputs = OrderedOutputs::left_on(outputs);
    }

    /// Returns the outputs that are on, as they were ordered.
    pub const fn has_on(&self) -> u32 {
        self.outputs.on()
    }

    /// Closes its port.
    pub(super) fn closes_line(&mut self) {
        self.line = Box::new(Closed);
    }

    /// Closes its port: whoever opens it anew has another connection.
    pub fn let_go(&mut self) {
        self.closes_line();
        self.outputs.went_off();
        (self.open, self.dead) = (0, true);
    }

    /// Inputs that changed and were not told, in order: by number, and whether active.
    pub fn take_inputs(&mut self) -> Vec<(u8, bool)> {
        self.inputs.drain(..).collect()
    }

    /// Leaves its port to something that is done to the controller, and speaks to it again afterwards: what
    /// came of that, and what the controller is then, or why it does not answer; then nothing moves any more.
    pub fn anew<T>(
        &mut self,
        does: impl FnOnce() -> T,
        opens: impl FnOnce() -> Result<Ends, String>,
    ) -> (T, Result<String, String>) {
        self.finish(|| false);
        let (place, owed) = (self.place(), self.owed);
        self.line = Box::new(Closed);
        let done = does();
        let again = opens().and_then(|(driver, line)| {
            Self::open_logged(&self.name, (driver, line), self.log.clone(), false)
        });
        match again {
            Ok(connection) => {
                let opens = self.opens.take();
                *self = connection;
                self.opens = opens;
                self.owed = owed.or(self.owed);
            }
            Err(why) => {
                self.fail(why.clone(), "look at its firmware", None, true);
                return (done, Err(why));
            }
        }
        if let (Some(place), false) = (place, self.facts.homes) {
            self.is_at(place);
        }
        (done, Ok(self.facts.name.clone()))
    }

    pub(super) fn now_s(&self) -> f64 {
        self.since.elapsed().as_secs_f64()
    }

    /// Returns its place when it told last, machine frame.
    pub(super) fn place(&mut self) -> Option<Axes> {
        let standing = self.link.driver().stands()?;
        Some(standing.position.plus(self.offset))
    }

    /// Moves bytes both ways.
    fn carry(&mut self, wait: Duration) {
        if self.dead || self.lost.is_some() && !self.is_back(wait) {
            return;
        }
        let now_s = self.now_s();
        let out = self.link.driver().speak(now_s);
        let mut bytes = [0; 1024];
        let sent = if out.is_empty() { Ok(()) } else { self.line.write(&out) };
        self.log.passes(&out, true, &**self.link.driver());
        match sent.and_then(|()| self.line.read(&mut bytes, wait)) {
            Ok(count) => {
                let now_s = self.now_s();
                self.link.driver().hear(&bytes[..count], now_s);
                self.log.passes(&bytes[..count], false, &**self.link.driver());
            }
            Err(why) => self.line_is_lost(why.to_string()),
        }
    }

    /// Looks what became of orders; sends what is due.
    pub(super) fn tend(&mut self, wait: Duration) {
        let now_s = self.now_s();
        let each_s = if self.looks_often { LOOK_S } else { ASK_S };
        if (self.open == 0 || self.looks_often) && now_s - self.asked_s > each_s {
            self.asked_s = now_s;
            self.link.driver().signal(Signal::Ask, now_s);
        }
        self.carry(wait);
        if self.lost.is_some() {
            // Nobody can answer.
            return;
        }
        self.takes_news();
        // What the link has just given goes out without waiting for the next look. What comes with it is news too: a place
        // that is known is never newer than the inputs that were told with it.
        self.carry(Duration::ZERO);
        self.takes_news();
        let stopped = self.link.driver().trouble().cloned();
        if let Some(trouble) = stopped.filter(|trouble| !matches!(trouble, Trouble::Locked { .. }))
        {
            self.troubled(&trouble, None);
        }
    }

    /// Takes what the driver has heard: orders that are done, inputs, the state of the link.
    fn takes_news(&mut self) {
        if let Some(holds) = self.link.driver().shares() {
            self.turned.hear(holds);
        }
        if self.turned.changes_time() || self.link.driver().waits().is_some() {
            self.stopwatch.skip_stretch();
        }
        let told = self.link.poll(self.now_s());
        for told in told {
            match told {
                LinkNews::Done(ticket) => {
                    self.done = ticket;
                    self.open = self.open.saturating_sub(1);
                    if self.open == 0 {
                        self.stopwatch.end_stretch(self.now_s());
                    }
                    if self.probing == Some(ticket) {
                        self.probed();
                    }
                }
                LinkNews::Input { line, on } => {
                    if on {
                        self.active.insert(line)
                    } else {
                        self.active.remove(&line)
                    };
                    self.inputs.push_back((line, on));
                }
                LinkNews::State(state) => self.state_is(state),
            }
        }
    }

    fn state_is(&mut self, state: LinkState) {
        match state {
            LinkState::Up => {}
            LinkState::Lost => {
                let why = format!("{} does not answer any more", self.name);
                let hint =
                    "what it had in its buffer it may have made; look at its cable and its power";
                self.fail(why, hint, None, true);
            }
            LinkState::Refused(ticket, why) => {
                let at = self.row.at(ticket);
                match self.link.driver().trouble().cloned() {
                    Some(trouble) => self.troubled(&trouble, at),
                    None => self.fail(format!("{}: {why}", self.name), "", at, false),
                }
            }
        }
    }

    fn troubled(&mut self, trouble: &Trouble, at: Option<At>) {
        let hint = match trouble {
            Trouble::Alarm { lost: true, .. } | Trouble::Restarted => {
                "its place may be lost: home it, or set the location, before the next file"
            }
            _ => "nothing moves any more; outputs are off",
        };
        let at = at.or_else(|| self.row.at(self.done + 1));
        let mut why = format!("{}: {trouble}", self.name);
        if let (Trouble::Gap { .. }, Some(place)) = (trouble, self.place()) {
            let [x, y, z, ..] = place.0;
            why += &format!("; the machine stands at {x:.3}, {y:.3}, {z:.3}");
        }
        self.fail(why, hint, at, false);
    }

    pub(super) fn fail(
        &mut self,
        message: String,
        hint: &'static str,
        at: Option<At>,
        silent: bool,
    ) {
        let stands = self.place();
        let failure = Fault { message, hint, at, silent, stands, made_s: None };
        let _ = self.failure.get_or_insert(failure);
    }

    /// Fails because the program asks for an output that the controller does not have.
    pub(super) fn lacks(&mut self, number: u8) {
        let what = no_output(&self.facts, number);
        self.fail(format!("{} {what}", self.name), "", None, false);
    }

    pub(super) fn order(&mut self, order: Order) -> Option<Ticket> {
        match order {
            Order::Output { .. } | Order::Spindle { .. } => self.stopwatch.count_to_stand(),
            Order::Probe { .. } | Order::Home | Order::Unlock => self.stopwatch.skip_stretch(),
            Order::Move { .. } | Order::Jog { .. } | Order::Arc { .. } => {}
        }
        let ticket = self.link.order(order)?;
        self.open += 1;
        Some(ticket)
    }

    /// Slows down on the path, stops, and begins anew from where it stands. Outputs are off until the next
    /// move, whatever the machine should have on.
    pub(super) fn stop_at_once(&mut self) {
        let until_s = self.now_s() + STOPPING_S;
        self.stopwatch.skip_stretch();
        self.link.stop(self.now_s());
        while !self.dead {
            let now_s = self.now_s();
            if now_s - self.asked_s > STANDS_S {
                self.asked_s = now_s;
                self.link.driver().signal(Signal::Ask, now_s);
            }
            self.carry(NAP);
            drop(self.link.driver().replies(now_s));
            if self.link.driver().begin_anew() {
                break;
            }
            if now_s > until_s {
                let why = format!("{} does not say that it has stopped", self.name);
                return self.fail(why, "press its emergency stop and look at it", None, true);
            }
        }
        self.link.restart(self.now_s());
        self.outputs.went_off();
        (self.done, self.open) = (0, 0);
        (self.probing, self.contact, self.looks_often) = (None, None, false);
        // Its reset has set the override back.
        if self.turned.feed() != 1.0 {
            self.signal(Signal::Feed(self.turned.feed_percent()));
        }
        for turned in self.turned.to_restore() {
            self.signal(Signal::Override(turned));
        }
    }

    /// Signals something that is done at once.
    pub(super) fn signal(&mut self, signal: Signal) {
        let now_s = self.now_s();
        self.link.driver().signal(signal, now_s);
    }

    /// Slows down on the path until it stands, and keeps everything.
    pub(super) fn comes_to_hold(&mut self) {
        let until_s = self.now_s() + STOPPING_S;
        self.stopwatch.skip_stretch();
        self.signal(Signal::Hold);
        while self.failure.is_none() && self.link.driver().hold() == Hold::Ordered {
            let now_s = self.now_s();
            if now_s - self.asked_s > STANDS_S {
                self.asked_s = now_s;
                self.signal(Signal::Ask);
            }
            self.tend(NAP);
            if now_s > until_s {
                let why = format!("{} does not say that it is held", self.name);
                self.fail(why, "press its emergency stop and look at it", None, true);
            }
        }
    }

    /// Returns `true` while something that was ordered is not done.
    pub(super) const fn is_busy(&self) -> bool {
        self.open > 0 && self.failure.is_none()
    }

    /// Waits until everything that was ordered is done. Somebody may hold the machine at the controller: when
    /// the operator wants it stopped and it still does not come to an end, it is given up.
    fn finish(&mut self, mut is_stopped: impl FnMut() -> bool) {
        let mut stopped_s = None;
        while self.is_busy() {
            self.tend(NAP);
            let now_s = self.now_s();
            if stopped_s.is_none() && is_stopped() {
                stopped_s = Some(now_s);
            }
            if stopped_s.is_some_and(|at_s| now_s - at_s > PATIENCE_S) {
                self.give_up();
            }
        }
    }

    /// The run is over; when it did not end well, everything is stopped and switched off.
    pub fn close(&mut self, well: bool, is_stopped: impl FnMut() -> bool) {
        if well {
            self.finish(is_stopped);
        }
        if !well || self.failure.is_some() {
            self.outputs.want_none();
            self.stop_at_once();
        }
        self.closed = true;
    }
}

impl Drop for Connection {
    fn drop(&mut self) {
        // Whoever forgot to close it has left in the middle.
        if self.open > 0 || self.outputs.has_own_on() && !self.closed {
            self.stop_at_once();
        }
        self.put_back();
        if !self.dead {
            self.log.link("the line is closed");
        }
    }
}
