//! The path of a run.

use super::pen::Pen;
use super::rotary::is_rotary;
use crate::machine::Planning;
use kerf_control::{OwnTime, Session};
use kerf_diag::Diagnostic;
use kerf_diag::Repetitions;
use kerf_program::Axis;
use kerf_trace::{Event, ExecutedMove, Sink, Tally};

/// Collects moves, their times, and what was found.
#[derive(Debug)]
pub struct Collector {
    /// The path.
    pub pen: Pen,
    /// Time when each move is over.
    pub plan: Planning,
    /// The findings.
    pub findings: Vec<Diagnostic>,
    /// Findings that come again and again.
    again: Repetitions,
    /// Line of the part file itself that was made last: what a file it calls does belongs to it.
    line: u32,
}

impl Collector {
    /// The path of a run from where the machine stands.
    pub fn of(session: &Session) -> Self {
        let start = session.memory.position;
        let rotary = is_rotary(&session.memory.settings);
        let pen = match rotary {
            true => Pen::rotary(start.first3(), start[Axis::B]),
            false => Pen::new(start.first3()),
        };
        let (plan, findings, again) = Default::default();
        Self { pen, plan, findings, again, line: 0 }
    }

    /// Puts all moments into the time of the controller that makes the run; returns its seconds and counts.
    pub fn retime(&mut self, mut own: OwnTime<'_>) -> (f64, Tally) {
        let (seconds, tally) = (own.total_s(), std::mem::take(&mut own.tally));
        let clocks = own.clocks();
        self.pen.path.retime(&clocks);
        self.plan.retime(&clocks);
        (seconds, tally)
    }

    /// Tells how often something was found again; nothing more comes.
    pub fn tell_rest(&mut self) {
        self.findings.extend(self.again.diagnostics());
    }

    fn follow(&mut self, made: &ExecutedMove<'_>) {
        let at = made.span.made.at;
        if at.file == 0 {
            self.line = at.line;
        }
        self.pen.follow(made, self.line, self.plan.moves());
        self.plan.add(made);
    }
}

impl Sink for Collector {
    fn event(&mut self, event: &Event) {
        match event {
            Event::Clear { .. } => self.pen.clear(self.plan.moves()),
            Event::Diag(found) if self.again.is_new(found) => self.findings.push((**found).clone()),
            _ => {}
        }
    }

    fn looks_at_motion(&self) -> bool {
        false
    }

    fn made(&mut self, made: &ExecutedMove<'_>) {
        self.follow(made);
    }
}
