//! Outputs of a controller: what a run wants on, and what was ordered so far.

/// Lines that an output can have.
const LINES: u8 = u32::BITS as u8;

/// Outputs by bits: line 1 is the lowest.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct OrderedOutputs {
    wanted: u32,
    ordered: u32,
    /// On from before, as far as anybody knows: whatever such an output is switched to is ordered.
    left: u32,
}

impl OrderedOutputs {
    /// Outputs that were left on by what was before.
    pub const fn left_on(outputs: u32) -> Self {
        Self { wanted: outputs, ordered: outputs, left: outputs }
    }

    /// Returns those that are on, as they were ordered.
    pub const fn on(&self) -> u32 {
        self.ordered
    }

    /// Returns `true` if any is on because this run ordered it.
    pub const fn has_own_on(&self) -> bool {
        self.ordered & !self.left != 0
    }

    /// The output of a line, counted from 1, is to be on or off from here on.
    pub const fn want(&mut self, line: u8, on: bool) {
        let bit = 1 << (line - 1);
        self.wanted = if on { self.wanted | bit } else { self.wanted & !bit };
        if self.left & bit != 0 {
            self.left &= !bit;
            self.ordered = self.ordered & !bit | bit & !self.wanted;
        }
    }

    /// Nothing is to be on.
    pub const fn want_none(&mut self) {
        self.wanted = 0;
    }

    /// Everything went off, whatever is wanted.
    pub const fn went_off(&mut self) {
        (self.ordered, self.left) = (0, 0);
    }

    /// Returns what is to be ordered so that everything is as it is wanted, each line with its state, lowest first; it counts
    /// as ordered.
    pub fn take_orders(&mut self) -> impl Iterator<Item = (u8, bool)> + use<> {
        let wanted = self.wanted;
        let changed = wanted ^ std::mem::replace(&mut self.ordered, wanted);
        let is_set = |bits: u32, line: u8| bits & 1 << (line - 1) != 0;
        let changed = (1..=LINES).filter(move |line| is_set(changed, *line));
        changed.map(move |line| (line, is_set(wanted, line)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn orders(outputs: &mut OrderedOutputs) -> Vec<(u8, bool)> {
        outputs.take_orders().collect()
    }

    #[test]
    fn only_changes_are_ordered() {
        let mut outputs = OrderedOutputs::default();
        outputs.want(3, true);
        outputs.want(1, true);
        assert_eq!(orders(&mut outputs), [(1, true), (3, true)]);
        outputs.want(3, true);
        assert_eq!(orders(&mut outputs), []);
        outputs.want(1, false);
        assert_eq!(orders(&mut outputs), [(1, false)]);
        assert!(outputs.has_own_on());
    }

    #[test]
    fn one_that_was_left_on_is_ordered_whatever_it_is_switched_to() {
        for on in [false, true] {
            let mut outputs = OrderedOutputs::left_on(0b10);
            assert!(!outputs.has_own_on());
            assert_eq!(orders(&mut outputs), []);
            outputs.want(2, on);
            assert_eq!(orders(&mut outputs), [(2, on)]);
        }
    }

    #[test]
    fn what_a_stop_switched_off_is_ordered_again_with_the_next_move() {
        let mut outputs = OrderedOutputs::default();
        outputs.want(1, true);
        assert_eq!(orders(&mut outputs), [(1, true)]);
        outputs.went_off();
        assert_eq!((outputs.on(), orders(&mut outputs)), (0, vec![(1, true)]));
        outputs.want_none();
        outputs.went_off();
        assert_eq!(orders(&mut outputs), []);
    }
}
