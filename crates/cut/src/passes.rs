//! The order of actions that all Cut commands share: plunges, passes, ways back, pull-up.
//!
//! ```text
//! plain, tab   Z0?  ( plunge  path  way back? )×n          pull up?
//! pocket       Z0?  ( plunge  rings  way back )×n          down or pull up
//! spiral       Z0?  ( path, falling  way back? )×n  path?  pull up?
//! ```
//!
//! The way back goes up to Safe-Z and jogs to the beginning of the path; it is needed when the path
//! is open or is a pocket (command reference, CC; readings, A-73 … A-79).

use crate::error::{MAX_STEPS, check_length};
use crate::step::{Cut, Trail};
use crate::{Context, CutError};
use kerf_geom::Point2;
use kerf_program::MoveKind::{Cut as Cutting, Jog};
use std::ops::Range;

/// Work done beside following the path.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Feature {
    /// 0: nothing.
    #[default]
    Plain,
    /// 1: tabs on the last pass; the caller sends that through [`crate::Tabber`].
    Tab,
    /// 2: the inside is cleared.
    Pocket,
    /// 3: the plunge is spread over the path.
    Spiral,
    /// 4: the same, and a flat pass at the end.
    SpiralBottom,
}

impl Feature {
    /// The feature of the user's number, 0 … 4.
    pub const fn from_number(number: u8) -> Option<Self> {
        Some(match number {
            0 => Self::Plain,
            1 => Self::Tab,
            2 => Self::Pocket,
            3 => Self::Spiral,
            4 => Self::SpiralBottom,
            _ => return None,
        })
    }
}

/// Number and depth of the passes along a path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Passes {
    /// Change of Z for each repetition as the user wrote it, mm; negative goes down.
    pub plunge_mm: f64,
    /// Number of passes.
    pub repetitions: u32,
    /// Work done beside following the path.
    pub feature: Feature,
    /// Stay at the depth of the last pass.
    pub no_pull_up: bool,
    /// Move Z to [`Context::zero_z`] first and plunge from there.
    pub from_zero: bool,
}

impl Default for Passes {
    /// One pass at the present Z.
    fn default() -> Self {
        Self {
            plunge_mm: 0.0,
            repetitions: 1,
            feature: Feature::Plain,
            no_pull_up: false,
            from_zero: false,
        }
    }
}

/// A path that can be cut again and again.
pub(crate) trait Outline {
    /// Returns the beginning of the path.
    fn begin(&self) -> Point2;
    /// Returns `true` if the path ends where it begins.
    fn is_closed(&self) -> bool;
    /// Steps of one pass, or of one level of the pocket; about, and never too few.
    fn step_count(&self, pocket: bool) -> f64;
    /// Follows the path from its beginning; Z goes evenly from the first to the second value.
    fn follow(&self, z: [f64; 2], trail: &mut Trail);
    /// Clears the inside at the present Z, from the beginning of the path.
    fn clear(&self, trail: &mut Trail);
    /// Clock direction of travel at the end.
    fn heading_deg(&self) -> f64;
}

/// All moves of a command that cuts this outline.
///
/// A tool that is not at the beginning goes there first, straight and at its present Z.
pub(crate) fn cut(
    outline: &impl Outline,
    passes: &Passes,
    context: &Context,
) -> Result<Cut, CutError> {
    check(outline, passes, context)?;
    let mut job =
        OutlineCut { outline, passes, context, trail: Trail::new(context.start), last_pass: 0..0 };
    job.run();
    job.trail.check()?;
    Ok(Cut {
        steps: job.trail.steps,
        last_pass: (!job.last_pass.is_empty()).then_some(job.last_pass),
        heading_deg: outline.heading_deg(),
    })
}

fn check(outline: &impl Outline, passes: &Passes, context: &Context) -> Result<(), CutError> {
    let pocket = passes.feature == Feature::Pocket;
    if passes.repetitions < 1 {
        return Err(CutError::Repetitions);
    }
    check_length("plunge", passes.plunge_mm)?;
    check_length(
        "depth of all plunges",
        context.plunge_mm(passes.plunge_mm) * f64::from(passes.repetitions),
    )?;
    if pocket && !outline.is_closed() {
        return Err(CutError::PocketNeedsFullCircle);
    }
    if pocket && !(0.0..100.0).contains(&context.overlap_percent) {
        return Err(CutError::Overlap);
    }
    if pocket && context.cutter_mm == 0.0 {
        return Err(CutError::PocketNeedsCutter);
    }
    // Way back, plunge and bottom pass.
    let all = (outline.step_count(pocket) + 4.0) * (f64::from(passes.repetitions) + 1.0);
    if all < MAX_STEPS as f64 { Ok(()) } else { Err(CutError::TooManySteps) }
}

struct OutlineCut<'a, O> {
    outline: &'a O,
    passes: &'a Passes,
    context: &'a Context,
    trail: Trail,
    last_pass: Range<usize>,
}

impl<O: Outline> OutlineCut<'_, O> {
    fn run(&mut self) {
        self.trail.line(Cutting, self.outline.begin());
        if self.passes.from_zero {
            self.trail.vertical(Cutting, self.context.zero_z);
        }
        let top = self.trail.at[2];
        let plunge = self.context.plunge_mm(self.passes.plunge_mm);
        let depth = |n: u32| top + plunge * f64::from(n);
        let levels = (1..=self.passes.repetitions).map(depth);
        let turns = (1..=self.passes.repetitions).map(|n| [depth(n - 1), depth(n)]);
        let bottom = depth(self.passes.repetitions);
        match self.passes.feature {
            Feature::Plain | Feature::Tab => levels.for_each(|z| self.pass([z, z])),
            Feature::Pocket => levels.for_each(|z| self.level(z)),
            Feature::Spiral => turns.for_each(|z| self.pass(z)),
            Feature::SpiralBottom => {
                turns.for_each(|z| self.pass(z));
                self.pass([bottom, bottom]);
            }
        }
        let lifts = !self.passes.no_pull_up && (plunge != 0.0 || self.passes.from_zero);
        self.trail.vertical(Cutting, if lifts { self.context.start[2] } else { bottom });
    }

    fn pass(&mut self, z: [f64; 2]) {
        self.enter(z[0]);
        let first = self.trail.steps.len();
        self.outline.follow(z, &mut self.trail);
        self.last_pass = first..self.trail.steps.len();
    }

    fn level(&mut self, z: f64) {
        self.enter(z);
        self.outline.clear(&mut self.trail);
        self.way_back();
    }

    /// Goes to the beginning of the path at this Z.
    fn enter(&mut self, z: f64) {
        if self.trail.xy() != self.outline.begin() {
            self.way_back();
        }
        self.trail.vertical(Cutting, z);
    }

    fn way_back(&mut self) {
        let z = self.trail.at[2].max(self.context.travel_z());
        self.trail.vertical(Jog, z);
        self.trail.line(Jog, self.outline.begin());
    }
}
