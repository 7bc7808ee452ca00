//! A file that is gone through line by line, or taken up in the middle.
//!
//! ```text
//!  ask ─┬─ Step: this line runs, ask again        go to N ─► lines before N are passed over, all
//!       ├─ Run: from here on without asking                  of them or only what they set up
//!       └─ Quit: the run ends
//! ```
//!
//! The question is a step of its own: its answer is kept until the line has run, because a line may
//! have to wait.

use super::Core;
use super::context::{Context, Stop};
use crate::syntax::codes::{
    ARC_DISTANCE, DISTANCE, FEED_MODE, MOTION, PATH, PLANE, RETURN, SYSTEM, TOOL_LENGTH, UNITS,
};
use crate::syntax::gathered::Gathered;
use crate::syntax::tree::{Block, Node, Program};
use kerf_diag::Code;
use kerf_program::{Answer, Button, GoTo, Question, QuestionKind, Status};
use std::sync::Arc;

/// The modes that lines set up for those behind them. Zeros (G10, G92), tools, spindle, outputs
/// and cutter compensation are not among them: they do something.
const MODES: [usize; 9] =
    [PLANE, DISTANCE, ARC_DISTANCE, FEED_MODE, UNITS, RETURN, SYSTEM, PATH, TOOL_LENGTH];

/// Way in which a file is gone through.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub(super) struct Stepping {
    /// The operator is asked before each line.
    pub(super) asks: bool,
    /// The operator let the next line run.
    granted: bool,
    /// Lines of the file before this index are passed over, but for what they set up.
    skip_to: Option<u32>,
}

impl Stepping {
    pub(super) const fn new(asks: bool) -> Self {
        Self { asks, granted: false, skip_to: None }
    }

    /// Returns `true` if lines run as in any file.
    pub(super) const fn is_off(&self) -> bool {
        !self.asks && self.skip_to.is_none()
    }
}

impl Core {
    /// A line ran: the next one is asked for again.
    pub(super) const fn line_ran(&mut self) {
        self.stepping.granted = false;
    }
}

impl Context<'_> {
    /// Begins at the line that the options name.
    pub(super) fn begin_at(&mut self) -> Result<(), Stop> {
        match self.core.options.from.take() {
            Some(to) => self.go_to(to),
            None => Ok(()),
        }
    }

    /// Asks about a line, or passes over it; false when it is to run.
    pub(super) fn steps_over(&mut self, program: &Arc<Program>, node: Node) -> Result<bool, Stop> {
        if self.core.stepping.is_off() {
            return Ok(false);
        }
        if let Some(to) = self.core.stepping.skip_to {
            if self.at.line <= to {
                // Behind a mistake too, so that a check comes to its end.
                self.go_on_at(self.at.line);
                self.set_up(program, node)?;
                return Ok(true);
            }
            self.core.stepping.skip_to = None;
        }
        let stepping = self.core.stepping;
        if !stepping.asks || stepping.granted || node == Node::Blank {
            return Ok(false);
        }
        self.ask_step(program)?;
        Ok(true)
    }

    fn ask_step(&mut self, program: &Program) -> Result<(), Stop> {
        let last = self.host.last_line(&program.name);
        let question = Question {
            kind: QuestionKind::Step,
            text: program.line_text(self.at.line).trim().into(),
            title: program.name.to_string(),
            buttons: vec![Button::Step, Button::Run, Button::Quit],
            default: 0,
            prefill: last.map_or_else(String::new, |line| line.to_string()),
            icon: 0,
            until: None,
        };
        match self.ask_at_once(&question)? {
            Answer::Button(Button::Step) => self.core.stepping.granted = true,
            Answer::Button(Button::Run) => self.core.stepping.asks = false,
            Answer::Button(_) => return Err(Stop::Finished(Status::Stopped)),
            Answer::Text(words) => {
                if let Some(to) = GoTo::read(&words, last) {
                    self.go_to(to)?;
                }
            }
        }
        Ok(())
    }

    fn go_to(&mut self, to: GoTo) -> Result<(), Stop> {
        let program = self.program();
        if to.line > program.line_count() {
            let message = format!("there is no line {} in {}", to.line, program.name);
            let hint = format!("its last line is {}", program.line_count());
            self.warn(Code::OutOfRange, message, hint);
            return Ok(());
        }
        if self.core.calls.len() == 1 && program.is_in_subroutine(to.line) {
            let message = format!("line {} lies in a subroutine", to.line);
            return Err(self.fail(Code::BadFlow, message, "begin at a line that calls it"));
        }
        let index = to.line - 1;
        self.core.stepping.skip_to = to.settings.then_some(index);
        match (to.settings, self.core.calls.last_mut()) {
            (false, Some(call)) => call.next = index,
            (true, Some(call)) if index < call.next => call.next = 0,
            _ => {}
        }
        Ok(())
    }

    /// Carries out what a line sets up for those behind it: modes, feed, speed, parameters.
    fn set_up(&mut self, program: &Arc<Program>, node: Node) -> Result<(), Stop> {
        match node {
            Node::Move => {
                let plain = program.move_of(self.at.line).unwrap_or_default();
                self.set_modes(&Gathered::of_move(&plain))
            }
            Node::Block(index) => match program.blocks.get(index as usize) {
                Some(block) => self.set_up_block(program, *block),
                None => Ok(()),
            },
            _ => Ok(()),
        }
    }

    fn set_up_block(&mut self, program: &Arc<Program>, block: Block) -> Result<(), Stop> {
        let extra = program.extra_of(&block);
        if block.delete > 0 && block.delete <= self.core.options.block_delete
            || extra.is_some_and(|e| e.flow.is_some())
        {
            return Ok(());
        }
        let gathered = self.gather(program, &block)?;
        let settings = match extra {
            Some(extra) => self.evaluate_settings(program, &extra.settings)?,
            None => Vec::new(),
        };
        self.set_modes(&gathered)?;
        self.assign(program, settings)
    }

    fn set_modes(&mut self, all: &Gathered) -> Result<(), Stop> {
        self.execute(&all.only(&MODES, b"FST"))?;
        if let Some(motion @ (0 | 10 | 20 | 30)) = all.g[MOTION] {
            self.core.state.modal.motion = Some(motion);
        }
        Ok(())
    }
}
