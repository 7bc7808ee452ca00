//! Keys of a pendant that are something else already.

use super::Contradiction;
use crate::Configuration;

/// The keys of the axes, by setting.
const AXIS_KEYS: [&str; 6] =
    ["pendant.x", "pendant.y", "pendant.z", "pendant.a", "pendant.b", "pendant.c"];

/// An input is one key, and none that stops the machine.
pub(super) fn keys(c: &Configuration, found: &mut Vec<Contradiction>) {
    if !c.program.display.has_pendant() {
        return;
    }
    let hint = "Each key has an input of its own that stops nothing, or 0.";
    let keys = keys_of(c);
    for (i, (key, input)) in keys.iter().enumerate() {
        if let Some((other, _)) = keys[..i].iter().find(|(_, earlier)| earlier == input) {
            let message = format!("input {input} is a key of {other} and of {key}");
            found.push(Contradiction::new(&[key, other], message, hint));
        }
        if stops(c, *input) {
            let message = format!("input {input} is a key of {key} and stops the machine (VN)");
            found.push(Contradiction::new(&[key], message, hint));
        }
    }
}

/// Setting and input of each key that there is.
fn keys_of(c: &Configuration) -> Vec<(&'static str, u8)> {
    let axes = AXIS_KEYS.into_iter().zip(c.pendant.axes);
    let axes = axes.flat_map(|(key, inputs)| inputs.map(|input| (key, input)));
    let others = [("pendant.fast", c.pendant.fast), ("pendant.close", c.pendant.close)];
    axes.chain(others).filter(|(_, input)| *input != 0).collect()
}

/// Returns `true` if it is a limit, a stop, or the enclosure.
fn stops(c: &Configuration, input: u8) -> bool {
    let io = &c.program.io;
    let limit = matches!(io.inputs.get(usize::from(input) - 1), Some(1 | 2));
    limit || [false, true].into_iter().any(|reads| io.stops(input, reads))
}
