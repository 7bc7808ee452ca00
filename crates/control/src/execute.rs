//! Making the stack of moves that is read: planning, following the plan, stopping on the way.

use crate::reentry::taken;
use crate::run_end::Break;
use crate::runner::Runner;
use crate::stack::Running;
use crate::station::Station;
use crate::turn::{Slows, Turn};
use crate::{OperatorRequest, reentry, table_limits};
use kerf_diag::Code;
use kerf_machine::lines::Input;
use kerf_machine::{Going, Watch};
use kerf_motion::{Plan, Stop, planner};
use kerf_program::settings::IoModes;
use kerf_program::{Axes, Halted as Stood, Interpreter, StoppedBy};
use kerf_sim::{Halt, HaltCause, Watched, pin};
use kerf_trace::event::Event;

impl<I: Interpreter> Runner<'_, I> {
    /// The moves that were read begin to move.
    pub(crate) fn begin(&mut self) -> Result<(), Break> {
        reentry::take_up(&mut self.stops)?;
        let waiting = std::mem::take(&mut self.stops.station.stack.waiting);
        let may = table_limits::check(&mut self.stops, &waiting);
        self.stops.station.stack.waiting = waiting;
        may?;
        if self.stops.station.stack.waiting.is_empty() {
            return Ok(());
        }
        table_limits::heed_limit(&mut self.stops)?;
        let t0_s = self.set_off()?;
        let waiting = std::mem::take(&mut self.stops.station.stack.waiting);
        let planner = planner(self.stops.station.world.machine.settings());
        self.stops.station.stack.running = Some(Running { planner, waiting, t0_s });
        Ok(())
    }

    /// Makes what is planned for good of the stack that moves; all of it when it is complete.
    pub(crate) fn run_on(&mut self, complete: bool) -> Result<(), Break> {
        while let Some(running) = &mut self.stops.station.stack.running {
            let Some(piece) = running.next(complete, self.stops.station.feed) else { break };
            let made = self.run_piece(piece);
            if made.is_err() {
                self.stops.station.stack.running = None;
                return made;
            }
        }
        Ok(())
    }

    /// Makes a piece of plan; what is left of the stack goes on after it, unless something halts it.
    fn run_piece(&mut self, piece: Plan) -> Result<(), Break> {
        let turned = self.follow_plan(piece);
        let number = match &turned {
            Some((stop, ..)) if stop.share < 1.0 => self.stops.station.stack.next_number(),
            _ => self.stops.station.stack.last_number,
        };
        match turned {
            None => {
                if let Some(number) = number {
                    self.stops.station.interpreter.carried_out(number);
                }
                Ok(())
            }
            Some((stop, Turn::Operator(OperatorRequest::Feed(share)), _)) => {
                self.stops.station.override_feed(share);
                self.go_on_at(|t0_s| t0_s + stop.end_s);
                Ok(())
            }
            Some((stop, why, began)) => {
                self.stops.station.stand();
                self.stops.station.learn_switched_off();
                self.stops.station.world.workspace.tape.stood(stop.share);
                // A stop behind the last move leaves nothing to make.
                let motion =
                    if stop.share < 1.0 { number } else { self.stops.station.stack.next_number() };
                let at = kerf_program::Halted { motion, began, stands: stop.position };
                self.answer_halt(why, number, &at)?;
                self.set_off_again()
            }
        }
    }

    /// Sets off with the rest of the stack, from a stand.
    fn set_off_again(&mut self) -> Result<(), Break> {
        if self.stops.station.stack.running.is_some() {
            let at = self.stops.station.last_move;
            table_limits::may_move(&mut self.stops, at)?;
            let t0_s = self.set_off()?;
            self.go_on_at(|_| t0_s);
        }
        Ok(())
    }

    fn go_on_at(&mut self, moment: impl FnOnce(f64) -> f64) {
        if let Some(running) = &mut self.stops.station.stack.running {
            running.t0_s = moment(running.t0_s);
        }
    }

    /// Follows a piece of plan, move by move, to its end or to where it is left for another.
    /// With it goes where the machine was when it was left.
    fn follow_plan(&mut self, mut plan: Plan) -> Option<(Stop, Turn, Axes)> {
        let t0_s = self.stops.station.stack.running.as_ref()?.t0_s;
        let watched = self.stops.station.watched(t0_s);
        let watches = pins(&watched, t0_s, &self.stops.station.world.machine.settings().io);
        self.stops.station.world.tracked().follows(&plan, t0_s);
        let mut turned: Option<(Stop, Turn, Axes)> = None;
        let mut index = 0;
        while index < plan.moves().len() {
            if turned.is_none() && self.stops.station.is_taken_up() {
                self.stops.station.stand_back(&plan.moves()[index..]);
                return None;
            }
            self.stops.station.carry_out_marks();
            let (begin_s, end_s) = plan.span_s(index);
            let [_, end_s] = self.stops.station.moments(t0_s, [begin_s, end_s]);
            match &turned {
                Some((stop, turn, _)) => {
                    let (until, part) = (plan.moves().len(), stop.part(index));
                    let going = Going { plan: &plan, index, t0_s, until, part, watches: &[] };
                    self.stops.station.slow_down(Slows::for_turn(turn), end_s, going);
                }
                None => {
                    let until = index.saturating_add(self.stops.station.stack.before_mark());
                    let (part, watches) = (1.0, &*watches);
                    let going = Going { plan: &plan, index, t0_s, until, part, watches };
                    let ask = Station::ask_pace;
                    let met = self.stops.station.meet(end_s, &watched, Some(going), ask);
                    if let Some((t_s, turn)) = met {
                        if let Turn::Operator(OperatorRequest::Feed(share)) = turn
                            && self.stops.station.drive.overrides()
                        {
                            self.stops.station.override_feed(share);
                            continue;
                        }
                        if self.stops.station.overtakes(turn) {
                            self.stops.station.stand_back(&plan.moves()[index..]);
                            return None;
                        }
                        let Some(turn) = self.stops.station.hold_on_path(turn, &going) else {
                            continue;
                        };
                        let began = plan.at((t_s - t0_s).max(0.0)).position;
                        let stops = !matches!(turn, Turn::Operator(OperatorRequest::Feed(_)));
                        let stood_s = if stops { self.stops.station.brake(&going) } else { None };
                        let at_s = (stood_s.unwrap_or(t_s) - t0_s).max(0.0);
                        let (made, stop) = self.replan(plan, at_s, turn, stood_s.is_none())?;
                        if let Turn::Input(Halt { cause: HaltCause::Watch(index), .. }) = turn {
                            self.stops.station.drop_outputs(t_s, index);
                        }
                        self.stops.station.world.tracked().replans(&made, t0_s, t_s);
                        (plan, turned) = (made, Some((stop, turn, began)));
                        continue;
                    }
                }
            }
            self.stops.station.make_one(&plan, index, t0_s, false);
            if turned.as_ref().is_none_or(|(stop, ..)| index < stop.whole()) {
                self.stops.station.stack.made_one(&plan.moves()[index]);
            }
            index += 1;
        }
        turned
    }

    /// The piece as it is made when it is left, and where that is; with a ramp, unless the machine has
    /// slowed down by itself.
    fn replan(&mut self, piece: Plan, t_s: f64, turn: Turn, ramps: bool) -> Option<(Plan, Stop)> {
        let planner = &mut self.stops.station.stack.running.as_mut()?.planner;
        match turn {
            Turn::Input(halt) => planner.stop(piece, t_s, halt.ramped && ramps),
            Turn::Operator(
                OperatorRequest::Stop
                | OperatorRequest::Hold
                | OperatorRequest::End
                | OperatorRequest::GiveUp,
            ) => planner.stop(piece, t_s, ramps),
            Turn::Operator(OperatorRequest::Feed(share)) => planner.feed(piece, t_s, share),
            // A switch stops nothing by itself.
            Turn::Operator(OperatorRequest::Input { .. }) => None,
        }
    }

    /// Answers a stop of motion: fails with what follows, unless the motion goes on.
    fn answer_halt(
        &mut self,
        why: Turn,
        number: Option<u64>,
        at: &kerf_program::Halted,
    ) -> Result<(), Break> {
        let halt = match why {
            Turn::Operator(_) if self.stops.station.interpreter.takes_stops() => {
                self.stops.station.world.tell(&Event::Stop {
                    by: "operator",
                    n: 0,
                    t: self.stops.station.world.now(),
                });
                return Err(taken(&mut self.stops, StoppedBy::Operator, at));
            }
            Turn::Operator(request) => return Ok(self.stops.stands(request)?),
            Turn::Input(halt) => halt,
        };
        let (by, n) = match halt.cause {
            HaltCause::Watch(index) if self.stops.station.is_emergency(index) => {
                ("stop", Input::EmergencyStop.number())
            }
            HaltCause::Watch(index) => {
                ("watch", self.stops.station.watched(0.0).get(index).map_or(0, |w| w.input))
            }
            HaltCause::Limit(n) => ("limit", n),
            HaltCause::Stop(n) => ("stop", n),
            HaltCause::LinkLost => ("link", 0),
            HaltCause::Stall => ("stall", 0),
        };
        self.stops.station.world.tell(&Event::Stop { by, n, t: self.stops.station.world.now() });
        match halt.cause {
            HaltCause::Watch(index) if self.stops.station.is_emergency(index) => {
                Ok(self.stops.heed_press()?)
            }
            HaltCause::Watch(index) => {
                let at = kerf_program::Halted { motion: number, ..*at };
                self.changed_s = halt.t_s;
                self.interrupt(index, &at)
            }
            cause => self.halted_by(cause, *at),
        }
    }

    /// Answers a stop that no program has asked for: fails with what follows, unless the run goes on.
    pub(crate) fn halted_by(
        &mut self,
        cause: HaltCause,
        at: kerf_program::Halted,
    ) -> Result<(), Break> {
        let takes = self.stops.station.interpreter.takes_stops();
        match cause {
            HaltCause::LinkLost => Err(self.stops.link_is_lost().into()),
            HaltCause::Stall => Err(self.stops.has_stalled().into()),
            HaltCause::Stop(n) if self.stops.station.cuts_power(n) => {
                Err(self.stops.power_is_cut().into())
            }
            HaltCause::Stop(n) if takes => Err(taken(&mut self.stops, StoppedBy::Input(n), &at)),
            HaltCause::Limit(n) if takes => Err(taken(&mut self.stops, StoppedBy::Limit(n), &at)),
            HaltCause::Stop(n) => Ok(self.stops.blocked(n)?),
            HaltCause::Limit(n) => {
                let message = format!("stopped by limit input {n}");
                self.stops.station.world.limit = Some(n);
                let at = self.stops.station.last_move;
                Ok(self.stops.limited(at, Code::InputStop, message)?)
            }
            HaltCause::Watch(_) => Ok(()),
        }
    }

    /// The machine is about to move what was read: the warning comes first. Gives the moment at which motion
    /// starts.
    fn set_off(&mut self) -> Result<f64, Break> {
        loop {
            self.stops.station.world.workspace.tape.moves(true, self.stops.station.world.placed());
            if self.stops.station.is_open_for_take_up() {
                return Ok(self.stops.station.world.now());
            }
            let watched = self.stops.station.watched(self.stops.station.world.now());
            let Some(turn) = self.stops.station.warn(&watched) else {
                return Ok(self.stops.station.world.now());
            };
            if self.stops.station.overtakes(turn) {
                // The machine is elsewhere: it is brought back before the first move.
                return Ok(self.stops.station.world.now());
            }
            self.stops.station.stand();
            self.stops.station.world.workspace.tape.stood(1.0);
            if let Turn::Input(Halt { cause: HaltCause::Watch(index), .. }) = turn {
                self.stops.station.drop_outputs(self.stops.station.world.now(), index);
            }
            let (number, stands) = (
                self.stops.station.stack.next_number(),
                self.stops.station.world.machine.position(),
            );
            let at = Stood { motion: number, began: stands, stands };
            self.answer_halt(turn, number, &at)?;
            let at = self.stops.station.last_move;
            table_limits::may_move(&mut self.stops, at)?;
        }
    }
}

/// Inputs at whose change the machine stands at once, as their pins are reported; what slows down along a ramp needs no
/// exact place.
fn pins(watched: &[Watched], t0_s: f64, io: &IoModes) -> Vec<Watch> {
    let at_once = watched.iter().filter(|watch| !watch.ramped);
    let heeded = at_once.filter(|watch| watch.level_from_s.is_none_or(|from_s| from_s <= t0_s));
    heeded.map(|w| Watch { input: w.input, active: pin(w.input, w.on, io) }).collect()
}
