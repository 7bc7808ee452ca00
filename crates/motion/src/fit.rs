//! Lowers wished speeds until every move can be made with its acceleration, and so makes the
//! profiles of a stack: the look-ahead, over the whole stack at once.

use crate::moves::Move;
use crate::plan::{Law, Plan};
use crate::profile::Profile;
use crate::ramped::Ramped;

/// Turns the highest speeds allowed at the ends and inside each move into profiles: a pass back, so
/// that every move can slow in time, and a pass forward, so that none starts faster than was reached.
pub(crate) fn fit(moves: Vec<Move>, mut caps: Vec<Profile>) -> Plan {
    slow_in_time(&moves, &mut caps);
    let duration_s = run(&moves, &mut caps);
    Plan { moves, law: Law::Ramped(Ramped { profiles: caps, duration_s }) }
}

fn slow_in_time(moves: &[Move], caps: &mut [Profile]) {
    let mut v = None;
    for i in (0..moves.len()).rev() {
        let (m, cap) = (&moves[i], &mut caps[i]);
        cap.v_exit = v.unwrap_or(cap.v_exit).min(cap.v_exit);
        cap.v_entry = cap.v_entry.min(reach(m, cap.v_exit));
        v = (i > 0 && m.continues(&moves[i - 1])).then_some(cap.v_entry);
    }
}

/// Gives the time at the end, seconds.
fn run(moves: &[Move], caps: &mut [Profile]) -> f64 {
    let (mut v, mut t_s) = (None, 0.0);
    for (i, (m, cap)) in moves.iter().zip(caps).enumerate() {
        cap.start_s = t_s;
        cap.v_entry = v.unwrap_or(cap.v_entry);
        cap.v_exit = cap.v_exit.min(reach(m, cap.v_entry));
        cap.v_peak = peak(m, cap);
        t_s += cap.phases(m.length_mm, m.accel_mm_s2).duration_s();
        let goes_on = moves.get(i + 1).is_some_and(|next| next.continues(m));
        v = goes_on.then_some(cap.v_exit);
    }
    t_s
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
