//! The settings of the machine: one model, seen by the V commands, by the configuration file and by
//! everything that plans or drives.
//!
//! Lengths are millimetres, speeds mm/s or degrees/s, whatever unit the user has chosen: changing
//! the unit changes how they are shown, so there is no drift. The defaults are those of the OpenSBP
//! command reference where it gives one; the notes beside the others say so.

mod controller;
mod cutter;
mod io;
mod speeds;
mod table;
mod tool_change;
mod unit;
mod view;

pub use controller::{Controller, PORTS, SIM};
pub use cutter::{Cutter, PlungeSign, Tabs, ToolOffset, Trigger};
pub use io::{IoModes, LINES, SWITCHES, TorchHeight};
pub use speeds::{PerGroup, RAMP_SPEED_STEP_MM_S, Ramps, Speeds};
pub use table::{Driver, Limits, NO_SHIFT_JOG_MM_S, Resolution};
pub use tool_change::ToolChanges;
pub use unit::{AxisUnit, LinearUnit, MM_PER_INCH, to_user};
pub use view::{Display, View};

use crate::{Axes, Axis, Dynamics, RampModel, Smoothing};
use io::TORCH;
use serde::{Deserialize, Serialize};

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
    pub height: TorchHeight,
    pub driver: Driver,
    /// The controller's abilities and its connections.
    #[serde(default)]
    pub controller: Controller,
    pub tool_offset: ToolOffset,
    pub view: View,
    pub display: Display,
    pub resolution: Resolution,
    /// Warning before motion starts, seconds (SW).
    pub warning_s: f64,
    /// Starting the spindle from a program asks the operator first, unless it counts as active.
    #[serde(default = "yes")]
    pub ask_spindle: bool,
    /// M6 of G-code runs the owner's tool change, the custom cut C9.
    #[serde(default)]
    pub m6_runs_c9: bool,
    /// Where tools are changed and measured; from the machine's configuration.
    #[serde(default)]
    pub tool_changes: ToolChanges,
    /// A device takes the speeds that programs give spindles (TR); without one the operator sets them.
    #[serde(default = "yes")]
    pub spindle_device: bool,
    /// Limits of the axes; from the machine's configuration, no V command sets them.
    #[serde(default)]
    pub dynamics: Option<Dynamics>,
    /// Moves that the stack takes before the tool pulls up and the rest is read; no limit when not
    /// given. From the machine's configuration.
    #[serde(default)]
    pub stack_limit: Option<u32>,
    /// The model of motion; the configuration or an option names it.
    #[serde(default)]
    pub ramp_model: Option<RampModel>,
    /// Rounding of corners in the `profiler` model.
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

    /// Returns the limits of the axes, as far as they are known.
    pub fn axis_dynamics(&self) -> Dynamics {
        self.dynamics.unwrap_or_else(|| Dynamics::usual(&self.speeds))
    }

    /// Returns the unit in which the user measures an axis.
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
        let before = AxisUnit::Linear(std::mem::replace(&mut self.linear_unit, unit));
        for axis in self.rotary_units.iter_mut().filter(|axis| **axis == before) {
            *axis = AxisUnit::Linear(unit);
        }
    }

    /// Internal units (mm or degrees) in one user unit of an axis.
    pub const fn axis_scale(&self, axis: Axis) -> f64 {
        self.axis_unit(axis).scale()
    }

    /// Returns `true` while torch height is controlled: enabled in VN and switched on by VH.
    pub const fn torch_on(&self) -> bool {
        self.height.on && self.io.analog == TORCH
    }

    /// A position or distance of all axes in the user's units.
    pub fn to_user(&self, internal: Axes) -> Axes {
        Axes(std::array::from_fn(|i| to_user(internal.0[i], self.axis_scale(Axis::ALL[i]))))
    }
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
            speeds: Speeds::default(),
            ramps: Ramps::default(),
            cutter: Cutter::default(),
            tabs: Tabs::default(),
            limits: Limits::default(),
            io: IoModes::default(),
            height: TorchHeight::default(),
            driver: Driver::default(),
            controller: Controller::default(),
            tool_offset: ToolOffset::default(),
            view: View::default(),
            display: Display::default(),
            resolution: Resolution::default(),
            // The reference's 2 s before motion; headless runs set 0.
            warning_s: 0.0,
            ask_spindle: true,
            m6_runs_c9: false,
            tool_changes: ToolChanges::default(),
            spindle_device: true,
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
    fn lengths_read_back_in_the_unit_they_were_given() {
        let s = Settings::default();
        assert_eq!(
            s.to_user(Axes::xyz(3.0 * MM_PER_INCH, 0.25 * MM_PER_INCH, -MM_PER_INCH)).first3(),
            [3.0, 0.25, -1.0]
        );
    }
}
