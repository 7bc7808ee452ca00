//! Problem of the search under a limit of jerk: the limits, the pieces, and where the search starts.

use crate::condition::{Quad, dots, quad};
use crate::launch::{End, Launch};
use crate::pieces::{Part, Piece};

/// By how much all is slowed in each step in which no motion within the limits was found in time.
const SLOWER: f64 = 0.8;

/// After a motion that is given the search starts at least at this share of what is expected.
const SLOW: f64 = 0.4;

/// From a motion that is given on, slowing comes into its full within this share of the way.
const SLOWED: f64 = 0.2;

/// Start of the search, as a share of what is expected.
const BEGIN: f64 = 0.6;

/// Limits, pieces and the unknowns.
pub(crate) struct Problem<'a, const N: usize> {
    pub pieces: &'a [Piece<N>],
    pub accel: [f64; N],
    pub jerk: [f64; N],
    pub begin: End,
    pub end: Launch,
    /// Squared speeds of a motion from the same beginning within the limits, in the middle of the
    /// pieces as far as it goes; for the first pieces, so many, it has the same.
    pub before: &'a [f64],
    pub kept: usize,
    /// Cost that the barriers may have at the end, as a share of the time.
    pub gap: f64,
}

impl<const N: usize> Problem<'_, N> {
    /// By how much each piece is slowed in a step: not at all where the motion is given.
    pub fn slower(&self) -> Vec<f64> {
        let begin = self.pieces.get(self.kept).map_or(0.0, |p| p.at_mm);
        let end = self.pieces.last().map_or(0.0, |p| p.at_mm);
        let full = SLOWED * (end - begin).max(f64::MIN_POSITIVE);
        let share = |p: &Piece<N>| match self.begin {
            End::Rest(_) => 1.0,
            End::Motion(_) => ((p.at_mm - begin) / full).clamp(0.0, 1.0),
        };
        self.pieces.iter().map(|p| 1.0 - (1.0 - SLOWER) * share(p)).collect()
    }

    /// Returns the start of the search: about what the jerk allows. From a slow place x^(3/4) can grow as
    /// the distance does; so it is kept from changing faster, at a good part of that rate.
    pub fn start(&self) -> Vec<f64> {
        let jerk = self.jerk.iter().copied().fold(f64::INFINITY, f64::min);
        let rate = BEGIN * (4.5 * jerk).sqrt();
        let mut z: Vec<f64> =
            self.pieces.iter().map(|p| BEGIN * self.steady(p).powf(0.75)).collect();
        let n = z.len();
        let half = |k: usize| 0.5 * self.pieces[k].h;
        let mut last = match self.begin {
            End::Rest(launch) => rate * launch.way_mm,
            End::Motion([x, _]) => x.powf(0.75),
        };
        for (k, z) in z.iter_mut().enumerate() {
            last += rate * (half(k) + if k > 0 { half(k - 1) } else { 0.0 });
            last = last.min(*z);
            *z = last;
        }
        last = rate * self.end.way_mm;
        for (k, z) in z.iter_mut().enumerate().rev() {
            last += rate * (half(k) + if k + 1 < n { half(k + 1) } else { 0.0 });
            last = last.min(*z);
            *z = last;
        }
        let mut x: Vec<f64> = z.iter().map(|z| z.powf(4.0 / 3.0)).collect();
        for _ in 0..4 {
            let before = x.clone();
            for k in 1..n.saturating_sub(1) {
                x[k] = 0.25 * (before[k - 1] + 2.0 * before[k] + before[k + 1]);
            }
        }
        self.begin_with(&mut x);
        x
    }

    /// Begins with the motion before, as long as it is not slow, and goes over to what is expected; at
    /// the end as slow as it takes to stand there.
    fn begin_with(&self, x: &mut [f64]) {
        let End::Motion([at, accel]) = self.begin else { return };
        for (k, x) in x.iter_mut().enumerate() {
            let before = self.before.get(k).copied().unwrap_or(0.0);
            let least = SLOW * *x;
            let near = (1.0 - before / (3.0 * least)).max(0.0);
            *x = before + if k < self.kept { 0.0 } else { least * near * near };
        }
        let moves =
            |axis: &usize| self.pieces.iter().any(|p| p.parts.iter().any(|p| p.moves[*axis]));
        let least = |limits: &[f64; N]| {
            (0..N).filter(moves).map(|axis| limits[axis]).fold(f64::INFINITY, f64::min)
        };
        let (rate, gain) = ((4.5 * least(&self.jerk)).sqrt(), 2.0 * least(&self.accel));
        let mut left = self.end.way_mm;
        for (piece, x) in self.pieces.iter().zip(x.iter_mut()).skip(self.kept).rev() {
            left += piece.h;
            let most = (BEGIN * rate * left).powf(4.0 / 3.0);
            *x = x.min(most).min(BEGIN * gain * left);
        }
        x[0] = at + accel * self.pieces[0].h;
    }

    /// The squared speed that a piece allows without s̈.
    fn steady(&self, piece: &Piece<N>) -> f64 {
        let mut x = piece.cap.min(piece.guess);
        let mut steepest = 0.0f64;
        for (_, gain) in piece.parts.iter().flat_map(Part::axes) {
            let each = dots(gain, &[1.0; 3]);
            steepest = each.iter().fold(steepest, |most, gain| most.max(gain.abs()));
        }
        if steepest > 0.0 {
            x = x.min(steepest.powf(-2.0 / 3.0));
        }
        x
    }

    /// Returns the shares of the neighbours' middle ordinates in the outer ordinates of a piece.
    pub fn shares(&self, k: usize) -> [[f64; 2]; 2] {
        let h = |i: usize| self.pieces[i].h;
        let mean = |i: usize| {
            let whole = h(i - 1) + h(i);
            [h(i) / whole, h(i - 1) / whole]
        };
        let left = match self.begin {
            _ if k > 0 => mean(k),
            End::Rest(launch) => [0.0, launch.share(h(0))],
            End::Motion(_) => [0.0, 0.0],
        };
        let last = k + 1 == self.pieces.len();
        let right = if last { [self.end.share(h(k)), 0.0] } else { mean(k + 1) };
        [left, right]
    }

    /// Conditions on the speed in a piece, between zero and the cap: as shares of half of it.
    pub fn cap(&self, k: usize) -> Quad {
        let mut caps = [self.pieces[k].cap; 3];
        if let (0, End::Rest(launch)) = (k, &self.begin) {
            caps[0] = caps[0].min(launch.most);
        }
        if k + 1 == self.pieces.len() {
            caps[2] = caps[2].min(self.end.most);
        }
        // What the motion at the beginning has settled nothing can change.
        let free = if k == 0 && matches!(self.begin, End::Motion(_)) { 2 } else { 0 };
        quad(|m| if (free..3).contains(&m) { 2.0 / caps[m] } else { 0.0 })
    }
}
