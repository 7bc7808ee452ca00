//! A board with step queues as a machine that a run drives.

use super::board_port::BoardPort;
use super::facts;
use super::feeder::{Feeder, Scale};
use super::height::{EVERY_S, Height, Sensor};
use super::homing::{Came, Homing};
use super::outputs::Outputs;
use super::run_lead::RunLead;
use super::steering::{self, Steering};
use super::touch::Probe;
use super::wiring::Wiring;
use crate::controller::connection::NAP;
use kerf_driver_klipper::board::{Ended, Home, News as BoardNews, Start};
use kerf_driver_klipper::mailbox::{Answer, Progress, Request, Set};
use kerf_driver_klipper::tmc::Trouble;
use kerf_machine::driver::Facts;
use kerf_machine::lines::Input;
use kerf_machine::{Fault, Going, Machine as _};
use kerf_program::settings::IoModes;
use kerf_program::{At, Axes, Axis, AxisSet, HeightLaw, Settings};
use std::collections::VecDeque;
use std::time::Duration;

/// Time behind the last step after which it has surely been made, seconds.
const SETTLED_S: f64 = 0.005;
/// A board that was told to stop is waited for at most so long, seconds.
const STOPPING_S: f64 = 3.0;
/// A moment that is reached but for the rounding of a sum, seconds.
pub(super) const SAME_S: f64 = 1e-9;
/// Counts are waited for at most so long before a fault is told, seconds.
const COUNTING_S: f64 = 1.0;
/// Time before its end at which a move that is handed over counts, while it is made, seconds.
const NEARLY_S: f64 = 1e-6;

/// The state of motion, as far as it is known here.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum State {
    /// Latches are not armed.
    Rest,
    /// They are asked for.
    Starting,
    /// Pieces go out, by this scale; the board has motion up to a clock.
    Moving(Scale, u64),
}

/// A board with step queues.
pub struct Queued {
    pub(super) name: String,
    pub(super) facts: Facts,
    pub(super) wiring: Wiring,
    pub(super) per_unit: Axes,
    pub(super) port: Box<dyn BoardPort>,
    pub(super) progress: Progress,
    pub(super) feeder: Feeder,
    pub(super) state: State,
    pub(super) outputs: Outputs,
    /// Changes of outputs that come with the next piece.
    pub(super) changes: Vec<(usize, f64)>,
    pub(super) inputs: VecDeque<(u8, bool)>,
    /// States of the inputs, a bit each.
    pub(super) pressed: u8,
    /// Modes of the inputs.
    pub(super) io: IoModes,
    /// Counts of the motors as they were told last, and what they are where its axis stands at 0.
    pub(super) counts: Vec<i64>,
    pub(super) zeros: Vec<i64>,
    /// Place where it stands, when that is not the end of the plan.
    pub(super) elsewhere: Option<Axes>,
    /// It has come to rest by itself, on the path, because nothing followed in time.
    pub(super) late: bool,
    /// The line of the move at hand.
    pub(super) at: Option<At>,
    /// Time by which the run is ahead.
    pub(super) lead: RunLead,
    /// A motor driver that is not well and goes on, in a sentence that was not told yet.
    pub(super) told_drivers: Option<String>,
    /// While nothing moves: the moment of machine time that was told last, and when.
    pub(super) stood: Option<(f64, f64)>,
    /// Switches that stop motors of their own in the motion that begins next.
    pub(super) homes: Vec<Home>,
    /// Switches that stopped motors in the motion under way, with the counts of the motors then.
    pub(super) edges: Vec<(usize, u64, Vec<i64>)>,
    /// Homing under way.
    pub(super) homing: Option<Homing>,
    /// The end of a motion of homing, which was not looked at.
    pub(super) came: Option<Came>,
    /// Switches whose states are asked for, and what they told.
    pub(super) asked: Vec<(usize, Option<bool>)>,
    /// The moment of machine time that was told last, seconds.
    pub(super) told_s: f64,
    /// Inputs at whose change it stands by itself.
    pub(super) probe: Probe,
    /// The pin that measures the height of a torch.
    pub(super) sensor: Sensor,
    /// A sentence where the thread of the link has no real-time priority.
    pub(super) priority: Option<String>,
    /// Nothing more is done.
    pub(super) fault: Option<Fault>,
    /// It is told from this moment on, or once it is known where the machine stands.
    pub(super) tells_s: f64,
}

impl Queued {
    /// A board that is ready, with the name that people use, the version of its program, the counts of its motors, and
    /// steps for a millimetre or a degree.
    pub fn new(
        name: &str,
        version: &str,
        (wiring, per_unit): (Wiring, Axes),
        counts: Vec<i64>,
        port: Box<dyn BoardPort>,
    ) -> Self {
        let motors: Vec<Axis> = wiring.motors.iter().map(|motor| motor.axis).collect();
        let mut queued = Self {
            name: name.to_owned(),
            facts: facts::of(version, &wiring),
            feeder: Feeder::new(motors, per_unit),
            wiring,
            per_unit,
            port,
            progress: Progress::default(),
            state: State::Rest,
            outputs: Outputs::default(),
            changes: Vec::new(),
            inputs: VecDeque::new(),
            pressed: 0,
            io: IoModes::default(),
            zeros: vec![0; counts.len()],
            counts,
            elsewhere: None,
            late: false,
            at: None,
            lead: RunLead::default(),
            told_drivers: None,
            stood: None,
            homes: Vec::new(),
            edges: Vec::new(),
            homing: None,
            came: None,
            asked: Vec::new(),
            told_s: f64::NEG_INFINITY,
            probe: Probe::default(),
            sensor: Sensor::default(),
            priority: None,
            fault: None,
            tells_s: f64::INFINITY,
        };
        queued.count_anew();
        queued.learn_inputs();
        for enable in &queued.wiring.enables {
            queued.port.request(Request::Output { output: *enable, share: 1.0 });
        }
        queued
    }

    /// The counts of the motors stand for the place that the plan leads to.
    pub(super) fn count_anew(&mut self) {
        let made = self.wiring.motors.iter().map(|motor| self.feeder.made(motor.axis));
        self.zeros = self.counts.iter().zip(made).map(|(count, made)| count - made).collect();
    }

    /// Place of the axes by the counts of the motors.
    pub fn counted(&self) -> Axes {
        let mut place = Axes::default();
        let motors = self.wiring.motors.iter().zip(self.counts.iter().zip(&self.zeros));
        for (motor, (count, zero)) in motors {
            place[motor.axis] = (count - zero) as f64 / self.per_unit[motor.axis];
        }
        place
    }

    /// Places of the axes as the counts of their motors have them, whatever the machine calls them.
    pub fn by_counts(&self) -> Axes {
        let mut place = Axes::default();
        for (motor, count) in self.wiring.motors.iter().zip(&self.counts) {
            place[motor.axis] = *count as f64 / self.per_unit[motor.axis];
        }
        place
    }

    /// One of the boards has counted nothing since it was powered, or all have come back to where they began.
    pub fn is_fresh(&self) -> bool {
        let motors = self.wiring.setup.motors.iter().zip(&self.counts);
        let boards = 0..self.wiring.pins.boards.len();
        boards.into_iter().any(|board| {
            let mut own = motors.clone().filter(|(motor, _)| motor.step.board == board).peekable();
            own.peek().is_some() && own.all(|(_, count)| *count == 0)
        })
    }

    /// The machine is where it stands: from here on places are counted so.
    pub fn is_at(&mut self, place: Axes) {
        self.feeder.is_at(place);
        self.count_anew();
        self.elsewhere = None;
    }

    /// Axes that have a motor.
    pub fn axes(&self) -> AxisSet {
        self.wiring.axes()
    }

    /// Numbers of its outputs that go on and off.
    pub fn outputs(&self) -> Vec<u8> {
        self.wiring.outputs.iter().map(|(number, _)| *number).collect()
    }

    /// Counts of its motors, as the board told last, and as they are planned from the place that is zero on.
    pub fn counts(&self) -> [Vec<i64>; 2] {
        let made = self.wiring.motors.iter().zip(&self.zeros);
        let planned = made.map(|(motor, zero)| zero + self.feeder.made(motor.axis));
        [self.counts.clone(), planned.collect()]
    }

    /// Progress of the board, as it was told last.
    pub const fn progress(&self) -> Progress {
        self.progress
    }

    /// Inputs that changed and were not told, in order: by number, and whether active.
    pub fn take_inputs(&mut self) -> Vec<(u8, bool)> {
        self.inputs.drain(..).collect()
    }

    /// Closes its port: whoever opens it anew has another board.
    pub fn let_go(&mut self) {
        self.port = Box::new(Gone);
        self.fail("its port is closed".into(), "", true);
    }

    /// Clock of the board at a moment of machine time, while it is in motion.
    pub fn clock_at(&self, t_s: f64) -> Option<f64> {
        match self.state {
            State::Moving(scale, _) => Some(scale.at(t_s)),
            _ => None,
        }
    }

    /// Ticks of a time, seconds.
    pub(super) fn ticks(&self, time_s: f64) -> u64 {
        match self.state {
            State::Moving(scale, _) => (time_s * scale.rate) as u64,
            _ => 0,
        }
    }

    /// Looks what became of requests, waiting for a moment at most.
    pub(super) fn tend(&mut self, wait: Duration) {
        let (progress, answers) = self.port.look(wait);
        let gap_s = progress.at_s - self.progress.at_s;
        self.lead.looked(gap_s, wait.as_secs_f64(), self.state != State::Rest);
        self.progress = progress;
        for answer in answers {
            match answer {
                Answer::Started(Start { clock, ticks_per_s }) => {
                    let begin_s = self.feeder.begins_s().unwrap_or(self.feeder.handed_s);
                    let scale = Scale { from: (begin_s, clock as f64), rate: ticks_per_s };
                    self.state = State::Moving(scale, clock);
                }
                Answer::Refused(why) => self.fail(why, "nothing moves any more", false),
                Answer::News(news) => self.hear(news),
            }
        }
        let now_s = match (self.state, self.progress.clock) {
            (State::Moving(scale, _), Some((now, _))) => Some(scale.moment(now)),
            _ => None,
        };
        let is_on = |number| self.wiring.is_on(self.pressed, &self.io, number);
        self.feeder.height.iter_mut().for_each(|height| height.feel(is_on, now_s));
        if let Some(now_s) = now_s {
            self.sensor.look(now_s, self.feeder.height.as_mut());
        }
    }

    /// Z goes down and up by the input of a torch from here on, as settings have it (VH), or does not.
    pub(super) fn follow_torch(&mut self, settings: &Settings) {
        self.io = settings.io;
        let is_on = |number| self.wiring.is_on(self.pressed, &self.io, number);
        let torch = steering::of_torch(settings, is_on).filter(|_| self.facts.follows_torch);
        Height::follow_torch(&mut self.feeder.height, torch);
    }

    /// The pin of the height is measured from now on, or no more.
    pub(super) fn measures(&mut self, measures: bool) {
        if let Some(voltage) = self.wiring.height.filter(|_| self.sensor.measures != measures) {
            self.sensor = Sensor::new(measures);
            let every_s = measures.then_some(EVERY_S);
            self.port.request(Request::Measure { voltage, every_s });
        }
    }

    /// Z follows a sheet from here on, or does not. Returns what the readings tell of the head, as a contact.
    pub(super) fn follow_sheet(&mut self, law: Option<HeightLaw>) -> Vec<(u8, bool)> {
        self.feeder.height = None;
        let Some(law) = law else { return Vec::new() };
        if !self.facts.follows(&law) {
            let why = "has no height control by this sensor: it reads the voltage of a torch at the pin board.height, or two \
                       switches at the pins of inputs 17 and 20 (board.inputs)";
            self.fail(why.into(), "name the pins, and set height.mode by them", false);
            return Vec::new();
        }
        let is_on = |number| self.wiring.is_on(self.pressed, &self.io, number);
        let steering = Steering::of(&law, is_on);
        if steering == Steering::Readings {
            self.measures(true);
            self.tend(Duration::ZERO);
            if self.feeder.rests {
                self.wait_until(|it| it.sensor.reading().is_some());
            }
        }
        let height = Height::new(law, steering, self.sensor.reading());
        let contacts = height.is_high().map(|is_high| (Input::ZHigh.number(), is_high));
        self.feeder.height = Some(height);
        contacts.into_iter().collect()
    }

    fn hear(&mut self, news: BoardNews) {
        match news {
            BoardNews::Ended { why, counts } => {
                self.counts = counts;
                self.ended(why);
            }
            BoardNews::Buttons(states) => {
                let changed = self.pressed ^ states;
                let numbers = self.wiring.inputs.iter().enumerate();
                let moved = numbers.filter(|(bit, _)| changed & (1 << bit) != 0);
                let moved = moved.map(|(bit, it)| (it.number, states & (1 << bit) != 0));
                let moved: Vec<(u8, bool)> = moved.collect();
                self.pressed = states;
                for (number, is_active) in moved {
                    if !self.ends_motion(number, is_active) {
                        self.inputs.push_back((number, is_active));
                    }
                }
            }
            BoardNews::Shutdown(reason) => {
                let why = format!("the board has shut down: {reason}");
                let hint = "its motors stand and its outputs are off; look why, then connect again";
                self.fail(why, hint, false);
                self.port.request(Request::Recover);
            }
            BoardNews::Fault(fault) => {
                self.fail(
                    fault.to_string(),
                    "its place may be lost: home it first",
                    fault.is_silent(),
                );
            }
            BoardNews::Touched { switch, clock, counts } => {
                self.edges.push((switch, clock, counts))
            }
            BoardNews::Switch { switch, on } => self.switch_told(switch, on),
            BoardNews::Ready { .. } => {}
            BoardNews::Driver(Trouble { name, drives: true, words }) => {
                self.told_drivers =
                    Some(format!("{}: the driver of motor {name}: {words}", self.name));
            }
            BoardNews::Driver(Trouble { name, words, .. }) => {
                let hint = "its place may be lost: home it first";
                self.fail(format!("the driver of motor {name}: {words}"), hint, false);
            }
            BoardNews::Voltage { all, .. } => {
                let scale = match self.state {
                    State::Moving(scale, _) => Some(scale),
                    _ => None,
                };
                self.sensor.measured(&all, scale, self.feeder.height.as_mut());
            }
            BoardNews::Register { .. } => {}
        }
    }

    /// Motion is over: its counts are known.
    fn ended(&mut self, why: Ended) {
        let edges = std::mem::take(&mut self.edges);
        if self.homing.is_some() && matches!(why, Ended::Rested | Ended::Touched) {
            self.state = State::Rest;
            let edges = edges.into_iter().map(|(switch, _, counts)| (switch, counts)).collect();
            self.came = Some(Came { why, counts: self.counts.clone(), edges });
            return;
        }
        if why == Ended::Touched && self.feeder.follow.is_some() {
            // An input leaves outputs as they are, but nothing burns where it stands.
            let off = self.outputs.rests(&self.wiring);
            off.into_iter()
                .for_each(|(output, share)| self.port.request(Request::Output { output, share }));
        }
        if why == Ended::Touched && self.is_touched(&edges) {
            self.state = State::Rest;
            return;
        }
        if let (Ended::Guarded, Some((switch, clock, _))) = (why, edges.first()) {
            self.guarded(*switch, *clock);
        }
        let planned = why == Ended::Rested && self.feeder.rests;
        self.late = why == Ended::Rested && !planned;
        self.state = State::Rest;
        if !planned {
            let place = self.counted();
            self.elsewhere = Some(place);
            let untold = self.fault.as_mut().filter(|_| self.progress.at_s < self.tells_s);
            if let Some(fault) = untold {
                fault.stands = Some(place);
                self.tells_s = f64::NEG_INFINITY;
            }
        }
        match why {
            Ended::Rested | Ended::Asked | Ended::Shutdown | Ended::Guarded => {}
            Ended::Touched => self.fail(
                "an input stopped the machine, and the run was past that place already".into(),
                "its place is known: begin again at this line",
                false,
            ),
            Ended::Deadline | Ended::Late => {
                let why = "the computer was too late with its steps: the board has stopped at once";
                let hint = "its counts are known, but a heavy machine may have slipped: home it";
                self.fail(why.into(), hint, false);
            }
        }
    }

    pub(super) fn fail(&mut self, why: String, hint: &'static str, silent: bool) {
        if self.fault.is_some() {
            return;
        }
        let stands = (self.state == State::Rest).then(|| self.counted());
        let message = format!("{}: {why}", self.name);
        self.tells_s = if stands.is_some() || silent {
            f64::NEG_INFINITY
        } else {
            self.progress.at_s + COUNTING_S
        };
        self.fault = Some(Fault { message, hint, at: self.at, silent, stands, made_s: None });
        self.drop_all();
    }

    /// Motion is dropped, outputs go off.
    pub(super) fn drop_all(&mut self) {
        (self.homing, self.came) = (None, None);
        self.homes.clear();
        self.feeder.only = None;
        self.port.request(Request::Stop);
        self.switch_off();
        self.feeder.forget();
    }

    pub(super) fn switch_off(&mut self) {
        self.changes.clear();
        for (output, share) in self.outputs.off(&self.wiring) {
            self.port.request(Request::Output { output, share });
        }
    }

    /// Hands pieces over as far ahead as the board's lead asks for; tells whether there was one.
    pub(super) fn hand_on(&mut self) -> bool {
        let before = self.feeder.handed_s;
        match self.state {
            State::Rest if self.feeder.begins_s().is_some() && self.progress.rests => {
                self.port.request(Request::Start(std::mem::take(&mut self.homes)));
                self.state = State::Starting;
            }
            State::Moving(..) => while self.hand_over().is_some() {},
            _ => {}
        }
        self.feeder.handed_s > before
    }

    /// Hands one piece over, where there is one and it is time for it.
    fn hand_over(&mut self) -> Option<()> {
        let State::Moving(scale, starts) = self.state else { return None };
        let (now, off) = self.progress.clock?;
        let begin_s = self.feeder.begins_s()?;
        let [_, lead_s] = self.progress.lead_s;
        let earliest = now + off + self.ticks(RunLead::least_s(lead_s));
        let late = self.feeder.rests && scale.at(begin_s) < earliest as f64;
        let from = (begin_s, earliest.max(starts) as f64);
        let scale = if late { Scale { from, ..scale } } else { scale };
        let clock = (scale.at(begin_s) as u64).max(starts);
        if clock > now + off + self.ticks(self.lead.ahead_s(lead_s)) || self.fault.is_some() {
            return None;
        }
        let (piece, [followed, behind]) = self.feeder.piece(&scale, starts)?;
        let clock = clock.min(piece.ends);
        let set = |(output, share)| Set { output, share, clock };
        let sets = self.changes.drain(..).map(set).chain(followed).collect();
        self.state = State::Moving(scale, piece.ends);
        self.port.request(Request::Offer(piece, [sets, behind]));
        Some(())
    }

    /// The moment of a move that is reached: what was handed over is made, whatever comes. Where the plan ends at a stand
    /// nobody goes on before the machine is there.
    pub(super) fn reached_s(&self, going: &Going<'_>) -> f64 {
        let (begin_s, end_s) = going.plan.span_s(going.index);
        let [begin_s, end_s] = [begin_s, end_s].map(|s| going.t0_s + s);
        if self.probe.is_armed() && !self.feeder.starves {
            return self.passed_s(end_s).clamp(begin_s, end_s.max(begin_s));
        }
        let handed_s = self.feeder.handed_s;
        let is_handed = self.feeder.starves || handed_s >= end_s - SAME_S;
        let is_last = going.index + 1 == going.plan.moves().len();
        let waits = is_last && self.feeder.rests && !self.is_made();
        if is_handed && !waits {
            return f64::INFINITY;
        }
        handed_s.clamp(begin_s, (end_s - NEARLY_S).max(begin_s))
    }

    /// Everything that was handed over is made, as far as the board's clock tells.
    pub(super) fn is_made(&self) -> bool {
        let State::Moving(_, ends) = self.state else { return self.state == State::Rest };
        let settled = ends + self.ticks(SETTLED_S);
        self.feeder.rests && self.progress.clock.is_some_and(|(now, _)| now > settled)
    }

    /// Switches what waits for the next move, which does not come.
    pub(super) fn switch_now(&mut self) {
        for (output, share) in std::mem::take(&mut self.changes) {
            self.port.request(Request::Output { output, share });
        }
    }

    /// Waits until something holds or the time is over.
    pub(super) fn wait_until(&mut self, holds: impl Fn(&Self) -> bool) -> bool {
        let until_s = self.progress.at_s + STOPPING_S;
        while !holds(self) {
            if self.progress.at_s > until_s {
                return false;
            }
            self.tend(NAP);
        }
        true
    }

    /// The run is over: what it left is made, or dropped where it did not end well.
    pub fn close(&mut self, well: bool, mut is_stopped: impl FnMut() -> bool) {
        while well && self.settle() && !is_stopped() {}
        if !well || self.fault.is_some() || !self.is_made() {
            self.drop_all();
        }
        self.port.request(Request::LetRest);
        self.wait_until(|it| it.state == State::Rest);
        self.measures(false);
        (self.sensor, self.feeder.height) = (Sensor::default(), None);
        self.check_drivers();
    }

    /// Has the board look at its motor drivers; what is wrong with them is told when it is known.
    pub(super) fn check_drivers(&mut self) {
        if !self.wiring.setup.tuned.is_empty() {
            self.port.request(Request::CheckDrivers);
        }
    }
}

impl Drop for Queued {
    fn drop(&mut self) {
        // An output that is left on would have the board shut down by itself.
        self.drop_all();
    }
}

/// A board that somebody else has.
struct Gone;

impl BoardPort for Gone {
    fn request(&mut self, _: Request) {}

    fn look(&mut self, _: Duration) -> (Progress, Vec<Answer>) {
        (Progress::default(), Vec::new())
    }
}
