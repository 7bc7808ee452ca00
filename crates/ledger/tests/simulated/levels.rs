//! The heights at which shapes are cut, where a sheet is followed: whatever stops a job and wherever it dies,
//! the surface is where it was.

use crate::simulated::watch::Seen;
use kerf_trace::Event;
use std::collections::BTreeMap;

/// Tolerance of heights on a sheet that is followed, mm: they are as good as the sensor, and the head runs on.
const NEAR: f64 = 0.5;

/// The number under which ZTop goes: no shape has it.
const TOP: u32 = 0;

/// The lowest and the highest place of each shape, and of ZTop as it is told.
#[derive(Debug, Default)]
pub struct Levels(BTreeMap<u32, [f64; 2]>);

impl Levels {
    pub fn of(seen: &Seen) -> Self {
        let mut levels = Self::default();
        levels.add(seen);
        levels
    }

    /// Adds the levels of another process.
    pub fn add(&mut self, seen: &Seen) {
        for piece in &seen.pieces {
            [piece.from, piece.to].iter().for_each(|at| self.reaches(piece.line, at[2]));
        }
        for event in &seen.events {
            if let Event::Heights { top, .. } = event {
                self.reaches(TOP, *top);
            }
        }
    }

    fn reaches(&mut self, line: u32, z: f64) {
        let [low, high] = self.0.entry(line).or_insert([z, z]);
        (*low, *high) = (low.min(z), high.max(z));
    }

    /// A shape that was cut lower or higher than here.
    pub fn left_by(&self, other: &Self) -> Option<String> {
        other.0.iter().find_map(|(line, [low, high])| {
            let [lowest, highest] = self.0.get(line)?;
            let leaves = *low < lowest - NEAR || *high > highest + NEAR;
            let what = if *line == TOP { "ZTop".into() } else { format!("shape {line}") };
            leaves.then(|| format!("{what} at {low} to {high}, not {lowest} to {highest}"))
        })
    }
}
