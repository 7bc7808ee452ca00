//! Commands to G-code.
//!
//! Arcs stay arcs, comments stay comments. Places are written in working coordinates; where a program
//! moves its zero, G92 does. What G-code has no word for becomes a comment that says so.

mod motion;
#[cfg(test)]
mod tests;
mod words;

use crate::Dialect;
use kerf_program::settings::LinearUnit;
use kerf_program::{
    Axes, AxisSet, Command, Frame, PathControl, Settings, Sourced, ToolPathStart, Turn,
};
use std::fmt::Write as _;
use std::sync::Arc;
use words::{comment, number};

/// How G-code is written.
#[derive(Clone, Debug, PartialEq)]
pub struct Writing {
    /// For which controller.
    pub dialect: Dialect,
    /// The unit of the file.
    pub unit: LinearUnit,
    /// The frames at the start.
    pub frame: Frame,
    /// Where the machine is at the start, machine frame.
    pub position: Axes,
    /// The settings at the start: moves without a feed of their own take their speeds.
    pub settings: Arc<Settings>,
    /// The output that the spindle follows, which is written as M3 and M5; 0 for none.
    pub spindle_output: u8,
    /// A comment in the first line.
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
            title: None,
        }
    }
}

/// Writes a program.
pub fn write(commands: &[Sourced], writing: &Writing) -> String {
    let mut writer = Writer::new(writing);
    writer.begin();
    for sourced in commands {
        writer.command(&sourced.command);
    }
    writer.end();
    writer.text
}

/// A program while it is written.
struct Writer<'a> {
    writing: &'a Writing,
    text: String,
    settings: Arc<Settings>,
    frame: Frame,
    position: Axes,
    /// The place as it was last written, so that no word is repeated.
    written: [Option<String>; kerf_program::AXES],
    /// The motion word in force.
    motion: &'static str,
    /// The feed in force.
    feed: Option<String>,
    inverse: bool,
    turn: Turn,
    changing: bool,
    overrides: [bool; 2],
}

impl<'a> Writer<'a> {
    fn new(writing: &'a Writing) -> Self {
        Self {
            writing,
            text: String::new(),
            settings: writing.settings.clone(),
            frame: writing.frame,
            position: writing.position,
            written: Default::default(),
            motion: "",
            feed: None,
            inverse: false,
            turn: Turn::Off,
            changing: false,
            overrides: [true; 2],
        }
    }

    fn is_grbl(&self) -> bool {
        self.writing.dialect == Dialect::Grbl
    }

    fn line(&mut self, text: &str) {
        self.text.push_str(text);
        self.text.push('\n');
    }

    fn comment(&mut self, text: &str) {
        for line in text.lines() {
            let line = comment(line);
            self.line(&line);
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

    fn end(&mut self) {
        if self.turn != Turn::Off {
            self.line("M5");
        }
        self.line("M2");
    }

    fn command(&mut self, command: &Command) {
        match command {
            Command::Line(line) => self.straight(line),
            Command::Arc(arc) => self.arc(arc),
            Command::Settings(settings) => self.settings = settings.clone(),
            Command::Location { frame, working, .. } => self.locate(*frame, *working),
            Command::Wait { seconds } => self.line(&format!("G4 P{}", number(*seconds, 3))),
            Command::Output { number, on } => self.output(*number, *on),
            Command::Pwm { channel, percent } => self.pwm(*channel, *percent),
            Command::Spindle { rpm, .. } => self.line(&format!("S{}", number(*rpm, 3))),
            Command::SpindleTurn { turn, .. } => self.turn(*turn),
            Command::Coolant { mist, flood } => self.coolant(*mist, *flood),
            Command::PathControl(path) => self.path_control(*path),
            Command::Overrides { feed, spindle } => self.overrides([*feed, *spindle]),
            Command::Print { text, .. } if !self.is_grbl() => {
                self.line(&comment(&format!("PRINT,{text}")));
            }
            Command::Print { text, .. } | Command::Message { text } => self.comment(text),
            Command::ToolPath(start) => self.tool(start),
            Command::ToolChange { begin } => self.changing |= *begin,
            Command::MotorsOff => self.unsaid("motors off"),
            Command::Independent { .. } => self.unsaid("an axis that moves by itself"),
            Command::Sound { path } => self.unsaid(&format!("the sound {path}")),
            Command::EndStack
            | Command::WarningOff
            | Command::Diagnostic(_)
            | Command::File { .. }
            | Command::ClearPreview => {}
        }
    }

    /// What G-code has no word for.
    fn unsaid(&mut self, what: &str) {
        self.comment(&format!("not in G-code: {what}"));
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
            let word = &place[axis.index()];
            let _ = write!(text, " {}{word}", axis.letter());
            self.written[axis.index()] = Some(word.clone());
        }
        self.line(&text);
    }

    fn output(&mut self, number: u8, on: bool) {
        if number == self.writing.spindle_output {
            // A program that told the direction has switched the output with it.
            match (on, self.turn) {
                (true, Turn::Off) => self.turn(Turn::Clockwise),
                (false, turn) if turn != Turn::Off => self.turn(Turn::Off),
                _ => {}
            }
        } else if self.is_grbl() {
            self.unsaid(&format!("output {number} {}", if on { "on" } else { "off" }));
        } else {
            self.line(&format!("M6{} P{}", if on { 4 } else { 5 }, number.saturating_sub(1)));
        }
    }

    fn pwm(&mut self, channel: u8, percent: f64) {
        if self.is_grbl() {
            self.unsaid(&format!("channel {channel} at {percent} %"));
        } else {
            let (channel, percent) = (channel.saturating_sub(1), number(percent, 3));
            self.line(&format!("M68 E{channel} Q{percent}"));
        }
    }

    fn turn(&mut self, turn: Turn) {
        self.turn = turn;
        self.line(match turn {
            Turn::Off => "M5",
            Turn::Clockwise => "M3",
            Turn::Counterclockwise | Turn::Dynamic => "M4",
        });
    }

    fn coolant(&mut self, mist: bool, flood: bool) {
        if !(mist && flood) {
            self.line("M9");
        }
        if mist {
            self.line("M7");
        }
        if flood {
            self.line("M8");
        }
    }

    fn path_control(&mut self, path: PathControl) {
        let unit = self.writing.unit.mm();
        let word = |letter: char, mm: Option<f64>| {
            mm.map_or(String::new(), |v| format!(" {letter}{}", number(v / unit, 6)))
        };
        match path {
            PathControl::ExactPath => self.line("G61"),
            _ if self.is_grbl() => {}
            PathControl::ExactStop => self.line("G61.1"),
            PathControl::Blend { tolerance_mm, merge_mm } => {
                let merge = merge_mm.filter(|_| tolerance_mm.is_some());
                let text = format!("G64{}{}", word('P', tolerance_mm), word('Q', merge));
                self.line(&text);
            }
        }
    }

    fn overrides(&mut self, wanted: [bool; 2]) {
        let before = std::mem::replace(&mut self.overrides, wanted);
        match wanted {
            _ if self.is_grbl() || wanted == before => {}
            [true, true] => self.line("M48"),
            [false, false] => self.line("M49"),
            [feed, spindle] => {
                self.line(&format!("M50 P{}", u8::from(feed)));
                self.line(&format!("M51 P{}", u8::from(spindle)));
            }
        }
    }

    /// A tool change is written when the tool is known.
    fn tool(&mut self, start: &ToolPathStart) {
        let Some(tool) = start.tool.as_ref().filter(|_| std::mem::take(&mut self.changing)) else {
            return;
        };
        self.turn = Turn::Off;
        let digits: String = tool.chars().filter(char::is_ascii_digit).collect();
        if digits.is_empty() || self.is_grbl() {
            self.comment(&format!("tool {tool}"));
            self.line("M0");
        } else {
            self.line(&format!("T{digits} M6"));
        }
    }
}
