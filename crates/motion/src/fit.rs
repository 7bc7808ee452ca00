//! Lowers wished speeds until every move can be made with its acceleration, and so makes the
//! profiles of a stack: the look-ahead, as far as moves are known.
//!
//! ```text
//!  speed ▲         caps ▔▔▔▔▔▔▔╲▁▁▁▁▁▁
//!        │ ╱▔▔▔▔▔╲ ╱▔▔▔▔▔▔▔▔▔▔╲│       hi: as if nothing slowed after the last move known
//!        │╱       ▔             ╲      lo: as if the machine had to stand there
//!        └────────────────┴──────┴───► way
//!               final        open
//! ```
//!
//! Whatever comes, the speed lies between the two. Where they agree, everything before is final.

use crate::ahead::Ahead;
use crate::moves::Move;
use crate::plan::{Law, Plan};
use crate::profile::Profile;
use crate::ramped::Ramped;

/// The look-ahead over one stack.
#[derive(Clone, Debug, Default)]
pub(crate) struct Fit {
    /// So many moves of the window were passed back before.
    passed: usize,
    /// So many moves of the window have their profiles.
    done: usize,
    /// Speed at the end of the last piece, when it runs on.
    v: Option<f64>,
    /// Time at the end of the last piece, seconds.
    t_s: f64,
}

impl Fit {
    /// Begins at a speed and a time; without a speed as fast as the caps allow.
    pub const fn running(v: Option<f64>, t_s: f64) -> Self {
        Self { passed: 0, done: 0, v, t_s }
    }

    /// Goes on with so many moves that have their caps for good; `complete` when they are all of the stack.
    pub fn advance(&mut self, ahead: &mut Ahead, capped: usize, complete: bool) {
        let known = self.slow_in_time(ahead, capped, complete);
        self.run(ahead, known);
    }

    /// Returns the number of moves of the window that have their profiles.
    pub const fn done(&self) -> usize {
        self.done
    }

    /// Goes on, and gives the next piece of plan.
    pub fn take(&mut self, ahead: &mut Ahead, capped: usize, complete: bool) -> Option<Plan> {
        self.advance(ahead, capped, complete);
        self.made(ahead)
    }

    /// The next piece of plan: the moves that have their profiles.
    pub fn made(&mut self, ahead: &mut Ahead) -> Option<Plan> {
        let count = std::mem::take(&mut self.done);
        if count == 0 {
            return None;
        }
        let (moves, profiles) = ahead.take(count);
        self.passed -= count;
        let law = Law::Ramped(Ramped { profiles, duration_s: self.t_s });
        Some(Plan { moves, law })
    }

    /// A pass back, so that every move can slow in time. Gives how many moves are final.
    fn slow_in_time(&mut self, ahead: &mut Ahead, capped: usize, complete: bool) -> usize {
        let (mut hi, mut lo) = (None, if complete { None } else { Some(0.0) });
        let mut known = self.done;
        for i in (self.done..capped).rev() {
            let m = &ahead.moves[i];
            if ahead.moves.get(i + 1).is_none_or(|next| !next.continues(m)) {
                (hi, lo) = (None, None);
            }
            let cap = &mut ahead.caps[i];
            let exit = cap.v_exit;
            cap.v_exit = at_most(exit, hi);
            let least = at_most(exit, lo);
            if known == self.done && least == cap.v_exit {
                known = i + 1;
            }
            if known > self.done && i < self.passed && cap.v_exit == exit {
                break;
            }
            lo = Some(cap.v_entry.min(reach(m, least)));
            cap.v_entry = cap.v_entry.min(reach(m, cap.v_exit));
            hi = Some(cap.v_entry);
        }
        self.passed = capped;
        known
    }

    /// A pass forward, so that no move starts faster than was reached; the profiles come of it.
    fn run(&mut self, ahead: &mut Ahead, known: usize) {
        for i in self.done..known {
            let (m, cap) = (&ahead.moves[i], &mut ahead.caps[i]);
            cap.start_s = self.t_s;
            cap.v_entry = self.v.unwrap_or(cap.v_entry);
            cap.v_exit = cap.v_exit.min(reach(m, cap.v_entry));
            cap.v_peak = peak(m, cap);
            self.t_s += cap.phases(m.length_mm, m.accel_mm_s2).duration_s();
            let goes_on = ahead.moves.get(i + 1).is_some_and(|next| next.continues(m));
            self.v = goes_on.then_some(cap.v_exit);
        }
        self.done = known;
    }
}

fn at_most(cap: f64, bound: Option<f64>) -> f64 {
    bound.unwrap_or(cap).min(cap)
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
