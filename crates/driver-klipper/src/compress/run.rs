//! Steps of one command in the making: windows of time, and whole numbers that pass through all of them.

use super::Steps;

/// Most windows of a command: bounds the memory of a motor.
const MOST_WINDOWS: usize = 4096;
/// Values of `add` beside the best one that are tried where no whole interval fits that.
const BESIDE: i64 = 3;

/// A window divided by the number of its step: the interval has to lie in it, less `add` times the middle.
#[derive(Clone, Copy, Debug)]
struct Slot {
    low: f64,
    high: f64,
    /// (k − 1) / 2.
    middle: f64,
}

/// The command in the making.
#[derive(Clone, Debug)]
pub struct Run {
    from: u64,
    forward: bool,
    slots: Vec<Slot>,
    /// Number of steps, to the newest window.
    count: u16,
    /// Least first interval.
    least: u32,
    interval: i64,
    add: i64,
}

impl Run {
    /// An empty one that counts from a clock.
    pub const fn new(from: u64) -> Self {
        Self { from, forward: false, slots: Vec::new(), count: 0, least: 0, interval: 0, add: 0 }
    }

    /// Clock from which the steps count.
    pub const fn from(&self) -> u64 {
        self.from
    }

    /// Begins with a step; false where its window is too early.
    pub fn begin(&mut self, forward: bool, window: [f64; 2], more: u16, least: u32) -> bool {
        (self.forward, self.least) = (forward, least);
        self.extend(window, more, least)
    }

    /// Adds so many steps the same way, the last of them with a window; false where no numbers pass through all windows.
    pub fn extend(&mut self, [low, high]: [f64; 2], more: u16, least: u32) -> bool {
        let before = self.count;
        let Some(count) = before.checked_add(more).filter(|_| self.slots.len() < MOST_WINDOWS)
        else {
            return false;
        };
        self.count = count;
        let k = f64::from(count);
        let from = self.from as f64;
        let slot = Slot { low: (low - from) / k, high: (high - from) / k, middle: 0.5 * (k - 1.0) };
        self.slots.push(slot);
        let solved = (self.slots.len() > 1 && self.holds(slot, least)) || self.solve(least);
        if !solved {
            self.slots.pop();
            self.count = before;
        }
        solved
    }

    /// Ends the command; nothing where it has no step.
    pub fn close(&mut self) -> Option<Steps> {
        let count = Some(self.count).filter(|count| *count > 0)?;
        let add = if count > 1 { self.add as i16 } else { 0 };
        let (forward, from, interval) = (self.forward, self.from, self.interval as u32);
        let steps = Steps { forward, from, interval, count, add };
        self.from = steps.to();
        self.slots.clear();
        self.count = 0;
        Some(steps)
    }

    /// The numbers found so far pass through the newest window too.
    fn holds(&self, slot: Slot, least: u32) -> bool {
        let value = self.interval as f64 + self.add as f64 * slot.middle;
        let last = self.interval + self.add * (i64::from(self.count) - 1);
        value >= slot.low && value <= slot.high && last >= i64::from(least)
    }

    /// Seeks numbers that pass through all windows, as far from their ends as can be.
    ///
    /// For each `add` the interval has a lowest and a highest value. Their difference is concave in `add`, so the best
    /// one is found by halving.
    fn solve(&mut self, least: u32) -> bool {
        let [mut low, mut high] = self.adds();
        while low < high {
            let middle = low + (high - low) / 2;
            if self.width(middle, least) < self.width(middle + 1, least) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        let beside = (0..=BESIDE).flat_map(|n| [low - n, low + n]);
        let mut fitting = beside.filter(|add| i16::try_from(*add).is_ok());
        let found = fitting.find_map(|add| Some((self.interval(add, least)?, add)));
        if let Some((interval, add)) = found {
            (self.interval, self.add) = (interval, add);
        }
        found.is_some()
    }

    /// Bounds of `add`, from the newest window and the one half-way to it.
    fn adds(&self) -> [i64; 2] {
        let count = self.slots.len();
        if count < 2 {
            return [0, 0];
        }
        let (half, last) = (self.slots[count / 2 - 1], self.slots[count - 1]);
        let apart = last.middle - half.middle;
        let bound = |add: f64| add.clamp(f64::from(i16::MIN), f64::from(i16::MAX)) as i64;
        [bound((last.low - half.high) / apart), bound((last.high - half.low) / apart)]
    }

    /// Lowest and highest interval with an `add`.
    fn bounds(&self, add: i64, least: u32) -> [f64; 2] {
        let slope = add as f64;
        let last = f64::from(least) - slope * (f64::from(self.count) - 1.0);
        let mut low = last.max(f64::from(self.least));
        let mut high = f64::from(i32::MAX);
        for slot in &self.slots {
            low = low.max(slot.low - slope * slot.middle);
            high = high.min(slot.high - slope * slot.middle);
        }
        [low, high]
    }

    fn width(&self, add: i64, least: u32) -> f64 {
        let [low, high] = self.bounds(add, least);
        high - low
    }

    /// The whole interval nearest to the middle of its bounds.
    fn interval(&self, add: i64, least: u32) -> Option<i64> {
        let [low, high] = self.bounds(add, least);
        let middle = (0.5 * (low + high)).round();
        (middle >= low && middle <= high).then_some(middle as i64)
    }
}
