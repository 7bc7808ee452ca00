//! The inputs and outputs of a machine: of the one that a server has, of a controller, or as the data folder keeps them.

use crate::commands::io::{Switch, Switches};
use crate::data_args::{DataArgs, data_folder};
use crate::exit::Usage;
use crate::machine_choice::MachineChoice;
use crate::remote::{Card, Remote, beside};
use crate::{memory, setup};
use anyhow::Result;
use clap::Args;
use kerf_journal::{Journal, Press};
use kerf_machine::Configuration;
use kerf_machine::lines::line_of_pin;
use kerf_machine::wiring::{self, Bit, INPUT_BITS, OUTPUT_BITS};
use kerf_model::ports::Ports;

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
        memory::journal(&data_folder(&self.data)?, looks)
    }

    /// Returns the machine, unless a controller is named: its card is not this one.
    pub fn machine(&self) -> Result<Configuration> {
        setup::machine(&self.machine, &self.data)
    }

    /// The server that has the machine, where one runs.
    pub fn server(&self) -> Result<Option<Remote>> {
        beside(&self.data, &self.machine)
    }

    /// The card of the machine that a running server has; it is armed first where that is wanted.
    pub fn served(&self, arm: bool) -> Result<Option<Card>> {
        Ok(self.server()?.map(|server| Card::of(server, arm)))
    }

    /// The input or output of a name.
    ///
    /// # Errors
    /// None of the machine is called so.
    pub fn line(&self, name: &str) -> Result<Line> {
        Line::named(name, &self.machine).ok_or_else(|| Usage(self.nothing_called(name)).into())
    }

    fn nothing_called(&self, name: &str) -> String {
        if let Some(controller) = self.machine.controller() {
            return format!(
                "{controller} has no input or output {name}; kerf io list --machine {controller} shows those it has"
            );
        }
        let names = OUTPUT_BITS.iter().chain(INPUT_BITS).map(|bit| bit.name);
        let hint = kerf_diag::did_you_mean(name, names)
            .unwrap_or_else(|| "kerf io list shows all of them".into());
        format!("no input or output is called {name}; {hint}")
    }

    /// Tells whether an input or output is on; of an input what it reads.
    pub fn is_on(&self, line: Line) -> Result<bool> {
        match line {
            Line::Bit(is_output, bit) => Ok(self.ports()?.is_on(is_output, bit)),
            Line::Switch(switch) => Switches::of(self).is_on(switch),
        }
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
            Some(card) if is_output => {
                let ports = card.switch(bit, on)?;
                goes_off(on);
                Ok(ports)
            }
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
            moved(number, on, journal)
        })?;
        Ok(ports)
    }

    /// Puts the switch of an input of the simulated machine, which nobody serves.
    pub fn move_switch(&self, number: u8, on: bool) -> Result<()> {
        self.change(|_, journal| moved(number, on, journal)).map(drop)
    }
}

/// Tells what becomes of an output that was switched through a server.
pub fn goes_off(on: bool) {
    if on {
        eprintln!(
            "kerf: the output goes off again when nobody drives the machine of the server any more: switch it at the \
             page that drives, or send the lines that need it together (kerf send)"
        );
    }
}

/// Whatever runs next finds the switch where it was left.
fn moved(number: u8, on: bool, journal: Option<&Journal>) -> Result<()> {
    journal.map_or(Ok(()), |journal| Ok(journal.registry.move_switch(Press { number, on })?))
}

/// An input or output.
#[derive(Clone, Copy, Debug)]
pub enum Line {
    /// A bit of the card, and `true` for an output.
    Bit(bool, &'static Bit),
    /// A switch, by its number.
    Switch(Switch),
}

impl Line {
    /// The input or output of a machine that a name means; a controller has no card.
    pub fn named(name: &str, machine: &MachineChoice) -> Option<Self> {
        let of_controller = machine.controller().is_some();
        let bit = wiring::bit(name).filter(|_| !of_controller);
        let bit = bit.map(|(is_output, bit)| Self::Bit(is_output, bit));
        bit.or_else(|| Switch::named(name, of_controller).map(Self::Switch))
    }
}
