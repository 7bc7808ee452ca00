//! Planning while a program is read: moves go in at one end, finished pieces of plan come out at the
//! other, and only what a later move can still change is kept.
//!
//! ```text
//!  push ──► move … move   ──► take ──► Plan, Plan, …    times go on from piece to piece
//!           the window
//! ```

use crate::moves::Move;
use crate::plan::Plan;
use crate::stop::Stop;

/// A model of motion: decides how fast a stack of moves is run.
pub trait Model {
    /// Plans a stack. It starts and ends at rest.
    fn plan(&self, moves: Vec<Move>) -> Plan;
}

/// Plans one stack of moves, which starts and ends at rest, while it is read.
///
/// The pieces of plan that come out follow each other without a gap; each tells its times from the
/// start of the stack. Put together they do not depend on when pieces were taken.
pub trait Planner {
    /// The next move of the stack.
    fn push(&mut self, made: Move);

    /// The next piece of plan that no later move can change; `None` when more has to be known first.
    fn take(&mut self) -> Option<Plan>;

    /// The stack is complete: the last piece of its plan, which ends at rest; `None` when nothing is
    /// left. Moves pushed later belong to another stack, which begins at time 0.
    fn finish(&mut self) -> Option<Plan>;

    /// Forgets the stack, and gives back the moves that did not come out: after a stop somebody moved
    /// the workpiece, or they are planned otherwise.
    fn withdraw(&mut self) -> Vec<Move>;
}

/// A planner whose plan can be left for another on the way.
pub trait Replanner: Planner {
    /// The machine is stopped at a time inside the piece that came out last: ramped along the path,
    /// or at once. Gives the piece as it is made now, which ends where the machine stands and may
    /// run on into moves that had not come out, and the stop.
    ///
    /// What is left of the stack stays: it comes out as another stack, which begins there at time 0.
    /// `None` only for a piece without moves.
    fn stop(&mut self, piece: Plan, t_s: f64, ramped: bool) -> Option<(Plan, Stop)>;

    /// From a time inside the piece that came out last cuts run at another share of the speed asked
    /// for ([`Move::at_feed`]). Gives the piece as it is made up to there, and where that is.
    ///
    /// What is left of the stack stays: it comes out as another stack, which goes on there at the
    /// present speed, at time 0. Moves that are pushed later have their own share.
    fn feed(&mut self, piece: Plan, t_s: f64, share: f32) -> Option<(Plan, Stop)>;
}
