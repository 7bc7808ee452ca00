//! Moves by hand: what a person has the machine do beside jobs and part files (Profiler reference,
//! "Changing the Tool Position").
//!
//! A [`Hand`] is an interpreter like a job: it is stepped, gives commands, and is stopped and goes on by
//! the same table of states.

use crate::homing::soft_bounds;
use crate::lines::Input;
use crate::sequence::{CHORDS, Word, planner_settings, rapid_mm_s};
use crate::settings::Configuration;
use crate::state::{Effect, Event, State, StopSettings};
use kerf_diag::{Code, Diagnostic, Place};
use kerf_geom::{Arc2, Point2, Polyarc, Segment};
use kerf_program::job::{Job, JobShape};
use kerf_program::settings::Mode;
use kerf_program::{
    AXES, Answer, Arc as Turn, At, Axes, Axis, AxisSet, Button, Command, Feed, Frame, Halted, Host,
    Interpreter, Line, MoveKind, Question, QuestionKind, Settings, Sourced, Status, Step,
    StoppedBy, Watch,
};
use std::collections::VecDeque;
use std::sync::Arc;
use std::task::Poll;

/// Places closer than this are the same, mm or degrees.
const SAME: f64 = 1e-9;

/// Without a bound a key that is held moves so far, mm or degrees.
pub const FAR: f64 = 10_000.0;

/// So long a stop input is waited for to be released before the operator is asked again, seconds.
const RELEASE_S: f64 = 0.5;

/// What a person wants.
#[derive(Clone, Debug, PartialEq)]
pub enum Errand {
    /// Find the home switches of these axes.
    FindHome(AxisSet),
    /// To home on these axes, Z first.
    Home(AxisSet),
    /// To the job origin in X and Y, Z at least at Z top.
    Origin,
    /// To the finish position of jobs, in the same way.
    Finish,
    /// To a place; axes without a value stay.
    To {
        /// X and Y from the job origin, the others from home; or all from where the tool is.
        place: [Option<f64>; AXES],
        /// From where the tool is.
        relative: bool,
        /// X and Y first, then the others; else all together.
        flat: bool,
    },
    /// In X and Y at Z top, from the job origin.
    CutMoveTo([f64; 2]),
    /// Along lines and arcs, one after the other. A stop ends it for good where the tool stands then.
    Along(Arc<[Stretch]>),
    /// For as long as a key is held.
    Held(Held),
    /// For as long as a key of the keypad of part files is held.
    Keypad(Keypad),
}

impl Errand {
    /// What it is called.
    pub const fn name(&self) -> &'static str {
        match self {
            Self::FindHome(_) => "homing",
            Self::Home(_) => "move to home",
            Self::Origin => "move to origin",
            Self::Finish => "move to finish",
            Self::To { .. } => "move to",
            Self::CutMoveTo(_) => "cut move to",
            Self::Along(_) => "move along",
            Self::Held(_) => "key",
            Self::Keypad(_) => "keypad",
        }
    }
}

/// A part of a way that is followed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stretch {
    /// A line or an arc, millimetres from the job origin. A line begins where the tool is.
    pub path: Segment,
    /// Z at its end, millimetres from home; without it Z stays.
    pub z_mm: Option<f64>,
}

/// A key that is held.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Held {
    /// Which way, −1, 0 or 1 an axis.
    pub way: [i8; AXES],
    /// Share of the highest speeds, 0.01 … 1.
    pub speed: f64,
    /// Share of the highest accelerations, 0.01 … 1.
    pub accel: f64,
    /// Z may go below Z bottom, which is being set.
    pub sets_bottom: bool,
}

/// A key of the keypad of part files (command reference, SK): it moves as jogs do, with the keypad's own
/// ramp.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Keypad {
    /// Which way, mm or degrees of each axis.
    pub way: [f64; AXES],
    /// How many times that at most; without it as far as the axes go.
    pub times: Option<f64>,
    /// Share of the jog speeds, 0.01 … 1.
    pub speed: f64,
    /// Axes whose lengths count, since they were homed.
    pub bounded: AxisSet,
}

/// The settings with which the keypad moves: a share of the jog speeds, its own ramp, no warning.
pub fn keypad_settings(settings: &Settings, share: f64) -> Settings {
    let mut settings = settings.clone();
    let jog = &mut settings.speeds.jog;
    for speed in [&mut jog.xy, &mut jog.z, &mut jog.a, &mut jog.b, &mut jog.c] {
        *speed *= share.clamp(0.01, 1.0);
    }
    settings.ramps.jog_rate_mm = settings.ramps.keypad_rate_mm;
    settings.warning_s = 0.0;
    settings
}

/// A way to a place, machine frame.
#[derive(Clone, Copy, Debug)]
struct Leg {
    to: Axes,
    /// The arc in X and Y; else it is straight.
    arc: Option<Arc2>,
}

impl From<Axes> for Leg {
    fn from(to: Axes) -> Self {
        Self { to, arc: None }
    }
}

/// An errand being done.
#[derive(Clone, Debug)]
pub struct Hand {
    errand: Errand,
    machine: Arc<Configuration>,
    settings: Arc<Settings>,
    frame: Frame,
    position: Axes,
    /// Ways still to go.
    legs: VecDeque<Leg>,
    /// Where the rest leads, while the machine is stopped.
    rest: Option<VecDeque<Leg>>,
    given: bool,
    begun: bool,
    state: State,
    motions: u64,
    /// The stop input that blocks it.
    blocked_by: u8,
    /// Why it is not moving.
    why: Arc<str>,
    /// What is said when it is done.
    note: Option<Arc<str>>,
    over: Option<(Status, Option<Box<Diagnostic>>)>,
}

impl Hand {
    /// An errand of a machine that stands at a position, machine frame.
    pub fn new(errand: Errand, machine: Arc<Configuration>, position: Axes, frame: Frame) -> Self {
        let mut settings = match &errand {
            Errand::Keypad(keypad) => keypad_settings(&machine.program, keypad.speed),
            _ => planner_settings(&machine),
        };
        if let (Errand::Held(held), Some(dynamics)) = (&errand, &mut settings.dynamics) {
            let share = held.accel.clamp(0.01, 1.0);
            dynamics.accel_mm_s2 = dynamics.accel_mm_s2.zip(Axes::default(), |a, _| a * share);
        }
        let mut hand = Self {
            errand,
            settings: Arc::new(settings),
            machine,
            frame,
            position,
            legs: VecDeque::new(),
            rest: None,
            given: false,
            begun: false,
            state: State::Running,
            motions: 0,
            blocked_by: 0,
            why: Arc::default(),
            note: None,
            over: None,
        };
        hand.legs = hand.ways();
        hand
    }

    /// Where it leads, one way after the other.
    fn ways(&mut self) -> VecDeque<Leg> {
        if let Errand::Along(stretches) = &self.errand {
            return self.along(stretches);
        }
        self.straight_ways().into_iter().map(Leg::from).collect()
    }

    fn straight_ways(&mut self) -> VecDeque<Axes> {
        let here = self.position;
        let job = &self.machine.job;
        match self.errand {
            Errand::FindHome(_) | Errand::Along(_) => VecDeque::new(),
            Errand::Home(axes) => {
                let mut up = here;
                if axes.contains(Axis::Z) {
                    up[Axis::Z] = 0.0;
                }
                let mut home = up;
                axes.iter().for_each(|axis| home[axis] = 0.0);
                [up, home].into()
            }
            Errand::Origin => self.over_the_table([0.0; 2]),
            Errand::Finish => self.over_the_table(job.finish_mm),
            Errand::CutMoveTo(place) => self.over_the_table(place),
            Errand::To { place, relative, flat } => {
                let mut to = here;
                for (axis, value) in Axis::ALL.into_iter().zip(place) {
                    let Some(value) = value else { continue };
                    let zero = match axis {
                        _ if relative => here[axis],
                        Axis::X => job.origin_mm[0],
                        Axis::Y => job.origin_mm[1],
                        _ => 0.0,
                    };
                    to[axis] = zero + value;
                }
                let mut level = to;
                if flat {
                    (2..AXES).for_each(|i| level.0[i] = here.0[i]);
                }
                [level, to].into()
            }
            Errand::Held(held) => {
                let way = held.way.map(f64::from);
                [self.as_far_as_allowed(way, FAR)].into()
            }
            Errand::Keypad(keypad) => {
                [self.as_far_as_allowed(keypad.way, keypad.times.unwrap_or(FAR))].into()
            }
        }
    }

    /// Lines and arcs from the job origin.
    fn along(&self, stretches: &[Stretch]) -> VecDeque<Leg> {
        let [x0, y0] = self.machine.job.origin_mm;
        let on_table = |at: Point2| Point2::new(x0 + at.x, y0 + at.y);
        let mut to = self.position;
        let leg = |stretch: &Stretch| {
            let end = on_table(stretch.path.end());
            (to[Axis::X], to[Axis::Y]) = (end.x, end.y);
            to[Axis::Z] = stretch.z_mm.unwrap_or(to[Axis::Z]);
            let on_table = |arc: Arc2| Arc2 {
                start: on_table(arc.start),
                centre: on_table(arc.centre),
                ..arc
            };
            Leg { to, arc: stretch.path.arc().map(on_table) }
        };
        stretches.iter().map(leg).collect()
    }

    /// Up to Z top where the tool is lower, then to a place from the job origin.
    fn over_the_table(&self, [x, y]: [f64; 2]) -> VecDeque<Axes> {
        let [x0, y0] = self.machine.job.origin_mm;
        let mut up = self.position;
        up[Axis::Z] = up[Axis::Z].max(self.machine.zpos.top_mm);
        let mut there = up;
        (there[Axis::X], there[Axis::Y]) = (x0 + x, y0 + y);
        [up, there].into()
    }

    /// Where a key that is held leads: to the first bound on its way.
    fn as_far_as_allowed(&mut self, way: [f64; AXES], most: f64) -> Axes {
        let ways = Axis::ALL.into_iter().zip(way);
        let mut far = most;
        for (axis, way) in ways.clone().filter(|(_, way)| *way != 0.0) {
            let (low, high) = self.allowed(axis);
            let end = if way > 0.0 { high } else { low };
            let room = ((end - self.position[axis]) / way).max(0.0);
            if room < far {
                far = room;
                self.note = Some(self.ends_at(axis, end));
            }
        }
        let mut to = self.position;
        ways.for_each(|(axis, way)| to[axis] += way * far);
        to
    }

    /// What is said at the end of an axis; at the keypad in the words and units of part files.
    fn ends_at(&self, axis: Axis, end: f64) -> Arc<str> {
        if !matches!(self.errand, Errand::Keypad(_)) {
            let name = self.machine.motors.axis_name(axis);
            return format!("Out of bounds: {name} ends at {end:.3}").into();
        }
        let shown = self.settings.to_user(self.frame.working(Axes::splat(end)))[axis];
        let shown = (shown * 1e4).round() / 1e4;
        format!("Out of bounds: {} ends at {shown}", axis.letter()).into()
    }

    /// Where an axis may go, machine frame: the soft bounds, the table limits while they are checked,
    /// Z no lower than Z bottom.
    fn allowed(&self, axis: Axis) -> (f64, f64) {
        let (bounded, to_bottom) = match self.errand {
            Errand::Held(held) => (true, held.sets_bottom),
            Errand::Keypad(keypad) => (keypad.bounded.contains(axis), true),
            _ => (true, false),
        };
        let free = (f64::NEG_INFINITY, f64::INFINITY);
        let soft = soft_bounds(&self.machine, axis).filter(|_| bounded);
        let (mut low, mut high) = soft.unwrap_or(free);
        let limits = &self.machine.program.limits;
        if limits.check {
            let zero = self.frame.base_zero[axis];
            low = low.max(limits.low[axis] + zero);
            high = high.min(limits.high[axis] + zero);
        }
        if axis == Axis::Z && !to_bottom && self.machine.axes.limit_movement {
            low = low.max(self.machine.zpos.bottom_mm);
        }
        (low, high)
    }

    /// Why it is not done: it leads out of bounds.
    fn refusal(&self) -> Option<Box<Diagnostic>> {
        if matches!(self.errand, Errand::Keypad(_)) && self.settings.mode == Mode::Preview {
            let place = Place::line(self.errand.name().into(), 0);
            let why =
                Diagnostic::new(Code::NotSupported, place, "the keypad moves nothing in preview");
            return Some(Box::new(why.hint("SM sets Move/Cut mode")));
        }
        if self.is_held() {
            return None;
        }
        let (outside, reached) = self.places().into_iter().find_map(|to| {
            let axis = Axis::ALL.into_iter().find(|axis| {
                let (low, high) = self.allowed(*axis);
                let moves = (to[*axis] - self.position[*axis]).abs() > SAME;
                moves && !(low - SAME..=high + SAME).contains(&to[*axis])
            })?;
            Some((axis, to[axis]))
        })?;
        let (low, high) = self.allowed(outside);
        let name = self.machine.motors.axis_name(outside);
        let message = format!("Out of bounds: {name} would reach {reached:.3}");
        let hint = format!("{name} goes from {low:.3} to {high:.3}");
        let place = Place::line(self.errand.name().into(), 0);
        Some(Box::new(Diagnostic::new(Code::OutsideLimits, place, message).hint(hint)))
    }

    /// The places that must be within bounds: the end of the way, all of one that is followed.
    fn places(&self) -> Vec<Axes> {
        if !matches!(self.errand, Errand::Along(_)) {
            return self.legs.back().map(|leg| leg.to).into_iter().collect();
        }
        let mut places = Vec::new();
        for leg in &self.legs {
            places.push(leg.to);
            let mut reaches = |at: Point2| {
                let mut place = leg.to;
                (place[Axis::X], place[Axis::Y]) = (at.x, at.y);
                places.push(place);
            };
            leg.arc.iter().for_each(|arc| arc.extremes(&mut reaches));
        }
        places
    }

    /// It lasts as long as a key is held.
    const fn is_held(&self) -> bool {
        matches!(self.errand, Errand::Held(_) | Errand::Keypad(_))
    }

    /// A stop ends it for good.
    const fn ends_at_stop(&self) -> bool {
        self.is_held() || matches!(self.errand, Errand::Along(_))
    }

    fn stop_settings(&self) -> StopSettings {
        StopSettings::profiler(self.machine.pause.raise)
    }

    fn give(&self, command: Command, out: &mut Vec<Sourced>) {
        out.push(Sourced { at: At::default(), command });
    }

    fn end(&mut self, status: Status, why: Option<Box<Diagnostic>>) -> Step {
        self.over = Some((status, why.clone()));
        Step::Done(status, why)
    }

    fn begin(&mut self, out: &mut Vec<Sourced>) -> Step {
        self.begun = true;
        if let Some(why) = self.refusal() {
            return self.end(Status::Failed, Some(why));
        }
        self.give(Command::Settings(self.settings.clone()), out);
        Step::Ran
    }

    /// The next way.
    fn go(&mut self, leg: Leg, out: &mut Vec<Sourced>) {
        let Leg { to, arc } = leg;
        let rapid = || rapid_mm_s(&self.settings, to.minus(self.position));
        let feed = match self.errand {
            Errand::Keypad(_) => Feed::Axis,
            Errand::Held(held) => Feed::Path(held.speed.clamp(0.01, 1.0) * rapid()),
            _ => Feed::Path(rapid()),
        };
        let kind = MoveKind::Jog;
        let command = match arc {
            None => Command::Line(Line { kind, to, feed }),
            Some(Arc2 { centre, sweep_rad, .. }) => {
                let centre = [centre.x, centre.y];
                Command::Arc(Turn {
                    kind,
                    centre,
                    sweep_rad,
                    to,
                    feed,
                    chords: CHORDS,
                    small: false,
                })
            }
        };
        self.motions += 1;
        (self.position, self.given) = (to, true);
        self.give(command, out);
    }

    fn is_at(&self, place: &Axes) -> bool {
        Axis::ALL.into_iter().all(|axis| (place[axis] - self.position[axis]).abs() <= SAME)
    }

    fn carry_on(&mut self, host: &mut dyn Host, out: &mut Vec<Sourced>) -> Step {
        if self.given {
            if host.settle().is_pending() {
                return Step::Waiting;
            }
            self.given = false;
            self.legs.pop_front();
            return Step::Ran;
        }
        match self.legs.front().copied() {
            Some(leg) if leg.arc.is_none() && self.is_at(&leg.to) => drop(self.legs.pop_front()),
            Some(leg) => self.go(leg, out),
            None if self.rest.is_some() => return self.ask(host, out),
            None => {
                if let Some(text) = self.note.take() {
                    self.give(Command::Message { text }, out);
                }
                return self.end(Status::Ok, None);
            }
        }
        Step::Ran
    }

    /// What follows on a stop: the table says whether the tool rises; the rest of the way is kept.
    fn halt(&mut self, event: Event, halted: &Halted) {
        self.position = halted.stands;
        self.given = false;
        let Some(mut stands) = self.state.on(event, self.stop_settings()) else { return };
        if let Some(next) = stands.state.on(Event::Stands, self.stop_settings()) {
            stands = next;
        }
        self.state = stands.state;
        let mut rest = std::mem::take(&mut self.legs);
        rest.push_front(halted.stands.into());
        self.rest = Some(rest);
        let (top, mut up) = (self.machine.zpos.top_mm, halted.stands);
        if stands.effects.contains(&Effect::Raise) && up[Axis::Z] < top {
            up[Axis::Z] = top;
            self.legs.push_back(up.into());
        }
    }

    fn ask(&mut self, host: &mut dyn Host, out: &mut Vec<Sourced>) -> Step {
        let words = match host.ask(&self.question()) {
            Poll::Pending => return Step::Waiting,
            Poll::Ready(Answer::Text(words)) => words,
            Poll::Ready(Answer::Button(button)) => button.word().to_owned(),
        };
        match Word::read(&words) {
            Some(Word::Continue) => {
                let Some(state) = self.goes_on_in(host, out) else { return Step::Ran };
                self.state = state;
                self.legs = self.rest.take().unwrap_or_default();
                let mut over = self.position;
                if let Some(Leg { to, .. }) = self.legs.front() {
                    (over[Axis::X], over[Axis::Y]) = (to[Axis::X], to[Axis::Y]);
                    self.legs.push_front(over.into());
                }
                let (name, why) = (self.state.name().into(), "".into());
                self.give(Command::State { name, why }, out);
            }
            Some(Word::Abort) if self.state == State::Limited => {
                let why = self.stopped_for(Code::InputStop);
                return self.end(Status::Limit, Some(why));
            }
            Some(Word::Abort) => return self.end(Status::Stopped, None),
            _ => {}
        }
        Step::Ran
    }

    /// The state in which it goes on; nothing while a stop input is active.
    fn goes_on_in(&self, host: &mut dyn Host, out: &mut Vec<Sourced>) -> Option<State> {
        let settings = self.stop_settings();
        match self.state {
            State::Limited => Some(self.state.on(Event::Override, settings)?.state),
            State::Blocked
                if self.settings.io.stops(self.blocked_by, host.input(self.blocked_by)) =>
            {
                let text = "release the stop input".into();
                self.give(Command::Message { text }, out);
                self.give(Command::Wait { seconds: RELEASE_S }, out);
                None
            }
            State::Blocked => {
                let released = self.state.on(Event::Released, settings)?;
                Some(released.state.on(Event::Continue, settings)?.state)
            }
            state => Some(state.on(Event::Continue, settings)?.state),
        }
    }

    fn stopped_for(&self, code: Code) -> Box<Diagnostic> {
        let place = Place::line(self.errand.name().into(), 0);
        Box::new(Diagnostic::new(code, place, self.why.to_string()))
    }

    fn question(&self) -> Question {
        let limited = self.state == State::Limited;
        let [goes_on, ends] = match limited {
            true => [Button::Continue, Button::End],
            false => [Button::Resume, Button::Quit],
        };
        Question {
            kind: if limited { QuestionKind::Limit } else { QuestionKind::Paused },
            text: if self.why.is_empty() { "Paused".into() } else { self.why.to_string() },
            title: "Move".into(),
            buttons: vec![goes_on, ends],
            default: 1,
            prefill: String::new(),
            icon: 0,
            until: None,
        }
    }
}

/// CutMoveTo with cutting: a job of one line from where the tool is, cut through, that ends at its end.
pub fn cut_move(machine: &Configuration, position: Axes, [x, y]: [f64; 2]) -> Job {
    let [x0, y0] = machine.job.origin_mm;
    let (origin, to) = (Point2::new(x0, y0), Point2::new(x, y));
    let from = Point2::new(position[Axis::X] - x0, position[Axis::Y] - y0);
    let shape = JobShape::through(1, Polyarc::lines([from, to], false));
    Job { name: "cut move to".into(), shapes: [shape].into(), origin, finish: to, ..Job::default() }
}

impl Interpreter for Hand {
    fn step(&mut self, host: &mut dyn Host, out: &mut Vec<Sourced>) -> Step {
        match &self.over {
            Some((status, why)) => Step::Done(*status, why.clone()),
            None if !self.begun => self.begin(out),
            None => self.carry_on(host, out),
        }
    }

    fn run(&mut self, host: &mut dyn Host, out: &mut Vec<Sourced>, lines: u64) -> Step {
        for _ in 0..lines.max(1) {
            match self.step(host, out) {
                Step::Ran => {}
                other => return other,
            }
        }
        Step::Ran
    }

    /// Only the emergency stop is watched: it ends a move by hand for good.
    fn interrupt(&mut self, _: &Watch, _: Option<u64>, position: Axes) {
        self.position = position;
        self.why = "emergency stop".into();
        self.over = Some((Status::Stopped, Some(self.stopped_for(Code::InputStop))));
    }

    fn takes_stops(&self) -> bool {
        true
    }

    /// A key is let go for good, and a way that is followed ends; every other way is kept.
    fn stopped(&mut self, by: StoppedBy, halted: &Halted) {
        let (event, why) = match by {
            StoppedBy::Operator | StoppedBy::PowerCut => (Event::Stop, String::new()),
            StoppedBy::Input(n) => {
                self.blocked_by = n;
                (Event::StopInput, format!("stopped by stop input {n}"))
            }
            StoppedBy::Limit(n) => (Event::Limit, format!("stopped by limit input {n}")),
        };
        self.why = why.into();
        if self.ends_at_stop() {
            (self.position, self.legs, self.given) = (halted.stands, VecDeque::new(), false);
            match event {
                Event::Stop => self.over = Some((Status::Ended, None)),
                _ if self.is_held() => self.note = Some(self.why.clone()),
                _ => {
                    let limit = event == Event::Limit;
                    let status = if limit { Status::Limit } else { Status::Stopped };
                    self.over = Some((status, Some(self.stopped_for(Code::InputStop))));
                }
            }
            return;
        }
        self.halt(event, halted);
    }

    fn nudge(&mut self, _: Axes) {}

    fn carried_out(&mut self, _: u64) {}

    fn stop(&mut self, _: &mut dyn Host, _: &mut Vec<Sourced>) -> Step {
        self.end(Status::Stopped, None)
    }

    fn limit(&mut self, _: &mut dyn Host, _: &mut Vec<Sourced>) -> Step {
        self.end(Status::Limit, None)
    }

    /// The emergency stop.
    fn watches(&self) -> Vec<Watch> {
        let input = Input::EmergencyStop.number();
        vec![Watch::level(input, self.machine.estop.active, 0.0)]
    }

    fn file_name(&self, file: u32) -> Option<Arc<str>> {
        (file == 0).then(|| self.errand.name().into())
    }

    fn call_stack(&self) -> Vec<At> {
        vec![At::default()]
    }

    fn motions(&self) -> u64 {
        self.motions
    }

    fn lines(&self) -> u64 {
        0
    }

    fn settings(&self) -> &Arc<Settings> {
        &self.settings
    }

    fn frame(&self) -> &Frame {
        &self.frame
    }

    fn position(&self) -> Axes {
        self.position
    }

    fn variables(&self) -> Vec<(String, String)> {
        Vec::new()
    }
}
