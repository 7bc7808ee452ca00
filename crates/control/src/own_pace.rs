//! The time that a run takes on a controller that plans for itself.
//!
//! ```text
//!  moves from stand to stand ── as they are sent ──► OwnPlanner::seconds ──► Clocks: time of the plan ─► time of the controller
//! ```

use crate::controller::merged::together;
use crate::learned::Learned;
use kerf_machine::driver::Facts;
use kerf_machine::driver::planners::{Controller, OwnPlanner};
use kerf_motion::Move;
use kerf_program::{Frame, MoveKind, OutputReason, ToolPathStart};
use kerf_trace::{Event, ExecutedMove, Sink, Tally};

/// Shorter gaps between moves are rounding, seconds.
const GAP_S: f64 = 1e-6;

/// The way in which a controller makes moves in a time of its own: its planner, and how Kerf sends it moves.
#[derive(Clone, Debug, PartialEq)]
pub struct OwnPace {
    planner: OwnPlanner,
    /// Short straight moves that lie so near one line are sent as one, mm.
    tolerance_mm: f64,
    /// The factor by which motion takes longer than the planner says, as runs have shown.
    factor: f64,
}

impl OwnPace {
    /// That of a planner alone, to which short straight moves are sent as one where they lie so near one line, mm.
    pub const fn new(planner: OwnPlanner, tolerance_mm: f64) -> Self {
        Self { planner, tolerance_mm, factor: 1.0 }
    }

    /// Returns the planner, and the distance within which moves are sent as one, mm.
    pub const fn by_planner(&self) -> (&OwnPlanner, f64) {
        (&self.planner, self.tolerance_mm)
    }

    /// That of a controller, by its planner alone; nothing where it makes the plan in its time, or does not tell how it plans.
    pub fn of(facts: &Facts) -> Option<Self> {
        let planner = facts.planner.clone()?;
        Some(Self::new(planner, facts.arc_tolerance_mm))
    }

    /// The same with a factor that was learned from runs.
    pub fn learned(self, learned: Learned) -> Self {
        Self { factor: learned.factor(), ..self }
    }

    /// Returns the seconds of each move, from a stand to a stand.
    pub fn seconds(&self, moves: Vec<Move>) -> Vec<f64> {
        sent_s(&self.planner, moves, self.tolerance_mm)
    }
}

/// Counts a run in the time of a controller that plans for itself.
pub struct OwnTime<'a> {
    controller: &'a dyn Controller,
    /// Kerf sends the moves: short ones that lie so near one line as one, mm.
    sent_mm: Option<f64>,
    /// The factor by which motion takes longer than the controller's planner says.
    factor: f64,
    /// The counts, in that controller's time.
    pub tally: Tally,
    /// Both times at the ends of moves and waits.
    clocks: Clocks,
    /// Moves since the machine stood, with their ends in the plan's own time, seconds.
    run: Vec<(Move, f64)>,
    /// End of the last move in the plan's own time, seconds.
    end_s: f64,
}

impl<'a> OwnTime<'a> {
    /// That of a controller which gets each move as a line, from whatever sends files.
    pub fn of_file(controller: &'a dyn Controller) -> Self {
        Self {
            controller,
            sent_mm: None,
            factor: 1.0,
            tally: Tally::default(),
            clocks: Clocks::default(),
            run: Vec::new(),
            end_s: 0.0,
        }
    }

    /// That of a controller which Kerf drives.
    pub fn of_run(pace: &'a OwnPace) -> Self {
        let (sent_mm, factor) = (Some(pace.tolerance_mm), pace.factor);
        Self { sent_mm, factor, ..Self::of_file(&pace.planner) }
    }

    /// Seconds in all.
    pub fn total_s(&self) -> f64 {
        let t = &self.tally;
        t.cut_s + t.jog_s + t.wait_s + t.tool_change_s
    }

    /// The moments of the plan in the controller's time.
    pub fn clocks(self) -> Clocks {
        self.clocks
    }

    /// The machine stands: the moves since it last did are counted.
    fn stand(&mut self) {
        let run = std::mem::take(&mut self.run);
        let moves: Vec<Move> = run.iter().map(|(made, _)| *made).collect();
        let seconds = match self.sent_mm {
            Some(tolerance_mm) => sent_s(self.controller, moves, tolerance_mm),
            None => self.controller.seconds(&moves),
        };
        for ((made, end_s), seconds) in run.iter().zip(seconds) {
            let seconds = seconds * self.factor;
            self.tally.made(made, seconds, &Frame::default());
            self.clocks.goes_on(*end_s, seconds);
        }
    }

    /// Time without motion is the same everywhere.
    fn wait(&mut self, until_s: f64) {
        let wait_s = until_s - self.end_s;
        if wait_s > GAP_S {
            self.stand();
            self.tally.waited(wait_s);
            self.clocks.goes_on(until_s, wait_s);
        }
        self.end_s = self.end_s.max(until_s);
    }
}

impl Sink for OwnTime<'_> {
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
        self.end_s = made.t0_s + made.span.t1_s;
        self.run.push((*made.span.made, self.end_s));
    }
}

/// Seconds of each move, where short ones on one line are sent as one and a jog as a move of its speed.
fn sent_s(controller: &dyn Controller, mut moves: Vec<Move>, tolerance_mm: f64) -> Vec<f64> {
    let mut rest = &moves[..];
    let (mut sent, mut counts) = (Vec::new(), Vec::new());
    while !rest.is_empty() {
        let (together, others) = rest.split_at(together(rest, tolerance_mm));
        sent.extend(as_one(together));
        counts.push(together.len());
        rest = others;
    }
    let mut seconds = controller.seconds(&sent).into_iter();
    let mut of_each = Vec::with_capacity(moves.len());
    for count in counts {
        let whole_s = seconds.next().unwrap_or(0.0);
        let parts: Vec<f64> = moves.drain(..count).map(|made| made.length_mm).collect();
        let length: f64 = parts.iter().sum();
        of_each.extend(parts.into_iter().map(|part| whole_s * part / length));
    }
    of_each
}

/// The move that is sent for several.
fn as_one(moves: &[Move]) -> Option<Move> {
    let (mut one, last) = (*moves.first()?, moves.last()?);
    (one.speed_mm_s, one.kind, one.to) = (one.top_mm_s(), MoveKind::Cut, last.to);
    one.length_mm = moves.iter().map(|made| made.length_mm).sum();
    Some(one)
}

/// The moments of a plan in the time of the controller that makes it.
#[derive(Clone, Debug, Default)]
pub struct Clocks {
    /// Moments of the plan and of the controller, seconds, in their order.
    both: Vec<[f64; 2]>,
}

impl Clocks {
    /// The plan comes to a moment, for which the controller takes so long.
    fn goes_on(&mut self, plan_s: f64, takes_s: f64) {
        let [_, before_s] = self.both.last().copied().unwrap_or_default();
        self.both.push([plan_s, before_s + takes_s]);
    }

    /// Returns a moment of the plan in the controller's time, seconds.
    pub fn own_s(&self, plan_s: f64) -> f64 {
        let behind = self.both.partition_point(|[plan, _]| *plan < plan_s);
        let before = behind.checked_sub(1).map_or([0.0; 2], |at| self.both[at]);
        let Some(next) = self.both.get(behind) else { return before[1] + plan_s - before[0] };
        let span_s = next[0] - before[0];
        let share = if span_s > 0.0 { (plan_s - before[0]) / span_s } else { 1.0 };
        before[1] + share * (next[1] - before[1])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_moment_within_a_move_lies_within_it_in_the_time_of_the_controller_too() {
        let mut clocks = Clocks::default();
        for (plan_s, takes_s) in [(1.0, 2.0), (3.0, 2.0), (4.0, 1.0)] {
            clocks.goes_on(plan_s, takes_s);
        }
        for (plan_s, own_s) in
            [(0.0, 0.0), (0.5, 1.0), (1.0, 2.0), (2.0, 3.0), (4.0, 5.0), (4.5, 5.5)]
        {
            assert_eq!(clocks.own_s(plan_s), own_s, "{plan_s}");
        }
    }
}
