//! What a board tells of its inputs: switches, rows of inputs, voltages, registers of motor drivers.

use super::channel::{Channel, Told};
use super::motion::Motion;
use super::news::{Measured, News, NotNow};
use super::questions::About;
use crate::dictionary::{Message, Value};
use crate::orders::{Order, OrderError};
use crate::setup::Object;
use crate::tmc::{TmcError, spi, uart};
use std::collections::VecDeque;

/// The value of a register, or the reason for which it is unknown.
pub type Value32 = Result<u32, TmcError>;

/// Time until the first look, seconds: the line may need some resends by then.
const FIRST_S: f64 = 0.5;
/// Time between two looks at a row of inputs, seconds.
const LOOK_S: f64 = 0.002;
/// Looks after which a change that was not acknowledged is told again.
const AGAIN: u32 = 50;
/// Measurements that are added up, and the time between them, seconds.
const SAMPLES: u32 = 8;
const SAMPLE_S: f64 = 0.001;
/// Bytes of a report of voltages: a sum each.
const REPORT: u32 = 2;

/// A row of inputs.
#[derive(Clone, Copy, Debug, Default)]
pub struct Buttons {
    /// Changes that were taken, modulo 256.
    taken: u8,
}

impl Buttons {
    /// The board looks at the row from now on.
    pub fn look(&self, channel: &mut Channel, clock: u64) -> Result<(), OrderError> {
        if channel.setup.buttons.is_empty() {
            return Ok(());
        }
        let oid = channel.oid(Object::Buttons);
        let first = clock + (FIRST_S * channel.frequency) as u64;
        let rest = (LOOK_S * channel.frequency) as u32;
        channel.send(Order::QueryButtons, [oid, first as u32, rest, AGAIN, 0])
    }

    /// Reads changes of a row of inputs; those that were told before are left out.
    pub fn told(
        &mut self,
        channel: &mut Channel,
        message: &Message<'_>,
        news: &mut VecDeque<News>,
    ) -> Told {
        let told = message.number("ack_count").unwrap_or_default() as u8;
        let states = message.bytes("state").unwrap_or_default();
        let known = usize::from(self.taken.wrapping_sub(told));
        let Some(fresh) = states.get(known..).filter(|fresh| !fresh.is_empty()) else {
            return Ok(());
        };
        let inverted = channel.setup.buttons.iter().enumerate().filter(|(_, pin)| pin.inverted);
        let mask = inverted.fold(0, |mask, (n, _)| mask | 1_u8 << n);
        news.extend(fresh.iter().map(|state| News::Buttons(state ^ mask)));
        self.taken = self.taken.wrapping_add(fresh.len() as u8);
        Ok(channel.send(Order::AckButtons, [channel.oid(Object::Buttons), fresh.len() as u32])?)
    }
}

impl Channel {
    pub fn ask_switch(&mut self, switch: usize) -> Result<(), OrderError> {
        let oid = self.oid(Object::Switch(switch));
        self.ask(About::Switch(switch), Order::EndstopState, [oid])
    }

    pub fn told_switch(
        &mut self,
        motion: &Motion,
        message: &Message<'_>,
        news: &mut VecDeque<News>,
    ) {
        let number = |field| message.number(field).unwrap_or_default();
        let switches = &self.setup.switches;
        let found = (0..switches.len()).find(|n| self.oid(Object::Switch(*n)) == number("oid"));
        let Some(switch) = found.filter(|n| self.questions.answered(About::Switch(*n))) else {
            return;
        };
        if let Some(look_s) = motion.latches.look_s(switch) {
            let rest = (look_s * self.frequency).round().max(1.0) as u64;
            let next = self.clock.as_ref().map(|clock| clock.unwrapped(number("next_clock")));
            let clock = next.unwrap_or_default().saturating_sub(rest);
            let count = |motor| motion.queue.count_at(motor, clock).unwrap_or_default();
            let counts = (0..self.setup.motors.len()).map(count).collect();
            return news.push_back(News::Touched { switch, clock, counts });
        }
        let inverted = switches.get(switch).is_some_and(|pin| pin.inverted);
        news.push_back(News::Switch { switch, on: (number("pin_value") != 0) != inverted });
    }

    /// Measures a voltage every so many seconds from a moment on, or no more.
    pub fn measure(
        &mut self,
        voltage: usize,
        every_s: Option<f64>,
        now_s: f64,
    ) -> Result<(), NotNow> {
        let Some((clock, _)) = self.now(now_s) else { return Err(NotNow::Busy) };
        let first = (clock + self.ticks(FIRST_S)) as u32;
        let oid = self.oid(Object::Voltage(voltage));
        let samples = if every_s.is_some() { SAMPLES } else { 0 };
        let rest = every_s.map_or(0, |every_s| self.ticks(every_s));
        if let Some(own) = self.rests.get_mut(voltage) {
            *own = rest;
        }
        let sample = self.ticks(SAMPLE_S) as u32;
        let numbers = [oid, first, sample, samples, rest as u32, REPORT, 0, 0xffff, 0];
        Ok(self.send(Order::QueryAnalog, numbers)?)
    }

    /// Reads measurements of a voltage: each is the mean of some samples, and its clock is in their middle.
    pub fn told_voltage(&mut self, message: &Message<'_>, news: &mut VecDeque<News>) {
        let oid = message.number("oid");
        let mut voltages = 0..self.setup.voltages.len();
        let found = voltages.find(|n| Some(self.oid(Object::Voltage(*n))) == oid);
        let (Some(voltage), Some(line)) = (found, &self.clock) else { return };
        let full = self.dictionary.constant("ADC_MAX").unwrap_or(4095.0) * f64::from(SAMPLES);
        let next = line.unwrapped(message.number("next_clock").unwrap_or_default());
        let rest = self.rests.get(voltage).copied().unwrap_or_default();
        let middle = self.ticks(0.5 * f64::from(SAMPLES - 1) * SAMPLE_S);
        let sums: Vec<&[u8]> =
            message.bytes("values").unwrap_or_default().chunks_exact(2).collect();
        let many = sums.len() as u64;
        let measured = |(n, sum): (u64, &&[u8])| Measured {
            clock: next.saturating_sub((many - n) * rest) + middle,
            share: f64::from(u16::from_le_bytes([sum[0], sum[1]])) / full,
        };
        let all = (0..).zip(&sums).map(measured).collect();
        news.push_back(News::Voltage { voltage, all });
    }

    pub fn ask_register(
        &mut self,
        driver: usize,
        address: u8,
        register: u8,
    ) -> Result<(), OrderError> {
        let command = self.bits(driver, uart::read(address, register), uart::ANSWER_BITS)?;
        self.questions.ask(About::Register(driver, register), command);
        Ok(())
    }

    pub fn write_register(
        &mut self,
        driver: usize,
        address: u8,
        register: u8,
        value: u32,
    ) -> Result<(), OrderError> {
        let command = self.bits(driver, uart::write(address, register, value), 0)?;
        self.push(command, None)
    }

    /// Reads what came over a wire: the wire, the register that was asked for, and its value.
    pub fn told_register(&mut self, message: &Message<'_>) -> Option<(usize, u8, Value32)> {
        let oid = message.number("oid");
        let mut wires = 0..self.setup.drivers.len();
        let found = wires.find(|n| Some(self.oid(Object::Driver(*n))) == oid);
        let asked = |register: &u8| {
            self.questions.has(|about| about == About::Register(found.unwrap_or(0), *register))
        };
        let (driver, register) = found.zip((0..=u8::MAX).find(asked))?;
        self.questions.answered(About::Register(driver, register));
        let value = uart::answer(register, message.bytes("read").unwrap_or_default());
        Some((driver, register, value))
    }

    /// Sends bytes to a chip behind a select, and asks for its own.
    pub fn transfer(&mut self, select: usize, bytes: Vec<u8>) -> Result<(), OrderError> {
        let oid = self.oid(Object::Select(select));
        let values = [Value::Number(oid), Value::Bytes(bytes)];
        let command = self.orders.write_values(Order::Transfer, &values)?;
        self.questions.ask(About::Transfer(select), command);
        Ok(())
    }

    /// Reads what came from a chip: its select, and its data.
    pub fn told_transfer(&mut self, message: &Message<'_>) -> Option<(usize, Value32)> {
        let oid = message.number("oid");
        let mut selects = 0..self.setup.selects.len();
        let select = selects.find(|n| Some(self.oid(Object::Select(*n))) == oid)?;
        let asked = self.questions.answered(About::Transfer(select));
        asked.then(|| (select, spi::answer(message.bytes("response").unwrap_or_default())))
    }

    fn bits(&self, driver: usize, bits: Vec<u8>, read: u32) -> Result<Vec<u8>, OrderError> {
        let oid = self.oid(Object::Driver(driver));
        let values = [Value::Number(oid), Value::Bytes(bits), Value::Number(read)];
        self.orders.write_values(Order::DriverUart, &values)
    }
}
