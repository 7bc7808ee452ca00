//! Running one stack of moves on the machine.

use crate::event::{ArcEvent, Centre, Event, MoveEvent};
use crate::runner::{Over, Runner};
use crate::session::LimitPolicy;
use crate::sink::Made;
use crate::stack::Stack;
use kerf_diag::{Code, Diagnostic, Place};
use kerf_motion::{Model, Move, Optimal, Path, Plan, Profiler, plan_stack};
use kerf_program::{
    Answer, At, Axes, Axis, Button, Command, Interpreter, Question, QuestionKind, RampModel,
    Settings, Sourced, Status,
};
use kerf_sbp::SPINDLE_STATUS;
use kerf_sim::{Halt, HaltCause, Violation};
use std::iter::Peekable;
use std::vec::IntoIter;

/// What is told when the interlock forbids motion or a spindle.
const ENCLOSURE_OPEN: &str = "enclosure open";

/// Why a stack did not run to its end.
#[derive(Debug)]
pub(crate) enum Halted {
    /// A watched input; its index among the watches, and the motion that was interrupted.
    Watch { index: usize, number: Option<u64> },
    /// The run is over.
    Over(Over),
}

/// Where a stack stopped.
struct Stopped {
    /// Index of the move in which the machine stands.
    index: usize,
    /// What was not made.
    rest: Vec<Move>,
    halt: Option<Halt>,
}

type Marks = Peekable<IntoIter<(usize, Sourced)>>;

impl<I: Interpreter> Runner<'_, I> {
    /// Runs a stack; `None` when all of it was made.
    pub(crate) fn execute(&mut self, mut stack: Stack) -> Option<Halted> {
        loop {
            if let Err(over) = self.check(&stack.moves) {
                return Some(Halted::Over(over));
            }
            let count = stack.moves.len();
            let mut marks = std::mem::take(&mut stack.marks).into_iter().peekable();
            let moves = std::mem::take(&mut stack.moves);
            let stopped = match self.make(moves, &mut marks) {
                Ok(()) => return None,
                Err(stopped) => stopped,
            };
            let number = stack.numbers.get(stopped.index).copied();
            let nudged = match self.answer_halt(stopped.halt, number) {
                Ok(nudged) => nudged,
                Err(halted) => return Some(halted),
            };
            stack = stack.after(count - stopped.rest.len(), stopped.rest, marks);
            stack.moves.iter_mut().for_each(|made| made.shift(nudged));
        }
    }

    /// Nothing moves that would leave the table, or while a stop input is active.
    fn check(&mut self, moves: &[Move]) -> Result<(), Over> {
        let Some(first) = moves.first() else { return Ok(()) };
        if self.lists_limits() {
            self.list_violations(moves);
        } else if let Some(violation) = self.world.machine.first_outside(moves) {
            self.ask_about_limit(moves, &violation)?;
        }
        match self.world.machine.stop_input() {
            None => Ok(()),
            Some(input) => {
                let message = match self.world.machine.open_enclosure() {
                    Some(_) => ENCLOSURE_OPEN.into(),
                    None => format!("stop input {input} is active: nothing may move"),
                };
                Err(self.over(Status::Stopped, Code::InputStop, first.at, message))
            }
        }
    }

    /// Nothing is asked about what is only drawn.
    fn lists_limits(&self) -> bool {
        self.limits == LimitPolicy::List || self.world.machine.draws()
    }

    fn list_violations(&mut self, moves: &[Move]) {
        for made in moves {
            let alone = std::slice::from_ref(made);
            if let Some(violation) = self.world.machine.first_outside(alone) {
                let message = self.limit_message(&violation);
                let place = Place::line(self.world.file(made.at), made.at.line);
                let diagnostic = Diagnostic::new(Code::OutsideLimits, place, message);
                self.world.tell_diagnostic(diagnostic);
            }
        }
    }

    fn ask_about_limit(&mut self, moves: &[Move], violation: &Violation) -> Result<(), Over> {
        let at = moves.get(violation.move_index).map_or(At::default(), |m| m.at);
        let message = self.limit_message(violation);
        let question = limit_question(message.clone());
        if self.ask(&question, at)? == Answer::Button(Button::Continue) {
            self.world.machine.override_limits();
            return Ok(());
        }
        Err(self.over(Status::Limit, Code::OutsideLimits, at, message))
    }

    fn limit_message(&self, violation: &Violation) -> String {
        let scale = self.world.scale(violation.axis);
        let [reached, limit] =
            [violation.reached, violation.limit].map(|v| kerf_sbp::format_number(v / scale));
        let letter = violation.axis.letter();
        format!(
            "{letter} would reach {reached}, the table limit is {limit} (table base coordinates)"
        )
    }

    /// Ends the run when a spindle would start in an open enclosure.
    pub(crate) fn spindle_refused(&self, sourced: &Sourced) -> Option<Over> {
        let starts = matches!(sourced.command, Command::Output { number: 1 | 2, on: true });
        let open = starts && self.world.machine.open_enclosure().is_some();
        let message = ENCLOSURE_OPEN.into();
        open.then(|| self.over(Status::Stopped, Code::InputStop, sourced.at, message))
    }

    fn over(&self, status: Status, code: Code, at: At, message: String) -> Over {
        let place = Place::line(self.world.file(at), at.line);
        let diagnostic = Diagnostic::new(code, place, message);
        Over { status, diagnostic: Some(Box::new(diagnostic)) }
    }

    /// Plans and makes moves until they are made or something stops them.
    fn make(&mut self, moves: Vec<Move>, marks: &mut Marks) -> Result<(), Stopped> {
        if moves.is_empty() {
            self.carry_out_marks(marks, usize::MAX);
            return Ok(());
        }
        let before_s = self.world.now();
        let t0_s = self.world.machine.begin_motion();
        self.world.tally.waited(t0_s - before_s);
        self.world.tell_log();
        let plan = plan(moves, self.world.machine.settings());
        let halt = self.world.machine.first_halt(t0_s + plan.duration_s(), &self.watched());
        let stopped = match halt {
            None => self.follow_plan(plan, t0_s, marks),
            Some(halt) => {
                let (plan, stopped) = cut(plan, halt.t_s - t0_s, halt.ramped);
                let operator = self.follow_plan(plan, t0_s, marks);
                operator.or(Some(Stopped { halt: Some(halt), ..stopped }))
            }
        };
        self.world.machine.rest();
        self.world.tell_log();
        match stopped {
            Some(stopped) => Err(stopped),
            None => {
                self.carry_out_marks(marks, usize::MAX);
                Ok(())
            }
        }
    }

    /// Makes moves that nothing stops.
    pub(crate) fn make_unasked(&mut self, moves: Vec<Move>) {
        let t0_s = self.world.now();
        let plan = plan(moves, self.world.machine.settings());
        for index in 0..plan.moves().len() {
            self.make_one(&plan, index, t0_s);
        }
    }

    /// Makes a plan, move by move; the operator may stop it.
    fn follow_plan(&mut self, mut plan: Plan, t0_s: f64, marks: &mut Marks) -> Option<Stopped> {
        let mut stopped = None;
        let mut index = 0;
        while index < plan.moves().len() {
            self.carry_out_marks(marks, index);
            let (begin_s, end_s) = plan.span_s(index);
            let [_, end_s] = self.moments(t0_s, [begin_s, end_s]);
            if stopped.is_none()
                && let Some(t_s) = self.pace.pass(self.world.now(), end_s)
            {
                let (rest, why) = cut(plan, (t_s - t0_s).max(0.0), true);
                plan = rest;
                stopped = Some(why);
                continue;
            }
            self.make_one(&plan, index, t0_s);
            index += 1;
        }
        stopped
    }

    /// When a part of a plan that started at `t0_s` begins and ends. What is only drawn takes no time.
    fn moments(&self, t0_s: f64, span_s: [f64; 2]) -> [f64; 2] {
        if self.world.machine.draws() { [self.world.now(); 2] } else { span_s.map(|s| t0_s + s) }
    }

    fn make_one(&mut self, plan: &Plan, index: usize, t0_s: f64) {
        let Some(span) = plan.span(index) else { return };
        self.last_move = span.made.at;
        self.trail.moves(span.made.at);
        let [begin_s, end_s] = self.moments(t0_s, [span.t0_s, span.t1_s]);
        if self.world.tells_motion() {
            let event = self.move_event(span.made, begin_s, end_s);
            self.world.tell(&event);
        }
        self.world.tell_made(&Made { plan, span: &span, t0_s });
        let frame = self.world.machine.frame();
        self.world.tally.made(span.made, end_s - begin_s, frame);
        self.world.machine.make(t0_s, plan, &span);
        self.world.tell_log();
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

    /// Carries out what is marked before a move of this index or an earlier one.
    fn carry_out_marks(&mut self, marks: &mut Marks, index: usize) {
        while let Some((_, sourced)) = marks.next_if(|(before, _)| *before <= index) {
            self.world.perform(sourced.command);
        }
    }

    /// What follows when motion was stopped: it goes on with the rest, shifted by so much, or not.
    fn answer_halt(&mut self, halt: Option<Halt>, number: Option<u64>) -> Result<Axes, Halted> {
        let t = self.world.now();
        let Some(halt) = halt else { return self.hold().map_err(Halted::Over) };
        let (by, n) = match halt.cause {
            HaltCause::Watch(index) => ("watch", self.watched().get(index).map_or(0, |w| w.input)),
            HaltCause::Limit(n) => ("limit", n),
            HaltCause::Stop(n) => ("stop", n),
        };
        self.world.tell(&Event::Stop { by, n, t });
        match halt.cause {
            HaltCause::Watch(index) => Err(Halted::Watch { index, number }),
            HaltCause::Limit(n) => {
                self.limit_input(n).map(|()| Axes::default()).map_err(Halted::Over)
            }
            HaltCause::Stop(n) => {
                self.world.machine.stopped(true);
                self.world.shelf.stored.set(SPINDLE_STATUS, Some("0"));
                self.world.tell_log();
                let message = match self.world.machine.open_enclosure() {
                    Some(_) => ENCLOSURE_OPEN.into(),
                    None => format!("stopped by stop input {n}"),
                };
                Err(Halted::Over(self.over(
                    Status::Stopped,
                    Code::InputStop,
                    self.last_move,
                    message,
                )))
            }
        }
    }

    fn limit_input(&mut self, n: u8) -> Result<(), Over> {
        let at = self.last_move;
        let message = format!("stopped by limit input {n}");
        let question = limit_question(message.clone());
        if self.ask(&question, at)? == Answer::Button(Button::Continue) {
            self.world.machine.override_limits();
            return Ok(());
        }
        Err(self.over(Status::Limit, Code::InputStop, at, message))
    }
}

/// Plans a stack with the model of motion in force.
fn plan(moves: Vec<Move>, settings: &Settings) -> Plan {
    let dynamics = &settings.axis_dynamics();
    match settings.model() {
        RampModel::Shopbot => plan_stack(moves, &settings.ramps),
        RampModel::Profiler => Profiler { dynamics, smoothing: &settings.smoothing }.plan(moves),
        RampModel::Optimal => Optimal { dynamics }.plan(moves),
    }
}

/// The part of a plan that is made when it is stopped at a time, and what is left.
fn cut(plan: Plan, t_s: f64, ramped: bool) -> (Plan, Stopped) {
    let Some(stop) = plan.stop(t_s, ramped) else {
        return (plan, Stopped { index: 0, rest: Vec::new(), halt: None });
    };
    let index = stop.move_index;
    let (plan, rest) = plan.cut(&stop);
    (plan, Stopped { index, rest, halt: None })
}

/// The axis in whose unit the speed of a move is told.
fn leading_axis(made: &Move) -> Axis {
    let moves = |axis: &Axis| made.from[*axis] != made.to[*axis];
    let arc = matches!(made.path, Path::Arc { .. });
    if arc { Axis::X } else { Axis::ALL.into_iter().find(moves).unwrap_or(Axis::X) }
}

fn limit_question(text: String) -> Question {
    Question {
        kind: QuestionKind::Limit,
        text,
        title: "Limits".into(),
        buttons: vec![Button::Continue, Button::End],
        default: 1,
        prefill: String::new(),
        icon: 48,
        until: None,
    }
}
