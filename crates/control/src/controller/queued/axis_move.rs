//! Moves of one axis of a board with step queues, outside a run: on the bench.

use super::machine::Queued;
use kerf_machine::{Configuration, Going, Machine};
use kerf_motion::{Mover, Plan, planner};
use kerf_program::{At, Axis, Feed, Line, MoveKind};

/// A move takes no longer than this, seconds.
const PATIENCE_S: f64 = 60.0;

/// Move of one axis to a place.
#[derive(Clone, Copy, Debug)]
pub struct AxisMove {
    /// The axis.
    pub axis: Axis,
    /// The place, mm or degrees.
    pub to_mm: f64,
    /// Its speed, mm/s or degrees/s.
    pub mm_s: f64,
}

impl AxisMove {
    fn plan(self, queued: &Queued, machine: &Configuration) -> Option<Plan> {
        let settings = &machine.program;
        let (from, mut to) = (queued.counted(), queued.counted());
        to[self.axis] = self.to_mm;
        let line = Line { kind: MoveKind::Cut, to, feed: Feed::Path(self.mm_s) };
        let made = Mover::new(from, settings).line(At::default(), &line)?;
        let mut planner = planner(settings);
        planner.push(made);
        planner.finish()
    }

    /// Makes it, and waits until the axis stands. Returns `false` where it was stopped, at once and without a ramp.
    ///
    /// # Errors
    /// It does not come to its place; in words.
    pub fn moves(
        self,
        queued: &mut Queued,
        machine: &Configuration,
        is_stopped: impl Fn() -> bool,
    ) -> Result<bool, String> {
        self.goes(queued, machine, |_| is_stopped())?;
        while !is_stopped() && queued.settle() {}
        if is_stopped() {
            queued.halt();
            return Ok(false);
        }
        queued.close(true, || false);
        queued.fault().map_or(Ok(true), |fault| Err(fault.message.clone()))
    }

    /// Makes it until something holds of the time since its beginning, seconds, or the axis is there.
    ///
    /// # Errors
    /// It does not come to its place; in words.
    pub fn goes(
        self,
        queued: &mut Queued,
        machine: &Configuration,
        ends: impl Fn(f64) -> bool,
    ) -> Result<(), String> {
        let Some(plan) = self.plan(queued, machine) else { return Ok(()) };
        let (t0_s, end_s) = (queued.progress().at_s, plan.duration_s());
        let (moves, mut index) = (plan.moves().len(), 0);
        queued.begin_plan();
        while index < moves {
            let going = Going { plan: &plan, index, t0_s, until: moves, part: 1.0, watches: &[] };
            let news = queued.advance(&going, t0_s, t0_s + end_s);
            if let Some(fault) = queued.fault() {
                return Err(fault.message.clone());
            }
            let since_s = queued.progress().at_s - t0_s;
            if since_s > PATIENCE_S {
                return Err(format!("{} does not come to its place", self.axis.letter()));
            }
            if ends(since_s) {
                return Ok(());
            }
            index += usize::from(news.reached_s >= t0_s + plan.span_s(index).1);
        }
        Ok(())
    }
}
