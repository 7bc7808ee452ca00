//! Settings that contradict each other, refused by name before anything moves.

mod contradiction;
mod motors;
mod pendant;
mod ranges;
mod speeds;
mod tools;

pub use contradiction::Contradiction;

use crate::Configuration;

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
    ranges::warm_up,
    speeds::cutting,
    speeds::height,
    speeds::homing,
    pendant::keys,
    tools::home_input,
    tools::shared_input,
    tools::jigs,
    tools::start_sequences,
    tools::laser,
    tools::sensor,
    tools::plate,
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
