//! Leaving any plan for another on the way, whatever model it comes from.

use crate::moves::Move;
use crate::plan::Plan;
use crate::planner::{Planner, Replanner};
use crate::stop::Stop;

/// A planner of any model that can be stopped and overridden.
#[derive(Clone, Debug)]
pub struct Retimed<P> {
    planner: P,
}

impl<P: Planner> Retimed<P> {
    /// Around a planner.
    pub const fn new(planner: P) -> Self {
        Self { planner }
    }

    /// Leaves a plan with a ramp; what is left is planned anew with its override changed.
    fn leave(
        &mut self,
        mut piece: Plan,
        t_s: f64,
        ramped: bool,
        change: impl Fn(Move) -> Move,
    ) -> Option<(Plan, Stop)> {
        let mut later = Vec::new();
        while let Some(next) = self.planner.finish() {
            later.extend(piece.join(next));
        }
        let stop = piece.stop(t_s, ramped)?;
        let (made, rest) = piece.cut(&stop);
        rest.into_iter().chain(later).for_each(|m| self.planner.push(change(m)));
        Some((made, stop))
    }
}

impl<P: Planner> Planner for Retimed<P> {
    fn push(&mut self, made: Move) {
        self.planner.push(made);
    }

    fn take(&mut self) -> Option<Plan> {
        self.planner.take()
    }

    fn finish(&mut self) -> Option<Plan> {
        self.planner.finish()
    }
}

impl<P: Planner> Replanner for Retimed<P> {
    fn stop(&mut self, piece: Plan, t_s: f64, ramped: bool) -> Option<(Plan, Stop)> {
        self.leave(piece, t_s, ramped, |m| m)
    }

    fn feed(&mut self, piece: Plan, t_s: f64, share: f32) -> Option<(Plan, Stop)> {
        self.leave(piece, t_s, true, |m| m.at_feed(share))
    }

    fn withdraw(&mut self) -> Vec<Move> {
        let rest = std::iter::from_fn(|| self.planner.finish());
        rest.flat_map(|plan| plan.moves().to_vec()).collect()
    }
}
