//! The working zero, as it follows the zero point of the controller that holds.

use kerf_machine::driver::{Zero, ZeroChange};
use kerf_program::{AXES, Axes, rounded};
use kerf_wire::AxisUnits;

/// Axes whose working zero follows: the shape of VA.
const FOLLOW: usize = 3;

/// Returns what the axes read by the zero point that holds, as far as the change is about them; nothing where none holds.
pub fn reads(position: Axes, zeros: &[Zero], change: ZeroChange) -> Option<[Option<f64>; AXES]> {
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

/// The command by which axes read so many mm, in the unit of each.
pub fn values(reads: [Option<f64>; AXES], units: &[AxisUnits]) -> String {
    let words = reads.iter().zip(units).take(FOLLOW).map(|(reads, axis)| {
        reads.map_or(String::new(), |mm| rounded(mm / axis.scale, 9).to_string())
    });
    format!("VA,{}", words.collect::<Vec<_>>().join(","))
}
