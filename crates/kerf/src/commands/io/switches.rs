//! Inputs and outputs by number, as programs have them: those of a controller, and the switches of every machine.

use super::states::{State, States};
use crate::commands::by_hand::ServerArgs;
use crate::commands::card::{CardArgs, goes_off};
use crate::commands::shop::Shop;
use crate::commands::which::Which;
use crate::controller::First;
use crate::exit::{Exit, Usage};
use crate::summary::told_by_server;
use anyhow::{Result, bail};
use kerf_control::controller::{lines, output_name, output_of_name, wired};
use kerf_machine::driver::Facts;
use kerf_machine::lines::Output;
use kerf_machine::wiring;
use kerf_program::settings::SWITCHES;
use std::thread::sleep;
use std::time::Duration;

/// Looks at a controller before its inputs are known: it is asked five times a second.
const LOOKS: u32 = 60;
/// Time between two of them.
const LOOK: Duration = Duration::from_millis(5);

/// An input or an output, by its number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Switch {
    pub is_output: bool,
    /// 1 to 12.
    pub number: u8,
}

impl Switch {
    /// The switch of a name: `out.2` or 2, `in.1`; of a controller also the name of an output of it.
    pub fn named(word: &str, of_controller: bool) -> Option<Self> {
        let (is_output, word) = match word.strip_prefix("in.") {
            Some(input) => (false, input),
            None => (true, word.strip_prefix("out.").unwrap_or(word)),
        };
        let numbered = word.parse().ok().filter(|n: &u8| (1..=SWITCHES as u8).contains(n));
        let number = match numbered {
            None if of_controller && is_output => output_of_controller(word),
            number => number,
        }?;
        Some(Self { is_output, number })
    }

    /// Its name: `out.2`.
    pub fn name(self) -> String {
        format!("{}.{}", if self.is_output { "out" } else { "in" }, self.number)
    }
}

/// The output of a controller that a name means: its own, or that of the card which is wired to it.
fn output_of_controller(word: &str) -> Option<u8> {
    let of_card = || {
        let (is_output, bit) = wiring::bit(word)?;
        // What the controller has is looked at once it is connected.
        wired(&Facts::default(), Output::of_name(bit.name).filter(|_| is_output)?.number())
    };
    output_of_name(word).or_else(of_card).filter(|line| usize::from(*line) <= SWITCHES)
}

/// The switches of a machine.
pub struct Switches {
    which: Which,
    card: CardArgs,
}

impl Switches {
    /// Those of the machine of a card.
    pub fn of(card: &CardArgs) -> Self {
        Self { which: Which::looking(&card.machine, &card.data), card: card.clone() }
    }

    /// Refuses a switch that the machine does not have.
    fn refuse_lacking(&self, switch: Switch, shop: &Shop) -> Result<()> {
        let Some((inputs, outputs)) = has(shop) else { return Ok(()) };
        let all = if switch.is_output { outputs } else { inputs };
        if all.contains(&switch.number) {
            return Ok(());
        }
        let side = if switch.is_output { "output" } else { "input" };
        let all: Vec<_> = all.iter().map(u8::to_string).collect();
        bail!(
            "{} tells of no {side} {}, but of {}",
            shop.controller.as_ref().map_or("", |it| it.name()),
            switch.number,
            all.join(", ")
        );
    }

    /// Tells whether a switch is on; of an input what it reads.
    pub fn is_on(&self, switch: Switch) -> Result<bool> {
        if let Some(card) = self.card.served(false)? {
            return Ok(card.lamps()?[usize::from(switch.is_output)].contains(&switch.number));
        }
        let mut shop = looked_at(&self.which)?;
        self.refuse_lacking(switch, &shop)?;
        shop.leave();
        Ok(reads(&shop, switch))
    }

    /// Switches an output, as SO does, or puts a switch of the simulated machine.
    pub fn set(&self, switch: Switch, on: bool, there: ServerArgs) -> Result<Exit> {
        if !switch.is_output {
            return self.press(switch, on);
        }
        let line = format!("SO,{},{}", switch.number, u8::from(on));
        if let Some(server) = self.card.server()? {
            let exit = told_by_server(&server.send(&line, there.arm)?, true);
            goes_off(on && exit == Exit::Good);
            return Ok(exit);
        }
        Shop::open(&self.which, false)?.types(&line)
    }

    fn press(&self, switch: Switch, on: bool) -> Result<Exit> {
        let served = self.card.served(false)?;
        if let (None, Some(name)) = (&served, self.card.machine.controller()) {
            bail!(Usage(format!(
                "{} is read, not set: {name} tells what is wired to it",
                switch.name()
            )));
        }
        match served {
            Some(card) => card.press_switch(switch.number, on)?,
            None => self.card.move_switch(switch.number, on)?,
        }
        Ok(Exit::Good)
    }

    /// Every switch with its state, as often as it is asked for.
    pub fn states(&self) -> Result<States> {
        if let Some(card) = self.card.served(false)? {
            let all = (1..=SWITCHES as u8).collect::<Vec<_>>();
            return Ok(Box::new(move || {
                let lamps = card.lamps()?;
                let on =
                    |switch: Switch| lamps[usize::from(switch.is_output)].contains(&switch.number);
                Ok(states(&all, &all, on))
            }));
        }
        let mut shop = looked_at(&self.which)?;
        shop.leave();
        let (inputs, outputs) = has(&shop).unwrap_or_default();
        Ok(Box::new(move || {
            shop.look();
            Ok(states(&inputs, &outputs, |switch| reads(&shop, switch)))
        }))
    }
}

/// The machine, whose controller has told what its inputs read.
fn looked_at(which: &Which) -> Result<Shop> {
    let mut shop = Shop::open_after(which, First::LOOK, false)?;
    for _ in 0..if shop.controller.is_some() { LOOKS } else { 0 } {
        shop.look();
        sleep(LOOK);
    }
    Ok(shop)
}

/// The inputs of which a controller tells, and the outputs that it has.
fn has(shop: &Shop) -> Option<(Vec<u8>, Vec<u8>)> {
    let driven = shop.controller.as_ref()?.driven();
    let driven = driven.borrow();
    let facts = driven.facts();
    Some((lines(facts.inputs).collect(), lines(facts.outputs).collect()))
}

fn reads(shop: &Shop, Switch { is_output, number }: Switch) -> bool {
    shop.session
        .look(|model| if is_output { model.outputs().is_on(number) } else { model.input(number) })
}

fn states(inputs: &[u8], outputs: &[u8], is_on: impl Fn(Switch) -> bool) -> Vec<State> {
    let sides = [(true, outputs), (false, inputs)];
    let all = sides.into_iter().flat_map(|(is_output, numbers)| {
        numbers.iter().map(move |number| Switch { is_output, number: *number })
    });
    let state = |switch: Switch| State {
        is_output: switch.is_output,
        address: switch.number.to_string(),
        name: output_name(switch.number).filter(|_| switch.is_output).unwrap_or_default().into(),
        on: is_on(switch),
        about: String::new(),
    };
    all.map(state).collect()
}
