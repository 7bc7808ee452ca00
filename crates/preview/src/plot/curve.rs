//! A curve of any number of points in bounded memory.
//!
//! Points come in order of x. They are gathered in buckets of equal width, and of each bucket the
//! first, lowest, highest and last point are kept, which is all that a picture of that width can
//! show (U. Jugel et al., "M4: a visualization-oriented time series data aggregation", 2014). When
//! there are too many buckets, each pair becomes one.

/// Buckets at most; a page is about a thousand line widths wide.
const MOST: usize = 8192;
/// Width of a bucket at first.
const FINEST: f64 = 1e-6;

/// A point of a curve.
pub type Point = [f32; 2];

/// A curve y(x).
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    width: f64,
    buckets: Vec<Bucket>,
}

/// Points that are kept of those whose x have the same place on the grid of widths.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Bucket {
    place: u64,
    first: Point,
    low: Point,
    high: Point,
    last: Point,
}

impl Default for Curve {
    fn default() -> Self {
        Self { width: FINEST, buckets: Vec::new() }
    }
}

impl Curve {
    /// Adds a point; x is 0 or more and never falls. What is not finite is left out.
    pub fn push(&mut self, x: f64, y: f64) {
        if !(x.is_finite() && y.is_finite() && x >= 0.0) {
            return;
        }
        let place = (x / self.width) as u64;
        let point = [x as f32, y as f32];
        let new = Bucket { place, first: point, low: point, high: point, last: point };
        match self.buckets.last_mut() {
            Some(last) if last.place == place => last.take(&new),
            _ => self.buckets.push(new),
        }
        if self.buckets.len() > MOST {
            self.merge();
        }
    }

    /// The points, in order.
    pub fn points(&self) -> impl Iterator<Item = Point> {
        self.buckets.iter().flat_map(Bucket::points)
    }

    /// Lowest and highest y; `None` without points.
    pub fn range(&self) -> Option<[f64; 2]> {
        let low = self.buckets.iter().map(|b| b.low[1]).reduce(f32::min)?;
        let high = self.buckets.iter().map(|b| b.high[1]).reduce(f32::max)?;
        Some([f64::from(low), f64::from(high)])
    }

    fn merge(&mut self) {
        while self.buckets.len() > MOST / 2 {
            self.width *= 2.0;
            self.buckets.iter_mut().for_each(|b| b.place /= 2);
            self.buckets.dedup_by(|next, before| {
                let same = next.place == before.place;
                if same {
                    before.take(next);
                }
                same
            });
        }
    }
}

impl Bucket {
    fn take(&mut self, later: &Self) {
        if later.low[1] < self.low[1] {
            self.low = later.low;
        }
        if later.high[1] > self.high[1] {
            self.high = later.high;
        }
        self.last = later.last;
    }

    fn points(&self) -> impl Iterator<Item = Point> {
        let inner =
            if self.low[0] <= self.high[0] { [self.low, self.high] } else { [self.high, self.low] };
        let all = [self.first, inner[0], inner[1], self.last];
        (0..4).filter(move |k| *k == 0 || all[*k] != all[*k - 1]).map(move |k| all[k])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn few_points_are_all_kept() {
        let mut curve = Curve::default();
        for k in 0..100 {
            curve.push(f64::from(k), f64::from(k * k));
        }
        assert_eq!(curve.points().count(), 100);
        assert_eq!(curve.range(), Some([0.0, 9801.0]));
    }

    #[test]
    fn a_spike_stays_among_a_million_points() {
        let mut curve = Curve::default();
        for k in 0..1_000_000 {
            curve.push(f64::from(k) * 0.001, if k == 654_321 { 7.0 } else { 1.0 });
        }
        assert_eq!(curve.range(), Some([1.0, 7.0]));
        assert!(curve.points().count() <= 4 * MOST);
        let spike = curve.points().find(|p| p[1] == 7.0);
        assert_eq!(spike, Some([654.321, 7.0]));
    }

    #[test]
    fn what_is_no_number_is_left_out() {
        let mut curve = Curve::default();
        curve.push(0.0, f64::NAN);
        curve.push(f64::INFINITY, 0.0);
        assert_eq!((curve.points().count(), curve.range()), (0, None));
    }
}
