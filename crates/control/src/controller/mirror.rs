//! Outputs of the machine on the controller.

use super::Shared;
use super::lacks::{needs, wired};
use crate::{Event, Sink};
use kerf_program::{OutputReason, Turn};

/// The line of flood coolant.
const FLOOD: u8 = 2;

/// The line of mist coolant.
const MIST: u8 = 3;

/// Has the controller switch what the machine switches.
pub struct Mirror(pub Shared);

impl Sink for Mirror {
    fn event(&mut self, event: &Event) {
        let mut connection = self.0.borrow_mut();
        match event {
            Event::Output { n, on, why, .. } if *why != OutputReason::Trigger => {
                let lacks = needs(connection.facts(), *n, *why);
                match wired(*n) {
                    Some(_) if lacks && *on => connection.lacks(&format!("output {n}")),
                    Some(line) if !lacks => connection.want(line, *on),
                    _ => {}
                }
            }
            Event::Spindle { rpm, .. } => connection.spin(*rpm),
            Event::Coolant { mist, flood, .. } => {
                connection.want(FLOOD, *flood);
                connection.want(MIST, *mist);
            }
            other => {
                if let Some(what) = lacked(other) {
                    connection.lacks(what);
                }
            }
        }
    }

    fn looks_at_motion(&self) -> bool {
        false
    }
}

/// What an event needs that no controller has that is driven move by move.
pub(super) fn lacked(event: &Event) -> Option<&'static str> {
    match event {
        Event::Output { on: true, why: OutputReason::Trigger, .. } => {
            Some("output that switches within a move (VC)")
        }
        Event::Pwm { percent, .. } if *percent > 0.0 => Some("PWM output"),
        Event::Intensity { byte, .. } if *byte > 0 => Some("intensity output"),
        Event::Turn { turn: Turn::Counterclockwise, .. } => {
            Some("spindle that turns the other way")
        }
        Event::Turn { turn: Turn::Dynamic, .. } => Some("laser whose power follows the speed"),
        _ => None,
    }
}
