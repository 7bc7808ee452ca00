//! Outputs that change at a clock, and are told again before the board's watch takes their host for dead.

use super::{Lead, Release};

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

/// The board's rules for an output.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rules {
    /// Ticks after which the board shuts down when it was not told again; 0 for never.
    pub watch: u64,
    /// Value at which it is off.
    pub off: u32,
    /// It may be told to change now, whenever that is, while no change of it is queued in the board.
    pub at_once: bool,
}

/// An output as the board knows it.
#[derive(Clone, Copy, Debug)]
struct Output {
    rules: Rules,
    /// Newest change that was sent; nothing where that was a former session's.
    last: Option<Change>,
}

/// All outputs of a board.
#[derive(Clone, Debug)]
pub struct Outputs(Vec<Output>);

impl Outputs {
    pub fn new(outputs: &[Rules]) -> Self {
        Self(outputs.iter().map(|rules| Output { rules: *rules, last: None }).collect())
    }

    /// Notes a change that is wanted as soon as may be, and returns it as it goes. A queue in the board that is surely empty
    /// is passed by, so the change may come late; else it has a clock that a command which is sent twice still comes before.
    pub fn soon(
        &mut self,
        output: usize,
        value: u32,
        [now, off]: [u64; 2],
        lead: &Lead,
    ) -> Release {
        let known = self.0.get_mut(output);
        let idle = known
            .filter(|it| it.rules.at_once && it.last.is_some_and(|last| last.clock + off < now));
        if let Some(idle) = idle {
            idle.last = Some(Change { output, clock: now, value });
            return Release::AtOnce { output, value };
        }
        let change = Change { output, clock: 0, value };
        Release::Output(self.sent(change, now + off + lead.transit()))
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
    pub fn off(&self) -> impl Iterator<Item = Release> {
        let off = |Output { rules, last }: &Output| {
            let last = last.filter(|last| rules.watch > 0 && last.value != rules.off);
            last.map(|last| Release::AtOnce { output: last.output, value: rules.off })
        };
        self.0.iter().filter_map(off)
    }

    /// Outputs that have a watch, with the values at which they are off.
    pub fn watched(&self) -> impl Iterator<Item = (usize, u32)> {
        let rules = self.0.iter().map(|it| it.rules).enumerate();
        rules.filter(|(_, rules)| rules.watch > 0).map(|(output, rules)| (output, rules.off))
    }

    /// Outputs are off, and no change is on its way.
    pub fn forget(&mut self) {
        self.0.iter_mut().for_each(|output| output.last = None);
    }

    /// Changes that tell again what stands, for outputs that are on: at once where the board takes that, so that a frame which
    /// is lost is no matter; else ahead by the shortest lead, and by less than the watch, beyond which the board takes none.
    pub fn again(&mut self, [now, off_by]: [u64; 2], lead: &Lead) -> Vec<Release> {
        let again = |Output { rules: Rules { watch, off, at_once }, last }: &mut Output| {
            let on = last.filter(|last| last.value != *off && *watch > 0)?;
            let clock = if *at_once {
                now.saturating_sub(off_by)
            } else {
                now + lead.least().min(*watch / 2)
            };
            (on.clock + *watch / AGAIN <= clock).then(|| {
                let Change { output, value, .. } = on;
                let change = Change { clock, ..on };
                *last = Some(change);
                if *at_once { Release::AtOnce { output, value } } else { Release::Output(change) }
            })
        };
        self.0.iter_mut().filter_map(again).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Tells an output again for a quarter of a minute; returns the farthest ahead that it was told, ticks.
    fn told_ahead(at_once: bool) -> u64 {
        let lead = Lead::new(1e6).of_deadline(2.0);
        let watch = 500_000;
        let mut outputs = Outputs::new(&[Rules { watch, off: 0, at_once }]);
        let mut last = outputs.sent(Change { output: 0, clock: 0, value: 1 }, 0).clock;
        let mut farthest = 0;
        for now in (0..15_000_000).step_by(5_000) {
            for release in outputs.again([now, 0], &lead) {
                let clock = if let Release::Output(change) = release { change.clock } else { now };
                assert!(clock - last <= watch, "{now} {last} {release:?}");
                (last, farthest) = (clock, farthest.max(clock - now));
            }
            assert!(last + watch / 2 > now, "{now}: it was told last for {last}");
        }
        farthest
    }

    #[test]
    fn an_output_is_told_again_within_its_watch_however_long_the_lead_is() {
        assert_eq!([told_ahead(false), told_ahead(true)], [250_000, 0]);
    }
}
