//! All that a machine tells: places and limits, what its inputs read, when they change, and which of them stop motion.

use super::Machine;
use crate::carriages::line_of;
use crate::flips::flips;
use crate::halt::{self, Halt, Heeds, Watched};
use crate::inputs::{CABLE, Change};
use crate::limits::{self, Violation};
use crate::outputs::Outputs;
use crate::scene;
use kerf_machine::homing::Which;
use kerf_machine::lines::Input;
use kerf_motion::{Move, Plan};
use kerf_program::{AXES, Axes, Axis, AxisSet, Frame, Independent, Settings};
use std::collections::BTreeSet;
use std::sync::Arc;

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

    /// Switches that somebody moved by hand, and where they were left.
    pub fn switches(&self) -> Vec<(u8, bool)> {
        self.inputs.moved_by_hand()
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
        place[Axis::Z] += self.torch.displacement(self.clock_s) + self.head.offset_mm();
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

    /// Temperature of the heater, degrees.
    pub const fn heater_degrees(&self) -> f64 {
        self.heater.degrees()
    }

    /// Steps each motor has made, driver channel 1 first.
    pub fn steps(&self) -> [i64; AXES] {
        let mut motors = self.motors.clone();
        if !self.draws() {
            motors.follow(self.true_position(), &self.settings);
        }
        motors.steps()
    }

    /// Axes that may have been moved while the motors had no power, and whose location nobody has
    /// set since.
    pub const fn unverified(&self) -> AxisSet {
        self.unverified
    }

    /// Returns how far axes are from where the controller believes them, because somebody pushed them: what only the
    /// simulation knows, mm or degrees.
    pub const fn astray(&self) -> Axes {
        self.hand.astray
    }

    /// Returns how far each motor's carriage is from where the controller believes it: what only the simulation knows.
    pub fn truth(&self) -> Vec<Vec<f64>> {
        self.carriages.astray()
    }

    /// Tells whether a home switch of an axis is on.
    pub fn home_switch(&self, axis: Axis, which: Which) -> bool {
        self.carriages.is_on(axis, which)
    }

    /// The input of an axis' home switch.
    pub fn home_line(axis: Axis) -> Option<Input> {
        line_of(axis)
    }

    /// The motor of an axis that moves while the others stand; `None` for all.
    pub const fn alone(&self) -> Option<(Axis, usize)> {
        self.carriages.alone()
    }

    /// The first move of a stack that would leave the table, or the lengths of the axes, unless limits
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

    /// Foresees the changes of the home switches while a plan is carried out.
    pub(super) fn foreseen_switches(&self, plan: &Plan, t0_s: f64) -> Vec<Change> {
        let change = |(t_s, input, on)| Change { input, at_s: t0_s + t_s, on };
        let ahead = self.carriages.foresee(plan).into_iter().map(change);
        ahead.filter(|change| change.at_s >= self.clock_s).collect()
    }

    /// Foresees what switches will feel on the way.
    pub(super) fn foreseen_touches(&self, plan: &Plan, t0_s: f64) -> Vec<Change> {
        let change = |input: u8| {
            let felt = |t_s: f64| {
                let at = plan.at(t_s).position;
                scene::contact(&self.touches, input, &at).unwrap_or_default()
            };
            let from_s = (self.clock_s - t0_s).max(0.0);
            let flips = flips(from_s, plan.duration_s(), &felt).into_iter();
            flips.map(move |(t_s, on)| Change { input, at_s: t0_s + t_s, on })
        };
        scene::inputs(&self.touches).into_iter().flat_map(change).collect()
    }
}
