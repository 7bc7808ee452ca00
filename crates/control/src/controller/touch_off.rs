//! A tool that the controller touches off by itself, while it waits for it.

use super::Connection;
use super::connection::NAP;
use kerf_machine::driver::{Signal, TouchOff, Zero};

/// A tool comes to the plate and is lifted off it within this, seconds.
const TOUCHED_S: f64 = 300.0;

/// A report that comes so long after it has lifted the tool tells where it stands, seconds.
const SETTLED_S: f64 = 0.5;

/// The axis of the tool.
const Z: usize = 2;

/// A tool that was touched off.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TouchedOff {
    /// Z zero of the controller is higher by this, mm: the tool is longer than the one before.
    pub higher_mm: f64,
    /// No tool was touched off before: the next ones are measured against this one.
    pub is_reference: bool,
}

impl TouchedOff {
    /// Tells of it in a sentence.
    pub fn sentence(&self) -> String {
        let mm = kerf_program::decimal(self.higher_mm.abs(), 3);
        match (self.is_reference, self.higher_mm >= 0.0) {
            (true, _) => "the tool is touched off, the first one: set Z zero with it, the next ones are measured against it".into(),
            (false, true) => format!("the tool is touched off: Z zero is {mm} mm higher"),
            (false, false) => format!("the tool is touched off: Z zero is {mm} mm lower"),
        }
    }
}

/// Has the controller touch the tool off for which it waits.
///
/// # Errors
/// It touches none off, the tool has touched nothing, or it was stopped: then the change of tools is given up.
pub fn touch_off(
    connection: &mut Connection,
    mut is_stopped: impl FnMut() -> bool,
) -> Result<TouchedOff, String> {
    let refused = |name: &str, why: &str| format!("{name}: {why}");
    let before_mm = shift_mm(connection);
    connection.signal(Signal::ByHand);
    connection.signal(Signal::TouchOff);
    let until_s = connection.now_s() + TOUCHED_S;
    let is_reference = loop {
        match connection.link.driver().touch_off() {
            _ if connection.failure.is_some() => break false,
            Some(TouchOff::Going) => {}
            Some(TouchOff::Done { .. }) if !connection.link.driver().knows_zeros() => {}
            Some(TouchOff::Done { is_reference }) => break is_reference,
            Some(TouchOff::Failed(why)) => return Err(refused(&connection.name, &why)),
            Some(TouchOff::Wanted) => {
                let why = "it is at work, or was moved a moment ago: try again";
                return Err(refused(&connection.name, why));
            }
            None => {
                return Err(refused(&connection.name, "it waits for no tool that it touches off"));
            }
        }
        if is_stopped() || connection.now_s() > until_s {
            connection.stop_at_once();
            let why = "stopped while it touched the tool off: it has given the change of tools up";
            return Err(refused(&connection.name, why));
        }
        connection.tend(NAP);
    };
    let until_s = connection.now_s() + SETTLED_S;
    while connection.now_s() < until_s && connection.failure.is_none() {
        connection.tend(NAP);
    }
    match &connection.failure {
        Some(fault) => Err(fault.message.clone()),
        None => Ok(TouchedOff { higher_mm: shift_mm(connection) - before_mm, is_reference }),
    }
}

/// The shift of Z by the length of the tool, as the controller told it last, mm.
fn shift_mm(connection: &mut Connection) -> f64 {
    let zeros = connection.link.driver().zeros();
    zeros.iter().find(|zero| zero.name == Zero::TOOL).map_or(0.0, |zero| zero.at.0[Z])
}
