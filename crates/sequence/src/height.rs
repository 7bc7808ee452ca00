//! Height control in jobs: what the machine is told, and how ZSurface and ZTop follow (Profiler
//! reference, "Automatic Height Control"; readings, P-79 to P-84, Height control).

use crate::Sequence;
use crate::place::Along;
use crate::small::Small;
use kerf_geom::{Point2, Vec2};
use kerf_machine::lines::Input;
use kerf_machine::settings::height::HeightMode;
use kerf_program::job::{Depth, Heights, JobShape};
use kerf_program::{Axis, Gauge, HeightLaw, Host};
use std::sync::Arc;

/// Bits of one reading on the line: start, eight of data, stop.
const BITS: f64 = 10.0;

/// A head that stands nearer to where it was has not been carried, mm: far below a step.
const CARRIED_MM: f64 = 1e-6;

/// The way along X.
const ALONG_X: Vec2 = Vec2 { x: 1.0, y: 0.0 };

impl Sequence {
    /// Returns the law by which Z follows the sheet in a shape; only THRU shapes are followed.
    pub(crate) fn height_law(&self, shape: &JobShape) -> Option<HeightLaw> {
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
        // As far over the sheet as the way begins, whichever set point is that of its direction.
        let over_mm = gap_mm(&law, end_of(before)) - gap_mm(&law, shape.start() - before.end());
        let raised_mm = self.travel_mm() - self.heights.surface_mm + over_mm;
        Some(HeightLaw { raised_mm: Some(raised_mm), ..law })
    }

    /// In the plane to where a path begins, its height over the sheet kept where that is asked for.
    pub(crate) fn link(&self, shape: &JobShape, place: Point2) -> Vec<Small> {
        let mut steps = self.way_to(place);
        let law = self.law_between(shape).filter(|_| self.here.along == Along::Before);
        if let (Some(law), Some(at)) = (law, steps.len().checked_sub(1)) {
            steps.insert(at, Small::Height(Some(Arc::new(law))));
            steps.push(Small::Height(None));
        }
        steps
    }

    /// Down to the height of the cut: where the sensor says so, at the lowest to ZBottom.
    pub(crate) fn down(&self, shape: &JobShape, z: f64) -> Vec<Small> {
        let Some(law) = self.height_law(shape) else { return vec![Small::Plunge(z)] };
        let proportional = matches!(law.gauge, Gauge::Proportional { .. });
        let mut steps = Vec::from(Self::until_sensed(law, z));
        // A reading says where the head is; two inputs cannot tell how far it ran on.
        steps.extend(proportional.then_some(Small::AboveSensed(0.0)));
        steps
    }

    /// Returns the law by which Z follows the sheet in the first shape in which it does.
    pub fn follows_sheet(&self) -> Option<HeightLaw> {
        self.job.shapes.iter().find_map(|shape| self.height_law(shape))
    }

    /// Height control goes by two switches.
    pub(crate) fn is_simple(&self) -> bool {
        self.law.as_ref().is_some_and(|law| matches!(law.gauge, Gauge::Simple { .. }))
    }

    /// Above the sheet a head is too high: where no switch says so it is not connected, or there is no sheet,
    /// and the cut would be one in the air.
    pub(crate) fn feels_nothing(&self, host: &mut dyn Host) -> bool {
        let travels = self.travel_mm() > self.heights.surface_mm + CARRIED_MM
            && self.position[Axis::Z] > self.travel_mm() - CARRIED_MM;
        travels && !host.input(Input::ZHigh.number()) && !host.input(Input::ZLow.number())
    }

    /// Down until the sensor says that the head is at its height, at the lowest to a height.
    pub(crate) fn until_sensed(law: HeightLaw, lowest: f64) -> [Small; 2] {
        [Small::Height(Some(Arc::new(law))), Small::Lower(lowest)]
    }

    /// The tool is about to cut where it stands: ZSurface is there, and ZTop as far above it as it was set.
    pub(crate) fn cuts_here(&mut self) {
        if let Some(law) = self.law.clone().filter(|_| self.controlled) {
            self.heights = law.carried(self.heights, self.position[Axis::Z]);
        }
    }

    /// Height control left Z somewhere: ZSurface and ZTop have followed, unless it left Z where it was.
    pub(crate) fn follow_heights(&mut self, z_mm: f64) {
        let carried = (z_mm - self.begun_mm).abs() > CARRIED_MM;
        if let Some(law) = self.law.clone().filter(|_| carried) {
            self.heights = law.carried(self.heights, z_mm);
        }
        self.begun_mm = z_mm;
        self.position[Axis::Z] = z_mm;
    }

    /// The machine was halted at a height: ZSurface and ZTop have followed on the path and between paths,
    /// not on the way down to the sheet, which is sensed anew. Whether they have.
    pub(crate) fn heights_left(&mut self, z_mm: f64) -> bool {
        let travels = self.given && matches!(self.steps.front(), Some(Small::Travel(_)));
        let follows = self.controlled && (self.is_following() || travels);
        if follows {
            self.follow_heights(z_mm);
        }
        self.begun_mm = z_mm;
        follows
    }

    /// ZTop and ZSurface as they were when the job began.
    pub(crate) fn restore_heights(&mut self) {
        let [top_mm, surface_mm] = [self.machine.zpos.top_mm, self.machine.zpos.surface_mm];
        self.heights = Heights { top_mm, surface_mm, ..self.heights };
    }

    /// Returns the inputs that height control watches while a path is followed, and the message of each.
    pub(crate) fn height_faults(&self) -> &'static [(Input, &'static str)] {
        if self.controlled { &FAULTS } else { &[] }
    }
}

/// The distance over the sheet at which a law keeps the head in a direction, mm.
fn gap_mm(law: &HeightLaw, way: Vec2) -> f64 {
    law.gap_mm(law.set_point(way.x, way.y))
}

/// The direction in which a path ends.
fn end_of(shape: &JobShape) -> Vec2 {
    let last = shape.path.segment_count().checked_sub(1);
    last.map_or(ALONG_X, |last| shape.path.segment(last).direction(1.0))
}

/// Message where two switches do not tell that the head is too high, high above the sheet.
pub(crate) const NOTHING_FELT: &str = "no height readings: zhigh is off at Z top";

/// Faults of height control that the controller notices, and the message of each.
pub(crate) const FAULTS: [(Input, &str); 3] = [
    (Input::HeightSilent, "no height readings"),
    (Input::HeightConflict, "height sensors conflict"),
    (Input::HeightAtZero, "z at 0"),
];
