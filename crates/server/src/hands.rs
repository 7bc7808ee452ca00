//! Motion by the hands of a person: jogs, nudges, lifts.

use crate::asker::Asker;
use crate::clock::Clock;
use crate::gate::Demand;
use crate::hub::Hub;
use crate::loader::Loader;
use crate::locks::lock;
use crate::machine::link::{Held, Wanted};
use crate::machine::{LastState, Link, Order, reach};
use crate::orders::Orders;
use crate::people::{Grip, GripError, Pages};
use crate::refusal::{not_open, problem};
use kerf_control::{Jog, LIFT, Nudge};
use kerf_program::{Axes, Axis};
use kerf_wire::{Problem, State, Who, Why};
use std::sync::{Arc, Mutex};

/// The questions of programs in which the tool may be lifted and moved, and goes back by itself.
const PROGRAM_ASKS: [&str; 2] = ["pause", "msgbox"];

/// Moves the machine by hand.
pub struct Hands {
    pub hub: Arc<Hub>,
    pub link: Arc<Link>,
    pub left: Arc<Mutex<LastState>>,
    pub orders: Arc<Orders>,
    pub loader: Arc<Loader>,
    pub pages: Arc<Pages>,
    pub clock: Clock,
}

impl Hands {
    /// Moves an axis by a distance, as an answer where a question lets hands move.
    ///
    /// # Errors
    /// There is no such axis or distance, or it may not begin.
    pub fn nudge(&self, asker: &Asker, axis: char, distance: f64) -> Result<(), Problem> {
        let Some(axis) = Axis::from_letter(axis).filter(|_| distance.is_finite()) else {
            return Err(problem(Why::Malformed, "an axis and a distance are needed"));
        };
        match self.question_for_hands("hold") {
            Some(question) => self.nudge_in_question(asker, question, axis, distance),
            None => self.orders.order_of(asker, Order::Nudge(axis, distance)),
        }
    }

    /// A nudge is an answer to the question after a stop, in the unit of the axis.
    fn nudge_in_question(
        &self,
        asker: &Asker,
        question: u32,
        axis: Axis,
        distance: f64,
    ) -> Result<(), Problem> {
        let units = self.hub.read(|now| now.units.axes.clone());
        let unit = units.iter().find(|unit| unit.letter == axis.letter());
        let nudge = Nudge { axis, distance: distance / unit.map_or(1.0, |unit| unit.scale) };
        let give = |wanted: &mut Wanted| wanted.give(question, nudge.to_string());
        let counts = self.orders.want_of(asker, Demand::GoOn, give)?;
        counts.then_some(()).ok_or_else(not_open)
    }

    /// Begins a jog, unless its own stop came before, or it came so late that nobody knows whether it is held.
    pub fn jog(&self, asker: &Asker, grip: Grip, order: Order) -> Result<(), Problem> {
        let who = &asker.who;
        let held = Held::pressed(who.client, self.pages.jog_begins(who.client, grip)?);
        if held.is_over(self.clock.now()) {
            let text = "the key was pressed too long ago: the link is slow; press it anew";
            return Err(problem(Why::Late, text));
        }
        if self.link.lock().jog.is_some() {
            return Err(problem(Why::State, "another jog is not over yet"));
        }
        match self.question_for_hands("keypad hold paused pause msgbox") {
            Some(question) => self.jog_in_question(asker, question, held, &order),
            None => self.orders.order_held(asker, order, held),
        }
    }

    /// Lifting is an answer to a question of the program; afterwards it is asked again.
    pub fn lift(&self, asker: &Asker, question: u32) -> Result<(), Problem> {
        let open = self.hub.read(|now| {
            let asked = now.asked.as_ref().filter(|asked| asked.number == question);
            asked.is_some_and(|asked| PROGRAM_ASKS.contains(&asked.kind.as_str()))
        });
        let counts = open
            && self
                .orders
                .want_of(asker, Demand::GoOn, |wanted| wanted.give(question, LIFT.into()))?;
        let late = || problem(Why::Late, "no program asks this any more: nothing is lifted");
        counts.then_some(()).ok_or_else(late)
    }

    /// The tool is in for which the controller waits: what runs goes on, or the controller alone.
    ///
    /// # Errors
    /// It waits for none.
    pub fn tool_is_in(&self, asker: &Asker) -> Result<(), Problem> {
        let (wants_tool, state) = self.hub.read(|now| (now.machine.wants_tool, now.machine.state));
        if !wants_tool {
            return Err(problem(Why::State, "the controller waits for no tool"));
        }
        if state == State::Idle {
            return self.orders.order_of(asker, Order::ToolIn);
        }
        self.orders.want_of(asker, Demand::GoOn, |wanted| wanted.tool_in = true)
    }

    /// Has the controller touch off the tool for which it waits.
    ///
    /// # Errors
    /// It waits for none that it touches off by itself, or a job runs, whose Z zero would not follow.
    pub fn touch_off(&self, asker: &Asker) -> Result<(), Problem> {
        if !self.hub.read(|now| now.machine.touches_off) {
            let text = "the controller touches no tool off now: it waits for none, or a job runs";
            return Err(problem(Why::State, text));
        }
        self.orders.order_of(asker, Order::TouchOff)
    }

    /// The number of the question that lets the tool be moved while it is open, where it is of one of these kinds.
    fn question_for_hands(&self, kinds: &str) -> Option<u32> {
        self.hub.read(|now| {
            let stands = matches!(now.machine.state, State::Asking | State::Stopped);
            let asked = now.asked.as_ref().filter(|_| stands)?;
            kinds.split(' ').any(|kind| asked.kind == kind).then_some(asked.number)
        })
    }

    /// A jog is an answer to the question; afterwards it is asked again.
    fn jog_in_question(
        &self,
        asker: &Asker,
        question: u32,
        held: Held,
        order: &Order,
    ) -> Result<(), Problem> {
        let Order::Jog { direction, distance, speed } = order else {
            return Err(problem(Why::State, "the machine is busy"));
        };
        let base = Axes(self.hub.read(|now| now.motion.at.base));
        let far = reach(&lock(&self.left).session.memory.settings, base, *direction, *distance);
        let jog = Jog { by: Axes(direction.map(|way| way * far)), speed: *speed };
        let counts = self.orders.want_of(asker, Demand::GoOn, |wanted| {
            let counts = wanted.jog.is_none() && wanted.give(question, jog.to_string());
            if counts {
                wanted.jog = Some(held);
            }
            counts
        })?;
        counts.then_some(()).ok_or_else(not_open)
    }

    /// A sign of the hand of a page, stamped with the clock of the server, ms.
    pub fn grip(&self, who: &Who, seq: u64, clock_ms: f64) -> Result<Grip, Problem> {
        Ok(self.pages.grip(who.client, seq, clock_ms, self.clock.now())?)
    }

    /// A jog goes on that a page holds, which stamps its sign with the clock of the server, ms.
    ///
    /// # Errors
    /// The jog is over, or the sign is too old.
    pub fn renew_at(&self, who: &Who, (seq, ms): (u64, f64)) -> Result<(), Problem> {
        self.renew(who, self.grip(who, seq, ms)?)
    }

    /// A jog goes on that somebody holds.
    ///
    /// # Errors
    /// It is over.
    pub fn renew(&self, who: &Who, grip: Grip) -> Result<(), Problem> {
        self.pages.jog_holds(who.client, grip);
        let now = self.clock.now();
        let renews = |held: &mut Held| held.renew(who.client, grip, now);
        let renewed = self.link.want(|wanted| wanted.jog.as_mut().is_some_and(renews));
        if renewed { Ok(()) } else { Err(problem(Why::Late, "this jog is over")) }
    }

    /// Lets go of a key of a page; of whatever is held where no jog is named.
    pub fn release(&self, client: u32, seq: Option<u64>) {
        let Some(seq) = seq else { return self.link.release(|_| true) };
        self.pages.jog_over(client, seq);
        self.link.release(|held| held.client == client && held.seq == seq);
    }
}

impl From<GripError> for Problem {
    fn from(error: GripError) -> Self {
        let why = if error == GripError::Far { Why::Malformed } else { Why::Late };
        problem(why, error.to_string())
    }
}

/// Returns `true` if a jog goes somewhere and its numbers are within bounds.
pub fn makes_sense(order: &Order) -> bool {
    let Order::Jog { direction, distance, speed } = order else { return false };
    let goes = direction.iter().any(|way| *way != 0.0);
    let bounded = direction.iter().all(|share| share.abs() <= 1.0);
    goes && bounded
        && *speed > 0.0
        && *speed <= 1.0
        && distance.is_none_or(|mm| mm > 0.0 && mm.is_finite())
}
