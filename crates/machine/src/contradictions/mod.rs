//! Settings that contradict each other, refused by name before anything moves.

mod motors;
mod pendant;
mod ranges;
mod speeds;
mod tools;

use crate::Configuration;

/// Settings that cannot all hold.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Contradiction {
    /// The settings, the one most likely wrong first.
    pub keys: Vec<&'static str>,
    /// The contradiction in words; names the settings.
    pub message: String,
    /// Way to mend it.
    pub hint: &'static str,
}

impl Contradiction {
    fn new(keys: &[&'static str], message: impl Into<String>, hint: &'static str) -> Self {
        Self { keys: keys.into(), message: message.into(), hint }
    }
}

type Check = fn(&Configuration, &mut Vec<Contradiction>);

const CHECKS: &[Check] = &[
    motors::one_axis_each,
    motors::heads,
    motors::pairs,
    motors::tangential,
    motors::pulses,
    ranges::limits,
    ranges::heights,
    ranges::homes,
    ranges::ports,
    speeds::cutting,
    speeds::height,
    speeds::homing,
    pendant::keys,
    tools::home_input,
    tools::shared_input,
    tools::jigs,
    tools::start_sequences,
    tools::laser,
];

/// Everything that contradicts itself in a configuration.
pub fn contradictions(configuration: &Configuration) -> Vec<Contradiction> {
    let mut found = Vec::new();
    for check in CHECKS {
        check(configuration, &mut found);
    }
    found
}

#[cfg(test)]
mod tests;
