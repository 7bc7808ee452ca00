//! Finding home: each axis goes to its switch and counts from there (Profiler reference, "Finding the
//! Home Position on an Axis"; readings, P-86 to P-88).
//!
//! ```text
//!            1 ──────────────────►│   fast, until the switch turns on
//!                           2 ◄───│   fast, until it turns off
//!                             3 ─►│   slow, until it turns on: recorded
//!         4, 5 ◄── distance off ──│   home, at the highest speed of the axis
//! ```
//!
//! Two motors of one axis are homed together; then, if the machine is set so, each alone, so that
//! each stands the same way off its own switch. The procedure is the same for every machine: it asks
//! an [`Axle`] to move and to tell where its switch changed.

use crate::Configuration;
use crate::settings::axes::Z2;
use crate::settings::homing::{HomeEnd, HomeSwitch};
use crate::settings::motors::Motor;
use kerf_program::{Axis, AxisSet};

/// Which motors of an axis move, and whose switches are looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Which {
    /// All of them; their switches are in parallel.
    All,
    /// One alone, counted from 0.
    One(usize),
}

/// Result of a search, mm or degrees from zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sought {
    /// Place where the switch changed; nothing when it did not within the way allowed.
    pub edge: Option<f64>,
    /// Place where the motion ended.
    pub stopped: f64,
}

/// One axis of a machine that can be homed.
pub trait Axle {
    /// Returns `true` if a switch of these motors is on.
    fn switch(&self, which: Which) -> bool;

    /// Moves at a speed, negative backwards, until the switch of these motors reads `until`, then
    /// slows to a stop; slows to a stop as well when `most` has been gone.
    fn seek(&mut self, which: Which, speed: f64, until: bool, most: f64) -> Sought;

    /// Moves to a place at a speed.
    fn go(&mut self, which: Which, to: f64, speed: f64);

    /// The place where these motors stand is zero from now on.
    fn zero(&mut self, which: Which);
}

/// A machine that can be homed.
pub trait Rig {
    /// One of its axes.
    fn axle(&mut self, axis: Axis) -> &mut dyn Axle;
}

/// An axis that was homed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Homed {
    /// The axis.
    pub axis: Axis,
    /// Which of its motors.
    pub which: Which,
    /// Place of home, counted from what was zero before.
    pub home: f64,
    /// The same in whole steps: how far the last home was off, where there was one.
    pub difference_steps: i64,
}

/// A switch that did not come.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{axis} home not found{}", self.which())]
pub struct NotFound {
    /// The axis, as people call it.
    pub axis: &'static str,
    /// The motor that moved alone, where it did.
    pub motor: Option<Motor>,
    /// The switch did not turn off.
    pub stays_on: bool,
}

impl NotFound {
    /// Behind the name of the axis: what of it failed.
    fn which(&self) -> String {
        let motor =
            self.motor.map(|motor| format!(" with motor {} alone", motor.word().to_uppercase()));
        let stays_on = if self.stays_on { ": its switch stays on" } else { "" };
        motor.unwrap_or_default() + stays_on
    }
}

/// The order in which axes are homed: the tool first leaves the work.
const ORDER: [Axis; 6] = [Axis::Z, Axis::A, Axis::X, Axis::Y, Axis::B, Axis::C];

/// Greatest way of a search, as a multiple of the axis' length.
const MARGIN: f64 = 1.1;

/// Homes axes of a machine, and tells what was found one after the other. Axes without a switch keep the zero
/// they have.
///
/// # Errors
/// [`NotFound`] with the first axis whose switch did not come; it is not homed, nor are those that
/// would have followed. Those before it are.
pub fn home(
    machine: &Configuration,
    rig: &mut dyn Rig,
    axes: AxisSet,
    homed: &mut Vec<Homed>,
) -> Result<(), NotFound> {
    for axis in ORDER {
        if axes.contains(axis) && machine.homing.of(axis).fitted {
            home_axis(machine, rig.axle(axis), axis, homed)?;
        }
    }
    Ok(())
}

fn home_axis(
    machine: &Configuration,
    axle: &mut dyn Axle,
    axis: Axis,
    homed: &mut Vec<Homed>,
) -> Result<(), NotFound> {
    let search = Search::new(machine, axis);
    let motors = search.motors.len();
    let mut rounds = vec![Which::All];
    if search.separate && motors > 1 {
        rounds.extend((0..motors).map(Which::One));
    }
    for which in rounds {
        let home = search.find(axle, which)?;
        axle.go(which, home, search.top);
        axle.zero(which);
        let steps = machine.program.resolution.steps_per_unit[axis];
        homed.push(Homed { axis, which, home, difference_steps: (home * steps).round() as i64 });
    }
    Ok(())
}

/// Settings needed to find the home of an axis.
struct Search {
    name: &'static str,
    motors: Vec<Motor>,
    switch: HomeSwitch,
    /// The direction of the switch.
    toward: f64,
    /// Greatest way of the search.
    most: f64,
    /// The highest speed of the axis.
    top: f64,
    /// Distance by which home lies farther.
    adjustment: f64,
    separate: bool,
}

impl Search {
    fn new(machine: &Configuration, axis: Axis) -> Self {
        let switch = *machine.homing.of(axis);
        let limits = &machine.program.limits;
        let length = match machine.axes.length[axis] {
            length if length > 0.0 => length,
            _ => limits.high[axis] - limits.low[axis],
        };
        let second_head = axis == Z2 && machine.motors.z2.is_some();
        Self {
            name: machine.motors.axis_name(axis),
            motors: machine.motors.of_axis(axis),
            switch,
            toward: if switch.end == HomeEnd::High { 1.0 } else { -1.0 },
            most: length * MARGIN,
            top: machine.program.axis_dynamics().speed_mm_s[axis],
            adjustment: if second_head { machine.homing.z2_adjustment_mm } else { 0.0 },
            separate: match axis {
                Axis::X => machine.homing.separate_x,
                Axis::Y => machine.homing.separate_y,
                _ => false,
            },
        }
    }

    /// Finds home and returns its place, from zero.
    fn find(&self, axle: &mut dyn Axle, which: Which) -> Result<f64, NotFound> {
        let (fast, slow) = (self.switch.fast * self.toward, self.switch.slow * self.toward);
        if axle.switch(which) {
            self.seek(axle, which, -fast, false)?;
        }
        self.seek(axle, which, fast, true)?;
        let left = self.seek(axle, which, -fast, false)?;
        let edge = if slow == 0.0 { left } else { self.seek(axle, which, slow, true)? };
        Ok(edge - self.toward * self.switch.off + self.adjustment)
    }

    fn seek(
        &self,
        axle: &mut dyn Axle,
        which: Which,
        speed: f64,
        until: bool,
    ) -> Result<f64, NotFound> {
        let motor = match which {
            Which::All => None,
            Which::One(n) => self.motors.get(n).copied(),
        };
        let missing = NotFound { axis: self.name, motor, stays_on: !until };
        axle.seek(which, speed, until, self.most).edge.ok_or(missing)
    }
}

/// Returns the soft bounds of an axis, mm or degrees: from its length and the end at which it is homed, counted
/// from home. `None` without a length, or where movement is not limited.
pub fn soft_bounds(machine: &Configuration, axis: Axis) -> Option<(f64, f64)> {
    let length = machine.axes.length[axis];
    if !machine.axes.limit_movement || length <= 0.0 {
        return None;
    }
    Some(match machine.homing.of(axis).end {
        HomeEnd::Low => (0.0, length),
        HomeEnd::High => (-length, 0.0),
    })
}

/// Returns the bounds of an axis moved by hand, machine frame, mm or degrees: within its length, counted from where the
/// machine was switched on until it is homed, and Z no lower than Z bottom. Z bottom is known where Z was homed or has
/// a length.
pub fn bounds_by_hand(machine: &Configuration, axis: Axis, homed: bool) -> (f64, f64) {
    let length = soft_bounds(machine, axis);
    let (low, high) = length.unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
    let to_bottom = axis == Axis::Z && machine.axes.limit_movement && (homed || length.is_some());
    (if to_bottom { low.max(machine.zpos.bottom_mm) } else { low }, high)
}

/// Words about the end of an axis, behind those that say where it is: what to change where Z ends at Z bottom.
pub fn words_of_end(machine: &Configuration, axis: Axis, end: f64) -> &'static str {
    let bottom = axis == Axis::Z && machine.axes.limit_movement && end == machine.zpos.bottom_mm;
    if bottom { ", Z bottom (zpos.bottom_mm)" } else { "" }
}

/// Returns the table limits of an axis, table base coordinates. `None` while they are not checked, and for
/// an axis that the machine lacks or that turns without end.
pub fn table_bounds(machine: &Configuration, axis: Axis) -> Option<(f64, f64)> {
    let limits = &machine.program.limits;
    let there = axis.index() < usize::from(machine.program.axis_count);
    let holds = limits.check && there && !turns_endlessly(machine, axis);
    holds.then(|| (limits.low[axis], limits.high[axis]))
}

/// Returns `true` for the tangential axis where it turns without end.
pub fn turns_endlessly(machine: &Configuration, axis: Axis) -> bool {
    axis == Axis::C && machine.misc.tangential && machine.misc.tangential_endless
}
