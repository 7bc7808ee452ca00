//! Modes of inputs and outputs, torch height, laser and heater (VN, SO 4, VH).

use crate::Host;
use serde::{Deserialize, Serialize};

/// Inputs and outputs a machine has.
pub const SWITCHES: usize = 12;

/// Inputs and outputs a machine has: the switches, and two ports of eight lines each behind them
/// that only jobs use. `kerf-machine` names the lines of the ports.
pub const LINES: usize = SWITCHES + 16;

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

impl Default for IoModes {
    fn default() -> Self {
        Self {
            limits_active: true,
            input4_normally_open: false,
            analog: 0,
            inputs: [0; SWITCHES],
            outputs: [0; SWITCHES],
            output4: -1,
            interlock: None,
        }
    }
}

impl IoModes {
    /// The inputs that stop motion and forbid it.
    pub fn stop_inputs(&self) -> impl Iterator<Item = u8> + use<> {
        let modes = self.inputs;
        let by_mode = (1..=SWITCHES as u8)
            .filter(move |n| *n == 4 || matches!(modes[usize::from(*n) - 1], 3 | 4));
        by_mode.chain(self.interlock)
    }

    /// Returns `true` if an input that reads this stops motion and forbids it: the emergency stop when it
    /// is pressed, the enclosure when it is open, stop inputs by their modes.
    pub fn stops(&self, number: u8, reads: bool) -> bool {
        let mode = self.inputs.get(usize::from(number).wrapping_sub(1));
        match mode {
            _ if number == 4 || self.interlock == Some(number) => reads,
            Some(3) => reads,
            Some(4) => !reads,
            _ => false,
        }
    }

    /// Returns `true` if any stop input is active.
    pub fn stop_is_active(&self, host: &mut dyn Host) -> bool {
        self.stop_inputs().any(|number| self.stops(number, host.input(number)))
    }
}

/// Torch height, laser and heater (VH).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct TorchHeight {
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

impl Default for TorchHeight {
    fn default() -> Self {
        Self {
            on: false,
            rate: 0.25,
            low_percent: 0.0,
            high_percent: 0.0,
            frequency_khz: 5.4,
            low_cycle: 3.0,
            temperature: 0.0,
        }
    }
}

/// [`IoModes::analog`] for torch height (readings, A-100).
pub(super) const TORCH: u8 = 1;
