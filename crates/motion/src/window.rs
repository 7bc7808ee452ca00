//! The ramps of the command reference, planned while a stack is read.

use crate::ahead::Ahead;
use crate::caps::{BLOCK, Caps};
use crate::fit::Fit;
use crate::moves::Move;
use crate::plan::Plan;
use crate::planner::{Planner, Replanner};
use crate::slowing::slow_down;
use crate::stop::Stop;
use crate::surge::Runs;
use kerf_program::settings::Ramps;

/// Plans a stack with the ramps of the command reference while it is read.
///
/// What is kept: the moves within the minimum distance, those of a run between full corners that may
/// still prove short, and those on which the tool may have to slow for what comes; and a block, so
/// that the work for a move does not depend on how often pieces are taken.
#[derive(Clone, Debug)]
pub struct ShopBotPlanner {
    ramps: Ramps,
    ahead: Ahead,
    caps: Caps,
    runs: Runs,
    fit: Fit,
    /// The next piece is looked for when so many moves are known.
    enough: usize,
    /// So many moves at the front were made already, and count only for the bends in them.
    behind: usize,
    /// A piece that is known already.
    ready: Option<Plan>,
}

impl ShopBotPlanner {
    /// For a stack that is planned with these ramps.
    pub fn new(ramps: &Ramps) -> Self {
        Self {
            ramps: *ramps,
            ahead: Ahead::default(),
            caps: Caps::new(ramps, BLOCK),
            runs: Runs::new(ramps),
            fit: Fit::default(),
            enough: BLOCK,
            behind: 0,
            ready: None,
        }
    }

    /// For a stack that begins with these moves.
    pub fn of(ramps: &Ramps, moves: Vec<Move>) -> Self {
        let mut planner = Self::new(ramps);
        planner.ahead.moves = moves;
        planner
    }

    /// Goes on from moves that were made with those that are left, at a speed (without one as fast as
    /// these allow) and a time.
    fn going_on(ramps: &Ramps, made: &[Move], left: &[Move], v: Option<f64>, t_s: f64) -> Self {
        let behind = Caps::reach_back(ramps, made);
        let mut planner = Self::of(ramps, [behind, left].concat());
        planner.behind = behind.len();
        planner.fit = Fit::running(v, t_s);
        planner.runs.begin_long();
        planner.enough = 0;
        planner
    }

    /// A piece that came out and all that is known behind it, as if nothing came after: a plan that
    /// ends at rest.
    fn all(&mut self, mut piece: Plan) -> Plan {
        while let Some(next) = self.finish() {
            piece.join(next);
        }
        piece
    }

    fn piece(&mut self, complete: bool) -> Option<Plan> {
        loop {
            self.stride(complete);
            if self.ahead.caps.len() == self.ahead.moves.len() {
                break;
            }
        }
        let plan = self.fit.made(&mut self.ahead)?;
        self.runs.left(plan.moves.len());
        Some(plan)
    }

    /// Goes on by a block, so that what is looked at several times is still near the processor; by more where
    /// much stays open and is looked at again.
    fn stride(&mut self, complete: bool) {
        let Self { ahead, caps, runs, fit, behind, .. } = self;
        let open = ahead.caps.len() - fit.done();
        caps.walk(ahead, BLOCK.max(open));
        let last = complete && ahead.caps.len() == ahead.moves.len();
        if last {
            caps.finish(ahead);
        }
        let settled = if last { ahead.moves.len() } else { caps.settled(ahead) };
        let capped = runs.hold_short(ahead, settled, last);
        if capped >= *behind {
            let made = std::mem::take(behind);
            ahead.take(made);
            runs.left(made);
            fit.advance(ahead, capped - made, last);
        }
    }
}

impl Planner for ShopBotPlanner {
    fn push(&mut self, made: Move) {
        self.ahead.moves.push(made);
    }

    fn take(&mut self) -> Option<Plan> {
        if self.ready.is_some() {
            return self.ready.take();
        }
        if self.ahead.moves.len() < self.enough {
            return None;
        }
        let plan = self.piece(false);
        // What stays is looked at again: twice as many make up for it.
        self.enough = BLOCK.max(2 * self.ahead.moves.len());
        plan
    }

    fn finish(&mut self) -> Option<Plan> {
        if self.ready.is_some() {
            return self.ready.take();
        }
        let plan = self.piece(true);
        *self = Self::new(&self.ramps);
        plan
    }

    fn withdraw(&mut self) -> Vec<Move> {
        std::mem::replace(self, Self::new(&self.ramps)).ahead.moves
    }
}

impl Replanner for ShopBotPlanner {
    fn stop(&mut self, piece: Plan, t_s: f64, ramped: bool) -> Option<(Plan, Stop)> {
        let all = self.all(piece);
        let stop = all.stop(t_s, ramped)?;
        let (made, rest) = all.cut(&stop);
        *self = Self::of(&self.ramps, rest);
        self.enough = 0;
        Some((made, stop))
    }

    fn feed(&mut self, piece: Plan, t_s: f64, share: f32) -> Option<(Plan, Stop)> {
        let all = self.all(piece);
        let (t_s, v) = all.overridable(t_s);
        let stop = all.stop(t_s, false)?;
        let (made, rest) = all.cut(&stop);
        let rest: Vec<Move> = rest.into_iter().map(|m| m.at_feed(share)).collect();
        let goal = Self::going_on(&self.ramps, &made.moves, &rest, None, 0.0).finish();
        *self = match goal.and_then(|goal| slow_down(&goal, v)) {
            None => Self::going_on(&self.ramps, &made.moves, &rest, Some(v), 0.0),
            Some(slowing) => {
                let made = [Caps::reach_back(&self.ramps, &made.moves), &slowing.made.moves];
                let (left, t_s) = (&slowing.left, slowing.made.duration_s());
                let mut planner =
                    Self::going_on(&self.ramps, &made.concat(), left, Some(slowing.v), t_s);
                planner.ready = Some(slowing.made);
                planner
            }
        };
        Some((made, stop))
    }
}
