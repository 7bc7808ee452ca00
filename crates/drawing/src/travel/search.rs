//! Terms of a search for the order of cutting.

use super::rapids::Rapids;
use crate::OpError;
use kerf_geom::Point2;

/// Terms of a search.
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Search {
    /// Place that the head comes from and returns to.
    pub from: Point2,
    /// Closed shapes may begin elsewhere, and open ones be turned where nothing but the direction changes.
    pub starts: bool,
    /// Speed and times of the head between the cuts.
    #[serde(default)]
    pub rapids: Rapids,
    /// Number of times that a change of the tour is tried; `None` is what such a drawing deserves.
    #[serde(default)]
    pub tries: Option<u32>,
}

impl Search {
    /// Checks the speeds and times.
    pub(crate) fn check(&self) -> Result<(), OpError> {
        let Rapids { speed_mm_s, accel_mm_s2, lift_s, tool_change_s } = self.rapids;
        let bounds = [
            ("the speed", speed_mm_s, speed_mm_s > 0.0 && speed_mm_s.is_finite(), "above 0"),
            ("the acceleration", accel_mm_s2, accel_mm_s2 >= 0.0, "0 or more"),
            ("the time of a lift", lift_s, lift_s >= 0.0, "0 or more"),
            ("the time of a tool change", tool_change_s, tool_change_s >= 0.0, "0 or more"),
        ];
        let wrong = bounds.into_iter().find(|(_, _, holds, _)| !holds);
        wrong.map_or(Ok(()), |(what, value, _, bound)| Err(OpError::Bound { what, value, bound }))
    }
}
