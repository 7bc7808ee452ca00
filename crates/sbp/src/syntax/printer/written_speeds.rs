//! The move speeds that a part file has said.

use kerf_program::Axis;
use kerf_program::settings::PerGroup;

/// The groups of VS: XY, Z, A, B.
pub(super) const GROUPS: [Axis; 4] = [Axis::X, Axis::Z, Axis::A, Axis::B];

/// The move speeds as they were last written; `None` for those that the file has not said.
#[derive(Debug, Default)]
pub(super) struct Written(pub(super) [Option<f64>; 4]);

impl Written {
    /// Those of the settings.
    pub(super) fn of(speeds: &PerGroup) -> Self {
        Self(GROUPS.map(|axis| Some(speeds.of(axis))))
    }

    /// Returns the time that a move of these distances takes; `None` when the file has not said it.
    pub(super) fn time(&self, distances: &[f64; 4]) -> Option<f64> {
        let mut time = 0.0_f64;
        for (speed, distance) in self.0.iter().zip(distances) {
            if *distance > 0.0 {
                time = time.max(distance / (*speed)?);
            }
        }
        Some(time)
    }
}
