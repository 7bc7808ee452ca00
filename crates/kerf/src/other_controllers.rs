//! Estimates the time that another controller would take: the moves of a run, from rest to rest, and what
//! its planner makes of them.

use kerf_motion::Move;
use kerf_motion::controllers::Controller;
use kerf_program::{Frame, OutputReason, ToolPathStart};
use kerf_trace::{Event, ExecutedMove, Sink, Tally};

/// Shorter gaps between moves are rounding, seconds.
const GAP_S: f64 = 1e-6;

/// Counts a run as another controller would make it.
pub struct Estimate<'a> {
    controller: &'a dyn Controller,
    /// The counts, in that controller's time.
    pub tally: Tally,
    /// Moves since the machine stood.
    run: Vec<Move>,
    /// End of the last move in Kerf's own time, seconds.
    end_s: f64,
}

impl<'a> Estimate<'a> {
    /// Nothing yet.
    pub fn new(controller: &'a dyn Controller) -> Self {
        Self { controller, tally: Tally::default(), run: Vec::new(), end_s: 0.0 }
    }

    /// Seconds in all.
    pub fn total_s(&self) -> f64 {
        let t = &self.tally;
        t.cut_s + t.jog_s + t.wait_s + t.tool_change_s
    }

    /// The machine stands: the moves since it last did are counted.
    fn stand(&mut self) {
        let seconds = self.controller.seconds(&self.run);
        for (made, seconds) in self.run.drain(..).zip(seconds) {
            self.tally.made(&made, seconds, &Frame::default());
        }
    }

    /// Time without motion is the same everywhere.
    fn wait(&mut self, until_s: f64) {
        if until_s - self.end_s > GAP_S {
            self.stand();
            self.tally.waited(until_s - self.end_s);
        }
        self.end_s = self.end_s.max(until_s);
    }
}

impl Sink for Estimate<'_> {
    fn event(&mut self, event: &Event) {
        match event {
            // Outputs are switched when what came before has been made.
            Event::Output { why: OutputReason::Program, .. } | Event::Spindle { .. } => {
                self.stand()
            }
            Event::ToolPath { name, tool, t } => {
                self.wait(*t);
                self.stand();
                self.tally.begins(&ToolPathStart { name: name.clone(), tool: tool.clone() });
            }
            Event::ToolChange { begin, t } => {
                self.wait(*t);
                self.stand();
                self.tally.changing(*begin);
            }
            Event::End(end) => {
                self.wait(end.t);
                self.stand();
            }
            _ => {}
        }
    }

    fn looks_at_motion(&self) -> bool {
        false
    }

    fn made(&mut self, made: &ExecutedMove<'_>) {
        self.wait(made.t0_s + made.span.t0_s);
        self.run.push(*made.span.made);
        self.end_s = made.t0_s + made.span.t1_s;
    }
}
