//! The place of a job: its stage, shape, pass and path.

use kerf_geom::{Point2, Polyarc};
use kerf_program::At;
use kerf_program::job::{Depths, Heights, Job, JobShape};
use std::sync::Arc;

/// Stage of a job.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Stage {
    /// Nothing has happened.
    #[default]
    Begin,
    /// A door, a jig or the second Start is waited for.
    Waiting,
    /// The head goes to the first shape, the router starts.
    Approach,
    /// Shapes are cut.
    Shapes,
    /// The head goes to the finish position.
    Finish,
}

/// Progress along a path.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) enum Along {
    /// Not at all.
    #[default]
    Before,
    /// Up to here.
    At(Spot),
    /// To its end.
    After,
    /// To its end, and the tool is clear of it.
    Clear,
}

/// A place on a path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Spot {
    /// The segment, counted from 0.
    pub segment: usize,
    /// Share of it that lies behind, 0 … 1.
    pub share: f64,
    /// The place itself, millimetres from the job's origin.
    pub at: Point2,
}

impl Spot {
    /// The beginning of a path.
    pub fn start_of(shape: &JobShape) -> Self {
        Self { segment: 0, share: 0.0, at: shape.start() }
    }

    /// The place of a path nearest to one, in a segment.
    pub fn near(path: &Polyarc, segment: usize, at: Point2) -> Self {
        let segment = segment.min(path.segment_count().saturating_sub(1));
        let share = path.segment(segment).nearest(at).share;
        Self { segment, share, at }
    }
}

/// Which path of a job is cut, and how far.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Here {
    /// Which repetition, counted from 0.
    pub repeat: u32,
    /// Which shape in cutting order, counted from 0.
    pub nth: usize,
    /// Which pass, counted from 0.
    pub pass: usize,
    /// Progress along the path.
    pub along: Along,
}

impl Here {
    /// The shape.
    pub fn shape<'a>(&self, job: &'a Job) -> Option<&'a JobShape> {
        job.shapes.get(self.nth)
    }

    /// The spot from which the path is left to make; nothing when it is made.
    pub fn spot(&self, shape: &JobShape) -> Option<Spot> {
        match self.along {
            Along::Before => Some(Spot::start_of(shape)),
            Along::At(spot) => Some(spot),
            Along::After | Along::Clear => None,
        }
    }
}

/// Returns the number of passes that a path takes.
pub(crate) fn passes(depths: &Depths) -> usize {
    match depths {
        Depths::Level(levels) => levels.len(),
        Depths::Along(_) => 1,
    }
}

/// The motion commands of the path at hand: which segment each of them makes.
#[derive(Clone, Debug, Default)]
pub(crate) struct Followed {
    /// Number of the first.
    pub first: u64,
    /// Segment of each.
    pub segments: Vec<u32>,
}

/// How far a job is done.
#[derive(Clone, Debug)]
pub(crate) struct Progress {
    pub stage: Stage,
    pub here: Here,
    /// Heights of the path at hand.
    pub depths: Depths,
    /// Motions of the path at hand.
    pub followed: Followed,
    /// Shapes begun behind the first.
    pub cut: u64,
    /// The group told last.
    pub group: Option<Arc<str>>,
}

impl Progress {
    /// Nothing has happened yet.
    pub fn new(job: &Job, heights: &Heights) -> Self {
        Self {
            stage: Stage::Begin,
            here: Here { nth: job.start.saturating_sub(1), ..Here::default() },
            depths: Depths::Along(heights.surface_mm),
            followed: Followed::default(),
            cut: 0,
            group: None,
        }
    }

    /// Returns the place of the job in its file: the number of the shape.
    pub fn at(&self, job: &Job) -> At {
        At { file: 0, line: self.here.shape(job).map_or(0, |shape| shape.number) }
    }

    /// The heights of the path at hand are those of now.
    pub fn refresh_depths(&mut self, job: &Job, heights: &Heights) {
        let shape = self.here.shape(job);
        let depths = shape.map(|shape| shape.depths(heights));
        if let Some(Ok(depths)) = depths {
            self.depths = depths;
        }
    }

    /// Height of the tool at a spot of the path at hand, machine frame.
    pub fn height_at(&self, shape: &JobShape, spot: &Spot, bottom_mm: f64) -> f64 {
        match &self.depths {
            Depths::Level(levels) => levels.get(self.here.pass).copied().unwrap_or(bottom_mm),
            Depths::Along(base) => {
                let (from, to) = (shape.height_mm(spot.segment), shape.height_mm(spot.segment + 1));
                base + from + (to - from) * spot.share
            }
        }
    }

    /// The path that follows; beyond the last shape when there is none.
    pub fn next(&self, job: &Job) -> Here {
        let Here { repeat, nth, pass, .. } = self.here;
        if pass + 1 < passes(&self.depths) {
            return Here { pass: pass + 1, along: Along::Before, ..self.here };
        }
        if nth + 1 >= job.shapes.len() && repeat + 1 < job.repeats.max(1) {
            return Here { repeat: repeat + 1, ..Here::default() };
        }
        Here { nth: nth + 1, pass: 0, along: Along::Before, repeat }
    }
}
