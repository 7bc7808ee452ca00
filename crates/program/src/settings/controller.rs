//! The controller's abilities and its connections: from the machine's configuration, no V command
//! sets them.

use super::SWITCHES;
use super::table::Driver;
use serde::{Deserialize, Serialize};

/// Connections that VI chooses from.
pub const PORTS: usize = 16;

/// The name of the simulated machine among the connections.
pub const SIM: &str = "sim";

/// A controller.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct Controller {
    /// Outputs that it has, from 1 on.
    pub outputs: u8,
    /// It has PWM: power of a laser or a heater.
    pub pwm: bool,
    /// Axes can move beside the others (MI).
    pub independent: bool,
    /// Address of each port of VI: a serial device, a TCP address, or `sim`; blank is the simulated
    /// machine too.
    pub ports: [String; PORTS],
}

impl Default for Controller {
    fn default() -> Self {
        let ports = Default::default();
        Self { outputs: SWITCHES as u8, pwm: true, independent: true, ports }
    }
}

impl Controller {
    /// Returns the address of a port.
    pub fn address(&self, port: u8) -> &str {
        let address = self.ports.get(usize::from(port).wrapping_sub(1));
        address.map(|it| it.trim()).filter(|it| !it.is_empty()).unwrap_or(SIM)
    }

    /// Returns `true` if a port is that of the simulated machine.
    pub fn is_simulated(&self, port: u8) -> bool {
        self.address(port).eq_ignore_ascii_case(SIM)
    }
}

impl Driver {
    /// Baud of the connection; the codes of VI.
    pub const fn baud(&self) -> u32 {
        match self.speed_code {
            2 => 115_200,
            3 => 230_400,
            4 => 460_800,
            _ => 921_600,
        }
    }

    /// Describes the connection to the controller in words: `port 3, /dev/ttyUSB0, 460800 baud`.
    pub fn connection(&self, controller: &Controller) -> String {
        let (port, address) = (self.port, controller.address(self.port));
        if controller.is_simulated(port) {
            return format!("port {port}, {SIM}");
        }
        format!("port {port}, {address}, {} baud", self.baud())
    }
}
