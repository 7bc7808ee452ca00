//! Home switches, soft bounds, and where the axes truly are.

use super::Machine;
use crate::carriages::line_of;
use crate::inputs::Change;
use crate::limits::{self, Violation};
use kerf_machine::Configuration;
use kerf_machine::homing::{Which, soft_bounds};
use kerf_machine::lines::Input;
use kerf_motion::{Move, Plan};
use kerf_program::{Axis, AxisSet};

impl Machine {
    /// The same machine with the switches, motors and lengths of a configuration; the lengths bound these
    /// axes. What is known of where its axes truly are stays, where it has as many motors as before.
    #[must_use]
    pub fn equipped(mut self, machine: &Configuration, bounded: AxisSet) -> Self {
        let known = self.carriages.astray();
        self.carriages = crate::carriages::Carriages::new(machine);
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

    /// Returns how far each motor's carriage is from where the controller believes it: what only the simulation knows.
    pub fn truth(&self) -> Vec<Vec<f64>> {
        self.carriages.astray()
    }

    /// The same machine, whose carriages are off by so much.
    #[must_use]
    pub fn with_truth(mut self, truth: &[Vec<f64>]) -> Self {
        self.carriages.set_astray(truth);
        self.carriages.settle(self.position);
        self.put_home_switches();
        self
    }

    /// The contacts of the home switches are as the carriages have them.
    pub(super) fn put_home_switches(&mut self) {
        for (line, on) in self.carriages.lines() {
            if on || self.input(line) {
                self.inputs.put(line, on);
            }
        }
    }

    /// Tells whether a home switch of an axis is on.
    pub fn home_switch(&self, axis: Axis, which: Which) -> bool {
        self.carriages.is_on(axis, which)
    }

    /// The input of an axis' home switch.
    pub fn home_line(axis: Axis) -> Option<Input> {
        line_of(axis)
    }

    /// From here on only this motor of an axis moves; `None` for all.
    pub const fn move_alone(&mut self, motor: Option<(Axis, usize)>) {
        self.carriages.move_alone(motor);
    }

    /// The motor of an axis that moves while the others stand; `None` for all.
    pub const fn alone(&self) -> Option<(Axis, usize)> {
        self.carriages.alone()
    }

    /// The axis is at zero where it stands.
    pub fn zero(&mut self, axis: Axis) {
        self.carriages.zeroed(axis, self.position[axis]);
        self.position[axis] = 0.0;
        self.unverified.remove(axis);
        self.motors.say(self.true_position());
    }

    /// Foresees the changes of the home switches while a plan is carried out.
    pub(super) fn foreseen_switches(&self, plan: &Plan, t0_s: f64) -> Vec<Change> {
        let change = |(t_s, input, on)| Change { input, at_s: t0_s + t_s, on };
        let ahead = self.carriages.foresee(plan).into_iter().map(change);
        ahead.filter(|change| change.at_s >= self.clock_s).collect()
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
}
