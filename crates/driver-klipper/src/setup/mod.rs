//! What hangs on a board: motors, switches, outputs, inputs, as the commands that configure it.
//!
//! A board keeps one configuration from power-up to reset, with a check number that means nothing to it. Kerf's is
//! made of the configuration's text, so a board that was configured by someone else, or otherwise, is known by its
//! number.

mod driver;
mod needs;
mod pins;
mod share;

pub use driver::{Driver, DriverSelect, DriverWire, RegisterLink};
pub use pins::{Pin, Pull};
pub use share::{Share, own};

use crate::dictionary::{Dictionary, DictionaryError};
use crate::orders::{Order, OrderError, Orders};
use crate::tmc::spi;
use pins::{Look, Pins};

/// Version of the way in which objects are numbered.
const VERSION: &str = "kerf 1";

/// Rates of clocks that are believed, ticks a second: those of boards are 12 to 520 million.
const FREQUENCIES: std::ops::RangeInclusive<f64> = 1e5..=1e10;

/// A motor with step and direction.
#[derive(Clone, Debug, PartialEq)]
pub struct Motor {
    /// Pin of the steps.
    pub step: Pin,
    /// Pin of the direction; inverted where the motor turns the other way.
    pub dir: Pin,
    /// Least width of a pulse, seconds.
    pub pulse_s: f64,
    /// Time that the driver needs between direction and step, seconds.
    pub turn_s: f64,
    /// Each edge is a step: the driver is told so, and the board can.
    pub both_edges: bool,
    /// Least time between two steps that the board and the driver keep up with, seconds.
    pub least_s: f64,
}

/// An output that goes on and off.
#[derive(Clone, Debug, PartialEq)]
pub struct Switched {
    /// Its pin.
    pub pin: Pin,
    /// The board shuts down when it was on for so long without being told again, seconds; none where it is no danger.
    pub watch_s: Option<f64>,
}

/// An output with a share of time.
#[derive(Clone, Debug, PartialEq)]
pub struct Pulsed {
    /// Its pin.
    pub pin: Pin,
    /// Length of a cycle, seconds.
    pub cycle_s: f64,
    /// As of a [`Switched`] one.
    pub watch_s: Option<f64>,
}

/// Everything that hangs on a board. The objects of the board count up in this order; its latches are the last.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Setup {
    /// Motors.
    pub motors: Vec<Motor>,
    /// Switches that stop motors: limits, homes, probes.
    pub switches: Vec<Pin>,
    /// Outputs that go on and off.
    pub outputs: Vec<Switched>,
    /// Outputs with a share of time.
    pub pulsed: Vec<Pulsed>,
    /// Voltages.
    pub voltages: Vec<Pin>,
    /// Inputs that are looked at all the time, at most eight.
    pub buttons: Vec<Pin>,
    /// Wires to motor drivers.
    pub drivers: Vec<DriverWire>,
    /// Chip selects of motor drivers.
    pub selects: Vec<DriverSelect>,
    /// Motor drivers whose registers are set, behind those wires and selects.
    pub tuned: Vec<Driver>,
    /// Switches on other boards that may stop motors of this one.
    pub away: usize,
}

/// The reason for which a setup does not fit a board.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SetupError {
    /// The board lacks a pin or a command, or a value is out of bounds.
    #[error(transparent)]
    Order(#[from] OrderError),
    /// The board lacks an answer, or a field of it.
    #[error(transparent)]
    Answer(#[from] DictionaryError),
    /// A pin has two tasks.
    #[error("pin `{0}` is used twice: give each motor, switch and output pins of its own")]
    Twice(String),
    /// Two pins that belong together are on two boards.
    #[error("pins `{}` and `{}` are on two boards: step and direction of a motor, or both ends of a wire, go to one", .0[0], .0[1])]
    Split([String; 2]),
    /// The board needs a pin for itself.
    #[error("pin `{pin}` is used by the board itself ({by}): take another one")]
    Reserved {
        /// The pin.
        pin: String,
        /// Name of the board's use.
        by: String,
    },
    /// Too many things.
    #[error("a board can have {most} {what}, not {count}")]
    Many {
        /// Kind of thing.
        what: &'static str,
        /// Most of them.
        most: usize,
        /// The number.
        count: usize,
    },
    /// Both edges are asked of a board that steps on one.
    #[error("this board cannot step on both edges: set one edge, and a pulse that the driver sees")]
    BothEdges,
    /// The board does not tell how fast its clock is.
    #[error("the board does not tell the rate of its clock: flash its firmware anew")]
    Frequency,
}

/// A setup as commands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Configured {
    /// The commands in their order, without the last one that carries the check number.
    pub commands: Vec<Vec<u8>>,
    /// The check number.
    pub crc: u32,
}

/// Objects of a setup by their kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Object {
    /// A motor.
    Motor(usize),
    /// A switch.
    Switch(usize),
    /// An output.
    Output(usize),
    /// An output with a share of time.
    Pulsed(usize),
    /// A voltage.
    Voltage(usize),
    /// The row of inputs.
    Buttons,
    /// A wire to motor drivers.
    Driver(usize),
    /// A chip select of a motor driver.
    Select(usize),
    /// A latch: the one over all motion, then one for each switch.
    Latch(usize),
}

impl Setup {
    /// Number of its latches: one over all motion, one for each switch that may stop motors.
    pub fn latches(&self) -> usize {
        1 + self.switches.len() + self.away
    }

    /// Number of an object in the board.
    pub fn oid(&self, object: Object) -> u32 {
        let rows = [
            self.motors.len(),
            self.switches.len(),
            self.outputs.len(),
            self.pulsed.len(),
            self.voltages.len(),
            usize::from(!self.buttons.is_empty()),
            self.drivers.len(),
            self.selects.len(),
        ];
        let (row, n) = match object {
            Object::Motor(n) => (0, n),
            Object::Switch(n) => (1, n),
            Object::Output(n) => (2, n),
            Object::Pulsed(n) => (3, n),
            Object::Voltage(n) => (4, n),
            Object::Buttons => (5, 0),
            Object::Driver(n) => (6, n),
            Object::Select(n) => (7, n),
            Object::Latch(n) => (8, n),
        };
        (rows[..row].iter().sum::<usize>() + n) as u32
    }

    /// Writes the setup as commands of a board.
    ///
    /// # Errors
    ///
    /// It does not fit the board.
    pub fn commands(&self, board: &Dictionary, orders: &Orders) -> Result<Configured, SetupError> {
        let frequency = board
            .constant("CLOCK_FREQ")
            .filter(|f| FREQUENCIES.contains(f))
            .ok_or(SetupError::Frequency)?;
        let count = self.oid(Object::Latch(0)) as usize + self.latches();
        let many = |what, most, count| SetupError::Many { what, most, count };
        if count > 255 {
            return Err(many("objects", 255, count));
        }
        if self.buttons.len() > 8 {
            return Err(many("inputs that are looked at", 8, self.buttons.len()));
        }
        self.needs(board, orders)?;
        let mut writer =
            Writer { board, orders, frequency, pins: Pins::new(board), commands: Vec::new() };
        writer.write(Order::Allocate, [count as u32])?;
        self.write(&mut writer)?;
        let text: Vec<u8> = [VERSION.as_bytes(), &writer.commands.concat()].concat();
        // An empty board tells 0.
        let crc = crc32fast::hash(&text).max(1);
        Ok(Configured { commands: writer.commands, crc })
    }

    fn write(&self, to: &mut Writer<'_>) -> Result<(), SetupError> {
        for (n, motor) in self.motors.iter().enumerate() {
            to.motor(self.oid(Object::Motor(n)), motor)?;
        }
        for (n, switch) in self.switches.iter().enumerate() {
            let (pin, pull) = (to.input(switch, Look::Switch)?, switch.pull.number());
            to.write(Order::ConfigEndstop, [self.oid(Object::Switch(n)), pin, pull])?;
        }
        for (n, output) in self.outputs.iter().enumerate() {
            let (oid, off) = (self.oid(Object::Output(n)), u32::from(output.pin.inverted));
            let (pin, watch) = (to.pin(&output.pin)?, to.ticks(output.watch_s.unwrap_or(0.0)));
            to.write(Order::ConfigDigital, [oid, pin, off, off, watch])?;
        }
        for (n, output) in self.pulsed.iter().enumerate() {
            let (pin, cycle) = (to.pin(&output.pin)?, to.ticks(output.cycle_s));
            let off = if output.pin.inverted { to.pwm_max() } else { 0 };
            let watch = to.ticks(output.watch_s.unwrap_or(0.0));
            to.write(Order::ConfigPwm, [self.oid(Object::Pulsed(n)), pin, cycle, off, off, watch])?;
        }
        for (n, voltage) in self.voltages.iter().enumerate() {
            let pin = to.pin(voltage)?;
            to.write(Order::ConfigAnalog, [self.oid(Object::Voltage(n)), pin])?;
        }
        self.write_rows(to)
    }

    fn write_rows(&self, to: &mut Writer<'_>) -> Result<(), SetupError> {
        let buttons = self.oid(Object::Buttons);
        if !self.buttons.is_empty() {
            to.write(Order::ConfigButtons, [buttons, self.buttons.len() as u32])?;
        }
        for (n, wire) in self.drivers.iter().enumerate() {
            let rx = to.pin(&wire.rx)?;
            let tx = if wire.tx.name == wire.rx.name { rx } else { to.pin(&wire.tx)? };
            let (oid, bit) = (self.oid(Object::Driver(n)), to.ticks(1.0 / crate::tmc::uart::BAUD));
            to.write(Order::ConfigDriverUart, [oid, rx, wire.rx.pull.number(), tx, bit])?;
        }
        for (n, select) in self.selects.iter().enumerate() {
            to.select(self.oid(Object::Select(n)), select)?;
        }
        for n in 0..self.latches() {
            to.write(Order::ConfigTrsync, [self.oid(Object::Latch(n))])?;
        }
        for (n, button) in self.buttons.iter().enumerate() {
            let (pin, pull) = (to.input(button, Look::Row)?, button.pull.number());
            to.write(Order::AddButton, [buttons, n as u32, pin, pull])?;
        }
        Ok(())
    }
}

/// Commands of a setup in the making.
struct Writer<'a> {
    board: &'a Dictionary,
    orders: &'a Orders,
    /// Ticks a second.
    frequency: f64,
    pins: Pins,
    commands: Vec<Vec<u8>>,
}

impl Writer<'_> {
    fn write<const N: usize>(&mut self, order: Order, numbers: [u32; N]) -> Result<(), SetupError> {
        self.commands.push(self.orders.write(order, numbers)?);
        Ok(())
    }

    fn motor(&mut self, oid: u32, motor: &Motor) -> Result<(), SetupError> {
        if motor.both_edges && self.board.constant("STEPPER_STEP_BOTH_EDGE") != Some(1.0) {
            return Err(SetupError::BothEdges);
        }
        let [step, dir] = [self.pin(&motor.step)?, self.pin(&motor.dir)?];
        let invert = if motor.both_edges { -1_i32 } else { i32::from(motor.step.inverted) };
        let pulse = self.ticks(motor.pulse_s).max(1);
        self.write(Order::ConfigStepper, [oid, step, dir, invert as u32, pulse])
    }

    fn select(&mut self, oid: u32, select: &DriverSelect) -> Result<(), SetupError> {
        let cs = self.pin(&select.cs)?;
        self.write(Order::ConfigSpi, [oid, cs, 0])?;
        let share = |writer: &mut Self, pin: &Pin| writer.pins.share(writer.board, &pin.name);
        let [miso, mosi, sck] = &select.bus;
        let [miso, mosi, sck] = [share(self, miso)?, share(self, mosi)?, share(self, sck)?];
        let bit = self.ticks(spi::BIT_S).max(1);
        self.write(Order::SpiBus, [oid, miso, mosi, sck, spi::MODE, bit])
    }

    fn pin(&mut self, pin: &Pin) -> Result<u32, SetupError> {
        self.pins.take(self.board, &pin.name)
    }

    fn input(&mut self, pin: &Pin, look: Look) -> Result<u32, SetupError> {
        self.pins.look_at(self.board, &pin.name, look)
    }

    fn ticks(&self, time_s: f64) -> u32 {
        (time_s * self.frequency).round() as u32
    }

    fn pwm_max(&self) -> u32 {
        self.board.constant("PWM_MAX").unwrap_or(255.0) as u32
    }
}
