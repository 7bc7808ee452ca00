//! Motors and the axes they drive.

use super::Contradiction;
use crate::Configuration;
use crate::settings::axes::{W, Z2};
use crate::settings::job::Heads;
use kerf_program::Axis;
use kerf_program::settings::AxisUnit;

type Found = Vec<Contradiction>;

/// One motor drives only one axis (Profiler reference, "Motor Parameters").
pub(super) fn one_axis_each(c: &Configuration, found: &mut Found) {
    let assigned: Vec<_> =
        c.motors.further().into_iter().filter_map(|(key, motor)| Some((key, motor?))).collect();
    for (i, (key, motor)) in assigned.iter().enumerate() {
        let earlier = assigned[..i].iter().find(|(_, other)| other == motor);
        if let Some((other, _)) = earlier {
            let motor = motor.word().to_uppercase();
            let message = format!("motor {motor} drives two axes: {other} and {key}");
            found.push(Contradiction::new(&[key, other], message, "One motor drives one axis."));
        }
    }
}

/// Axis A is either a second head or an axis of its own.
pub(super) fn heads(c: &Configuration, found: &mut Found) {
    if c.motors.z2.is_some() && c.motors.a.is_some() {
        found.push(Contradiction::new(
            &["motors.a", "motors.z2"],
            "axis A has two motors: motors.a and motors.z2",
            "The second head is axis A of part files: set one of the two to none.",
        ));
    }
    if c.motors.z2.is_none() && c.job.heads == Heads::Both {
        found.push(Contradiction::new(
            &["job.heads", "motors.z2"],
            "job.heads is both, but there is no second head: motors.z2 is none",
            "Tell which motor drives the second head, or let job.heads be z.",
        ));
    }
    if c.motors.z2.is_some() && c.program.axis_unit(Z2) == AxisUnit::Degrees {
        found.push(Contradiction::new(
            &["rotary", "motors.z2"],
            "the second head (motors.z2) is axis A, which rotary measures in degrees",
            "Let rotary begin with mm or in.",
        ));
    }
}

/// Homing motors apart needs two of them.
pub(super) fn pairs(c: &Configuration, found: &mut Found) {
    let pairs = [
        ("homing.separate_x", c.homing.separate_x, "motors.x2", c.motors.x2),
        ("homing.separate_y", c.homing.separate_y, "motors.y2", c.motors.y2),
    ];
    for (key, apart, motor_key, motor) in pairs {
        if apart && motor.is_none() {
            let message = format!("{key} is true, but {motor_key} is none");
            let hint = "Only two motors can be homed apart.";
            found.push(Contradiction::new(&[key, motor_key], message, hint));
        }
    }
}

/// A tool that is turned along the path needs an axis that turns.
pub(super) fn tangential(c: &Configuration, found: &mut Found) {
    if !c.misc.tangential {
        return;
    }
    if c.motors.w.is_none() {
        found.push(Contradiction::new(
            &["misc.tangential", "motors.w"],
            "misc.tangential is true, but motors.w is none",
            "Tell which motor turns the tool: w, q or r.",
        ));
    }
    if c.program.axis_unit(W) != AxisUnit::Degrees {
        found.push(Contradiction::new(
            &["rotary", "misc.tangential"],
            "the tangential axis is C, which rotary does not measure in degrees",
            "Let rotary end with deg.",
        ));
    }
}

/// At the highest speed a step must end before the next begins ("Microstepping Drive Parameters").
pub(super) fn pulses(c: &Configuration, found: &mut Found) {
    let pulse_ns = c.step_pulse_ns();
    let speed = c.program.axis_dynamics().speed_mm_s;
    let period_ns = |axis: Axis| 1e9 / (speed[axis] * c.program.resolution.steps_per_unit[axis]);
    let fastest = Axis::ALL.into_iter().min_by(|a, b| period_ns(*a).total_cmp(&period_ns(*b)));
    let Some(axis) = fastest else { return };
    if f64::from(pulse_ns) >= period_ns(axis) {
        found.push(Contradiction::new(
            &["motors.step_delay_ns", "sim.output_delay_ns", "dynamics.speed_mm_s", "steps.per_unit"],
            format!(
                "a step pulse takes {pulse_ns} ns (motors.step_delay_ns and sim.output_delay_ns), but \
                 at its highest speed axis {} steps every {:.0} ns",
                axis.letter(),
                period_ns(axis)
            ),
            "Shorten the step delay, or lower speed or steps.",
        ));
    }
}
