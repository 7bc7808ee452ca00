//! Signals to the controller: what is done at once, beside the row of orders.

use crate::at_once;
use crate::driver::{Grbl, Phase};
use crate::report::Doing;
use crate::tool_wait::{JOG_CANCEL, MODE, TOOL, TOUCH, ToolWait};
use kerf_machine::driver::{Driver, Hold, Override, Signal};

impl Grbl {
    /// Has the controller carry out a signal.
    pub(crate) fn take_signal(&mut self, signal: Signal, now_s: f64) {
        match signal {
            Signal::Ask => self.out.push(at_once::ASK),
            Signal::Hold => {
                self.hold = Hold::Ordered;
                self.out.push(at_once::HOLD);
            }
            Signal::Resume => {
                self.hold = Hold::None;
                self.out.push(at_once::RESUME);
            }
            Signal::Stop => self.stop(now_s),
            Signal::ByHand => {
                let asks = self.pending.iter().all(|line| line.ticket.is_none());
                let rests = asks && self.queue.is_empty() && self.flights.is_empty();
                if self.phase == Phase::Ready && rests && self.tool.hears() {
                    // A question that was on its way when it began to wait is answered when the tool is in.
                    self.aside.append(&mut self.pending);
                    self.out.push(TOOL);
                }
            }
            Signal::ToolIn if self.tool.is_on() => self.out.extend(self.tool.is_in()),
            Signal::TouchOff => {
                let rests = self.has_said_all() && self.flights.is_empty();
                let may =
                    self.tool.takes_jogs() && self.tool.touch_off(self.told.of(MODE)).is_some();
                if self.phase == Phase::Ready && rests && may {
                    self.tool.begins_touch();
                    self.say(TOUCH);
                }
            }
            Signal::ToolOff if self.tool.is_on() => {
                self.tool = ToolWait::default();
                self.reset();
            }
            Signal::ToolIn | Signal::ToolOff => {}
            Signal::Feed(percent) => {
                (self.shares.feed, self.turned_s) = (percent.clamp(10, 200), now_s);
                self.out.extend(at_once::feed(percent));
            }
            Signal::Override(Override::Rapid(percent)) => {
                let (share, command) = at_once::rapid(percent);
                (self.shares.rapid, self.turned_s) = (share, now_s);
                self.out.push(command);
            }
            Signal::Override(Override::Spindle(percent)) => {
                (self.shares.spindle, self.turned_s) = (percent.clamp(10, 200), now_s);
                self.out.extend(at_once::spindle(percent));
            }
        }
    }

    /// Slows it down; what was not sent is forgotten.
    fn stop(&mut self, now_s: f64) {
        let end = self.card.gives_up(now_s);
        self.out.extend(end);
        self.queue.clear();
        self.stopped_s = now_s;
        match self.phase {
            // It hears nothing else while it goes home.
            Phase::Ready if self.quiet() => self.reset(),
            // A reset would end the change of tools.
            Phase::Ready if self.tool.takes_jogs() && !self.tool.is_touching() => {
                (self.phase, self.doing) = (Phase::Stopping, Doing::Slowing);
                self.out.extend([JOG_CANCEL, at_once::ASK]);
                return;
            }
            // What it does is asked anew: it may have stood a moment ago, or be at work for somebody who is gone.
            Phase::Ready | Phase::Silent | Phase::Asked | Phase::Gap => {
                (self.phase, self.doing) = (Phase::Stopping, Doing::Slowing);
                self.out.extend([at_once::HOLD, at_once::ASK]);
            }
            Phase::Stopping | Phase::Resetting | Phase::Stopped => {}
        }
        self.tool = ToolWait::default();
    }
}
