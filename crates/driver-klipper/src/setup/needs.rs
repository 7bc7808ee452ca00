//! The words that a board has to know before anything of a setup is told to it: so that an old one is refused while it
//! stands, and not in the middle of a motion.

use super::{Setup, SetupError};
use crate::dictionary::{Dictionary, Wanted};
use crate::orders::{Order, Orders};

/// Commands of every session.
const ALWAYS: &[Order] = &[
    Order::Uptime,
    Order::Clock,
    Order::Config,
    Order::EmergencyStop,
    Order::ClearShutdown,
    Order::ConfigTrsync,
    Order::TrsyncStart,
    Order::TrsyncTimeout,
    Order::TrsyncTrigger,
];

/// Commands of motors.
const MOTORS: &[Order] = &[
    Order::ConfigStepper,
    Order::QueueStep,
    Order::NextDir,
    Order::ResetStepClock,
    Order::Position,
    Order::StopOnTrigger,
];

/// Answers of every session, and the fields that are read.
const ANSWERS: &[Wanted] = &[
    Wanted { name: "uptime", fields: &["high", "clock"] },
    Wanted { name: "clock", fields: &["clock"] },
    Wanted { name: "config", fields: &["is_config", "crc", "is_shutdown", "move_count"] },
    Wanted { name: "shutdown", fields: &["static_string_id"] },
    Wanted { name: "is_shutdown", fields: &["static_string_id"] },
    Wanted { name: "trsync_state", fields: &["oid", "can_trigger", "trigger_reason"] },
];

impl Setup {
    /// Looks for all words that sessions with this setup use.
    pub(super) fn needs(&self, board: &Dictionary, orders: &Orders) -> Result<(), SetupError> {
        let of = |there: bool, orders: &'static [Order]| if there { orders } else { &[] };
        let commands = [
            ALWAYS,
            of(!self.motors.is_empty(), MOTORS),
            of(
                !self.switches.is_empty(),
                &[Order::ConfigEndstop, Order::EndstopHome, Order::EndstopState],
            ),
            of(!self.outputs.is_empty(), &[Order::ConfigDigital, Order::QueueDigital]),
            of(!self.pulsed.is_empty(), &[Order::ConfigPwm, Order::QueuePwm]),
            of(!self.voltages.is_empty(), &[Order::ConfigAnalog, Order::QueryAnalog]),
            of(
                !self.buttons.is_empty(),
                &[Order::ConfigButtons, Order::AddButton, Order::QueryButtons, Order::AckButtons],
            ),
            of(!self.drivers.is_empty(), &[Order::ConfigDriverUart, Order::DriverUart]),
            of(!self.selects.is_empty(), &[Order::ConfigSpi, Order::SpiBus, Order::Transfer]),
        ];
        commands.into_iter().flatten().try_for_each(|order| orders.require(*order))?;
        let answer = |there: bool, name, fields| there.then_some(Wanted { name, fields });
        let answers = [
            answer(!self.motors.is_empty(), "stepper_position", &["oid", "pos"]),
            answer(!self.switches.is_empty(), "endstop_state", &["oid", "next_clock", "pin_value"]),
            answer(!self.voltages.is_empty(), "analog_in_state", &["oid", "next_clock", "values"]),
            answer(!self.buttons.is_empty(), "buttons_state", &["ack_count", "state"]),
            answer(!self.drivers.is_empty(), "tmcuart_response", &["oid", "read"]),
            answer(!self.selects.is_empty(), "spi_transfer_response", &["oid", "response"]),
        ];
        let answers = ANSWERS.iter().chain(answers.iter().flatten());
        answers.into_iter().try_for_each(|wanted| board.answer(wanted))?;
        Ok(())
    }
}
