//! All that a machine tells: places and limits, what its inputs read, when they change, and which of them stop motion.

use super::Model;
use crate::halt::{self, Halt, Heeds, Watched};
use crate::inputs::CABLE;
use crate::limits::{self, Violation};
use crate::outputs::Outputs;
use kerf_motion::Move;
use kerf_program::{AXES, Axes, Axis, AxisSet, Frame, Independent, Settings};
use std::collections::BTreeSet;
use std::sync::Arc;

impl Model {
    /// Returns the state that an input, 1 … 12, reads.
    pub fn input(&self, number: u8) -> bool {
        self.inputs.reads(number, &self.settings.io)
    }

    /// Returns what programs read from inputs at a moment of the motion under way: the clock stands at its beginning.
    pub fn inputs_at(&self, t_s: f64) -> impl Fn(u8) -> bool {
        let inputs = self.inputs.at(t_s, &self.settings.io);
        move |number| inputs.reads(number, &self.settings.io)
    }

    /// Returns when an input reads a state: now, or at a later moment of which was told. `None` where nobody told.
    pub fn when_input(&self, number: u8, on: bool) -> Option<f64> {
        self.inputs.when(number, on, self.clock_s, &self.settings.io)
    }

    /// Returns the inputs that changed from a moment on, up to now, and what they read.
    pub fn changed_since(&self, from_s: f64) -> Vec<(u8, bool)> {
        self.inputs.changed_since(from_s, &self.settings.io)
    }

    /// Returns the moment up to which is known what the inputs do: now, or that of the last change that was told.
    pub fn told_s(&self) -> f64 {
        self.inputs.told_s().map_or(self.clock_s, |told_s| told_s.max(self.clock_s))
    }

    /// Returns the first change that was told, up to a time, that stops motion, or a program that waits.
    pub fn halted(&self, until_s: f64, watches: &[Watched]) -> Option<Halt> {
        self.halted_by(
            until_s,
            watches,
            Heeds { limits: true, stalls: true, past: &self.overridden.switches },
        )
    }

    /// Returns the first change that was told, up to a time, that stops a program while nothing moves.
    pub fn halted_at_rest(&self, until_s: f64, watches: &[Watched]) -> Option<Halt> {
        self.halted_by(
            until_s,
            watches,
            Heeds { limits: false, stalls: false, past: &BTreeSet::new() },
        )
    }

    fn halted_by(&self, until_s: f64, watches: &[Watched], heeds: Heeds<'_>) -> Option<Halt> {
        let levels = watches.iter().any(|watch| watch.level_from_s.is_some());
        let changes = levels || self.inputs.is_due(until_s);
        let halt = || halt::first(&self.inputs, until_s, &self.settings.io, watches, heeds);
        (changes && !self.draws()).then(halt).flatten()
    }

    /// Returns a stop input that forbids motion now.
    pub fn stop_input(&self) -> Option<u8> {
        if self.draws() {
            return None;
        }
        self.inputs.stopping(&self.settings.io)
    }

    /// Returns a limit switch that is on now, or whose wire is broken, and that nobody has overridden.
    pub fn limit_input(&self) -> Option<u8> {
        if self.draws() {
            return None;
        }
        self.inputs.limiting(&self.settings.io, &self.overridden.switches)
    }

    /// Returns `true` if the controller answers, or motion is only drawn and needs none.
    pub fn is_connected(&self) -> bool {
        let Settings { driver, controller, io, .. } = &*self.settings;
        let answers = controller.is_simulated(driver.port) && self.inputs.reads(CABLE, io);
        self.draws() || answers
    }

    /// Returns the input that tells of an open enclosure, which forbids motion and spindles now.
    pub fn open_enclosure(&self) -> Option<u8> {
        let interlock = self.settings.io.interlock?;
        (!self.draws() && self.input(interlock)).then_some(interlock)
    }

    /// Returns `true` while commands are only drawn (SP): outputs, waits and inputs have no effect.
    pub const fn draws(&self) -> bool {
        self.drawing_from.is_some()
    }

    /// Returns machine time, seconds.
    pub const fn clock_s(&self) -> f64 {
        self.clock_s
    }

    /// Returns the position that planned motion has reached, machine frame.
    pub const fn position(&self) -> Axes {
        self.position
    }

    /// Returns the position, axes that move on their own included, machine frame.
    pub fn true_position(&self) -> Axes {
        let mut place = self.position;
        for axis in Axis::ALL {
            place[axis] += self.spins[axis.index()].displacement(self.clock_s);
        }
        place[Axis::Z] += self.torch.displacement(self.clock_s) + self.carried_mm;
        place
    }

    /// Returns the axes that move by themselves.
    pub fn spinning(&self) -> AxisSet {
        let moving = Axis::ALL.into_iter().filter(|axis| self.spins[axis.index()].moves());
        moving.fold(AxisSet::EMPTY, AxisSet::with)
    }

    /// Returns the axes that move by themselves, with their motions.
    pub fn moving_alone(&self) -> Vec<(Axis, Independent)> {
        self.spinning().iter().map(|axis| (axis, self.spins[axis.index()].motion())).collect()
    }

    /// Returns the frames in force.
    pub const fn frame(&self) -> &Frame {
        &self.frame
    }

    /// Returns the settings in force.
    pub const fn settings(&self) -> &Arc<Settings> {
        &self.settings
    }

    /// Returns the outputs.
    pub const fn outputs(&self) -> &Outputs {
        &self.outputs
    }

    /// Returns the temperature of the heater, degrees.
    pub const fn heater_degrees(&self) -> f64 {
        self.heater.degrees()
    }

    /// Returns the steps that each motor has made, driver channel 1 first.
    pub fn steps(&self) -> [i64; AXES] {
        let mut motors = self.motors.clone();
        if !self.draws() {
            motors.follow(self.true_position(), &self.settings);
        }
        motors.steps()
    }

    /// Returns the axes that may have been moved while the motors had no power, and whose location nobody has
    /// set since.
    pub const fn unverified(&self) -> AxisSet {
        self.unverified
    }

    /// Returns the motor of an axis that moves while the others stand; `None` for all.
    pub const fn alone(&self) -> Option<(Axis, usize)> {
        self.alone
    }

    /// Returns the first move of a stack that would leave the table, or the lengths of the axes, unless limits
    /// are off or overridden.
    pub fn first_outside(&self, moves: &[Move]) -> Option<Violation> {
        if self.overridden.table {
            return None;
        }
        let axes = usize::from(self.settings.axis_count);
        let limits = &self.settings.limits;
        let table = limits
            .check
            .then(|| limits::first_outside(moves, self.frame.base_zero, limits, axes))
            .flatten();
        let soft = limits::first_out_of_bounds(moves, &self.bounds);
        match (table, soft) {
            (Some(table), Some(soft)) if table.move_index <= soft.move_index => Some(table),
            (table, soft) => soft.or(table),
        }
    }

    /// Returns the range of an axis, machine frame: its soft bounds, and the table limits while they are checked.
    pub fn room(&self, axis: Axis) -> (f64, f64) {
        let (mut low, mut high) =
            self.bounds[axis.index()].unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
        let limits = &self.settings.limits;
        if limits.check && !self.overridden.table {
            let zero = self.frame.base_zero[axis];
            (low, high) = (low.max(limits.low[axis] + zero), high.min(limits.high[axis] + zero));
        }
        (low, high)
    }
}
