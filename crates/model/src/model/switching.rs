//! Outputs: lines, spindles, PWM, intensity, the light of the warning, the power of the motors; and when they go on
//! and off by themselves.

use super::Model;
use super::shine::Shine;
use crate::heater;
use crate::limits::Overridden;
use crate::log::What;
use crate::outputs::{MOTION_OUTPUT, Occasion, switched};
use kerf_machine::lines::{Input, Output};
use kerf_program::settings::{LINES, SWITCHES};
use kerf_program::{AXES, Axes, Beam, MoveKind, OutputReason};

/// Factors of steps that are not made coarser.
const FINE: [u8; AXES] = [1; AXES];

/// The PWM channel of the heater.
const HEATER_CHANNEL: u8 = 1;

/// The outputs of the spindles.
const SPINDLES: [u8; 2] = [1, 2];

/// Outputs and PWM that were on when the power went off.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct WasOn {
    /// Outputs, by number.
    pub outputs: Vec<u8>,
    /// PWM channels, each with its percent.
    pub pwm: Vec<(u8, f64)>,
}

impl WasOn {
    /// Tells whether a spindle is among them: outputs 1 and 2, or the speed that a PWM channel sets.
    pub fn turns(&self) -> bool {
        self.outputs.iter().any(|n| SPINDLES.contains(n)) || !self.pwm.is_empty()
    }
}

impl Model {
    /// The heater is held at its temperature, or cools.
    pub(super) fn heat(&mut self, to_s: f64) {
        if !heater::active(&self.settings.height, &self.settings.io) {
            if self.heater.heats() {
                self.pwm(HEATER_CHANNEL, 0.0);
            }
            self.heater.cool(to_s);
            return;
        }
        let (mut heater, height) = (self.heater, self.settings.height);
        heater.hold(to_s, &height, |t_s, percent| self.pwm_at(t_s, HEATER_CHANNEL, percent));
        self.heater = heater;
    }

    /// A part file starts.
    pub fn begin_file(&mut self) {
        self.begin_lines();
        self.by_mode(Occasion::Start, OutputReason::Mode);
    }

    /// Tells whether an output comes on when a part file starts.
    pub fn switches_on_at_start(&self) -> bool {
        !self.draws() && switched(&self.settings.io, Occasion::Start).any(|(_, on)| on)
    }

    /// Lines that somebody typed begin.
    pub fn begin_lines(&mut self) {
        self.advance(self.clock_s);
        self.overridden = Overridden::default();
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
        self.overridden = Overridden::default();
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

    /// Tells whether a spindle turns, or an axis moves by itself.
    pub fn turns(&self) -> bool {
        !self.spinning().is_empty() || SPINDLES.into_iter().any(|n| self.outputs.is_on(n))
    }

    /// The operator stops a machine that stands: what turns goes off, and every output that a part file which is
    /// stopped leaves off.
    pub fn stop_at_rest(&mut self) {
        self.stop_spindles();
        self.by_mode(Occasion::Stop, OutputReason::Stop);
        self.by_mode(Occasion::End, OutputReason::Stop);
        self.come_back.clear();
    }

    /// Every output goes off.
    pub fn outputs_off(&mut self) {
        self.set_light(false);
        self.all_off(OutputReason::Stop);
        let channels: Vec<u8> = self.pwm.keys().copied().collect();
        channels.into_iter().for_each(|channel| self.pwm(channel, 0.0));
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
        // Where nobody was asked the light of the warning shines on: what follows it comes back.
        if self.light && self.settings.io.output4 != -4 {
            self.output(MOTION_OUTPUT, true, OutputReason::Motion);
        }
    }

    /// The power was off: nothing is on, and it stands somewhere. Tells what was on, but for what comes
    /// back by itself: the output that follows motion and the one that the trigger switches.
    pub fn restart(&mut self, position: Axes) -> WasOn {
        self.position = position;
        self.motors.say(self.true_position());
        self.light = false;
        let pwm = std::mem::take(&mut self.pwm).into_iter();
        let pwm = pwm.filter(|(_, percent)| *percent > 0.0).collect();
        self.shine = Shine::default();
        self.carried_mm = 0.0;
        let outputs = std::mem::take(&mut self.outputs);
        let trigger = &self.settings.cutter.trigger;
        let by_itself = |n: u8| {
            n == MOTION_OUTPUT && self.settings.io.output4 != -4
                || trigger.active && n == trigger.output
        };
        let on = |n: &u8| outputs.is_on(*n) && !by_itself(*n);
        WasOn { outputs: (1..=SWITCHES as u8).filter(on).collect(), pwm }
    }

    /// An output was left on, as far as anybody knows: whatever it is switched to is told.
    pub fn was_left_on(&mut self, number: u8) {
        self.outputs.was_left_on(number);
    }

    /// Switches an output.
    pub fn output(&mut self, number: u8, on: bool, why: OutputReason) {
        self.output_at(self.clock_s, number, on, why);
    }

    /// Sets a PWM channel.
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

    pub(super) fn all_off(&mut self, why: OutputReason) {
        for number in 1..=LINES as u8 {
            self.output(number, false, why);
        }
        self.beam(Beam::Off);
    }

    /// Ends the warning until the next motion (WARNING OFF, a question to the operator).
    pub fn warning_off(&mut self) {
        self.set_light(false);
    }

    pub(super) fn by_mode(&mut self, occasion: Occasion, why: OutputReason) {
        let io = self.settings.io;
        for (number, on) in switched(&io, occasion) {
            self.output(number, on, why);
        }
    }

    pub(super) fn set_light(&mut self, on: bool) {
        if std::mem::replace(&mut self.light, on) == on {
            return;
        }
        self.log.add(self.clock_s, What::Light(on));
        if self.settings.io.output4 != -4 {
            self.output(MOTION_OUTPUT, on, OutputReason::Motion);
        }
    }

    pub(super) fn output_at(&mut self, t_s: f64, number: u8, on: bool, why: OutputReason) {
        let given = self.settings.driver.enabled || !on;
        if !self.draws() && given && self.outputs.set(number, on) {
            self.log.add(t_s, What::Output { number, on, why });
            self.release_jig(t_s, number, on);
        }
    }

    pub(super) fn pwm_at(&mut self, t_s: f64, channel: u8, percent: f64) {
        let before = self.pwm.get(&channel).copied().unwrap_or_default();
        if !self.draws() && (before - percent).abs() > 1e-9 {
            self.pwm.insert(channel, percent);
            let frequency_khz = self.settings.height.frequency_khz;
            self.log.add(t_s, What::Pwm { channel, percent, frequency_khz });
        }
    }

    /// Cuts motor power; everything that moves or is on stops (MO).
    pub fn motors_off(&mut self) {
        if self.draws() {
            return;
        }
        self.spins_off();
        self.set_light(false);
        self.all_off(OutputReason::Stop);
        self.power_motors(false);
        self.doubt();
    }

    pub(super) fn power_motors(&mut self, on: bool) {
        if std::mem::replace(&mut self.powered, on) != on {
            self.log.add(self.clock_s, What::Motors(on));
        }
    }

    /// Steps are coarser during jogs, unless shifting is disabled.
    pub(super) fn shift_resolution(&mut self, moving: Option<MoveKind>) {
        let resolution = &self.settings.resolution;
        let shifted = moving == Some(MoveKind::Jog) && !resolution.no_shift;
        let factors = if shifted { resolution.multipliers } else { FINE };
        if !self.draws() && std::mem::replace(&mut self.coarse, factors) != factors {
            self.log.add(self.clock_s, What::Resolution(factors));
        }
    }

    /// The pulse frequency of the laser, Hz.
    pub fn laser_frequency(&mut self, hz: f64) {
        if !self.draws() {
            self.log.add(self.clock_s, What::LaserFrequency(hz));
        }
    }

    /// The output of a jig switches its start switch off.
    pub(super) fn release_jig(&mut self, t_s: f64, number: u8, on: bool) {
        let jigs = [(Output::Jig1, Input::Jig1), (Output::Jig2, Input::Jig2)];
        let jig = jigs.into_iter().find(|(output, _)| on && output.number() == number);
        if let Some((_, input)) = jig.filter(|(_, input)| self.input(input.number())) {
            self.inputs.put(input.number(), false);
            self.log.add(t_s, What::Input { number: input.number(), on: false });
        }
    }

    /// Returns the behaviour of the intensity output.
    pub const fn shines(&self) -> &Beam {
        self.shine.beam()
    }

    /// From here on the intensity output does this.
    pub fn beam(&mut self, beam: Beam) {
        let log = (!self.draws()).then_some(&mut self.log);
        self.shine.set(beam, self.clock_s, log);
    }

    /// Outputs go off at a moment in the middle of motion, and the intensity with them.
    pub fn drop_outputs(&mut self, t_s: f64, outputs: &[u8]) {
        for number in outputs {
            self.output_at(t_s, *number, false, OutputReason::Stop);
        }
        if !outputs.is_empty() {
            let log = (!self.draws()).then_some(&mut self.log);
            self.shine.drop_at(t_s, log);
        }
    }
}
