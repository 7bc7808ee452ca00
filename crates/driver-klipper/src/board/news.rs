//! News of a board, and the reasons for which it does nothing more.

use crate::dictionary::DictionaryError;
use crate::orders::OrderError;
use crate::setup::SetupError;
use crate::tmc::Trouble;

/// The reason for which motion ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ended {
    /// All steps are made.
    Rested,
    /// The host asked for it: dropped at once, without a ramp.
    Asked,
    /// A switch that was watched stopped the motors, or the host did in the same way.
    Touched,
    /// A limit, a door or an emergency stop stopped the motors; outputs go off.
    Guarded,
    /// The board did not hear from its host in time.
    Deadline,
    /// The host was late with its steps, and stopped before the board would have shut down.
    Late,
    /// The board had shut down, and goes on.
    Shutdown,
}

/// The reason for which something cannot be done now.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum NotNow {
    /// There is no board.
    #[error("no board is connected")]
    Absent,
    /// It is not known well enough yet, or it moves.
    #[error("the board is busy: wait until it stands")]
    Busy,
    /// Nothing moves.
    #[error("nothing moves")]
    Rest,
    /// It is shut down.
    #[error("the board is shut down: clear that first")]
    Shutdown,
    /// It cannot be told.
    #[error(transparent)]
    Order(#[from] OrderError),
}

/// The beginning of motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Start {
    /// Clock at which the first piece begins.
    pub clock: u64,
    /// Ticks a second, as measured: times of a plan become clocks by it.
    pub ticks_per_s: f64,
}

/// A measurement of a voltage.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// Clock in the middle of its samples.
    pub clock: u64,
    /// Share of the full voltage, from 0 to 1.
    pub share: f64,
}

/// News of a board.
#[derive(Clone, Debug, PartialEq)]
pub enum News {
    /// It can be moved.
    Ready {
        /// Version of the program in it.
        version: String,
        /// Steps that each motor has made since its configuration.
        counts: Vec<i64>,
    },
    /// Motion is over.
    Ended {
        /// The reason.
        why: Ended,
        /// Steps that each motor has made, as the board counted them.
        counts: Vec<i64>,
    },
    /// A switch that stopped motors was first seen so at a clock.
    Touched {
        /// Its place among the switches.
        switch: usize,
        /// Clock of the look that saw it.
        clock: u64,
        /// Count of each motor then, if it made all that it was told.
        counts: Vec<i64>,
    },
    /// State of a switch that was asked for.
    Switch {
        /// Its place among the switches.
        switch: usize,
        /// It is closed.
        on: bool,
    },
    /// Inputs that are looked at all the time changed: a bit each, set where it is on.
    Buttons(u8),
    /// A voltage was measured.
    Voltage {
        /// Its place among the voltages.
        voltage: usize,
        /// Measurements in order of time.
        all: Vec<Measured>,
    },
    /// A register of a motor driver.
    Register {
        /// Place of its wire among the wires.
        driver: usize,
        /// Number of the register.
        register: u8,
        /// Its value, or the reason for which it is unknown.
        value: Result<u32, crate::tmc::TmcError>,
    },
    /// A motor driver is not well.
    Driver(Trouble),
    /// The board shut down. Its motors stand, its outputs are off; the counts are kept.
    Shutdown(String),
    /// Nothing more can be done in this session.
    Fault(Fault),
}

/// The reason for which a session with a board is over.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Fault {
    /// Nobody answers.
    #[error(
        "no board answers: is it powered, is this its port and its rate, is Klipper's firmware on it?"
    )]
    NoBoard,
    /// The dictionary is of no use.
    #[error(transparent)]
    Dictionary(#[from] DictionaryError),
    /// The setup does not fit the board.
    #[error(transparent)]
    Setup(#[from] SetupError),
    /// A command does not fit the board.
    #[error(transparent)]
    Order(#[from] OrderError),
    /// The board holds another configuration.
    #[error(
        "the board was configured by another program or for another machine ({0:08x}): reset it, then connect again"
    )]
    Foreign(u32),
    /// The board was shut down before the session.
    #[error("the board is shut down ({0}): reset it, then connect again")]
    ShutDown(String),
    /// The configuration was not taken.
    #[error("the board did not take its configuration: reset it, then connect again")]
    Configuration,
    /// The board began anew within the session.
    #[error(
        "the board has restarted: its position is lost; look at its supply, then connect and home again"
    )]
    Restarted,
    /// Frames are not acknowledged any more.
    #[error(
        "the board does not answer any more: its motors stop by themselves; look at its cable and supply"
    )]
    Silent,
    /// A question was not answered, while other things were.
    #[error("the board does not answer `{0}`: flash its firmware anew")]
    Unanswered(&'static str),
    /// A motor driver cannot be set.
    #[error("the driver of motor {motor}: {why}; nothing moves")]
    Driver {
        /// The name of its motor.
        motor: String,
        /// The reason.
        why: String,
    },
    /// One of several boards of a machine.
    #[error("board {board}: {fault}")]
    OnBoard {
        /// Its name.
        board: String,
        /// The mistake in it.
        fault: Box<Self>,
    },
    /// Steps were lost between host and board.
    #[error(
        "motor {motor} made {made} steps, {planned} were planned: home the machine, and report this"
    )]
    Lost {
        /// Its place among the motors.
        motor: usize,
        /// Count that was planned.
        planned: i64,
        /// Count that the board told.
        made: i64,
    },
}

impl Fault {
    /// The board does not answer.
    pub fn is_silent(&self) -> bool {
        match self {
            Self::OnBoard { fault, .. } => fault.is_silent(),
            _ => matches!(self, Self::Silent | Self::NoBoard | Self::Unanswered(_)),
        }
    }
}
