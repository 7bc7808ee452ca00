//! The share that one board has in a machine of several: its own motors, switches and outputs, counted anew.

use super::{Driver, Pin, RegisterLink, Setup, SetupError};

/// A board's part of a setup. The lists name its things by their places in the whole, in the order of the part.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Share {
    /// What hangs on the board.
    pub setup: Setup,
    /// Motors.
    pub motors: Vec<usize>,
    /// Switches.
    pub switches: Vec<usize>,
    /// Outputs: those that go on and off, then those with a share of time.
    pub outputs: Vec<usize>,
    /// Voltages.
    pub voltages: Vec<usize>,
    /// Inputs that are looked at all the time.
    pub buttons: Vec<usize>,
    /// Wires to motor drivers.
    pub drivers: Vec<usize>,
}

/// Place of a thing of the machine in a list of a share.
pub fn own(list: &[usize], whole: usize) -> Option<usize> {
    list.iter().position(|it| *it == whole)
}

impl Setup {
    /// The shares of so many boards.
    ///
    /// # Errors
    ///
    /// Pins of one motor, or of one wire, are on two boards.
    pub fn shares(&self, boards: usize) -> Result<Vec<Share>, SetupError> {
        let motors = self.motors.iter().map(|motor| [&motor.step, &motor.dir]);
        let wires = self.drivers.iter().map(|wire| [&wire.rx, &wire.tx]);
        let buses = self.selects.iter().flat_map(|it| it.bus.iter().map(|pin| [&it.cs, pin]));
        let pairs = motors.chain(wires).chain(buses);
        if let Some([one, other]) = pairs.into_iter().find(|[a, b]| a.board != b.board) {
            return Err(SetupError::Split([one.name.clone(), other.name.clone()]));
        }
        Ok((0..boards).map(|board| self.share(board)).collect())
    }

    fn share(&self, board: usize) -> Share {
        let pin = |pin: &Pin| pin.board == board;
        let (motors, own_motors) = part(&self.motors, |motor| pin(&motor.step));
        let (switches, own_switches) = part(&self.switches, pin);
        let (outputs, own_outputs) = part(&self.outputs, |output| pin(&output.pin));
        let (pulsed, own_pulsed) = part(&self.pulsed, |output| pin(&output.pin));
        let (voltages, own_voltages) = part(&self.voltages, pin);
        let (buttons, own_buttons) = part(&self.buttons, pin);
        let (drivers, own_drivers) = part(&self.drivers, |wire| pin(&wire.rx));
        let (selects, own_selects) = part(&self.selects, |select| pin(&select.cs));
        let tuned = self.tuned.iter().filter_map(|driver| {
            let way = match driver.way {
                RegisterLink::Wire { wire, address } => {
                    RegisterLink::Wire { wire: own(&drivers, wire)?, address }
                }
                RegisterLink::Select(select) => RegisterLink::Select(own(&selects, select)?),
            };
            Some(Driver { way, ..driver.clone() })
        });
        let tuned = tuned.collect();
        let behind = self.outputs.len();
        Share {
            motors,
            outputs: outputs.into_iter().chain(pulsed.into_iter().map(|n| behind + n)).collect(),
            voltages,
            buttons,
            drivers,
            setup: Setup {
                motors: own_motors,
                away: self.away + self.switches.len() - switches.len(),
                switches: own_switches,
                outputs: own_outputs,
                pulsed: own_pulsed,
                voltages: own_voltages,
                buttons: own_buttons,
                drivers: own_drivers,
                selects: own_selects,
                tuned,
            },
            switches,
        }
    }
}

/// Places of the things that are a board's, and the things.
fn part<T: Clone>(all: &[T], is_own: impl Fn(&T) -> bool) -> (Vec<usize>, Vec<T>) {
    let own = all.iter().enumerate().filter(|(_, it)| is_own(it));
    own.map(|(n, it)| (n, it.clone())).unzip()
}
