//! The working zero, as it follows the zero point of the controller that holds.

use kerf_program::{AXES, rounded};
use kerf_wire::AxisUnits;

/// Axes whose working zero follows: the shape of VA.
const FOLLOW: usize = 3;

/// The command by which axes read so many mm, in the unit of each.
pub fn values(reads: [Option<f64>; AXES], units: &[AxisUnits]) -> String {
    let words = reads.iter().zip(units).take(FOLLOW).map(|(reads, axis)| {
        reads.map_or(String::new(), |mm| rounded(mm / axis.scale, 9).to_string())
    });
    format!("VA,{}", words.collect::<Vec<_>>().join(","))
}
