//! The ramps of the OpenSBP command reference (section "Ramping", command VR).

use crate::moves::Move;
use crate::plan::Plan;
use crate::profile::Profile;
use kerf_program::settings::Ramps;

/// A model of motion: decides how fast a stack of moves is run.
pub trait Model {
    /// Plans a stack. It starts and ends at rest.
    fn plan(&self, moves: Vec<Move>) -> Plan;
}

/// Linear ramps between ramp speed and move speed, slowed where the direction changes.
#[derive(Clone, Copy, Debug)]
pub struct ShopBot<'a> {
    /// What VR says.
    pub ramps: &'a Ramps,
}

/// Plans a stack with the ramps of the command reference.
pub fn plan_stack(moves: Vec<Move>, ramps: &Ramps) -> Plan {
    ShopBot { ramps }.plan(moves)
}

impl Model for ShopBot<'_> {
    fn plan(&self, moves: Vec<Move>) -> Plan {
        let mut profiles = caps(&moves);
        fit(&moves, &mut profiles);
        Plan::new(moves, profiles)
    }
}

/// The highest speeds that each move may have at its start, inside and at its end.
fn caps(moves: &[Move]) -> Vec<Profile> {
    let ends = |m: &Move| m.speed_mm_s.min(m.ramp_mm_s);
    let mut caps: Vec<Profile> = moves
        .iter()
        .map(|m| Profile { start_s: 0.0, v_entry: ends(m), v_peak: m.speed_mm_s, v_exit: ends(m) })
        .collect();
    for i in 1..moves.len() {
        if moves[i].continues(&moves[i - 1]) {
            let v = caps[i - 1].v_peak.min(caps[i].v_peak);
            caps[i - 1].v_exit = v;
            caps[i].v_entry = v;
        }
    }
    caps
}

/// Lowers caps until every move can be made with its acceleration: a pass back, so that every
/// move can slow in time, and a pass forward, so that none starts faster than was reached.
fn fit(moves: &[Move], caps: &mut [Profile]) {
    for i in (0..moves.len()).rev() {
        if i + 1 < moves.len() && moves[i + 1].continues(&moves[i]) {
            caps[i].v_exit = caps[i + 1].v_entry;
        }
        caps[i].v_entry = caps[i].v_entry.min(reach(&moves[i], caps[i].v_exit));
    }
    for i in 0..moves.len() {
        if i > 0 && moves[i].continues(&moves[i - 1]) {
            caps[i].v_entry = caps[i - 1].v_exit;
        }
        caps[i].v_exit = caps[i].v_exit.min(reach(&moves[i], caps[i].v_entry));
        caps[i].v_peak = peak(&moves[i], &caps[i]);
    }
}

/// The speed to which a move can accelerate from one end to the other.
fn reach(m: &Move, v: f64) -> f64 {
    (v * v + 2.0 * m.accel_mm_s2 * m.length_mm).sqrt()
}

/// The highest speed in a move: the cap, or where rise and fall meet in a short move.
fn peak(m: &Move, cap: &Profile) -> f64 {
    let (a, b) = (cap.v_entry * cap.v_entry, cap.v_exit * cap.v_exit);
    let meet = (m.accel_mm_s2 * m.length_mm + 0.5 * (a + b)).sqrt();
    meet.min(cap.v_peak).max(cap.v_entry).max(cap.v_exit)
}
