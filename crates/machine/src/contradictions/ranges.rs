//! Places in order, ports apart.

use super::Contradiction;
use crate::Configuration;
use crate::hand::warm_steps;
use kerf_program::Axis;

type Found = Vec<Contradiction>;

/// The table has its low end below its high end.
pub(super) fn limits(c: &Configuration, found: &mut Found) {
    let limits = &c.program.limits;
    if let Some(axis) = Axis::ALL.into_iter().find(|axis| limits.low[*axis] > limits.high[*axis]) {
        found.push(Contradiction::new(
            &["limits.low", "limits.high"],
            format!("limits.low is above limits.high for axis {}", axis.letter()),
            "The low end of an axis is at most its high end.",
        ));
    }
}

/// Top ≥ surface ≥ bottom, and the bottom within reach ("Special Z Axis Positions").
pub(super) fn heights(c: &Configuration, found: &mut Found) {
    let z = &c.zpos;
    let ordered = [
        ("zpos.surface_mm", z.surface_mm, "zpos.top_mm", z.top_mm),
        ("zpos.bottom_mm", z.bottom_mm, "zpos.surface_mm", z.surface_mm),
    ];
    for (low_key, low, high_key, high) in ordered {
        if low > high {
            let message = format!("{low_key} ({low}) is above {high_key} ({high})");
            let hint = "Z top is the highest, Z bottom the lowest of the three.";
            found.push(Contradiction::new(&[low_key, high_key], message, hint));
        }
    }
    let length = c.axes.length[Axis::Z];
    if c.axes.limit_movement && length > 0.0 && z.bottom_mm < -length {
        let message =
            format!("zpos.bottom_mm ({}) is below the travel of Z ({length})", z.bottom_mm);
        let hint = "The tool goes down from home by the third value of axis.length at most.";
        found.push(Contradiction::new(&["zpos.bottom_mm", "axis.length"], message, hint));
    }
}

const OFF: [&str; 6] = [
    "homing.x.off",
    "homing.y.off",
    "homing.z.off",
    "homing.a.off",
    "homing.b.off",
    "homing.w.off",
];

/// Home lies within the travel of its axis, of axes that have a switch.
pub(super) fn homes(c: &Configuration, found: &mut Found) {
    for (axis, key) in Axis::ALL.into_iter().zip(OFF) {
        let (switch, length) = (c.homing.of(axis), c.axes.length[axis]);
        if switch.fitted && c.axes.limit_movement && length > 0.0 && switch.off > length {
            let name = axis.letter();
            let message =
                format!("{key} ({}) is more than the travel of {name} ({length})", switch.off);
            let hint = "Home lies so far from the switch, and axis.length is all the axis has.";
            found.push(Contradiction::new(&[key, "axis.length"], message, hint));
        }
    }
}

/// Hand console, file sending and height readings do not share a port ("Communication").
pub(super) fn ports(c: &Configuration, found: &mut Found) {
    let ports = [
        ("options.console_port", c.options.console_port),
        ("options.send_port", c.options.send_port),
        ("height.port", c.height.port),
    ];
    for (i, (key, port)) in ports.iter().enumerate() {
        if let Some((other, _)) = ports[..i].iter().find(|(_, earlier)| earlier == port) {
            let message = format!("{other} and {key} are the same serial port, {port}");
            let hint = "Each of the three has a port of its own.";
            found.push(Contradiction::new(&[key, other], message, hint));
        }
    }
}

/// The steps of a warm-up are such steps.
pub(super) fn warm_up(c: &Configuration, found: &mut Found) {
    if let Err(why) = warm_steps(&c.options.warm_up) {
        let hint = "The usual steps are 25:2, 50:2, 75:2, 100:2.";
        found.push(Contradiction::new(&["options.warm_up"], why, hint));
    }
}
