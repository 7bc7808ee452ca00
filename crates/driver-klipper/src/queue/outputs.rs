//! Outputs that change at a clock, and are told again before the board's watch takes their host for dead.

use super::Lead;

/// Parts of the watch after which an output is told again.
const AGAIN: u64 = 4;

/// An output changes at a clock.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Change {
    /// Its place among all outputs: those that go on and off, then those with a share of time.
    pub output: usize,
    /// Clock.
    pub clock: u64,
    /// Its value as the board takes it.
    pub value: u32,
}

/// An output as the board knows it.
#[derive(Clone, Copy, Debug)]
struct Output {
    /// Ticks after which the board shuts down when it was not told again; 0 for never.
    watch: u64,
    /// Value at which it is off.
    off: u32,
    /// Newest change that was sent.
    last: Option<Change>,
}

/// All outputs of a board.
#[derive(Clone, Debug)]
pub struct Outputs(Vec<Output>);

impl Outputs {
    pub fn new(outputs: &[(u64, u32)]) -> Self {
        Self(
            outputs
                .iter()
                .map(|(watch, off)| Output { watch: *watch, off: *off, last: None })
                .collect(),
        )
    }

    /// Notes a change that goes out, at the earliest at a clock and behind the one before; returns it as it goes.
    pub fn sent(&mut self, change: Change, earliest: u64) -> Change {
        let Some(output) = self.0.get_mut(change.output) else { return change };
        let behind = output.last.map_or(0, |last| last.clock + 1);
        let change = Change { clock: change.clock.max(earliest).max(behind), ..change };
        output.last = Some(change);
        change
    }

    /// Changes that put all outputs off that have a watch and are on, or that were told to go on later. What has none gives
    /// motors their current.
    pub fn off(&self) -> impl Iterator<Item = Change> {
        let off = |output: &Output| {
            let last = output.last.filter(|last| output.watch > 0 && last.value != output.off);
            last.map(|last| Change { clock: 0, value: output.off, ..last })
        };
        self.0.iter().filter_map(off)
    }

    /// Outputs are off, and no change is on its way.
    pub fn forget(&mut self) {
        self.0.iter_mut().for_each(|output| output.last = None);
    }

    /// Changes that tell again what stands, for outputs that are on: ahead by the shortest lead, and by less than the watch,
    /// beyond which the board takes none.
    pub fn again(&mut self, now: u64, lead: &Lead) -> impl Iterator<Item = Change> + use<> {
        let clock = |output: &Output| now + lead.least().min(output.watch / 2);
        let due = |output: &&mut Output| {
            let on = output.last.filter(|last| last.value != output.off && output.watch > 0);
            on.is_some_and(|last| last.clock + output.watch / AGAIN <= clock(output))
        };
        let again = |output: &mut Output| {
            let clock = clock(output);
            let change = output.last.map(|last| Change { clock, ..last });
            output.last = change;
            change
        };
        let told: Vec<Change> = self.0.iter_mut().filter(due).filter_map(again).collect();
        told.into_iter()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_output_is_told_again_within_its_watch_however_long_the_lead_is() {
        let lead = Lead::new(1e6).of_deadline(2.0);
        let watch = 500_000;
        let mut outputs = Outputs::new(&[(watch, 0)]);
        let mut last = outputs.sent(Change { output: 0, clock: 0, value: 1 }, 0).clock;
        for now in (0..3_000_000).step_by(5_000) {
            for change in outputs.again(now, &lead) {
                assert!(
                    change.clock > now && change.clock - last <= watch,
                    "{now} {last} {change:?}"
                );
                last = change.clock;
            }
            assert!(last + watch > now, "{now}: it was told last for {last}");
        }
    }
}
