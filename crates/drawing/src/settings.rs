//! Settings by which the shapes of a group are cut.

pub use kerf_program::job::CutDepth;
use kerf_program::job::Plunge;
use serde::{Deserialize, Serialize};
use thiserror::Error;

/// The most passes of one path: more are a slip of the decimal point.
const MOST_PASSES: f64 = 10_000.0;

/// An arc by which the tool comes to a path or leaves it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Lead {
    /// Radius, millimetres. Negative puts the arc on the other side of the path.
    pub radius_mm: f64,
    /// Included angle, 0 … 360 degrees.
    pub angle_deg: f64,
}

impl Lead {
    /// Returns `true` if there is an arc at all.
    pub fn is_some(&self) -> bool {
        self.radius_mm != 0.0 && self.angle_deg != 0.0
    }
}

/// The cut settings and the path settings of a group (Profiler reference, tables 9 and 10).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct GroupSettings {
    /// Its shapes are cut.
    pub on: bool,
    /// Its shapes are followed without cutting, to lead the head round obstacles.
    pub traversal: bool,
    /// The tool control output, 1 … 3.
    pub tool: u8,
    /// The tool cut output, 1 … 3.
    pub cut: u8,
    /// Highest cutting speed, mm/min; `None` is the machine's cutting speed.
    pub speed_mm_min: Option<f64>,
    /// Depth of the cut.
    pub height: CutDepth,
    /// Depth of one pass, millimetres; only with [`CutDepth::Mm`].
    pub pass_mm: Option<f64>,
    /// Distance of the path from the shape, millimetres; positive is right of travel.
    pub offset_mm: f64,
    /// Stock that the rough pass leaves for the final one, millimetres; 0 is no rough pass.
    pub rough_mm: f64,
    /// Cut on both sides of the shape.
    pub double_line: bool,
    /// Length of the path's beginning that is left out, millimetres.
    pub tag_mm: f64,
    /// The way onto the path.
    pub lead_in: Lead,
    /// The way off the path.
    pub lead_out: Lead,
    /// The way down into the material. A helix lies on the side of a lead-in, on the other one when its radius is
    /// negative.
    #[serde(default)]
    pub plunge: Plunge,
    /// Diameter of the cutter, millimetres, for pictures; `None` is twice the offset.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cutter_mm: Option<f64>,
}

impl Default for GroupSettings {
    fn default() -> Self {
        Self {
            on: true,
            traversal: false,
            tool: 1,
            cut: 1,
            speed_mm_min: None,
            height: CutDepth::Thru,
            pass_mm: None,
            offset_mm: 0.0,
            rough_mm: 0.0,
            double_line: false,
            tag_mm: 0.0,
            lead_in: Lead::default(),
            lead_out: Lead::default(),
            plunge: Plunge::default(),
            cutter_mm: None,
        }
    }
}

/// A setting that cannot be.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum SettingsError {
    /// An output that is not there.
    #[error("{what} is {number}: a group has the outputs 1, 2 and 3")]
    Output {
        /// `tool` or `cut`.
        what: &'static str,
        /// The number given.
        number: u8,
    },
    /// Passes need a depth to be divided.
    #[error("multi-pass needs height type MM: set the height to a depth in millimetres first")]
    PassNeedsMm,
    /// A length or speed outside its bounds.
    #[error("{what} is {value}: it must be {bound}")]
    Bound {
        /// Name of the setting.
        what: &'static str,
        /// The value given.
        value: f64,
        /// The bound, in words.
        bound: &'static str,
    },
}

impl GroupSettings {
    /// Checks what one setting alone and all together may be.
    ///
    /// # Errors
    /// The first setting that cannot be.
    pub fn check(&self) -> Result<(), SettingsError> {
        for (what, number) in [("tool", self.tool), ("cut", self.cut)] {
            if !(1..=3).contains(&number) {
                return Err(SettingsError::Output { what, number });
            }
        }
        if self.pass_mm.is_some() && !matches!(self.height, CutDepth::Mm(_)) {
            return Err(SettingsError::PassNeedsMm);
        }
        self.bounds().try_for_each(|(what, value, holds, bound)| {
            let fits = value.is_finite() && holds;
            if fits { Ok(()) } else { Err(SettingsError::Bound { what, value, bound }) }
        })
    }

    fn bounds(&self) -> impl Iterator<Item = (&'static str, f64, bool, &'static str)> {
        let depth = if let CutDepth::Mm(depth) = self.height { depth } else { 0.0 };
        let pass = self.pass_mm.unwrap_or(1.0);
        let speed = self.speed_mm_min.unwrap_or(1.0);
        let angle = |lead: Lead| (0.0..=360.0).contains(&lead.angle_deg);
        let number = "a number";
        let cutter = self.cutter_mm.unwrap_or(1.0);
        let (steep, helix) = match self.plunge {
            Plunge::Straight => (90.0, 1.0),
            Plunge::Ramp { angle_deg } => (angle_deg, 1.0),
            Plunge::Helix { radius_mm, angle_deg } => (angle_deg, radius_mm),
        };
        [
            ("height", depth, true, number),
            ("pass", pass, pass > 0.0, "above 0 mm"),
            ("pass", pass, -depth <= MOST_PASSES * pass, "at least a 10,000th of the height"),
            ("speed", speed, speed > 0.0, "above 0 mm/min"),
            ("offset", self.offset_mm, true, number),
            ("rough", self.rough_mm, true, number),
            ("tag", self.tag_mm, self.tag_mm >= 0.0, "0 mm or more"),
            ("lead-in radius", self.lead_in.radius_mm, true, number),
            ("lead-in angle", self.lead_in.angle_deg, angle(self.lead_in), "0 to 360 degrees"),
            ("lead-out radius", self.lead_out.radius_mm, true, number),
            ("lead-out angle", self.lead_out.angle_deg, angle(self.lead_out), "0 to 360 degrees"),
            ("plunge angle", steep, (0.1..=90.0).contains(&steep), "0.1 to 90 degrees"),
            ("plunge radius", helix, helix != 0.0, "a number other than 0"),
            ("cutter", cutter, cutter > 0.0, "above 0 mm"),
        ]
        .into_iter()
    }

    /// Returns the width of the group's cuts, millimetres: the cutter's diameter, or twice the offset of what it
    /// cuts; nothing where neither is known.
    pub fn width_mm(&self) -> Option<f64> {
        let twice = 2.0 * self.offset_mm.abs();
        self.cutter_mm.or_else(|| (twice > 0.0).then_some(twice))
    }

    /// Distance of the rough path from the shape, millimetres, or nothing without a rough pass:
    /// the offset made larger by the rough amount; without an offset the sign of the rough amount
    /// tells the side (readings, Rough pass).
    pub fn rough_offset_mm(&self) -> Option<f64> {
        if self.rough_mm == 0.0 {
            return None;
        }
        if self.offset_mm == 0.0 {
            return Some(self.rough_mm);
        }
        Some(self.offset_mm + self.offset_mm.signum() * self.rough_mm.abs())
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn pro_group_rough_formula() {
        let rough = |offset_mm, rough_mm| {
            GroupSettings { offset_mm, rough_mm, ..Default::default() }.rough_offset_mm()
        };
        assert_eq!(rough(3.0, 0.5), Some(3.5));
        assert_eq!(rough(3.0, -0.5), Some(3.5));
        assert_eq!(rough(-3.0, 0.5), Some(-3.5));
        assert_eq!(rough(-3.0, -0.5), Some(-3.5));
    }

    #[test]
    fn pro_group_rough_zero() {
        let rough = |rough_mm| GroupSettings { rough_mm, ..Default::default() }.rough_offset_mm();
        assert_eq!(rough(0.5), Some(0.5));
        assert_eq!(rough(-0.5), Some(-0.5));
        assert_eq!(rough(0.0), None);
    }

    fn refused(change: impl FnOnce(&mut GroupSettings), word: &str) {
        let mut settings = GroupSettings::default();
        assert_eq!(settings.check(), Ok(()));
        change(&mut settings);
        let message = settings.check().unwrap_err().to_string();
        assert!(message.contains(word), "{message}");
    }

    #[test]
    fn settings_out_of_bounds_are_refused_by_name() {
        refused(|s| s.tool = 4, "tool is 4");
        refused(|s| s.cut = 0, "cut is 0");
        refused(|s| s.pass_mm = Some(2.0), "multi-pass needs height type MM");
        refused(|s| (s.height, s.pass_mm) = (CutDepth::Mm(-3.0), Some(0.0)), "pass is 0");
        refused(
            |s| (s.height, s.pass_mm) = (CutDepth::Mm(-3.0), Some(1e-4)),
            "at least a 10,000th",
        );
        refused(|s| s.tag_mm = -1.0, "tag is -1");
        refused(|s| s.offset_mm = f64::NAN, "offset is NaN");
        refused(|s| s.lead_in.angle_deg = 361.0, "lead-in angle");
        refused(|s| s.plunge = Plunge::Ramp { angle_deg: 0.0 }, "plunge angle is 0");
        let none = Plunge::Helix { radius_mm: 0.0, angle_deg: 2.0 };
        refused(|s| s.plunge = none, "plunge radius is 0");
        refused(|s| s.speed_mm_min = Some(0.0), "speed is 0");
        refused(|s| s.cutter_mm = Some(0.0), "cutter is 0");
    }
}
