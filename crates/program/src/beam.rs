//! The intensity output of a laser: seven bits, fixed or following the real speed (Profiler
//! reference, "Intensity Output").

use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Values that intensity and discretized speed can have: 0 … 127.
pub const LEVELS: usize = 128;

/// Behaviour of the intensity output.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub enum Beam {
    /// Nothing.
    #[default]
    Off,
    /// A fixed value.
    Level {
        /// Intensity 0 … 127, scaled and clipped already.
        value: u8,
        /// The lowest bit of the port's byte is set (burn bit).
        burn: bool,
    },
    /// It follows the speed while a cut moves.
    Follow(Arc<IntensityLaw>),
}

/// Law by which intensity depends on speed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct IntensityLaw {
    /// Intensity of each discretized speed; [`LEVELS`] of them.
    pub table: Arc<[u8]>,
    /// Scale of the output, percent.
    pub scale_percent: f64,
    /// Least and greatest value that gives a pulse the laser can make.
    pub clip: Option<[u8; 2]>,
}

impl IntensityLaw {
    /// The discretized speed: trunc(127 s / C), at most 127.
    pub fn index(speed_mm_s: f64, full_mm_s: f64) -> u8 {
        // A speed that reaches a step by rounding has reached it.
        let share = (speed_mm_s / full_mm_s * 127.0 + 1e-9).clamp(0.0, 127.0);
        if share.is_nan() { 0 } else { share as u8 }
    }

    /// The speed from which a discretized speed holds, as a share of the full one.
    pub fn share_of(index: u8) -> f64 {
        f64::from(index) / 127.0
    }

    /// The output value of an intensity 0 … 127 that is asked for: through the table, scaled, clipped.
    pub fn value(&self, index: u8) -> u8 {
        let entry = self.table.get(usize::from(index)).copied().unwrap_or_default();
        let scaled = (self.scale_percent / 100.0 * f64::from(entry) + 1e-9).clamp(0.0, 127.0) as u8;
        self.clip.map_or(scaled, |[low, high]| scaled.clamp(low.min(high), high))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn law(scale_percent: f64, clip: Option<[u8; 2]>) -> IntensityLaw {
        IntensityLaw { table: (0..128).collect(), scale_percent, clip }
    }

    #[test]
    fn pro_intensity_index() {
        let index = |share: f64| IntensityLaw::index(100.0 * share, 100.0);
        assert_eq!([0.8, 0.5, 1.0, 1.2, 0.0].map(index), [101, 63, 127, 127, 0]);
    }

    #[test]
    fn pro_intensity_scale() {
        let table: Arc<[u8]> = std::iter::repeat_n(64, 128).collect();
        assert_eq!(IntensityLaw { table, ..law(60.0, None) }.value(100), 38);
        assert_eq!(law(60.0, None).value(101), 60);
    }

    #[test]
    fn pro_intensity_clip() {
        let law = law(100.0, Some([12, 63]));
        assert_eq!([5, 38, 100].map(|i| law.value(i)), [12, 38, 63]);
    }

    #[test]
    fn pro_intensity_nonlinear() {
        let table: Arc<[u8]> = (0..128).map(|i: u8| i.max(64)).collect();
        let law = IntensityLaw { table, ..law(100.0, None) };
        assert_eq!([law.value(10), law.value(63), law.value(100)], [64, 64, 100]);
    }
}
