//! True places of the axes, and what their home switches tell of them.
//!
//! The controller believes an axis to be where it has sent it. Each motor's carriage is off from that by
//! what nobody told the controller: where the machine stood when it was switched on, a push by hand, a
//! motor that moved while the other one of its axis stood.

use kerf_machine::Configuration;
use kerf_machine::homing::Which;
use kerf_machine::lines::Input;
use kerf_machine::settings::homing::HomeEnd;
use kerf_motion::{Move, Path, Plan};
use kerf_program::{AXES, Axes, Axis};

/// Time between two looks at a switch, seconds.
const LOOK_S: f64 = 0.001;

/// Precision with which the moment of a change is sought, seconds.
const EXACT_S: f64 = 1e-9;

/// The carriages of all axes.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Carriages {
    axes: [Vec<Carriage>; AXES],
    /// Any of them has a switch.
    has_switch: bool,
    hysteresis: f64,
    /// The motor that moves while the others of its axis stand.
    alone: Option<(Axis, usize)>,
}

/// Carriage that one motor moves.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Carriage {
    /// True place less the place that is believed.
    astray: f64,
    /// True place at which its switch turns on.
    switch_at: Option<f64>,
    /// The side on which the switch is: 1 or −1.
    side: f64,
    on: bool,
}

impl Carriage {
    /// Returns the state that the switch reads at a true place.
    fn reads(&self, place: f64, hysteresis: f64) -> bool {
        let Some(at) = self.switch_at else { return false };
        let beyond = self.side * (place - at);
        beyond >= 0.0 || (self.on && beyond > -hysteresis)
    }
}

impl Carriages {
    /// Of a machine that was just switched on: what is believed is counted from where it stands.
    pub fn new(machine: &Configuration) -> Self {
        let simulated = &machine.simulated;
        let of_axis = |axis: Axis| {
            let side = if machine.homing.of(axis).end == HomeEnd::High { 1.0 } else { -1.0 };
            let fitted = machine.homing.of(axis).fitted;
            let carriage = |motor: kerf_machine::settings::motors::Motor| Carriage {
                astray: simulated.start_at[axis.index()],
                switch_at: simulated.switch_at[motor.index()].filter(|_| fitted),
                side,
                on: false,
            };
            machine.motors.of_axis(axis).into_iter().map(carriage).collect()
        };
        let axes = Axis::ALL.map(of_axis);
        let has_switch = axes.iter().flatten().any(|it: &Carriage| it.switch_at.is_some());
        Self { axes, has_switch, hysteresis: simulated.hysteresis, alone: None }
    }

    /// Returns how far each carriage is off.
    pub fn astray(&self) -> Vec<Vec<f64>> {
        self.axes.iter().map(|axis| axis.iter().map(|it| it.astray).collect()).collect()
    }

    /// They are off by so much; carriages that are not there are left out.
    pub fn set_astray(&mut self, astray: &[Vec<f64>]) {
        for (axis, values) in self.axes.iter_mut().zip(astray) {
            axis.iter_mut().zip(values).for_each(|(it, value)| it.astray = *value);
        }
    }

    /// Tells whether a switch of these motors is on.
    pub fn is_on(&self, axis: Axis, which: Which) -> bool {
        let axis = &self.axes[axis.index()];
        match which {
            Which::All => axis.iter().any(|it| it.on),
            Which::One(motor) => axis.get(motor).is_some_and(|it| it.on),
        }
    }

    /// The lines of home switches that there are, and what they read.
    pub fn lines(&self) -> Vec<(u8, bool)> {
        let lines = [Input::XHome, Input::YHome, Input::ZHome, Input::WHome];
        let told = |line: Input| {
            let axes = Axis::ALL.into_iter().filter(|axis| Input::home_of(*axis) == Some(line));
            let switches = axes.flat_map(|axis| &self.axes[axis.index()]);
            let mut switches = switches.filter(|it| it.switch_at.is_some()).peekable();
            switches.peek()?;
            Some((line.number(), switches.any(|it| it.on)))
        };
        lines.into_iter().filter_map(told).collect()
    }

    /// Only this motor moves from here on; `None` for all.
    pub const fn move_alone(&mut self, motor: Option<(Axis, usize)>) {
        self.alone = motor;
    }

    /// The controller believes to have moved.
    pub fn moved(&mut self, from: Axes, to: Axes) {
        if let Some((axis, motor)) = self.alone {
            let by = to[axis] - from[axis];
            let others = self.axes[axis.index()].iter_mut().enumerate();
            others.filter(|(n, _)| *n != motor).for_each(|(_, it)| it.astray -= by);
        }
        self.settle(to);
    }

    /// Somebody pushed an axis.
    pub fn pushed(&mut self, axis: Axis, by: f64, believed: Axes) {
        self.axes[axis.index()].iter_mut().for_each(|it| it.astray += by);
        self.settle(believed);
    }

    /// Makes a place that was believed the zero from now on.
    pub fn zeroed(&mut self, axis: Axis, place: f64) {
        self.axes[axis.index()].iter_mut().for_each(|it| it.astray += place);
    }

    /// Switches read what they read at these places.
    pub fn settle(&mut self, believed: Axes) {
        if !self.has_switch {
            return;
        }
        let hysteresis = self.hysteresis;
        for axis in Axis::ALL {
            for it in &mut self.axes[axis.index()] {
                it.on = it.reads(believed[axis] + it.astray, hysteresis);
            }
        }
    }

    /// Returns when lines of switches change while a plan is carried out: seconds of the plan, line, state.
    pub fn foresee(&self, plan: &Plan) -> Vec<(f64, u8, bool)> {
        if !self.has_switch {
            return Vec::new();
        }
        let mut ahead = self.clone();
        let mut changes = Vec::new();
        for (index, made) in plan.moves().iter().enumerate() {
            if ahead.may_change(made) {
                match made.path {
                    Path::Line => ahead.pass(plan, index, &mut changes),
                    _ => ahead.look(plan, index, &mut changes),
                }
            } else {
                ahead.moved(made.from, made.to);
            }
        }
        changes
    }

    /// Tells whether a switch can change on the way of a move.
    fn may_change(&self, made: &Move) -> bool {
        let bulge = match made.path {
            Path::Arc { centre, .. } => {
                2.0 * (made.from.0[0] - centre[0]).hypot(made.from.0[1] - centre[1])
            }
            _ => 0.0,
        };
        Axis::ALL.into_iter().any(|axis| {
            let (from, to) = (made.from[axis], made.to[axis]);
            let ends = [from.min(to) - bulge, from.max(to) + bulge];
            self.axes[axis.index()].iter().any(|it| {
                ends.iter().any(|end| it.reads(end + it.astray, self.hysteresis) != it.on)
            })
        })
    }

    /// Follows a straight move: each switch is passed once at the most.
    fn pass(&mut self, plan: &Plan, index: usize, changes: &mut Vec<(f64, u8, bool)>) {
        let (begin_s, end_s) = plan.span_s(index);
        let (from, to) = (plan.at(begin_s).position, plan.at(end_s).position);
        let mut after = self.clone();
        after.moved(from, to);
        let mut passed = Vec::new();
        for axis in Axis::ALL {
            let now = self.axes[axis.index()].iter().zip(&after.axes[axis.index()]);
            for (motor, _) in now.enumerate().filter(|(_, (now, then))| now.on != then.on) {
                passed.push((
                    self.moment_of(plan, (axis, motor), from, [begin_s, end_s]),
                    axis,
                    motor,
                ));
            }
        }
        passed.sort_by(|a, b| a.0.total_cmp(&b.0));
        for (t_s, axis, motor) in passed {
            let before = self.lines();
            let it = &mut self.axes[axis.index()][motor];
            it.on = !it.on;
            let changed = self.lines().into_iter().zip(before).filter(|(now, then)| now != then);
            changes.extend(changed.map(|((line, on), _)| (t_s, line, on)));
        }
        *self = after;
    }

    /// Finds the moment at which one switch is passed, between two others, seconds of the plan.
    fn moment_of(
        &self,
        plan: &Plan,
        (axis, motor): (Axis, usize),
        from: Axes,
        [mut low_s, mut high_s]: [f64; 2],
    ) -> f64 {
        let it = self.axes[axis.index()][motor];
        let stands = self.alone.is_some_and(|(of, moves)| of == axis && moves != motor);
        let place = |t_s: f64| {
            let believed = if stands { from[axis] } else { plan.at(t_s).position[axis] };
            believed + it.astray
        };
        while high_s - low_s > EXACT_S {
            let middle_s = 0.5 * (low_s + high_s);
            let passed = it.reads(place(middle_s), self.hysteresis) != it.on;
            if passed { high_s = middle_s } else { low_s = middle_s }
        }
        high_s
    }

    /// Looks at the switches all along a move.
    fn look(&mut self, plan: &Plan, index: usize, changes: &mut Vec<(f64, u8, bool)>) {
        let (begin_s, end_s) = plan.span_s(index);
        let slices = ((end_s - begin_s) / LOOK_S).ceil().max(1.0) as u64;
        let (mut from_s, mut from) = (begin_s, plan.at(begin_s).position);
        for slice in 1..=slices {
            let t_s = begin_s + (end_s - begin_s) * slice as f64 / slices as f64;
            let to = plan.at(t_s).position;
            let (before, mut after) = (self.lines(), self.clone());
            after.moved(from, to);
            let now = after.lines();
            if now != before {
                let change_s = self.moment(plan, from, [from_s, t_s]);
                let changed = now.into_iter().zip(before).filter(|(now, then)| now != then);
                changes.extend(changed.map(|((line, on), _)| (change_s, line, on)));
            }
            (*self, from_s, from) = (after, t_s, to);
        }
    }

    /// Finds the moment at which the lines first change, between two others, seconds of the plan.
    fn moment(&self, plan: &Plan, from: Axes, [mut low_s, mut high_s]: [f64; 2]) -> f64 {
        let changed = |t_s: f64| {
            let mut there = self.clone();
            there.moved(from, plan.at(t_s).position);
            there.lines() != self.lines()
        };
        while high_s - low_s > EXACT_S {
            let middle_s = 0.5 * (low_s + high_s);
            if changed(middle_s) { high_s = middle_s } else { low_s = middle_s }
        }
        high_s
    }
}
