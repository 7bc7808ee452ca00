//! Moves beside the program: up after a stop, and back to where it was stopped.
//!
//! They heed every stop as those of the program do. While the program runs, which is so on the way back, a
//! stop on the way is a stop like any other: the tool rises, and comes back to that place before it goes on.
//! While it is stopped already, the question that comes next, or is open, says what follows.

use crate::OperatorRequest;
use crate::by_hand::Driven;
use crate::interruption::Interruption;
use crate::run_end::RunEnd;
use crate::station::Station;
use crate::stopping::RunStops;
use kerf_diag::Code;
use kerf_machine::state::State;
use kerf_model::HaltCause;
use kerf_program::{Axes, Axis, Feed, Interpreter, Line, MoveKind, Status};
use kerf_trace::Event;

/// Outcome of a move that was stopped on the way.
enum After {
    /// It goes on.
    On,
    /// It ends there.
    Ended,
}

impl<I: Interpreter> RunStops<'_, I> {
    /// Goes to a place, machine frame; stays on the way when something says so. What ends the run is told
    /// by [`Stops::heeded`], and nothing moves any more.
    pub(crate) fn go(&mut self, kind: MoveKind, to: Axes) {
        let nudged = self.station.nudged.unwrap_or_default();
        while self.ends.is_none() {
            // Whoever stopped it on the way may have nudged the workpiece.
            let to = to.plus(self.station.nudged.unwrap_or_default().minus(nudged));
            if self.station.is_open_for_take_up() {
                return self.station.world.model.put(to);
            }
            self.station.mover.set_position(self.station.world.model.position());
            let line = Line { kind, to, feed: Feed::Axis };
            let Some(made) = self.station.mover.line(self.station.last_move, &line) else { return };
            let settings = self.station.world.model.settings().clone();
            let driven = match self.station.world.model.stop_input() {
                _ if self.station.is_ended_by_press() => Driven::EmergencyStop,
                Some(n) => Driven::StopInput(n),
                None => self.station.drive(made, &settings, &[]),
            };
            match self.on_the_way(driven) {
                Ok(After::On) => {}
                Ok(After::Ended) => return,
                Err(over) => self.ends = Some(over),
            }
        }
    }

    /// Fails, once, with what ended the run beside the program.
    pub(crate) fn heeded(&mut self) -> Result<(), RunEnd> {
        self.ends.take().map_or(Ok(()), Err)
    }

    fn on_the_way(&mut self, driven: Driven) -> Result<After, RunEnd> {
        let runs = self.state == State::Running;
        if runs {
            self.station.world.workspace.tape.stood(1.0);
        }
        let (by, n) = match driven {
            Driven::There | Driven::Edge(_) => return Ok(After::Ended),
            Driven::OperatorRequest(OperatorRequest::End) => {
                return Err(RunEnd::of(Status::Ended));
            }
            Driven::OperatorRequest(request) if runs => {
                return self.stands(request).map(|()| After::On);
            }
            Driven::OperatorRequest(_) => {
                self.station.drive.heard();
                ("operator", 0)
            }
            Driven::EmergencyStop => return Err(self.emergency()),
            Driven::Limit(n) => ("limit", n),
            Driven::StopInput(n) => ("stop", n),
            Driven::LinkLost => ("link", 0),
            Driven::Stalled => ("stall", 0),
        };
        self.station.world.tell(&Event::Stop { by, n, t: self.station.world.now() });
        match driven {
            Driven::Limit(n) if runs => {
                let message = format!("stopped by limit input {n}");
                self.limited(self.station.last_move, Code::InputStop, message).map(|()| After::On)
            }
            Driven::StopInput(n) if runs || self.station.cuts_power(n) => {
                self.ended_by(HaltCause::Stop(n))
            }
            Driven::StopInput(n) => self.stopped_again(n).map(|()| After::On),
            Driven::LinkLost => self.ended_by(HaltCause::LinkLost),
            Driven::Stalled => self.ended_by(HaltCause::Stall),
            _ => Ok(After::Ended),
        }
    }

    /// Deals with the cause of a halt in a run of a part file; a job never comes here.
    fn ended_by(&mut self, cause: HaltCause) -> Result<After, RunEnd> {
        match cause {
            HaltCause::Stop(n) if self.station.cuts_power(n) => Err(self.power_is_cut()),
            HaltCause::Stop(n) => self.blocked(n).map(|()| After::On),
            HaltCause::LinkLost => Err(self.link_is_lost()),
            HaltCause::Watch(_) => Err(self.emergency()),
            _ => Err(self.has_stalled()),
        }
    }

    /// A stop input while the machine is stopped already: nothing moves or turns before it is released.
    pub(crate) fn stopped_again(&mut self, n: u8) -> Result<(), RunEnd> {
        let message = self.station.stop_input_message(format!("stopped by stop input {n}"));
        self.stop_spindles();
        self.station.world.tell_log();
        self.until_released(&message, true)
    }

    /// Stands until a moment, and heeds every stop meanwhile.
    pub(crate) fn stand_heeding(&mut self, until_s: f64) -> Result<(), RunEnd> {
        while self.station.world.now() < until_s && !self.station.is_open_for_take_up() {
            let watched = self.station.watched_at_rest();
            let turn = self.station.meet(until_s, watched.as_slice(), None, Station::ask_pace);
            if self.station.drive.fault().is_some() {
                return Err(self.link_is_lost());
            }
            self.station.stand_until(turn.map_or(until_s, |(t_s, _)| t_s));
            self.station.world.workspace.tape.stood(1.0);
            match turn {
                Some((_, Interruption::Operator(request))) => self.stands(request)?,
                Some((_, Interruption::Input(halt))) => {
                    self.ended_by(halt.cause)?;
                }
                None => {}
            }
        }
        Ok(())
    }

    /// Goes back to a place, from wherever the operator moved the machine: over it at a height, or
    /// higher, then down.
    pub(crate) fn go_back_to(&mut self, stood: Axes, lifted_mm: f64) {
        let mut above = self.station.world.model.position();
        above[Axis::Z] = above[Axis::Z].max(lifted_mm);
        let mut over = stood;
        over[Axis::Z] = above[Axis::Z];
        let before = self.station.nudged.unwrap_or_default();
        for (kind, to) in [(MoveKind::Jog, above), (MoveKind::Jog, over), (MoveKind::Cut, stood)] {
            let on_the_way = self.station.nudged.unwrap_or_default().minus(before);
            self.go(kind, to.plus(on_the_way));
        }
    }

    /// Lifts the tool to safe Z when it is lower (command reference, stopping).
    pub(crate) fn lift(&mut self) {
        let mut to = self.station.world.model.position();
        let Some(safe_mm) = self.station.lift_mm() else { return };
        if to[Axis::Z] < safe_mm {
            to[Axis::Z] = safe_mm;
            self.go(MoveKind::Jog, to);
        }
    }
}
