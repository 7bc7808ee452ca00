//! Settings that a controller keeps by number (`$120`), written and read back.

use super::Connection;
use super::connection::NAP;

/// A controller writes a setting and tells all of them within this, seconds.
const WRITTEN_S: f64 = 4.0;

/// Controllers keep three decimals: what was read back is the same within this, and this share.
const SAME: f64 = 0.000_6;
const SAME_SHARE: f64 = 1e-4;

/// Has the controller keep another value of a setting; returns what it told then.
///
/// # Errors
/// It keeps no such setting, is at work, refuses the value, was stopped meanwhile, or keeps another value.
pub fn change_setting(
    connection: &mut Connection,
    number: u16,
    value: &str,
    mut is_stopped: impl FnMut() -> bool,
) -> Result<String, String> {
    let refused = |name: &str, why: String| format!("{name}: {why}");
    if connection.open > 0 || connection.failure.is_some() {
        return Err(refused(&connection.name, "it is at work, or takes no orders".into()));
    }
    let keeps = connection.link.driver().keeps_setting(number, value);
    keeps.map_err(|why| refused(&connection.name, why))?;
    let until_s = connection.now_s() + WRITTEN_S;
    while !connection.link.driver().knows_zeros() && connection.failure.is_none() {
        if connection.now_s() > until_s || is_stopped() {
            let why = format!("it has not said that ${number} is written");
            return Err(refused(&connection.name, why));
        }
        connection.tend(NAP);
    }
    if let Some(fault) = &connection.failure {
        return Err(fault.message.clone());
    }
    if let Some(why) = connection.link.driver().takes_refusal() {
        return Err(refused(&connection.name, why));
    }
    connection.hears_facts();
    let kept = connection.link.driver().setting(number).unwrap_or_default().trim().to_owned();
    if !same(&kept, value) {
        let why = format!("it keeps ${number}={kept}, and not the {value} that was written");
        return Err(refused(&connection.name, why));
    }
    Ok(kept)
}

/// Returns `true` if a value that was read back is the one that was written.
fn same(kept: &str, value: &str) -> bool {
    let number = |text: &str| text.split_whitespace().next()?.parse::<f64>().ok();
    match (number(kept), number(value)) {
        (Some(kept), Some(value)) => (kept - value).abs() < SAME.max(value.abs() * SAME_SHARE),
        _ => kept == value.trim(),
    }
}
