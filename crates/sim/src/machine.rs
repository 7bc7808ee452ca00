//! The machine itself.

mod drive;
mod height;
mod home;
mod job;
mod readings;
mod switching;
mod torch;

pub use switching::WasOn;

use crate::carriages::Carriages;
use crate::follower::Follower;
use crate::hand::Hand;
use crate::heater::Heater;
use crate::independent::Spin;
use crate::inputs::{CABLE, Inputs, STALL};
use crate::laser;
use crate::lift::Lift;
use crate::limits::Overridden;
use crate::log::{Log, What};
use crate::motors::Motors;
use crate::outputs::Outputs;
use crate::scene::Touch;
use crate::sheet::Sheet;
use crate::trigger;
use kerf_motion::{Plan, Span};
use kerf_program::settings::Mode;
use kerf_program::{
    AXES, Axes, Axis, AxisSet, Beam, Frame, HeightLaw, Independent, OutputReason, Settings,
};
use std::sync::Arc;

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
    /// Motion of Z by the torch, beside the plan.
    torch: Spin,
    /// Speed of that motion now, mm/s, upwards or downwards.
    torch_mm_s: f64,
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
    beam: Beam,
    /// Time at which the beam that follows the speed goes off, in the move under way.
    beam_ends_s: Option<f64>,
    sheet: Option<Sheet>,
    /// Bodies on the table, and the inputs that change where the tool is inside of them.
    touches: Arc<[Touch]>,
    /// Height control, while it is on.
    law: Option<HeightLaw>,
    follower: Follower,
    /// State of the intensity output: value and burn bit.
    intensity: (u8, bool),
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
            torch: Spin::default(),
            torch_mm_s: 0.0,
            heater: Heater::default(),
            motors,
            powered: true,
            unverified: AxisSet::EMPTY,
            hand: Hand::default(),
            carriages: Carriages::default(),
            bounds: [None; AXES],
            coarse: [1; AXES],
            pwm_percent: 0.0,
            beam: Beam::Off,
            beam_ends_s: None,
            sheet: None,
            touches: Arc::default(),
            law: None,
            follower: Follower::default(),
            intensity: (0, false),
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

    /// Returns `true` while commands are only drawn (SP): outputs, waits and inputs have no effect.
    pub const fn draws(&self) -> bool {
        self.drawing_from.is_some()
    }

    /// Machine time, seconds.
    pub const fn clock_s(&self) -> f64 {
        self.clock_s
    }

    /// Returns the position that planned motion has reached, machine frame.
    pub const fn position(&self) -> Axes {
        self.position
    }

    /// Returns its position, axes that move on their own included, machine frame.
    pub fn true_position(&self) -> Axes {
        let mut place = self.position;
        for axis in Axis::ALL {
            place[axis] += self.spins[axis.index()].displacement(self.clock_s);
        }
        place[Axis::Z] += self.torch.displacement(self.clock_s) + self.follower.offset_mm;
        place
    }

    /// Axes that move by themselves.
    pub fn spinning(&self) -> AxisSet {
        let moving = Axis::ALL.into_iter().filter(|axis| self.spins[axis.index()].moves());
        moving.fold(AxisSet::EMPTY, AxisSet::with)
    }

    /// Lists the axes that move by themselves, with their motions.
    pub fn moving_alone(&self) -> Vec<(Axis, Independent)> {
        self.spinning().iter().map(|axis| (axis, self.spins[axis.index()].motion())).collect()
    }

    /// The frames in force.
    pub const fn frame(&self) -> &Frame {
        &self.frame
    }

    /// The settings in force.
    pub const fn settings(&self) -> &Arc<Settings> {
        &self.settings
    }

    /// The outputs.
    pub const fn outputs(&self) -> &Outputs {
        &self.outputs
    }

    /// Returns the log of what happened since it was last emptied.
    pub const fn log(&mut self) -> &mut Log {
        &mut self.log
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

    /// Temperature of the heater, degrees.
    pub const fn heater_degrees(&self) -> f64 {
        self.heater.degrees()
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
            if change.input == torch::TORCH_INPUT {
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
        self.shine(t0_s, plan, span);
        let lift = self.follow_sheet(t0_s, plan, span);
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
}

#[cfg(test)]
mod tests;
