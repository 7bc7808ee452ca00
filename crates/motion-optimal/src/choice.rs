//! Which of two smoothings is run: bumps that stay on their own half of the segments are best on
//! even curves, where they add up to a curvature that does not change; bumps as wide as can be where
//! corners are close and uneven.
//!
//! It is decided for [`BLOCK`] vertices at a time, by the time they would take if the tool slowed no
//! more than their curvature asks for. Where the choice changes, the narrower width holds.

use crate::bounds::Bounds;
use crate::leg::Leg;
use crate::track::Track;
use crate::widths::{REACH, Smoothing, back};

/// Vertices for which is decided together.
const BLOCK: usize = 32;

/// The narrow bumps are taken up when they are faster by more than this share.
const BETTER: f64 = 0.018;

/// A bump that ends at a place, but for rounding, counts there.
const BESIDE: f64 = 1.0 + 1e-6;

/// The widths that are run: above zero half-widths of bumps, zero where the machine stands, below
/// zero where there is no turn and so no bump.
#[derive(Clone, Debug, Default)]
pub(crate) struct Choice {
    pub widths: Vec<f64>,
    /// For how many vertices the widths are final.
    pub done: usize,
    /// For how many vertices is decided.
    decided: usize,
    /// The narrow smoothing was chosen last.
    narrow: bool,
    before: f64,
    /// Samples of a block.
    samples: Vec<Sample>,
}

/// A place with the greatest squared speed there, and the way to the next.
#[derive(Clone, Copy, Debug)]
struct Sample {
    y: f64,
    way_mm: f64,
    /// Greatest change of the squared speed on that way.
    gain: f64,
}

impl Choice {
    /// Goes on; the widest bumps are final for so many vertices.
    pub fn advance<const N: usize>(
        &mut self,
        smoothing: &Smoothing<N>,
        track: &Track,
        legs: &[Leg],
        bounds: &Bounds<N>,
        wide: usize,
        ended: bool,
    ) {
        loop {
            let to = (self.decided + BLOCK).min(wide);
            // A sample looks at the bumps that reach it.
            let known = to + REACH < wide || ended;
            if !known || to == self.decided || (to < self.decided + BLOCK && !ended) {
                break;
            }
            self.decide(smoothing, track, legs, bounds, to);
        }
        back(&mut self.widths, &track.at_mm, self.done..self.decided);
        let done = if ended { self.decided } else { self.decided.saturating_sub(REACH) };
        for j in self.done..done.max(self.done) {
            if smoothing.is_straight(j) {
                self.widths[j] = -self.widths[j].max(f64::MIN_POSITIVE);
            }
        }
        self.done = done.max(self.done);
    }

    /// Forgets the first vertices.
    pub fn forget(&mut self, vertices: usize) {
        self.widths.drain(..vertices);
        self.done -= vertices;
        self.decided -= vertices;
    }

    fn decide<const N: usize>(
        &mut self,
        smoothing: &Smoothing<N>,
        track: &Track,
        legs: &[Leg],
        bounds: &Bounds<N>,
        to: usize,
    ) {
        let range = self.decided..to;
        let (narrow, wide) = (&smoothing.narrow, &smoothing.wide);
        let before = self.narrow;
        if narrow[range.clone()] != wide[range.clone()] {
            let mut time = |widths: &[f64]| {
                self.sample(smoothing, widths, track, legs, bounds, range.clone());
                self.time()
            };
            let times = [time(narrow), time(wide)];
            let better = if before { 1.0 } else { 1.0 + BETTER };
            self.narrow = times[0] * better < times[1];
        }
        let at = &track.at_mm;
        for j in range {
            let near = before != self.narrow && j < self.decided + REACH;
            let chosen = match (near, self.narrow) {
                (true, _) => narrow[j].min(wide[j]),
                (false, true) => narrow[j],
                (false, false) => wide[j],
            };
            let order = if j > 0 { self.before + (at[j] - at[j - 1]) } else { 0.0 };
            self.before = chosen.min(order);
            self.widths.push(self.before);
        }
        if before != self.narrow {
            for j in self.done..self.decided {
                self.widths[j] = self.widths[j].min(narrow[j]).min(wide[j]);
            }
        }
        self.decided = to;
    }

    /// Looks at the vertices and at the middles of the segments.
    fn sample<const N: usize>(
        &mut self,
        smoothing: &Smoothing<N>,
        widths: &[f64],
        track: &Track,
        legs: &[Leg],
        bounds: &Bounds<N>,
        range: std::ops::Range<usize>,
    ) {
        self.samples.clear();
        let at = &track.at_mm;
        for j in range.filter(|j| j + 1 < at.len()) {
            let half = 0.5 * (at[j + 1] - at[j]);
            let feed = legs[track.owner[j] as usize].speed_mm_s;
            let slope = &smoothing.directions[j];
            let load = (0..N).map(|k| slope[k].abs() * bounds.per_accel[k]).fold(0.0, f64::max);
            let gain = if load > 0.0 { 2.0 * half / load } else { 0.0 };
            for place in [at[j], at[j] + half] {
                let (slope, bend) = shape(smoothing, widths, at, j, place);
                let load = (0..N).map(|k| bend[k].abs() * bounds.per_accel[k]).fold(0.0, f64::max);
                let square: f64 = slope.iter().map(|p| p * p).sum();
                let y = if smoothing.stops(j) && place == at[j] {
                    0.0
                } else {
                    (feed * feed / square).min(1.0 / load)
                };
                self.samples.push(Sample { y, way_mm: half, gain });
            }
        }
    }

    /// Time over the samples, with ramps.
    fn time(&mut self) -> f64 {
        let samples = &mut self.samples;
        for i in 1..samples.len() {
            samples[i].y = samples[i].y.min(samples[i - 1].y + samples[i - 1].gain);
        }
        for i in (1..samples.len()).rev() {
            samples[i - 1].y = samples[i - 1].y.min(samples[i].y + samples[i - 1].gain);
        }
        let time = |pair: &[Sample]| 2.0 * pair[0].way_mm / (pair[0].y.sqrt() + pair[1].y.sqrt());
        samples.windows(2).map(time).filter(|t| t.is_finite()).sum()
    }
}

/// Slope and curvature at a place on the segment after a vertex.
fn shape<const N: usize>(
    smoothing: &Smoothing<N>,
    widths: &[f64],
    at: &[f64],
    vertex: usize,
    place: f64,
) -> ([f64; N], [f64; N]) {
    let (mut slope, mut bend) = (smoothing.directions[vertex], [0.0; N]);
    let mut add = |j: usize, left: f64| {
        let scale = 0.5 / widths[j];
        let turn = smoothing.turn_at(j);
        for k in 0..N {
            slope[k] += scale * left * turn[k];
            bend[k] += scale * turn[k];
        }
    };
    let mut j = vertex + 1;
    while j < widths.len() && at[j] - place <= widths[j] * BESIDE && widths[j] > 0.0 {
        add(j, widths[j] - (at[j] - place));
        j += 1;
    }
    let mut j = vertex + 1;
    while j > 0 && place - at[j - 1] < widths[j - 1] {
        j -= 1;
        add(j, (place - at[j]) - widths[j]);
    }
    (slope, bend)
}
