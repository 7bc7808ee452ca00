//! The bits of the card, as its lamps show them.

use kerf_machine::Configuration;
use kerf_machine::lines::{Input, Output};
use kerf_machine::settings::motors::{Direction, Motor};
use kerf_machine::wiring::{Bit, INPUT_BITS, OUTPUT_BITS, Port};
use kerf_model::Model;
use kerf_model::ports::motor_bits;
use kerf_program::{Axes, Axis};
use kerf_wire::{Io, PortBit, Ports};

const fn index(port: Port) -> usize {
    match port {
        Port::A => 0,
        Port::B => 1,
        Port::C => 2,
    }
}

const fn put(byte: &mut u8, bit: &Bit, on: bool) {
    *byte = if on { *byte | bit.mask() } else { *byte & !bit.mask() };
}

/// The ports of a machine that stands, with what its inputs read. Directions stay as they were before.
pub fn ports(machine: &Model, reads: impl Fn(u8) -> bool, before: &Ports) -> Ports {
    let mut ports = Ports::default();
    for bit in INPUT_BITS {
        let on = Input::of_name(bit.name).is_some_and(|line| reads(line.number()));
        put(&mut ports.inputs[index(bit.port)], bit, on);
    }
    for bit in OUTPUT_BITS {
        let outputs = machine.outputs();
        let on = Output::of_name(bit.name).is_some_and(|line| outputs.is_on(line.number()));
        put(&mut ports.outputs[index(bit.port)], bit, on);
    }
    for (direction, _) in Motor::ALL.into_iter().filter_map(motor_bits) {
        let at = index(direction.port);
        put(&mut ports.outputs[at], direction, before.outputs[at] & direction.mask() != 0);
    }
    ports
}

/// An input reads something else.
pub fn reads(ports: &mut Ports, number: u8, on: bool) {
    let is_it = |bit: &&Bit| Input::of_name(bit.name).is_some_and(|line| line.number() == number);
    if let Some(bit) = INPUT_BITS.iter().find(is_it) {
        put(&mut ports.inputs[index(bit.port)], bit, on);
    }
}

/// The state that pages are told of an input; nothing of one that is none.
pub fn input_state(io: &Io, number: u8) -> Option<bool> {
    let lamp = io.inputs.iter().find(|lamp| lamp.number == number).map(|lamp| lamp.on);
    let is_it = |bit: &&Bit| Input::of_name(bit.name).is_some_and(|line| line.number() == number);
    let bit = || INPUT_BITS.iter().find(is_it);
    lamp.or_else(|| bit().map(|bit| io.ports.inputs[index(bit.port)] & bit.mask() != 0))
}

/// The same while the axes move: a motor that steps, and which way.
pub fn moving(ports: &mut Ports, velocity: Axes, machine: &Configuration) {
    let motors = &machine.motors;
    for motor in Motor::ALL {
        let Some(axis) = motors.axis_of(motor) else { continue };
        let (Some((direction, step)), speed) = (motor_bits(motor), velocity[axis]) else {
            continue;
        };
        let steps = speed.abs() > 0.0;
        put(&mut ports.outputs[index(step.port)], step, steps);
        if steps {
            let forwards = motors.direction[axis.index()] == Direction::Forwards;
            put(&mut ports.outputs[index(direction.port)], direction, (speed > 0.0) == forwards);
        }
    }
}

/// No motor steps any more.
pub fn stand(ports: &mut Ports) {
    for (_, step) in Motor::ALL.into_iter().filter_map(motor_bits) {
        put(&mut ports.outputs[index(step.port)], step, false);
    }
}

/// Every bit of the card with its name on this machine.
pub fn bits(machine: &Configuration) -> Vec<PortBit> {
    let named = |bit: &Bit, output: bool| {
        let input = Input::of_name(bit.name).filter(|_| !output);
        let name = input.and_then(|input| machine.name_in_use(input)).unwrap_or(bit.name);
        let (name, about) = (name.into(), bit.about.into());
        PortBit { output, port: bit.port.letter(), place: bit.place, name, about }
    };
    let outputs = OUTPUT_BITS.iter().map(|bit| named(bit, true));
    outputs.chain(INPUT_BITS.iter().map(|bit| named(bit, false))).collect()
}

/// Returns the speed up to which positions are told: live drawing is a setting in tenths of the machine's highest
/// speed, 10 for always and 0 for never (Profiler reference, "Miscellaneous Configuration Options").
pub fn live_mm_s(machine: &Configuration) -> Option<f64> {
    match machine.misc.runtime_drawing {
        0 => None,
        10.. => Some(f64::INFINITY),
        tenths => {
            let speeds = machine.program.axis_dynamics().speed_mm_s;
            let most = [Axis::X, Axis::Y, Axis::Z].map(|axis| speeds[axis]);
            // Speeds are sums of small steps.
            Some(most.into_iter().fold(0.0, f64::max) * f64::from(tenths) / 10.0 + 1e-6)
        }
    }
}
