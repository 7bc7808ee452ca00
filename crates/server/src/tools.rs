//! The tools that are known by their numbers, and what the controller keeps of the machine, as pages change them.

use crate::app::App;
use crate::asker::Asker;
use crate::machine::Order;
use crate::refusal::problem;
use kerf_wire::{Act, Problem, ToolChange, Why};

/// Longest name of a tool, in bytes.
const LONGEST: usize = 80;

/// Does what a page asks for about tools and steps.
///
/// # Errors
/// It makes no sense, the machine has none of it, or is busy.
pub fn hears(app: &App, asker: &Asker, act: Act) -> Result<(), Problem> {
    match act {
        Act::Tool { number, change, .. } => self::change(app, asker, number, change),
        Act::ControllerSteps { axis, steps, .. } => app.hands.keep_steps(asker, axis, steps),
        Act::TouchOff { .. } => app.hands.touch_off(asker),
        _ => app.hands.tool_is_in(asker),
    }
}

/// Changes a tool.
///
/// # Errors
/// There is no such number, diameter, length or name, or the machine is busy.
fn change(app: &App, asker: &Asker, number: u32, change: ToolChange) -> Result<(), Problem> {
    if number == 0 && change != ToolChange::In {
        return Err(problem(Why::Malformed, "tools have numbers from 1"));
    }
    if let ToolChange::Is { name, diameter, length } = &change {
        if !(diameter.is_finite() && *diameter >= 0.0 && length.is_finite()) {
            let text = "a tool has a diameter of 0 or more and a length, in millimetres";
            return Err(problem(Why::Malformed, text));
        }
        if name.len() > LONGEST || name.contains(char::is_control) {
            let text = format!("the name of a tool is one line of at most {LONGEST} bytes");
            return Err(problem(Why::Malformed, text));
        }
    }
    app.orders.order_of(asker, Order::Tool { number, change })
}
