//! The moves that a cut is made of, and the growing list of them.

use crate::CutError;
use crate::error::check_length;
use kerf_geom::{Arc2, Point2};
use kerf_program::MoveKind;
use serde::{Deserialize, Serialize};
use std::ops::Range;

/// One move, starting where the step before ended.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Step {
    /// A straight move.
    Line {
        /// Cut at move speed, or jog.
        kind: MoveKind,
        /// End of the line.
        to: [f64; 3],
    },
    /// A circular cut in the XY plane; Z changes in proportion to the angle.
    Arc {
        /// Centre of the circle.
        centre: [f64; 2],
        /// Swept angle in radians, positive counter-clockwise.
        sweep_rad: f64,
        /// End of the arc.
        to: [f64; 3],
        /// Number of chords that the circle resolution asks for.
        chords: u32,
        /// The circle is below the small circle size.
        small: bool,
    },
}

impl Step {
    /// Returns the end of the step.
    pub const fn to(&self) -> [f64; 3] {
        match self {
            Self::Line { to, .. } | Self::Arc { to, .. } => *to,
        }
    }

    /// Length of its path in space when it starts at `from`, mm.
    pub fn length(&self, from: [f64; 3]) -> f64 {
        let rise = self.to()[2] - from[2];
        self.flat(from).hypot(rise)
    }

    /// Length of its path seen from above, mm.
    fn flat(&self, from: [f64; 3]) -> f64 {
        let start = Point2::new(from[0], from[1]);
        match *self {
            Self::Line { to, .. } => start.distance(Point2::new(to[0], to[1])),
            Self::Arc { centre, sweep_rad, .. } => {
                let centre = Point2::new(centre[0], centre[1]);
                Arc2 { start, centre, sweep_rad }.length()
            }
        }
    }
}

/// All moves of one Cut command.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Cut {
    /// The moves in order.
    pub steps: Vec<Step>,
    /// The steps of the last pass, without plunge, return and pull-up: the ones that get tabs when
    /// the feature is [`crate::Feature::Tab`] or tabs are on for the file. `None` for pockets, which
    /// are not tabbed.
    pub last_pass: Option<Range<usize>>,
    /// Direction of travel at the end of the outline, clock degrees 0 … 360 (for MD).
    pub heading_deg: f64,
}

/// The tool on its way: the steps so far and where they have led.
pub(crate) struct Trail {
    /// Place of the tool.
    pub at: [f64; 3],
    /// The steps so far.
    pub steps: Vec<Step>,
}

impl Trail {
    pub fn new(at: [f64; 3]) -> Self {
        Self { at, steps: Vec::new() }
    }

    pub fn xy(&self) -> Point2 {
        Point2::new(self.at[0], self.at[1])
    }

    /// A straight move in X and Y only; none when the tool is there.
    pub fn line(&mut self, kind: MoveKind, to: Point2) {
        if self.xy() != to {
            self.push(Step::Line { kind, to: [to.x, to.y, self.at[2]] });
        }
    }

    /// A straight move in Z only; none when the tool is there.
    pub fn vertical(&mut self, kind: MoveKind, z: f64) {
        if self.at[2] != z {
            self.push(Step::Line { kind, to: [self.at[0], self.at[1], z] });
        }
    }

    pub fn push(&mut self, step: Step) {
        self.at = step.to();
        self.steps.push(step);
    }

    /// Refuses steps that lead out of the world.
    pub fn check(&self) -> Result<(), CutError> {
        let mut places = self.steps.iter().flat_map(|s| s.to());
        places.try_for_each(|v| check_length("location", v))
    }
}
