//! Height control on the simulated machine: Z beside the plan, and what the sensors of the head tell.

use super::Machine;
use super::job::{EXACT_S, SLICE_S};
use crate::follower::{Follower, Reading, Sensed, TICK_S};
use crate::inputs::{Change, Inputs};
use crate::log::What;
use crate::sheet::Sheet;
use kerf_machine::lines::Input;
use kerf_motion::{Plan, Span, State};
use kerf_program::{Axes, Axis, Gauge, HeightLaw, MoveKind};

/// Z while it follows the sheet: what one tick after the other makes of it.
struct Following<'a> {
    machine: &'a Machine,
    law: HeightLaw,
    follower: Follower,
    inputs: Inputs,
}

/// What a tick came to.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tick {
    t_s: f64,
    /// How far Z has been carried, mm.
    offset_mm: f64,
    /// Where the tool is, Z of the machine frame, mm.
    z_mm: f64,
    reading: Option<Reading>,
    /// What the controller notices.
    faults: [(Input, bool); 3],
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
        if !self.law.acts_in(span) {
            return;
        }
        let begin_s = span.t0_s.max(from_s);
        let ticks = ((span.t1_s - begin_s) / TICK_S).round().max(1.0) as u64;
        for tick in 0..ticks {
            let at_s = begin_s + tick as f64 * TICK_S;
            let tick = self.tick(t0_s + at_s, &plan.at(at_s), span.made.speed_mm_s);
            each(&tick);
        }
    }

    fn tick(&mut self, t_s: f64, state: &State, full_mm_s: f64) -> Tick {
        while self.inputs.step(t_s, &self.machine.settings.io).is_some() {}
        let planned_mm = state.position[Axis::Z];
        let sensed = self.sense(state, full_mm_s);
        let reading = self.follower.tick(t_s, planned_mm, &self.law, &sensed);
        let z_mm = planned_mm + self.follower.offset_mm;
        let faults = [
            (Input::HeightSilent, self.follower.is_lost()),
            (Input::HeightConflict, sensed.high && sensed.low && sensed.active),
            (Input::HeightAtZero, z_mm >= self.law.ceiling_mm - 1e-9),
        ];
        Tick { t_s, offset_mm: self.follower.offset_mm, z_mm, reading, faults }
    }

    fn sense(&self, state: &State, full_mm_s: f64) -> Sensed {
        let [x, y, z] = state.position.first3();
        let [vx, vy, _] = state.velocity.first3();
        let reads = |number: u8| self.inputs.reads(number, &self.machine.settings.io);
        let (high, low) = match self.law.gauge {
            Gauge::Simple { high, low } => (reads(high), reads(low)),
            Gauge::Proportional { .. } => (false, false),
        };
        let over = z + self.follower.offset_mm;
        let gap_mm = self.machine.sheet.map(|sheet| over - sheet.height_mm(x, y));
        let silent = reads(Input::NoReadings.number());
        let active = state.path_speed_mm_s >= self.law.activation * full_mm_s;
        Sensed { gap_mm, silent, high, low, way: [vx, vy], active }
    }
}

/// Where a law acts.
trait Acts {
    /// Whether Z follows during a move: a cut whose Z is the plan's own, or a jog in the plane where the law
    /// is for travel.
    fn acts_in(&self, span: &Span<'_>) -> bool;
}

impl Acts for HeightLaw {
    fn acts_in(&self, span: &Span<'_>) -> bool {
        let made = span.made;
        let wanted = if self.raised_mm.is_some() { MoveKind::Jog } else { MoveKind::Cut };
        made.kind == wanted && made.from[Axis::Z] == made.to[Axis::Z]
    }
}

impl Machine {
    /// Z follows the sheet from here on, or does not.
    pub fn height_control(&mut self, law: Option<HeightLaw>) {
        self.land_torch();
        self.law = law;
    }

    fn following(&self) -> Option<Following<'_>> {
        let law = self.law.filter(|_| !self.draws())?;
        let (follower, inputs) = (self.follower, self.inputs.clone());
        Some(Following { machine: self, law, follower, inputs })
    }

    /// Z follows the sheet over one move.
    pub(super) fn follow_sheet(&mut self, t0_s: f64, plan: &Plan, span: &Span<'_>) {
        let Some(mut following) = self.following() else { return };
        let mut told = Vec::new();
        following.through(t0_s, plan, span, span.t0_s, &mut |tick| {
            told.extend(tick.reading.map(|reading| (tick.t_s, tick.z_mm, reading)));
        });
        let follower = following.follower;
        let before_mm = self.follower.offset_mm;
        self.follower = follower;
        for (t_s, z_mm, Reading { value, gap_mm, error_mm }) in told {
            self.log.add(t_s, What::Height { z_mm, gap_mm, error_mm, reading: value });
        }
        if self.follower.offset_mm != before_mm {
            let planned_mm = span.made.to[Axis::Z];
            let end_s = t0_s + span.t1_s;
            self.log.add(end_s, What::Carried { z_mm: planned_mm + follower.offset_mm });
        }
    }

    /// What height control will make of a plan from now on.
    pub(super) fn foreseen_ticks(&self, plan: &Plan, t0_s: f64) -> Vec<Tick> {
        let Some(mut following) = self.following() else { return Vec::new() };
        let from_s = (self.clock_s - t0_s).max(0.0);
        let mut ticks = Vec::new();
        for index in 0..plan.moves().len() {
            let Some(span) = plan.span(index).filter(|span| span.t1_s > from_s) else { continue };
            following.through(t0_s, plan, &span, from_s, &mut |tick| ticks.push(*tick));
        }
        ticks
    }

    /// What height control will notice on the way, each fault off at first.
    pub(super) fn foreseen_faults(&self, ticks: &[Tick]) -> Vec<Change> {
        if self.law.is_none() {
            return Vec::new();
        }
        let faults = [Input::HeightSilent, Input::HeightConflict, Input::HeightAtZero];
        let off = |input: Input| Change { input: input.number(), at_s: self.clock_s, on: false };
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

    /// What the sensors of the head will tell of a sheet.
    pub(super) fn foreseen_sensors(
        &self,
        plan: &Plan,
        t0_s: f64,
        sheet: Sheet,
        ticks: &[Tick],
    ) -> Vec<Change> {
        let at = |t_s: f64| {
            let mut at = plan.at(t_s).position;
            // Where height control carries the head.
            let behind = ticks.partition_point(|tick| tick.t_s <= t0_s + t_s);
            let tick = behind.checked_sub(1).and_then(|i| ticks.get(i));
            at[Axis::Z] += tick.map_or(self.follower.offset_mm, |tick| tick.offset_mm);
            at
        };
        let close = |t_s: f64| {
            let at = at(t_s);
            at[Axis::Z] <= sheet.height_mm(at[Axis::X], at[Axis::Y])
        };
        let (from_s, to_s) = (self.clock_s - t0_s, plan.duration_s());
        let changes = |input: Input, is: &dyn Fn(f64) -> bool| -> Vec<Change> {
            let flips = flips(from_s.max(0.0), to_s, is).into_iter();
            let change = |(t_s, on)| Change { input: input.number(), at_s: t0_s + t_s, on };
            flips.map(change).collect()
        };
        let mut all = changes(Input::WHome, &close);
        if matches!(self.law, Some(HeightLaw { gauge: Gauge::Proportional { .. }, .. })) {
            let high = |t_s: f64| self.above_band(&sheet, &at(t_s));
            all.extend(changes(Input::ZHigh, &high));
        }
        all
    }

    /// Whether the reading says that the head is above the band it is to keep.
    fn above_band(&self, sheet: &Sheet, at: &Axes) -> bool {
        let Some(law) = self.law else { return false };
        let Gauge::Proportional { gain_mm, set_points, .. } = law.gauge else { return false };
        let gap_mm = at[Axis::Z] - sheet.height_mm(at[Axis::X], at[Axis::Y]);
        (law.reading(gap_mm) - set_points[0]) * gain_mm.signum() >= 1.0
    }
}

/// When something becomes true or false in a stretch of time, the state at its beginning first.
pub(super) fn flips(from_s: f64, to_s: f64, is: &dyn Fn(f64) -> bool) -> Vec<(f64, bool)> {
    let mut states = vec![(from_s, is(from_s))];
    let slices = ((to_s - from_s) / SLICE_S).ceil().max(1.0) as u64;
    for slice in 1..=slices {
        let end_s = from_s + (to_s - from_s) * slice as f64 / slices as f64;
        let (begin_s, before) = states.last().copied().unwrap_or_default();
        if is(end_s) == before {
            continue;
        }
        let start_s = begin_s.max(end_s - (to_s - from_s) / slices as f64);
        states.push((flip(start_s, end_s, before, is), !before));
    }
    states
}

/// When a state ends between two moments.
fn flip(mut from_s: f64, mut to_s: f64, before: bool, is: &dyn Fn(f64) -> bool) -> f64 {
    while to_s - from_s > EXACT_S {
        let middle_s = 0.5 * (from_s + to_s);
        if is(middle_s) == before { from_s = middle_s } else { to_s = middle_s }
    }
    to_s
}
