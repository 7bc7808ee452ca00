//! Commands to OpenSBP.
//!
//! The counterpart of the interpreter: arcs stay arcs (CG), dwells are PAUSE, outputs SO, and where a
//! program moves its zero, VA does. Places are working locations in the unit of the file. What
//! OpenSBP has no word for becomes a comment that says so and is told beside the text.
//!
//! Speeds are where the languages differ most. A feed counts along the path; OpenSBP gives XY and Z
//! a speed each (see `speeds`).

mod arcs;
mod moves;
mod places;
mod speeds;
mod switches;
#[cfg(test)]
mod tests;

use crate::syntax::table::settings_lines;
use kerf_program::settings::LinearUnit;
use kerf_program::{
    At, Axes, AxisSet, ChangeWords, Changing, Command, Frame, Hold, Lost, PathControl, Printer,
    Settings, Sourced, ToolPathStart, Written,
};
use places::Places;
use std::sync::Arc;

/// Unit and starting state with which OpenSBP is written.
#[derive(Clone, Debug, PartialEq)]
pub struct Printing {
    /// The unit of the file.
    pub unit: LinearUnit,
    /// The frames at the start.
    pub frame: Frame,
    /// Place of the machine at the start, machine frame.
    pub position: Axes,
    /// The settings at the start.
    pub settings: Arc<Settings>,
    /// The file has to say how many axes there are and what A and B are measured in: those of the
    /// settings.
    pub declare_axes: bool,
    /// The output of the mist coolant; 0 for none.
    pub mist_output: u8,
    /// The output of the flood coolant; 0 for none.
    pub flood_output: u8,
    /// Comments in the first lines.
    pub title: Option<String>,
}

impl Default for Printing {
    fn default() -> Self {
        Self {
            unit: LinearUnit::Inch,
            frame: Frame::default(),
            position: Axes::default(),
            settings: Arc::default(),
            declare_axes: false,
            mist_output: 0,
            flood_output: 0,
            title: None,
        }
    }
}

/// Writes a program.
pub fn print(commands: &[Sourced], printing: &Printing) -> Written {
    let mut printer = SbpPrinter::new(printing);
    for sourced in commands {
        printer.command(sourced);
    }
    Box::new(printer).finish()
}

/// A part file while it is written.
#[derive(Debug)]
pub struct SbpPrinter<'a> {
    printing: &'a Printing,
    text: String,
    lost: Vec<Lost>,
    /// The line of the source that is being written.
    at: At,
    /// Comments that stand behind the next line.
    beside: Option<String>,
    settings: Arc<Settings>,
    /// Settings that hold from here on and are not written yet.
    changed: Option<Arc<Settings>>,
    places: Places,
    speeds: speeds::Written,
    coolant: [bool; 2],
    changing: Changing,
    /// A comment that names a tool path was written for this line already.
    named: Option<At>,
    path_control_told: bool,
}

impl<'a> SbpPrinter<'a> {
    /// Begins a part file.
    pub fn new(printing: &'a Printing) -> Self {
        let mut printer = Self {
            printing,
            text: String::new(),
            lost: Vec::new(),
            at: At::default(),
            beside: None,
            settings: printing.settings.clone(),
            changed: None,
            places: Places::new(printing),
            speeds: speeds::Written::default(),
            coolant: [false; 2],
            changing: Changing::default(),
            named: None,
            path_control_told: false,
        };
        printer.begin();
        printer
    }

    fn begin(&mut self) {
        if let Some(title) = &self.printing.title {
            self.comment(title);
        }
        // A machine set to the other unit cuts nothing.
        let (name, wrong) = match self.printing.unit {
            LinearUnit::Inch => ("INCHES", 1),
            LinearUnit::Mm => ("MM", 0),
        };
        self.comment(&format!("UNITS: {name}"));
        self.line(&format!("IF %(25) = {wrong} THEN GOTO UNIT_ERROR"));
        if self.printing.declare_axes {
            let line = settings_lines(&self.settings).into_iter().find(|l| l.starts_with("VD"));
            let fields: Vec<_> = line.iter().flat_map(|l| l.split(',')).take(6).collect();
            if let [_, _, axes, _, a, b] = fields[..] {
                self.line(&format!("VD,,{axes},,{a},{b}"));
            }
        }
        self.line("SA");
    }

    /// Writes a line, and behind it the comment that waits for one.
    fn line(&mut self, text: &str) {
        self.text.push_str(text);
        if let Some(comment) = self.beside.take() {
            self.text.push_str(" '");
            self.text.push_str(&comment);
        }
        self.text.push('\n');
    }

    /// Writes a comment that waits for a line into one of its own.
    fn flush(&mut self) {
        if let Some(comment) = self.beside.take() {
            self.line(&format!("'{comment}"));
        }
    }

    fn unsaid(&mut self, what: impl Into<String>) {
        self.lose(Lost { at: self.at, what: what.into(), is_motion: false });
    }

    fn unsaid_motion(&mut self, what: impl Into<String>) {
        self.lose(Lost { at: self.at, what: what.into(), is_motion: true });
    }

    fn write(&mut self, command: &Command) {
        match command {
            Command::Line(line) => self.straight(line),
            Command::Arc(arc) => self.arc(arc),
            Command::Settings(_) => {}
            Command::Location { frame, working, base } => {
                let before = self.places.frame.base_zero;
                if base.iter().any(|a| frame.base_zero[a] != before[a]) {
                    self.unsaid("a change of the table base coordinates");
                }
                self.locate(*frame, *working);
            }
            Command::Wait { seconds } => self.wait(*seconds),
            Command::Output { number, on } => self.output(*number, *on),
            Command::Pwm { channel, .. } => self.unsaid(format!("the duty of channel {channel}")),
            Command::Spindle { number, rpm } => self.spindle(*number, *rpm),
            Command::SpindleTurn { turn, .. } => self.turn(*turn),
            Command::Coolant { mist, flood } => self.coolant([*mist, *flood]),
            Command::PathControl(path) => self.path_control(*path),
            Command::Overrides { feed, spindle } if !(*feed && *spindle) => {
                self.unsaid("that the operator's overrides do not hold");
            }
            Command::MotorsOff => self.line("MO"),
            Command::WarningOff => self.line("WARNING OFF"),
            Command::ClearPreview | Command::Heights(_) | Command::InForce(_) => {}
            Command::Independent { .. } => self.unsaid_motion("an axis that moves by itself"),
            Command::HeightControl(_) => self.unsaid_motion("height control"),
            Command::Beam(_) => self.unsaid("the intensity of a laser"),
            Command::LaserFrequency { .. } => self.unsaid("the pulse frequency of a laser"),
            Command::Print { text, newline } => self.print(text, *newline),
            Command::Message { text } if self.named == Some(self.at) => {
                let _ = text;
            }
            Command::Message { text } => self.comment(text),
            Command::ToolPath(start) => self.tool_path(start),
            Command::Sound { path } => self.unsaid(format!("the sound {path}")),
            Command::File { path, .. } => self.unsaid(format!("use of the file {path}")),
            Command::ToolChange { .. }
            | Command::Overrides { .. }
            | Command::EndStack
            | Command::Chorded(_)
            | Command::State { .. }
            | Command::Diagnostic(_) => {}
        }
    }

    /// Settings that changed, as the V commands that set them, as soon as something follows them.
    fn write_settings(&mut self) {
        let Some(settings) = self.changed.take() else { return };
        let before = std::mem::replace(&mut self.settings, settings.clone());
        let known = settings_lines(&before);
        for line in settings_lines(&settings) {
            let of_the_file = ["VD", "SA", "SR"].iter().any(|own| line.starts_with(own));
            if !of_the_file && !known.contains(&line) {
                self.line(&line);
            }
        }
        self.speeds = speeds::Written::of(&settings.speeds.cut);
    }

    fn path_control(&mut self, path: PathControl) {
        let usual = path == PathControl::Blend { tolerance_mm: None, merge_mm: None };
        if !usual && !std::mem::replace(&mut self.path_control_told, true) {
            self.unsaid("how closely the path is followed (G61, G64): the ramps of VR hold");
        }
    }

    fn print(&mut self, text: &str, newline: bool) {
        let quoted = text.replace('"', "'");
        // With a comma as first separator the commas of a text would part it.
        let mode = if text.contains(',') { ";" } else { "" };
        let end = if newline { "" } else { ";" };
        self.line(&format!("PRINT{mode} \"{quoted}\"{end}"));
    }

    /// The name of a tool path or a tool, as the previewer's comments have it.
    fn tool_path(&mut self, start: &ToolPathStart) {
        if self.named == Some(self.at) {
            return;
        }
        let name = start.name.as_ref().map(|name| format!("Toolpath Name = {name}"));
        let tool = start.tool.as_ref().map(|tool| format!("Tool Name = {tool}"));
        for text in [name, tool].into_iter().flatten() {
            self.comment(&text);
            self.named = Some(self.at);
        }
    }

    fn change(&mut self, words: ChangeWords) {
        match words {
            ChangeWords::PutIn(tool) => self.put_in(&tool),
            ChangeWords::Hold(text) => self.hold(&Hold { at: self.at, text, until: None }),
        }
    }

    /// The owner's own file changes the tool.
    fn put_in(&mut self, tool: &str) {
        let digits: String = tool.chars().filter(char::is_ascii_digit).collect();
        let name = if digits.is_empty() { format!("\"{tool}\"") } else { digits };
        self.line(&format!("&Tool = {name}"));
        self.line("C9");
        self.places.changed_tool();
        self.named = Some(self.at);
    }
}

impl Printer for SbpPrinter<'_> {
    fn command(&mut self, sourced: &Sourced) {
        self.at = sourced.at;
        if let Command::Settings(settings) = &sourced.command {
            self.changed = Some(settings.clone());
            return;
        }
        if let Some(words) = self.changing.follow(&sourced.command) {
            self.change(words);
        }
        if self.changing.is_under_way() {
            return self.places.follow(&sourced.command);
        }
        self.write_settings();
        self.write(&sourced.command);
        if !matches!(sourced.command, Command::ToolPath(_)) {
            self.named = None;
        }
    }

    fn zero_at(&mut self, at: At, frame: &Frame, axes: AxisSet) {
        self.at = at;
        self.write_settings();
        self.locate_in_machine(frame, axes);
    }

    fn comment(&mut self, text: &str) {
        self.flush();
        for line in text.lines() {
            self.line(&format!("'{}", line.trim()));
        }
    }

    fn comment_beside(&mut self, text: &str) {
        self.flush();
        self.beside = Some(text.split_whitespace().collect::<Vec<_>>().join(" "));
    }

    fn hold(&mut self, hold: &Hold) {
        self.at = hold.at;
        if self.changing.tell(&hold.text) {
            return;
        }
        if !hold.text.is_empty() {
            // PAUSE shows the comment above it.
            let text: Vec<_> = hold.text.split_whitespace().collect();
            self.comment(&text.join(" "));
        }
        match hold.until {
            Some((input, on)) => self.line(&format!("PAUSE UNTIL {input},{}", u8::from(on))),
            None => self.line("PAUSE"),
        }
    }

    fn next_tool(&mut self, name: &str) {
        self.changing.expect(name);
    }

    fn lose(&mut self, lost: Lost) {
        self.comment(&format!("not in OpenSBP: {}", lost.what));
        self.lost.push(lost);
    }

    fn finish(mut self: Box<Self>) -> Written {
        if let Some(words) = self.changing.end() {
            self.change(words);
        }
        self.flush();
        for line in ["END", "UNIT_ERROR:", "C#,91", "END"] {
            self.line(line);
        }
        Written { text: self.text, lost: self.lost }
    }
}
