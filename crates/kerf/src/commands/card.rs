//! The inputs and outputs of a machine: of the one that a server has, or as the data folder keeps them.

use crate::args::DataArgs;
use crate::exit::Usage;
use crate::machine_name::MachineChoice;
use crate::remote::{Card, beside};
use crate::{memory, setup};
use anyhow::{Result, bail};
use clap::Args;
use kerf_journal::{Journal, Press};
use kerf_machine::Configuration;
use kerf_machine::lines::line_of_pin;
use kerf_machine::wiring::{self, Bit, INPUT_BITS, OUTPUT_BITS};
use kerf_sim::ports::Ports;

/// Under which key the ports are kept.
const KEY: &str = "IoPorts";

/// The machine whose inputs and outputs are meant.
#[derive(Args, Clone, Debug)]
pub struct CardArgs {
    #[command(flatten)]
    pub data: DataArgs,
    #[command(flatten)]
    pub machine: MachineChoice,
}

impl CardArgs {
    fn journal(&self, looks: bool) -> Result<Option<Journal>> {
        memory::journal(&setup::data_folder(&self.data)?, looks)
    }

    /// Returns the machine, unless a controller is named: its card is not this one.
    pub fn machine(&self) -> Result<Configuration> {
        setup::machine(&self.machine, &self.data)
    }

    /// The card of the machine that a running server has; it is armed first where that is wanted.
    pub fn served(&self, arm: bool) -> Result<Option<Card>> {
        let server = beside(&self.data, &self.machine)?;
        Ok(server.map(|server| Card::of(server, arm)))
    }

    /// The ports as they are; of inputs what they read.
    pub fn ports(&self) -> Result<Ports> {
        if let Some(card) = self.served(false)? {
            return card.ports();
        }
        self.kept()
    }

    /// The ports of the data folder, which nobody serves.
    fn kept(&self) -> Result<Ports> {
        let journal = self.journal(true)?;
        let (mut ports, mut moved) = (Ports::default(), Vec::new());
        if let Some(journal) = &journal {
            ports =
                journal.registry.value(KEY)?.as_deref().and_then(Ports::read).unwrap_or_default();
            moved = journal.registry.switches()?;
        }
        let machine = self.machine()?;
        let untouched = kerf_sim::untouched(&machine);
        for bit in INPUT_BITS {
            let line = line_of_pin(bit);
            let level = moved.iter().find(|(number, _)| *number == line).map(|(_, level)| *level);
            let reads = |level: bool| machine.io.line_reads(line, level);
            ports.set_input(bit, level.map_or_else(|| untouched(line), reads));
        }
        Ok(ports)
    }

    /// Changes the ports, unless a run owns the machine.
    pub fn change<T>(
        &self,
        change: impl FnOnce(&mut Ports, Option<&Journal>) -> Result<T>,
    ) -> Result<(Ports, T)> {
        let journal = self.journal(false)?;
        let _owner = journal.as_ref().map(Journal::own).transpose()?;
        let mut ports = self.kept()?;
        let answer = change(&mut ports, journal.as_ref())?;
        if let Some(journal) = &journal {
            journal.registry.set_value(KEY, Some(&ports.write()))?;
        }
        Ok((ports, answer))
    }

    /// Switches a bit, through the server that has the machine where one runs; of an input it is the level of its pin.
    pub fn switch(&self, (is_output, bit): (bool, &Bit), on: bool, arm: bool) -> Result<Ports> {
        match self.served(arm)? {
            Some(card) if is_output => card.switch(bit, on),
            Some(card) => card.press(bit, self.machine()?.io.line_reads(line_of_pin(bit), on)),
            None => self.switch_here(is_output, bit, on),
        }
    }

    /// Switches a bit of a machine that nobody serves.
    fn switch_here(&self, is_output: bool, bit: &Bit, on: bool) -> Result<Ports> {
        let machine = self.machine()?;
        let (ports, ()) = self.change(|ports, journal| {
            if is_output {
                return Ok(ports.set_output(bit, on, false)?);
            }
            let number = line_of_pin(bit);
            ports.set_input(bit, machine.io.line_reads(number, on));
            // Whatever runs next finds the switch where it was left.
            journal.map_or(Ok(()), |journal| journal.registry.move_switch(Press { number, on }))?;
            Ok(())
        })?;
        Ok(ports)
    }
}

/// The bit of a name, and `true` for an output.
///
/// # Errors
/// No bit is called so.
pub fn known(name: &str) -> Result<(bool, &'static Bit)> {
    match wiring::bit(name) {
        Some(found) => Ok(found),
        None => {
            let names = OUTPUT_BITS.iter().chain(INPUT_BITS).map(|bit| bit.name);
            let hint = kerf_diag::did_you_mean(name, names)
                .unwrap_or_else(|| "kerf io list shows every bit".into());
            bail!(Usage(format!("no bit is called {name}; {hint}")))
        }
    }
}
