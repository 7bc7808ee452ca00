//! The connection to a controller: a driver, the line it hangs on, and the clock of the world.

use super::lacks::{lacked, needs, no_output, out_of_reach, wired};
use super::row::{Chord, Handed, Row};
use super::ways::{chords, speed_mm_s};
use kerf_machine::driver::{
    Changed, Driver, Facts, Link, LinkState, Order, Signal, Ticket, Told, Trouble, Wired,
};
use kerf_machine::{Actuator, Fault, Going, Machine, News, Watch};
use kerf_motion::{Move, Path};
use kerf_program::{At, Axes, MoveKind, OutputReason};
use std::collections::{BTreeSet, VecDeque};
use std::time::{Duration, Instant};

/// Line that a driver hangs on. Errors are told to people as they are.
pub trait Line {
    /// The bytes that came, waiting for the first of them at most so long; 0 when none did.
    fn read(&mut self, into: &mut [u8], wait: Duration) -> Result<usize, String>;

    /// Sends all bytes.
    fn write(&mut self, bytes: &[u8]) -> Result<(), String>;
}

/// Time that one look at the line takes when nothing comes.
const NAP: Duration = Duration::from_millis(4);

/// A controller that has not told who it is after this is none, seconds.
const GREETING_S: f64 = 8.0;

/// A machine slows down and its controller is reset within this, seconds.
const STOPPING_S: f64 = 10.0;

/// A setting is put back within this, seconds: writing one takes some milliseconds.
const PUTTING_S: f64 = 2.0;

/// Going home takes at most so long, seconds.
const HOMING_S: f64 = 300.0;

/// The line of flood coolant.
const FLOOD: u8 = 2;

/// The line of mist coolant.
const MIST: u8 = 3;

/// While it has nothing to do the controller is asked so often how it is, seconds.
const ASK_S: f64 = 0.2;

/// While an input is watched that is only looked at, the controller is asked so often, seconds.
const LOOK_S: f64 = 0.02;

/// The fastest a machine goes while it looks at an input now and then, mm/s: in 0.06 s, for a look, the line both ways and
/// the next turn of the run, and on a ramp of 100 mm/s² it comes no farther than [`kerf_machine::OVERRUN_MM`].
const POLLED_MM_S: f64 = 1.5;

/// Most orders on their way to the controller that are not done.
const AHEAD: usize = 512;

/// A line that somebody else has.
struct Closed;

impl Line for Closed {
    fn read(&mut self, _: &mut [u8], _: Duration) -> Result<usize, String> {
        self.write(&[]).map(|()| 0)
    }

    fn write(&mut self, _: &[u8]) -> Result<(), String> {
        Err("the port of the controller is closed".into())
    }
}

/// The last moves of a piece of plan that does not end at a stand are not waited for, as long as this,
/// seconds: the next piece is planned meanwhile, and the machine does not stop between them.
const LEAD_S: f64 = 0.5;

/// Time limit for the last moves of a machine that is wanted stopped, seconds: longer than what is sent ahead takes.
const PATIENCE_S: f64 = 2.0;

/// A share in percent, as a driver is told it.
fn percent(share: f32) -> u8 {
    (share * 100.0).round().clamp(1.0, 250.0) as u8
}

/// Returns `true` if a run goes on without waiting for the machine.
fn leads(going: &Going<'_>, until_s: f64) -> bool {
    let plan = going.plan;
    let last = plan.span(plan.moves().len().saturating_sub(1));
    // A ramp ends at its own speed, which is a stand all the same.
    let goes_on = last.is_some_and(|last| last.v_exit > 1.001 * last.made.ramp_mm_s);
    goes_on && going.t0_s + plan.duration_s() - until_s < LEAD_S
}

/// A connection to a controller.
pub struct Connection {
    name: String,
    link: Link<Box<dyn Wired>>,
    line: Box<dyn Line>,
    since: Instant,
    facts: Facts,
    /// A place of the machine less that of the controller.
    offset: Axes,
    row: Row,
    /// The last order that is done.
    done: Ticket,
    /// Orders given and not done.
    open: usize,
    /// Outputs as they should be, and as they were ordered.
    wanted: u32,
    ordered: u32,
    rpm: Option<f64>,
    /// Share of the ordered speed at which it makes moves.
    feed: f32,
    inputs: VecDeque<(u8, bool)>,
    /// Inputs that are active.
    active: BTreeSet<u8>,
    /// The order that ends where the probe changes, under way.
    probing: Option<Ticket>,
    /// The move of the plan that a contact ended, and the share of it at which it stands.
    contact: Option<(usize, f64)>,
    /// An input is watched that is only looked at now and then.
    looks_often: bool,
    asked_s: f64,
    /// While nothing moves: the moment of machine time that was told last, and when.
    stood: Option<(f64, Instant)>,
    failure: Option<Fault>,
    /// A setting of the controller that was changed, and is put back.
    owed: Option<Changed>,
    /// The line itself is gone.
    dead: bool,
    /// The run is over, and what it leaves on is meant to be.
    closed: bool,
}

impl Connection {
    /// Speaks to a controller until it has told who it is.
    ///
    /// # Errors
    /// Nobody answers, or something that is no such controller, or one that cannot be driven as it is set.
    pub fn open(name: &str, driver: Box<dyn Wired>, line: Box<dyn Line>) -> Result<Self, String> {
        Self::new(name, driver, line).greeted()
    }

    /// The same, after it has stopped what may go on from a run that has no end.
    ///
    /// # Errors
    /// As [`Connection::open`].
    pub fn open_stopped(
        name: &str,
        driver: Box<dyn Wired>,
        line: Box<dyn Line>,
    ) -> Result<Self, String> {
        let mut connection = Self::new(name, driver, line);
        connection.link.stop(0.0);
        connection.greeted()
    }

    fn new(name: &str, driver: Box<dyn Wired>, line: Box<dyn Line>) -> Self {
        Self {
            name: name.to_owned(),
            link: Link::new(driver),
            line,
            since: Instant::now(),
            facts: Facts::default(),
            offset: Axes::default(),
            row: Row::default(),
            done: 0,
            open: 0,
            wanted: 0,
            ordered: 0,
            rpm: None,
            feed: 1.0,
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
            closed: false,
        }
    }

    /// Waits until it has told who it is.
    fn greeted(mut self) -> Result<Self, String> {
        while self.now_s() < GREETING_S && !self.dead {
            self.carry(NAP);
            if let Some(trouble @ Trouble::Unfit { .. }) = self.link.driver().trouble() {
                return Err(format!("{}: {trouble}", self.name));
            }
            if let Some(facts) = self.link.driver().facts().cloned() {
                self.facts = facts;
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

    /// Returns the setting of the controller that was changed to drive it.
    pub const fn changed(&self) -> Option<Changed> {
        self.owed
    }

    /// A run that has no end has left a setting changed: it is put back behind this one.
    pub const fn owes(&mut self, changed: Changed) {
        if self.owed.is_none() {
            self.owed = Some(changed);
        }
    }

    /// Puts back what was changed in the controller; tells whether that is done.
    fn put_back(&mut self) -> bool {
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
    pub fn home(&mut self, is_stopped: impl Fn() -> bool) -> Result<(), String> {
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

    /// Leaves its port to something that is done to the controller, and speaks to it again afterwards: what
    /// came of that, and what the controller is then, or why it does not answer; then nothing moves any more.
    pub fn anew<T>(
        &mut self,
        does: impl FnOnce() -> T,
        opens: impl FnOnce() -> Result<(Box<dyn Wired>, Box<dyn Line>), String>,
    ) -> (T, Result<String, String>) {
        self.finish(|| false);
        let (place, owed) = (self.place(), self.owed);
        self.line = Box::new(Closed);
        let done = does();
        match opens().and_then(|(driver, line)| Self::open(&self.name, driver, line)) {
            Ok(connection) => {
                *self = connection;
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

    fn now_s(&self) -> f64 {
        self.since.elapsed().as_secs_f64()
    }

    /// Returns its place when it told last, machine frame.
    fn place(&mut self) -> Option<Axes> {
        let standing = self.link.driver().stands()?;
        Some(standing.position.plus(self.offset))
    }

    /// Moves bytes both ways.
    fn carry(&mut self, wait: Duration) {
        if self.dead {
            return;
        }
        let now_s = self.now_s();
        let out = self.link.driver().speak(now_s);
        let mut bytes = [0; 1024];
        let sent = if out.is_empty() { Ok(()) } else { self.line.write(&out) };
        match sent.and_then(|()| self.line.read(&mut bytes, wait)) {
            Ok(count) => {
                let now_s = self.now_s();
                self.link.driver().hear(&bytes[..count], now_s);
            }
            Err(why) => {
                self.dead = true;
                self.fail(why, "look at its cable and its power", None, true);
            }
        }
    }

    /// Looks what became of orders; sends what is due.
    fn tend(&mut self, wait: Duration) {
        let now_s = self.now_s();
        let each_s = if self.looks_often { LOOK_S } else { ASK_S };
        if (self.open == 0 || self.looks_often) && now_s - self.asked_s > each_s {
            self.asked_s = now_s;
            self.link.driver().signal(Signal::Ask, now_s);
        }
        self.carry(wait);
        let told = self.link.poll(self.now_s());
        for told in told {
            match told {
                Told::Done(ticket) => {
                    self.done = ticket;
                    self.open = self.open.saturating_sub(1);
                    if self.probing == Some(ticket) {
                        self.probed();
                    }
                }
                Told::Input { line, on } => {
                    if on {
                        self.active.insert(line)
                    } else {
                        self.active.remove(&line)
                    };
                    self.inputs.push_back((line, on));
                }
                Told::State(state) => self.state_is(state),
            }
        }
        // What the link has just given goes out without waiting for the next look.
        self.carry(Duration::ZERO);
        let stopped = self.link.driver().trouble().cloned();
        if let Some(trouble) = stopped.filter(|trouble| !matches!(trouble, Trouble::Locked { .. }))
        {
            self.troubled(&trouble, None);
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
        self.fail(format!("{}: {trouble}", self.name), hint, at, false);
    }

    fn fail(&mut self, message: String, hint: &'static str, at: Option<At>, silent: bool) {
        let stands = self.place();
        let failure = Fault { message, hint, at, silent, stands };
        let _ = self.failure.get_or_insert(failure);
    }

    /// Fails because the program asks for an output that the controller does not have.
    fn lacks(&mut self, number: u8) {
        let what = no_output(&self.facts, number);
        self.fail(format!("{} {what}", self.name), "", None, false);
    }

    fn order(&mut self, order: Order) -> Option<Ticket> {
        let ticket = self.link.order(order)?;
        self.open += 1;
        Some(ticket)
    }

    /// Tells whether another move may be handed over.
    const fn has_room(&self) -> bool {
        self.open < AHEAD && self.failure.is_none()
    }

    /// Hands a move over, after the outputs that should be on. One that ends at a change of the probe is alone.
    fn hand(&mut self, made: &Move, watches: &[Watch]) {
        let probes = self.probes(made, watches);
        if self.contact.is_some() || self.probing.is_some() || probes.is_some() && self.open > 0 {
            return;
        }
        self.switch_outputs();
        let chords = chords(made, self.facts.arc_tolerance_mm);
        let mut speed_mm_s = speed_mm_s(made, &chords);
        if made.kind == MoveKind::Jog {
            // An override is of cuts.
            speed_mm_s /= f64::from(self.feed);
        }
        self.looks_often = !watches.is_empty() && probes.is_none();
        if let Some(Watch { active, .. }) = probes {
            let order = Order::Probe { to: made.to.minus(self.offset), speed_mm_s, active };
            self.probing = self.order(order);
        } else if self.looks_often {
            speed_mm_s = speed_mm_s.min(POLLED_MM_S);
        }
        let mut handed = Handed { at: made.at, from: made.from, chords: Vec::new() };
        for (share, to) in chords {
            let order = Order::Move { to: to.minus(self.offset), speed_mm_s };
            let Some(ticket) = self.probing.or_else(|| self.order(order)) else { return };
            handed.chords.push(Chord { ticket, share, to });
        }
        self.row.push(handed);
    }

    /// The input at whose change the controller itself ends a move: its probe, where the move is straight, nothing else
    /// is watched, and the probe is not there already.
    fn probes(&self, made: &Move, watches: &[Watch]) -> Option<Watch> {
        let [watch] = watches else { return None };
        let is_there = self.active.contains(&watch.input) == watch.active;
        let straight = matches!(made.path, Path::Line) && made.from != made.to;
        (self.facts.probe == Some(watch.input) && straight && !is_there).then_some(*watch)
    }

    /// The order that probes is done: where a contact ended it, the rest of its move is not made.
    fn probed(&mut self) {
        self.probing = None;
        let Some(contact) = self.link.driver().contact() else { return };
        let place = contact.plus(self.offset);
        let last = self.row.next().saturating_sub(1);
        self.contact = Some((last, self.row.along_last(place)));
    }

    /// An output is to be on or off from here on.
    fn want(&mut self, line: u8, on: bool) {
        let bit = self.facts.outputs & (1 << (line - 1));
        self.wanted = if on { self.wanted | bit } else { self.wanted & !bit };
        self.switch_outputs();
    }

    /// The speed of the spindle from here on.
    fn spin(&mut self, rpm: f64) {
        self.rpm = Some(rpm);
        self.order(Order::Spindle { rpm });
    }

    fn switch_outputs(&mut self) {
        for line in 1..=u32::BITS as u8 {
            let bit = 1 << (line - 1);
            if (self.wanted ^ self.ordered) & bit == 0 {
                continue;
            }
            let on = self.wanted & bit != 0;
            if line == 1 && on {
                // A spindle without a speed does not turn.
                let rpm = self.rpm.unwrap_or(self.facts.spindle_rpm);
                self.order(Order::Spindle { rpm });
            }
            self.order(Order::Output { line, on });
        }
        self.ordered = self.wanted;
    }

    /// Slows down on the path, stops, and begins anew from where it stands. Outputs are off until the next
    /// move, whatever the machine should have on.
    fn stop_at_once(&mut self) {
        let until_s = self.now_s() + STOPPING_S;
        self.link.stop(self.now_s());
        while !self.dead {
            let now_s = self.now_s();
            if now_s - self.asked_s > ASK_S / 2.0 {
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
        (self.done, self.open, self.ordered) = (0, 0, 0);
        (self.probing, self.contact, self.looks_often) = (None, None, false);
        // Its reset has set the override back.
        if self.feed != 1.0 {
            self.feed(self.feed);
        }
    }

    /// The moment that is reached of a move, as far as it is known.
    fn reached_s(&mut self, going: &Going<'_>) -> f64 {
        let place = self.place();
        let share = match self.contact {
            Some((index, share)) if index == going.index => share.min(1.0 - f64::EPSILON),
            _ => self.row.share(going.index, self.done, place),
        };
        if share >= 1.0 {
            return f64::INFINITY;
        }
        going.t0_s + going.plan.time_at_share(going.index, share)
    }

    /// Returns `true` while something that was ordered is not done.
    const fn is_busy(&self) -> bool {
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
            self.wanted = 0;
            self.stop_at_once();
        }
        self.put_back();
        self.closed = true;
    }
}

impl Machine for Connection {
    fn name(&self) -> &str {
        &self.name
    }

    fn facts(&self) -> &Facts {
        &self.facts
    }

    fn refuses(&self, mv: &Move) -> Option<String> {
        let why = out_of_reach(&self.facts, mv.from, mv.to, self.offset)?;
        Some(format!("{} {why}", self.name))
    }

    fn is_real(&self) -> bool {
        true
    }

    fn begin(&mut self) {
        self.closed = false;
    }

    fn begin_plan(&mut self) {
        (self.contact, self.looks_often) = (None, false);
        self.row.begin();
    }

    fn set(&mut self, actuator: &Actuator) {
        match *actuator {
            Actuator::Output { number, on, why } if why != OutputReason::Trigger => {
                let lacks = needs(&self.facts, number, why);
                match wired(number) {
                    Some(_) if lacks && on => self.lacks(number),
                    Some(line) if !lacks => self.want(line, on),
                    _ => {}
                }
            }
            Actuator::Spindle { rpm } => self.spin(rpm),
            Actuator::Coolant { mist, flood } => {
                self.want(FLOOD, flood);
                self.want(MIST, mist);
            }
            other => {
                if let Some(what) = lacked(&other) {
                    self.fail(format!("{} has no {what}", self.name), "", None, false);
                }
            }
        }
    }

    fn advance(&mut self, going: &Going<'_>, _: f64, until_s: f64) -> News {
        self.stood = None;
        // What is known to be made already is not waited for.
        let reached_s = self.reached_s(going);
        if reached_s >= until_s {
            return News { reached_s, input: None };
        }
        self.row.come_to(going.index);
        let moves = going.plan.moves();
        while self.has_room() && self.row.next() < moves.len().min(going.until) {
            let next = self.row.next();
            self.hand(&moves[next], going.watches);
            if self.row.next() == next {
                break;
            }
        }
        self.tend(NAP);
        let input = self.inputs.pop_front();
        let leads = input.is_none() && leads(going, until_s);
        News { reached_s: if leads { until_s } else { self.reached_s(going) }, input }
    }

    fn stand(&mut self, from_s: f64, until_s: f64) -> News {
        let before = self.stood.filter(|(told_s, _)| *told_s == from_s);
        let (_, since) = before.unwrap_or_else(|| (from_s, Instant::now()));
        if until_s > from_s {
            self.tend(NAP);
        }
        let reached_s = (from_s + since.elapsed().as_secs_f64()).min(until_s);
        self.stood = Some((reached_s, Instant::now()));
        News { reached_s, input: self.inputs.pop_front() }
    }

    fn look(&mut self) {
        self.tend(Duration::ZERO);
    }

    fn settle(&mut self) -> bool {
        if self.is_busy() {
            self.tend(NAP);
        }
        self.is_busy()
    }

    fn stop(&mut self, going: &Going<'_>) -> Option<f64> {
        if let Some((index, share)) = self.contact.take() {
            self.row = Row::default();
            return Some(going.t0_s + going.plan.time_at_share(index, share));
        }
        // The end of the piece before is made: what it belongs to is told already.
        while self.done < self.row.before && self.is_busy() {
            self.tend(NAP);
        }
        let done = self.done;
        if self.failure.is_none() {
            self.stop_at_once();
        }
        let place = self.place()?;
        let (index, share) = self.row.locate(done, place).unwrap_or((going.index, 0.0));
        self.row = Row::default();
        Some(going.t0_s + going.plan.time_at_share(index, share))
    }

    fn feed(&mut self, share: f32) {
        if self.facts.overrides {
            self.feed = share;
            self.link
                .driver()
                .signal(Signal::Feed(percent(share)), self.since.elapsed().as_secs_f64());
        }
    }

    fn give_up(&mut self) {
        let why = format!("{} was stopped before it had made its last moves", self.name);
        let hint = "it was held at the controller: look why before the next file";
        self.fail(why, hint, None, false);
    }

    fn waits(&mut self) -> Option<&'static str> {
        self.link.driver().waits()
    }

    fn fault(&self) -> Option<&Fault> {
        self.failure.as_ref()
    }
}

impl Drop for Connection {
    fn drop(&mut self) {
        // Whoever forgot to close it has left in the middle.
        if self.open > 0 || self.ordered != 0 && !self.closed {
            self.stop_at_once();
        }
        self.put_back();
    }
}
