//! A course in bounded room: as it is while there is room, later by grains of equal time.
//!
//! ```text
//!  as it is   ╱╲__╱╲____         every point that is on no line between its neighbours
//!  by grains  |f lg e|f lg e|    of each grain its first, least, greatest and last point
//! ```
//!
//! Grains are as long at the beginning as at the end. Where there are too many points they become twice as
//! long, and each takes what two of them had. So a course by grains is never outside of what the true one is
//! within the same grain.

/// Moments, seconds, and the value there.
pub(super) type Points = Vec<(f64, f64)>;

/// Distance from the line between its neighbours at which a point says nothing: in mm less than a step of any motor.
const STRAIGHT: f64 = 1e-6;
/// The shortest grain, seconds.
const FINEST_S: f64 = 0.005;
/// Two grains have room in any bound.
const FEWEST: usize = 8;

/// Course of a value between two points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Between {
    /// It changes evenly.
    Slope,
    /// It stays what it was at the first.
    Step,
}

/// A course that is collected point by point.
#[derive(Debug)]
pub(super) struct BoundedCourse {
    points: Points,
    between: Between,
    /// So many of them were looked through.
    settled: usize,
    /// Length of a grain, seconds; 0 while it is kept as it is.
    grain_s: f64,
    /// Points that it has at most.
    most: usize,
}

impl BoundedCourse {
    /// A value that changes evenly, in at most so many points; `usize::MAX` keeps everything.
    pub const fn slopes(most: usize) -> Self {
        Self { points: Points::new(), between: Between::Slope, settled: 0, grain_s: 0.0, most }
    }

    /// The same of a value that holds until it changes.
    pub fn steps(most: usize) -> Self {
        Self { between: Between::Step, ..Self::slopes(most) }
    }

    /// Goes on to a point.
    pub fn add(&mut self, point: (f64, f64)) {
        self.points.push(point);
        // Seldom enough that it costs little.
        if self.points.len() > self.most.max(FEWEST).saturating_mul(2) {
            self.shorten();
        }
    }

    /// Its points, and how long a grain is, seconds.
    pub fn finish(mut self) -> (Points, f64) {
        if self.most < usize::MAX {
            self.shorten();
        }
        (self.points, self.grain_s)
    }

    /// Leaves out what lies on lines, then what lies within grains, until there are few enough.
    fn shorten(&mut self) {
        let fresh = self.points.split_off(self.settled.saturating_sub(1));
        self.points.extend(match self.between {
            Between::Slope => straightened(&fresh),
            Between::Step => changes(fresh),
        });
        if self.grain_s > 0.0 {
            self.points = by_grains(&self.points, self.grain_s);
        }
        while self.points.len() > self.most.max(FEWEST) {
            self.grain_s = (2.0 * self.grain_s).max(FINEST_S);
            self.points = by_grains(&self.points, self.grain_s);
        }
        self.settled = self.points.len();
    }
}

/// Of each grain the first, the least, the greatest and the last point, in order.
fn by_grains(points: &[(f64, f64)], grain_s: f64) -> Points {
    let number = |point: &(f64, f64)| (point.0 / grain_s).floor() as i64;
    points.chunk_by(|a, b| number(a) == number(b)).flat_map(corners).collect()
}

fn corners(grain: &[(f64, f64)]) -> Points {
    let by_value = |a: &usize, b: &usize| grain[*a].1.total_cmp(&grain[*b].1);
    let (least, greatest) = ((0..grain.len()).min_by(by_value), (0..grain.len()).max_by(by_value));
    let ends = [Some(0), least, greatest, grain.len().checked_sub(1)];
    let mut kept: Vec<usize> = ends.into_iter().flatten().collect();
    kept.sort_unstable();
    kept.dedup();
    kept.into_iter().map(|n| grain[n]).collect()
}

/// The same steps without those that change nothing.
fn changes(mut steps: Points) -> Points {
    steps.dedup_by(|later, first| later.1 == first.1);
    steps
}

/// The same course without points on the line between the one that is kept before and the next.
fn straightened(points: &[(f64, f64)]) -> Points {
    let mut kept = Points::new();
    // Lines from the last point that is kept have to lie between these slopes to pass by all since.
    let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
    for (n, point) in points.iter().enumerate() {
        let Some(from) = kept.last().copied() else {
            kept.push(*point);
            continue;
        };
        let slopes = slopes(from, *point);
        (low, high) = (low.max(slopes.0), high.min(slopes.1));
        let Some(next) = points.get(n + 1) else {
            kept.push(*point);
            continue;
        };
        let to_next = (next.1 - from.1) / (next.0 - from.0);
        if !(low <= to_next && to_next <= high) {
            kept.push(*point);
            (low, high) = (f64::NEG_INFINITY, f64::INFINITY);
        }
    }
    kept
}

/// Slopes of the lines that pass near enough by a point; none where it is at the same moment.
fn slopes(from: (f64, f64), to: (f64, f64)) -> (f64, f64) {
    let (wide_s, high) = (to.0 - from.0, to.1 - from.1);
    if wide_s > 0.0 {
        return ((high - STRAIGHT) / wide_s, (high + STRAIGHT) / wide_s);
    }
    if high.abs() <= STRAIGHT {
        return (f64::NEG_INFINITY, f64::INFINITY);
    }
    (f64::INFINITY, f64::NEG_INFINITY)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(points: &[(f64, f64)], expected: &[(f64, f64)]) {
        assert_eq!(straightened(points), expected);
    }

    /// A course of teeth half a second long, on a slope, looked at every 5 ms.
    fn teeth(seconds: u32) -> Points {
        let at = |n: u32| {
            let tooth = f64::from(n % 100) - 50.0;
            (f64::from(n) * 0.005, tooth.abs() / 10.0 + f64::from(n) * 1e-5)
        };
        (0..=seconds * 200).map(at).collect()
    }

    fn kept(points: &[(f64, f64)], most: usize) -> (Points, f64) {
        let mut kept = BoundedCourse::slopes(most);
        points.iter().for_each(|point| kept.add(*point));
        kept.finish()
    }

    #[test]
    fn what_lies_on_a_line_is_left_out() {
        check(&[], &[]);
        check(&[(0.0, 1.0)], &[(0.0, 1.0)]);
        check(&[(0.0, 0.0), (1.0, 1.0), (2.0, 2.0)], &[(0.0, 0.0), (2.0, 2.0)]);
        let ramp = [(0.0, 0.0), (1.0, 5.0), (1.0, 5.0), (2.0, 5.0), (3.0, 5.0), (4.0, 0.0)];
        check(&ramp, &[(0.0, 0.0), (1.0, 5.0), (3.0, 5.0), (4.0, 0.0)]);
        let steps = [(0.0, 0.0), (1.0, 0.0), (1.0, 7.0), (2.0, 7.0), (2.0, 0.0)];
        check(&steps, &steps);
    }

    #[test]
    fn a_course_that_has_room_is_kept_as_it_is() {
        let (points, grain_s) = kept(&teeth(100), 1000);
        assert!((401..420).contains(&points.len()) && grain_s == 0.0, "{} {grain_s}", points.len());
    }

    #[test]
    fn a_long_even_course_is_as_fine_at_its_beginning_as_at_its_end() {
        let (points, _) = kept(&teeth(2000), 1000);
        let mut tenths = [0; 10];
        points.iter().for_each(|(t, _)| tenths[((t / 200.0) as usize).min(9)] += 1);
        let (least, most) = (tenths.iter().min().copied(), tenths.iter().max().copied());
        assert!(least > Some(45) && most < Some(110), "{tenths:?}");
        assert!(most < least.map(|n| n + n / 4), "{tenths:?}");
    }

    #[test]
    fn a_course_by_grains_stays_within_what_is_true_in_each() {
        let course = teeth(2000);
        let (points, grain_s) = kept(&course, 1000);
        assert!((2.0..16.0).contains(&grain_s), "{grain_s}");
        let number = |t: f64| (t / grain_s).floor() as i64;
        let range = |points: &[(f64, f64)]| {
            let values = points.iter().map(|(_, value)| *value);
            values.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(v), b.max(v)))
        };
        let ranges = |points: &[(f64, f64)]| -> Vec<(i64, (f64, f64))> {
            let grains = points.chunk_by(|a, b| number(a.0) == number(b.0));
            grains.map(|grain| (number(grain[0].0), range(grain))).collect()
        };
        let (true_ones, drawn) = (ranges(&course), ranges(&points));
        assert_eq!(true_ones.len(), drawn.len());
        for ((n, (low, high)), (m, (least, greatest))) in true_ones.into_iter().zip(drawn) {
            assert_eq!(n, m);
            assert!((low - least).abs() < 0.1 && (high - greatest).abs() < 0.1, "grain {n}");
            assert!(low <= least && greatest <= high, "grain {n}");
        }
    }

    #[test]
    fn a_course_that_is_too_long_keeps_its_ends_and_its_peaks() {
        let value = |n: i32| if n == 7_001 { 99.0 } else { f64::from(n % 3) };
        let course: Points = (0..10_000).map(|n| (f64::from(n), value(n))).collect();
        let (points, _) = kept(&course, 500);
        assert!((250..=500).contains(&points.len()), "{}", points.len());
        assert_eq!((points.first(), points.last()), (Some(&(0.0, 0.0)), Some(&(9999.0, 0.0))));
        assert!(points.contains(&(7001.0, 99.0)));
        assert!(points.is_sorted_by_key(|(t, _)| *t));
    }

    #[test]
    fn steps_that_are_too_many_never_have_a_value_that_there_was_not() {
        let mut beam = BoundedCourse::steps(500);
        for n in 0..40_000 {
            beam.add((f64::from(n) * 0.01, if n % 2 == 0 { 64.0 } else { 0.0 }));
        }
        // It ends off, and stays off.
        let (points, grain_s) = beam.finish();
        assert!((100..=500).contains(&points.len()) && grain_s > 0.5, "{} {grain_s}", points.len());
        assert!(points.iter().all(|(_, value)| *value == 64.0 || *value == 0.0), "{points:?}");
        assert_eq!(points.last(), Some(&(399.99, 0.0)));
        let number = |t: f64| (t / grain_s).floor() as i64;
        for grain in points.chunk_by(|a, b| number(a.0) == number(b.0)) {
            assert!(grain.iter().any(|point| point.1 == 0.0), "{grain:?}");
            assert!(grain.iter().any(|point| point.1 == 64.0), "{grain:?}");
        }
    }

    #[test]
    fn steps_that_have_room_are_kept_without_those_that_change_nothing() {
        let mut beam = BoundedCourse::steps(500);
        [(0.0, 7.0), (1.0, 7.0), (2.0, 0.0)].into_iter().for_each(|step| beam.add(step));
        assert_eq!(beam.finish(), (vec![(0.0, 7.0), (2.0, 0.0)], 0.0));
    }

    #[test]
    fn a_course_at_no_time_at_all_has_an_end() {
        let (points, _) = kept(&[(f64::NAN, 1.0); 100], 10);
        assert!(points.len() <= 10);
    }
}
