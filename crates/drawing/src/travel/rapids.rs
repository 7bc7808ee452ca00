//! Time that the head travels: seconds for a distance.

use serde::{Deserialize, Serialize};

/// Speed and times of the head on the way from cut to cut.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Rapids {
    /// Greatest speed, mm/s.
    pub speed_mm_s: f64,
    /// Acceleration, mm/s²; 0 for no limit.
    pub accel_mm_s2: f64,
    /// Raising the tool and lowering it again, seconds.
    pub lift_s: f64,
    /// Changing the tool, seconds.
    pub tool_change_s: f64,
}

impl Default for Rapids {
    /// A router of middle size whose tool is changed by hand.
    fn default() -> Self {
        Self { speed_mm_s: 150.0, accel_mm_s2: 500.0, lift_s: 1.0, tool_change_s: 60.0 }
    }
}

impl Rapids {
    /// Seconds for a distance from rest to rest: v = √(a·d) at the middle of a short one, full speed for a
    /// part of a long one.
    pub fn seconds(&self, distance_mm: f64) -> f64 {
        let ramps_mm = self.ramps_mm();
        if distance_mm < ramps_mm {
            2.0 * (distance_mm / self.accel_mm_s2).sqrt()
        } else {
            (distance_mm + ramps_mm) / self.speed_mm_s
        }
    }

    /// Returns the distance on which speeding up to full speed meets slowing down from it, millimetres.
    fn ramps_mm(&self) -> f64 {
        if self.accel_mm_s2 > 0.0 {
            self.speed_mm_s * self.speed_mm_s / self.accel_mm_s2
        } else {
            0.0
        }
    }
}

/// Travel between the cuts.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Travelled {
    /// Length of all rapids, millimetres.
    pub length_mm: f64,
    /// Rapids, lifts and tool changes, seconds.
    pub seconds: f64,
    /// Number of tool changes.
    pub tool_changes: usize,
}

impl Travelled {
    pub(super) fn leg(&mut self, rapids: &Rapids, distance_mm: f64, tool_change: bool) {
        self.length_mm += distance_mm;
        self.seconds += rapids.seconds(distance_mm);
        if tool_change {
            self.seconds += rapids.tool_change_s;
            self.tool_changes += 1;
        }
    }

    pub(super) fn lifts(&mut self, rapids: &Rapids) {
        self.seconds += rapids.lift_s;
    }
}

impl std::fmt::Display for Travelled {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{:.1} mm in {:.1} s", self.length_mm, self.seconds)?;
        match self.tool_changes {
            0 => Ok(()),
            1 => f.write_str(" with 1 tool change"),
            more => write!(f, " with {more} tool changes"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_ways_never_reach_full_speed() {
        let rapids = Rapids { speed_mm_s: 100.0, accel_mm_s2: 500.0, ..Rapids::default() };
        let near = |value: f64, expected: f64| assert!((value - expected).abs() < 1e-12, "{value}");
        near(rapids.seconds(0.0), 0.0);
        near(rapids.seconds(5.0), 0.2);
        near(rapids.seconds(20.0), 0.4);
        near(rapids.seconds(120.0), 1.4);
        near(Rapids { accel_mm_s2: 0.0, ..rapids }.seconds(5.0), 0.05);
    }
}
