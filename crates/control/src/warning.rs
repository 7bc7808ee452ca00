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
            let turn = self.meet(until_s, watched, None, Self::pass);
            if self.drive.fault().is_some() {
                return turn.map(|(_, turn)| turn);
            }
            if let Some((t_s, Turn::Operator(request @ OperatorRequest::Feed(_)))) = turn {
                self.postpone((t_s, request));
                continue;
            }
            self.stand_until(turn.map_or(until_s, |(t_s, _)| t_s));
            if turn.is_some() {
                return turn.map(|(_, turn)| turn);
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
