//! At which line of the part file a run ended, for its log.

use crate::run_end::RunEnd;
use crate::station::Station;
use kerf_diag::{Code, Diagnostic, Severity, SourcePlace};
use kerf_program::{At, Interpreter, Status};
use kerf_workspace::part_log::{self, PartLog};

/// Place of the program when it was looked at last.
#[derive(Clone, Debug, Default)]
pub(crate) struct Trail {
    /// Number of files that are open around the part file: one when a typed line runs it.
    depth: usize,
    /// The open files and the line that runs next in each, outermost first.
    open: Vec<At>,
    /// It asked, so what runs next is the line that asks; else it had been read ahead of the machine.
    asked: bool,
    /// The line of the part file's last move.
    moved: u32,
}

impl Trail {
    /// Of a part file that lies so deep.
    pub fn new(depth: usize) -> Self {
        Self { depth, ..Self::default() }
    }

    /// The program asks something.
    pub fn asks(&mut self, open: Vec<At>) {
        (self.open, self.asked) = (open, true);
    }

    /// The program goes on.
    pub fn goes_on(&mut self, open: Vec<At>) {
        // When it was read to its end nothing is open, though the machine may still move. A line that
        // asked stays where it is until its answer is taken.
        if !open.is_empty() && open != self.open {
            (self.open, self.asked) = (open, false);
        }
    }

    /// A move was made.
    pub const fn moves(&mut self, at: At) {
        if at.file as usize == self.depth {
            self.moved = at.line;
        }
    }

    /// The line of the part file that was executed last.
    fn line(&self, last_move: At) -> u32 {
        match self.open.get(self.depth..) {
            Some([at]) if self.asked => at.line,
            // A called file was read to its end and still moves: its call waited here.
            Some([at]) if last_move.file != at.file => at.line,
            // The line that called another file lies before the one that runs next.
            Some([at, called, ..]) if last_move.file == called.file => at.line.saturating_sub(1),
            _ => self.moved,
        }
    }
}

/// Writes the line of the part file into the system log.
pub(crate) fn write_system_log<I: Interpreter>(station: &mut Station<'_, I>, over: &RunEnd) {
    let Some(file) = station.interpreter.file_name(station.trail.depth as u32) else { return };
    let failed = over.diagnostic.as_deref().filter(|_| over.status == Status::Failed);
    let line = failed.map(|error| ended_at(station, &file, Some(error)));
    let machine = &station.world.model;
    let (draws, settings) = (machine.draws() || station.world.previews, machine.settings().clone());
    let seconds = station.world.now();
    station.world.workspace.log_file(&settings, &file, draws, seconds, line);
}

/// Writes the log of the part file, if there is one.
pub(crate) fn write_log<I: Interpreter>(
    station: &mut Station<'_, I>,
    log: &PartLog,
    over: &RunEnd,
) {
    let depth = station.trail.depth as u32;
    let Some(file) = station.interpreter.file_name(depth) else { return };
    let (call, error) = (station.interpreter.file_call(depth), over.diagnostic.as_deref());
    let ended = part_log::why(over.status, error).map(|why| (ended_at(station, &file, error), why));
    let (draws, seconds) = (station.world.model.draws(), station.world.now());
    let entry = log.entry(&file, draws, seconds, call, ended);
    if let Err(error) = station.world.workspace.add_to_log(&file, &entry) {
        let message = format!("the log of {file} cannot be written: {error}");
        let diagnostic = Diagnostic::new(Code::FileError, SourcePlace::line(file, 1), message);
        station.world.tell_diagnostic(diagnostic.severity(Severity::Warning));
    }
}

/// The line of the part file at which the run ended: that of the error, or of the call that led
/// to it, else that of the last move.
fn ended_at<I: Interpreter>(
    station: &Station<'_, I>,
    file: &str,
    error: Option<&Diagnostic>,
) -> u32 {
    let places = error.into_iter().flat_map(|d| d.callers.iter().rev().chain([&d.place]));
    let told = places.filter(|p| &*p.file == file && p.line > 0).map(|p| p.line).next();
    told.unwrap_or_else(|| station.trail.line(station.last_move)).max(1)
}
