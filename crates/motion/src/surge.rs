//! Short runs between full corners keep ramp speed, so that a series of very short moves does not
//! surge (command reference, Ramping).

use crate::ahead::Ahead;
use crate::moves::Move;
use kerf_program::settings::Ramps;

/// A run between full corners that cannot reach this multiple of ramp speed keeps ramp speed. The
/// manual gives no number; this is a guess.
const SURGE: f64 = 2.0;

/// No ramp along a reference length is faster than this multiple of the fastest of the axes: at least
/// one of the parts of a length of three is as long as the length over √3.
const ALONG: f64 = 2.0;

/// Runs between full corners, one after the other.
#[derive(Clone, Debug)]
pub(crate) struct Runs {
    /// The next move to look at.
    next: usize,
    /// The first move of the run that is open.
    first: usize,
    /// Gain of the squared speed up to the middle of the run, which is lost again behind it.
    gain: f64,
    corner_before: bool,
    /// A run that gains so much is no short one, whatever comes.
    enough: f64,
}

impl Runs {
    /// For a stack that is planned with these ramps.
    pub fn new(ramps: &Ramps) -> Self {
        let cut = &ramps.cut;
        let fastest = [cut.xy, cut.z, cut.a, cut.b, cut.c].into_iter().fold(0.0, f64::max);
        let enough = surge(ALONG * fastest);
        Self { next: 0, first: 0, gain: 0.0, corner_before: false, enough }
    }

    /// The first run began before the first move: it is no short one.
    pub const fn begin_long(&mut self) {
        self.gain = self.enough;
    }

    /// Goes on over the moves whose caps are settled; `complete` when they are all of the stack. Gives
    /// how many moves have their caps for good.
    pub fn hold_short(&mut self, ahead: &mut Ahead, settled: usize, complete: bool) -> usize {
        for i in self.next..settled {
            let m = &ahead.moves[i];
            let cap = &mut ahead.caps[i];
            cap.v_entry = cap.v_entry.min(cap.v_peak);
            cap.v_exit = cap.v_exit.min(cap.v_peak);
            self.gain += m.accel_mm_s2 * m.length_mm;
            let next = ahead.moves.get(i + 1).filter(|next| next.continues(m));
            let ramp = next.map(|next| m.ramp_mm_s.max(next.ramp_mm_s) * (1.0 + 1e-9));
            let corner = ramp.is_some_and(|ramp| cap.v_exit <= ramp);
            if next.is_some() && !corner {
                continue;
            }
            if corner || self.corner_before {
                self.hold(ahead, i);
            }
            (self.first, self.gain, self.corner_before) = (i + 1, 0.0, corner);
        }
        self.next = settled.max(self.next);
        if complete || self.gain >= self.enough { settled } else { self.first }
    }

    /// So many moves have left the window.
    pub const fn left(&mut self, count: usize) {
        self.next -= count;
        self.first = self.first.saturating_sub(count);
    }

    fn hold(&self, ahead: &mut Ahead, last: usize) {
        let ramp = |m: &Move| m.ramp_mm_s;
        let least = surge(ramp(&ahead.moves[self.first]).max(ramp(&ahead.moves[last])));
        if self.gain >= least.min(self.enough) {
            return;
        }
        for (cap, m) in ahead.caps[self.first..=last].iter_mut().zip(&ahead.moves[self.first..]) {
            let v = m.ramp_mm_s;
            cap.v_entry = cap.v_entry.min(v);
            cap.v_peak = cap.v_peak.min(v);
            cap.v_exit = cap.v_exit.min(v);
        }
    }
}

/// Returns the gain of the squared speed that takes it from a ramp speed to [`SURGE`] times as much.
const fn surge(ramp: f64) -> f64 {
    (SURGE * SURGE - 1.0) * ramp * ramp
}
