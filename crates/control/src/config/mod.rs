//! The machine's configuration: a TOML file that says how its settings start.
//!
//! What the file does not name keeps its default; a key that is not known is refused, and so is a
//! value out of bounds. Lengths are millimetres, speeds millimetres a second, rotary axes degrees,
//! whatever unit the user reads.
//!
//! ```toml
//! units = "mm"                # what the user reads: in or mm
//! axes = 4
//! rotary = ["mm", "deg", "deg"]   # what A, B and C are: in, mm or deg
//! warning_s = 2.0             # warning before motion
//! stack_limit = 1000          # moves read before motion begins; no limit when not given
//! [speeds.cut]
//! xy = 50.0
//! z = 25.0
//! [ramps]
//! cut_rate_mm = 5.0
//! [limits]
//! low = [0, 0, -150]
//! high = [2400, 1200, 50]
//! check = true
//! [io]
//! inputs = [0, 2, 2]          # modes of VN, input 1 first
//! interlock = 12              # the input that is ON while the enclosure is open
//! [steps]
//! per_unit = [40, 40, 40]     # steps for a millimetre or a degree
//! [smoothing]                 # of the model `motion = "profiler"`
//! factor = 0.6
//! stop_angle_deg = 1.0
//! centripetal_percent = 100
//! cut_speed_mm_s = 100        # highest along X; along Y so many times that:
//! y_factor = 1.0
//! ```

mod bounds;
mod motion;

use bounds::{
    NOT_NEGATIVE, NUMBER, POSITIVE, axes, group, modes, not_negative, positive, refused, set,
};
use kerf_program::settings::{AxisUnit, LinearUnit, Settings};
use kerf_program::{AXES, Axis, Dynamics, RampModel};
use motion::{RampValues, SmoothingValues, check_dynamics};
use serde::Deserialize;

/// Why a configuration is refused. Names the key and what it accepts.
#[derive(Debug, thiserror::Error, PartialEq)]
pub enum ConfigError {
    /// The text is no such file.
    #[error("{0}")]
    Text(String),
    /// A value is out of bounds.
    #[error("{key} must be {wanted}, not {got}")]
    Value {
        /// The key.
        key: String,
        /// What it accepts.
        wanted: &'static str,
        /// What was given.
        got: String,
    },
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Config {
    units: Option<Unit>,
    axes: Option<u8>,
    rotary: Option<[RotaryUnit; 3]>,
    warning_s: Option<f64>,
    speeds: Option<Speeds>,
    ramps: Option<RampValues>,
    limits: Option<Limits>,
    io: Option<Io>,
    steps: Option<Steps>,
    dynamics: Option<Dynamics>,
    stack_limit: Option<u32>,
    /// The model of motion.
    motion: Option<RampModel>,
    smoothing: Option<SmoothingValues>,
}

#[derive(Clone, Copy, Deserialize)]
#[serde(rename_all = "lowercase")]
enum Unit {
    In,
    Mm,
}

#[derive(Clone, Copy, Deserialize)]
#[serde(rename_all = "lowercase")]
enum RotaryUnit {
    In,
    Mm,
    Deg,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Speeds {
    cut: Option<Group>,
    jog: Option<Group>,
}

#[derive(Clone, Copy, Deserialize)]
#[serde(deny_unknown_fields)]
struct Group {
    xy: Option<f64>,
    z: Option<f64>,
    a: Option<f64>,
    b: Option<f64>,
    c: Option<f64>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Limits {
    low: Option<Vec<f64>>,
    high: Option<Vec<f64>>,
    check: Option<bool>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Io {
    limits_active: Option<bool>,
    input4_normally_open: Option<bool>,
    analog: Option<u8>,
    interlock: Option<u8>,
    inputs: Option<Vec<u8>>,
    outputs: Option<Vec<u8>>,
    output4: Option<i8>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Steps {
    per_unit: Option<Vec<f64>>,
}

/// Settings as a configuration file gives them.
///
/// # Errors
/// [`ConfigError`] for text that is no TOML, keys that are not known and values out of bounds.
pub fn settings(text: &str) -> Result<Settings, ConfigError> {
    let config: Config =
        toml::from_str(text).map_err(|e| ConfigError::Text(e.to_string().trim().into()))?;
    let mut settings = Settings::default();
    config.units(&mut settings)?;
    config.motion(&mut settings)?;
    if let Some(limits) = &config.limits {
        limits.apply(&mut settings)?;
    }
    if let Some(io) = &config.io {
        io.apply(&mut settings)?;
    }
    Ok(settings)
}

impl Config {
    fn units(&self, s: &mut Settings) -> Result<(), ConfigError> {
        if let Some(unit) = self.units {
            s.use_linear_unit(match unit {
                Unit::In => LinearUnit::Inch,
                Unit::Mm => LinearUnit::Mm,
            });
        }
        if let Some(units) = self.rotary {
            s.rotary_units = units.map(|u| match u {
                RotaryUnit::In => AxisUnit::Linear(LinearUnit::Inch),
                RotaryUnit::Mm => AxisUnit::Linear(LinearUnit::Mm),
                RotaryUnit::Deg => AxisUnit::Degrees,
            });
        }
        set(&mut s.axis_count, self.axes, "axes", "1 to 6", |n| (1..=AXES as u8).contains(n))?;
        if let Some(limit) = self.stack_limit {
            set(&mut 0, Some(limit), "stack_limit", "1 or greater", |n| *n > 0)?;
            s.stack_limit = Some(limit);
        }
        set(&mut s.warning_s, self.warning_s, "warning_s", NOT_NEGATIVE, not_negative)
    }

    fn motion(&self, s: &mut Settings) -> Result<(), ConfigError> {
        if let Some(speeds) = &self.speeds {
            group(&mut s.speeds.cut, speeds.cut, "speeds.cut", POSITIVE, positive)?;
            group(&mut s.speeds.jog, speeds.jog, "speeds.jog", POSITIVE, positive)?;
        }
        if let Some(ramps) = &self.ramps {
            ramps.apply(&mut s.ramps)?;
        }
        if let Some(steps) = &self.steps {
            let key = "steps.per_unit";
            axes(
                &mut s.resolution.steps_per_unit,
                steps.per_unit.as_ref(),
                key,
                POSITIVE,
                positive,
            )?;
        }
        if let Some(dynamics) = self.dynamics {
            check_dynamics(&dynamics)?;
            s.dynamics = Some(dynamics);
        }
        s.ramp_model = self.motion;
        match &self.smoothing {
            Some(smoothing) => smoothing.apply(s),
            None => Ok(()),
        }
    }
}

impl Limits {
    fn apply(&self, s: &mut Settings) -> Result<(), ConfigError> {
        let limits = &mut s.limits;
        axes(&mut limits.low, self.low.as_ref(), "limits.low", NUMBER, |v| v.is_finite())?;
        axes(&mut limits.high, self.high.as_ref(), "limits.high", NUMBER, |v| v.is_finite())?;
        limits.check = self.check.unwrap_or(limits.check);
        let crossed = Axis::ALL.into_iter().find(|a| limits.low[*a] > limits.high[*a]);
        crossed.map_or(Ok(()), |axis| {
            Err(refused("limits.low", "at most limits.high", format!("more for {}", axis.letter())))
        })
    }
}

impl Io {
    fn apply(&self, s: &mut Settings) -> Result<(), ConfigError> {
        let io = &mut s.io;
        io.limits_active = self.limits_active.unwrap_or(io.limits_active);
        io.input4_normally_open = self.input4_normally_open.unwrap_or(io.input4_normally_open);
        set(&mut io.analog, self.analog, "io.analog", "0 to 5", |n| *n <= 5)?;
        if let Some(input) = self.interlock {
            let mut number = 0;
            set(&mut number, Some(input), "io.interlock", "1 to 12", |n| (1..=12).contains(n))?;
            io.interlock = Some(number);
        }
        set(&mut io.output4, self.output4, "io.output4", "-1 to -4", |n| (-4..=-1).contains(n))?;
        modes(&mut io.inputs, self.inputs.as_ref(), "io.inputs", "modes 0 to 4", 4)?;
        modes(&mut io.outputs, self.outputs.as_ref(), "io.outputs", "modes 0 to 5", 5)
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn what_is_named_is_set_and_the_rest_keeps_its_default() {
        let text = "units = \"mm\"\naxes = 4\n[speeds.cut]\nxy = 30.0\n[limits]\nlow = [-1, -2]\n\
            check = true\n[io]\ninputs = [0, 2]\noutput4 = -4\ninterlock = 12\n[steps]\nper_unit = [40]";
        let (s, d) = (settings(text).unwrap(), Settings::default());
        assert_eq!((s.linear_unit, s.axis_count), (LinearUnit::Mm, 4));
        assert_eq!((s.speeds.cut.xy, s.speeds.cut.z), (30.0, d.speeds.cut.z));
        assert_eq!((s.limits.low.0[1], s.limits.low.0[2]), (-2.0, d.limits.low.0[2]));
        assert_eq!((s.limits.check, s.io.inputs[1], s.io.output4), (true, 2, -4));
        assert_eq!((s.resolution.steps_per_unit.0[0], s.io.interlock), (40.0, Some(12)));
        assert_eq!(settings("").unwrap(), d);
    }

    #[test]
    fn the_example_of_the_book_is_a_configuration() {
        let page = include_str!("../../../../docs/book/machine.md");
        let example = page.split("```").nth(1).unwrap().trim_start_matches("toml");
        let s = settings(example).unwrap();
        assert_eq!((s.axis_count, s.warning_s, s.io.outputs[2]), (4, 2.0, 3));
        assert!(s.dynamics.is_some());
    }

    #[test]
    fn every_mistake_names_its_key() {
        for (text, part) in [
            ("unit = 3", "unknown field `unit`"),
            ("units = \"cm\"", "unknown variant `cm`"),
            ("axes = 7", "axes must be 1 to 6, not 7"),
            ("[speeds.cut]\nxy = 0", "speeds.cut.xy must be greater than 0, not 0"),
            ("[ramps]\ncut_rate_mm = inf", "ramps.cut_rate_mm must be greater than 0, not inf"),
            ("[limits]\nlow = [9e9]", "limits.low must be at most limits.high, not more for X"),
            ("[io]\ninterlock = 13", "io.interlock must be 1 to 12, not 13"),
            ("[io]\ninputs = [5]", "io.inputs must be modes 0 to 4, not 5"),
            ("[io]\noutputs = [0,0,0,0,0,0,0,0,0,0,0,0,0]", "io.outputs must be a shorter list"),
            ("[steps]\nper_unit = [nan]", "steps.per_unit must be greater than 0"),
            ("motion = \"fast\"", "unknown variant `fast`"),
            ("stack_limit = 0", "stack_limit must be 1 or greater, not 0"),
            ("axes = ", "TOML parse error"),
        ] {
            let error = settings(text).unwrap_err().to_string();
            assert!(error.contains(part), "{text}: {error}");
        }
    }
}
