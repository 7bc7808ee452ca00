//! Commands to G-code.
//!
//! Arcs stay arcs, comments stay comments. Places are written in working coordinates; where a program
//! moves its zero, G92 does. What G-code, or the controller it is written for, has no word for becomes
//! a comment that says so and is told beside the text.
//!
//! The dialects: `linuxcnc` uses everything LinuxCNC has; `grbl` what grbl 1.1 reads; `generic` only
//! the words that routers agree on.

mod comments;
mod motion;
mod switches;
#[cfg(test)]
mod tests;

use crate::syntax::dialect::Dialect;
use comments::{comment, comments};
use kerf_program::settings::LinearUnit;
use kerf_program::{
    At, Axes, AxisSet, ChangeWords, Changing, Command, Frame, Hold, Lost, PathControl, Printer,
    Settings, Sourced, SpindleTurn, Written, decimal,
};
use std::fmt::Write as _;
use std::sync::Arc;
use switches::Switches;

/// Time that M66 waits for an input, seconds: it needs a bound.
const WAIT_S: u32 = 86_400;

/// Dialect, unit and starting state with which G-code is written.
#[derive(Clone, Debug, PartialEq)]
pub struct Writing {
    /// For which controller.
    pub dialect: Dialect,
    /// The unit of the file.
    pub unit: LinearUnit,
    /// The frames at the start.
    pub frame: Frame,
    /// Place of the machine at the start, machine frame.
    pub position: Axes,
    /// The settings at the start: moves without a feed of their own take their speeds.
    pub settings: Arc<Settings>,
    /// The output that the spindle follows, which is written as M3 and M5; 0 for none.
    pub spindle_output: u8,
    /// The output of the mist coolant, which is written as M7; 0 for none.
    pub mist_output: u8,
    /// The output of the flood coolant, which is written as M8; 0 for none.
    pub flood_output: u8,
    /// Comments in the first lines.
    pub title: Option<String>,
}

impl Default for Writing {
    fn default() -> Self {
        Self {
            dialect: Dialect::LinuxCnc,
            unit: LinearUnit::Mm,
            frame: Frame::default(),
            position: Axes::default(),
            settings: Arc::default(),
            spindle_output: 1,
            mist_output: 0,
            flood_output: 0,
            title: None,
        }
    }
}

/// Writes a program.
pub fn write(commands: &[Sourced], writing: &Writing) -> Written {
    let mut writer = Writer::new(writing);
    for sourced in commands {
        writer.command(sourced);
    }
    Box::new(writer).finish()
}

/// The ramps of the linear axes; those of the others change with their units.
fn ramps(settings: &Settings) -> [f64; 8] {
    let ramps = &settings.ramps;
    let [cut, jog] = [&ramps.cut, &ramps.jog];
    let rates = [ramps.cut_rate_mm, ramps.jog_rate_mm];
    let corners = [ramps.min_distance_mm, ramps.slow_corner_percent];
    [cut.xy, cut.z, jog.xy, jog.z, rates[0], rates[1], corners[0], corners[1]]
}

/// A program while it is written.
#[derive(Debug)]
pub struct Writer<'a> {
    writing: &'a Writing,
    text: String,
    lost: Vec<Lost>,
    /// The line of the source that is being written.
    at: At,
    /// Comments that stand behind the next block.
    beside: Vec<String>,
    settings: Arc<Settings>,
    frame: Frame,
    position: Axes,
    /// The zero of G54, machine frame; what the working zero is off it is the shift of G92.
    system: Axes,
    /// The place as it was last written, so that no word is repeated.
    written: [Option<String>; kerf_program::AXES],
    /// The motion word in force.
    motion: &'static str,
    /// The plane of arcs in force.
    plane: &'static str,
    /// The feed in force.
    feed: Option<String>,
    inverse: bool,
    switches: Switches,
    changing: Changing,
    overrides: [bool; 2],
    /// It was told that an axis is linear.
    linear_told: bool,
    /// Lines to come that an arc was written for.
    chords_left: u32,
}

impl<'a> Writer<'a> {
    /// Begins a program.
    pub fn new(writing: &'a Writing) -> Self {
        let mut writer = Self {
            writing,
            text: String::new(),
            lost: Vec::new(),
            at: At::default(),
            beside: Vec::new(),
            settings: writing.settings.clone(),
            frame: writing.frame,
            position: writing.position,
            system: writing.frame.working_zero,
            written: Default::default(),
            motion: "",
            plane: "G17",
            feed: None,
            inverse: false,
            switches: Switches::default(),
            changing: Changing::default(),
            overrides: [true; 2],
            linear_told: false,
            chords_left: 0,
        };
        writer.begin();
        writer
    }

    fn is_grbl(&self) -> bool {
        self.writing.dialect == Dialect::Grbl
    }

    fn is_linuxcnc(&self) -> bool {
        self.writing.dialect == Dialect::LinuxCnc
    }

    /// Writes a block, and behind it the comments that wait for one.
    fn line(&mut self, text: &str) {
        self.text.push_str(text);
        for comment in std::mem::take(&mut self.beside) {
            self.text.push(' ');
            self.text.push_str(&comment);
        }
        self.text.push('\n');
    }

    /// Writes comments that wait for a block into lines of their own.
    fn flush(&mut self) {
        for comment in std::mem::take(&mut self.beside) {
            self.text.push_str(&comment);
            self.text.push('\n');
        }
    }

    fn begin(&mut self) {
        if let Some(title) = &self.writing.title {
            self.comment(title);
        }
        let unit = match self.writing.unit {
            LinearUnit::Inch => "G20",
            LinearUnit::Mm => "G21",
        };
        let rest = if self.is_grbl() { "G17 G90 G94" } else { "G17 G40 G49 G80 G90 G94" };
        self.line(&format!("{unit} {rest}"));
    }

    /// Notes something that cannot be said, and is no motion.
    fn unsaid(&mut self, what: impl Into<String>) {
        self.lose(Lost { at: self.at, what: what.into(), is_motion: false });
    }

    /// Motion that cannot be said.
    fn unsaid_motion(&mut self, what: impl Into<String>) {
        self.lose(Lost { at: self.at, what: what.into(), is_motion: true });
    }

    fn write(&mut self, command: &Command) {
        match command {
            Command::Line(_) if self.chords_left > 0 => self.chords_left -= 1,
            Command::Line(line) => self.straight(line),
            Command::Arc(arc) => self.arc(arc),
            Command::Chorded(arc) => self.arc_in_plane(arc),
            Command::Settings(settings) => self.use_settings(settings),
            Command::Location { frame, working, base } => {
                if base.iter().any(|a| frame.base_zero[a] != self.frame.base_zero[a]) {
                    self.unsaid("a change of the table base coordinates");
                }
                self.locate(*frame, *working);
            }
            Command::Wait { seconds } => self.wait(*seconds),
            Command::Output { number, on } => self.output(*number, *on),
            Command::Pwm { channel, percent } => self.pwm(*channel, *percent),
            Command::Spindle { rpm, .. } => self.line(&format!("S{}", decimal(*rpm, 3))),
            Command::SpindleTurn { turn, .. } => self.turn(*turn),
            Command::Coolant { mist, flood } => self.coolant([*mist, *flood]),
            Command::PathControl(path) => self.path_control(*path),
            Command::Overrides { feed, spindle } => self.overrides([*feed, *spindle]),
            Command::Print { text, .. } if self.is_linuxcnc() => {
                self.line(&comment(&format!("PRINT,{text}")));
            }
            Command::Print { text, .. } | Command::Message { text } => self.comment(text),
            Command::MotorsOff => self.unsaid("motors off"),
            Command::Independent { .. } => self.unsaid_motion("an axis that moves by itself"),
            Command::HeightControl(_) => self.unsaid_motion("height control"),
            Command::Beam(_) => self.unsaid("the intensity of a laser"),
            Command::LaserFrequency { .. } => self.unsaid("the pulse frequency of a laser"),
            Command::Sound { path } => self.unsaid(format!("the sound {path}")),
            Command::File { path, .. } => self.unsaid(format!("use of the file {path}")),
            Command::EndStack
            | Command::State { .. }
            | Command::Heights(_)
            | Command::InForce(_)
            | Command::ToolPath(_)
            | Command::ToolChange { .. }
            | Command::WarningOff
            | Command::Diagnostic(_)
            | Command::ClearPreview => {}
        }
    }

    /// Speeds are taken into the feed; of the rest, what moves or switches something is told.
    fn use_settings(&mut self, settings: &Arc<Settings>) {
        let before = std::mem::replace(&mut self.settings, settings.clone());
        if ramps(settings) != ramps(&before) {
            self.unsaid("ramps (VR): the controller's own hold");
        }
        if settings.cutter.trigger.active && settings.cutter.trigger != before.cutter.trigger {
            self.unsaid("an output that follows the height of an axis (VC)");
        }
        if settings.io.output4 != before.io.output4 {
            self.unsaid("output 4 following the motion (SO,4)");
        }
        if settings.torch_on() && !before.torch_on() {
            self.unsaid_motion("torch height control (VH)");
        }
    }

    fn locate(&mut self, frame: Frame, working: AxisSet) {
        let before = std::mem::replace(&mut self.frame, frame);
        let moved: Vec<_> =
            working.iter().filter(|a| frame.working_zero[*a] != before.working_zero[*a]).collect();
        if moved.is_empty() {
            return;
        }
        let place = self.words_of(self.position);
        let mut text = String::from("G92");
        for axis in moved {
            if self.lacks(axis.index()) {
                continue;
            }
            let word = &place[axis.index()];
            let _ = write!(text, " {}{word}", axis.letter());
            self.written[axis.index()] = Some(word.clone());
        }
        if text != "G92" {
            self.line(&text);
        }
    }

    /// G10 L2: the system's zero, so that the shift of G92 above it stays.
    fn locate_in_machine(&mut self, frame: &Frame, axes: AxisSet) {
        let mut text = String::from("G10 L2 P1");
        for axis in axes.iter() {
            if self.lacks(axis.index()) {
                continue;
            }
            let moved = frame.working_zero[axis] - self.frame.working_zero[axis];
            self.system[axis] += moved;
            self.frame.working_zero[axis] = frame.working_zero[axis];
            let word = self.value(axis.index(), self.system[axis]);
            let _ = write!(text, " {}{word}", axis.letter());
            self.written[axis.index()] = None;
        }
        if text != "G10 L2 P1" {
            self.line(&text);
        }
    }

    fn path_control(&mut self, path: PathControl) {
        let unit = self.writing.unit.mm();
        let word = |letter: char, mm: Option<f64>| {
            mm.map_or(String::new(), |v| format!(" {letter}{}", decimal(v / unit, 6)))
        };
        match path {
            PathControl::ExactPath => self.line("G61"),
            PathControl::ExactStop if self.is_linuxcnc() => self.line("G61.1"),
            PathControl::Blend { tolerance_mm, merge_mm } if self.is_linuxcnc() => {
                let merge = merge_mm.filter(|_| tolerance_mm.is_some());
                let text = format!("G64{}{}", word('P', tolerance_mm), word('Q', merge));
                self.line(&text);
            }
            PathControl::Blend { .. } if !self.writing.dialect.is_of_grbl() => self.line("G64"),
            PathControl::Blend { tolerance_mm: None, .. } => {}
            PathControl::ExactStop | PathControl::Blend { .. } => {
                self.unsaid("how closely the path is followed");
            }
        }
    }

    fn overrides(&mut self, wanted: [bool; 2]) {
        let before = std::mem::replace(&mut self.overrides, wanted);
        match wanted {
            _ if wanted == before => {}
            _ if !self.is_linuxcnc() => self.unsaid("whether the operator's overrides hold"),
            [true, true] => self.line("M48"),
            [false, false] => self.line("M49"),
            [feed, spindle] => {
                self.line(&format!("M50 P{}", u8::from(feed)));
                self.line(&format!("M51 P{}", u8::from(spindle)));
            }
        }
    }

    fn change(&mut self, words: ChangeWords) {
        match words {
            ChangeWords::PutIn(tool) => self.put_in(&tool),
            ChangeWords::Hold(text) => self.hold(&Hold { at: self.at, text, until: None }),
        }
    }

    fn put_in(&mut self, tool: &str) {
        self.switches.turn = SpindleTurn::Off;
        let digits: String = tool.chars().filter(char::is_ascii_digit).collect();
        if digits.is_empty() || self.is_grbl() {
            self.comment(&format!("tool {tool}"));
            self.line("M0");
        } else {
            self.line(&format!("T{digits} M6"));
        }
    }
}

impl Printer for Writer<'_> {
    fn command(&mut self, sourced: &Sourced) {
        self.at = sourced.at;
        if let Some(words) = self.changing.follow(&sourced.command) {
            self.change(words);
        }
        self.write(&sourced.command);
    }

    fn zero_at(&mut self, at: At, frame: &Frame, axes: AxisSet) {
        self.at = at;
        self.locate_in_machine(frame, axes);
    }

    fn comment(&mut self, text: &str) {
        self.flush();
        for comment in comments(text) {
            self.line(&comment);
        }
    }

    fn comment_beside(&mut self, text: &str) {
        self.flush();
        self.beside = comments(text);
    }

    fn hold(&mut self, hold: &Hold) {
        self.at = hold.at;
        if self.changing.tell(&hold.text) {
            return;
        }
        if !hold.text.is_empty() {
            self.flush();
            for text in hold.text.lines().filter(|l| !l.trim().is_empty()) {
                let text = if self.is_grbl() { text.into() } else { format!("MSG,{text}") };
                self.line(&comment(&text));
            }
        }
        match hold.until {
            Some((input, on)) if self.is_linuxcnc() => {
                let (input, mode) = (input.saturating_sub(1), if on { 3 } else { 4 });
                self.line(&format!("M66 P{input} L{mode} Q{WAIT_S}"));
            }
            Some((input, _)) => {
                self.unsaid(format!("waiting for input {input}: the operator goes on"));
                self.line("M0");
            }
            None => self.line("M0"),
        }
    }

    fn next_tool(&mut self, name: &str) {
        self.changing.expect(name);
    }

    fn lose(&mut self, lost: Lost) {
        self.comment(&format!("not in G-code: {}", lost.what));
        self.lost.push(lost);
    }

    fn finish(mut self: Box<Self>) -> Written {
        if let Some(words) = self.changing.end() {
            self.change(words);
        }
        self.flush();
        self.all_off();
        self.line("M2");
        Written { text: self.text, lost: self.lost }
    }
}
