//! Facts of a board with step queues as a machine: what it has, and how long before it is made a move is told.

use super::steering::SWITCHES;
use super::wiring::Wiring;
use kerf_driver_klipper::queue::Lead;
use kerf_machine::driver::Facts;
use kerf_program::{Axis, TORCH_INPUT};

/// Time that a piece needs from one thread to the other, seconds.
pub const HANDING_S: f64 = 0.02;
/// Share of the board's lead that the run may stall for, whatever was measured.
pub const SPARE: f64 = 0.34;
/// Times the longest stall of the run that is provided for.
pub const SAFETY: f64 = 2.0;
/// Longest stall of the run that is provided for, seconds.
pub const LONGEST_S: f64 = 0.4;
/// A run tells of moves so long before they are made at most, seconds: whatever the lead and the run's own stalls are.
const TELLS_S: f64 = Lead::MOST_S * (0.5 + SPARE) + HANDING_S + SAFETY * LONGEST_S;

/// Facts of a board with such a version of its program and such a wiring.
pub fn of(version: &str, wiring: &Wiring) -> Facts {
    let bit = |number: u8| 1_u32.checked_shl(u32::from(number).wrapping_sub(1)).unwrap_or(0);
    let bits = |all: &[(u8, usize)]| all.iter().fold(0, |bits, (number, _)| bits | bit(*number));
    let outputs = bits(&wiring.outputs);
    let has_z = wiring.axes().contains(Axis::Z);
    let has_input = |number: u8| wiring.inputs.iter().any(|looked| looked.number == number);
    Facts {
        name: version.to_owned(),
        axes: wiring.motors.iter().map(|motor| motor.axis.index() + 1).max().unwrap_or(0),
        outputs: outputs | wiring.spindle.map_or(0, |_| 1),
        pwm: bits(&wiring.pwm),
        inputs: wiring.inputs.iter().fold(0, |bits, looked| bits | bit(looked.number)),
        homes: !wiring.homes.is_empty(),
        spindle_rpm: wiring.spindle.map_or(0.0, |(_, most)| most),
        follows_speed: wiring.spindle.is_some(),
        follows_voltage: has_z && wiring.height.is_some(),
        follows_switches: has_z && SWITCHES.into_iter().all(|input| has_input(input.number())),
        follows_torch: has_z && has_input(TORCH_INPUT),
        feed_waits: true,
        leads_s: TELLS_S,
        ..Facts::default()
    }
}
