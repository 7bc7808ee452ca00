//! The machine itself.

mod head;
mod readings;
mod shine;
mod switching;
mod torch;

pub use switching::WasOn;

use crate::carriages::Carriages;
use crate::hand::{Hand, Push};
use crate::heater::Heater;
use crate::independent::Spin;
use crate::inputs::{CABLE, Change, Inputs, STALL};
use crate::laser;
use crate::lift::Lift;
use crate::limits::Overridden;
use crate::log::{Log, What};
use crate::motors::Motors;
use crate::outputs::Outputs;
use crate::scene::{self, Touch};
use crate::sheet::Sheet;
use crate::trigger;
use head::{Ahead, Head, Lent};
use kerf_machine::Configuration;
use kerf_machine::homing::soft_bounds;
use kerf_machine::lines::Input;
use kerf_motion::{Move, Plan, Span};
use kerf_program::settings::Mode;
use kerf_program::{
    AXES, Axes, Axis, AxisSet, Frame, HeightLaw, Independent, OutputReason, Settings,
};
use shine::Shine;
use std::sync::Arc;
use torch::{TORCH_INPUT, Torch, in_xy};

/// A simulated machine. See the [crate] for what it does.
#[derive(Clone, Debug)]
pub struct Machine {
    clock_s: f64,
    /// Position that planned motion has reached, machine frame.
    position: Axes,
    frame: Frame,
    settings: Arc<Settings>,
    inputs: Inputs,
    outputs: Outputs,
    spins: [Spin; AXES],
    torch: Torch,
    heater: Heater,
    motors: Motors,
    /// Motors have power.
    powered: bool,
    /// Axes that may have been moved by hand while they had none.
    unverified: AxisSet,
    hand: Hand,
    /// True places of the axes.
    carriages: Carriages,
    /// Range in which each axis may go, machine frame.
    bounds: [Option<(f64, f64)>; AXES],
    /// Factors of coarser steps.
    coarse: [u8; AXES],
    pwm_percent: f64,
    shine: Shine,
    head: Head,
    /// Bodies on the table, and the inputs that change where the tool is inside of them.
    touches: Arc<[Touch]>,
    light: bool,
    /// Outputs of mode 2 that a stop switched off: they come back when motion goes on.
    come_back: Vec<u8>,
    /// Limits that do not hold until the file ends.
    overridden: Overridden,
    /// Commands are only drawn (SP): where the machine really stands.
    drawing_from: Option<Axes>,
    log: Log,
}

impl Default for Machine {
    fn default() -> Self {
        Self::new(Axes::default(), Frame::default(), Arc::default(), Inputs::default())
    }
}

impl Machine {
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
            heater: Heater::default(),
            motors,
            powered: true,
            unverified: AxisSet::EMPTY,
            hand: Hand::default(),
            carriages: Carriages::default(),
            bounds: [None; AXES],
            coarse: [1; AXES],
            pwm_percent: 0.0,
            shine: Shine::default(),
            head: Head::default(),
            touches: Arc::default(),
            light: false,
            come_back: Vec::new(),
            overridden: Overridden::default(),
            drawing_from: None,
            log: Log::default(),
        }
    }

    /// The machine after a run, ready for the next, which counts time from 0: what turns keeps
    /// turning, what is on stays on, motors keep their count.
    #[must_use]
    pub fn again(
        mut self,
        position: Axes,
        frame: Frame,
        settings: Arc<Settings>,
        inputs: Inputs,
    ) -> Self {
        for spin in &mut self.spins {
            spin.set_back(self.clock_s);
        }
        self.heater.set_back(self.clock_s);
        self.clock_s = 0.0;
        (self.position, self.frame) = (position, frame);
        self.inputs = inputs.after(&self.inputs);
        (self.drawing_from, self.settings) = (None, settings);
        self.put_home_switches();
        self.motors.say(self.true_position());
        self
    }

    /// The same machine, whose run goes on from a moment: what its script of inputs did until then is told.
    #[must_use]
    pub fn begun_at(mut self, t_s: f64) -> Self {
        if t_s <= 0.0 {
            return self;
        }
        for spin in &mut self.spins {
            spin.set_back(-t_s);
        }
        self.heater.set_back(-t_s);
        self.inputs = self.inputs.at(t_s, &self.settings.io);
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

    /// The same machine with the switches, motors and lengths of a configuration; the lengths bound these
    /// axes. What is known of where its axes truly are stays, where it has as many motors as before.
    #[must_use]
    pub fn equipped(mut self, machine: &Configuration, bounded: AxisSet) -> Self {
        let known = self.carriages.astray();
        self.carriages = Carriages::new(machine);
        if known.iter().zip(self.carriages.astray()).all(|(a, b)| a.len() == b.len()) {
            self.carriages.set_astray(&known);
        }
        self.carriages.settle(self.position);
        self.inputs.wire(machine.io);
        self.bounds =
            Axis::ALL.map(|axis| soft_bounds(machine, axis).filter(|_| bounded.contains(axis)));
        self.put_home_switches();
        // Nobody presses the emergency stop, whatever its level.
        self.inputs.rests(Input::EmergencyStop.number(), !machine.estop.active);
        self
    }

    /// The same machine, whose carriages are off by so much.
    #[must_use]
    pub fn with_truth(mut self, truth: &[Vec<f64>]) -> Self {
        self.carriages.set_astray(truth);
        self.carriages.settle(self.position);
        self.put_home_switches();
        self
    }

    /// The same machine with a sheet on its table, or without.
    #[must_use]
    pub const fn with_sheet(mut self, sheet: Option<Sheet>) -> Self {
        self.head.put_sheet(sheet);
        self
    }

    /// The same machine with things on its table that switches feel.
    #[must_use]
    pub fn with_touches(mut self, touches: &[Touch]) -> Self {
        self.touches = touches.into();
        let at = self.true_position();
        for input in scene::inputs(touches) {
            if let Some(on) = scene::contact(touches, input, &at) {
                self.inputs.put(input, on);
            }
        }
        self
    }

    /// The same machine, whose switches somebody has left like this.
    #[must_use]
    pub fn with_switches(mut self, switches: &[(u8, bool)]) -> Self {
        for (input, on) in switches {
            self.press(Change { input: *input, on: *on, at_s: self.clock_s });
        }
        self.log.take().for_each(drop);
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

    /// The same machine, pushed by hand at these times.
    #[must_use]
    pub fn pushed(mut self, script: Vec<Push>) -> Self {
        let to_come = script.into_iter().filter(|push| push.at_s >= self.clock_s).collect();
        self.hand.follow(to_come);
        self
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
        while let Some(push) = self.hand.next(to_s) {
            self.push(push);
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

    /// A move of a plan that started at `t0_s` has been made: outputs, PWM, position, clock. Tells how far height
    /// control carried Z on it.
    pub fn make(&mut self, t0_s: f64, plan: &Plan, span: &Span<'_>) -> Lift {
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
        let lent = Lent { inputs: &self.inputs, modes: &self.settings.io, draws };
        let lift = self.head.follow_sheet(lent, t0_s, plan, span, &mut self.log);
        self.carriages.moved(self.position, span.made.to);
        self.position = span.made.to;
        if !self.draws() {
            self.advance(t0_s + span.t1_s);
        }
        lift
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

    /// Somebody moves the switch of an input, now or at a moment of the motion under way; it stays
    /// there, also for the next run.
    pub fn press(&mut self, change: Change) {
        let at_s = change.at_s.max(self.clock_s);
        self.inputs.press(Change { at_s, ..change });
        self.advance(self.clock_s);
    }

    /// An axis is pushed by hand: its motor holds it, or it gives way and nobody notices.
    fn push(&mut self, push: Push) {
        let by = if self.powered || self.draws() { 0.0 } else { push.by };
        self.hand.astray[push.axis] += by;
        self.carriages.pushed(push.axis, by, self.position);
        let what = What::Pushed { axis: push.axis, by };
        self.log.add(push.at_s.max(self.clock_s), what);
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

    /// The contacts of the home switches are as the carriages have them.
    fn put_home_switches(&mut self) {
        for (line, on) in self.carriages.lines() {
            if on || self.input(line) {
                self.inputs.put(line, on);
            }
        }
    }

    /// From here on only this motor of an axis moves; `None` for all.
    pub const fn move_alone(&mut self, motor: Option<(Axis, usize)>) {
        self.carriages.move_alone(motor);
    }

    /// The axis is at zero where it stands.
    pub fn zero(&mut self, axis: Axis) {
        self.carriages.zeroed(axis, self.position[axis]);
        self.position[axis] = 0.0;
        self.unverified.remove(axis);
        self.motors.say(self.true_position());
    }

    /// Motion will follow this plan from a moment on: what the sensors will tell is worked out.
    pub fn foresee(&mut self, plan: &Plan, t0_s: f64) {
        if self.draws() {
            return;
        }
        let lent = Lent { inputs: &self.inputs, modes: &self.settings.io, draws: false };
        let ahead = Ahead { plan, t0_s, from_s: self.clock_s };
        let ticks = self.head.foreseen_ticks(lent, &ahead);
        let mut all = self.foreseen_switches(plan, t0_s);
        all.extend(self.head.foreseen_sensors(lent, &ahead, &ticks));
        all.extend(self.foreseen_touches(plan, t0_s));
        all.extend(self.head.foreseen_faults(self.clock_s, &ticks));
        all.sort_by(|a, b| a.at_s.total_cmp(&b.at_s));
        self.inputs.foresee(all);
    }

    /// Z follows the sheet from here on, or does not.
    pub fn height_control(&mut self, law: Option<HeightLaw>) {
        self.land_torch();
        let lent = Lent { inputs: &self.inputs, modes: &self.settings.io, draws: self.draws() };
        for (input, on) in self.head.use_law(law, &self.true_position(), lent) {
            self.inputs.put(input, on);
        }
    }

    /// A move begins that Z may ride on, or the machine comes to rest.
    fn ride(&mut self, made: Option<&Move>) {
        let rides = made.filter(|made| self.settings.torch_on() && !self.draws() && in_xy(made));
        self.torch.ride(rides.map_or(0.0, |made| self.settings.height.rate * made.speed_mm_s));
        self.steer_torch(self.clock_s);
    }

    /// Turns Z down or up by the state of the input.
    fn steer_torch(&mut self, t_s: f64) {
        let on = self.input(TORCH_INPUT);
        self.torch.steer(t_s, on, &mut self.log);
    }

    /// Adds the way that torch and height control have carried Z to the planned position: the next motion begins there.
    pub fn land_torch(&mut self) {
        self.torch.ride(0.0);
        self.steer_torch(self.clock_s);
        self.position[Axis::Z] += self.torch.end(self.clock_s);
        self.position[Axis::Z] += self.head.land_mm();
    }
}

#[cfg(test)]
mod tests;
