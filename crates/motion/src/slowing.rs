//! Down to a slower plan from a speed that is above it: where the operator lowers the feed while the
//! machine moves.
//!
//! ```text
//!  speed ▲ now
//!        │   ╲  as steeply as the ramps allow
//!        │    ╲
//!        │ ────╳──────╲    goal: the plan as if it had always been slower
//!        └─────┴───────────► way
//!            meets
//! ```

use crate::moves::Move;
use crate::plan::{Law, Plan};
use crate::profile::{Phases, Profile};
use crate::ramped::Ramped;

/// The way down to a plan.
#[derive(Debug)]
pub(crate) struct Slowing {
    /// Moves and parts of them that are made meanwhile.
    pub made: Plan,
    /// Moves of the goal, and parts of them, that are left.
    pub left: Vec<Move>,
    /// Speed where the goal is met.
    pub v: f64,
}

/// Slows from a speed at the start of a plan until it is met; `None` when it is not slower.
pub(crate) fn slow_down(goal: &Plan, mut v: f64) -> Option<Slowing> {
    let Law::Ramped(law) = &goal.law else { return None };
    if law.profiles.first().is_none_or(|first| v <= first.v_entry) {
        return None;
    }
    let (mut moves, mut profiles, mut left) = (Vec::new(), Vec::new(), Vec::new());
    let mut t_s = 0.0;
    for (i, m) in goal.moves.iter().enumerate() {
        let way_mm = meets(&law.phases(i, m), &law.profiles[i], m, v);
        let way_mm = way_mm.unwrap_or(m.length_mm);
        let share = (way_mm / m.length_mm).min(1.0);
        let exit = (v * v - 2.0 * m.accel_mm_s2 * way_mm).max(0.0).sqrt();
        if way_mm > 0.0 {
            profiles.push(Profile { start_s: t_s, v_entry: v, v_peak: v, v_exit: exit });
            // Mean speed times time is way, for constant acceleration.
            t_s += 2.0 * way_mm / (v + exit);
            let (made, rest) = m.split(share);
            moves.push(if share < 1.0 { made } else { *m });
            left.extend((share < 1.0).then_some(rest));
        } else {
            left.push(*m);
        }
        v = exit;
        let next = goal.moves.get(i + 1);
        let goes_on = next.is_some_and(|next| next.continues(m));
        let entry = law.profiles.get(i + 1).map_or(0.0, |p| p.v_entry);
        if share < 1.0 || !goes_on || v <= entry {
            left.extend_from_slice(&goal.moves[i + 1..]);
            break;
        }
    }
    let law = Law::Ramped(Ramped { profiles, duration_s: t_s });
    Some(Slowing { made: Plan { moves, law }, left, v })
}

/// After which way slowing from a speed meets a profile; `None` when not in this move.
fn meets(phases: &Phases, goal: &Profile, m: &Move, v: f64) -> Option<f64> {
    let (square, a) = (v * v, m.accel_mm_s2);
    if v <= goal.v_entry {
        return Some(0.0);
    }
    let [rise_mm, cruise_mm] = phases.ways_mm();
    let rising = (square - goal.v_entry * goal.v_entry) / (4.0 * a);
    if rising <= rise_mm {
        return Some(rising);
    }
    let level = (square - goal.v_peak * goal.v_peak) / (2.0 * a);
    (level <= rise_mm + cruise_mm).then_some(level)
}
