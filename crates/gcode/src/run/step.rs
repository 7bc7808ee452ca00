//! One line at a time.

use super::Core;
use super::context::{Context, Stop};
use super::controllers;
use super::core::{Call, CallKind};
use crate::syntax::dialect::Dialect;
use crate::syntax::gathered::{Fault, Gathered};
use crate::syntax::tree::{Block, Node, Program, Setting, Span, Target, Value};
use kerf_diag::Code;
use kerf_program::{At, Command, Host, Sourced, Status, Step};
use std::sync::Arc;

/// Executes one line, or what a step is left to do of an earlier one.
pub(super) fn step(core: &mut Core, host: &mut dyn Host, out: &mut Vec<Sourced>) -> Step {
    if !core.started {
        core.started = true;
        core.calls.push(Call::new(0, 0, CallKind::Main));
        let mut c = Context { core, host, out, at: At::default(), span: Span::default() };
        c.relocate();
        let outcome = c.begin_at();
        return finish(&mut c, outcome, 0);
    }
    if core.only_is_done() && !core.over {
        return Step::Done(Status::Ok, None);
    }
    let (file, next) = core.calls.last().map_or((0, 0), |c| (c.file, c.next));
    let program = core.programs.get(file as usize).cloned().unwrap_or_default();
    let node = program.line(next + 1).map(|l| l.node());
    let at = At { file, line: if node.is_some() { next + 1 } else { next } };
    if node.is_some() && core.options.max_lines > 0 && core.lines >= core.options.max_lines {
        return too_many_lines(core, host, out, at);
    }
    let given = out.len();
    let mut c = Context { core, host, out, at, span: Span::default() };
    let outcome = c.next(&program, node);
    finish(&mut c, outcome, given)
}

/// Turns the outcome of a line into a step.
fn finish(c: &mut Context<'_>, outcome: Result<(), Stop>, given: usize) -> Step {
    if matches!(outcome, Err(Stop::Failed(_))) {
        c.core.changing = false;
    }
    match outcome {
        Ok(()) | Err(Stop::Again) => Step::Ran,
        Err(Stop::Waiting) => {
            c.out.truncate(given);
            Step::Waiting
        }
        Err(Stop::Failed(diagnostic)) if c.core.options.keep_going => {
            c.core.told.motion_lost = true;
            c.emit(Command::Diagnostic(diagnostic));
            Step::Ran
        }
        Err(Stop::Failed(diagnostic)) => {
            c.core.abandon();
            Step::Done(Status::Failed, Some(diagnostic))
        }
        Err(Stop::Finished(status)) => {
            c.core.abandon();
            Step::Done(status, None)
        }
    }
}

fn too_many_lines(core: &mut Core, host: &mut dyn Host, out: &mut Vec<Sourced>, at: At) -> Step {
    let bound = core.options.max_lines;
    let c = Context { core, host, out, at, span: Span::default() };
    let diagnostic = c
        .diagnostic(Span::default(), Code::LineLimit, format!("stopped after {bound} lines"))
        .hint("is there a loop that never ends? --max-lines raises the bound");
    core.abandon();
    Step::Done(Status::Limit, Some(Box::new(diagnostic)))
}

impl Core {
    /// The run is over, whatever was under way.
    pub(super) fn abandon(&mut self) {
        self.position = self.tool_position();
        self.compensator = None;
        self.beside = None;
        self.probing = None;
        self.holding = None;
        self.retracting = None;
        self.over = true;
    }
}

impl Context<'_> {
    fn next(&mut self, program: &Arc<Program>, node: Option<Node>) -> Result<(), Stop> {
        if self.core.probing.is_some() {
            return self.end_probe();
        }
        if self.core.over {
            self.end_compensation()?;
            self.settle()?;
            return Err(Stop::Finished(Status::Ok));
        }
        let Some(node) = node else { return self.end_of_file() };
        if self.core.holding.is_none() && self.steps_over(program, node)? {
            return Ok(());
        }
        self.core.lines += 1;
        self.go_on_at(self.at.line);
        let outcome = match self.core.holding.clone() {
            Some(text) => self.hold(&text).and_then(|()| self.retract_by_hand()),
            None => self.node(program, node),
        };
        // A block that holds the program is the one at hand until somebody has answered.
        let holds = outcome.is_ok() && self.core.holding.is_some();
        if holds || matches!(outcome, Err(Stop::Waiting | Stop::Again)) {
            self.core.lines -= 1;
            self.go_on_at(self.at.line - 1);
        } else {
            self.core.line_ran();
        }
        outcome
    }

    /// Chooses the line (by index) that the innermost call goes on at.
    pub(super) fn go_on_at(&mut self, index: u32) {
        if let Some(call) = self.core.calls.last_mut() {
            call.next = index;
        }
    }

    fn node(&mut self, program: &Arc<Program>, node: Node) -> Result<(), Stop> {
        match node {
            Node::Blank => Ok(()),
            Node::Move => {
                self.span = whole_line(program, self.at.line);
                let plain = program.move_of(self.at.line).unwrap_or_default();
                self.execute(&Gathered::of_move(&plain))
            }
            Node::Block(index) => match program.blocks.get(index as usize) {
                Some(block) => self.block(program, *block),
                None => Ok(()),
            },
            Node::Percent => self.percent(program),
            Node::Console => self.console(program),
            Node::Bad => self.bad(program),
        }
    }

    fn block(&mut self, program: &Arc<Program>, block: Block) -> Result<(), Stop> {
        if block.delete > 0 && block.delete <= self.core.options.block_delete {
            return Ok(());
        }
        self.span = whole_line(program, self.at.line);
        let extra = program.extra_of(&block);
        if let Some(flow) = extra.and_then(|e| e.flow.as_ref()) {
            self.need_words(controllers::O_WORDS)?;
            self.comments(program, extra)?;
            return self.flow(program, flow);
        }
        let gathered = self.gather(program, &block)?;
        self.begin_tool_change(&gathered)?;
        let settings = match extra {
            Some(extra) if !extra.settings.is_empty() => {
                self.need_words(kind_of(&extra.settings))?;
                self.evaluate_settings(program, &extra.settings)?
            }
            _ => Vec::new(),
        };
        let told = self.out.len();
        self.comments(program, extra)?;
        let outcome = if block.words.0 == block.words.1 { Ok(()) } else { self.execute(&gathered) };
        if matches!(outcome, Err(Stop::Waiting)) {
            self.out.truncate(told);
            return outcome;
        }
        self.assign(program, settings)?;
        outcome
    }

    /// The words of a block with the values of now.
    pub(super) fn gather(
        &mut self,
        program: &Arc<Program>,
        block: &Block,
    ) -> Result<Gathered, Stop> {
        let words = program.words_of(block);
        if !block.computed {
            let value = |w: &crate::syntax::tree::Word| match w.value {
                Value::Number(n) => Ok(n),
                Value::Computed(_) => Ok(0.0),
            };
            return Ok(Gathered::of(words, value, |_| {}));
        }
        self.need_words(controllers::EXPRESSIONS)?;
        let mut first = None;
        let gathered = {
            let (core, span) = (&*self.core, self.span);
            let value = |w: &crate::syntax::tree::Word| match w.value {
                Value::Number(n) => Ok(n),
                Value::Computed(index) => match program.exprs.get(index as usize) {
                    Some(expr) => core.evaluate(program, expr, w.span),
                    None => Ok(0.0),
                },
            };
            let gathered = Gathered::of(words, value, |f| {
                first.get_or_insert(f);
            });
            gathered.needs(span, &mut |f| {
                first.get_or_insert(f);
            });
            gathered
        };
        match first {
            Some(fault) => Err(self.faulty(fault)),
            None => Ok(gathered),
        }
    }

    /// grbl itself has no expressions and no O-words, Mach3 no O-words.
    fn need_words(&self, what: &str) -> Result<(), Stop> {
        let dialect = self.core.options.dialect;
        if !controllers::lacks_words(dialect, what) {
            return Ok(());
        }
        let message = format!("{} has no {what}", dialect.title());
        Err(self.fail(Code::NotInDialect, message, "run it with --dialect linuxcnc"))
    }

    /// `%`: the first line of a file, or its end.
    fn percent(&mut self, program: &Program) -> Result<(), Stop> {
        let mut others = program.lines.others();
        let begins = (0..self.at.line - 1).all(|index| {
            let (line, node) = others.next().unwrap_or((index, Node::Bad));
            line == index && (node == Node::Blank || is_comment(program, node))
        });
        if !begins {
            self.core.over = true;
        }
        Ok(())
    }

    fn console(&mut self, program: &Program) -> Result<(), Stop> {
        self.span = whole_line(program, self.at.line);
        let message = "a line for the controller's console is not run";
        let hint = "settings of a controller belong into its configuration, not into a part";
        if self.core.options.dialect == Dialect::LinuxCnc {
            let hint = "lines with $ are grbl's; run it with --dialect grbl";
            return Err(self.fail(Code::ConsoleLine, message, hint));
        }
        if !std::mem::replace(&mut self.core.told.console, true) {
            self.warn(Code::ConsoleLine, message, hint);
        }
        Ok(())
    }

    /// A line that the reader refused.
    pub(super) fn bad(&mut self, program: &Program) -> Result<(), Stop> {
        if self.core.options.keep_going {
            self.core.told.motion_lost = true;
            return Ok(());
        }
        let line = self.at.line;
        let known = program.diagnostics.iter().find(|d| d.place.line == line && d.is_error());
        Err(match known.or(program.diagnostics.first()) {
            Some(diagnostic) => Stop::Failed(Box::new(diagnostic.clone())),
            None => self.faulty(Fault::new(Code::BadBlock, self.span, "this line cannot be read")),
        })
    }
}

fn is_comment(program: &Program, node: Node) -> bool {
    let Node::Block(index) = node else { return false };
    let block = program.blocks.get(index as usize);
    block.is_some_and(|b| {
        b.words.0 == b.words.1
            && program.extra_of(b).is_none_or(|e| e.settings.is_empty() && e.flow.is_none())
    })
}

/// The kind of parameters that a line sets.
fn kind_of(settings: &[Setting]) -> &'static str {
    let named = settings.iter().any(|setting| matches!(setting.target, Target::Named(_)));
    if named { controllers::NAMED } else { controllers::NUMBERED }
}

/// The code of a line, blanks around it left out.
pub(super) fn whole_line(program: &Program, line: u32) -> Span {
    let text = program.line_text(line);
    let code = text.trim_start();
    Span { start: (text.len() - code.len()) as u32, end: text.trim_end().len() as u32 }
}
