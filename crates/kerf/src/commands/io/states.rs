//! States of inputs and outputs, whichever machine has them: listed, and watched.

use crate::out;
use crate::stop::Stop;
use anyhow::Result;
use kerf_machine::Configuration;
use kerf_machine::lines::Input;
use kerf_machine::wiring::{INPUT_BITS, OUTPUT_BITS};
use kerf_model::ports::Ports;
use std::thread;
use std::time::{Duration, Instant};

/// Interval at which changes are looked for.
const LOOK: Duration = Duration::from_millis(50);

/// An input or output, and its state.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct State {
    pub is_output: bool,
    /// Port and bit, or its number.
    pub address: String,
    pub name: String,
    pub on: bool,
    /// Its other names and its purpose.
    pub about: String,
}

/// All states, as often as they are asked for.
pub type States = Box<dyn FnMut() -> Result<Vec<State>>>;

impl State {
    const fn side(&self) -> &'static str {
        if self.is_output { "output" } else { "input" }
    }

    /// A line of a list.
    pub fn line(&self) -> String {
        let Self { address, name, on, about, .. } = self;
        let line = format!("{:<7}{address:<4}{name:<18}{} {about}", self.side(), u8::from(*on));
        format!("{}\n", line.trim_end())
    }

    fn change(&self) -> String {
        let words = [self.side(), &self.address, &self.name, if self.on { "1" } else { "0" }];
        let words: Vec<_> = words.into_iter().filter(|word| !word.is_empty()).collect();
        format!("{}\n", words.join(" "))
    }
}

/// The bits of a card.
pub fn of_card(ports: &Ports, machine: &Configuration) -> Vec<State> {
    let sides = [(true, OUTPUT_BITS), (false, INPUT_BITS)];
    let all = sides
        .into_iter()
        .flat_map(|(is_output, bits)| bits.iter().map(move |bit| (is_output, bit)));
    let state = |(is_output, bit): (bool, &kerf_machine::wiring::Bit)| {
        let input = Input::named(bit.name).filter(|_| !is_output);
        State {
            is_output,
            address: bit.address(),
            name: input.and_then(|it| machine.name_in_use(it)).unwrap_or(bit.name).into(),
            on: ports.is_on(is_output, bit),
            about: format!("{:<22}{}", bit.aliases.join(", "), bit.about),
        }
    };
    all.map(state).collect()
}

/// Prints every change as it happens, for so many seconds where they are given.
pub fn watch(mut states: States, seconds: Option<f64>) -> Result<()> {
    let stop = Stop::listen()?;
    let (began, mut before) = (Instant::now(), states()?);
    let is_over = || stop.is_wanted() || stop.leaves();
    while !is_over() && seconds.is_none_or(|most| began.elapsed().as_secs_f64() < most) {
        thread::sleep(LOOK);
        let now = states()?;
        let changed = now.iter().zip(&before).filter(|(now, before)| now.on != before.on);
        changed.for_each(|(now, _)| out::print(&now.change()));
        before = now;
    }
    Ok(())
}
