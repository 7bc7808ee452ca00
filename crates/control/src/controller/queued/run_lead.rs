//! Time by which a run hands pieces over before they begin.

use super::facts::{HANDING_S, LONGEST_S, SAFETY, SPARE};

/// A lead that is so many times the one that was told, or that part of it, is told.
const TOLD: f64 = 1.5;
/// Share of a stall that is forgotten in a second.
const FORGOTTEN: f64 = 0.02;

/// The stalls of a run, and what the operator was told of the lead of its board.
#[derive(Debug, Default)]
pub struct RunLead {
    /// Longest time for which the run did not look, slowly forgotten, seconds.
    stall_s: f64,
    /// The lead of the board that the operator was told of, seconds; nothing before the first motion.
    told_s: Option<f64>,
}

impl RunLead {
    /// Takes down that the run looks again after so many seconds, of which it waited for some.
    pub fn looked(&mut self, gap_s: f64, wait_s: f64, moves: bool) {
        let stalled_s = if moves { (gap_s - wait_s).min(LONGEST_S) } else { 0.0 };
        let forgotten = 1.0 - FORGOTTEN * gap_s.min(1.0);
        self.stall_s = (self.stall_s * forgotten).max(stalled_s);
    }

    /// Shortest time by which a piece is handed over before it begins, seconds, with such a lead of the board.
    pub fn least_s(lead_s: f64) -> f64 {
        0.5 * lead_s + HANDING_S
    }

    /// Time by which pieces are handed over before they begin, seconds, with such a lead of the board: so much before the way
    /// to rest would be sent in place of the next one that the run may stall. A hold and another feed come as much later.
    pub fn ahead_s(&self, lead_s: f64) -> f64 {
        Self::least_s(lead_s) + (SPARE * lead_s).max(SAFETY * self.stall_s)
    }

    /// A sentence about the lead of a board of this name, which follows its stalls, where it is another than was told. Seconds.
    pub fn changed(&mut self, name: &str, [stall_s, lead_s]: [f64; 2]) -> Option<String> {
        if lead_s <= 0.0 {
            return None;
        }
        let told_s = *self.told_s.get_or_insert(lead_s);
        if (1.0 / TOLD..TOLD).contains(&(lead_s / told_s)) {
            return None;
        }
        self.told_s = Some(lead_s);
        let why = if lead_s > told_s {
            "the computer stalled for"
        } else {
            "the computer stalls no longer than"
        };
        let [stall_ms, lead_ms] = [stall_s, lead_s].map(|time_s| time_s * 1e3);
        Some(format!(
            "{name}: {why} {stall_ms:.0} ms; motion is sent {lead_ms:.0} ms ahead from now on, and a hold begins as much later"
        ))
    }
}
