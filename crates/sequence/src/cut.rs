//! One shape, the machine that cuts it and the values in force.

use crate::place::{Progress, Spot};
use crate::setup::Setup;
use crate::step::{Awaited, Step};
use crate::values::Values;
use kerf_geom::Segment;
use kerf_machine::lines::{Input, Output};
use kerf_machine::planning::rapid_mm_s;
use kerf_machine::settings::delays::{BottomDelayType, TimeoutAction};
use kerf_program::job::{Depths, JobShape, Plunge};
use kerf_program::{Axes, Beam};

/// A shape, and what it is cut with.
pub(crate) struct Cut<'a> {
    pub setup: &'a Setup,
    pub values: &'a Values,
    pub shape: &'a JobShape,
}

impl Cut<'_> {
    pub fn bottom_delay(&self) -> Vec<Step> {
        let delays = &self.setup.machine.delays;
        let mut steps = Vec::from_iter(self.beam_at_bottom());
        if delays.bottom_type == BottomDelayType::Input {
            let pauses = delays.bottom_timeout == TimeoutAction::Pause;
            let missing = pauses.then_some("no end-of-bottom-delay input");
            let (input, timeout_s) = (Input::EndBottomDelay, delays.bottom_timeout_s);
            steps.push(Step::Await(Awaited { input, timeout_s, missing }));
        }
        steps.push(Step::Wait(delays.bottom_s));
        steps
    }

    pub fn end_of_cut(&self) -> Vec<Step> {
        let mut steps = vec![Step::Height(None), Step::Switch(Output::cut(self.shape.cut), false)];
        steps.extend(self.beam_at_end());
        steps.push(Step::Wait(self.setup.machine.delays.end_s));
        steps.push(Step::Beam(Beam::Off));
        steps
    }

    /// Cutting speed of a segment: the least of the shape's and the machine's in its direction. What
    /// the axes allow is the planner's concern.
    pub fn feed(&self, segment: &Segment, way: Axes) -> f64 {
        if self.shape.traversal {
            return rapid_mm_s(&self.setup.settings, way);
        }
        let along = segment.end() - segment.start();
        let share = match segment {
            Segment::Line { .. } => {
                self.setup.settings.smoothing.speed_share(along.y.abs().atan2(along.x.abs()))
            }
            Segment::Arc { .. } => 1.0,
        };
        self.shape.speed_mm_s.unwrap_or(f64::INFINITY).min(self.values.cut_mm_s * share)
    }

    /// The height from which the tool goes down along the path or a helix, when it does: that of the pass
    /// before, at the beginning of a path cut at one height.
    pub fn slopes_from(&self, progress: &Progress, spot: &Spot) -> Option<f64> {
        let Depths::Level(levels) = &progress.depths else { return None };
        if self.height_law().is_some() {
            return None;
        }
        let pass = progress.here.pass;
        let before =
            if pass == 0 { Some(&self.values.heights.surface_mm) } else { levels.get(pass - 1) };
        let begins = spot.segment == 0 && spot.share == 0.0;
        let (from, to) = (*before?, *levels.get(pass)?);
        let slopes = begins && !self.shape.plunge.slopes(&self.shape.path, from, to).is_empty();
        slopes.then_some(from)
    }

    /// Tells what happens instead of the way down that a shape asks for, if something does.
    pub fn other_entry(&self) -> Option<String> {
        let asked = match self.shape.plunge {
            _ if self.shape.traversal => return None,
            Plunge::Straight => return None,
            Plunge::Ramp { .. } => "ramp",
            Plunge::Helix { .. } => "helix",
        };
        let depths = self.shape.depths(&self.values.heights).ok()?;
        let Depths::Level(levels) = depths else { return None };
        let straight = if self.setup.machine.plasma.use_sequence {
            Some("the plasma torch starts above the sheet")
        } else if self.pierces() {
            Some("the laser pierces")
        } else {
            self.height_law().map(|_| "height control follows the sheet")
        };
        if let Some(why) = straight {
            return Some(format!("the tool goes straight down, without its {asked}: {why}"));
        }
        let drop_mm = self.values.heights.surface_mm - levels.first()?;
        self.shape.plunge.too_flat(&self.shape.path, drop_mm).map(|flat| flat.to_string())
    }
}
