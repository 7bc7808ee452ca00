//! A job: shapes to cut, in order, told without a word about the drawing they come from or the
//! machine that cuts them.
//!
//! The drawing half of Kerf makes it, the machine half carries it out; this is all they share of a
//! tool path. Places are millimetres in the plane of the job, whose origin lies somewhere on the
//! table; heights are told as the machine's own three heights are set when the job runs.

mod depth;
mod in_force;
mod plunge;

pub use depth::{CutDepth, Depths, Heights, LowError};
pub use in_force::InForce;
pub use plunge::{Plunge, Slope, TooFlat, helix_circle};

use kerf_geom::{Point2, Polyarc, Vec2};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// One path of a job with all settings by which it is cut.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct JobShape {
    /// Number of the shape of the drawing it comes from, counted from 1: what a person knows it by.
    pub number: u32,
    /// The path, millimetres from the job's origin.
    pub path: Arc<Polyarc>,
    /// Height above ZSurface at each vertex, for [`CutDepth::ThreeD`]; fewer mean 0.
    pub z_mm: Arc<[f64]>,
    /// Depth of the cut.
    pub height: CutDepth,
    /// Depth of one pass, millimetres; all at once without it. Only with [`CutDepth::Mm`].
    pub pass_mm: Option<f64>,
    /// Way in which the tool goes down.
    pub plunge: Plunge,
    /// The tool control output, 1 … 3: on while the tool is down.
    pub tool: u8,
    /// The tool cut output, 1 … 3: on while material is cut.
    pub cut: u8,
    /// Highest cutting speed, mm/s; `None` is the machine's.
    pub speed_mm_s: Option<f64>,
    /// The machine halts before it.
    pub pause: bool,
    /// It is only followed, to lead the head round obstacles.
    pub traversal: bool,
    /// The name of its group, for people.
    pub group: Arc<str>,
}

/// Something that a person should know of a job before it is cut.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Note {
    /// Number of the shape.
    pub shape: u32,
    /// The change, and the reason for it.
    pub text: Arc<str>,
}

/// The shapes to cut, in order, and their place.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Job {
    /// The name shown to people.
    pub name: Arc<str>,
    /// The paths, in cutting order, arrays laid out.
    pub shapes: Arc<[JobShape]>,
    /// Place of the job's origin on the table, millimetres from home; nothing for that of the machine.
    pub origin: Option<Point2>,
    /// Place of the head at the end, millimetres from the origin; nothing for that of the machine.
    pub finish: Option<Point2>,
    /// The shape with which it begins, counted from 1.
    pub start: usize,
    /// Number of times that it is cut.
    pub repeats: u32,
    /// Changes made after the job was made: told when it begins.
    #[serde(default)]
    pub notes: Arc<[Note]>,
}

impl Default for Job {
    fn default() -> Self {
        Self {
            name: Arc::default(),
            shapes: Arc::default(),
            origin: None,
            finish: None,
            start: 1,
            repeats: 1,
            notes: Arc::default(),
        }
    }
}

impl JobShape {
    /// An open or closed path that is cut through, by tool 1.
    pub fn through(number: u32, path: Polyarc) -> Self {
        Self {
            number,
            path: Arc::new(path),
            z_mm: Arc::default(),
            height: CutDepth::Thru,
            pass_mm: None,
            plunge: Plunge::Straight,
            tool: 1,
            cut: 1,
            speed_mm_s: None,
            pause: false,
            traversal: false,
            group: "black".into(),
        }
    }

    /// Returns the place where it begins.
    pub fn start(&self) -> Point2 {
        self.path.start().unwrap_or_default()
    }

    /// Returns the place where it ends.
    pub fn end(&self) -> Point2 {
        if self.path.closed { self.start() } else { self.path.end().unwrap_or_default() }
    }

    /// The heights at which it is cut.
    ///
    /// # Errors
    /// A pass or a point lies below ZBottom.
    pub fn depths(&self, heights: &Heights) -> Result<Depths, LowError> {
        Depths::of(self.height, self.pass_mm, &self.z_mm, heights)
    }

    /// Height above ZSurface at the end of so many segments.
    pub fn height_mm(&self, segments: usize) -> f64 {
        let count = self.path.vertices.len().max(1);
        self.z_mm.get(segments % count).copied().unwrap_or_default()
    }
}

impl Job {
    /// Returns the place on the table of a place of the job.
    pub fn on_table(&self, place: Point2) -> Point2 {
        let origin = self.origin.unwrap_or_default();
        place + Vec2::new(origin.x, origin.y)
    }
}
