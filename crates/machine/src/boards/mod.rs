//! Boards that are sold for printers, by name: which pin is at which plug.
//!
//! The table is `boards.toml`. A board fills the pins of a machine's file; whoever wires it goes through them once more,
//! because what hangs at a plug is known to nobody else.

mod read;

pub use read::{BoardsError, all};

use crate::settings::Configuration;
use crate::settings::drivers::Drivers;
use kerf_diag::did_you_mean;

/// A board and what is at its plugs, in the order of the table.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct KnownBoard {
    /// Its name, as people type it.
    pub name: String,
    /// Its maker's name for it.
    pub title: String,
    /// Chips with which it is sold, as their firmware names them at the beginning.
    pub chips: Vec<String>,
    /// The wire that all motor drivers share: receive and transmit.
    pub uart: Option<[String; 2]>,
    /// MISO, MOSI, SCK of motor drivers with chip selects.
    pub spi: Option<[String; 3]>,
    /// Plugs of motors.
    pub motors: Vec<MotorPlug>,
    /// Plugs of switches.
    pub ends: Vec<Plug>,
    /// Plugs of loads: fans first, heaters behind them.
    pub outputs: Vec<Plug>,
    /// A pin that is fit for the PWM of a spindle's speed.
    pub servo: Option<String>,
    /// An input for a probe or a touch plate.
    pub probe: Option<String>,
}

/// A plug with its pin.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Plug {
    /// The name that is printed beside it.
    pub name: String,
    /// Its pin.
    pub pin: String,
}

/// The plug of a motor, with the pins of its driver.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MotorPlug {
    /// The name that is printed beside it.
    pub name: String,
    /// Pin of the steps.
    pub step: String,
    /// Pin of the direction.
    pub dir: String,
    /// Pin that gives it current while it is low.
    pub enable: String,
    /// The way to the registers of its driver.
    pub wire: Wire,
    /// The driver, where it is soldered.
    pub driver: Option<String>,
    /// Its sense resistors, ohms, where they are not the usual ones of the driver.
    pub ohms: Option<f64>,
}

/// The way to the registers of a motor driver.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Wire {
    /// A pin of its own: its UART, or its chip select where the driver has SPI.
    Own(String),
    /// An address on the wire that all drivers share.
    Shared(u8),
    /// There is none: jumpers set the driver.
    None,
}

impl Default for Wire {
    fn default() -> Self {
        Self::Shared(0)
    }
}

/// Returns the board of a name.
///
/// # Errors
/// There is none; the message names the nearest.
pub fn named(name: &str) -> Result<KnownBoard, BoardsError> {
    let boards = all()?;
    let hint = || {
        let near = did_you_mean(name, boards.iter().map(|board| &*board.name));
        near.unwrap_or_else(|| "kerf machine boards lists them".into())
    };
    let found = boards.iter().find(|board| board.name.eq_ignore_ascii_case(name));
    found.cloned().ok_or_else(|| BoardsError::Unknown { name: name.to_owned(), hint: hint() })
}

impl KnownBoard {
    /// Returns `true` if a board that tells of this chip may be one.
    pub fn may_have(&self, chip: &str) -> bool {
        self.chips.iter().any(|own| chip.starts_with(&**own))
    }

    /// Fills the pins of a machine: its first three motors turn X, Y, Z, its first switches are their home switches, its
    /// loads are outputs 1 and up, its probe is input 1. Pins that stood there are replaced.
    pub fn fill(&self, machine: &mut Configuration) {
        let board = &mut machine.board;
        let driven = self.motors.iter().take(3);
        for (pins, motor) in board.motors.iter_mut().zip(driven.clone()) {
            *pins = format!("{} {}", motor.step, motor.dir);
        }
        board.enable =
            driven.map(|motor| format!("!{}", motor.enable)).collect::<Vec<_>>().join(", ");
        self.fill_drivers(&mut machine.drivers);
        let board = &mut machine.board;
        for (home, plug) in board.homes.iter_mut().zip(self.home_plugs()) {
            *home = format!("^{}", plug.pin);
        }
        let loads = self.outputs.iter().zip(1..);
        board.outputs =
            loads.map(|(plug, n)| format!("{n} {}", plug.pin)).collect::<Vec<_>>().join(", ");
        board.inputs = self.probe.as_ref().map(|pin| format!("1 ^{pin}")).unwrap_or_default();
    }

    /// Drivers that are soldered are known with their pins; their current is the motor's, so nobody knows it here.
    fn fill_drivers(&self, drivers: &mut Drivers) {
        drivers.spi = self.spi.as_ref().map(|pins| pins.join(" ")).unwrap_or_default();
        for (n, motor) in self.motors.iter().take(3).enumerate() {
            let Some(kind) = &motor.driver else { continue };
            let pins = match (&motor.wire, &self.uart) {
                (Wire::Own(pin), _) => pin.clone(),
                (Wire::Shared(address), Some([rx, tx])) => format!("{rx} {tx} {address}"),
                (Wire::Shared(_), None) | (Wire::None, _) => continue,
            };
            drivers.kinds[n] = format!("{kind} {pins}");
            drivers.ohms[n] = motor.ohms.unwrap_or_default();
        }
    }

    /// The plugs of the home switches of X, Y and Z: the first at the low end, where each axis has two.
    fn home_plugs(&self) -> impl Iterator<Item = &Plug> {
        self.ends.iter().filter(|plug| !plug.name.ends_with('+')).take(3)
    }

    /// Returns every pin of it, with a place each, as often as it is named.
    pub fn pins(&self) -> Vec<&str> {
        let motors = self.motors.iter().flat_map(|motor| {
            let own = match &motor.wire {
                Wire::Own(pin) => Some(pin),
                Wire::Shared(_) | Wire::None => None,
            };
            [&motor.step, &motor.dir, &motor.enable].into_iter().chain(own)
        });
        let plugs = self.ends.iter().chain(&self.outputs).map(|plug| &plug.pin);
        let wires =
            self.uart.iter().flat_map(|[rx, tx]| [Some(rx), Some(tx).filter(|tx| *tx != rx)]);
        let buses = wires.flatten().chain(self.spi.iter().flatten());
        let rest = buses.chain(&self.servo).chain(&self.probe);
        motors.chain(plugs).chain(rest).map(|pin| &**pin).collect()
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn a_pin_is_at_one_plug() {
        for board in all().unwrap() {
            let mut pins = board.pins();
            pins.sort_unstable();
            let twice = pins.windows(2).find(|pair| pair[0] == pair[1]);
            assert_eq!(twice, None, "{}", board.name);
        }
    }

    #[test]
    fn pins_have_the_form_of_their_chip() {
        for board in all().unwrap() {
            for chip in &board.chips {
                let fits = form(chip);
                let other = board.pins().into_iter().find(|pin| !fits(pin));
                assert_eq!(other, None, "{} {chip}", board.name);
            }
        }
    }

    /// Tells pins of a chip: `gpio0` to `gpio29`, `P0.0` to `P4.31`, `PA0` to `PI15`, `PA0` to `PL7` without a port I.
    fn form(chip: &str) -> fn(&str) -> bool {
        fn below(text: Option<&str>, most: u8) -> bool {
            text.is_some_and(|it| it.parse::<u8>().is_ok_and(|n| n < most && n.to_string() == it))
        }
        match chip {
            "rp2040" => |pin| below(pin.strip_prefix("gpio"), 30),
            it if it.starts_with("lpc") => |pin| {
                let (port, bit) = pin.split_once('.').unwrap_or_default();
                below(port.strip_prefix('P'), 5) && below(Some(bit), 32)
            },
            it if it.starts_with("stm32") => |pin| {
                let port = pin.strip_prefix('P').unwrap_or_default();
                port.starts_with(|it| ('A'..='I').contains(&it)) && below(port.get(1..), 16)
            },
            "atmega2560" => |pin| {
                let port = pin.strip_prefix('P').unwrap_or_default();
                port.starts_with(|it| ('A'..='L').contains(&it) && it != 'I')
                    && below(port.get(1..), 8)
            },
            other => panic!("{other} is a chip of no known form"),
        }
    }

    #[test]
    fn boards_are_told_apart_and_have_three_motors() {
        let boards = all().unwrap();
        assert!(boards.len() >= 20);
        for (n, board) in boards.iter().enumerate() {
            assert!(board.motors.len() >= 3 && !board.ends.is_empty(), "{}", board.name);
            assert!(boards[..n].iter().all(|it| it.name != board.name), "{}", board.name);
        }
    }

    #[test]
    fn drivers_on_one_wire_have_an_address_each() {
        for board in all().unwrap() {
            let shared = board.motors.iter().filter_map(|motor| match motor.wire {
                Wire::Shared(address) => Some(address),
                Wire::Own(_) | Wire::None => None,
            });
            let mut seen: Vec<u8> = shared.collect();
            assert_eq!(board.uart.is_some(), !seen.is_empty(), "{}", board.name);
            seen.sort_unstable();
            assert!(seen.windows(2).all(|it| it[0] < it[1]) && seen.iter().all(|it| *it < 4));
        }
    }

    #[test]
    fn a_board_fills_the_pins_of_a_machine() {
        let mut machine = Configuration::default();
        named("SKR-Pico").unwrap().fill(&mut machine);
        let board = &machine.board;
        assert_eq!(board.motors[..3], ["gpio11 gpio10", "gpio6 gpio5", "gpio19 gpio28"]);
        assert_eq!(board.motors[3], "");
        assert_eq!(board.enable, "!gpio12, !gpio7, !gpio2");
        assert_eq!(board.homes[..3], ["^gpio4", "^gpio3", "^gpio25"]);
        assert!(board.outputs.starts_with("1 gpio17, 2 gpio18"), "{}", board.outputs);
        assert_eq!(board.inputs, "1 ^gpio22");
        let kinds = &machine.drivers.kinds;
        assert_eq!(kinds[..2], ["tmc2209 gpio9 gpio8 0", "tmc2209 gpio9 gpio8 2"]);
        named("spider-1.1").unwrap().fill(&mut machine);
        assert_eq!(machine.board.homes[..3], ["^PB14", "^PB13", "^PA0"], "minus ends");
        assert_eq!(machine.board.inputs, "");
        named("ramps-1.4").unwrap().fill(&mut machine);
        assert_eq!(machine.board.motors[..3], ["PF0 PF1", "PF6 PF7", "PL3 PL1"]);
        assert_eq!(machine.board.homes[..3], ["^PE5", "^PJ1", "^PD3"]);
        named("kraken").unwrap().fill(&mut machine);
        assert_eq!(machine.drivers.kinds[0], "tmc5160 PD6");
        assert_eq!((&*machine.drivers.spi, machine.drivers.ohms[0]), ("PC7 PC8 PC6", 0.022));
    }

    #[test]
    fn chips_are_known_by_the_beginning_of_their_names() {
        let octopus = named("octopus-1.1").unwrap();
        assert!(octopus.may_have("stm32f446xx") && octopus.may_have("stm32f407xx"));
        assert!(!octopus.may_have("stm32h723xx"));
    }

    #[test]
    fn the_nearest_name_is_told() {
        let why = named("skr-pic").unwrap_err().to_string();
        assert!(why.contains("skr-pico"), "{why}");
    }
}
