//! Inputs that can serve one purpose only, and what tools can do.

use super::Contradiction;
use crate::Configuration;
use crate::settings::axes::W;
use crate::settings::intensity::LEVELS;
use crate::settings::laser::LaserType;
use kerf_program::Axis;

type Found = Vec<Contradiction>;

/// The card has home switches of X, Y, Z and W: a search for another one would go on until the axis is at its end.
pub(super) fn home_input(c: &Configuration, found: &mut Found) {
    if c.homing.of(Axis::B).fitted {
        found.push(Contradiction::new(
            &["homing.b.fitted"],
            "homing.b.fitted is true, but no input is a home switch of B",
            "There are inputs for X, Y, Z and W: set it to false, and set the zero of B by hand.",
        ));
    }
}

/// A tool that is measured goes to the sensor first.
pub(super) fn sensor(c: &Configuration, found: &mut Found) {
    let changes = &c.program.tool_changes;
    let places = [changes.sensor_x_mm, changes.sensor_y_mm];
    if changes.sensor_input.is_some() && places.contains(&None) {
        found.push(Contradiction::new(
            &["tool_change.sensor_input", "tool_change.sensor_x", "tool_change.sensor_y"],
            "tool_change.sensor_input names a sensor, but tool_change.sensor_x or tool_change.sensor_y is none",
            "Give the place of the sensor first.",
        ));
    }
}

/// A tool is measured at one thing.
pub(super) fn plate(c: &Configuration, found: &mut Found) {
    let changes = &c.program.tool_changes;
    if changes.sensor_input.is_some() && changes.plate_input.is_some() {
        found.push(Contradiction::new(
            &["tool_change.plate_input", "tool_change.sensor_input"],
            "tool_change.plate_input names a loose plate, and tool_change.sensor_input a sensor",
            "Tools are measured at one of them: set the other to none.",
        ));
    }
}

/// Bit 1 of input port A is the W home switch, Too-Close of a plasma, or the external start.
pub(super) fn shared_input(c: &Configuration, found: &mut Found) {
    let homes_w = c.homing.of(W).fitted;
    let homes_w_alone = c.homing.at_program_start.contains(W) || c.homing.at_job_start.contains(W);
    let uses = [
        ("homing.w.fitted", homes_w, "the W home switch"),
        ("homing.at_job_start", homes_w_alone && !homes_w, "homing W"),
        ("plasma.use", c.plasma.use_sequence, "Too-Close of the plasma start"),
        ("job.external_start", c.job.external_start, "the external start"),
    ];
    let used: Vec<_> = uses.into_iter().filter(|(_, used, _)| *used).collect();
    let [(first_key, _, first), rest @ ..] = used.as_slice() else { return };
    for (key, _, what) in rest {
        let message = format!("input A1 (WHOME) is {first} ({first_key}) and {what} ({key})");
        let hint = "The input serves one purpose: turn the others off.";
        found.push(Contradiction::new(&[key, first_key], message, hint));
    }
}

/// With the external start there is one jig ("Machining the Job").
pub(super) fn jigs(c: &Configuration, found: &mut Found) {
    if c.job.external_start && c.job.two_jigs {
        found.push(Contradiction::new(
            &["job.two_jigs", "job.external_start"],
            "job.external_start and job.two_jigs cannot both be used",
            "Jigs have start inputs of their own.",
        ));
    }
}

/// A torch is started one way, a laser another.
pub(super) fn start_sequences(c: &Configuration, found: &mut Found) {
    if c.plasma.use_sequence && c.laser.pierce.use_sequence {
        found.push(Contradiction::new(
            &["laser.pierce.use", "plasma.use"],
            "plasma.use and laser.pierce.use are both true",
            "A shape begins with one of the two sequences.",
        ));
    }
}

/// A laser has a kind, and a pulsed one a pulse that fits ("Intensity Output Example").
pub(super) fn laser(c: &Configuration, found: &mut Found) {
    if !c.laser.use_laser {
        return;
    }
    match c.laser.kind {
        None => found.push(Contradiction::new(
            &["laser.use", "laser.type"],
            "laser.use is true, but laser.type is none",
            "Tell the kind of laser: cw or pwm.",
        )),
        Some(LaserType::Pulsed) => {
            pulse(c, "laser.cut_hz", c.laser.cut_hz, found);
            if c.laser.pierce.use_sequence {
                pulse(c, "laser.pierce.hz", c.laser.pierce.hz, found);
            }
        }
        Some(LaserType::Continuous) => {}
    }
}

/// Some intensity must give a pulse within its limits.
fn pulse(c: &Configuration, key: &'static str, hz: f64, found: &mut Found) {
    let period_us = 1e6 / hz;
    let (min, max) = (c.laser.min_pulse_us, c.laser.max_pulse_us);
    let level = |us: f64| (us / period_us * (LEVELS - 1) as f64).trunc();
    if level(min) > level(max) || level(min) > (LEVELS - 1) as f64 || min > max {
        let message = format!(
            "no valid laser pulse width: at {hz} Hz ({key}) the period is {period_us} µs, the pulse \
             {min} µs at least (laser.min_pulse_us) and {max} µs at most (laser.max_pulse_us)"
        );
        let hint = "Lower the frequency, or let pulses be shorter.";
        let keys = [key, "laser.min_pulse_us", "laser.max_pulse_us"];
        found.push(Contradiction::new(&keys, message, hint));
    }
}
