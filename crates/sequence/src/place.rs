//! The place of a job: its stage, shape, pass and path.

use kerf_geom::{Point2, Polyarc};
use kerf_program::job::{Depths, Job, JobShape};

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
