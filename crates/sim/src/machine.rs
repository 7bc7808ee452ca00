//! The machine itself.

mod drive;
mod height;
mod home;
mod job;
mod torch;

use crate::carriages::Carriages;
use crate::follower::Follower;
use crate::halt::{self, Halt, Watched};
use crate::hand::Hand;
use crate::heater::{self, Heater};
use crate::independent::Spin;
use crate::inputs::{CABLE, Change, Inputs, STALL};
use crate::laser;
use crate::log::{Log, What};
use crate::motors::Motors;
use crate::outputs::{MOTION_OUTPUT, Occasion, Outputs, switched};
use crate::scene::Touch;
use crate::sheet::Sheet;
use crate::trigger;
use kerf_motion::{Plan, Span};
use kerf_program::settings::{LINES, Mode, SWITCHES};
use kerf_program::{
    AXES, Axes, Axis, AxisSet, Beam, Frame, HeightLaw, Independent, OutputReason, Settings,
};
use std::sync::Arc;

/// The PWM channel of the heater.
const HEATER_CHANNEL: u8 = 1;

/// The outputs of the spindles.
const SPINDLES: [u8; 2] = [1, 2];

/// What was on when the power went off.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct WasOn {
    /// Outputs, by number.
    pub outputs: Vec<u8>,
    /// The PWM channel.
    pub pwm_percent: f64,
}

impl WasOn {
    /// Whether a spindle is among it: outputs 1 and 2, or the speed that a PWM channel sets.
    pub fn turns(&self) -> bool {
        self.outputs.iter().any(|n| SPINDLES.contains(n)) || self.pwm_percent > 0.0
    }
}

/// A simulated machine. See the [crate] for what it does.
#[derive(Clone, Debug)]
pub struct Machine {
    clock_s: f64,
    /// Where planned motion has brought it, machine frame.
    position: Axes,
    frame: Frame,
    settings: Arc<Settings>,
    inputs: Inputs,
    outputs: Outputs,
    spins: [Spin; AXES],
    /// How far the torch has carried Z.
    torch: Spin,
    /// How fast it does so now.
    torch_mm_s: f64,
    heater: Heater,
    motors: Motors,
    /// Motors have power.
    powered: bool,
    /// Axes that may have been moved by hand while they had none.
    unverified: AxisSet,
    hand: Hand,
    /// Where the axes truly are.
    carriages: Carriages,
    /// Where each axis may go, machine frame.
    bounds: [Option<(f64, f64)>; AXES],
    /// Factors of coarser steps.
    coarse: [u8; AXES],
    pwm_percent: f64,
    beam: Beam,
    /// When the beam that follows the speed goes off, in the move under way.
    beam_ends_s: Option<f64>,
    sheet: Option<Sheet>,
    /// What switches feel where the tool is.
    touches: Arc<[Touch]>,
    /// Height control, while it is on.
    law: Option<HeightLaw>,
    follower: Follower,
    /// What the intensity output gives: value and burn bit.
    intensity: (u8, bool),
    light: bool,
    /// Outputs of mode 2 that a stop switched off: they come back when motion goes on.
    come_back: Vec<u8>,
    /// Limits were overridden until the file ends.
    overridden: bool,
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
            overridden: false,
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

    /// The same machine, standing elsewhere while a preview is drawn.
    #[must_use]
    pub fn drawing_from(mut self, position: Axes) -> Self {
        let drawn = std::mem::replace(&mut self.position, position);
        self.motors.say(self.true_position());
        (self.position, self.drawing_from) = (drawn, Some(position));
        self
    }

    /// Whether commands are only drawn (SP): outputs, waits and inputs have no effect.
    pub const fn draws(&self) -> bool {
        self.drawing_from.is_some()
    }

    /// Machine time, seconds.
    pub const fn clock_s(&self) -> f64 {
        self.clock_s
    }

    /// Where planned motion has brought it, machine frame.
    pub const fn position(&self) -> Axes {
        self.position
    }

    /// Where it is, axes that move on their own included, machine frame.
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

    /// What moves by itself.
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

    /// What an input, 1 … 12, reads.
    pub fn input(&self, number: u8) -> bool {
        self.inputs.reads(number, &self.settings.io)
    }

    /// The outputs.
    pub const fn outputs(&self) -> &Outputs {
        &self.outputs
    }

    /// What happened since this was asked last.
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

    /// The heater is held at its temperature, or cools.
    fn heat(&mut self, to_s: f64) {
        let (mut heater, height) = (self.heater, self.settings.height);
        if heater::active(&height, &self.settings.io) {
            heater.hold(to_s, &height, |t_s, percent| self.pwm_at(t_s, HEATER_CHANNEL, percent));
        } else {
            if heater.heats() {
                self.pwm(HEATER_CHANNEL, 0.0);
            }
            heater.cool(to_s);
        }
        self.heater = heater;
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

    /// A part file starts.
    pub fn begin_file(&mut self) {
        self.begin_lines();
        self.by_mode(Occasion::Start, OutputReason::Mode);
    }

    /// Lines that somebody typed begin.
    pub fn begin_lines(&mut self) {
        self.advance(self.clock_s);
        self.overridden = false;
    }

    /// The part file is over.
    pub fn end_file(&mut self) {
        self.end_lines();
        self.by_mode(Occasion::End, OutputReason::End);
    }

    /// Lines that somebody typed are over: outputs stay as they are.
    pub fn end_lines(&mut self) {
        self.set_light(false);
        self.land_torch();
        self.overridden = false;
    }

    /// Motion was stopped: outputs do what their modes say.
    pub fn stopped(&mut self) {
        if matches!(self.settings.io.output4, -2 | -3) {
            self.output(MOTION_OUTPUT, false, OutputReason::Stop);
        }
        self.come_back = self.outputs_of_mode_2();
        self.by_mode(Occasion::Stop, OutputReason::Stop);
    }

    /// A motor has stalled.
    pub fn stalled(&mut self) {
        if self.settings.io.output4 == -3 {
            self.output(MOTION_OUTPUT, false, OutputReason::Stop);
        }
    }

    /// Spindles and axes that move by themselves stop. Tells which spindles turned.
    pub fn stop_spindles(&mut self) -> Vec<u8> {
        self.spins_off();
        let turned: Vec<u8> = SPINDLES.into_iter().filter(|n| self.outputs.is_on(*n)).collect();
        turned.iter().for_each(|number| self.output(*number, false, OutputReason::Stop));
        turned
    }

    /// Every output goes off.
    pub fn outputs_off(&mut self) {
        self.set_light(false);
        self.all_off(OutputReason::Stop);
        self.pwm(HEATER_CHANNEL, 0.0);
    }

    fn outputs_of_mode_2(&self) -> Vec<u8> {
        let pauses = |n: &u8| self.settings.io.outputs[usize::from(*n) - 1] == 2;
        (1..=SWITCHES as u8).filter(pauses).filter(|n| self.outputs.is_on(*n)).collect()
    }

    /// Motion goes on after a stop.
    pub fn resumed(&mut self) {
        for number in std::mem::take(&mut self.come_back) {
            self.output(number, true, OutputReason::Mode);
        }
        self.by_mode(Occasion::Resume, OutputReason::Mode);
    }

    /// The power was off: nothing is on, and it stands somewhere. Tells what was on, but for what comes
    /// back by itself: the output that follows motion and the one that the trigger switches.
    pub fn restart(&mut self, position: Axes) -> WasOn {
        self.position = position;
        self.motors.say(self.true_position());
        self.light = false;
        let pwm_percent = std::mem::take(&mut self.pwm_percent);
        (self.beam, self.intensity) = (Beam::Off, (0, false));
        (self.law, self.follower) = (None, Follower::default());
        let outputs = std::mem::take(&mut self.outputs);
        let trigger = &self.settings.cutter.trigger;
        let by_itself = |n: u8| {
            n == MOTION_OUTPUT && self.settings.io.output4 != -4
                || trigger.active && n == trigger.output
        };
        let on = |n: &u8| outputs.is_on(*n) && !by_itself(*n);
        WasOn { outputs: (1..=SWITCHES as u8).filter(on).collect(), pwm_percent }
    }

    /// It stands there, without having gone there: what led there has happened before.
    pub const fn put(&mut self, position: Axes) {
        self.position = position;
    }

    /// Limits do not stop motion any more, until the file ends.
    pub const fn override_limits(&mut self) {
        self.overridden = true;
    }

    /// Switches an output.
    pub fn output(&mut self, number: u8, on: bool, why: OutputReason) {
        self.output_at(self.clock_s, number, on, why);
    }

    /// Sets the PWM channel.
    pub fn pwm(&mut self, channel: u8, percent: f64) {
        self.pwm_at(self.clock_s, channel, percent);
    }

    /// Sets the speed of a spindle.
    pub fn spindle(&mut self, number: u8, rpm: f64) {
        if self.draws() {
            return;
        }
        let on = self.outputs.is_on(number);
        self.log.add(self.clock_s, What::Spindle { number, rpm, on });
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

    fn all_off(&mut self, why: OutputReason) {
        for number in 1..=LINES as u8 {
            self.output(number, false, why);
        }
    }

    /// Ends the warning until the next motion (WARNING OFF, a question to the operator).
    pub fn warning_off(&mut self) {
        self.set_light(false);
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

    /// Somebody moves the switch of an input, now or at a moment of the motion under way; it stays
    /// there, also for the next run.
    pub fn press(&mut self, change: Change) {
        let at_s = change.at_s.max(self.clock_s);
        self.inputs.press(Change { at_s, ..change });
        self.advance(self.clock_s);
    }

    /// Switches that somebody moved by hand, and where they were left.
    pub fn switches(&self) -> Vec<(u8, bool)> {
        self.inputs.moved_by_hand()
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

    /// When an input reads a state: now, or at the time of a later change. `None` for never.
    pub fn when_input(&self, number: u8, on: bool) -> Option<f64> {
        self.inputs.when(number, on, self.clock_s, &self.settings.io)
    }

    /// When an input changes to a state the next time. `None` for never.
    pub fn when_pressed(&self, number: u8, on: bool) -> Option<f64> {
        let (now, modes) = (self.clock_s, &self.settings.io);
        let rests_s = self.inputs.when(number, !on, now, modes)?;
        self.inputs.when(number, on, rests_s, modes)
    }

    /// The first change of an input up to a time that stops motion, or a program that waits.
    pub fn first_halt(&self, until_s: f64, watches: &[Watched]) -> Option<Halt> {
        if self.draws() {
            return None;
        }
        halt::first(&self.inputs, until_s, &self.settings.io, watches, !self.overridden)
    }

    /// A stop input that forbids motion now.
    pub fn stop_input(&self) -> Option<u8> {
        if self.draws() {
            return None;
        }
        self.inputs.stopping(&self.settings.io)
    }

    /// Whether the controller answers. What is only drawn needs none.
    pub fn is_connected(&self) -> bool {
        let Settings { driver, controller, io, .. } = &*self.settings;
        let answers = controller.is_simulated(driver.port) && self.inputs.reads(CABLE, io);
        self.draws() || answers
    }

    /// An open enclosure that forbids motion and spindles now: the input that tells it.
    pub fn open_enclosure(&self) -> Option<u8> {
        let interlock = self.settings.io.interlock?;
        (!self.draws() && self.input(interlock)).then_some(interlock)
    }

    /// Motion is about to start: the warning comes first. Returns when motion starts, seconds.
    pub fn begin_motion(&mut self) -> f64 {
        if !self.draws() {
            self.power_motors(true);
        }
        if !self.light && !self.draws() {
            self.set_light(true);
            let wait_s = self.settings.warning_s.max(0.0);
            self.advance(self.clock_s + wait_s);
        }
        self.clock_s
    }

    /// A move of a plan that started at `t0_s` has been made: outputs, PWM, position, clock.
    pub fn make(&mut self, t0_s: f64, plan: &Plan, span: &Span<'_>) {
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
        self.follow_sheet(t0_s, plan, span);
        self.carriages.moved(self.position, span.made.to);
        self.position = span.made.to;
        if !self.draws() {
            self.advance(t0_s + span.t1_s);
        }
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

    fn by_mode(&mut self, occasion: Occasion, why: OutputReason) {
        let io = self.settings.io;
        for (number, on) in switched(&io, occasion) {
            self.output(number, on, why);
        }
    }

    fn set_light(&mut self, on: bool) {
        if std::mem::replace(&mut self.light, on) == on {
            return;
        }
        self.log.add(self.clock_s, What::Light(on));
        if self.settings.io.output4 != -4 {
            self.output(MOTION_OUTPUT, on, OutputReason::Motion);
        }
    }

    fn output_at(&mut self, t_s: f64, number: u8, on: bool, why: OutputReason) {
        let given = self.settings.driver.enabled || !on;
        if !self.draws() && given && self.outputs.set(number, on) {
            self.log.add(t_s, What::Output { number, on, why });
            self.release_jig(t_s, number, on);
        }
    }

    fn pwm_at(&mut self, t_s: f64, channel: u8, percent: f64) {
        if !self.draws() && (self.pwm_percent - percent).abs() > 1e-9 {
            self.pwm_percent = percent;
            let frequency_khz = self.settings.height.frequency_khz;
            self.log.add(t_s, What::Pwm { channel, percent, frequency_khz });
        }
    }
}

#[cfg(test)]
mod tests;
