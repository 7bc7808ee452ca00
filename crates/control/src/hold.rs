//! A run that the operator stopped in the middle: what may be done until it goes on or is given up.
//!
//! ```text
//!  stop: ramp down ─► lift to Safe-Z ─► ask ─► Resume: back over it and down, on along the path
//!                                        │ ▲
//!                             nudge, jog └─┘    Quit: the run is over
//! ```
//!
//! A nudge moves the tool and the working zero alike: whatever is cut next is shifted, and what the
//! display calls the place stays (command reference, MN).

use crate::by_hand::Jog;
use crate::nudge::Nudge;
use crate::runner::{Over, Runner};
use kerf_diag::{Code, Diagnostic, Place, Severity};
use kerf_machine::state::{Event as Stopped, StopSettings};
use kerf_program::{
    Answer, Axes, Axis, AxisSet, Button, Interpreter, MoveKind, Question, QuestionKind, Status,
};
use kerf_trace::Event;

/// A script of answers that says nothing but Resume does not hold a run for ever.
const MOST_REFUSALS: u32 = 1000;

/// Answer of the operator about a run that is stopped.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Said {
    Resume,
    Quit,
    /// A nudge or a jog, when it is one.
    Words(String),
}

impl<I: Interpreter> Runner<'_, I> {
    /// The operator stopped the machine, which stands; unless the run goes on.
    pub(crate) fn hold(&mut self) -> Result<(), Over> {
        let settings = StopSettings::OPENSBP;
        self.drive.heard();
        self.world.tell(&Event::Stop { by: "operator", n: 0, t: self.world.now() });
        self.heed_emergency()?;
        self.on(Stopped::Stop, settings, "");
        self.on(Stopped::Stands, settings, "");
        self.heeded()?;
        self.stopped_meanwhile()?;
        let (resumed, nudged) = self.until_resumed(&hold_question());
        self.kept.nudged = nudged;
        if resumed.is_err() {
            self.on(Stopped::Abort, settings, "");
            // Whatever is run next is cut where the workpiece is now.
            self.shift(nudged);
            self.world.workspace.tape.given_up(self.world.placed());
        }
        resumed?;
        self.world.workspace.tape.goes_on();
        self.on(Stopped::Continue, settings, "");
        self.heeded()
    }

    /// A stop input that came while the machine slowed down stops what turns as well.
    pub(crate) fn stopped_meanwhile(&mut self) -> Result<(), Over> {
        match self.world.machine.stop_input() {
            Some(n) if self.cuts_power(n) => Err(self.power_is_cut()),
            Some(_) if self.world.machine.turns() => {
                self.stop_spindles();
                self.world.tell_log();
                Ok(())
            }
            _ => Ok(()),
        }
    }

    /// Goes back to a place, from wherever the operator moved the machine: over it at a height, or
    /// higher, then down.
    pub(crate) fn go_back_to(&mut self, stood: Axes, lifted_mm: f64) {
        let mut above = self.world.machine.position();
        above[Axis::Z] = above[Axis::Z].max(lifted_mm);
        let mut over = stood;
        over[Axis::Z] = above[Axis::Z];
        let before = self.nudged.unwrap_or_default();
        for (kind, to) in [(MoveKind::Jog, above), (MoveKind::Jog, over), (MoveKind::Cut, stood)] {
            let on_the_way = self.nudged.unwrap_or_default().minus(before);
            self.go(kind, to.plus(on_the_way));
        }
    }

    /// Does what the operator says until the run goes on, or is given up. With it goes the sum of all
    /// nudges.
    pub(crate) fn until_resumed(&mut self, question: &Question) -> (Result<(), Over>, Axes) {
        let mut nudged = Axes::default();
        loop {
            match self.ask_whoever_stopped(question) {
                Err(over) => return (Err(over), nudged),
                Ok(Said::Resume) => return (Ok(()), nudged),
                Ok(Said::Quit) => {
                    return (Err(Over { status: Status::Stopped, diagnostic: None }), nudged);
                }
                Ok(Said::Words(words)) => {
                    if let Some(nudge) = Nudge::read(&words) {
                        nudged = nudged.plus(self.nudge(nudge));
                        if let Err(over) = self.heeded() {
                            return (Err(over), nudged);
                        }
                    } else if let Some(jog) = Jog::read(&words) {
                        self.jog(jog);
                    }
                }
            }
        }
    }

    /// Asks what follows on a stop: nothing goes on as long as a stop input is active. Where the power went
    /// before the answer, it is asked when the machine goes back, whether all is ready.
    pub(crate) fn ask_whoever_stopped(&mut self, question: &Question) -> Result<Said, Over> {
        for _ in 0..MOST_REFUSALS {
            if self.is_open_for_take_up() {
                return Ok(Said::Resume);
            }
            self.heed_emergency()?;
            let answer = self.ask(question, self.last_move)?;
            self.heed_emergency()?;
            match answer {
                Answer::Text(words) => return Ok(Said::Words(words)),
                Answer::Button(Button::Resume) if self.is_forbidden() => {}
                Answer::Button(Button::Resume) => return Ok(Said::Resume),
                // The power went before the run was given up.
                Answer::Button(_) if self.is_open_for_take_up() => return Ok(Said::Resume),
                Answer::Button(_) => break,
            }
        }
        Ok(Said::Quit)
    }

    /// Nudges as the operator says it, in his units. Tells how far, machine frame; nowhere when
    /// something forbids it.
    fn nudge(&mut self, nudge: Nudge) -> Axes {
        let Nudge { axis, distance } = nudge;
        let nudge = Nudge { axis, distance: distance * self.world.scale(axis) };
        let position = self.world.machine.position();
        let (settings, mut frame) = (self.world.machine.settings(), *self.world.machine.frame());
        let refused = if self.interpreter.takes_stops() {
            Some((Code::NotSupported, "a job is not nudged: move its origin".to_owned()))
        } else if self.world.machine.draws() {
            Some((Code::NotSupported, "nothing is nudged while commands are only drawn".to_owned()))
        } else {
            let within = nudge.check(settings, &frame, position);
            let within = within.and_then(|()| nudge.within(self.room_by_hand(axis), position));
            within.err().map(|outside| (Code::OutsideLimits, outside.to_string()))
        };
        if let Some((code, why)) = refused {
            self.tell_refused(code, why);
            return Axes::default();
        }
        frame.working_zero = frame.working_zero.plus(nudge.way());
        self.world.machine.use_frame(frame, AxisSet::EMPTY);
        self.world.tracked().begin_motion();
        self.world.tell_log();
        self.go(MoveKind::Jog, position.plus(nudge.way()));
        self.world.tell_base(AxisSet::EMPTY.with(axis));
        nudge.way()
    }

    fn tell_refused(&mut self, code: Code, why: String) {
        let place = Place::line(self.world.file(self.last_move), self.last_move.line);
        let diagnostic = Diagnostic::new(code, place, why);
        self.world.tell_diagnostic(diagnostic.severity(Severity::Warning));
    }

    /// Everything that was planned and not made follows the workpiece.
    pub(crate) fn shift(&mut self, by: Axes) {
        if by == Axes::default() {
            return;
        }
        self.stack.stand_back();
        self.stack.shift(by);
        self.interpreter.nudge(by);
        self.nudged = Some(self.nudged.unwrap_or_default().plus(by));
    }

    /// Lifts the tool to safe Z when it is lower (command reference, stopping).
    pub(crate) fn lift(&mut self) {
        let mut to = self.world.machine.position();
        let Some(safe_mm) = self.lift_mm() else { return };
        if to[Axis::Z] < safe_mm {
            to[Axis::Z] = safe_mm;
            self.go(MoveKind::Jog, to);
        }
    }

    /// Returns the height to which the tool is lifted, machine frame.
    pub(crate) fn lift_mm(&self) -> Option<f64> {
        let safe_mm = self.world.machine.settings().cutter.safe_z_mm?;
        Some(self.world.machine.frame().working_zero[Axis::Z] + safe_mm)
    }
}

fn hold_question() -> Question {
    Question {
        kind: QuestionKind::Hold,
        text: "Stopped. Resume, Quit, or nudge the workpiece (nudge y .05)".into(),
        title: "Stopped".into(),
        buttons: vec![Button::Resume, Button::Quit],
        default: 1,
        prefill: String::new(),
        icon: 0,
        until: None,
    }
}
