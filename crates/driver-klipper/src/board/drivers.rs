//! Registers of motor drivers: written once the board is there, read back, looked at between runs.
//!
//! ```text
//!  version ─► (write, count of datagrams) … ─► read back ─► condition        on a wire
//!  version ─► (write, the same again: it answers with the value) … ─► …      with a chip select
//! ```
//!
//! One driver is spoken to at a time. What is not confirmed is done again; a driver that stays silent ends the session
//! before anything moves.

use super::channel::Channel;
use super::inputs::Value32;
use super::news::Fault;
use crate::orders::OrderError;
use crate::setup::{Driver, RegisterLink};
use crate::tmc::{Chip, Condition, DRV_STATUS, GSTAT, IFCNT, TmcError, Trouble, Write, spi};
use std::collections::VecDeque;

/// Time that a datagram needs on a wire, seconds: one that follows sooner is dropped.
const ON_WIRE_S: f64 = 0.006;
/// Times that a step is tried.
const TRIES: u32 = 6;

/// A step on the way through the registers of a driver.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Step {
    /// The kind is what it is said to be.
    Version,
    /// The count of datagrams before the first.
    Count,
    /// A register is written, and that is confirmed.
    Write(Write),
    /// A register holds what was written.
    Holds(Write),
    /// The driver was not reset since it was written.
    Kept,
    /// The power stage is well.
    Condition,
}

/// The next thing of a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Turn {
    /// It is begun.
    Begins,
    /// A datagram is on the wire until a moment, then the count is asked for.
    OnWire,
    /// An answer is waited for; of a chip with a select the first one is of no use.
    Waits { first: bool },
}

/// The way through the drivers of a board.
#[derive(Debug, Default)]
pub struct Drivers {
    /// The next piece of work: the place of a driver, and a step.
    steps: VecDeque<(usize, Step)>,
    turn: Option<Turn>,
    tries: u32,
    /// The end of a datagram on a wire, seconds.
    until_s: f64,
    /// Datagrams that the driver has counted.
    count: u8,
    troubles: Vec<Trouble>,
}

impl Drivers {
    /// Begins to write the registers of all drivers.
    ///
    /// # Errors
    ///
    /// A driver cannot be set so.
    pub fn tune(&mut self, drivers: &[Driver]) -> Result<(), Fault> {
        for (n, driver) in drivers.iter().enumerate() {
            let writes = driver.tuning.writes();
            let writes = writes.map_err(|why| failed(driver, &why.to_string()))?;
            let is_wire = matches!(driver.way, RegisterLink::Wire { .. });
            let counts = is_wire.then_some(Step::Count);
            let holds = writes.iter().filter(|it| it.is_readable()).map(|it| Step::Holds(*it));
            let steps = [Step::Version].into_iter().chain(counts);
            let steps = steps.chain(writes.iter().map(|it| Step::Write(*it)));
            let steps = steps.chain(holds).chain([Step::Condition]);
            self.steps.extend(steps.map(|step| (n, step)));
        }
        Ok(())
    }

    /// Begins to look at the condition of all drivers.
    pub fn check(&mut self, drivers: &[Driver]) {
        if self.steps.is_empty() {
            let each = (0..drivers.len()).flat_map(|n| [(n, Step::Kept), (n, Step::Condition)]);
            self.steps.extend(each);
        }
    }

    /// Nothing is left to do.
    pub fn is_done(&self) -> bool {
        self.steps.is_empty()
    }

    /// Moment at which something is to be done without an answer, seconds.
    pub fn due_s(&self) -> f64 {
        match self.turn {
            _ if self.steps.is_empty() => f64::INFINITY,
            None | Some(Turn::Begins) => f64::NEG_INFINITY,
            Some(Turn::OnWire) => self.until_s,
            Some(Turn::Waits { .. }) => f64::INFINITY,
        }
    }

    /// Drivers that were found unwell since it was asked last.
    pub fn troubles(&mut self) -> Vec<Trouble> {
        std::mem::take(&mut self.troubles)
    }

    /// All that was under way is dropped: the board is shut down.
    pub fn forget(&mut self) {
        (self.steps, self.turn) = (VecDeque::new(), None);
    }

    /// Does what is due.
    pub fn go_on(&mut self, channel: &mut Channel, now_s: f64) -> Result<(), OrderError> {
        let Some((n, step)) = self.steps.front().copied() else { return Ok(()) };
        if now_s < self.due_s() {
            return Ok(());
        }
        let Driver { way, tuning, .. } = channel.setup.tuned[n].clone();
        let register = register(step, tuning.chip);
        self.turn = Some(match (way, step, self.turn) {
            (
                RegisterLink::Wire { wire, address },
                Step::Write(write),
                None | Some(Turn::Begins),
            ) => {
                channel.write_register(wire, address, write.register, write.value)?;
                self.until_s = now_s + ON_WIRE_S;
                Turn::OnWire
            }
            (RegisterLink::Wire { wire, address }, ..) => {
                channel.ask_register(wire, address, register)?;
                Turn::Waits { first: false }
            }
            (RegisterLink::Select(select), Step::Write(write), _) => {
                channel.transfer(select, spi::write(write.register, write.value))?;
                Turn::Waits { first: true }
            }
            (RegisterLink::Select(select), ..) => {
                channel.transfer(select, spi::read(register))?;
                Turn::Waits { first: true }
            }
        });
        Ok(())
    }

    /// Hears a register of a driver on a wire; true where it was asked for here.
    pub fn told_wire(
        &mut self,
        channel: &Channel,
        (wire, of): (usize, u8),
        value: Value32,
    ) -> Result<bool, Fault> {
        let Some((driver, step)) = self.front(channel) else { return Ok(false) };
        let is_it = matches!(driver.way, RegisterLink::Wire { wire: own, .. } if own == wire);
        let waits = matches!(self.turn, Some(Turn::Waits { .. }));
        if !is_it || !waits || register(step, driver.tuning.chip) != of {
            return Ok(false);
        }
        self.heard(driver, step, value).map(|()| true)
    }

    /// Hears the data of a chip with a select.
    pub fn told_select(
        &mut self,
        channel: &mut Channel,
        select: usize,
        value: Value32,
    ) -> Result<(), Fault> {
        let Some((driver, step)) = self.front(channel) else { return Ok(()) };
        if driver.way != RegisterLink::Select(select) {
            return Ok(());
        }
        if let Some(Turn::Waits { first: true }) = self.turn {
            let again = match step {
                Step::Write(write) => spi::write(write.register, write.value),
                _ => spi::read(register(step, driver.tuning.chip)),
            };
            channel.transfer(select, again)?;
            self.turn = Some(Turn::Waits { first: false });
            return Ok(());
        }
        self.heard(driver, step, value)
    }

    fn front(&self, channel: &Channel) -> Option<(Driver, Step)> {
        let (n, step) = self.steps.front()?;
        Some((channel.setup.tuned.get(*n)?.clone(), *step))
    }

    /// Holds an answer against what is wanted: goes on, tries again, or gives up.
    fn heard(&mut self, driver: Driver, step: Step, value: Value32) -> Result<(), Fault> {
        self.turn = Some(Turn::Begins);
        let Some(wrong) = self.wrong(&driver, step, value) else {
            (self.tries, _) = (0, self.steps.pop_front());
            return Ok(());
        };
        self.tries += 1;
        if self.tries >= TRIES { Err(failed(&driver, &wrong)) } else { Ok(()) }
    }

    /// The reason for which an answer is not the one that is wanted, in words.
    fn wrong(&mut self, driver: &Driver, step: Step, value: Value32) -> Option<String> {
        let value = match value {
            Ok(value) => value,
            // A chip with a select may hold a register of zeros.
            Err(TmcError::Silent)
                if matches!(driver.way, RegisterLink::Select(_)) && step == Step::Kept =>
            {
                0
            }
            Err(why) => return Some(why.to_string()),
        };
        let chip = driver.tuning.chip;
        let deaf = || Some("it does not take what is written into it".to_owned());
        match (step, driver.way) {
            (Step::Version, _) => match Chip::of_version(value) {
                Some(found) if found == chip => None,
                Some(found) => Some(format!("it is a {}, and no {}", found.name(), chip.name())),
                None => Some(format!("it is no driver that is known ({value:08x})")),
            },
            (Step::Count, _) => {
                self.count = value as u8;
                None
            }
            (Step::Write(_), RegisterLink::Wire { .. }) => {
                let raised = value as u8 == self.count.wrapping_add(1);
                self.count = value as u8;
                if raised { None } else { deaf() }
            }
            (Step::Write(write) | Step::Holds(write), _) if value == write.value => None,
            (Step::Write(_) | Step::Holds(_), _) => deaf(),
            (Step::Kept, _) => {
                let why = "it was reset, so its settings are gone: look at its supply, then connect again";
                self.note(driver, value & 1 == 0, false, why);
                None
            }
            (Step::Condition, _) => {
                let condition = Condition::of(chip, value);
                let warm = "it is warm: less current or more air, before it switches its motor off";
                match condition {
                    Condition::Fine => {}
                    Condition::Warm => self.note(driver, false, true, warm),
                    Condition::Off(why) => self.note(driver, false, false, why),
                }
                None
            }
        }
    }

    fn note(&mut self, driver: &Driver, is_well: bool, drives: bool, words: &'static str) {
        if !is_well {
            self.troubles.push(Trouble { name: driver.name.clone(), drives, words });
        }
    }
}

/// The register that a step looks at.
const fn register(step: Step, chip: Chip) -> u8 {
    match step {
        Step::Version => chip.version_register(),
        Step::Count | Step::Write(_) => IFCNT,
        Step::Holds(write) => write.register,
        Step::Kept => GSTAT,
        Step::Condition => DRV_STATUS,
    }
}

fn failed(driver: &Driver, why: &str) -> Fault {
    Fault::Driver { motor: driver.name.clone(), why: why.to_owned() }
}
