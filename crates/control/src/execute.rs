//! Making the stack of moves that is read: planning, following the plan, stopping on the way.

use crate::OperatorRequest;
use crate::drive::Heard;
use crate::runner::{Over, Runner};
use crate::stack::Running;
use kerf_diag::Code;
use kerf_journal::Kind;
use kerf_machine::lines::Input;
use kerf_machine::{Ahead, Going, Watch};
use kerf_motion::{Move, Path, Plan, Stop, planner};
use kerf_program::settings::IoModes;
use kerf_program::{Axes, Axis, Interpreter, StoppedBy};
use kerf_sim::{Halt, HaltCause, Lift, Watched, pin};
use kerf_trace::{
    Made,
    event::{ArcEvent, Centre, Event, MoveEvent},
};

/// Reason for which a stack did not run to its end.
#[derive(Debug)]
pub(crate) enum Halted {
    /// A watched input; its index among the watches, and the motion that was interrupted.
    Watch { index: usize, at: kerf_program::Halted },
    /// The machine was stopped, and the program says what follows.
    Taken { by: StoppedBy, at: kerf_program::Halted },
    /// The run is over.
    Over(Over),
}

/// Cause of a change of plan on the way.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Turn {
    /// An input stops motion.
    Input(Halt),
    /// The operator wants something.
    Operator(OperatorRequest),
}

/// The cause for which a machine slows down, as far as what is told meanwhile depends on it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Slows {
    /// STOP, which may be told until the machine stands.
    pub by_stop: bool,
    /// A stop input, which asks by itself when the machine stands.
    pub asks: bool,
}

impl Slows {
    const fn for_turn(turn: &Turn) -> Self {
        Self {
            by_stop: matches!(turn, Turn::Operator(OperatorRequest::Stop)),
            asks: matches!(turn, Turn::Input(Halt { cause: HaltCause::Stop(_), .. })),
        }
    }
}

impl<I: Interpreter> Runner<'_, I> {
    /// The moves that were read begin to move.
    pub(crate) fn begin(&mut self) -> Result<(), Halted> {
        self.take_up()?;
        let waiting = std::mem::take(&mut self.stack.waiting);
        let may = self.check(&waiting);
        self.stack.waiting = waiting;
        may.map_err(Halted::Over)?;
        if self.stack.waiting.is_empty() {
            return Ok(());
        }
        self.heed_limit()?;
        let t0_s = self.set_off()?;
        let waiting = std::mem::take(&mut self.stack.waiting);
        let planner = planner(self.world.machine.settings());
        self.stack.running = Some(Running { planner, waiting, t0_s });
        Ok(())
    }

    /// Makes what is planned for good of the stack that moves; all of it when it is complete.
    pub(crate) fn run_on(&mut self, complete: bool) -> Option<Halted> {
        while let Some(running) = &mut self.stack.running {
            let piece = running.next(complete, self.feed);
            let halted = self.run_piece(piece?);
            if halted.is_some() {
                self.stack.running = None;
                return halted;
            }
        }
        None
    }

    /// Everything of the stack was made: the machine stands.
    pub(crate) fn come_to_rest(&mut self) {
        if self.stack.running.take().is_some() {
            self.stand();
        }
        for sourced in self.stack.clear() {
            self.world.perform(sourced.command);
        }
    }

    /// The machine stands.
    pub(crate) fn stand(&mut self) {
        self.drive.stands();
        self.world.machine.rest();
        self.world.tell_log();
        self.world.workspace.tape.moves(false, self.world.placed());
    }

    /// Makes a piece of plan; what is left of the stack goes on after it, unless something halts it.
    fn run_piece(&mut self, piece: Plan) -> Option<Halted> {
        let turned = self.follow_plan(piece);
        let number = match &turned {
            Some((stop, ..)) if stop.share < 1.0 => self.stack.next_number(),
            _ => self.stack.last_number,
        };
        match turned {
            None => {
                if let Some(number) = number {
                    self.interpreter.carried_out(number);
                }
                None
            }
            Some((stop, Turn::Operator(OperatorRequest::Feed(share)), _)) => {
                self.override_feed(share);
                self.go_on_at(|t0_s| t0_s + stop.end_s);
                None
            }
            Some((stop, why, began)) => {
                self.stand();
                self.learn_switched_off();
                self.world.workspace.tape.stood(stop.share);
                // A stop behind the last move leaves nothing to make.
                let motion = if stop.share < 1.0 { number } else { self.stack.next_number() };
                let at = kerf_program::Halted { motion, began, stands: stop.position };
                self.answer_halt(why, number, &at).and_then(|()| self.set_off_again()).err()
            }
        }
    }

    /// Learns that nothing turns any more behind a stop that switches outputs off. It comes on again, with the time to come to
    /// speed, when the run goes on; a job says itself what comes on.
    pub(crate) fn learn_switched_off(&mut self) {
        if self.drive.stop_switches_off() && !self.interpreter.takes_stops() {
            self.world.stop_turning();
            self.world.tell_log();
        }
    }

    /// Sets off with the rest of the stack, from a stand.
    fn set_off_again(&mut self) -> Result<(), Halted> {
        if self.stack.running.is_some() {
            self.may_move(self.last_move).map_err(Halted::Over)?;
            let t0_s = self.set_off()?;
            self.go_on_at(|_| t0_s);
        }
        Ok(())
    }

    fn go_on_at(&mut self, moment: impl FnOnce(f64) -> f64) {
        if let Some(running) = &mut self.stack.running {
            running.t0_s = moment(running.t0_s);
        }
    }

    /// Follows a piece of plan, move by move, to its end or to where it is left for another.
    /// With it goes where the machine was when it was left.
    fn follow_plan(&mut self, mut plan: Plan) -> Option<(Stop, Turn, Axes)> {
        let t0_s = self.stack.running.as_ref()?.t0_s;
        let watched = self.watched(t0_s);
        let watches = pins(&watched, t0_s, &self.world.machine.settings().io);
        self.follows(&plan, t0_s);
        let mut turned: Option<(Stop, Turn, Axes)> = None;
        let mut index = 0;
        while index < plan.moves().len() {
            if turned.is_none() && self.is_taken_up() {
                self.stand_back(&plan.moves()[index..]);
                return None;
            }
            self.carry_out_marks();
            let (begin_s, end_s) = plan.span_s(index);
            let [_, end_s] = self.moments(t0_s, [begin_s, end_s]);
            match &turned {
                Some((stop, turn, _)) => {
                    let (until, part) = (plan.moves().len(), stop.part(index));
                    let going = Going { plan: &plan, index, t0_s, until, part, watches: &[] };
                    self.slow_down(Slows::for_turn(turn), end_s, going);
                }
                None => {
                    let until = index.saturating_add(self.stack.before_mark());
                    let (part, watches) = (1.0, &*watches);
                    let going = Going { plan: &plan, index, t0_s, until, part, watches };
                    if let Some((t_s, turn)) =
                        self.meet(end_s, &watched, Some(going), Self::ask_pace)
                    {
                        if let Turn::Operator(OperatorRequest::Feed(share)) = turn
                            && self.drive.overrides()
                        {
                            self.override_feed(share);
                            continue;
                        }
                        if self.overtakes(turn) {
                            self.stand_back(&plan.moves()[index..]);
                            return None;
                        }
                        let began = plan.at((t_s - t0_s).max(0.0)).position;
                        let stops = !matches!(turn, Turn::Operator(OperatorRequest::Feed(_)));
                        let stood_s = if stops { self.brake(&going) } else { None };
                        let at_s = (stood_s.unwrap_or(t_s) - t0_s).max(0.0);
                        let (made, stop) = self.replan(plan, at_s, turn, stood_s.is_none())?;
                        if let Turn::Input(Halt { cause: HaltCause::Watch(index), .. }) = turn {
                            self.drop_outputs(t_s, index);
                        }
                        self.replans(&made, t0_s, t_s);
                        (plan, turned) = (made, Some((stop, turn, began)));
                        continue;
                    }
                }
            }
            self.make_one(&plan, index, t0_s, false);
            if turned.as_ref().is_none_or(|(stop, ..)| index < stop.whole()) {
                self.stack.made_one(&plan.moves()[index]);
            }
            index += 1;
        }
        turned
    }

    /// Tells whether the power went while the machine was about to do what the operator wants.
    pub(crate) fn overtakes(&mut self, turn: Turn) -> bool {
        let Turn::Operator(request) = turn else { return false };
        let overtaken = self.is_overtaken();
        if overtaken {
            self.overtaken(request);
        }
        overtaken
    }

    /// A plan, or another piece of it, is about to be followed.
    pub(crate) fn follows(&mut self, plan: &Plan, t0_s: f64) {
        let ahead = Ahead { plan, t0_s, from_s: self.world.now() };
        if !self.world.machine.draws() {
            self.drive.follows(&ahead);
            self.begins_anew();
        }
    }

    /// What is left of a plan at a moment is made by another.
    pub(crate) fn replans(&mut self, plan: &Plan, t0_s: f64, at_s: f64) {
        let ahead = Ahead { plan, t0_s, from_s: self.world.now() };
        if !self.world.machine.draws() {
            self.drive.replans(&ahead);
            self.begins_anew();
            self.world.tracked().learn_until(at_s);
        }
    }

    /// A machine that repeats tells what it told of the move under way by the plan that is followed now.
    fn begins_anew(&mut self) {
        if self.drive.repeats() {
            self.world.machine.forget();
        }
    }

    /// Lets time pass up to a moment, unless an input that stops the machine or the operator comes before. The moment of
    /// the input may be over.
    pub(crate) fn meet(
        &mut self,
        end_s: f64,
        watched: &[Watched],
        going: Option<Going<'_>>,
        ask: Ask<Self>,
    ) -> Option<(f64, Turn)> {
        let now_s = self.world.now();
        let mut looked_s = now_s;
        loop {
            let machine = &self.world.machine;
            let halt = match going {
                Some(_) => machine.halted(looked_s, watched),
                None => machine.halted_at_rest(looked_s, watched),
            };
            let level_s = next_level_s(watched, looked_s, end_s);
            let until_s = halt.map_or(level_s.unwrap_or(end_s), |halt| halt.t_s);
            match ask(self, now_s, until_s.max(now_s), going) {
                Some((t_s, Heard::Input { number, on })) => {
                    self.world.tracked().learn(number, on, t_s);
                    looked_s = looked_s.max(t_s);
                }
                Some((t_s, Heard::Operator(request))) => {
                    return Some((t_s, Turn::Operator(request)));
                }
                None if self.drive.fault().is_some() => {
                    return Some((now_s, Turn::Input(link_lost(now_s))));
                }
                None => match (halt, level_s) {
                    (Some(halt), _) => return Some((halt.t_s, Turn::Input(halt))),
                    (None, Some(level_s)) => looked_s = level_s,
                    (None, None) => return None,
                },
            }
        }
    }

    /// Has a machine that slows down by itself do so; tells the moment of the plan at which it stands.
    pub(crate) fn brake(&mut self, going: &Going<'_>) -> Option<f64> {
        let drive = &mut self.drive;
        self.world.workspace.tape.hear_rarely(Kind::Stood, || drive.brake(going))
    }

    /// The piece as it is made when it is left, and where that is; with a ramp, unless the machine has
    /// slowed down by itself.
    fn replan(&mut self, piece: Plan, t_s: f64, turn: Turn, ramps: bool) -> Option<(Plan, Stop)> {
        let planner = &mut self.stack.running.as_mut()?.planner;
        match turn {
            Turn::Input(halt) => planner.stop(piece, t_s, halt.ramped && ramps),
            Turn::Operator(
                OperatorRequest::Stop | OperatorRequest::Hold | OperatorRequest::End,
            ) => planner.stop(piece, t_s, ramps),
            Turn::Operator(OperatorRequest::Feed(share)) => planner.feed(piece, t_s, share),
            // A switch stops nothing by itself.
            Turn::Operator(OperatorRequest::Input { .. }) => None,
        }
    }

    /// Lets time pass while the machine slows down, to the end of a part of its way: it stands no sooner, whatever is told
    /// meanwhile. What the operator wants comes next; a switch that is moved is so at once.
    pub(crate) fn slow_down(&mut self, slows: Slows, end_s: f64, going: Going<'_>) {
        let mut from_s = self.world.now();
        let mut before = None;
        while let Some(told) = self.pass_learning(from_s, end_s, Some(going)) {
            let (t_s, request) = told;
            // Whoever tells the same at the same moment goes on doing so until the machine stands.
            let repeats = before.replace(told) == Some(told);
            match request {
                OperatorRequest::End => {}
                OperatorRequest::Stop if slows.by_stop => {}
                _ if repeats => self.world.workspace.tape.unhear_request(),
                OperatorRequest::Stop | OperatorRequest::Hold if slows.asks => {
                    self.forgo();
                    self.world.workspace.tape.asks_again();
                }
                _ => {
                    self.put_off(told);
                    self.world.workspace.tape.asks_again();
                }
            }
            if repeats {
                break;
            }
            from_s = t_s;
        }
    }

    /// Returns machine time at begin and end of a part of a plan from `t0_s`. What is only drawn takes no time.
    fn moments(&self, t0_s: f64, span_s: [f64; 2]) -> [f64; 2] {
        if self.world.machine.draws() { [self.world.now(); 2] } else { span_s.map(|s| t0_s + s) }
    }

    pub(crate) fn make_one(&mut self, plan: &Plan, index: usize, t0_s: f64, beside: bool) {
        let Some(span) = plan.span(index) else { return };
        self.last_move = span.made.at;
        self.trail.moves(span.made.at);
        let [begin_s, end_s] = self.moments(t0_s, [span.t0_s, span.t1_s]);
        let alone = self.world.machine.alone();
        let lift =
            self.move_made(Going { plan, index, t0_s, until: index + 1, part: 1.0, watches: &[] });
        let made = carried(span.made, &lift);
        if self.world.tells_motion() {
            let event = self.move_event(&made, begin_s, end_s);
            self.world.tell(&event);
        }
        self.world.tell_made(&Made { plan, span: &span, t0_s, alone, lift: &lift, beside });
        let frame = *self.world.machine.frame();
        self.world.tally.made(&made, end_s - begin_s, &frame);
        self.world.tally.carried(&made, &lift, &frame);
        self.world.tell_log();
        let (file, place) = (self.world.file(span.made.at), self.world.placed());
        self.world.workspace.tape.made(&file, span.made.at.line, place);
    }

    /// A move of a plan is made: everything that happened on the way is known. Returns how far height control carried Z.
    fn move_made(&mut self, going: Going<'_>) -> Lift {
        let Going { plan, index, t0_s, .. } = going;
        let Some(span) = plan.span(index) else { return Lift::default() };
        let carried = if self.world.machine.draws() {
            self.world.machine.not_carried()
        } else {
            self.world.tracked().learn_until(t0_s + span.t1_s);
            self.world.driven.borrow_mut().made(&going)
        };
        self.world.machine.make(t0_s, plan, &span, &carried);
        carried.lift
    }

    fn move_event(&self, made: &Move, t0: f64, t1: f64) -> Event {
        let event = MoveEvent {
            kind: made.kind,
            file: self.world.file(made.at),
            line: made.at.line,
            to: self.world.place(made.to),
            t0,
            t1,
            speed: made.speed_mm_s / self.world.scale(leading_axis(made)),
            from: self.world.place(made.from),
        };
        let Path::Arc { centre, sweep_rad, .. } = made.path else { return Event::Move(event) };
        let mut middle = made.to;
        (middle[Axis::X], middle[Axis::Y]) = (centre[0], centre[1]);
        let centre = self.world.place(middle);
        Event::Arc(ArcEvent {
            made: event,
            centre: Centre { x: centre.x, y: centre.y },
            dir: if sweep_rad < 0.0 { "cw" } else { "ccw" },
            sweep: sweep_rad.abs().to_degrees(),
        })
    }

    /// Carries out what is marked before the next move.
    fn carry_out_marks(&mut self) {
        while let Some(sourced) = self.stack.due() {
            self.world.perform(sourced.command);
        }
    }

    /// Outputs that do not wait until the machine stands.
    pub(crate) fn drop_outputs(&mut self, t_s: f64, index: usize) {
        if let Some(watch) = self.interpreter.watches().get(index) {
            self.world.machine.drop_outputs(t_s, &watch.drops);
        }
    }

    /// Answers a stop of motion: fails with what follows, unless the motion goes on.
    pub(crate) fn answer_halt(
        &mut self,
        why: Turn,
        number: Option<u64>,
        at: &kerf_program::Halted,
    ) -> Result<(), Halted> {
        let halt = match why {
            Turn::Operator(_) if self.interpreter.takes_stops() => {
                self.world.tell(&Event::Stop { by: "operator", n: 0, t: self.world.now() });
                return Err(Halted::Taken { by: StoppedBy::Operator, at: *at });
            }
            Turn::Operator(request) => return self.stands(request).map_err(Halted::Over),
            Turn::Input(halt) => halt,
        };
        let (by, n) = match halt.cause {
            HaltCause::Watch(index) if self.is_emergency(index) => {
                ("stop", Input::EmergencyStop.number())
            }
            HaltCause::Watch(index) => {
                ("watch", self.watched(0.0).get(index).map_or(0, |w| w.input))
            }
            HaltCause::Limit(n) => ("limit", n),
            HaltCause::Stop(n) => ("stop", n),
            HaltCause::LinkLost => ("link", 0),
            HaltCause::Stall => ("stall", 0),
        };
        self.world.tell(&Event::Stop { by, n, t: self.world.now() });
        match halt.cause {
            HaltCause::Watch(index) if self.is_emergency(index) => {
                self.heed_press().map_err(Halted::Over)
            }
            HaltCause::Watch(index) => {
                let at = kerf_program::Halted { motion: number, ..*at };
                self.changed_s = halt.t_s;
                Err(Halted::Watch { index, at })
            }
            cause => self.halted_by(cause, *at),
        }
    }

    /// Answers a stop that no program has asked for: fails with what follows, unless the run goes on.
    pub(crate) fn halted_by(
        &mut self,
        cause: HaltCause,
        at: kerf_program::Halted,
    ) -> Result<(), Halted> {
        let takes = self.interpreter.takes_stops();
        match cause {
            HaltCause::LinkLost => Err(Halted::Over(self.link_is_lost())),
            HaltCause::Stall => Err(Halted::Over(self.has_stalled())),
            HaltCause::Stop(n) if self.cuts_power(n) => Err(Halted::Over(self.power_is_cut())),
            HaltCause::Stop(n) if takes => Err(Halted::Taken { by: StoppedBy::Input(n), at }),
            HaltCause::Limit(n) if takes => Err(Halted::Taken { by: StoppedBy::Limit(n), at }),
            HaltCause::Stop(n) => self.blocked(n).map_err(Halted::Over),
            HaltCause::Limit(n) => {
                let message = format!("stopped by limit input {n}");
                self.world.limit = Some(n);
                self.limited(self.last_move, Code::InputStop, message).map_err(Halted::Over)
            }
            HaltCause::Watch(_) => Ok(()),
        }
    }

    /// Tells whether a stop input is the emergency stop of a machine that cuts its power with it.
    pub(crate) fn cuts_power(&self, input: u8) -> bool {
        input == kerf_sim::STOP_INPUT && self.world.machine_is.estop.cuts_power
    }
}

/// A way to let time pass that heeds the operator: also what he asked for before, or only what he asks for now.
pub(crate) type Ask<R> = fn(&mut R, f64, f64, Option<Going<'_>>) -> Option<(f64, Heard)>;

/// Returns the next moment, up to another, from which on a state that is watched stops the machine.
fn next_level_s(watched: &[Watched], from_s: f64, end_s: f64) -> Option<f64> {
    let levels = watched.iter().filter_map(|watch| watch.level_from_s);
    levels.filter(|s| *s > from_s && *s <= end_s).min_by(f64::total_cmp)
}

/// Returns the halt of a plan that nothing follows any more.
pub(crate) const fn link_lost(t_s: f64) -> Halt {
    Halt { t_s, cause: HaltCause::LinkLost, ramped: false }
}

/// A move as it is made, between the heights that height control carries its ends to.
fn carried(made: &Move, lift: &Lift) -> Move {
    let [from_mm, to_mm] = lift.ends();
    let mut made = *made;
    made.from[Axis::Z] += from_mm;
    made.to[Axis::Z] += to_mm;
    made
}

/// The axis in whose unit the speed of a move is told.
fn leading_axis(made: &Move) -> Axis {
    let moves = |axis: &Axis| made.from[*axis] != made.to[*axis];
    let arc = matches!(made.path, Path::Arc { .. });
    if arc { Axis::X } else { Axis::ALL.into_iter().find(moves).unwrap_or(Axis::X) }
}

/// Inputs at whose change the machine stands at once, as their pins are reported; what slows down along a ramp needs no
/// exact place.
fn pins(watched: &[Watched], t0_s: f64, io: &IoModes) -> Vec<Watch> {
    let at_once = watched.iter().filter(|watch| !watch.ramped);
    let heeded = at_once.filter(|watch| watch.level_from_s.is_none_or(|from_s| from_s <= t0_s));
    heeded.map(|w| Watch { input: w.input, active: pin(w.input, w.on, io) }).collect()
}
