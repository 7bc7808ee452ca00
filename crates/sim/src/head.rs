//! Height control on the simulated machine: Z beside the plan, and what the sensors of the head tell.

use crate::sheet::Sheet;
use kerf_machine::height_follower::{
    self as follower, Follower, Sensed, TICK_S, acts_in, is_above_band, listens_in,
};
use kerf_machine::lines::Input;
use kerf_machine::{Ahead, Lift, LiftOfMove, Reading};
use kerf_model::flips;
use kerf_model::{Change, Inputs};
use kerf_motion::{Plan, Span, State};
use kerf_program::settings::IoModes;
use kerf_program::{Axes, Axis, Gauge, HeightLaw};

/// The head, and Z while it follows the sheet.
#[derive(Clone, Debug, Default)]
pub(crate) struct Head {
    sheet: Option<Sheet>,
    /// Height control, while it is on.
    law: Option<HeightLaw>,
    follower: Follower,
}

/// Inputs of the machine that the head belongs to.
#[derive(Clone, Copy)]
pub(crate) struct Lent<'a> {
    pub inputs: &'a Inputs,
    pub modes: &'a IoModes,
}

/// Z while it follows the sheet: what one tick after the other makes of it.
struct Following<'a> {
    sheet: Option<Sheet>,
    modes: &'a IoModes,
    law: HeightLaw,
    follower: Follower,
    inputs: Inputs,
}

/// Result of one tick.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tick {
    t_s: f64,
    /// Distance that Z has been carried, mm.
    offset_mm: f64,
    /// Height of the tool, Z of the machine frame, mm.
    z_mm: f64,
    reading: Option<follower::Reading>,
    /// The sensor sends nothing.
    silent: bool,
    /// Faults that the controller looks for, and whether it notices each.
    faults: [(Input, bool); 3],
}

impl Tick {
    /// The reading that was taken in it.
    fn told(&self) -> Option<Reading> {
        let follower::Reading { value, error_mm } = self.reading?;
        Some(Reading { t_s: self.t_s, z_mm: self.z_mm, error_mm, value })
    }
}

impl Following<'_> {
    /// Ticks through a move, from a moment of the plan on.
    fn through(
        &mut self,
        t0_s: f64,
        plan: &Plan,
        span: &Span<'_>,
        from_s: f64,
        each: &mut dyn FnMut(&Tick),
    ) {
        let acts = acts_in(&self.law, span.made);
        if !acts && !listens_in(&self.law, span.made) {
            return;
        }
        let begin_s = span.t0_s.max(from_s);
        let ticks = ((span.t1_s - begin_s) / TICK_S).round().max(1.0) as u64;
        for tick in 0..ticks {
            let at_s = begin_s + tick as f64 * TICK_S;
            let (t_s, state) = (t0_s + at_s, plan.at(at_s));
            let tick = if acts {
                self.tick(t_s, &state, span.made.speed_mm_s)
            } else {
                self.listen(t_s, &state)
            };
            each(&tick);
        }
    }

    /// On the way down to the sheet Z is the plan's: the controller only misses readings.
    fn listen(&mut self, t_s: f64, state: &State) -> Tick {
        while self.inputs.step(t_s, self.modes).is_some() {}
        let silent = self.is_silent();
        self.follower.listen(silent);
        let offset_mm = self.follower.offset_mm;
        let faults = [
            (Input::HeightSilent, self.follower.is_lost()),
            (Input::HeightConflict, false),
            (Input::HeightAtZero, false),
        ];
        let z_mm = state.position[Axis::Z] + offset_mm;
        Tick { t_s, offset_mm, z_mm, reading: None, silent, faults }
    }

    /// Returns `true` if the sensor sends nothing: its cable is broken, or there is no sheet that it could read.
    fn is_silent(&self) -> bool {
        self.sheet.is_none() || self.inputs.reads(Input::NoReadings.number(), self.modes)
    }

    fn tick(&mut self, t_s: f64, state: &State, full_mm_s: f64) -> Tick {
        while self.inputs.step(t_s, self.modes).is_some() {}
        let planned_mm = state.position[Axis::Z];
        let sensed = self.sense(state, full_mm_s);
        let reading = self.follower.tick(t_s, planned_mm, &self.law, &sensed);
        let z_mm = planned_mm + self.follower.offset_mm;
        let faults = [
            (Input::HeightSilent, self.follower.is_lost()),
            (Input::HeightConflict, sensed.high && sensed.low && sensed.active),
            (Input::HeightAtZero, z_mm >= self.law.ceiling_mm - 1e-9),
        ];
        let offset_mm = self.follower.offset_mm;
        Tick { t_s, offset_mm, z_mm, reading, silent: sensed.silent, faults }
    }

    fn sense(&self, state: &State, full_mm_s: f64) -> Sensed {
        let [x, y, z] = state.position.first3();
        let [vx, vy, _] = state.velocity.first3();
        let over = z + self.follower.offset_mm;
        let gap_mm = self
            .sheet
            .map(|sheet| over - sheet.height_mm(x, y) - self.law.raised_mm.unwrap_or_default());
        let felt = |number: u8, felt: fn(f64) -> bool| match gap_mm {
            Some(gap_mm) if !self.inputs.is_told(number) => felt(gap_mm),
            _ => self.inputs.reads(number, self.modes),
        };
        let (high, low) = match self.law.gauge {
            Gauge::Simple { high, low } => (felt(high, is_high), felt(low, is_low)),
            Gauge::Proportional { .. } => (false, false),
        };
        let silent = self.is_silent();
        let active = state.path_speed_mm_s >= self.law.activation * full_mm_s;
        Sensed { gap_mm, silent, high, low, way: [vx, vy], active }
    }
}

/// The gap between which and which the two switches of the simulated head leave it as it is, mm.
const BAND_MM: [f64; 2] = [3.7, 4.3];

/// The switch "too low" of the simulated head at a gap, mm.
fn is_low(gap_mm: f64) -> bool {
    gap_mm < BAND_MM[0]
}

/// The switch "too high" of the simulated head at a gap, mm.
fn is_high(gap_mm: f64) -> bool {
    gap_mm > BAND_MM[1]
}

impl Sheet {
    /// A flat sheet over which height control keeps the tool at a height, mm, machine frame.
    pub fn followed_at(z_mm: f64, law: &HeightLaw) -> Self {
        let gap_mm = match law.gauge {
            Gauge::Simple { .. } => 0.5 * (BAND_MM[0] + BAND_MM[1]),
            Gauge::Proportional { set_points: [x, _], .. } => law.gap_mm(x),
        };
        Self::flat(z_mm - gap_mm)
    }
}

impl Head {
    /// Z stays where it is.
    pub fn land(&mut self) {
        self.follower = Follower::default();
    }

    /// A sheet lies on the table, or none.
    pub const fn put_sheet(&mut self, sheet: Option<Sheet>) {
        self.sheet = sheet;
    }

    /// Z follows the sheet from here on, or does not. Returns what the switches of the head read at its place.
    pub fn use_law(
        &mut self,
        law: Option<HeightLaw>,
        at: &Axes,
        lent: Lent<'_>,
    ) -> Vec<(u8, bool)> {
        self.law = law;
        let read = |(input, feels): (Input, Feels)| (input.number(), feels.at(at, false));
        self.switches(lent).into_iter().map(read).collect()
    }

    /// Lists the switches of the head and what they go by while height control is on, as far as no script moves them.
    fn switches(&self, lent: Lent<'_>) -> Vec<(Input, Feels)> {
        let Some(law) = self.law else { return Vec::new() };
        let feels = |felt: Felt| Feels {
            sheet: self.sheet,
            raised_mm: law.raised_mm.unwrap_or_default(),
            felt,
        };
        match (law.gauge, self.sheet) {
            (Gauge::Proportional { .. }, _) => vec![(Input::ZHigh, feels(Felt::Above(law)))],
            (Gauge::Simple { .. }, Some(_)) => {
                let both = [(Input::ZHigh, Felt::High), (Input::ZLow, Felt::Low)].into_iter();
                let free = both.filter(|(input, _)| !lent.inputs.is_told(input.number()));
                free.map(|(input, felt)| (input, feels(felt))).collect()
            }
            // Two switches over no sheet feel nothing.
            (Gauge::Simple { .. }, None) => Vec::new(),
        }
    }

    fn following<'a>(&self, lent: Lent<'a>) -> Option<Following<'a>> {
        let law = self.law?;
        let (sheet, follower, inputs) = (self.sheet, self.follower, lent.inputs.clone());
        Some(Following { sheet, modes: lent.modes, law, follower, inputs })
    }

    /// Z follows the sheet over one move: how far it is carried on the way.
    pub fn follow_sheet(
        &mut self,
        lent: Lent<'_>,
        t0_s: f64,
        plan: &Plan,
        span: &Span<'_>,
    ) -> LiftOfMove {
        let before_mm = self.follower.offset_mm;
        let mut lift = Lift::still(before_mm);
        let Some(mut following) = self.following(lent) else {
            return LiftOfMove { lift, readings: Vec::new() };
        };
        let [begin_s, end_s] = [span.t0_s, span.t1_s].map(|s| t0_s + s);
        let mut readings = Vec::new();
        lift.carry(begin_s, before_mm);
        following.through(t0_s, plan, span, span.t0_s, &mut |tick| {
            readings.extend(tick.told());
            lift.carry((tick.t_s + TICK_S).min(end_s), tick.offset_mm);
        });
        self.follower = following.follower;
        LiftOfMove { lift, readings }
    }

    /// Foresees the ticks of height control over a plan from now on.
    pub fn foreseen_ticks(&self, lent: Lent<'_>, ahead: &Ahead<'_>) -> Vec<Tick> {
        let Ahead { plan, t0_s, from_s } = *ahead;
        let Some(mut following) = self.following(lent) else { return Vec::new() };
        let from_s = (from_s - t0_s).max(0.0);
        let mut ticks = Vec::new();
        for index in 0..plan.moves().len() {
            let Some(span) = plan.span(index).filter(|span| span.t1_s > from_s) else { continue };
            following.through(t0_s, plan, &span, from_s, &mut |tick| ticks.push(*tick));
        }
        ticks
    }

    /// Foresees the faults that height control will notice on the way, each off at first.
    pub fn foreseen_faults(&self, from_s: f64, ticks: &[Tick]) -> Vec<Change> {
        if self.law.is_none() {
            return Vec::new();
        }
        let faults = [Input::HeightSilent, Input::HeightConflict, Input::HeightAtZero];
        let off = |input: Input| Change { input: input.number(), at_s: from_s, on: false };
        let mut all: Vec<Change> = faults.map(off).into();
        let mut states = [false; 3];
        for tick in ticks {
            for ((input, on), state) in tick.faults.into_iter().zip(&mut states) {
                if std::mem::replace(state, on) != on {
                    all.push(Change { input: input.number(), at_s: tick.t_s, on });
                }
            }
        }
        all
    }

    /// Foresees the changes of the head's sensors, over a sheet or over none.
    pub fn foreseen_sensors(
        &self,
        lent: Lent<'_>,
        ahead: &Ahead<'_>,
        ticks: &[Tick],
    ) -> Vec<Change> {
        let Ahead { plan, t0_s, from_s } = *ahead;
        let at = |t_s: f64| {
            let mut at = plan.at(t_s).position;
            // Where height control carries the head.
            let behind = ticks.partition_point(|tick| tick.t_s <= t0_s + t_s);
            let tick = behind.checked_sub(1).and_then(|i| ticks.get(i));
            at[Axis::Z] += tick.map_or(self.follower.offset_mm, |tick| tick.offset_mm);
            (at, tick.is_some_and(|tick| tick.silent))
        };
        let (from_s, to_s) = (from_s - t0_s, plan.duration_s());
        let changes = |input: Input, is: &dyn Fn(f64) -> bool| -> Vec<Change> {
            let flips = flips(from_s.max(0.0), to_s, is).into_iter();
            let change = |(t_s, on)| Change { input: input.number(), at_s: t0_s + t_s, on };
            flips.map(change).collect()
        };
        let mut all = Vec::new();
        if let Some(sheet) = self.sheet {
            let close = |t_s: f64| {
                let (at, _) = at(t_s);
                at[Axis::Z] <= sheet.height_mm(at[Axis::X], at[Axis::Y])
            };
            all.extend(changes(Input::WHome, &close));
        }
        for (input, feels) in self.switches(lent) {
            let is = |t_s: f64| {
                let (at, silent) = at(t_s);
                feels.at(&at, silent)
            };
            all.extend(changes(input, &is));
        }
        all
    }
}

/// A switch of the head, or what a reading of its sensor stands for.
#[derive(Clone, Copy, Debug)]
enum Felt {
    /// The reading says that the head is above the band it is to keep; no reading does not say otherwise.
    Above(HeightLaw),
    /// The switch "too high".
    High,
    /// The switch "too low".
    Low,
}

/// Rule by which an input of the head depends on where the head is.
#[derive(Clone, Copy, Debug)]
struct Feels {
    sheet: Option<Sheet>,
    /// Distance of the head above its sensor, mm.
    raised_mm: f64,
    felt: Felt,
}

impl Feels {
    /// Returns the state that the input reads at a place, with the sensor silent or not.
    fn at(&self, at: &Axes, silent: bool) -> bool {
        let gap_mm = self.sheet.map(|sheet| {
            let [x, y, z] = at.first3();
            z - sheet.height_mm(x, y) - self.raised_mm
        });
        match (self.felt, gap_mm) {
            (Felt::Above(law), Some(gap_mm)) => silent || is_above_band(&law, law.reading(gap_mm)),
            (Felt::Above(_), None) => true,
            (Felt::High, gap_mm) => gap_mm.is_some_and(is_high),
            (Felt::Low, gap_mm) => gap_mm.is_some_and(is_low),
        }
    }
}
