//! Height control of a torch: by the voltage of its arc, or by two switches of its head.

use super::question::{Question, Step};
use super::{Ends, Told, Wizard, get, put};
use crate::controller::queued::pins::entries;
use crate::controller::queued::steering::SWITCHES;
use kerf_machine::settings::height::HeightMode;

const INPUTS: &str = "board.inputs";
const VOLTAGE: &str = "board.height";

impl Wizard<'_, '_> {
    /// Asks for the pins of a torch, where there is one.
    pub(super) fn torch(&mut self) -> Told {
        if self.ask(Question::of(Step::Torch, "", ""))? != "y" {
            return Ok(());
        }
        self.setting(Step::TorchVoltage, "", VOLTAGE)?;
        loop {
            let inputs = get(&self.machine, INPUTS);
            let answer =
                self.ask(Question::of(Step::TorchSwitches, "", switches(&inputs).join(" ")))?;
            let pins: Vec<&str> = answer.split_whitespace().collect();
            let inputs = match pins[..] {
                [] => break,
                ["-"] => without_switches(&inputs),
                [high, low] => with_switches(&inputs, [high, low]),
                _ => {
                    self.tell("Name two pins, too high and too low: ^gpio10 ^gpio11");
                    continue;
                }
            };
            put(&mut self.machine, INPUTS, &inputs).map_err(Ends::Failed)?;
            break;
        }
        let measures = !get(&self.machine, VOLTAGE).is_empty();
        self.machine.height.mode =
            if measures { HeightMode::Proportional } else { HeightMode::Simple };
        Ok(())
    }
}

/// An entry is that of a switch of the head.
fn is_switch(entry: &str, number: u8) -> bool {
    entry.split_whitespace().next() == Some(&*number.to_string())
}

/// The pins of the two switches among inputs.
fn switches(inputs: &str) -> Vec<String> {
    let pin = |number: u8| {
        let entry = entries(inputs).find(|entry| is_switch(entry, number))?;
        entry.split_whitespace().nth(1).map(str::to_owned)
    };
    SWITCHES.into_iter().filter_map(|input| pin(input.number())).collect()
}

/// Inputs but for the two switches.
fn without_switches(inputs: &str) -> String {
    let is_other = |entry: &&str| !SWITCHES.into_iter().any(|it| is_switch(entry, it.number()));
    entries(inputs).filter(is_other).collect::<Vec<_>>().join(", ")
}

/// Inputs with the two switches at pins.
fn with_switches(inputs: &str, pins: [&str; 2]) -> String {
    let own = SWITCHES.into_iter().zip(pins);
    let own = own.map(|(input, pin)| format!("{} {pin}", input.number()));
    let others = without_switches(inputs);
    entries(&others).map(str::to_owned).chain(own).collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn switches_of_a_head_are_two_of_the_inputs() {
        let inputs = with_switches("3 ^gpio22, 17 gpio1", ["^gpio10", "^!gpio11"]);
        assert_eq!(inputs, "3 ^gpio22, 17 ^gpio10, 20 ^!gpio11");
        assert_eq!(switches(&inputs), ["^gpio10", "^!gpio11"]);
        assert_eq!(without_switches(&inputs), "3 ^gpio22");
        assert_eq!((switches(""), without_switches("")), (Vec::new(), String::new()));
    }
}
