//! Making the stack of moves that is read: planning, following the plan, stopping on the way.

use crate::follow::{LeftPlan, follow_plan};
use crate::interruption::Interruption;
use crate::reentry::taken;
use crate::run_end::Break;
use crate::runner::Runner;
use crate::stack::Running;
use crate::{OperatorRequest, reentry, table_limits};
use kerf_diag::Code;
use kerf_machine::lines::Input;
use kerf_model::{Halt, HaltCause};
use kerf_motion::{Plan, planner};
use kerf_program::{Halted as Stood, Interpreter, StoppedBy};
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
        let station = &mut self.stops.station;
        let waiting = std::mem::take(&mut station.stack.waiting);
        let planner = planner(station.world.model.settings());
        station.stack.running = Some(Running { planner, waiting, t0_s });
        Ok(())
    }

    /// Makes what is planned for good of the stack that moves; all of it when it is complete.
    pub(crate) fn run_on(&mut self, complete: bool) -> Result<(), Break> {
        let whole = self.stops.station.drive.plans_corners();
        while let Some(running) = &mut self.stops.station.stack.running {
            let Some(piece) = running.next(complete, self.stops.station.feed, whole) else { break };
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
        let left = follow_plan(&mut self.stops.station, piece);
        let number = match &left {
            Some(LeftPlan { stop, .. }) if stop.share < 1.0 => {
                self.stops.station.stack.next_number()
            }
            _ => self.stops.station.stack.last_number,
        };
        match left {
            None => {
                if let Some(number) = number {
                    self.stops.station.interpreter.carried_out(number);
                }
                Ok(())
            }
            Some(LeftPlan {
                stop,
                why: Interruption::Operator(OperatorRequest::Feed(share)),
                ..
            }) => {
                self.stops.station.override_feed(share);
                self.go_on_at(|t0_s| t0_s + stop.end_s);
                Ok(())
            }
            Some(LeftPlan { stop, why, began }) => {
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

    /// Answers a stop of motion: fails with what follows, unless the motion goes on.
    fn answer_halt(
        &mut self,
        why: Interruption,
        number: Option<u64>,
        at: &kerf_program::Halted,
    ) -> Result<(), Break> {
        let halt = match why {
            Interruption::Operator(_) if self.stops.station.interpreter.takes_stops() => {
                self.stops.station.world.tell(&Event::Stop {
                    by: "operator",
                    n: 0,
                    t: self.stops.station.world.now(),
                });
                return Err(taken(&mut self.stops, StoppedBy::Operator, at));
            }
            Interruption::Operator(request) => return Ok(self.stops.stands(request)?),
            Interruption::Input(halt) => halt,
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
            let station = &mut self.stops.station;
            let (placed, now_s) = (station.world.placed(), station.world.now());
            station.world.workspace.tape.moves(true, placed);
            if station.is_open_for_take_up() {
                return Ok(now_s);
            }
            let watched = station.watched(now_s);
            let Some(turn) = station.warn(&watched) else { return Ok(station.world.now()) };
            if station.overtakes(turn) {
                // The machine is elsewhere: it is brought back before the first move.
                return Ok(station.world.now());
            }
            station.stand();
            station.world.workspace.tape.stood(1.0);
            if let Interruption::Input(Halt { cause: HaltCause::Watch(index), .. }) = turn {
                station.drop_outputs(station.world.now(), index);
            }
            let (number, stands) = (station.stack.next_number(), station.world.model.position());
            let at = Stood { motion: number, began: stands, stands };
            self.answer_halt(turn, number, &at)?;
            let at = self.stops.station.last_move;
            table_limits::may_move(&mut self.stops, at)?;
        }
    }
}
