//! Axes with homing switches on a bench: where they truly are, which the controller does not know.
//!
//! An axis accelerates and slows evenly. Its switches are on beyond a place and, when it comes back,
//! a little longer (hysteresis). Two motors may carry one axis; then each has a switch.

use kerf_machine::Configuration;
use kerf_machine::homing::{Axle, Rig, Sought, Which};
use kerf_machine::settings::homing::HomeEnd;
use kerf_machine::settings::motors::Motor;
use kerf_program::{AXES, Axis};

/// A stretch of motion from rest to rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Leg {
    /// The axis.
    pub axis: Axis,
    /// Motor of the machine that moved.
    pub which: Which,
    /// Beginning and end, seconds.
    pub span_s: [f64; 2],
    /// True places, mm or degrees, of the first motor that moved.
    pub from: f64,
    /// The end of it.
    pub to: f64,
    /// Highest speed.
    pub peak: f64,
    /// True place where a switch changed that was waited for.
    pub edge: Option<f64>,
}

/// One motor of an axis.
#[derive(Clone, Copy, Debug)]
struct Carried {
    /// True place of what it carries.
    place: f64,
    /// True place of what counts as zero.
    zero: f64,
    /// True place at which its switch turns on.
    switch_at: Option<f64>,
    /// The switch is on.
    on: bool,
}

/// One axis.
#[derive(Clone, Debug)]
pub struct Shaft {
    axis: Axis,
    motors: Vec<Carried>,
    /// The side on which the switches are: 1 or −1.
    side: f64,
    accel: f64,
    hysteresis: f64,
    clock_s: f64,
    legs: Vec<Leg>,
}

/// All axes of a machine.
#[derive(Clone, Debug)]
pub struct Bench(Vec<Shaft>);

impl Bench {
    /// The simulated machine as its configuration says it truly is.
    pub fn new(machine: &Configuration) -> Self {
        Self(Axis::ALL.into_iter().map(|axis| Shaft::new(machine, axis)).collect())
    }

    /// One axis.
    pub fn shaft(&mut self, axis: Axis) -> &mut Shaft {
        &mut self.0[axis.index()]
    }

    /// Every motion so far, axis by axis.
    pub fn legs(&self) -> Vec<Leg> {
        self.0.iter().flat_map(|shaft| shaft.legs.iter().copied()).collect()
    }

    /// Returns the true place of every axis.
    pub fn places(&self) -> [f64; AXES] {
        std::array::from_fn(|i| self.0[i].place(0))
    }
}

impl Rig for Bench {
    fn axle(&mut self, axis: Axis) -> &mut dyn Axle {
        // Axes move one after the other: all clocks go on together.
        let now_s = self.0.iter().fold(0.0_f64, |now, shaft| now.max(shaft.clock_s));
        let shaft = self.shaft(axis);
        shaft.clock_s = now_s;
        shaft
    }
}

impl Shaft {
    fn new(machine: &Configuration, axis: Axis) -> Self {
        let simulated = &machine.simulated;
        let side = if machine.homing.of(axis).end == HomeEnd::High { 1.0 } else { -1.0 };
        let place = simulated.start_at[axis.index()];
        let carried = |motor: Motor| {
            let switch_at = simulated.switch_at[motor.index()];
            let on = switch_at.is_some_and(|at| side * (place - at) >= 0.0);
            Carried { place, zero: place, switch_at, on }
        };
        let motors: Vec<_> = machine.motors.of_axis(axis).into_iter().map(carried).collect();
        let without = Carried { place, zero: place, switch_at: None, on: false };
        Self {
            axis,
            motors: if motors.is_empty() { vec![without] } else { motors },
            side,
            accel: machine.program.axis_dynamics().accel_mm_s2[axis],
            hysteresis: simulated.hysteresis,
            clock_s: 0.0,
            legs: Vec::new(),
        }
    }

    /// Returns the true place of a motor; 0 for one that is not there.
    pub fn place(&self, motor: usize) -> f64 {
        self.motors.get(motor).map_or(0.0, |it| it.place)
    }

    /// Returns the place that the display shows for a motor; 0 for one that is not there.
    pub fn shown(&self, motor: usize) -> f64 {
        self.motors.get(motor).map_or(0.0, |it| it.place - it.zero)
    }

    /// A switch moves, or breaks.
    pub fn put_switch(&mut self, motor: usize, at: Option<f64>) {
        if let Some(it) = self.motors.get_mut(motor) {
            it.switch_at = at;
            it.on = at.is_some_and(|at| self.side * (it.place - at) >= 0.0);
        }
    }

    fn moved(&self, which: Which) -> std::ops::Range<usize> {
        match which {
            Which::All => 0..self.motors.len(),
            Which::One(motor) => motor..(motor + 1).min(self.motors.len()),
        }
    }

    /// The way until the switches read a state, when moving in a direction; nothing for never.
    fn way_until(&self, which: Which, direction: f64, until: bool) -> Option<f64> {
        let motors = &self.motors[self.moved(which)];
        let mut ways = motors.iter().filter(|it| it.on != until).map(|it| {
            let at = it.switch_at?;
            let edge = if until { at } else { at - self.side * self.hysteresis };
            let way = (edge - it.place) * direction;
            (way >= 0.0 && (direction == self.side) == until).then_some(way)
        });
        if until {
            ways.flatten().min_by(f64::total_cmp)
        } else {
            // All of them have to be off.
            ways.try_fold(0.0_f64, |most, way| Some(most.max(way?)))
        }
    }

    /// Moves motors by a way, all switches following.
    fn shift(&mut self, which: Which, by: f64) {
        let (side, hysteresis, range) = (self.side, self.hysteresis, self.moved(which));
        for it in &mut self.motors[range] {
            it.place += by;
            if let Some(at) = it.switch_at {
                let beyond = side * (it.place - at);
                it.on = beyond >= 0.0 || (it.on && beyond > -hysteresis);
            }
        }
    }

    fn leg(&mut self, which: Which, by: f64, peak: f64, seconds: f64, edge: Option<f64>) {
        let first = self.moved(which).start;
        let (from, from_s) = (self.place(first), self.clock_s);
        self.shift(which, by);
        self.clock_s += seconds;
        let (axis, to) = (self.axis, self.place(first));
        self.legs.push(Leg { axis, which, span_s: [from_s, self.clock_s], from, to, peak, edge });
    }

    fn zero_of(&self, which: Which) -> f64 {
        self.motors.get(self.moved(which).start).map_or(0.0, |it| it.zero)
    }
}

/// A motion from rest that gains speed over a way, up to a highest, then slows to rest: how fast it
/// gets, how far it goes in all, and how long it takes.
fn run_up(way: f64, speed: f64, accel: f64) -> (f64, f64, f64) {
    let peak = speed.min((2.0 * accel * way).sqrt());
    let ramp = peak * peak / (2.0 * accel);
    let cruise_s = if peak > 0.0 { (way - ramp) / peak } else { 0.0 };
    (peak, way + ramp, 2.0 * peak / accel + cruise_s)
}

impl Axle for Shaft {
    fn switch(&self, which: Which) -> bool {
        self.motors[self.moved(which)].iter().any(|it| it.on)
    }

    fn seek(&mut self, which: Which, speed: f64, until: bool, most: f64) -> Sought {
        let (direction, zero) = (speed.signum(), self.zero_of(which));
        let first = self.moved(which).start;
        let way = if self.switch(which) == until {
            Some(0.0)
        } else {
            self.way_until(which, direction, until)
        };
        let edge = way.filter(|way| *way <= most).map(|way| self.place(first) + direction * way);
        // A search in vain ends where it has to.
        let (peak, length, seconds) = match (edge, way) {
            (Some(_), Some(way)) => run_up(way, speed.abs(), self.accel),
            _ => trapezoid(most, speed.abs(), self.accel),
        };
        self.leg(which, direction * length, peak, seconds, edge);
        Sought { edge: edge.map(|edge| edge - zero), stopped: self.place(first) - zero }
    }

    fn go(&mut self, which: Which, to: f64, speed: f64) {
        let by = to + self.zero_of(which) - self.place(self.moved(which).start);
        let (peak, _, seconds) = trapezoid(by.abs(), speed.abs(), self.accel);
        self.leg(which, by, peak, seconds, None);
    }

    fn zero(&mut self, which: Which) {
        let range = self.moved(which);
        self.motors[range].iter_mut().for_each(|it| it.zero = it.place);
    }
}

/// A motion from rest to rest over a way: how fast it gets, how far it goes, how long it takes.
fn trapezoid(way: f64, speed: f64, accel: f64) -> (f64, f64, f64) {
    let peak = speed.min((accel * way).sqrt());
    let seconds = if peak > 0.0 { peak / accel + way / peak } else { 0.0 };
    (peak, way, seconds)
}
