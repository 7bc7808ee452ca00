//! Stops and overrides of the feed: the curves stay, speeds are found anew.

use super::ProfilerPlanner;
use crate::ahead::Ahead;
use crate::fit::Fit;
use crate::moves::Move;
use crate::plan::Plan;
use crate::planner::Replanner;
use crate::slowing::slow_down;
use crate::stop::Stop;

impl ProfilerPlanner {
    /// Takes out all moves that have their curves: those of a piece that is known, and those behind.
    fn unmade(&mut self) -> impl Iterator<Item = Move> {
        let ready = self.ready.take().into_iter().flat_map(|plan| plan.moves);
        let ahead = std::mem::take(&mut self.ahead).moves;
        ready.chain(ahead).chain(std::mem::take(&mut self.curved))
    }

    /// Goes on with moves that have their curves, at a speed (without one as fast as these allow) and
    /// a time. What is not smoothed yet follows them.
    fn go_on(&mut self, left: Vec<Move>, v: Option<f64>, t_s: f64) {
        (self.ahead, self.fit) = (Ahead::default(), Fit::running(v, t_s));
        (self.curved, self.enough) = (left.into(), 0);
    }

    /// The plan of moves that have their curves, from the speed they allow to a stand. Only as many
    /// as it takes to slow down from a speed to that of the plan, which in the end slows too.
    fn goal(&self, left: &[Move], v: f64) -> Option<Plan> {
        let mut square = 4.0 * v * v;
        let near = left.iter().take_while(|m| {
            let goes_on = square > 0.0;
            square -= 2.0 * m.accel_mm_s2 * m.length_mm;
            goes_on
        });
        let mut planner = Self::new(&self.dynamics, &self.smoothing);
        near.for_each(|m| planner.cap(*m));
        let known = planner.ahead.moves.len();
        planner.fit.take(&mut planner.ahead, known, true)
    }
}

impl Replanner for ProfilerPlanner {
    fn stop(&mut self, piece: Plan, t_s: f64, ramped: bool) -> Option<(Plan, Stop)> {
        let mut all = piece;
        // Near the end of what is known the machine could not stand in time.
        let mut stop = all.stop(t_s, ramped)?;
        while stop.end_s >= all.duration_s() {
            let Some(next) = self.ready.take().or_else(|| self.piece(true)) else { break };
            all.join(next);
            stop = all.stop(t_s, ramped)?;
        }
        let (made, mut rest) = all.cut(&stop);
        rest.extend(self.unmade());
        self.go_on(rest, None, 0.0);
        Some((made, stop))
    }

    fn feed(&mut self, piece: Plan, t_s: f64, share: f32) -> Option<(Plan, Stop)> {
        let (t_s, v) = piece.overridable(t_s);
        let stop = piece.stop(t_s, false)?;
        let (made, mut rest) = piece.cut(&stop);
        rest.extend(self.unmade());
        rest.iter_mut().chain(&mut self.read).for_each(|m| *m = m.at_feed(share));
        let goal = self.goal(&rest, v);
        let near = goal.as_ref().map_or(0, |goal| goal.moves.len());
        match goal.and_then(|goal| slow_down(&goal, v)) {
            None => self.go_on(rest, Some(v), 0.0),
            Some(mut slowing) => {
                slowing.left.extend_from_slice(&rest[near..]);
                self.go_on(slowing.left, Some(slowing.v), slowing.made.duration_s());
                self.ready = Some(slowing.made);
            }
        }
        Some((made, stop))
    }
}
