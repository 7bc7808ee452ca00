//! Inputs: what they read, when they change, and which of them stop motion.

use super::Machine;
use crate::halt::{self, Halt, Heeds, Watched};
use crate::inputs::{CABLE, Change};
use kerf_program::Settings;
use std::collections::BTreeSet;

impl Machine {
    /// Returns the state that an input, 1 … 12, reads.
    pub fn input(&self, number: u8) -> bool {
        self.inputs.reads(number, &self.settings.io)
    }

    /// Returns what programs read from inputs at a moment of the motion under way: the clock stands at its beginning.
    pub fn inputs_at(&self, t_s: f64) -> impl Fn(u8) -> bool {
        let inputs = self.inputs.at(t_s, &self.settings.io);
        move |number| inputs.reads(number, &self.settings.io)
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

    /// Returns when an input reads a state: now, or at the time of a later change. `None` for never.
    pub fn when_input(&self, number: u8, on: bool) -> Option<f64> {
        self.inputs.when(number, on, self.clock_s, &self.settings.io)
    }

    /// Returns when an input changes to a state the next time. `None` for never.
    pub fn when_pressed(&self, number: u8, on: bool) -> Option<f64> {
        let (now, modes) = (self.clock_s, &self.settings.io);
        let rests_s = self.inputs.when(number, !on, now, modes)?;
        self.inputs.when(number, on, rests_s, modes)
    }

    /// Inputs that changed from a moment on, up to now, and what they read.
    pub fn changed_since(&self, from_s: f64) -> Vec<(u8, bool)> {
        self.inputs.changed_since(from_s, &self.settings.io)
    }

    /// The first change of an input up to a time that stops motion, or a program that waits.
    pub fn first_halt(&self, until_s: f64, watches: &[Watched]) -> Option<Halt> {
        if self.draws() {
            return None;
        }
        let heeds = Heeds { limits: true, stalls: true, past: &self.overridden.switches };
        halt::first(&self.inputs, until_s, &self.settings.io, watches, heeds)
    }

    /// The same while nothing moves.
    pub fn first_halt_at_rest(&self, until_s: f64, watches: &[Watched]) -> Option<Halt> {
        let watched = || {
            let at_rest = Heeds { limits: false, stalls: false, past: &BTreeSet::new() };
            halt::first(&self.inputs, until_s, &self.settings.io, watches, at_rest)
        };
        (!self.draws()).then(watched).flatten()
    }

    /// A stop input that forbids motion now.
    pub fn stop_input(&self) -> Option<u8> {
        if self.draws() {
            return None;
        }
        self.inputs.stopping(&self.settings.io)
    }

    /// A limit switch that is on now, or whose wire is broken, and that nobody has overridden.
    pub fn limit_input(&self) -> Option<u8> {
        if self.draws() {
            return None;
        }
        self.inputs.limiting(&self.settings.io, &self.overridden.switches)
    }

    /// Tells whether the controller answers. What is only drawn needs none.
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
}
