//! Stops of a run: the table of states says what follows, here its effects are
//! carried out.
//!
//! [`Stops`] is the middle floor of a run: it moves the machine by what [`Station`] can, and decides what follows.
//! Jobs and moves by hand know what they do when they are stopped, and ask the same table; the run of a
//! part file is stopped here. Whatever it is that runs, a cut power and a lost link end it here.

use crate::run_end::RunEnd;
use crate::station::Station;
use crate::stopped_spindles::StoppedSpindles;
use kerf_diag::Code;
use kerf_journal::LimitPolicy;
use kerf_machine::Fault;
use kerf_machine::lines::Input;
use kerf_machine::state::{Effect, Event as StateEvent, State, StopSettings};
use kerf_program::{Axes, Axis, Interpreter, OutputReason, Sourced, Status};
use kerf_sbp::SPINDLE_STATUS;
use kerf_trace::{Event, flag};

/// A place that is come back to, and what was on there.
#[derive(Clone, Debug, Default)]
pub(crate) struct ReturnPlace {
    /// Place where the machine stood.
    stood: Axes,
    /// Place that the commands that were read lead to.
    ahead: Axes,
    /// To where the tool was lifted.
    pub lifted_mm: f64,
    /// Distance by which the workpiece was nudged since.
    pub nudged: Axes,
    /// Spindles and axes that turned or moved by themselves.
    pub turned: StoppedSpindles,
}

/// Stops of a run and the way on: the state of the machine, and the place to come back to.
pub(crate) struct RunStops<'a, I> {
    pub station: Station<'a, I>,
    /// State of the machine. A job, or a move by hand, knows more of it.
    pub state: State,
    /// Place to which a run that was stopped comes back.
    pub kept: ReturnPlace,
    /// The operator took the tool out of the cut while the program waits.
    pub away: bool,
    /// End of the run that came while the machine moved beside the program.
    pub ends: Option<RunEnd>,
    /// A job has switched off what it leaves.
    settled: bool,
    pub limits: LimitPolicy,
}

impl<'a, I> RunStops<'a, I> {
    /// Makes the stops of a run that has not begun.
    pub fn new(station: Station<'a, I>, limits: LimitPolicy) -> Self {
        let (state, kept) = (State::Idle, ReturnPlace::default());
        Self { station, state, kept, away: false, ends: None, settled: false, limits }
    }
}

impl<I: Interpreter> RunStops<'_, I> {
    /// Asks the table what follows on an event and does it. What is not in the table does not happen.
    pub(crate) fn on(&mut self, event: StateEvent, settings: StopSettings, why: &str) {
        let Some(next) = self.state.on(event, settings) else { return };
        self.state = next.state;
        // What a run leaves on is settled before anybody is told that it is over.
        let (settled, others): (Vec<_>, Vec<_>) =
            next.effects.into_iter().partition(|effect| *effect == Effect::LeaveOutputs);
        settled.into_iter().for_each(|effect| self.carry_out(effect));
        if !matches!(
            event,
            StateEvent::Start | StateEvent::Ready | StateEvent::End | StateEvent::Stop
        ) {
            let (state, t) = (next.state.name().into(), self.station.world.now());
            self.station.world.tell(&Event::State { state, why: why.into(), t });
        }
        others.into_iter().for_each(|effect| self.carry_out(effect));
        self.station.world.tell_log();
    }

    pub(crate) fn carry_out(&mut self, effect: Effect) {
        match effect {
            // The planner has done the slowing down.
            Effect::SlowDown | Effect::Halt => self.station.world.model.stopped(),
            Effect::KeepPlace => self.keep_place(),
            Effect::SpindleOff => self.stop_spindles(),
            Effect::Raise => {
                self.lift();
                // The way back is as high although something ended the lift early.
                let lifted_mm = self.station.lift_mm().unwrap_or(f64::NEG_INFINITY);
                self.kept.lifted_mm = lifted_mm.max(self.station.world.model.position()[Axis::Z]);
            }
            Effect::AllOff => self.station.world.model.outputs_off(),
            Effect::MotorsOff => self.station.cut_power(),
            Effect::Doubt => self.station.doubt(),
            Effect::ComeBack => self.come_back(),
            // A job knows what it leaves on: nothing.
            Effect::LeaveOutputs if self.station.interpreter.takes_stops() => {
                let last = self.last_commands(Status::Stopped);
                last.into_iter().for_each(|sourced| self.station.world.perform(sourced.command));
                self.station.world.tell_log();
            }
            // Of part files outputs follow their modes, at the end of the file too; their heights stay.
            Effect::LeaveOutputs
            | Effect::CutOff
            | Effect::CutOffAtOnce
            | Effect::RouterOff
            | Effect::ToolOff
            | Effect::RestoreHeights => {}
        }
    }

    /// Returns the commands of the program for the end of its run. A job leaves nothing on, however it ends; that is
    /// settled once.
    pub(crate) fn last_commands(&mut self, status: Status) -> Vec<Sourced> {
        let mut last = Vec::new();
        let is_job = self.station.interpreter.takes_stops();
        if is_job && std::mem::replace(&mut self.settled, true) {
            return last;
        }
        match status {
            Status::Limit => {
                drop(self.station.interpreter.limit(&mut self.station.world, &mut last))
            }
            Status::Stopped => {
                drop(self.station.interpreter.stop(&mut self.station.world, &mut last))
            }
            _ if is_job => drop(self.station.interpreter.stop(&mut self.station.world, &mut last)),
            Status::Ok | Status::Ended | Status::Failed => {}
        }
        last
    }

    fn keep_place(&mut self) {
        self.station.tell_standing(flag::STOPPED);
        self.station.world.tracked().land();
        let stood = self.station.world.model.position();
        let ahead = self.station.mover.position();
        self.kept =
            ReturnPlace { stood, ahead, lifted_mm: stood[Axis::Z], ..ReturnPlace::default() };
    }

    /// Stops what turns; it comes on again with what was stopped before.
    pub(crate) fn stop_spindles(&mut self) {
        self.station.world.stop_turning();
        self.keep_turning();
    }

    /// Keeps what a stop input stopped meanwhile, which comes on again when the run goes on.
    pub(crate) fn keep_turning(&mut self) {
        let StoppedSpindles { spindles, alone } = std::mem::take(&mut self.station.world.stopped);
        self.kept.turned.add(spindles, alone);
    }

    /// Goes on where the machine stood, from wherever the operator moved it: what a stop switched off
    /// comes on again, then over the place at the height to which the tool was lifted, or higher, and
    /// down. What was planned follows the workpiece.
    fn come_back(&mut self) {
        let ReturnPlace { stood, ahead, lifted_mm, nudged, turned } =
            std::mem::take(&mut self.kept);
        let moved = self.station.world.model.position() != stood.plus(nudged);
        self.station.world.model.resumed();
        if moved {
            let until_s = self.station.world.model.warn();
            self.station.world.tell_log();
            self.ends = self.stand_heeding(until_s).err();
        }
        self.station.world.tell_log();
        self.station.world.tell(&Event::Resume { t: self.station.world.now() });
        // What somebody nudges when it is stopped on the way back moves what is ahead too.
        let before = self.station.nudged.unwrap_or_default();
        if self.ends.is_none() {
            self.turn_again(turned);
        }
        if moved {
            let nudged = nudged.plus(self.station.nudged.unwrap_or_default().minus(before));
            self.go_back_to(stood.plus(nudged), lifted_mm + nudged[Axis::Z]);
        }
        let on_the_way = self.station.nudged.unwrap_or_default().minus(before);
        self.station.shift(nudged);
        self.station.mover.set_position(ahead.plus(nudged).plus(on_the_way));
        self.station.tell_standing(0);
    }

    /// Spindles turn again, and have the time that the machine gives them to come to speed.
    pub(crate) fn turn_again(&mut self, StoppedSpindles { spindles, alone }: StoppedSpindles) {
        for (axis, motion) in alone {
            self.station.world.model.independent(axis, motion);
        }
        for number in &spindles {
            self.station.world.model.output(*number, true, OutputReason::Mode);
        }
        if !spindles.is_empty() {
            self.station.world.workspace.set_value(SPINDLE_STATUS, Some("1"));
            self.come_to_speed();
        }
    }

    /// Waits as long as the machine gives a spindle to come to speed.
    pub(crate) fn come_to_speed(&mut self) {
        self.station.world.tell_log();
        let seconds = self.station.world.machine_is.delays.router_start_s;
        if seconds > 0.0 && !self.station.world.model.draws() && self.ends.is_none() {
            let t = self.station.world.now();
            self.station.world.tell(&Event::Wait { seconds, t });
            self.ends = self.stand_heeding(t + seconds).err();
        }
    }

    /// The emergency stop of a machine that cuts its power: spindles at once, motors later. Nothing goes
    /// on from there.
    pub(crate) fn power_is_cut(&mut self) -> RunEnd {
        let message = "emergency stop";
        self.on(StateEvent::PowerCut, StopSettings::OPENSBP, message);
        self.station.world.workspace.set_value(SPINDLE_STATUS, Some("0"));
        let hint = "home the machine, or set its locations, before anything is cut";
        self.station
            .over(Status::Stopped, Code::InputStop, self.station.last_move, message.to_owned())
            .hint(hint)
    }

    /// The emergency stop that jobs have: a part file ends there, with everything off.
    pub(crate) fn emergency(&mut self) -> RunEnd {
        // Whoever pressed it wants nothing to move.
        let settings = StopSettings { raise: false, ..StopSettings::OPENSBP };
        let why = "emergency stop";
        self.station.world.workspace.tape.stops_at_input(Input::EmergencyStop.number());
        self.on(StateEvent::EmergencyStop, settings, why);
        self.stop_spindles();
        self.on(StateEvent::Stands, settings, why);
        self.on(StateEvent::Abort, settings, why);
        self.station.world.workspace.tape.given_up(self.station.world.placed());
        let mut over = self.station.over(
            Status::Stopped,
            Code::InputStop,
            self.station.last_move,
            why.to_owned(),
        );
        let hint = "release it; the location is known, and the run can be taken up";
        over.diagnostic = over.diagnostic.map(|why| Box::new((*why).hint(hint)));
        over
    }

    /// A motor has stalled: nobody knows how many steps are lost.
    pub(crate) fn has_stalled(&mut self) -> RunEnd {
        let message = "a motor has stalled";
        self.station.world.model.stalled();
        self.on(StateEvent::Stall, StopSettings::OPENSBP, message);
        self.station.over(
            Status::Failed,
            Code::InputStop,
            self.station.last_move,
            message.to_owned(),
        )
    }

    /// The controller does not answer any more.
    pub(crate) fn link_is_lost(&mut self) -> RunEnd {
        if let Some(failure) = self.station.drive.fault().cloned() {
            return self.fails(&failure);
        }
        self.on(StateEvent::LinkLost, StopSettings::OPENSBP, "not connected");
        self.station.not_connected(self.station.last_move)
    }

    /// The controller does not follow any more: where it stands is what it told last.
    pub(crate) fn fails(&mut self, failure: &Fault) -> RunEnd {
        self.station.drive.stands();
        if let Some(stands) = failure.stands {
            self.station.world.model.put(stands);
            self.station.mover.set_position(stands);
        }
        if let Some(made_s) = failure.made_s {
            return self.breaks_off(failure, made_s);
        }
        self.on(StateEvent::LinkLost, StopSettings::OPENSBP, &failure.message);
        let at = failure.at.unwrap_or(self.station.last_move);
        let code = if failure.silent { Code::NotConnected } else { Code::Controller };
        self.station.over(Status::Failed, code, at, failure.message.clone()).hint(failure.hint)
    }

    /// An input has stopped the machine at a moment, and it stands with everything off: the run ends there.
    fn breaks_off(&mut self, failure: &Fault, made_s: f64) -> RunEnd {
        let settings = StopSettings { raise: false, ..StopSettings::OPENSBP };
        self.on(StateEvent::EmergencyStop, settings, &failure.message);
        self.stop_spindles();
        self.on(StateEvent::Stands, settings, &failure.message);
        self.on(StateEvent::Abort, settings, &failure.message);
        self.station.world.workspace.tape.broke_off(made_s, self.station.world.placed());
        let at = failure.at.unwrap_or(self.station.last_move);
        let over = self.station.over(Status::Stopped, Code::InputStop, at, failure.message.clone());
        over.hint(failure.hint)
    }

    /// The emergency stop ends a part file as soon as it is pressed; where the power went then, it is what it
    /// is when the tool goes back.
    pub(crate) fn heed_emergency(&mut self) -> Result<(), RunEnd> {
        match self.station.world.model.stop_input() {
            Some(n) if self.station.cuts_power(n) && !self.station.is_open_for_take_up() => {
                Err(self.power_is_cut())
            }
            _ if self.station.is_ended_by_press() => self.heed_press(),
            _ => Ok(()),
        }
    }

    /// The same where it is known to be pressed, or was for a moment.
    pub(crate) fn heed_press(&mut self) -> Result<(), RunEnd> {
        if self.station.is_open_for_take_up() { Ok(()) } else { Err(self.emergency()) }
    }
}
