//! Movements by hand while a program waits: at the keypad that it opened (SK), or after a stop.
//!
//! They are answers to its question, which is asked again afterwards, until it gets another answer.

use crate::OperatorRequest;
use crate::hand_words::Jog;
use crate::interruption::Interruption;
use crate::run_end::RunEnd;
use crate::station::Station;
use kerf_diag::{Code, Diagnostic, SourcePlace};
use kerf_machine::Going;
use kerf_machine::hand::keypad_settings;
use kerf_machine::homing::{bounds_by_hand, words_of_end};
use kerf_machine::lines::Input;
use kerf_model::{HaltCause, Watched};
use kerf_motion::{Move, Mover, planner};
use kerf_program::{At, Axes, Axis, Feed, Interpreter, Line, MoveKind, Settings, Status};
use kerf_trace::Event;

impl<I: Interpreter> Station<'_, I> {
    /// Makes a move beside the program, until it is made or something stops it.
    pub(crate) fn drive(
        &mut self,
        made: Move,
        settings: &Settings,
        switches: &[Watched],
    ) -> Driven {
        self.world.workspace.tape.moves(true, self.world.placed());
        let watched = self.watched_by_hand(switches);
        if let Some(driven) = self.warn_by_hand(&watched) {
            self.stand();
            return driven;
        }
        let t0_s = self.world.now();
        let mut planner = planner(settings);
        planner.push(made);
        let mut turned: Option<(Interruption, Axes)> = None;
        while let Some(mut plan) = planner.finish() {
            self.world.tracked().follows(&plan, t0_s);
            let mut index = 0;
            while let Some(span) = plan.span(index) {
                let until = plan.moves().len();
                // No share of it is one of a move of the program, which is taken up at its own.
                let going = Going { plan: &plan, index, t0_s, until, part: 0.0, watches: &[] };
                let until = self.driven_until(&watched, going, turned.map(|(turn, _)| turn));
                let Some((t_s, turn)) = until else {
                    self.make_one(&plan, &span, t0_s, true);
                    index += 1;
                    continue;
                };
                let stood_s = self.brake(&going);
                let at_s = (t_s - t0_s).max(0.0);
                turned = Some((turn, plan.at(at_s).position));
                let ramps = (at_s, turn.is_ramped());
                let (at_s, ramped) =
                    stood_s.map_or(ramps, |stood_s| ((stood_s - t0_s).max(0.0), false));
                let Some((ramp_down, _)) = planner.stop(plan, at_s, ramped) else { break };
                self.world.tracked().replans(&ramp_down, t0_s, t_s);
                plan = ramp_down;
            }
            if turned.is_some() {
                break;
            }
        }
        self.stand();
        if turned.is_some() {
            self.learn_switched_off();
        }
        turned.map_or(Driven::There, |(turn, place)| Driven::by(turn, watched.len(), place))
    }

    /// Lets time pass to the end of a move, unless something stops the machine before. What stops already
    /// is not stopped again; what the operator wants meanwhile comes next.
    fn driven_until(
        &mut self,
        watched: &[Watched],
        going: Going<'_>,
        slows_for: Option<Interruption>,
    ) -> Option<(f64, Interruption)> {
        let end_s = going.t0_s + going.plan.span_s(going.index).1;
        if let Some(turn) = slows_for {
            self.slow_down(turn, end_s, going);
            return None;
        }
        loop {
            match self.meet(end_s, watched, Some(&going), Self::pass)? {
                (t_s, Interruption::Operator(request @ OperatorRequest::Feed(_))) => {
                    self.postpone((t_s, request));
                }
                turned => return Some(turned),
            }
        }
    }

    /// The switches that are sought first, then the emergency stop.
    fn watched_by_hand(&self, switches: &[Watched]) -> Vec<Watched> {
        let input = Input::EmergencyStop.number();
        let on = self.world.machine_is.estop.active;
        let emergency = Watched { input, on, ramped: true, level_from_s: None };
        switches.iter().copied().chain([emergency]).collect()
    }

    /// The same before a motion beside the program.
    fn warn_by_hand(&mut self, watched: &[Watched]) -> Option<Driven> {
        let turn = self.warn(watched)?;
        let here = self.world.model.position();
        Some(Driven::by(turn, watched.len(), here))
    }

    /// Moves until the way is made, a bound is reached, a limit switch stops it, or somebody lets go.
    /// Nothing of the program moves. A switch that is on already does not stop it again: whoever presses
    /// the key once more means it (command reference, VN).
    pub(crate) fn jog(&mut self, jog: Jog) {
        self.jog_until(jog, &[]);
    }

    /// The same until one of these switches changes; tells whether one did.
    pub(crate) fn jog_until(&mut self, jog: Jog, switches: &[Watched]) -> bool {
        let here = self.world.model.position();
        let (to, end) = self.within_bounds(here, jog.by);
        let line = Line { kind: MoveKind::Jog, to, feed: Feed::Axis };
        if self.world.model.draws() {
            return false;
        }
        if let Some(driven) = self.forbidden() {
            self.tell_driven(&driven, end);
            return false;
        }
        self.world.moved_by_hand();
        let settings = keypad_settings(self.world.model.settings(), jog.speed);
        let made = Mover::new(here, &settings).line(self.last_move, &line);
        let driven = made.map_or(Driven::There, |made| self.drive(made, &settings, switches));
        self.tell_driven(&driven, end);
        self.mover.set_position(self.world.model.position());
        matches!(driven, Driven::Edge(_))
    }

    /// Tells why a movement ended; a stop stops what turns as well.
    fn tell_driven(&mut self, driven: &Driven, end: Option<String>) {
        let said = match driven {
            Driven::There => end,
            Driven::Limit(n) => Some(format!("stopped by limit input {n}")),
            Driven::StopInput(n) => {
                self.world.stop_turning();
                self.world.tell_log();
                Some(format!("stopped by stop input {n}"))
            }
            Driven::OperatorRequest(request) => {
                self.heed_later(self.world.now(), *request);
                None
            }
            Driven::Stalled => Some("a motor has stalled".to_owned()),
            Driven::LinkLost => Some(self.why_lost()),
            Driven::EmergencyStop => {
                self.world.stop_turning();
                self.world.tell_log();
                Some("emergency stop".to_owned())
            }
            Driven::Edge(_) => None,
        };
        if let Some(text) = said {
            self.world.tell(&Event::Message { text: text.into(), t: self.world.now() });
        }
    }

    /// Letting go is done with; everything else is wanted of the program.
    fn heed_later(&mut self, t_s: f64, request: OperatorRequest) {
        if request != OperatorRequest::End {
            self.postpone((t_s, request));
        }
    }

    /// Returns the stop that forbids a movement by hand before it begins.
    pub(crate) fn forbidden(&self) -> Option<Driven> {
        let stop = self.world.model.stop_input().map(Driven::StopInput);
        stop.or_else(|| self.world.is_pressed().then_some(Driven::EmergencyStop))
    }

    /// The end of a way, or the first bound on it; and what is said at the bound.
    fn within_bounds(&self, from: Axes, by: Axes) -> (Axes, Option<String>) {
        let (mut share, mut said) = (1.0, None);
        for axis in Axis::ALL.into_iter().filter(|axis| by[*axis] != 0.0) {
            let (low, high) = self.room_by_hand(axis);
            let end = if by[axis] > 0.0 { high } else { low };
            let room = ((end - from[axis]) / by[axis]).max(0.0);
            if room < share {
                share = room;
                let shown = self.world.place(Axes::splat(end)).of(axis);
                let shown = kerf_sbp::format_number(shown);
                let words = words_of_end(&self.world.machine_is, axis, end);
                said = Some(format!("Out of bounds: {} ends at {shown}{words}", axis.letter()));
            }
        }
        (from.zip(by, |from, by| from + by * share), said)
    }

    /// Returns the lowest and the highest place to which an axis may be moved by hand, machine frame.
    pub(crate) fn room_by_hand(&self, axis: Axis) -> (f64, f64) {
        let (low, high) = self.world.model.room(axis);
        let homed = self.world.homed.contains(axis);
        let (lowest, highest) = bounds_by_hand(&self.world.machine_is, axis, homed);
        let (least, most) = self.drive.reach(axis).unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
        (low.max(lowest).max(least), high.min(highest).min(most))
    }

    /// Returns why the machine makes nothing more: what it tells itself, or that nothing is heard of it.
    fn why_lost(&self) -> String {
        self.drive.fault().map_or_else(|| "not connected".to_owned(), |fault| fault.message.clone())
    }

    /// Returns the end of a run whose motion by hand was stopped for good.
    pub(crate) fn interrupted(&self, driven: &Driven) -> RunEnd {
        let why = match driven {
            Driven::Limit(n) => format!("stopped by limit input {n}"),
            Driven::StopInput(n) => format!("stopped by stop input {n}"),
            Driven::EmergencyStop => "emergency stop".to_owned(),
            Driven::LinkLost => self.why_lost(),
            Driven::Stalled => "a motor has stalled".to_owned(),
            _ => return RunEnd::of(Status::Stopped),
        };
        let place = SourcePlace::line(self.world.file(At::default()), 0);
        let mut told = Diagnostic::new(Code::InputStop, place, why);
        if matches!(driven, Driven::StopInput(_) | Driven::EmergencyStop) {
            told = told.hint("release it: nothing moves before");
        }
        let diagnostic = Some(Box::new(told));
        let limit = matches!(driven, Driven::Limit(_));
        RunEnd { status: if limit { Status::Limit } else { Status::Stopped }, diagnostic }
    }
}

/// End of a motion by hand.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Driven {
    /// At its end.
    There,
    /// The switch that was sought changed there.
    Edge(Axes),
    /// The operator wants something.
    OperatorRequest(OperatorRequest),
    /// A limit input.
    Limit(u8),
    /// A stop input.
    StopInput(u8),
    /// The emergency stop.
    EmergencyStop,
    /// The controller does not answer any more.
    LinkLost,
    /// A motor has stalled.
    Stalled,
}

impl Driven {
    /// Translates the cause of a stop at a place; the last of so many watched inputs is the emergency stop, the others are
    /// sought.
    const fn by(turn: Interruption, watched: usize, place: Axes) -> Self {
        let halt = match turn {
            Interruption::Operator(request) => return Self::OperatorRequest(request),
            Interruption::Input(halt) => halt,
        };
        match halt.cause {
            HaltCause::Watch(n) if n + 1 < watched => Self::Edge(place),
            HaltCause::Watch(_) => Self::EmergencyStop,
            HaltCause::Limit(n) => Self::Limit(n),
            HaltCause::Stop(n) => Self::StopInput(n),
            HaltCause::LinkLost => Self::LinkLost,
            HaltCause::Stall => Self::Stalled,
        }
    }
}
