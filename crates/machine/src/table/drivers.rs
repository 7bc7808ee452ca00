//! Motor drivers with registers.

use super::Bounds::{Any, Range};
use super::setting::{Area, Setting, row};

pub(super) const AREAS: &[Area] = &[Area {
    title: "Motor drivers with registers",
    manual: "none: Kerf's own, docs/how-boards-with-step-queues-are-driven.md",
    rows: DRIVERS,
}];

const DRIVERS: &[Setting] = &[
    row!(
        c,
        "drivers.x",
        c.drivers.kinds[0],
        None,
        Any,
        "Driver of motor X with its pins: \"tmc2209 gpio9 gpio8 2\" or \"tmc5160 PC4\"; empty where it is set by hand."
    ),
    row!(
        c,
        "drivers.y",
        c.drivers.kinds[1],
        None,
        Any,
        "Driver of motor Y with its pins: \"tmc2209 gpio9 gpio8 2\" or \"tmc5160 PC4\"; empty where it is set by hand."
    ),
    row!(
        c,
        "drivers.z",
        c.drivers.kinds[2],
        None,
        Any,
        "Driver of motor Z with its pins: \"tmc2209 gpio9 gpio8 2\" or \"tmc5160 PC4\"; empty where it is set by hand."
    ),
    row!(
        c,
        "drivers.w",
        c.drivers.kinds[3],
        None,
        Any,
        "Driver of motor W with its pins: \"tmc2209 gpio9 gpio8 2\" or \"tmc5160 PC4\"; empty where it is set by hand."
    ),
    row!(
        c,
        "drivers.q",
        c.drivers.kinds[4],
        None,
        Any,
        "Driver of motor Q with its pins: \"tmc2209 gpio9 gpio8 2\" or \"tmc5160 PC4\"; empty where it is set by hand."
    ),
    row!(
        c,
        "drivers.r",
        c.drivers.kinds[5],
        None,
        Any,
        "Driver of motor R with its pins: \"tmc2209 gpio9 gpio8 2\" or \"tmc5160 PC4\"; empty where it is set by hand."
    ),
    row!(
        c,
        "drivers.spi",
        c.drivers.spi,
        None,
        Any,
        "MISO, MOSI and SCK of motor drivers with chip selects: \"PA6 PA7 PA5\"."
    ),
    row!(
        c,
        "drivers.current_a",
        c.drivers.current_a,
        None,
        Range(0.0, 20.0),
        "Current of motors X, Y, Z, W, Q, R while they turn, amperes, root mean square."
    ),
    row!(
        c,
        "drivers.hold",
        c.drivers.hold,
        None,
        Range(0.0, 1.0),
        "Share of that current while a motor stands."
    ),
    row!(
        c,
        "drivers.ohms",
        c.drivers.ohms,
        None,
        Range(0.0, 1.0),
        "Sense resistors of the drivers, ohms; 0 for the usual ones: 0.11, and 0.075 of a TMC5160."
    ),
    row!(
        c,
        "drivers.microsteps",
        c.drivers.microsteps,
        None,
        Range(1.0, 256.0),
        "Microsteps of a full step: 1, 2, 4 and so on up to 256."
    ),
    row!(
        c,
        "drivers.interpolates",
        c.drivers.interpolates,
        None,
        Any,
        "The drivers make 256 microsteps of each full step by themselves."
    ),
    row!(
        c,
        "drivers.quiet",
        c.drivers.quiet,
        None,
        Any,
        "StealthChop: less noise, and less torque at speed."
    ),
    row!(
        c,
        "drivers.stall",
        c.drivers.stall,
        None,
        Range(-64.0, 255.0),
        "Thresholds at which the drivers tell a stall at their DIAG pins; 0 where they tell none."
    ),
];
