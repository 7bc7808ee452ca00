//! The settings of the machine: one model, seen by the V commands, by the configuration file and by
//! everything that plans or drives.
//!
//! Lengths are millimetres, speeds mm/s or degrees/s, whatever unit the user has chosen: changing
//! the unit changes how they are shown, so there is no drift. The defaults are those of the OpenSBP
//! command reference where it gives one; the notes beside the others say so.

use crate::{AXES, Axes, Axis, Dynamics, RampModel, Smoothing};
use serde::{Deserialize, Serialize};

/// Millimetres in an inch.
pub const MM_PER_INCH: f64 = 25.4;

/// Inputs and outputs a machine has.
pub const SWITCHES: usize = 12;

/// The unit a person types and reads lengths in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum LinearUnit {
    /// Inches, the manuals' default.
    #[default]
    Inch,
    /// Millimetres.
    Mm,
}

impl LinearUnit {
    /// Millimetres in one unit.
    pub const fn mm(self) -> f64 {
        match self {
            Self::Inch => MM_PER_INCH,
            Self::Mm => 1.0,
        }
    }

    /// `in` or `mm`.
    pub const fn symbol(self) -> &'static str {
        match self {
            Self::Inch => "in",
            Self::Mm => "mm",
        }
    }
}

/// What an axis is measured in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum AxisUnit {
    /// A length, shown in this unit.
    Linear(LinearUnit),
    /// Degrees, never converted.
    Degrees,
}

impl AxisUnit {
    /// Internal units (mm or degrees) in one unit of the user.
    pub const fn scale(self) -> f64 {
        match self {
            Self::Linear(unit) => unit.mm(),
            Self::Degrees => 1.0,
        }
    }
}

/// SA or SR.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Distance {
    /// Values are locations.
    #[default]
    Absolute,
    /// Values are distances from the present location.
    Relative,
}

/// SM or SP.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Mode {
    /// Commands drive the tool.
    #[default]
    Move,
    /// Commands are only drawn.
    Preview,
}

/// One value for XY together and one for each other axis, as VS and VR list them.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[allow(missing_docs)]
pub struct PerGroup {
    pub xy: f64,
    pub z: f64,
    pub a: f64,
    pub b: f64,
    pub c: f64,
}

impl PerGroup {
    /// The same value everywhere.
    pub const fn splat(v: f64) -> Self {
        Self { xy: v, z: v, a: v, b: v, c: v }
    }

    /// The value that holds for an axis.
    pub const fn of(&self, axis: Axis) -> f64 {
        match axis {
            Axis::X | Axis::Y => self.xy,
            Axis::Z => self.z,
            Axis::A => self.a,
            Axis::B => self.b,
            Axis::C => self.c,
        }
    }

    /// The place of the value that holds for an axis.
    pub const fn of_mut(&mut self, axis: Axis) -> &mut f64 {
        match axis {
            Axis::X | Axis::Y => &mut self.xy,
            Axis::Z => &mut self.z,
            Axis::A => &mut self.a,
            Axis::B => &mut self.b,
            Axis::C => &mut self.c,
        }
    }
}

/// Speeds (VS, MS, JS): XY is the vector speed of the tool tip, mm/s; rotary axes degrees/s.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Speeds {
    /// Move speeds.
    pub cut: PerGroup,
    /// Jog speeds.
    pub jog: PerGroup,
}

/// Ramps (VR).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Ramps {
    /// Speed at which moves start and end, mm/s.
    pub cut: PerGroup,
    /// Speed at which jogs start and end, mm/s.
    pub jog: PerGroup,
    /// Distance of a move for a gain of [`RAMP_SPEED_STEP_MM_S`] from ramp speed, mm.
    pub cut_rate_mm: f64,
    /// The same for jogs.
    pub jog_rate_mm: f64,
    /// Sensitivity of 3D ramping, percent.
    pub threshold_3d_percent: f64,
    /// Path length over which changes of direction are summed, mm.
    pub min_distance_mm: f64,
    /// Speed at a corner just at the criterion, percent of the speed.
    pub slow_corner_percent: f64,
    /// Ramp rate in keypad mode, mm.
    pub keypad_rate_mm: f64,
    /// Circles of a smaller diameter run at ramp speed, mm.
    pub small_circle_mm: f64,
}

/// The gain of speed that the ramp rate speaks of: 2 in/s (command reference, VR).
pub const RAMP_SPEED_STEP_MM_S: f64 = 2.0 * MM_PER_INCH;

impl Ramps {
    /// Acceleration of a ramp that starts at `ramp_mm_s` with this rate, mm/s².
    ///
    /// From the ramp speed v0 to v0+2 in the distance of the rate: a = ((v0+2)² − v0²)/(2·rate).
    pub fn acceleration_mm_s2(ramp_mm_s: f64, rate_mm: f64) -> f64 {
        let top = ramp_mm_s + RAMP_SPEED_STEP_MM_S;
        (top * top - ramp_mm_s * ramp_mm_s) / (2.0 * rate_mm)
    }
}

/// The sign of a plunge that goes down.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum PlungeSign {
    /// Negative is down.
    #[default]
    Minus,
    /// Positive is down: Z counts downwards.
    Plus,
}

/// The output that Z or A switches (VC 8-12).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Trigger {
    /// Whether it is active; ends with the part file.
    pub active: bool,
    /// ON when passing this working location downwards, mm.
    pub on_at_mm: f64,
    /// OFF when passing this working location upwards, mm.
    pub off_at_mm: f64,
    /// Z or A.
    pub axis: Axis,
    /// Output number.
    pub output: u8,
}

/// Cutter values (VC).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Cutter {
    /// Cutter diameter, mm.
    pub diameter_mm: f64,
    /// Height for MH, JH and travel; `None` when turned off.
    pub safe_z_mm: Option<f64>,
    /// Height of the A axis for MH and JH.
    pub safe_a_mm: f64,
    /// Which sign plunges down.
    pub plunge: PlungeSign,
    /// Overlap of pocket rings, percent.
    pub pocket_overlap_percent: f64,
    /// The triggered output.
    pub trigger: Trigger,
}

/// Tabs (VB).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Tabs {
    /// Thickness of a tab, mm.
    pub up_mm: f64,
    /// Path between tabs, mm.
    pub next_mm: f64,
    /// Length of the flat top, mm.
    pub size_mm: f64,
    /// Length of each incline along the path, mm.
    pub lead_mm: f64,
    /// On inside a file.
    pub on: bool,
    /// Insert so many, then stop.
    pub count: Option<u32>,
    /// Path to the first tab when not `next_mm`.
    pub start_mm: Option<f64>,
}

/// Table limits in table base coordinates (VL, SF).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Limits {
    /// Lowest values.
    pub low: Axes,
    /// Highest values.
    pub high: Axes,
    /// Whether they are checked.
    pub check: bool,
}

/// Modes of inputs and outputs (VN, SO 4).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct IoModes {
    /// Limit inputs stop motion.
    pub limits_active: bool,
    /// Input 4 is a normally open stop.
    pub input4_normally_open: bool,
    /// 0 none, 1 torch, 2 laser, 3 analog 1, 4 analog 2, 5 both.
    pub analog: u8,
    /// 0 standard, 1 NO limit, 2 NC limit, 3 NO stop, 4 NC stop; index 0 is input 1.
    pub inputs: [u8; SWITCHES],
    /// 0 … 5 as VN lists them; index 0 is output 1.
    pub outputs: [u8; SWITCHES],
    /// Mode of output 4, −1 … −4.
    pub output4: i8,
    /// Input that is ON while the enclosure is open; from the machine's configuration.
    #[serde(default)]
    pub interlock: Option<u8>,
}

/// Torch height, laser and heater (VH).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Height {
    /// On or off.
    pub on: bool,
    /// Share of the XY speed used for Z.
    pub rate: f64,
    /// PWM at rest, percent.
    pub low_percent: f64,
    /// PWM at full speed, percent.
    pub high_percent: f64,
    /// Pulse frequency, kHz.
    pub frequency_khz: f64,
    /// Low cycle time, 1 … 10.
    pub low_cycle: f64,
    /// Set temperature.
    pub temperature: f64,
}

/// Driver (VI).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Driver {
    /// Port slot 1 … 16.
    pub port: u8,
    /// Axis of each driver channel.
    pub channels: [Axis; AXES],
    /// Speed code: 2 115.2, 3 230.4, 4 460.8, 5 921.6 kbaud.
    pub speed_code: u8,
    /// Steps and outputs are given.
    pub enabled: bool,
}

/// Temporary tool offset (VO).
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ToolOffset {
    /// In force.
    pub on: bool,
    /// The offsets; they add to the commanded axes.
    pub offset: Axes,
}

/// The preview's view (VP).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct View {
    /// Line spacing of the grid, mm.
    pub grid_mm: f64,
    /// Table size X, Y, Z, mm.
    pub table_mm: [f64; 3],
    /// Animate cutting.
    pub simulate: bool,
    /// Draw the cutter.
    pub draw_tool: bool,
    /// Start at the tool's location, else at 0,0.
    pub start_actual: bool,
    /// Draw jogs.
    pub show_jogs: bool,
}

/// Display values (VD).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Display {
    /// Show the control console (obsolete field 6).
    pub console: bool,
    /// Show file comments in the message screen.
    pub comments: bool,
    /// Tap distance of the keypad, mm.
    pub keypad_fixed_mm: f64,
    /// 0 mouse, 1 pendant on inputs, 2 other.
    pub keypad_remote: u8,
    /// Write the part file log.
    pub part_log: bool,
    /// Write the system log.
    pub system_log: bool,
    /// Message screen X, Y, width, height in twips (1/1440 in).
    pub message_twips: [f64; 4],
    /// Turn outputs off when the keypad closes.
    pub keypad_auto_off: bool,
    /// Show file progress.
    pub progress: bool,
    /// EASY interface, else FULL.
    pub easy: bool,
}

/// Unit values and resolution (VU).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Resolution {
    /// Steps per mm or per degree.
    pub steps_per_unit: Axes,
    /// Circle segment length, mm.
    pub circle_mm: f64,
    /// Resolution multipliers during jogs.
    pub multipliers: [u8; AXES],
    /// Step interval divider 1 … 100.
    pub divider: u8,
    /// Resolution shifting disabled: jogs reach [`NO_SHIFT_JOG_MM_S`] at most.
    pub no_shift: bool,
}

/// Top jog speed with resolution shifting disabled: 16 in/s (command reference, VU).
pub const NO_SHIFT_JOG_MM_S: f64 = 16.0 * MM_PER_INCH;

/// VN field 3: torch height (notes A-100).
const TORCH: u8 = 1;

/// All settings.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[allow(missing_docs)]
pub struct Settings {
    pub linear_unit: LinearUnit,
    pub axis_count: u8,
    /// Units of A, B and C.
    pub rotary_units: [AxisUnit; 3],
    pub distance: Distance,
    pub mode: Mode,
    pub speeds: Speeds,
    pub ramps: Ramps,
    pub cutter: Cutter,
    pub tabs: Tabs,
    pub limits: Limits,
    pub io: IoModes,
    pub height: Height,
    pub driver: Driver,
    pub tool_offset: ToolOffset,
    pub view: View,
    pub display: Display,
    pub resolution: Resolution,
    /// Warning before motion starts, seconds (SW).
    pub warning_s: f64,
    /// Starting the spindle from a program asks the operator first, unless it counts as active.
    #[serde(default = "yes")]
    pub ask_spindle: bool,
    /// What the axes can do; from the machine's configuration, no V command sets it.
    #[serde(default)]
    pub dynamics: Option<Dynamics>,
    /// Moves that the stack takes before the tool pulls up and the rest is read; no limit when not
    /// given. From the machine's configuration.
    #[serde(default)]
    pub stack_limit: Option<u32>,
    /// The model of motion; the configuration or an option names it.
    #[serde(default)]
    pub ramp_model: Option<RampModel>,
    /// How the `profiler` model goes round corners.
    #[serde(default)]
    pub smoothing: Smoothing,
}

const fn yes() -> bool {
    true
}

impl Settings {
    /// The model of motion in force: the one that is named; without a name `optimal` where it is
    /// known what the axes can do, else the ramps of VR.
    pub fn model(&self) -> RampModel {
        let usual = if self.dynamics.is_some() { RampModel::Optimal } else { RampModel::Shopbot };
        self.ramp_model.unwrap_or(usual)
    }

    /// What the axes can do, as far as it is known.
    pub fn axis_dynamics(&self) -> Dynamics {
        self.dynamics.unwrap_or_else(|| Dynamics::usual(&self.speeds))
    }

    /// What the user measures an axis in.
    pub const fn axis_unit(&self, axis: Axis) -> AxisUnit {
        match axis {
            Axis::X | Axis::Y | Axis::Z => AxisUnit::Linear(self.linear_unit),
            Axis::A => self.rotary_units[0],
            Axis::B => self.rotary_units[1],
            Axis::C => self.rotary_units[2],
        }
    }

    /// Changes the user's linear unit; linear rotary axes follow.
    pub fn use_linear_unit(&mut self, unit: LinearUnit) {
        self.linear_unit = unit;
        for axis in &mut self.rotary_units {
            if let AxisUnit::Linear(linear) = axis {
                *linear = unit;
            }
        }
    }

    /// Internal units (mm or degrees) in one user unit of an axis.
    pub const fn axis_scale(&self, axis: Axis) -> f64 {
        self.axis_unit(axis).scale()
    }

    /// Whether torch height is controlled now: enabled in VN and switched on by VH.
    pub const fn torch_on(&self) -> bool {
        self.height.on && self.io.analog == TORCH
    }

    /// A position or distance of all axes in the user's units.
    pub fn to_user(&self, internal: Axes) -> Axes {
        Axes(std::array::from_fn(|i| to_user(internal.0[i], self.axis_scale(Axis::ALL[i]))))
    }
}

/// An internal value in a user unit of `scale` internal units.
///
/// The decimal that converts back to this value, give or take the last bit, is taken where there
/// is one, so that 3 in is read back as 3 and not as 2.9999999999999996, and as 76.2 in mm.
pub fn to_user(internal: f64, scale: f64) -> f64 {
    let quotient = internal / scale;
    let decimal = (quotient * 1e9).round() / 1e9;
    if (decimal * scale - internal).abs() <= 2.0 * f64::EPSILON * internal.abs() {
        decimal
    } else {
        quotient
    }
}

const fn inch(v: f64) -> f64 {
    v * MM_PER_INCH
}

impl Default for Settings {
    /// The fresh state of the command reference: inches, 3 axes, standard tool.
    fn default() -> Self {
        Self {
            linear_unit: LinearUnit::Inch,
            axis_count: 3,
            rotary_units: [
                AxisUnit::Linear(LinearUnit::Inch),
                AxisUnit::Degrees,
                AxisUnit::Degrees,
            ],
            distance: Distance::Absolute,
            mode: Mode::Move,
            // The manual leaves speeds to the tool; these are Kerf's own for a mid-size router.
            speeds: Speeds {
                cut: PerGroup { xy: inch(2.0), z: inch(1.0), a: inch(1.0), b: 30.0, c: 30.0 },
                jog: PerGroup { xy: inch(6.0), z: inch(3.0), a: inch(3.0), b: 60.0, c: 60.0 },
            },
            ramps: Ramps {
                cut: PerGroup { b: 0.4, c: 0.4, ..PerGroup::splat(inch(0.4)) },
                jog: PerGroup { b: 0.4, c: 0.4, ..PerGroup::splat(inch(0.4)) },
                cut_rate_mm: inch(0.2),
                jog_rate_mm: inch(0.2),
                threshold_3d_percent: 100.0,
                min_distance_mm: inch(0.15),
                slow_corner_percent: 65.0,
                keypad_rate_mm: inch(0.2),
                small_circle_mm: inch(0.25),
            },
            cutter: Cutter {
                diameter_mm: inch(0.25),
                safe_z_mm: Some(inch(1.0)),
                safe_a_mm: inch(1.0),
                plunge: PlungeSign::Minus,
                pocket_overlap_percent: 10.0,
                trigger: Trigger {
                    active: false,
                    on_at_mm: 0.0,
                    off_at_mm: 0.0,
                    axis: Axis::Z,
                    output: 8,
                },
            },
            tabs: Tabs {
                up_mm: inch(0.1),
                next_mm: inch(4.0),
                size_mm: inch(1.0),
                lead_mm: inch(0.5),
                on: false,
                count: None,
                start_mm: None,
            },
            limits: Limits {
                low: Axes([0.0, 0.0, inch(-6.0), inch(-6.0), -360.0, -360.0]),
                high: Axes([inch(96.0), inch(48.0), inch(6.0), inch(6.0), 360.0, 360.0]),
                check: false,
            },
            io: IoModes {
                limits_active: true,
                input4_normally_open: false,
                analog: 0,
                inputs: [0; SWITCHES],
                outputs: [0; SWITCHES],
                output4: -1,
                interlock: None,
            },
            height: Height {
                on: false,
                rate: 0.25,
                low_percent: 0.0,
                high_percent: 0.0,
                frequency_khz: 5.4,
                low_cycle: 3.0,
                temperature: 0.0,
            },
            driver: Driver { port: 1, channels: Axis::ALL, speed_code: 5, enabled: true },
            tool_offset: ToolOffset::default(),
            view: View {
                grid_mm: inch(6.0),
                table_mm: [inch(96.0), inch(48.0), inch(6.0)],
                simulate: false,
                draw_tool: true,
                start_actual: true,
                show_jogs: true,
            },
            display: Display {
                console: true,
                comments: false,
                keypad_fixed_mm: inch(0.1),
                keypad_remote: 0,
                part_log: true,
                system_log: true,
                message_twips: [0.0, 0.0, 8800.0, 4600.0],
                keypad_auto_off: false,
                progress: false,
                easy: true,
            },
            resolution: Resolution {
                steps_per_unit: Axes([
                    400.0 / MM_PER_INCH,
                    400.0 / MM_PER_INCH,
                    400.0 / MM_PER_INCH,
                    400.0 / MM_PER_INCH,
                    5000.0 / 360.0,
                    5000.0 / 360.0,
                ]),
                circle_mm: inch(0.05),
                multipliers: [1; AXES],
                divider: 1,
                no_shift: false,
            },
            // The reference's 2 s before motion; headless runs set 0.
            warning_s: 0.0,
            ask_spindle: true,
            dynamics: None,
            stack_limit: None,
            ramp_model: None,
            smoothing: Smoothing::default(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ramp_of_the_manual_is_14_inches_per_second_squared() {
        let a = Ramps::acceleration_mm_s2(inch(0.4), inch(0.2));
        assert!((a / MM_PER_INCH - 14.0).abs() < 1e-9);
    }

    #[test]
    fn lengths_read_back_in_the_unit_they_were_given() {
        let s = Settings::default();
        assert_eq!(
            s.to_user(Axes::xyz(inch(1.0), inch(0.25), inch(-3.0))).first3(),
            [1.0, 0.25, -3.0]
        );
    }
}
