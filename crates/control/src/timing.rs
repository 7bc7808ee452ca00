//! Which input and output switches when, beside the motion: lines for a diagram, collected from a run.
//!
//! ```text
//!  Session::run ──► Lines ──► Timing   drawn by kerf timing, told to pages by the server
//! ```

use crate::{Event, Made, Sink};
use kerf_program::Axis;
use std::collections::BTreeMap;

pub use kerf_preview::timing::{Course, Timing, Track};

/// Between two looks at the plan, seconds.
const STEP_S: f64 = 0.005;
/// What lies this near to the line between its neighbours says nothing: in mm less than a step of any motor.
const STRAIGHT: f64 = 1e-6;

/// Moments, seconds, and the value there.
type Points = Vec<(f64, f64)>;
/// A bit's name, and when it changed to what.
type Edges = (String, Vec<(f64, bool)>);

/// What a run did, line by line.
#[derive(Debug)]
pub struct Lines {
    /// Positions of X, Y and Z, machine frame, mm.
    motion: [Points; 3],
    /// By whether it is an input, and its number.
    switches: BTreeMap<(bool, u8), Edges>,
    intensity: Points,
    frequency: Points,
    end_s: f64,
    /// Points of a value, and edges of all switches, that it keeps.
    most: usize,
    edges: usize,
}

impl Default for Lines {
    /// Lines that keep everything.
    fn default() -> Self {
        Self::bounded(usize::MAX)
    }
}

impl Lines {
    /// Lines that keep at most so many points of each value, its peaks among them, and so many edges of
    /// switches: behind those there is nothing any more.
    pub fn bounded(most: usize) -> Self {
        Self {
            motion: Default::default(),
            switches: BTreeMap::new(),
            intensity: Points::new(),
            frequency: Points::new(),
            end_s: 0.0,
            most,
            edges: 0,
        }
    }

    /// Whether it holds all of the run.
    pub const fn is_whole(&self) -> bool {
        self.edges <= self.most
    }

    /// The diagram; lines on which nothing happens are left out.
    pub fn timing(mut self, title: String) -> Timing {
        if self.most < usize::MAX {
            self.values().for_each(|(points, most)| shorten(points, most));
        }
        Timing { title, end_s: self.end_s, tracks: self.tracks() }
    }

    fn tracks(self) -> Vec<Track> {
        let moves = |points: &Points| points.windows(2).any(|pair| pair[0].1 != pair[1].1);
        let places = ["x", "y", "z"].into_iter().zip(self.motion);
        let places = places.filter(|(_, points)| moves(points));
        let values = [("intensity", self.intensity), ("pulses, Hz", self.frequency)];
        let values = values.into_iter().filter(|(_, points)| !points.is_empty());
        let track = |name: &str, course| Track { name: name.into(), course };
        let switches = self.switches.into_iter().map(|((input, _), (name, edges))| {
            let course = if input { Course::Input(edges) } else { Course::Output(edges) };
            Track { name, course }
        });
        places
            .map(|(name, points)| track(name, Course::Place(points)))
            .chain(values.map(|(name, points)| track(name, Course::Value(points))))
            .chain(switches)
            .collect()
    }

    /// Every value, and how many points it may have.
    fn values(&mut self) -> impl Iterator<Item = (&mut Points, usize)> {
        let others = [&mut self.intensity, &mut self.frequency];
        let most = self.most;
        self.motion.iter_mut().chain(others).map(move |points| (points, most))
    }

    fn switch(&mut self, input: bool, n: u8, name: Option<&str>, t: f64, on: bool) {
        self.edges += 1;
        if !self.is_whole() {
            return;
        }
        let kind = if input { "input" } else { "output" };
        let named = name.map_or_else(|| format!("{kind} {n}"), |name| name.to_owned());
        let entry = self.switches.entry((input, n)).or_insert((named, Vec::new()));
        entry.1.push((t, on));
    }
}

impl Sink for Lines {
    fn event(&mut self, event: &Event) {
        if !self.is_whole() {
            return;
        }
        match event {
            Event::Output { n, on, t, name, .. } => self.switch(false, *n, *name, *t, *on),
            Event::Input { n, on, t, name } => self.switch(true, *n, *name, *t, *on),
            Event::Intensity { value, t, .. } => {
                step(&mut self.intensity, *t, f64::from(*value), self.most);
            }
            Event::LaserHz { hz, t } => step(&mut self.frequency, *t, *hz, self.most),
            Event::End(end) => self.end_s = end.t,
            _ => {}
        }
        // Where it is full, it ends.
        if let (false, Event::Output { t, .. } | Event::Input { t, .. }) = (self.is_whole(), event)
        {
            self.end_s = *t;
        }
    }

    fn looks_at_motion(&self) -> bool {
        false
    }

    fn made(&mut self, made: &Made<'_>) {
        if !self.is_whole() {
            return;
        }
        let (from_s, to_s) = (made.span.t0_s, made.span.t1_s);
        let looks = ((to_s - from_s) / STEP_S).ceil().max(1.0) as u32;
        for look in 0..=looks {
            let at_s = from_s + (to_s - from_s) * f64::from(look) / f64::from(looks);
            let position = made.plan.at(at_s).position;
            for (course, axis) in self.motion.iter_mut().zip([Axis::X, Axis::Y, Axis::Z]) {
                add(course, (made.t0_s + at_s, position[axis]), self.most);
            }
        }
    }
}

/// A value holds until it changes.
fn step(points: &mut Points, t: f64, value: f64, most: usize) {
    let before = points.last().map_or(0.0, |(_, value)| *value);
    add(points, (t, before), most);
    add(points, (t, value), most);
}

fn add(points: &mut Points, point: (f64, f64), most: usize) {
    points.push(point);
    // Seldom enough that it costs little.
    if points.len() > most.saturating_mul(2) {
        shorten(points, most);
    }
}

/// Leaves out what lies on lines, then what lies between peaks, until there are few enough.
fn shorten(points: &mut Points, most: usize) {
    *points = straightened(points);
    while points.len() > most.max(8) {
        *points = peaks(points);
    }
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

/// Of four points the least and the greatest; the first and the last of all stay.
fn peaks(points: &[(f64, f64)]) -> Points {
    let [first, between @ .., last] = points else { return points.to_vec() };
    let mut kept = vec![*first];
    for four in between.chunks(4) {
        let by_value = |a: &&(f64, f64), b: &&(f64, f64)| a.1.total_cmp(&b.1);
        let (low, high) = (four.iter().min_by(by_value), four.iter().max_by(by_value));
        let mut two: Points = low.into_iter().chain(high).copied().collect();
        two.sort_by(|a, b| a.0.total_cmp(&b.0));
        two.dedup();
        kept.extend(two);
    }
    kept.push(*last);
    kept
}

#[cfg(test)]
mod tests {
    use super::*;
    use kerf_program::OutputReason;

    fn check(points: &[(f64, f64)], expected: &[(f64, f64)]) {
        assert_eq!(straightened(points), expected);
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
    fn a_course_that_is_too_long_keeps_its_ends_and_its_peaks() {
        let mut points = Points::new();
        for n in 0..10_000 {
            let value = if n == 7_001 { 99.0 } else { f64::from(n % 3) };
            add(&mut points, (f64::from(n), value), 500);
        }
        shorten(&mut points, 500);
        assert!((250..=500).contains(&points.len()), "{}", points.len());
        assert_eq!((points.first(), points.last()), (Some(&(0.0, 0.0)), Some(&(9999.0, 0.0))));
        assert!(points.contains(&(7001.0, 99.0)));
        assert!(points.is_sorted_by_key(|(t, _)| *t));
    }

    #[test]
    fn where_there_are_too_many_edges_it_ends() {
        let mut lines = Lines::bounded(10);
        for n in 0..20 {
            let (on, t) = (n % 2 == 0, f64::from(n));
            lines.event(&Event::Output { n: 1, on, t, why: OutputReason::Program, name: None });
        }
        assert!(!lines.is_whole());
        let timing = lines.timing(String::new());
        let [Track { name, course: Course::Output(edges) }] = &timing.tracks[..] else {
            panic!("{timing:?}")
        };
        assert_eq!((name.as_str(), edges.len(), timing.end_s), ("output 1", 10, 10.0));
    }
}
