//! Zero points that a controller keeps, in the machine's frame.

use super::Connection;
use super::connection::NAP;
use kerf_machine::driver::{AXES, Zero, ZeroChange};
use kerf_program::Axes;

/// A controller writes a zero point within this, seconds.
const WRITTEN_S: f64 = 2.0;

/// Returns the zero points that the controller keeps, machine frame.
pub fn zeros_of(connection: &mut Connection) -> Vec<Zero> {
    let offset = connection.offset();
    let placed = |zero: &Zero| {
        let at = if zero.is_shift() { zero.at } else { zero.at.plus(offset) };
        Zero { at, ..zero.clone() }
    };
    connection.link.driver().zeros().iter().map(placed).collect()
}

/// Has the controller change a zero point, a place being one of the machine, and waits until it has told it.
///
/// # Errors
/// It keeps none of this name, cannot change it so, is at work, refuses, or was stopped meanwhile.
pub fn change_zero(
    connection: &mut Connection,
    name: &str,
    change: ZeroChange,
    mut is_stopped: impl FnMut() -> bool,
) -> Result<(), String> {
    let change = match change {
        ZeroChange::Lies(at) => ZeroChange::Lies(counted(at, connection.offset())),
        change => change,
    };
    if connection.open > 0
        || connection.failure.is_some()
        || !connection.link.driver().keeps_zero(name, change)
    {
        return Err(format!(
            "{} does not change its zero point {name} so, or is at work",
            connection.name
        ));
    }
    let until_s = connection.now_s() + WRITTEN_S;
    while !connection.link.driver().knows_zeros() && connection.failure.is_none() {
        if connection.now_s() > until_s || is_stopped() {
            return Err(format!(
                "{} has not said that its zero point {name} is written",
                connection.name
            ));
        }
        connection.tend(NAP);
    }
    connection.failure.as_ref().map_or(Ok(()), |fault| Err(fault.message.clone()))
}

/// Returns what the axes read by the zero point that holds, as far as the change is about them; nothing where none holds.
pub fn working_reads(
    position: Axes,
    zeros: &[Zero],
    change: ZeroChange,
) -> Option<[Option<f64>; AXES]> {
    let holding = || zeros.iter().filter(|zero| zero.holds);
    holding().find(|zero| !zero.is_shift())?;
    let zero = holding().fold(Axes::default(), |sum, zero| sum.plus(zero.at));
    let reads = position.minus(zero).0.map(Some);
    Some(match change {
        ZeroChange::Reads(values) => values,
        ZeroChange::Lies(at) => std::array::from_fn(|axis| at[axis].and(reads[axis])),
        ZeroChange::Holds | ZeroChange::Gone => reads,
    })
}

/// A place of the machine as the controller counts.
fn counted(at: [Option<f64>; AXES], offset: Axes) -> [Option<f64>; AXES] {
    let mut at = at;
    for (mm, offset_mm) in at.iter_mut().zip(offset.0) {
        *mm = mm.map(|mm| mm - offset_mm);
    }
    at
}
