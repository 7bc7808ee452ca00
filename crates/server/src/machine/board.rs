//! What a run has to tell the pages, gathered so that they are told some thirty times a second and
//! not a thousand.

use super::ports;
use crate::hub::Hub;
use crate::told;
use kerf_control::{Doing, Made};
use kerf_machine::Configuration;
use kerf_program::{Axes, MoveKind};
use kerf_sim::Machine;
use kerf_wire::{
    Call, Change, InForce, Io, Message, Motion, NamedValue, Pause, Positions, Snapshot, Sound,
    Speeds, Tone, Units,
};
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Pages are told this often.
pub const TELL: Duration = Duration::from_millis(33);

/// Lines of the print window that wait to be told, at most.
const PRINTED: usize = 1000;

/// The moves of a run as they were planned in its preview.
#[derive(Clone, Debug, Default)]
pub struct Planned {
    /// When each is over, seconds.
    pub times: Arc<[f32]>,
    /// Which path of a job each belongs to, and where it ends in the plane; empty for a part program.
    pub ends: Arc<[PathEnd]>,
}

/// Number of a path, and where a move of it ends, X and Y of the machine frame.
pub type PathEnd = (u32, [f64; 2]);

/// Two sums of the same way may differ in the last digits, mm.
const SAME_MM: f64 = 1e-6;

impl Planned {
    /// How many of the moves are made behind one that ends there, when so many were before. What a pause
    /// adds to a job, and moves by hand, are not in its plan.
    fn made(&self, before: u32, (path, [x, y]): PathEnd) -> u32 {
        if self.ends.is_empty() {
            return before + 1;
        }
        let same = |at: &usize| {
            let (number, [px, py]) = self.ends[*at];
            number == path && (px - x).abs() < SAME_MM && (py - y).abs() < SAME_MM
        };
        let (from, all) = ((before as usize).min(self.ends.len()), self.ends.len());
        // Behind the present place first; a jig may be cut before another.
        let found = (from..all).find(same).or_else(|| (0..from).find(same));
        found.map_or(before, |at| at as u32 + 1)
    }
}

/// Gathers.
#[derive(Debug)]
pub struct Board {
    hub: Arc<Hub>,
    told: Instant,
    motion: Motion,
    units: Units,
    speeds: Speeds,
    io: Io,
    calls: Option<Vec<Call>>,
    watched: Option<Vec<NamedValue>>,
    printed: Vec<String>,
    messages: Vec<Message>,
    pause: Option<Pause>,
    sound: Option<String>,
    /// What the program said last, while nothing came behind it.
    comment: Option<Arc<str>>,
    /// Number of the run.
    run: u32,
    planned: Planned,
    machine: Configuration,
    /// Positions are told up to this speed, mm/s; nothing for never in motion.
    live_mm_s: Option<f64>,
    /// A job runs, no part program.
    is_job: bool,
    /// Where the machine was seen last, told or not.
    seen: Option<Positions>,
    /// Heights in force in a job.
    heights: Option<[f64; 3]>,
    /// What else a pause has changed of it.
    in_force: Option<InForce>,
    /// Moves that were made.
    made: u32,
    /// Share of the speed asked for.
    pub feed: f64,
}

impl Board {
    /// For a run with this plan.
    pub fn new(hub: Arc<Hub>, run: u32, planned: Planned, machine: Configuration) -> Self {
        let (units, speeds, io) = hub.read(|now| (now.units.clone(), now.speeds, now.io.clone()));
        let motion = hub.read(|now| Motion { at: now.motion.at, ..Motion::default() });
        Self {
            hub,
            told: Instant::now(),
            motion,
            units,
            speeds,
            io,
            calls: None,
            watched: None,
            printed: Vec::new(),
            messages: Vec::new(),
            pause: None,
            sound: None,
            comment: None,
            run,
            planned,
            live_mm_s: ports::live_mm_s(&machine),
            machine,
            seen: None,
            heights: None,
            in_force: None,
            is_job: false,
            made: 0,
            feed: 1.0,
        }
    }

    /// Where the machine is at a moment, and what else can be seen of it.
    pub fn see(&mut self, doing: &Doing<'_>, t_s: f64) {
        self.look_at(doing.machine, t_s);
        self.pause.take_if(|pause| pause.until <= t_s);
        if let Some(going) = &doing.going {
            ports::moving(&mut self.io.ports, going.at(t_s).velocity, &self.machine);
        }
        let frame = doing.machine.frame();
        let (place, speed_mm_s, going) = match &doing.going {
            Some(going) => {
                let state = going.at(t_s);
                (state.position, speed(state.velocity), going.made())
            }
            None => (doing.machine.position(), 0.0, None),
        };
        let at = told::positions(frame, place);
        self.seen = Some(at);
        let cutting = going.is_some_and(|made| made.kind == MoveKind::Cut);
        let live = doing.going.is_none() || self.live_mm_s.is_some_and(|most| speed_mm_s <= most);
        let before = (self.motion.at, self.motion.speed_mm_s, self.motion.cutting);
        let (at, speed_mm_s, cutting) = if live { (at, speed_mm_s, cutting) } else { before };
        let line = going.map_or(self.motion.line, |made| made.at.line);
        let (progress, remaining) = self.progress();
        self.motion =
            Motion { at, speed_mm_s, t: t_s, cutting, line, made: self.made, progress, remaining };
    }

    /// The machine stands.
    pub fn stand(&mut self) {
        (self.motion.speed_mm_s, self.motion.cutting) = (0.0, false);
        self.motion.at = self.seen.unwrap_or(self.motion.at);
        ports::stand(&mut self.io.ports);
    }

    fn look_at(&mut self, machine: &Machine, t_s: f64) {
        let settings = machine.settings();
        let rpm = self.speeds.rpm;
        let speeds = Speeds { rpm, ..told::speeds(settings) };
        // A job counts in millimetres; people go on reading what they are used to.
        if !self.is_job {
            self.units = told::units(settings);
        }
        self.speeds = speeds;
        self.io = told::io(machine, t_s, &self.io);
    }

    /// An input reads something else. Nobody looks at a machine that stands and asks.
    pub fn reads(&mut self, number: u8, on: bool) {
        if let Some(lamp) = self.io.inputs.iter_mut().find(|lamp| lamp.number == number) {
            lamp.on = on;
        }
        ports::reads(&mut self.io.ports, number, on);
    }

    /// How far the job is and how long it takes from here, by its plan.
    fn progress(&self) -> (f64, f64) {
        let times = &self.planned.times;
        let total = times.last().copied().map_or(0.0, f64::from);
        if total <= 0.0 {
            return (0.0, 0.0);
        }
        let made = (self.made as usize).min(times.len());
        let done = made.checked_sub(1).map_or(0.0, |last| f64::from(times[last]));
        (done / total, (total - done) / self.feed.max(0.1))
    }

    /// A move was made.
    pub fn made(&mut self, made: &Made<'_>) {
        let step = made.span.made;
        let [x, y, _] = step.to.first3();
        self.made = self.planned.made(self.made, (step.at.line, [x, y]));
    }

    /// A job begins.
    pub const fn begins_job(&mut self) {
        self.is_job = true;
    }

    /// Other heights are in force.
    pub const fn heights(&mut self, heights: [f64; 3]) {
        self.heights = Some(heights);
    }

    /// A pause has changed what holds for the rest of the job.
    pub const fn in_force(&mut self, in_force: InForce) {
        self.in_force = Some(in_force);
    }

    /// A spindle got a speed.
    pub const fn spindle(&mut self, rpm: f64) {
        self.speeds.rpm = rpm;
    }

    /// A line of the print window.
    pub fn print(&mut self, line: &str) {
        self.printed.extend(line.split('\n').map(str::to_owned));
        let too_many = self.printed.len().saturating_sub(PRINTED);
        self.printed.drain(..too_many);
    }

    /// A line of the message area.
    pub fn say(&mut self, tone: Tone, text: impl Into<String>) {
        self.messages.push(Message { tone, text: text.into(), run: self.run });
    }

    /// A comment of the program: the text of a pause that comes next.
    pub fn comment(&mut self, text: &Arc<str>) {
        self.say(Tone::Program, &**text);
        self.comment = Some(text.clone());
    }

    /// A pause begins.
    pub fn pause(&mut self, from_s: f64, seconds: f64) {
        let text = self.comment.take().map(|text| text.to_string()).unwrap_or_default();
        self.pause = Some(Pause { text, until: from_s + seconds });
    }

    /// A sound begins.
    pub fn sound(&mut self, name: String) {
        self.sound = Some(name);
    }

    /// Something else goes on: no pause does.
    pub fn goes_on(&mut self) {
        (self.pause, self.comment) = (None, None);
    }

    /// The run is over.
    pub fn ends(&mut self) {
        self.goes_on();
        self.tell();
    }

    /// Where the run is in its files.
    pub fn stands(&mut self, calls: Vec<Call>) {
        self.calls = Some(calls);
    }

    /// What the variables are that somebody wants to see.
    pub fn watches(&mut self, watched: Vec<NamedValue>) {
        self.watched = Some(watched);
    }

    /// Tells, unless that was done a moment ago, or somebody else tells something just now: the machine waits for
    /// nobody.
    pub fn tell_sometimes(&mut self) {
        if self.told.elapsed() >= TELL {
            let hub = self.hub.clone();
            hub.changing_if_free(|now| self.differing(now));
        }
    }

    /// Tells what is there to tell.
    pub fn tell(&mut self) {
        let hub = self.hub.clone();
        hub.changing(|now| self.differing(now));
    }

    /// What of it differs from what pages know. It counts as told from now on.
    fn differing(&mut self, now: &Snapshot) -> Vec<Change> {
        self.told = Instant::now();
        let mut changes = Vec::new();
        let mut put = |differs: bool, change: Change| changes.extend(differs.then_some(change));
        put(now.units != self.units, Change::Units { units: self.units.clone() });
        put(now.speeds != self.speeds, Change::Speeds { speeds: self.speeds });
        put(now.io != self.io, Change::Io { io: self.io.clone() });
        put(now.motion != self.motion, Change::Motion { motion: self.motion });
        if let Some(job) = &now.job {
            let calls = self.calls.take().unwrap_or_else(|| job.calls.clone());
            let heights = self.heights.or(job.heights);
            let in_force = self.in_force.or(job.in_force);
            let job = Some(kerf_wire::Job { calls, heights, in_force, ..job.clone() });
            put(now.job != job, Change::Job { job });
        }
        let pause = self.pause.clone();
        put(now.pause != pause, Change::Pause { pause });
        if let Some(name) = self.sound.take() {
            let number = now.sound.as_ref().map_or(0, |sound| sound.number).wrapping_add(1);
            put(true, Change::Sound { sound: Some(Sound { number, name }) });
        }
        if let Some(watched) = self.watched.take() {
            put(now.watched != watched, Change::Watched { watched });
        }
        let (lines, messages) =
            (std::mem::take(&mut self.printed), std::mem::take(&mut self.messages));
        put(!lines.is_empty(), Change::Printed { lines });
        put(!messages.is_empty(), Change::Messages { messages });
        changes
    }
}

/// Speed of the tool in space, or of the rotary axes when only they move.
fn speed(velocity: Axes) -> f64 {
    let [x, y, z, a, b, c] = velocity.0;
    let linear = (x * x + y * y + z * z).sqrt();
    if linear > 0.0 { linear } else { (a * a + b * b + c * c).sqrt() }
}
