//! The registry: values that programs and other software keep under a key, and, read in the same way, what the machine
//! says of itself and does now.

use super::reached::{PROGRESS, Reached};
use super::rows::Table;
use super::store::Store;
use super::switches::{self, SWITCHES, Switches};
use super::{JournalError, Live, Press, check_value, mirror, owner, stated};
use crate::facts::Fact;
use std::sync::Arc;

/// Values by key.
#[derive(Clone, Debug)]
pub struct Registry {
    pub(super) store: Arc<Store>,
}

impl Registry {
    pub(super) const fn new(store: Arc<Store>) -> Self {
        Self { store }
    }

    /// The value of a key.
    ///
    /// # Errors
    /// If the file cannot be read.
    pub fn value(&self, key: &str) -> Result<Option<String>, JournalError> {
        self.store.read(|rows| stated::value(rows, key))
    }

    /// The value of a key, as the file has it while a thread may be writing into it: nobody waits for the disk.
    pub fn look_up(&self, key: &str) -> Result<Option<String>, JournalError> {
        self.store.read_beside(|rows| stated::value(rows, key))
    }

    /// Gives a key a value; `None` removes it. What the machine says of itself is no value: see [`Registry::state`].
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn set_value(&self, key: &str, value: Option<&str>) -> Result<(), JournalError> {
        self.store.write(|rows| rows.set(Table::Value, key, value))
    }

    /// Keys and values in order.
    ///
    /// # Errors
    /// If the file cannot be read.
    pub fn values(&self) -> Result<Vec<(String, String)>, JournalError> {
        self.store.read(stated::values)
    }

    /// The machine says of itself that this is so; `None` takes it back.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn state(&self, fact: Fact, text: Option<&str>) -> Result<(), JournalError> {
        self.store.write(|rows| rows.set(Table::Fact, fact.key(), text))
    }

    /// Switches of the simulated machine that somebody moved, and whether each was left closed.
    ///
    /// # Errors
    /// If the journal cannot be read.
    pub fn switches(&self) -> Result<Switches, JournalError> {
        Ok(switches::read(&self.value(SWITCHES)?.unwrap_or_default()))
    }

    /// Records that a switch of the simulated machine, which stands, was moved.
    ///
    /// # Errors
    /// If the journal cannot be written.
    pub fn move_switch(&self, press: Press) -> Result<(), JournalError> {
        let mut switches = self.switches()?;
        switches.retain(|(number, _)| *number != press.number);
        switches.push((press.number, press.on));
        switches.sort_unstable();
        self.state(Fact::SimulatedSwitches, switches::write(&switches).as_deref())
    }

    /// Reads what the machine does now. A machine that nobody runs does nothing.
    ///
    /// # Errors
    /// If the file cannot be read.
    pub fn live(&self) -> Result<Live, JournalError> {
        self.running().map(Option::unwrap_or_default)
    }

    /// The same; nothing when nobody runs the machine.
    ///
    /// # Errors
    /// If the file cannot be read.
    pub fn running(&self) -> Result<Option<Live>, JournalError> {
        if !owner::is_owned(self.store.folder()) {
            return Ok(None);
        }
        let reached = self.store.read(|rows| rows.text(Table::Fact, PROGRESS))?;
        let reached: Option<Reached> = self.store.parsed(PROGRESS, reached)?;
        Ok(Some(reached.as_ref().map(Reached::live).unwrap_or_default()))
    }

    /// Tells other programs how a machine stands that nobody runs: a Kerf that was killed has left what was true
    /// then.
    ///
    /// # Errors
    /// If their file cannot be written.
    pub fn tell_rest(&self, rest: &Live) -> Result<(), JournalError> {
        if owner::is_owned(self.store.folder()) { Ok(()) } else { self.publish(rest) }
    }

    /// Writes what other programs read.
    pub(super) fn publish(&self, live: &Live) -> Result<(), JournalError> {
        mirror::publish(self.store.folder(), live, &self.values()?)
    }

    /// Takes over the values that other programs wrote into their file; what is none is left out.
    ///
    /// # Errors
    /// If the journal cannot be written; then the file stays.
    pub fn take_in(&self) -> Result<(), JournalError> {
        let Some(text) = mirror::incoming(self.store.folder())? else { return Ok(()) };
        for (key, value) in text.lines().filter_map(|line| line.split_once('=')) {
            let key = key.rsplit(['/', '\\']).next().unwrap_or(key).trim();
            let value = Some(value.trim()).filter(|value| !value.is_empty());
            if check_value(key, value).is_ok() {
                self.set_value(key, value)?;
            }
        }
        mirror::is_taken(self.store.folder())
    }
}
