//! Height control in jobs: what the machine is told, and how ZSurface and ZTop follow (Profiler
//! reference, "Automatic Height Control"; ledger notes 79 to 84 and 3.12).

use super::Sequence;
use super::place::Along;
use super::small::Small;
use crate::lines::Input;
use crate::settings::height::HeightMode;
use kerf_geom::Point2;
use kerf_program::job::{Depth, Heights, JobShape};
use kerf_program::{Axis, Gauge, HeightLaw};
use std::sync::Arc;

/// Bits of one reading on the line: start, eight of data, stop.
const BITS: f64 = 10.0;

impl Sequence {
    /// How Z follows the sheet in a shape; only THRU shapes are followed.
    pub(super) fn height_law(&self, shape: &JobShape) -> Option<HeightLaw> {
        let height = &self.machine.height;
        if !height.on || shape.depth != Depth::Thru || shape.traversal {
            return None;
        }
        let steps = self.settings.resolution.steps_per_unit[Axis::Z].abs();
        let sign = if height.invert { -1.0 } else { 1.0 };
        let gauge = match height.mode {
            HeightMode::Simple => {
                Gauge::Simple { high: Input::ZHigh.number(), low: Input::ZLow.number() }
            }
            HeightMode::Proportional => Gauge::Proportional {
                set_points: [height.x_set_point, height.y_set_point].map(f64::from),
                gain_mm: sign * height.k / steps,
                scale_mm: height.scale_mm,
                interval_s: BITS / f64::from(height.baud.max(1)),
            },
        };
        Some(HeightLaw {
            gauge,
            speed_mm_s: height.speed_mm_s,
            accel_mm_s2: height.accel_mm_s2,
            activation: height.activation_percent / 100.0,
            ceiling_mm: 0.0,
            floor_mm: self.heights.bottom_mm,
            raised_mm: None,
        })
    }

    /// The same on the way from the path before to a path, at the height of travel, where both are followed.
    fn law_between(&self, shape: &JobShape) -> Option<HeightLaw> {
        let before = self.here.nth.checked_sub(1).and_then(|nth| self.job.shapes.get(nth))?;
        let followed = self.machine.height.between && self.height_law(before).is_some();
        let law = self.height_law(shape).filter(|_| followed)?;
        Some(HeightLaw { raised_mm: Some(self.heights.top_mm - self.cut_at_mm), ..law })
    }

    /// In the plane to where a path begins, its height over the sheet kept where that is asked for.
    pub(super) fn link(&self, shape: &JobShape, place: Point2) -> Vec<Small> {
        let mut steps = self.way_to(place);
        let law = self.law_between(shape).filter(|_| self.here.along == Along::Before);
        if let (Some(law), Some(at)) = (law, steps.len().checked_sub(1)) {
            steps.insert(at, Small::Height(Some(Arc::new(law))));
            steps.push(Small::Height(None));
        }
        steps
    }

    /// Down to the height of the cut: where the sensor says so, at the lowest to ZBottom.
    pub(super) fn down(&self, shape: &JobShape, z: f64) -> Vec<Small> {
        let Some(law) = self.height_law(shape) else { return vec![Small::Plunge(z)] };
        let proportional = matches!(law.gauge, Gauge::Proportional { .. });
        let mut steps = Vec::from(Self::until_sensed(law, z));
        // A reading says where the head is; two inputs cannot tell how far it ran on.
        steps.extend(proportional.then_some(Small::AboveSensed(0.0)));
        steps
    }

    /// Down until the sensor says that the head is at its height, at the lowest to a height.
    pub(super) fn until_sensed(law: HeightLaw, lowest: f64) -> [Small; 2] {
        [Small::Height(Some(Arc::new(law))), Small::Lower(lowest)]
    }

    /// Height control left Z somewhere: ZSurface and ZTop have followed.
    pub(super) fn follow_heights(&mut self, z_mm: f64) {
        let by = z_mm - self.begun_mm;
        self.heights.surface_mm += by;
        self.heights.top_mm += by;
        self.cut_at_mm = z_mm;
        self.position[Axis::Z] = z_mm;
    }

    /// The heights in force where the tool is: under height control they have followed it.
    pub(super) fn heights_here(&self) -> Heights {
        let by = if self.controlled { self.position[Axis::Z] - self.begun_mm } else { 0.0 };
        let Heights { top_mm, surface_mm, bottom_mm } = self.heights;
        Heights { top_mm: top_mm + by, surface_mm: surface_mm + by, bottom_mm }
    }

    /// ZTop and ZSurface as they were when the job began.
    pub(super) fn restore_heights(&mut self) {
        let [top_mm, surface_mm] = [self.machine.zpos.top_mm, self.machine.zpos.surface_mm];
        self.heights = Heights { top_mm, surface_mm, ..self.heights };
    }

    /// What height control watches while a path is followed, and what is said then.
    pub(super) fn height_faults(&self) -> &'static [(Input, &'static str)] {
        if self.controlled { &FAULTS } else { &[] }
    }
}

/// What the controller notices of height control, and what is said.
pub(super) const FAULTS: [(Input, &str); 3] = [
    (Input::HeightSilent, "no height readings"),
    (Input::HeightConflict, "height sensors conflict"),
    (Input::HeightAtZero, "z at 0"),
];
