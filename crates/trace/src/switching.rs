//! Which input and output switches when, beside the motion: lines for a diagram, collected from a run.
//!
//! ```text
//!  Session::run ──► Lines ──► Timing   drawn by kerf timing, told to pages by the server
//! ```

mod bounded_course;
mod zero;

use crate::event::Partial;
use crate::{Event, ExecutedMove, Sink};
use bounded_course::BoundedCourse;
use kerf_machine::lines::{Input, Output};
use kerf_model::Model;
use kerf_preview::timing::{Course, Timing, Track};
use kerf_program::settings::LINES;
use std::collections::BTreeMap;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use zero::Zero;

/// Between two looks at the plan, seconds.
const STEP_S: f64 = 0.005;
/// Looks at a move, at most: a longer one is looked at as often as ever while it speeds up and slows down,
/// and less often between.
const LOOKS: u32 = 1000;

/// A bit's name, and when it changed to what.
type Edges = (String, Vec<(f64, bool)>);

/// Course of a run, line by line.
#[derive(Debug)]
pub struct Lines {
    /// Locations of X, Y and Z, mm.
    motion: [BoundedCourse; 3],
    /// Zero that they count from; that of the machine's frame where nobody said.
    zero: Option<Zero>,
    /// By whether it is an input, and its number.
    switches: BTreeMap<(bool, u8), Edges>,
    intensity: BoundedCourse,
    frequency: BoundedCourse,
    end_s: f64,
    /// Edges of all switches that it keeps.
    most: usize,
    edges: usize,
    /// Nobody waits for them any more.
    given_up: Arc<AtomicBool>,
}

impl Default for Lines {
    /// Lines that keep everything.
    fn default() -> Self {
        Self::bounded(usize::MAX)
    }
}

impl Lines {
    /// Lines that keep at most so many points of each value, by grains where there are more, and so many
    /// edges of switches: behind those there is nothing any more.
    pub fn bounded(most: usize) -> Self {
        Self {
            motion: std::array::from_fn(|_| BoundedCourse::slopes(most)),
            switches: BTreeMap::new(),
            intensity: BoundedCourse::steps(most),
            frequency: BoundedCourse::steps(most),
            end_s: 0.0,
            most,
            edges: 0,
            zero: None,
            given_up: Arc::default(),
        }
    }

    /// The same lines, which look at nothing more as soon as they are given up.
    #[must_use]
    pub fn until(self, given_up: Arc<AtomicBool>) -> Self {
        Self { given_up, ..self }
    }

    /// The lines of a run that begins on a machine: what is on before is on from the beginning, and courses are
    /// working locations; those of a job are the machine's.
    #[must_use]
    pub fn beginning(mut self, machine: &Model) -> Self {
        self.zero = Some(Zero::new(machine.position(), machine.frame()));
        for n in 1..=LINES as u8 {
            if machine.outputs().is_on(n) {
                self.switch(false, n, Output::of_number(n).map(Output::name), 0.0, true);
            }
            if machine.input(n) {
                self.switch(true, n, Input::of_number(n).map(Input::name), 0.0, true);
            }
        }
        self
    }

    /// Returns `true` if it holds all of the run.
    pub const fn is_whole(&self) -> bool {
        self.edges <= self.most
    }

    /// The diagram; lines on which nothing happens are left out.
    pub fn timing(self, title: String) -> Timing {
        Timing { title, end_s: self.end_s, tracks: self.tracks() }
    }

    fn tracks(self) -> Vec<Track> {
        let places = ["x", "y", "z"].into_iter().zip(self.motion).map(|(name, kept)| {
            let (points, grain_s) = kept.finish();
            Track { name: name.into(), course: Course::Place(points), grain_s }
        });
        let values = [("intensity", self.intensity), ("pulses, Hz", self.frequency)];
        let values = values.into_iter().map(|(name, kept)| {
            let (points, grain_s) = kept.finish();
            Track { name: name.into(), course: Course::Value(points), grain_s }
        });
        let switches = self.switches.into_iter().map(|((input, _), (name, edges))| {
            let course = if input { Course::Input(edges) } else { Course::Output(edges) };
            Track { name, course, grain_s: 0.0 }
        });
        places.chain(values).filter(happens).chain(switches).collect()
    }

    /// Locations are set: the courses go on elsewhere.
    fn locate(&mut self, set: &Partial, t: f64) {
        let Some(zero) = &mut self.zero else { return };
        for (course, step) in self.motion.iter_mut().zip(zero.set(set)) {
            step.into_iter().flatten().for_each(|value| course.add((t, value)));
        }
    }

    fn use_units(&mut self, symbol: &str) {
        if let Some(zero) = &mut self.zero {
            zero.use_units(symbol);
        }
    }

    /// The tool is at a place of the machine's frame.
    fn goes(&mut self, t: f64, position: [f64; 3]) {
        let zero = self.zero.as_mut();
        let at = zero.map_or(position, |zero| zero.goes(position));
        self.motion.iter_mut().zip(at).for_each(|(course, value)| course.add((t, value)));
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

/// The moments at which a move is looked at, from its beginning to its end.
fn looks(from_s: f64, to_s: f64) -> impl Iterator<Item = f64> {
    let (wide_s, quarter) = (to_s - from_s, LOOKS / 4);
    let wanted = (wide_s / STEP_S).ceil().max(1.0);
    let few = wanted <= f64::from(LOOKS);
    let count = if few { wanted as u32 } else { LOOKS };
    let ends_s = f64::from(quarter) * STEP_S;
    let between_s = (wide_s - 2.0 * ends_s) / f64::from(LOOKS - 2 * quarter);
    (0..=count).map(move |n| match n {
        _ if few => from_s + wide_s * f64::from(n) / f64::from(count),
        n if n < quarter => from_s + f64::from(n) * STEP_S,
        n if n <= LOOKS - quarter => from_s + ends_s + f64::from(n - quarter) * between_s,
        n => to_s - f64::from(LOOKS - n) * STEP_S,
    })
}

/// Returns `true` if there is anything to see on a line.
fn happens(track: &Track) -> bool {
    match &track.course {
        Course::Place(points) => points.windows(2).any(|pair| pair[0].1 != pair[1].1),
        Course::Value(points) => !points.is_empty(),
        Course::Output(edges) | Course::Input(edges) => !edges.is_empty(),
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
            Event::Intensity { value, t, .. } => self.intensity.add((*t, f64::from(*value))),
            Event::LaserHz { hz, t } => self.frequency.add((*t, *hz)),
            Event::Start { units, .. } | Event::Units { units, .. } => self.use_units(units),
            Event::Location { set, t, .. } => self.locate(set, *t),
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

    fn made(&mut self, made: &ExecutedMove<'_>) {
        if !self.is_whole() || self.given_up.load(Ordering::Relaxed) {
            return;
        }
        for at_s in looks(made.span.t0_s, made.span.t1_s) {
            self.goes(made.t0_s + at_s, made.place(at_s).first3());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use kerf_program::OutputReason;

    #[test]
    fn a_long_move_is_looked_at_closely_at_its_ends_only() {
        let short: Vec<f64> = looks(1.0, 1.018).collect();
        assert_eq!(short, [1.0, 1.0045, 1.009, 1.0135, 1.018]);
        let long: Vec<f64> = looks(10.0, 3e7).collect();
        assert_eq!((long.len(), long[0], long[1000]), (1001, 10.0, 3e7));
        assert!(long.is_sorted() && long.windows(2).all(|pair| pair[0] < pair[1]));
        assert!((long[249] - 11.245).abs() < 1e-6 && (long[751] - (3e7 - 1.245)).abs() < 1e-6);
        assert_eq!(looks(2.0, 2.0).collect::<Vec<_>>(), [2.0, 2.0]);
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
        let [Track { name, course: Course::Output(edges), .. }] = &timing.tracks[..] else {
            panic!("{timing:?}")
        };
        assert_eq!((name.as_str(), edges.len(), timing.end_s), ("output 1", 10, 10.0));
    }
}
