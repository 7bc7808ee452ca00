//! Things that a board does at a clock: by time, and in the order in which they were set where times are equal.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// A thing that becomes due: of which object.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Event {
    Step(u8),
    Unstep(u8),
    Report(u8),
    Expire(u8),
    Look(u8),
    Output(u8),
    Watch(u8),
    Buttons(u8),
    Analog(u8),
    Answer(u8),
    Stats,
}

#[derive(Clone, Debug, Default)]
pub struct Events {
    heap: BinaryHeap<Reverse<(u64, u64, Event)>>,
    order: u64,
}

impl Events {
    pub fn set(&mut self, clock: u64, event: Event) {
        self.order += 1;
        self.heap.push(Reverse((clock, self.order, event)));
    }

    pub fn drop(&mut self, event: Event) {
        self.heap.retain(|Reverse((_, _, other))| *other != event);
    }

    pub fn clear(&mut self) {
        self.heap.retain(|Reverse((_, _, event))| matches!(event, Event::Stats | Event::Analog(_)));
    }

    pub fn next(&mut self, until: u64) -> Option<(u64, Event)> {
        let Reverse((clock, _, _)) = self.heap.peek()?;
        if *clock > until {
            return None;
        }
        self.heap.pop().map(|Reverse((clock, _, event))| (clock, event))
    }
}
