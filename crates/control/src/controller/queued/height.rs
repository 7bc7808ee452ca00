//! Z that follows the sheet, on a board that measures the voltage of a torch or looks at the switches of its head.
//!
//! Motion is handed to the board some tenths of a second before it is made, so a reading tells of a place that Z has left
//! long since. It is compared with the place that Z had when it was taken: where the sheet is follows from it however long
//! ago that was, and Z does not swing. What a sheet rises in the meantime is what Z is behind. A switch that lets go tells a
//! place in the same way: Z goes back to where it was then.
//!
//! ```text
//!  reading ─► error at its moment ─► height of the sheet ─► Follower: speed, acceleration ─► steps of the next piece
//!                     ▲
//!             ticks: Z as it was handed over
//! ```

use super::feeder::Scale;
use super::steering::Steering;
use kerf_driver_klipper::board::Measured;
use kerf_machine::height_follower::{
    Follower, SILENCE_S, TICK_S, goes_down, is_above_band, listens_in,
};
use kerf_machine::lines::Input;
use kerf_machine::{Lift, LiftOfMove, Reading};
use kerf_motion::{Leg, Move};
use kerf_program::{Axis, HeightLaw};
use std::collections::VecDeque;

/// Time between two measurements, seconds.
pub const EVERY_S: f64 = 0.01;
/// A gap of so many units or less is no reading: the torch is out, or its cable is broken.
const MISSING: f64 = 0.5;
/// The largest reading.
const FULL: f64 = 255.0;
/// Readings after which it is known how far Z is behind them.
const SOME: usize = 30;
/// Ticks after which it is known how far Z is behind switches.
const SOME_TICKS: usize = 300;
/// Time for which what was handed over is remembered behind a move that was told, seconds.
const REMEMBERED_S: f64 = 1.0;
/// Time that a reading may need from the board, beside that between two of them, seconds.
const WAY_S: f64 = 0.04;

/// A stretch of motion that was handed over.
#[derive(Clone, Copy, Debug)]
struct Tick {
    /// Moments at which it begins and ends, seconds of machine time.
    span_s: [f64; 2],
    /// Distance by which Z is carried there, mm.
    offset_mm: [f64; 2],
    /// Planned height, mm.
    z_mm: f64,
    /// The reading that is wanted; nothing where Z is the plan's own.
    wanted: Option<f64>,
    /// Readings are awaited.
    listens: bool,
}

impl Tick {
    fn offset_at(&self, t_s: f64) -> f64 {
        let [from_s, to_s] = self.span_s;
        let share = ((t_s - from_s) / (to_s - from_s)).clamp(0.0, 1.0);
        self.offset_mm[0] + share * (self.offset_mm[1] - self.offset_mm[0])
    }
}

/// Height control, from its beginning to its end.
#[derive(Clone, Debug)]
pub struct Height {
    law: HeightLaw,
    steering: Steering,
    follower: Follower,
    /// Stretches that were handed over, in order of time.
    ticks: VecDeque<Tick>,
    /// Stretches of the way to rest, behind `ticks`.
    tail: Vec<Tick>,
    readings: Vec<Reading>,
    /// The moment of the last reading, seconds of machine time.
    read_s: f64,
    /// States that were told: above its band, silent, in conflict, at zero.
    told: [bool; 4],
    /// Longest time from a reading to the motion that follows it, seconds.
    behind_s: f64,
}

impl Height {
    /// Z follows from a place on; `reading` is the last one that came.
    pub fn new(law: HeightLaw, steering: Steering, reading: Option<f64>) -> Self {
        let is_high = |reading| is_missing(&law, reading) || is_above_band(&law, reading);
        let high = steering == Steering::Readings && reading.is_none_or(is_high);
        Self {
            law,
            steering,
            follower: Follower::default(),
            ticks: VecDeque::new(),
            tail: Vec::new(),
            readings: Vec::new(),
            read_s: f64::NEG_INFINITY,
            told: [high, false, false, false],
            behind_s: 0.0,
        }
    }

    /// Z follows by the law of a torch from now on, and stays where it is carried; or a torch leads it no more.
    pub fn follow_torch(height: &mut Option<Self>, torch: Option<(HeightLaw, Steering)>) {
        let before = height.as_mut().filter(|it| matches!(it.steering, Steering::Torch { .. }));
        match (torch, before) {
            (Some(torch), Some(before)) => (before.law, before.steering) = torch,
            (Some((law, steering)), None) => *height = Some(Self::new(law, steering, None)),
            (None, Some(_)) => *height = None,
            (None, None) => {}
        }
    }

    /// The head is above its band, as far as readings tell; nothing where there are none.
    pub fn is_high(&self) -> Option<bool> {
        self.reads().then_some(self.told[0])
    }

    fn reads(&self) -> bool {
        self.steering == Steering::Readings
    }

    /// A move goes down to the sheet, and readings end it.
    pub fn listens_in(&self, made: &Move) -> bool {
        listens_in(&self.law, made)
    }

    /// A move goes down to the sheet, and a switch of the head ends it.
    pub fn stops_in(&self, made: &Move) -> bool {
        matches!(self.steering, Steering::Switches(_)) && goes_down(&self.law, made)
    }

    /// Longest time from a reading, or a look at the switches, to the motion that follows it, seconds.
    pub const fn behind_s(&self) -> f64 {
        self.behind_s
    }

    /// It has followed for long enough to tell how far Z is behind.
    fn is_known(&self) -> bool {
        if self.reads() {
            self.readings.len() > SOME
        } else {
            self.behind_s > 0.0 && self.ticks.len() > SOME_TICKS
        }
    }

    /// The place to which Z was carried is that of the plan from now on.
    pub fn land(&mut self) {
        self.follower = Follower::default();
        self.ticks.clear();
        self.tail.clear();
    }

    /// Carries Z between two times of a plan that begins at a moment, as it is handed over. It stands at the end where the
    /// machine does.
    pub fn carry(&mut self, leg: &Leg, t0_s: f64, [from_s, to_s]: [f64; 2]) -> Lift {
        let end_s = if leg.rests() { leg.span_s()[1] } else { f64::INFINITY };
        let ticks = ((to_s - from_s) / TICK_S).ceil().max(1.0) as u32;
        let each_s = (to_s - from_s) / f64::from(ticks);
        let mut lift = Lift::still(self.follower.offset_mm);
        lift.carry(t0_s + from_s, self.follower.offset_mm);
        for n in 0..ticks {
            let at_s = from_s + f64::from(n) * each_s;
            let most_mm_s = self.law.accel_mm_s2 * (end_s - at_s - each_s).max(0.0);
            let tick = self.tick(leg, t0_s, [at_s, at_s + each_s], most_mm_s);
            lift.carry(tick.span_s[1], tick.offset_mm[1]);
            self.ticks.push_back(tick);
        }
        if self.read_s > f64::NEG_INFINITY
            && self.ticks.back().is_some_and(|it| it.wanted.is_some())
        {
            self.behind_s = self.behind_s.max(t0_s + from_s - self.read_s);
        }
        self.tail.clear();
        lift
    }

    fn tick(&mut self, leg: &Leg, t0_s: f64, [at_s, to_s]: [f64; 2], most_mm_s: f64) -> Tick {
        let before_mm = self.follower.offset_mm;
        let under_way = leg.under_way(at_s);
        let (mut wanted, mut listens, mut z_mm) = (None, false, 0.0);
        if let Some((made, state)) = under_way {
            z_mm = state.position[Axis::Z];
            let [vx, vy, _] = state.velocity.first3();
            let acts = self.steering.acts_in(&self.law, made)
                && state.path_speed_mm_s >= self.law.activation * made.speed_mm_s;
            wanted = acts.then(|| self.law.set_point(vx, vy));
            listens = acts || listens_in(&self.law, made);
        }
        let time_s = to_s - at_s;
        let made = under_way.map(|(made, _)| made).filter(|_| wanted.is_some());
        let speed_mm_s = made.map_or(0.0, |made| {
            let steered_mm_s = self.steering.speed_mm_s(made);
            steered_mm_s.unwrap_or_else(|| self.follower.towards(&self.law, time_s))
        });
        let speed_mm_s = speed_mm_s.clamp(-most_mm_s, most_mm_s);
        self.follower.go(z_mm, &self.law, speed_mm_s, time_s);
        let offset_mm = [before_mm, self.follower.offset_mm];
        Tick { span_s: [t0_s + at_s, t0_s + to_s], offset_mm, z_mm, wanted, listens }
    }

    /// Lets Z come to rest on the way to rest that begins at a moment, seconds of machine time.
    pub fn coast(&mut self, from_s: f64) -> Lift {
        let mut follower = self.follower;
        let mut lift = Lift::still(follower.offset_mm);
        lift.carry(from_s, follower.offset_mm);
        let (mut at_s, z_mm) = (from_s, self.ticks.back().map_or(0.0, |it| it.z_mm));
        self.tail.clear();
        while !follower.stands() {
            let before_mm = follower.offset_mm;
            follower.go(z_mm, &self.law, 0.0, TICK_S);
            let (span_s, offset_mm) = ([at_s, at_s + TICK_S], [before_mm, follower.offset_mm]);
            self.tail.push(Tick { span_s, offset_mm, z_mm, wanted: None, listens: false });
            at_s += TICK_S;
            lift.carry(at_s, follower.offset_mm);
        }
        lift
    }

    /// The way to rest behind the last piece was made.
    pub fn coasted(&mut self) {
        self.ticks.extend(std::mem::take(&mut self.tail));
    }

    /// The machine stands at a moment, whatever was handed over behind it.
    pub fn stands(&mut self, t_s: f64) {
        let offset_mm = self.offset_at(t_s);
        self.ticks.retain(|tick| tick.span_s[0] < t_s);
        self.tail.clear();
        self.follower = Follower::standing(offset_mm);
    }

    /// Distance by which Z is carried at a moment, mm.
    pub fn offset_at(&self, t_s: f64) -> f64 {
        let behind = self.ticks.partition_point(|tick| tick.span_s[0] <= t_s);
        match (behind.checked_sub(1).and_then(|n| self.ticks.get(n)), self.ticks.front()) {
            (Some(tick), _) => tick.offset_at(t_s),
            (None, Some(first)) => first.offset_mm[0],
            (None, None) => self.follower.offset_mm,
        }
    }

    fn tick_at(&self, t_s: f64) -> Option<&Tick> {
        let behind = self.ticks.partition_point(|tick| tick.span_s[0] <= t_s);
        let tick = behind.checked_sub(1).and_then(|n| self.ticks.get(n));
        tick.filter(|tick| t_s <= tick.span_s[1])
    }

    /// Takes a reading, 0 … 255, of a moment of machine time.
    pub fn read(&mut self, value: f64, t_s: f64) {
        if is_missing(&self.law, value) {
            return;
        }
        self.read_s = self.read_s.max(t_s);
        let Some(tick) = self.tick_at(t_s).copied() else { return };
        let offset_mm = tick.offset_at(t_s);
        let Some(wanted) = tick.wanted else { return };
        self.follower.aim(&self.law, offset_mm, value - wanted);
        let error_mm = self.law.gap_mm(value) - self.law.gap_mm(wanted);
        let z_mm = tick.z_mm + offset_mm;
        self.readings.push(Reading { t_s, z_mm, error_mm, value: value.round() as u8 });
    }

    /// Learns the states of inputs by number, as they are at a moment of machine time; nothing where none passes.
    pub fn feel(&mut self, reads: impl Fn(u8) -> bool, now_s: Option<f64>) {
        let changed = self.steering.learn(&self.law, reads);
        let (Some(now_s), Some(leads_mm)) = (now_s, self.steering.leads_mm()) else { return };
        let acts = self.tick_at(now_s).is_some_and(|tick| tick.wanted.is_some());
        self.read_s = now_s;
        if acts && leads_mm != 0.0 {
            self.follower.aim_at(self.offset_at(now_s) + leads_mm);
        } else if changed {
            self.follower.aim_at(self.offset_at(now_s));
        }
    }

    /// Changes that follow from switches, or from the readings up to a moment; `value` is the newest.
    fn changes(&mut self, value: f64, now_s: f64) -> Vec<(f64, Input, bool)> {
        let missing = self.reads() && is_missing(&self.law, value);
        let limit_s = SILENCE_S + EVERY_S + WAY_S;
        let awaits =
            [now_s - limit_s, now_s].map(|t_s| self.tick_at(t_s).is_some_and(|it| it.listens));
        let silent = self.reads() && awaits == [true, true] && now_s - self.read_s > limit_s;
        if silent {
            self.follower.stay();
        }
        let z_mm = self.tick_at(now_s).map(|tick| tick.z_mm + tick.offset_at(now_s));
        let carried = self.offset_at(now_s) > 0.0;
        let at_zero = carried && z_mm.is_some_and(|z_mm| z_mm >= self.law.ceiling_mm - 1e-9);
        // Where a switch tells that the head is too high, its input does.
        let high = missing || is_above_band(&self.law, value);
        let acts = self.tick_at(now_s).is_some_and(|tick| tick.wanted.is_some());
        let conflict = acts && self.steering.is_in_conflict();
        let is_so = [high, silent, conflict, at_zero];
        let before = std::mem::replace(&mut self.told, is_so);
        let inputs =
            [Input::ZHigh, Input::HeightSilent, Input::HeightConflict, Input::HeightAtZero];
        let states = inputs.into_iter().zip(is_so).zip(before);
        let changed = states.filter(|((_, now), before)| now != before);
        // What a reading tells was so when it was taken.
        let at_s = |input| if input == Input::ZHigh { self.read_s.min(now_s) } else { now_s };
        changed.map(|((input, on), _)| (at_s(input), input, on)).collect()
    }

    /// The way of Z beside the plan between two moments, with the readings up to then.
    pub fn made(&mut self, [begin_s, end_s]: [f64; 2]) -> LiftOfMove {
        let mut lift = Lift::still(self.offset_at(begin_s));
        lift.carry(begin_s, self.offset_at(begin_s));
        let within = |tick: &&Tick| tick.span_s[1] > begin_s && tick.span_s[0] < end_s;
        for tick in self.ticks.iter().filter(within) {
            let at_s = tick.span_s[1].min(end_s);
            lift.carry(at_s, tick.offset_at(at_s));
        }
        let over_s = end_s - REMEMBERED_S;
        while self.ticks.front().is_some_and(|tick| tick.span_s[1] < over_s) {
            self.ticks.pop_front();
        }
        let (readings, later) = self.readings.iter().partition(|reading| reading.t_s <= end_s);
        self.readings = later;
        LiftOfMove { lift, readings }
    }
}

/// A reading is the voltage of a torch that is out.
fn is_missing(law: &HeightLaw, value: f64) -> bool {
    law.gap_mm(value) <= MISSING * law.gap_mm(1.0).min(law.gap_mm(FULL - 1.0))
}

/// The pin that measures the height, and what it told.
#[derive(Clone, Debug, Default)]
pub struct Sensor {
    /// It is measured.
    pub measures: bool,
    /// The last reading, 0 … 255.
    value: Option<f64>,
    /// Changes that were not told to the run, each with its moment of machine time.
    changes: VecDeque<(f64, Input, bool)>,
    /// The operator knows how far Z is behind.
    told: bool,
}

impl Sensor {
    /// One of which nothing is known.
    pub fn new(measures: bool) -> Self {
        Self { measures, ..Self::default() }
    }

    /// The last reading.
    pub const fn reading(&self) -> Option<f64> {
        self.value
    }

    /// It was measured, while a board is in motion by a scale.
    pub fn measured(
        &mut self,
        all: &[Measured],
        scale: Option<Scale>,
        height: Option<&mut Height>,
    ) {
        let newest = all.last().map(|it| FULL * it.share);
        self.value = newest.or(self.value);
        let (Some(scale), Some(height)) = (scale, height) else { return };
        all.iter().for_each(|it| height.read(FULL * it.share, scale.moment(it.clock)));
    }

    /// Learns what follows at a moment of machine time from the readings up to then.
    pub fn look(&mut self, now_s: f64, height: Option<&mut Height>) {
        let Some(height) = height else { return };
        self.changes.extend(height.changes(self.value.unwrap_or(0.0), now_s));
    }

    /// The next change of an input that was not told, with its moment.
    pub fn take(&mut self) -> Option<(f64, (u8, bool))> {
        let (at_s, input, on) = self.changes.pop_front()?;
        Some((at_s, (input.number(), on)))
    }

    /// A sentence about how far Z is behind its readings, once and after some of them.
    pub fn tells(&mut self, name: &str, height: Option<&Height>) -> Option<String> {
        let height = height.filter(|it| !self.told && it.is_known())?;
        self.told = true;
        let [every_ms, behind_ms] = [EVERY_S, height.behind_s()].map(|time_s| time_s * 1e3);
        Some(if height.reads() {
            format!(
                "{name}: height control takes a reading every {every_ms:.0} ms, and Z answers it {behind_ms:.0} ms later"
            )
        } else {
            format!("{name}: height control has Z answer its switches {behind_ms:.0} ms later")
        })
    }
}
