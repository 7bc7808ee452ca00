//! Beliefs about the machine, and what follows from them.

mod readings;
mod shine;
mod switching;
mod torch;

pub use switching::WasOn;

use crate::heater::Heater;
use crate::independent::Spin;
use crate::inputs::{CABLE, Change, Inputs, STALL};
use crate::laser;
use crate::limits::Overridden;
use crate::log::{Log, What};
use crate::motors::Motors;
use crate::outputs::Outputs;
use crate::trigger;
use kerf_machine::height_follower::in_plane;
use kerf_machine::homing::soft_bounds;
use kerf_machine::{Configuration, Lift, LiftOfMove, Reading};
use kerf_motion::{Move, Plan, Span};
use kerf_program::settings::Mode;
use kerf_program::{
    AXES, Axes, Axis, AxisSet, Frame, Independent, OutputReason, Settings, TORCH_INPUT,
};
use shine::Shine;
use std::collections::BTreeMap;
use std::sync::Arc;
use torch::Torch;

/// Beliefs about a machine: places, frames, limits, inputs, outputs. See the [crate] for what it learns.
#[derive(Clone, Debug)]
pub struct Model {
    clock_s: f64,
    /// Position that planned motion has reached, machine frame.
    position: Axes,
    frame: Frame,
    settings: Arc<Settings>,
    inputs: Inputs,
    outputs: Outputs,
    spins: [Spin; AXES],
    torch: Torch,
    /// The machine itself carries Z by the torch.
    made_torch: bool,
    heater: Heater,
    motors: Motors,
    /// Motors have power.
    powered: bool,
    /// Axes that may have been moved by hand while they had none.
    unverified: AxisSet,
    /// The motor that moves while the others of its axis stand.
    alone: Option<(Axis, usize)>,
    /// Distance that height control has carried Z, mm.
    carried_mm: f64,
    /// Range in which each axis may go, machine frame.
    bounds: [Option<(f64, f64)>; AXES],
    /// Factors of coarser steps.
    coarse: [u8; AXES],
    pwm: BTreeMap<u8, f64>,
    shine: Shine,
    light: bool,
    /// Outputs of mode 2 that a stop switched off: they come back when motion goes on.
    come_back: Vec<u8>,
    /// Limits that do not hold until the file ends.
    overridden: Overridden,
    /// Commands are only drawn (SP): where the machine really stands.
    drawing_from: Option<Axes>,
    log: Log,
}

impl Default for Model {
    fn default() -> Self {
        Self::new(Axes::default(), Frame::default(), Arc::default(), Inputs::default())
    }
}

impl Model {
    /// A machine at rest at time 0.
    pub fn new(position: Axes, frame: Frame, settings: Arc<Settings>, inputs: Inputs) -> Self {
        let mut motors = Motors::default();
        motors.say(position);
        Self {
            clock_s: 0.0,
            position,
            frame,
            settings,
            inputs,
            outputs: Outputs::default(),
            spins: [Spin::default(); AXES],
            torch: Torch::default(),
            made_torch: false,
            heater: Heater::default(),
            motors,
            powered: true,
            unverified: AxisSet::EMPTY,
            alone: None,
            carried_mm: 0.0,
            bounds: [None; AXES],
            coarse: [1; AXES],
            pwm: BTreeMap::new(),
            shine: Shine::default(),
            light: false,
            come_back: Vec::new(),
            overridden: Overridden::default(),
            drawing_from: None,
            log: Log::default(),
        }
    }

    /// The inputs as they are told to be from now on.
    pub fn knows(&mut self, inputs: Inputs) {
        self.inputs = inputs;
    }

    /// The machine after a run, ready for the next, which counts time from 0: what turns keeps
    /// turning, what is on stays on, motors keep their count.
    #[must_use]
    pub fn again(mut self, position: Axes, frame: Frame, settings: Arc<Settings>) -> Self {
        for spin in &mut self.spins {
            spin.set_back(self.clock_s);
        }
        self.heater.set_back(self.clock_s);
        self.clock_s = 0.0;
        (self.position, self.frame) = (position, frame);
        (self.drawing_from, self.settings) = (None, settings);
        self.motors.say(self.true_position());
        self
    }

    /// The same machine, whose run goes on from a moment.
    #[must_use]
    pub fn begun_at(mut self, t_s: f64) -> Self {
        if t_s <= 0.0 {
            return self;
        }
        for spin in &mut self.spins {
            spin.set_back(-t_s);
        }
        self.heater.set_back(-t_s);
        self.clock_s = t_s;
        self
    }

    /// The same machine, standing elsewhere while a preview is drawn.
    #[must_use]
    pub fn drawing_from(mut self, position: Axes) -> Self {
        let drawn = std::mem::replace(&mut self.position, position);
        self.motors.say(self.true_position());
        (self.position, self.drawing_from) = (drawn, Some(position));
        self
    }

    /// Returns the log of what happened since it was last emptied.
    pub const fn log(&mut self) -> &mut Log {
        &mut self.log
    }

    /// The same machine, whose lengths bound these axes.
    #[must_use]
    pub fn bounded(mut self, machine: &Configuration, axes: AxisSet) -> Self {
        self.bounds =
            Axis::ALL.map(|axis| soft_bounds(machine, axis).filter(|_| axes.contains(axis)));
        self
    }

    /// The same machine, whose locations of these axes nobody has verified since an earlier session.
    #[must_use]
    pub fn doubting(mut self, axes: AxisSet) -> Self {
        axes.iter().for_each(|axis| self.unverified.insert(axis));
        self
    }

    /// The same machine, whose locations of these axes somebody has verified.
    #[must_use]
    pub fn trusting(mut self, axes: AxisSet) -> Self {
        axes.iter().for_each(|axis| self.unverified.remove(axis));
        self
    }

    /// Whether the machine itself carries Z by the torch (VH): it tells how far, and here nothing is reckoned of it.
    pub const fn leaves_torch(&mut self, made: bool) {
        self.made_torch = made;
    }

    /// From here on these settings hold.
    pub fn use_settings(&mut self, settings: Arc<Settings>) {
        self.follow_motors();
        if !settings.torch_on() {
            self.land_torch();
        }
        self.use_mode(settings.mode, &settings);
        if !settings.driver.enabled {
            self.all_off(OutputReason::Program);
        }
        let before = laser::active(&self.settings.height, &self.settings.io);
        self.settings = settings;
        let height = self.settings.height;
        if laser::active(&height, &self.settings.io) {
            self.pwm(laser::CHANNEL, height.low_percent);
        } else if before {
            self.pwm(laser::CHANNEL, 0.0);
        }
        self.heat(self.clock_s);
    }

    fn use_mode(&mut self, mode: Mode, settings: &Settings) {
        match (mode, self.drawing_from) {
            (Mode::Preview, None) => {
                self.set_light(false);
                self.drawing_from = Some(self.position);
                if !settings.view.start_actual {
                    for axis in [Axis::X, Axis::Y] {
                        self.position[axis] = self.frame.working_zero[axis];
                    }
                }
            }
            (Mode::Move, Some(position)) => {
                self.drawing_from = None;
                self.position = position;
            }
            _ => {}
        }
    }

    /// From here on these frames hold. Somebody set the locations of these axes.
    pub fn use_frame(&mut self, frame: Frame, set: AxisSet) {
        self.frame = frame;
        for axis in set.iter() {
            self.unverified.remove(axis);
        }
    }

    /// It stands there, without having gone there: what led there has happened before.
    pub const fn put(&mut self, position: Axes) {
        self.position = position;
    }

    /// The table and the lengths of the axes do not end motion any more, until the file ends.
    pub const fn override_table(&mut self) {
        self.overridden.table = true;
    }

    /// The limit switch of an input does not stop motion any more, until the file ends; the others do.
    pub fn override_switch(&mut self, input: u8) {
        self.overridden.switches.insert(input);
    }

    /// Lets an axis move beside the others.
    pub fn independent(&mut self, axis: Axis, motion: Independent) {
        if self.draws() {
            return;
        }
        let spin = &mut self.spins[axis.index()];
        if motion == Independent::Off {
            self.position[axis] += spin.end(self.clock_s);
        } else {
            spin.change(self.clock_s, motion);
        }
        self.log.add(self.clock_s, What::Independent { axis, motion });
    }

    /// Everything that moves by itself stops.
    fn spins_off(&mut self) {
        for axis in Axis::ALL {
            if self.spins[axis.index()].moves() {
                self.independent(axis, Independent::Off);
            }
        }
    }

    /// Lets the clock run to a time; inputs change on the way.
    pub fn advance(&mut self, to_s: f64) {
        while let Some(change) = self.inputs.step(to_s, &self.settings.io) {
            let on = self.inputs.reads(change.input, &self.settings.io);
            let t_s = change.at_s.max(self.clock_s);
            self.log.add(
                t_s,
                match change.input {
                    CABLE => What::Link(on),
                    STALL => What::Stall(on),
                    number => What::Input { number, on },
                },
            );
            if change.input == TORCH_INPUT {
                self.steer_torch(t_s);
            }
        }
        self.clock_s = self.clock_s.max(to_s);
        self.heat(self.clock_s);
    }

    /// Motion is about to start: the motors have power, the light warns. Returns when motion may start, seconds.
    pub fn warn(&mut self) -> f64 {
        if self.draws() {
            return self.clock_s;
        }
        self.power_motors(true);
        if self.light {
            return self.clock_s;
        }
        self.set_light(true);
        self.clock_s + self.settings.warning_s.max(0.0)
    }

    /// The same, and the warning passes.
    pub fn begin_motion(&mut self) -> f64 {
        let until_s = self.warn();
        self.advance(until_s);
        self.clock_s
    }

    /// A move of a plan that started at `t0_s` has been made: outputs, PWM, position, clock; and height control has carried
    /// Z on it.
    pub fn make(&mut self, t0_s: f64, plan: &Plan, span: &Span<'_>, carried: &LiftOfMove) {
        self.shift_resolution(Some(span.made.kind));
        self.ride(Some(span.made));
        let settings = &self.settings;
        if settings.cutter.trigger.active
            && let Some((t_s, on)) =
                trigger::switch(plan, span.index, &settings.cutter.trigger, self.frame.working_zero)
        {
            let number = settings.cutter.trigger.output;
            self.output_at(t0_s + t_s, number, on, OutputReason::Trigger);
        }
        if laser::active(&self.settings.height, &self.settings.io) {
            let height = self.settings.height;
            for (t_s, percent) in laser::corners(span, &height) {
                self.pwm_at(t0_s + t_s, laser::CHANNEL, percent);
            }
        }
        let draws = self.draws();
        self.shine.follow(t0_s, plan, span, (!draws).then_some(&mut self.log));
        self.follow_sheet(t0_s + span.t1_s, span.made.to, carried);
        self.position = span.made.to;
        if !self.draws() {
            self.advance(t0_s + span.t1_s);
        }
    }

    /// Height control has carried Z on a move to a place, which ends at a moment.
    fn follow_sheet(&mut self, end_s: f64, to: Axes, carried: &LiftOfMove) {
        for Reading { t_s, z_mm, error_mm, value } in carried.readings.iter().copied() {
            self.log.add(t_s, What::Height { z_mm, error_mm, reading: value });
        }
        let mut carries = |t_s: f64, mm: f64| {
            self.log.add(t_s, What::Carried { z_mm: to[Axis::Z] + mm });
        };
        let [before_mm, after_mm] = carried.lift.ends();
        // A torch carries the tool, and no heights of a job.
        let heights = !self.settings.torch_on();
        carried.lift.turns().filter(|_| heights).for_each(|(t_s, mm)| carries(t_s, mm));
        if heights && after_mm != before_mm {
            carries(end_s, after_mm);
        }
        self.carried_mm = after_mm;
    }

    /// Returns the way of height control over a move that is only drawn: none.
    pub fn not_carried(&self) -> LiftOfMove {
        LiftOfMove { lift: Lift::still(self.carried_mm), readings: Vec::new() }
    }

    /// The stack is over, the machine stands.
    pub fn rest(&mut self) {
        self.shift_resolution(None);
        self.ride(None);
        let height = self.settings.height;
        if laser::active(&height, &self.settings.io) {
            self.pwm(laser::CHANNEL, height.low_percent);
        }
    }

    /// The machine tells that the contact of an input changed at a moment of the motion under way.
    pub fn learn(&mut self, change: Change) {
        self.inputs.learn(change);
    }

    /// Forgets the news from the moment on up to which motion is made: the machine tells them once more.
    pub fn forget(&mut self) {
        self.inputs.forget(self.clock_s);
    }

    /// Logs that an axis is pushed by hand so far: its motor holds it, or it gives way.
    pub fn pushed(&mut self, axis: Axis, by: f64, at_s: f64) {
        let by = if self.powered || self.draws() { 0.0 } else { by };
        self.log.add(at_s, What::Pushed { axis, by });
    }

    /// Nobody knows for sure where the axes are from now on.
    pub fn doubt(&mut self) -> AxisSet {
        self.unverified = AxisSet::first(usize::from(self.settings.axis_count));
        self.unverified
    }

    /// The motors have brought the axes to where they are.
    fn follow_motors(&mut self) {
        if !self.draws() {
            self.motors.follow(self.true_position(), &self.settings);
        }
    }

    /// From here on only this motor of an axis moves; `None` for all.
    pub const fn move_alone(&mut self, motor: Option<(Axis, usize)>) {
        self.alone = motor;
    }

    /// The axis is at zero where it stands.
    pub fn zero(&mut self, axis: Axis) {
        self.position[axis] = 0.0;
        self.unverified.remove(axis);
        self.motors.say(self.true_position());
    }

    /// The switches of the head read this, now that Z follows the sheet from here on, or does not.
    pub fn senses(&mut self, contacts: &[(u8, bool)]) {
        contacts.iter().for_each(|(input, on)| self.inputs.put(*input, *on));
    }

    /// A move begins that Z may ride on, or the machine comes to rest.
    fn ride(&mut self, made: Option<&Move>) {
        let here = self.settings.torch_on() && !self.draws() && !self.made_torch;
        let rides = made.filter(|made| here && in_plane(made));
        self.torch.ride(rides.map_or(0.0, |made| self.settings.height.rate * made.speed_mm_s));
        self.steer_torch(self.clock_s);
    }

    /// Turns Z down or up by the state of the input.
    fn steer_torch(&mut self, t_s: f64) {
        if self.torch.rests() {
            return;
        }
        let on = self.input(TORCH_INPUT);
        self.torch.steer(t_s, on, &mut self.log);
    }

    /// Adds the way that torch and height control have carried Z to the planned position: the next motion begins there.
    pub fn land_torch(&mut self) {
        self.torch.ride(0.0);
        self.steer_torch(self.clock_s);
        self.position[Axis::Z] += self.torch.end(self.clock_s);
        self.position[Axis::Z] += std::mem::take(&mut self.carried_mm);
    }
}

#[cfg(test)]
mod tests;
