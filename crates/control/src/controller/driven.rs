//! A controller as a machine that a run drives: moves of the plan as orders, outputs in their place between them.

use super::Connection;
use super::chords::{arc, chords, speed_mm_s};
use super::connection::NAP;
use super::lacks::{lacked, needs, out_of_reach, wired};
use super::merged::together;
use super::row::{Chord, Handed, Row};
use kerf_machine::driver::{Facts, Hold, Order, Override, Shares, Signal};
use kerf_machine::{Actuator, Fault, Going, Machine, News, Watch};
use kerf_motion::{Move, Path};
use kerf_program::{Axes, Axis, MoveKind, OutputReason};
use std::time::{Duration, Instant};

/// The last moves of a piece of plan that does not end at a stand are not waited for, as long as this,
/// seconds: the next piece is planned meanwhile, and the machine does not stop between them.
pub(super) const LEAD_S: f64 = 0.5;

/// The line of flood coolant.
const FLOOD: u8 = 2;

/// The line of mist coolant.
const MIST: u8 = 3;

/// The fastest a machine goes while it looks at an input now and then, mm/s: in 0.06 s, for a look, the line both ways and
/// the next turn of the run, and on a ramp of 100 mm/s² it comes no farther than [`kerf_machine::OVERRUN_MM`].
const POLLED_MM_S: f64 = 1.5;

/// Most orders on their way to the controller that are not done.
const AHEAD: usize = 512;

/// Returns `true` if a run goes on without waiting for the machine.
fn leads(going: &Going<'_>, until_s: f64) -> bool {
    let plan = going.plan;
    let last = plan.span(plan.moves().len().saturating_sub(1));
    // A ramp ends at its own speed, which is a stand all the same.
    let goes_on = last.is_some_and(|last| last.v_exit > 1.001 * last.made.ramp_mm_s);
    // What may end at an input is made before anybody goes on.
    goes_on && going.watches.is_empty() && going.t0_s + plan.duration_s() - until_s < LEAD_S
}

impl Connection {
    /// Tells whether another move may be handed over.
    const fn has_room(&self) -> bool {
        (self.open < AHEAD || self.facts.takes_whole) && self.failure.is_none()
    }

    /// Hands the next move over, after the outputs that should be on; short ones on one line together. One that ends at a
    /// change of the probe is alone.
    fn hand(&mut self, moves: &[Move], watches: &[Watch]) {
        let Some(made) = moves.first() else { return };
        let count =
            if watches.is_empty() { together(moves, self.facts.arc_tolerance_mm) } else { 1 };
        if count > 1 && self.contact.is_none() && self.probing.is_none() {
            self.switch_outputs();
            self.stopwatch.add_moves(&moves[..count], self.now_s());
            return self.hand_together(&moves[..count]);
        }
        let probes = self.probes(made, watches);
        if self.contact.is_some() || self.probing.is_some() || probes.is_some() && self.open > 0 {
            return;
        }
        self.switch_outputs();
        let chords = chords(made, self.facts.arc_tolerance_mm);
        let mut speed_mm_s = speed_mm_s(made, &chords);
        self.stopwatch.add_moves(&moves[..1], self.now_s());
        self.looks_often = !watches.is_empty() && probes.is_none();
        if !watches.is_empty() {
            self.stopwatch.skip_stretch();
        }
        if let Some(Watch { active, .. }) = probes {
            let order = Order::Probe { to: made.to.minus(self.offset), speed_mm_s, active };
            self.probing = self.order(order);
        } else if self.looks_often {
            speed_mm_s = speed_mm_s.min(POLLED_MM_S / f64::from(self.turned.feed().max(1.0)));
        }
        let round = arc(made, self.facts.arc_tolerance_mm);
        if let Some(arc) = round.filter(|_| self.facts.arcs && watches.is_empty()) {
            return self.hand_arc(made, arc, &chords);
        }
        let mut handed = Handed { at: made.at, from: made.from, chords: Vec::new(), seen: 0.0 };
        for (share, to) in chords {
            let order = self.straight(made.kind, to, speed_mm_s);
            let Some(ticket) = self.probing.or_else(|| self.order(order)) else { return };
            handed.chords.push(Chord { ticket, share, to });
        }
        self.row.push(handed);
    }

    /// Hands moves over as one straight one.
    fn hand_together(&mut self, moves: &[Move]) {
        let [first, .., last] = moves else { return };
        let speed_mm_s = speed_mm_s(first, &[(1.0, first.to)]);
        self.looks_often = false;
        let order = self.straight(first.kind, last.to, speed_mm_s);
        let Some(ticket) = self.order(order) else { return };
        for mv in moves {
            let chords = vec![Chord { ticket, share: 1.0, to: mv.to }];
            self.row.push(Handed { at: mv.at, from: mv.from, chords, seen: 0.0 });
        }
    }

    /// Hands a move over as one arc, of which centre and swept angle are given.
    fn hand_arc(
        &mut self,
        made: &Move,
        (centre, sweep_rad): ([f64; 2], f64),
        chords: &[(f64, Axes)],
    ) {
        let [x, y, ..] = self.offset.0;
        let radius_mm = (made.from.0[0] - centre[0]).hypot(made.from.0[1] - centre[1]);
        let way_mm = (radius_mm * sweep_rad).hypot(made.to.0[2] - made.from.0[2]);
        let speed_mm_s = way_mm * made.top_mm_s() / made.length_mm;
        let (to, centre) = (made.to.minus(self.offset), [centre[0] - x, centre[1] - y]);
        let Some(ticket) = self.order(Order::Arc { to, centre, sweep_rad, speed_mm_s }) else {
            return;
        };
        let chords = chords.iter().map(|(share, to)| Chord { ticket, share: *share, to: *to });
        self.row.push(Handed { at: made.at, from: made.from, chords: chords.collect(), seen: 0.0 });
    }

    /// A straight move to a place of the machine. One that looks at an input now and then is no rapid one.
    fn straight(&self, kind: MoveKind, to: Axes, speed_mm_s: f64) -> Order {
        let to = to.minus(self.offset);
        if kind == MoveKind::Jog && !self.looks_often {
            Order::Jog { to, speed_mm_s }
        } else {
            Order::Move { to, speed_mm_s }
        }
    }

    /// The input at whose change the controller itself ends a move: its probe, where the move is straight, nothing else
    /// is watched, and the probe is not there already.
    fn probes(&self, made: &Move, watches: &[Watch]) -> Option<Watch> {
        let [watch] = watches else { return None };
        let is_there = self.active.contains(&watch.input) == watch.active;
        let straight = matches!(made.path, Path::Line) && made.from != made.to;
        (self.facts.probe == Some(watch.input) && straight && !is_there).then_some(*watch)
    }

    /// The order that probes is done: where a contact ended it, the rest of its move is not made.
    pub(super) fn probed(&mut self) {
        self.probing = None;
        let Some(contact) = self.link.driver().contact() else { return };
        let place = contact.plus(self.offset);
        let last = self.row.next().saturating_sub(1);
        self.contact = Some((last, self.row.along_last(place)));
    }

    /// An output is to be on or off from here on.
    fn want(&mut self, line: u8, on: bool) {
        if self.facts.outputs & 1 << (line - 1) != 0 {
            self.outputs.want(line, on);
        }
        self.switch_outputs();
    }

    /// The speed of the spindle from here on.
    fn spin(&mut self, rpm: f64) {
        self.rpm = Some(rpm);
        self.order(Order::Spindle { rpm });
    }

    fn switch_outputs(&mut self) {
        for (line, on) in self.outputs.take_orders() {
            if line == 1 && on {
                // A spindle without a speed does not turn.
                let rpm = self.rpm.unwrap_or(self.facts.spindle_rpm);
                self.order(Order::Spindle { rpm });
            }
            self.order(Order::Output { line, on });
        }
    }

    /// Makes the end of the piece of plan before, which is told already; not where somebody holds it at its own controls.
    fn makes_piece_before(&mut self) {
        while self.done < self.row.before && self.is_busy() && self.waits().is_none() {
            self.tend(NAP);
        }
    }

    /// The moment that is reached of a move, as far as it is known.
    fn reached_s(&mut self, going: &Going<'_>) -> f64 {
        let place = self.place();
        let share = match self.contact {
            Some((index, share)) if index == going.index => share.min(1.0 - f64::EPSILON),
            // It may be behind the contact that it has not told yet, and time does not go back.
            None if self.probing.is_some() => 0.0,
            _ => self.row.share(going.index, self.done, place),
        };
        self.row.sees(going.index, share);
        if share >= 1.0 {
            return f64::INFINITY;
        }
        going.t0_s + going.plan.time_at_share(going.index, share)
    }
}

impl Machine for Connection {
    fn name(&self) -> &str {
        &self.name
    }

    fn facts(&self) -> &Facts {
        &self.facts
    }

    fn refuses(&self, mv: &Move) -> Option<String> {
        let why = out_of_reach(&self.facts, mv.from, mv.to, self.offset)?;
        Some(format!("{} {why}", self.name))
    }

    fn reach(&self, axis: Axis) -> Option<(f64, f64)> {
        let (low, high) = self.facts.travel_mm[axis.index()]?;
        Some((low + self.offset[axis], high + self.offset[axis]))
    }

    fn in_real_time(&self) -> bool {
        true
    }

    fn home(&mut self) {
        self.order(Order::Home);
    }

    fn halt(&mut self) {
        self.stop_at_once();
    }

    fn place(&mut self) -> Option<Axes> {
        Self::place(self)
    }

    fn begin(&mut self) {
        self.closed = false;
    }

    fn begin_plan(&mut self) {
        (self.contact, self.looks_often) = (None, false);
        self.row.begin();
    }

    fn set(&mut self, actuator: &Actuator) {
        match *actuator {
            Actuator::Output { number, on, why } if why != OutputReason::Trigger => {
                let lacks = needs(&self.facts, number, why);
                match wired(&self.facts, number) {
                    Some(_) if lacks && on => self.lacks(number),
                    Some(line) if !lacks => self.want(line, on),
                    _ => {}
                }
            }
            Actuator::Spindle { rpm } => self.spin(rpm),
            Actuator::Coolant { mist, flood } => {
                self.want(FLOOD, flood);
                self.want(MIST, mist);
            }
            other => {
                if let Some(what) = lacked(&other) {
                    self.fail(format!("{} has no {what}", self.name), "", None, false);
                }
            }
        }
    }

    fn advance(&mut self, going: &Going<'_>, _: f64, until_s: f64) -> News {
        self.stood = None;
        // What is known to be made already is not waited for; an input that changed on its way is told before its end.
        let reached_s = self.reached_s(going);
        if reached_s >= until_s {
            return News { reached_s, input: self.inputs.pop_front() };
        }
        self.row.come_to(going.index);
        let moves = going.plan.moves();
        while self.has_room() && self.row.next() < moves.len().min(going.until) {
            let next = self.row.next();
            self.hand(&moves[next..moves.len().min(going.until)], going.watches);
            if self.row.next() == next {
                break;
            }
        }
        self.tend(NAP);
        let input = self.inputs.pop_front();
        let leads = input.is_none() && leads(going, until_s);
        News { reached_s: if leads { until_s } else { self.reached_s(going) }, input }
    }

    fn stand(&mut self, from_s: f64, until_s: f64) -> News {
        let before = self.stood.filter(|(told_s, _)| *told_s == from_s);
        let (_, since) = before.unwrap_or_else(|| (from_s, Instant::now()));
        if until_s > from_s {
            self.tend(NAP);
        }
        let reached_s = (from_s + since.elapsed().as_secs_f64()).min(until_s);
        self.stood = Some((reached_s, Instant::now()));
        News { reached_s, input: self.inputs.pop_front() }
    }

    fn changed_input(&mut self) -> Option<(u8, bool)> {
        self.inputs.pop_front()
    }

    fn look(&mut self) {
        self.tend(Duration::ZERO);
    }

    fn settle(&mut self) -> bool {
        if self.is_busy() {
            self.tend(NAP);
        }
        self.is_busy()
    }

    fn stop(&mut self, going: &Going<'_>) -> Option<f64> {
        if let Some((index, share)) = self.contact.take() {
            self.row = Row::default();
            return Some(going.t0_s + going.plan.time_at_share(index, share));
        }
        self.makes_piece_before();
        let (done, whole) = (self.done, self.done >= self.row.before);
        if self.failure.is_none() {
            self.stop_at_once();
        }
        let place = self.place()?;
        if !whole {
            // Somebody holds it at its own controls, before the end of what is told already.
            self.give_up();
        }
        let (index, share) = self.row.locate(done, place).unwrap_or((going.index, 0.0));
        self.row = Row::default();
        Some(going.t0_s + going.plan.time_at_share(index, share))
    }

    fn hold(&mut self, going: &Going<'_>) -> Option<f64> {
        self.makes_piece_before();
        self.comes_to_hold();
        let place = self.place().filter(|_| self.failure.is_none())?;
        let (index, share) = self.row.locate(self.done, place).unwrap_or((going.index, 0.0));
        Some(going.t0_s + going.plan.time_at_share(index, share))
    }

    fn go_on(&mut self) {
        self.signal(Signal::Resume);
    }

    fn went_on(&mut self) -> bool {
        self.link.driver().hold() == Hold::WentOn
    }

    fn feed(&mut self, share: f32) {
        if self.facts.overrides && self.turned.turn_feed(share) {
            self.signal(Signal::Feed(self.turned.feed_percent()));
        }
    }

    fn turn(&mut self, turned: Override) {
        if self.facts.overrides_more {
            self.turned.turn(turned);
            self.signal(Signal::Override(turned));
        }
    }

    fn turned_by_hand(&mut self) -> Option<Shares> {
        self.turned.take_news()
    }

    fn give_up(&mut self) {
        let why = format!("{} was stopped before it had made its last moves", self.name);
        let hint = "it was held at the controller: look why before the next file";
        self.fail(why, hint, None, false);
    }

    fn waits(&mut self) -> Option<&'static str> {
        if self.lost.is_some() {
            return Some("its line is gone: it is opened again when it is back");
        }
        self.link.driver().waits()
    }

    fn waits_for_tool(&mut self) -> bool {
        self.lost.is_none() && self.link.driver().waits_for_tool()
    }

    fn touches_off(&mut self) -> bool {
        self.lost.is_none() && self.link.driver().touch_off().is_some()
    }

    fn tool_is_in(&mut self) {
        self.signal(Signal::ToolIn);
    }

    fn gives_tool_up(&mut self) {
        self.signal(Signal::ToolOff);
        self.stop_at_once();
    }

    fn fault(&self) -> Option<&Fault> {
        self.failure.as_ref()
    }
}
