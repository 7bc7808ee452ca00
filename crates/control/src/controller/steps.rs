//! Steps of a millimetre that a controller keeps (`$100` to `$102`), read and written.

use super::Connection;
use super::connection::NAP;

/// A controller writes a setting and tells all of them within this, seconds.
const WRITTEN_S: f64 = 4.0;

/// Share by which the number that was read back may differ: a controller keeps three decimals.
const SAME: f64 = 1e-4;

/// Has the controller keep another number of steps a millimetre of an axis, X being 0, and reads it back.
///
/// # Errors
/// It keeps none, is at work, refuses, was stopped meanwhile, or keeps another number.
pub fn change_steps(
    connection: &mut Connection,
    axis: usize,
    steps: f64,
    mut is_stopped: impl FnMut() -> bool,
) -> Result<f64, String> {
    let rests = connection.open == 0 && connection.failure.is_none();
    if !rests || !connection.link.driver().keeps_steps(axis, steps) {
        return Err(format!("{} keeps no steps of this axis, or is at work", connection.name));
    }
    let until_s = connection.now_s() + WRITTEN_S;
    while !connection.link.driver().knows_zeros() && connection.failure.is_none() {
        if connection.now_s() > until_s || is_stopped() {
            return Err(format!("{} has not said that its steps are written", connection.name));
        }
        connection.tend(NAP);
    }
    if let Some(fault) = &connection.failure {
        return Err(fault.message.clone());
    }
    let kept = connection.link.driver().steps_per_mm().get(axis).copied().unwrap_or_default();
    if (kept - steps).abs() > steps.abs() * SAME {
        return Err(format!(
            "{} keeps {kept} steps a millimetre, and not the {steps} that were written",
            connection.name
        ));
    }
    Ok(kept)
}
