//! Gathers what a run has to tell the pages, so that they are told some thirty times a second and
//! not a thousand.

use super::planned::{Course, Planned};
use super::ports;
use super::typing::Typing;
use crate::files::PartFolder;
use crate::hub::Hub;
use crate::to_wire;
use kerf_diag::{Diagnostic, SourcePlace};
use kerf_machine::{Configuration, Going};
use kerf_model::Model;
use kerf_program::{At, Axes, MoveKind};
use kerf_trace::{Doing, ExecutedMove, OpenFile};
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
    /// The program's last comment, while nothing came behind it.
    comment: Option<Arc<str>>,
    /// Number of the run.
    run: u32,
    course: Course,
    machine: Configuration,
    parts: PartFolder,
    /// The file that the tool's line is in, and as pages know it.
    tool_file: (Arc<str>, String),
    /// Positions are told up to this speed, mm/s; nothing for never in motion.
    live_mm_s: Option<f64>,
    /// A job runs, no part program.
    is_job: bool,
    /// Place where the machine was seen last, told or not.
    seen: Option<Positions>,
    /// Heights in force in a job.
    heights: Option<[f64; 3]>,
    /// Other settings of the job that a pause has changed.
    in_force: Option<InForce>,
    /// VD has closed the message screen.
    silent: bool,
    /// The typed line that runs, where one does.
    typing: Option<Typing>,
    /// Share of the speed asked for.
    pub feed: f64,
    /// Share of rapid moves, where the machine overrides them by itself.
    pub rapid: f64,
    /// Seconds of machine time in a second of whoever waits.
    rate: f64,
    /// Planned time of what was made before the run was taken up, seconds.
    before_s: f64,
}

impl Board {
    /// For a run with this plan.
    pub fn new(
        hub: Arc<Hub>,
        run: u32,
        planned: Planned,
        machine: Configuration,
        parts: PartFolder,
        rate: f64,
    ) -> Self {
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
            course: Course::new(planned),
            parts,
            tool_file: Default::default(),
            live_mm_s: ports::live_mm_s(&machine),
            machine,
            seen: None,
            heights: None,
            in_force: None,
            is_job: false,
            silent: false,
            typing: None,
            feed: 1.0,
            rapid: 1.0,
            rate,
            before_s: 0.0,
        }
    }

    /// Number of the run.
    pub const fn run(&self) -> u32 {
        self.run
    }

    /// Takes the typed line that runs, where one does.
    pub fn typed(&mut self, typing: Option<Typing>) {
        self.typing = typing;
    }

    /// The plan of what runs is known by now.
    pub fn plans(&mut self, planned: Planned) {
        self.course.plan(planned);
    }

    /// Looks where the machine is at a moment, and what else can be seen of it.
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
                let share = self.share_of_plan(going, f64::from(doing.feed));
                (state.position, share * speed(state.velocity), going.made())
            }
            None => (doing.machine.position(), 0.0, None),
        };
        let at = to_wire::positions(frame, place);
        self.seen = Some(at);
        let cutting = going.is_some_and(|made| made.kind == MoveKind::Cut);
        let live = doing.going.is_none() || self.live_mm_s.is_some_and(|most| speed_mm_s <= most);
        let before = (self.motion.at, self.motion.speed_mm_s, self.motion.cutting);
        let (at, speed_mm_s, cutting) = if live { (at, speed_mm_s, cutting) } else { before };
        if let Some(going) = &doing.going {
            self.course.goes(going, t_s, f64::from(doing.feed));
        }
        if let Some(made) = going {
            self.stands_in(made.at.line);
            self.tool_is_in(doing, made.at);
        }
        let progress = self.course.progress();
        let remaining = self.course.remaining_s(self.feed) / self.rate;
        let elapsed = (self.before_s + t_s) / self.rate;
        let motion = Motion { at, speed_mm_s, t: t_s, cutting, progress, remaining, ..self.motion };
        self.motion = Motion { elapsed, ..motion };
    }

    /// Returns the share of the speed of its plan at which a move is made: another than 1 where the machine overrides
    /// by itself, and its plan stays that of another feed.
    fn share_of_plan(&self, going: &Going<'_>, planned: f64) -> f64 {
        match going.made().map(|made| made.kind) {
            Some(MoveKind::Cut) => self.feed / planned,
            Some(MoveKind::Jog) => self.rapid,
            _ => 1.0,
        }
    }

    /// The move that is made is one of this file.
    fn tool_is_in(&mut self, doing: &Doing<'_>, at: At) {
        if let Some(file) = doing.file(at)
            && self.tool_file.0 != *file
        {
            self.tool_file = (file.clone(), self.parts.name_of(file));
        }
    }

    /// The machine stands.
    pub fn stand(&mut self) {
        (self.motion.speed_mm_s, self.motion.cutting) = (0.0, false);
        self.motion.at = self.seen.unwrap_or(self.motion.at);
        ports::stand(&mut self.io.ports);
    }

    fn look_at(&mut self, machine: &Model, t_s: f64) {
        let settings = machine.settings();
        let rpm = self.speeds.rpm;
        let speeds = Speeds { rpm, ..to_wire::speeds(settings) };
        // A job counts in millimetres; people go on reading what they are used to.
        if !self.is_job {
            self.units = to_wire::units(settings);
        }
        self.speeds = speeds;
        self.io = to_wire::io(machine, t_s, &self.machine, &self.io);
    }

    /// An input reads something else. Nobody looks at a machine that stands and asks.
    pub fn reads(&mut self, number: u8, on: bool) {
        if let Some(lamp) = self.io.inputs.iter_mut().find(|lamp| lamp.number == number) {
            lamp.on = on;
        }
        ports::reads(&mut self.io.ports, number, on);
        let reads = |number| ports::input_state(&self.io, number).unwrap_or_default();
        self.io.forbidden = to_wire::forbidden(reads, &self.machine.program.io, &self.machine);
    }

    /// A move was made.
    pub fn made(&mut self, made: &ExecutedMove<'_>) {
        self.course.made(made);
        self.motion.made = self.course.moves();
        if self.typing.as_ref().is_some_and(|typing| typing.draws(made)) {
            self.hub.typed().follow(made);
        }
    }

    /// A move was made before the run was cut short that is taken up.
    pub fn made_before(&mut self, made: &ExecutedMove<'_>) {
        self.made(made);
        self.before_s = self.course.made_s();
        self.stands_in(made.span.made.at.line);
    }

    /// The line of the tool: where no line stands for a move, it is that of the one before.
    const fn stands_in(&mut self, line: u32) {
        if line > 0 {
            self.motion.line = line;
        }
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
        self.silent = false;
        self.printed.extend(line.split('\n').map(str::to_owned));
        let too_many = self.printed.len().saturating_sub(PRINTED);
        self.printed.drain(..too_many);
    }

    /// VD was carried out.
    pub const fn displays(&mut self, comments: bool) {
        self.silent = !comments;
    }

    /// A line of the message area.
    pub fn say(&mut self, tone: Tone, text: impl Into<String>) {
        // Pages know files by their names below the part folder.
        let text = self.parts.named_in(&text.into());
        self.messages.push(Message { tone, text, run: self.run, ..Message::default() });
    }

    /// A finding of the run, with its place for whoever goes to see it.
    pub fn finds(&mut self, found: &Diagnostic) {
        let SourcePlace { file, line, .. } = &found.place;
        let place = (*line > 0).then(|| Call { file: self.parts.name_of(file), line: *line });
        let told = to_wire::message(found);
        let (text, hint) = (self.parts.named_in(&told.text), self.parts.named_in(&told.hint));
        self.messages.push(Message { text, hint, place, run: self.run, ..told });
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
        self.motion.progress = self.course.progress();
        self.motion.remaining = self.course.remaining_s(self.feed) / self.rate;
        self.tell();
    }

    /// Notes where the run is in its files.
    pub fn stands(&mut self, files: &[OpenFile]) {
        let call = |open: &OpenFile| Call { file: self.parts.name_of(&open.file), line: open.line };
        self.calls = Some(files.iter().map(call).collect());
        if let Some(typing) = &mut self.typing {
            typing.stands(files, &self.parts);
        }
    }

    /// Notes the values of the variables that somebody wants to see.
    pub fn watches(&mut self, watched: Vec<NamedValue>) {
        self.watched = Some(watched);
    }

    /// The machine is held: it stands where it was seen last.
    pub fn stands_still(&mut self) {
        self.motion.speed_mm_s = 0.0;
        self.motion.at = self.seen.unwrap_or(self.motion.at);
        self.tell();
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

    /// Returns what of it differs from what pages know. It counts as told from now on.
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
            let tool_file = self.tool_file.1.clone();
            let silent = self.silent;
            let job = kerf_wire::CurrentRun {
                calls,
                tool_file,
                heights,
                in_force,
                silent,
                ..job.clone()
            };
            let job = Some(job);
            put(now.job != job, Change::Job { job });
        }
        let typed = self.hub.typed().summary();
        put(now.typed != typed, Change::Typed { typed });
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_speed_is_that_in_space_or_else_that_of_the_rotary_axes() {
        assert_eq!(speed(Axes([2.0, 3.0, 6.0, 50.0, 0.0, 0.0])), 7.0);
        assert_eq!(speed(Axes([0.0, 0.0, 0.0, 3.0, 4.0, 12.0])), 13.0);
    }
}
