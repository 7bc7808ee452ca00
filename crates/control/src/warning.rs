//! The warning before motion: the light is on and nothing moves yet, so that people can step back. Whatever stops
//! the machine stops it now, before anything has moved.

use crate::execute::{Halted, Turn};
use crate::runner::Runner;
use crate::{OperatorRequest, by_hand::Driven};
use kerf_program::{Halted as Stood, Interpreter};
use kerf_sim::{Halt, HaltCause, Watched};

impl<I: Interpreter> Runner<'_, I> {
    /// The machine is about to move what was read: the warning comes first. Gives the moment at which motion
    /// starts.
    pub(crate) fn set_off(&mut self) -> Result<f64, Halted> {
        loop {
            self.world.workspace.tape.moves(true, self.world.placed());
            if self.is_open_for_take_up() {
                return Ok(self.world.now());
            }
            let watched = self.watched(self.world.now());
            let Some(turn) = self.warn(&watched) else { return Ok(self.world.now()) };
            if self.overtakes(turn) {
                // The machine is elsewhere: it is brought back before the first move.
                return Ok(self.world.now());
            }
            self.stand();
            self.world.workspace.tape.stood(1.0);
            if let Turn::Input(Halt { cause: HaltCause::Watch(index), .. }) = turn {
                self.drop_outputs(self.world.now(), index);
            }
            let (number, stands) = (self.stack.next_number(), self.world.machine.position());
            let at = Stood { motion: number, began: stands, stands };
            self.answer_halt(turn, number, &at)?;
            self.may_move(self.last_move).map_err(Halted::Over)?;
        }
    }

    /// Lets the warning pass. What stops the machine meanwhile is told.
    fn warn(&mut self, watched: &[Watched]) -> Option<Turn> {
        let until_s = self.world.machine.warn();
        self.world.tell_log();
        while self.world.now() < until_s {
            let now_s = self.world.now();
            let halt = self.world.machine.first_halt_at_rest(until_s, watched);
            let end_s = halt.map_or(until_s, |halt| halt.t_s.max(now_s));
            let request = self.pass(now_s, end_s, None);
            if self.drive.fault().is_some() {
                return Some(Turn::Input(crate::execute::link_lost(now_s)));
            }
            match request {
                Some((t_s, OperatorRequest::Input { number, on })) => self.press(number, on, t_s),
                Some(request @ (_, OperatorRequest::Feed(_))) => self.postpone(request),
                Some((t_s, request)) => {
                    self.stand_until(t_s);
                    return Some(Turn::Operator(request));
                }
                None => {
                    self.stand_until(end_s);
                    if halt.is_some() {
                        return halt.map(Turn::Input);
                    }
                }
            }
        }
        None
    }

    /// The same before a motion beside the program.
    pub(crate) fn warn_by_hand(&mut self, watched: &[Watched]) -> Option<Driven> {
        let turn = self.warn(watched)?;
        let here = self.world.machine.position();
        Some(match turn {
            Turn::Operator(request) => Driven::OperatorRequest(request),
            Turn::Input(halt) => Driven::by(halt.cause, watched.len()).at(here),
        })
    }
}
