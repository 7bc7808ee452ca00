//! Height control in jobs: what the machine is told, and how ZSurface and ZTop follow (Profiler
//! reference, "Automatic Height Control"; ledger notes 79 to 84 and 3.12).

use super::Sequence;
use super::small::Small;
use crate::lines::Input;
use crate::settings::height::HeightMode;
use kerf_program::job::{Depth, JobShape};
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
        })
    }

    /// Down to the height of the cut: where the sensor says so, at the lowest to ZBottom.
    pub(super) fn down(&self, shape: &JobShape, z: f64) -> Vec<Small> {
        match self.height_law(shape) {
            Some(law) => vec![Small::Height(Some(Arc::new(law))), Small::Lower(z)],
            None => vec![Small::Plunge(z)],
        }
    }

    /// Height control left Z somewhere: ZSurface and ZTop have followed.
    pub(super) fn follow_heights(&mut self, z_mm: f64) {
        let by = z_mm - self.begun_mm;
        self.heights.surface_mm += by;
        self.heights.top_mm += by;
        self.position[Axis::Z] = z_mm;
    }
}
