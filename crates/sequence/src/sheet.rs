//! Height control in jobs: what the machine is told, and how ZSurface and ZTop follow (Profiler
//! reference, "Automatic Height Control"; readings, P-79 to P-84, Height control).

use crate::cut::Cut;
use crate::step::Step;
use kerf_geom::Vec2;
use kerf_machine::lines::Input;
use kerf_machine::settings::height::HeightMode;
use kerf_program::job::{self, Heights, JobShape};
use kerf_program::{Axis, Gauge, HeightLaw, Host};
use std::sync::Arc;

/// Bits of one reading on the line: start, eight of data, stop.
const BITS: f64 = 10.0;

/// A head that stands nearer to where it was has not been carried, mm: far below a step.
const CARRIED_MM: f64 = 1e-6;

/// The way along X.
const ALONG_X: Vec2 = Vec2 { x: 1.0, y: 0.0 };

/// How height control carries Z over the sheet.
#[derive(Clone, Debug)]
pub(crate) struct Sheet {
    /// Law by which Z follows the sheet, or followed it last.
    pub law: Option<Arc<HeightLaw>>,
    /// Height control is on.
    pub controlled: bool,
    /// The height from which height control carried Z, machine frame.
    pub begun_mm: f64,
    /// Place where the sheet was felt, Z of the machine frame.
    pub felt_mm: f64,
}

impl Sheet {
    /// A sheet with its surface at a height.
    pub const fn at(surface_mm: f64) -> Self {
        Self { law: None, controlled: false, begun_mm: surface_mm, felt_mm: surface_mm }
    }

    /// Height control goes by two switches.
    pub fn is_simple(&self) -> bool {
        self.law.as_ref().is_some_and(|law| matches!(law.gauge, Gauge::Simple { .. }))
    }

    /// Height control begins or ends; `true` where it ends, and Z is to be asked for.
    pub fn control(&mut self, law: Option<Arc<HeightLaw>>, z_mm: f64) -> bool {
        let ends = law.is_none() && self.controlled;
        if law.is_some() || ends {
            self.controlled = law.is_some();
            self.begun_mm = if ends { self.begun_mm } else { z_mm };
            self.law = law.or_else(|| self.law.take());
        }
        ends
    }

    /// The tool is about to cut at a height: ZSurface is there, and ZTop as far above it as it was set.
    pub fn cuts_at(&self, heights: &mut Heights, z_mm: f64) {
        if let Some(law) = self.law.as_ref().filter(|_| self.controlled) {
            *heights = law.carried(*heights, z_mm);
        }
    }

    /// Height control left Z somewhere: ZSurface and ZTop have followed, unless it left Z where it was.
    pub fn left_at(&mut self, heights: &mut Heights, z_mm: f64) {
        let carried = (z_mm - self.begun_mm).abs() > CARRIED_MM;
        if let Some(law) = self.law.as_ref().filter(|_| carried) {
            *heights = law.carried(*heights, z_mm);
        }
        self.begun_mm = z_mm;
    }

    /// Returns the inputs that height control watches while a path is followed, and the message of each.
    pub const fn faults(&self) -> &'static [(Input, &'static str)] {
        if self.controlled { &FAULTS } else { &[] }
    }
}

/// Above the sheet a head is too high: where no switch says so it is not connected, or there is no sheet,
/// and the cut would be one in the air.
pub(crate) fn feels_nothing(
    heights: &Heights,
    travel_mm: f64,
    z_mm: f64,
    host: &mut dyn Host,
) -> bool {
    let travels = travel_mm > heights.surface_mm + CARRIED_MM && z_mm > travel_mm - CARRIED_MM;
    travels && !host.input(Input::ZHigh.number()) && !host.input(Input::ZLow.number())
}

impl Cut<'_> {
    /// Returns the law by which Z follows the sheet in a shape; only THRU shapes are followed.
    pub fn height_law(&self) -> Option<HeightLaw> {
        let height = &self.setup.machine.height;
        if !height.on || self.shape.height != job::CutDepth::Thru || self.shape.traversal {
            return None;
        }
        let steps = self.setup.settings.resolution.steps_per_unit[Axis::Z].abs();
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
            floor_mm: self.values.heights.bottom_mm,
            raised_mm: None,
        })
    }

    /// Down to the height of the cut: where the sensor says so, at the lowest to ZBottom.
    pub fn down(&self, z: f64) -> Vec<Step> {
        let Some(law) = self.height_law() else { return vec![Step::Plunge(z)] };
        let proportional = matches!(law.gauge, Gauge::Proportional { .. });
        let mut steps = Vec::from(Self::until_sensed(law, z));
        // A reading says where the head is; two inputs cannot tell how far it ran on.
        steps.extend(proportional.then_some(Step::AboveSensed(0.0)));
        steps
    }

    /// Down until the sensor says that the head is at its height, at the lowest to a height.
    pub fn until_sensed(law: HeightLaw, lowest: f64) -> [Step; 2] {
        [Step::Height(Some(Arc::new(law))), Step::Lower(lowest)]
    }
}

/// The distance over the sheet at which a law keeps the head in a direction, mm.
pub(crate) fn gap_mm(law: &HeightLaw, way: Vec2) -> f64 {
    law.gap_mm(law.set_point(way.x, way.y))
}

/// The direction in which a path ends.
pub(crate) fn end_of(shape: &JobShape) -> Vec2 {
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
