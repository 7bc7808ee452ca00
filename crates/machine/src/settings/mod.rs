//! The settings of a machine, an area a file.

pub mod axes;
pub mod board;
mod choices;
pub mod delays;
pub mod drivers;
pub mod estop;
pub mod height;
pub mod homing;
pub mod intensity;
pub mod io;
pub mod job;
pub mod laser;
pub mod misc;
pub mod motors;
pub mod options;
pub mod pause;
pub mod pendant;
pub mod plasma;
pub mod simulated;
pub mod speeds;

pub(crate) use choices::Words;
use choices::words;

use crate::lines::Input;
use kerf_program::job::Heights;
use kerf_program::{Axis, Settings, rounded};

/// Everything that is set of one machine.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Configuration {
    /// Settings that part files see: units, speeds, ramps, limits, modes of switches, steps, dynamics and the
    /// smoothing of paths. The V commands are views of it.
    pub program: Settings,
    /// Lengths and soft bounds.
    pub axes: axes::AxisSettings,
    /// Which motor drives what, and how it is pulsed.
    pub motors: motors::Motors,
    /// Special heights of Z.
    pub zpos: Heights,
    /// Speeds of plunging and of moving by hand.
    pub speeds: speeds::MachineSpeeds,
    /// Waits in the cutting sequence.
    pub delays: delays::Delays,
    /// Effects of pausing.
    pub pause: pause::Pause,
    /// Which inputs are keys of a pendant.
    pub pendant: pendant::Pendant,
    /// Levels of the inputs and the card they come from.
    pub io: io::IoMap,
    /// The intensity output.
    pub intensity: intensity::Intensity,
    /// Automatic height control.
    pub height: height::HeightControl,
    /// The plasma start sequence.
    pub plasma: plasma::Plasma,
    /// Laser and piercing.
    pub laser: laser::Laser,
    /// Homing of each axis.
    pub homing: homing::Homing,
    /// The emergency stop.
    pub estop: estop::EmergencyStop,
    /// Settings that belong nowhere else.
    pub misc: misc::Miscellaneous,
    /// Start, place and repetition of jobs.
    pub job: job::JobSettings,
    /// Options of the program beside the machine.
    pub options: options::Options,
    /// Pins of a board with step queues.
    pub board: board::Board,
    /// Motor drivers with registers on such a board.
    pub drivers: drivers::Drivers,
    /// Switches, start place and delays of the simulated machine.
    pub simulated: simulated::Simulated,
}

impl Configuration {
    /// The device of a serial port, 1 … 4.
    pub fn device(&self, port: u8) -> Option<&str> {
        let port = usize::from(port).checked_sub(1)?;
        self.options.devices.get(port).map(String::as_str)
    }

    /// Returns the name of an input on this machine, where that is not its usual name.
    pub fn name_in_use(&self, input: Input) -> Option<&'static str> {
        match input {
            Input::EndBottomDelay if self.plasma.use_sequence => Some("arc"),
            Input::WHome if self.plasma.use_sequence => Some("too_close"),
            Input::WHome if self.job.external_start => Some("door"),
            _ => None,
        }
    }

    /// Returns advice on a setting of this very machine, where there is some.
    pub fn advice(&self, key: &str) -> Option<String> {
        match key {
            "height.k" => {
                let steps = self.program.resolution.steps_per_unit[Axis::Z];
                let k = self.height.suggested_k(steps);
                Some(format!(
                    "{} suits this Z axis, half of it is {}",
                    rounded(k, 3),
                    rounded(0.5 * k, 3)
                ))
            }
            "height.port" => self.device(self.height.port).map(str::to_owned),
            "options.console_port" => self.device(self.options.console_port).map(str::to_owned),
            "options.send_port" => self.device(self.options.send_port).map(str::to_owned),
            _ => None,
        }
    }

    /// Returns the time that a step output is on: one output delay of the machine and what the step delay adds,
    /// nanoseconds ("Microstepping Drive Parameters").
    pub const fn step_pulse_ns(&self) -> u32 {
        self.simulated.output_delay_ns.saturating_add(self.motors.step_delay_ns)
    }
}
