//! The state of the machine as its commands leave it: where it stands, and which outputs are on.

use kerf_machine::lines::Output;
use kerf_program::Axes;

/// Place and outputs.
#[derive(Clone, Debug)]
pub(crate) struct Head {
    /// Place after the last motion, machine frame.
    pub position: Axes,
    /// Motions given so far.
    pub motions: u64,
    /// Outputs that are on, a bit each.
    on: u32,
}

impl Head {
    /// At a place, everything off.
    pub const fn at(position: Axes) -> Self {
        Self { position, motions: 0, on: 0 }
    }

    pub const fn is_on(&self, output: Output) -> bool {
        self.on & bit(output) != 0
    }

    /// Switches an output; `true` when that changes it.
    pub const fn switch(&mut self, output: Output, on: bool) -> bool {
        let changes = self.is_on(output) != on;
        if changes {
            self.on ^= bit(output);
        }
        changes
    }

    pub const fn all_off(&mut self) {
        self.on = 0;
    }
}

const fn bit(output: Output) -> u32 {
    1 << output.number()
}
