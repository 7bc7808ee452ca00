//! Each command as lines.

use super::file::SbpPrinter;
use super::{arcs, moves, switches};
use crate::syntax::table::settings_lines;
use kerf_program::{
    At, AxisSet, ChangeWords, Command, Frame, Hold, Lost, PathControl, Printer, Sourced,
    ToolPathStart, Written,
};

impl Printer for SbpPrinter<'_> {
    fn command(&mut self, sourced: &Sourced) {
        self.at = sourced.at;
        if let Command::Settings(settings) = &sourced.command {
            self.changed = Some(settings.clone());
            return;
        }
        if let Some(words) = self.changing.follow(&sourced.command) {
            change(self, words);
        }
        if self.changing.is_under_way() {
            return self.places.follow(&sourced.command);
        }
        write_settings(self);
        write(self, &sourced.command);
        if !matches!(sourced.command, Command::ToolPath(_)) {
            self.named = None;
        }
    }

    fn zero_at(&mut self, at: At, frame: &Frame, axes: AxisSet) {
        self.at = at;
        write_settings(self);
        moves::locate_in_machine(self, frame, axes);
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
            change(&mut self, words);
        }
        self.flush();
        for line in ["END", "UNIT_ERROR:", "C#,91", "END"] {
            self.line(line);
        }
        Written { text: self.text, lost: self.lost }
    }
}

fn write(p: &mut SbpPrinter<'_>, command: &Command) {
    match command {
        Command::Line(line) => moves::straight(p, line),
        Command::Arc(arc) => arcs::arc(p, arc),
        Command::Settings(_) => {}
        Command::Location { frame, working, base } => {
            let before = p.places.frame.base_zero;
            if base.iter().any(|a| frame.base_zero[a] != before[a]) {
                p.unsaid("a change of the table base coordinates");
            }
            moves::locate(p, *frame, *working);
        }
        Command::Wait { seconds } => switches::wait(p, *seconds),
        Command::Output { number, on } => switches::output(p, *number, *on),
        Command::Pwm { channel, .. } => p.unsaid(format!("the duty of channel {channel}")),
        Command::Spindle { number, rpm } => switches::spindle(p, *number, *rpm),
        Command::SpindleTurn { turn, .. } => switches::turn(p, *turn),
        Command::Coolant { mist, flood } => switches::coolant(p, [*mist, *flood]),
        Command::PathControl(path) => path_control(p, *path),
        Command::Overrides { feed, spindle } if !(*feed && *spindle) => {
            p.unsaid("that the operator's overrides do not hold");
        }
        Command::MotorsOff => p.line("MO"),
        Command::WarningOff => p.line("WARNING OFF"),
        Command::ClearPreview | Command::Heights(_) | Command::InForce(_) => {}
        Command::Independent { .. } => p.unsaid_motion("an axis that moves by itself"),
        Command::HeightControl(_) => p.unsaid_motion("height control"),
        Command::Beam(_) => p.unsaid("the intensity of a laser"),
        Command::LaserFrequency { .. } => p.unsaid("the pulse frequency of a laser"),
        Command::Print { text, newline } => print(p, text, *newline),
        Command::Message { text } if p.named == Some(p.at) => {
            let _ = text;
        }
        Command::Message { text } => p.comment(text),
        Command::ToolPath(start) => tool_path(p, start),
        Command::Sound { path } => p.unsaid(format!("the sound {path}")),
        Command::File { path, .. } => p.unsaid(format!("use of the file {path}")),
        Command::ToolChange { .. }
        | Command::Overrides { .. }
        | Command::EndStack
        | Command::Chorded(_)
        | Command::State { .. }
        | Command::Diagnostic(_) => {}
    }
}

/// Settings that changed, as the V commands that set them, as soon as something follows them.
fn write_settings(p: &mut SbpPrinter<'_>) {
    let Some(settings) = p.changed.take() else { return };
    let before = std::mem::replace(&mut p.settings, settings.clone());
    let known = settings_lines(&before);
    for line in settings_lines(&settings) {
        let of_the_file = ["VD", "SA", "SR"].iter().any(|own| line.starts_with(own));
        if !of_the_file && !known.contains(&line) {
            p.line(&line);
        }
    }
    p.speeds = super::written_speeds::Written::of(&settings.speeds.cut);
}

fn path_control(p: &mut SbpPrinter<'_>, path: PathControl) {
    let usual = path == PathControl::Blend { tolerance_mm: None, merge_mm: None };
    if !usual && !std::mem::replace(&mut p.path_control_told, true) {
        p.unsaid("how closely the path is followed (G61, G64): the ramps of VR hold");
    }
}

fn print(p: &mut SbpPrinter<'_>, text: &str, newline: bool) {
    let quoted = text.replace('"', "'");
    // With a comma as first separator the commas of a text would part it.
    let mode = if text.contains(',') { ";" } else { "" };
    let end = if newline { "" } else { ";" };
    p.line(&format!("PRINT{mode} \"{quoted}\"{end}"));
}

/// The name of a tool path or a tool, as the previewer's comments have it.
fn tool_path(p: &mut SbpPrinter<'_>, start: &ToolPathStart) {
    if p.named == Some(p.at) {
        return;
    }
    let name = start.name.as_ref().map(|name| format!("Toolpath Name = {name}"));
    let tool = start.tool.as_ref().map(|tool| format!("Tool Name = {tool}"));
    for text in [name, tool].into_iter().flatten() {
        p.comment(&text);
        p.named = Some(p.at);
    }
}

fn change(p: &mut SbpPrinter<'_>, words: ChangeWords) {
    match words {
        ChangeWords::PutIn(tool) => put_in(p, &tool),
        ChangeWords::Hold(text) => p.hold(&Hold { at: p.at, text, until: None }),
    }
}

/// The owner's own file changes the tool.
fn put_in(p: &mut SbpPrinter<'_>, tool: &str) {
    let digits: String = tool.chars().filter(char::is_ascii_digit).collect();
    let name = if digits.is_empty() { format!("\"{tool}\"") } else { digits };
    p.line(&format!("&Tool = {name}"));
    p.line("C9");
    p.places.changed_tool();
    p.named = Some(p.at);
}
