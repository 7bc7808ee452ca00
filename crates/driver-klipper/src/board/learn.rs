//! The way from a board whose words are known to one that can be moved: its configuration, and a board at rest.

use super::channel::{Channel, Told};
use super::latch::stop_looking;
use crate::compress::Limits;
use crate::orders::Order;
use crate::queue::{Queue, Rules};
use crate::setup::{Configured, Object, Pulsed, Switched};

/// Least number of ticks between two steps of a motor that boards are asked for, whatever the setup says.
const LEAST: u32 = 3;

/// The state of learning about a board.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Learning {
    /// Clock and configuration are asked for.
    Asked,
    /// The configuration went out, and is asked for; so often an answer said that there is none.
    Configured(u32),
    /// It is this machine's configuration; the counts are asked for.
    Counts,
    /// Registers of motor drivers are written.
    Drivers,
    /// All is known.
    Ready,
}

/// Sends a configuration.
pub fn configure(channel: &mut Channel, configured: &Configured) -> Told {
    for command in configured.commands.clone() {
        channel.push(command, None)?;
    }
    Ok(channel.send(Order::Finalize, [configured.crc])?)
}

/// Stops what a former session may have left.
pub fn put_at_rest(channel: &mut Channel) -> Told {
    let switches = channel.setup.switches.len();
    let latches: Vec<u32> =
        (0..channel.setup.latches()).map(|n| channel.oid(Object::Latch(n))).collect();
    // Starting a latch takes the motors from it that a former session left there.
    latches.iter().try_for_each(|oid| channel.send(Order::TrsyncStart, [*oid, 0, 0, 0]))?;
    let all = channel.oid(Object::Latch(0));
    for motor in 0..channel.setup.motors.len() {
        channel.send(Order::StopOnTrigger, [channel.oid(Object::Motor(motor)), all])?;
    }
    latches.iter().try_for_each(|oid| channel.send(Order::TrsyncTrigger, [*oid, 0]))?;
    Ok((0..switches).try_for_each(|switch| stop_looking(channel, switch))?)
}

/// An empty queue for the motors and outputs of a board with so many places.
pub fn queue(channel: &Channel, places: usize) -> Queue {
    Queue::new(limits(channel), &rules(channel), places)
}

fn limits(channel: &Channel) -> Vec<Limits> {
    let ticks = |time_s: f64| (time_s * channel.frequency).ceil() as u32;
    let limits = channel.setup.motors.iter().map(|motor| {
        let pulse = if motor.both_edges { 0.0 } else { motor.pulse_s };
        Limits {
            error: channel.options.error_s * channel.frequency,
            least: ticks(motor.least_s.max(2.0 * pulse)).max(LEAST),
            turn: ticks(motor.turn_s + pulse).max(LEAST),
        }
    });
    limits.collect()
}

/// The board's rules for each output.
fn rules(channel: &Channel) -> Vec<Rules> {
    let watch = |watch_s: Option<f64>| channel.ticks(watch_s.unwrap_or(0.0));
    let switched = |output: &Switched| Rules {
        watch: watch(output.watch_s),
        off: u32::from(output.pin.inverted),
        at_once: channel.orders.has(Order::UpdateDigital),
    };
    let pulsed = |output: &Pulsed| Rules {
        watch: watch(output.watch_s),
        off: if output.pin.inverted { channel.pwm_max() } else { 0 },
        at_once: false,
    };
    let outputs = channel.setup.outputs.iter().map(switched);
    outputs.chain(channel.setup.pulsed.iter().map(pulsed)).collect()
}
