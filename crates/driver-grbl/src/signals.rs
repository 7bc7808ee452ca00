//! Signals to the controller: what is done at once, beside the row of orders.

use crate::at_once;
use crate::driver::{Grbl, Phase};
use crate::report::Doing;
use crate::tool_wait::{JOG_CANCEL, TOOL, ToolWait};
use kerf_machine::driver::{Driver, Hold, Override, Signal};

/// Has the controller carry out a signal.
pub fn take(grbl: &mut Grbl, signal: Signal, now_s: f64) {
    match signal {
        Signal::Ask => grbl.out.push(at_once::ASK),
        Signal::Hold => {
            grbl.hold = Hold::Ordered;
            grbl.out.push(at_once::HOLD);
        }
        Signal::Resume => {
            grbl.hold = Hold::None;
            grbl.out.push(at_once::RESUME);
        }
        Signal::Stop => stop(grbl, now_s),
        Signal::ByHand => {
            let rests = grbl.has_said_all() && grbl.flights.is_empty();
            if grbl.phase == Phase::Ready && rests && grbl.tool.hears() {
                grbl.out.push(TOOL);
            }
        }
        Signal::ToolIn if grbl.tool.is_on() => grbl.out.extend(grbl.tool.is_in()),
        Signal::ToolOff if grbl.tool.is_on() => {
            grbl.tool = ToolWait::default();
            grbl.reset();
        }
        Signal::ToolIn | Signal::ToolOff => {}
        Signal::Feed(percent) => {
            (grbl.shares.feed, grbl.turned_s) = (percent.clamp(10, 200), now_s);
            grbl.out.extend(at_once::feed(percent));
        }
        Signal::Override(Override::Rapid(percent)) => {
            let (share, command) = at_once::rapid(percent);
            (grbl.shares.rapid, grbl.turned_s) = (share, now_s);
            grbl.out.push(command);
        }
        Signal::Override(Override::Spindle(percent)) => {
            (grbl.shares.spindle, grbl.turned_s) = (percent.clamp(10, 200), now_s);
            grbl.out.extend(at_once::spindle(percent));
        }
    }
}

/// Slows it down; what was not sent is forgotten.
fn stop(grbl: &mut Grbl, now_s: f64) {
    grbl.queue.clear();
    grbl.stopped_s = now_s;
    match grbl.phase {
        // It hears nothing else while it goes home.
        Phase::Ready if grbl.quiet() => grbl.reset(),
        // A reset would end the change of tools.
        Phase::Ready if grbl.tool.takes_jogs() => {
            (grbl.phase, grbl.doing) = (Phase::Stopping, Doing::Slowing);
            grbl.out.extend([JOG_CANCEL, at_once::ASK]);
            return;
        }
        // What it does is asked anew: it may have stood a moment ago, or be at work for somebody who is gone.
        Phase::Ready | Phase::Silent | Phase::Asked | Phase::Gap => {
            (grbl.phase, grbl.doing) = (Phase::Stopping, Doing::Slowing);
            grbl.out.extend([at_once::HOLD, at_once::ASK]);
        }
        Phase::Stopping | Phase::Resetting | Phase::Stopped => {}
    }
    grbl.tool = ToolWait::default();
}
