//! Taking up a run that was cut short: up to where it was it runs in silence, the world's part
//! played from the [tape](crate::journal); then the machine goes back to where the cut ended.
//!
//! ```text
//!           lift ┌───────── approach ────────┐
//!                │   spindle, outputs        │ plunge
//!   stands here ─┘                           └─► on along the path
//! ```
//!
//! The move that was under way is made again from its start. A job knows its own way back, that from a
//! pause: it is only told where it was.

use crate::Event;
use crate::execute::Halted;
use crate::journal::Placed;
use crate::runner::Runner;
use kerf_motion::Move;
use kerf_program::{Axes, Axis, Interpreter, MoveKind, OutputReason, StoppedBy};
use std::sync::Arc;

impl<I: Interpreter> Runner<'_, I> {
    /// The world is heard again when all has happened that happened before.
    pub(crate) fn wake(&mut self) {
        if self.world.silent && !self.world.shelf.tape.plays() {
            self.world.silent = false;
            self.world.shelf.goes_live();
            let stands = self.stands_at();
            self.world.shelf.tape.wake(stands);
        }
    }

    /// Whether the next move is the first one that was not made before.
    pub(crate) fn is_taken_up(&mut self) -> bool {
        self.wake();
        self.reentry.is_some() && (!self.world.silent || self.world.shelf.tape.is_reentered())
    }

    /// The moves that are left are planned anew, from a stand.
    pub(crate) fn stand_back(&mut self, piece: &[Move]) {
        let mut left = piece.to_vec();
        if let Some(mut running) = self.stack.running.take() {
            left.extend(running.planner.withdraw());
        }
        if let Some(first) = left.first_mut() {
            first.from = self.world.machine.position();
        }
        self.stack.waiting = left;
        self.stand();
    }

    /// Brings the machine back to where the run was, before the first move that was not made; or lets
    /// the program do it.
    pub(crate) fn take_up(&mut self) -> Result<(), Halted> {
        if !self.is_taken_up() {
            return Ok(());
        }
        // It may have been taken up here before, and cut short again.
        let from = self.world.shelf.tape.reentered().unwrap_or_else(|| {
            let from = self.stands_at();
            self.reentry = None;
            self.world.shelf.tape.reenter(&from);
            from
        });
        if self.interpreter.takes_stops() {
            return Err(self.hand_over(from.position));
        }
        self.go_back(from.position);
        Ok(())
    }

    /// The program finds its way back from where the machine stands.
    fn hand_over(&mut self, from: Axes) -> Halted {
        let began = self.world.machine.position();
        let motion = self.stack.next_number();
        self.world.machine.restart(from);
        self.tell_taken_up();
        self.world.tell(&Event::Resume { t: self.world.now() });
        let at = kerf_program::Halted { motion, began, stands: from };
        Halted::Taken { by: StoppedBy::PowerCut, at }
    }

    /// Where the machine stands, in the frames of the run.
    pub(crate) fn stands_at(&self) -> Placed {
        let Placed { position: here, frame } = self.world.placed();
        let position = self.reentry.map_or(here, |stands| stands.seen_from(&frame));
        Placed { position, frame }
    }

    /// A run that was taken up and is over without a move leaves the machine where it stood.
    pub(crate) fn stay_where_it_stands(&mut self) {
        if self.reentry.is_some() {
            let stands = self.stands_at();
            self.world.machine.restart(stands.position);
        }
    }

    fn go_back(&mut self, from: Axes) {
        let ahead = self.mover.position();
        let to = self.world.machine.position();
        let was_on = self.world.machine.restart(from);
        self.world.machine.begin_motion();
        self.tell_taken_up();
        self.lift();
        for number in was_on {
            self.world.machine.output(number, true, OutputReason::Program);
        }
        self.world.tell_log();
        self.approach(to);
        self.go(MoveKind::Cut, to);
        self.mover.set_position(ahead);
        self.world.tell(&Event::Resume { t: self.world.now() });
    }

    fn tell_taken_up(&mut self) {
        let (file, line) = (self.world.file(self.last_move), self.last_move.line);
        let text = match line {
            0 => "taken up before the first move".to_owned(),
            line => format!("taken up behind line {line} of {file}"),
        };
        self.world.tell(&Event::Message { text: Arc::from(text), t: self.world.now() });
        self.world.tell_log();
    }

    /// Over the place, no lower than the tool is now.
    fn approach(&mut self, to: Axes) {
        let mut over = to;
        over[Axis::Z] = to[Axis::Z].max(self.world.machine.position()[Axis::Z]);
        self.go(MoveKind::Jog, over);
    }
}
