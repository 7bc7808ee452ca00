//! The effect of each statement. The larger families have files of their own.

use super::flow::Purpose;
use super::{Arguments, Context, Status, Stop, commands};
use crate::Expr;
use crate::Value;
use crate::table::{CommandSpec, Stack};
use crate::tree::{Arg, Assigned, NameId, Program, Statement, Target};
use kerf_diag::Code;
use kerf_program::{Command, ToolPathStart};
use std::sync::Arc;

/// GOSUBs within each other at most, in one file.
const MOST_GOSUBS: usize = 10_000;
/// The oldest GOSUBs that are forgotten then, where programs leave them by GOTO and never return.
const FORGOTTEN_GOSUBS: usize = 1_000;

impl Context<'_> {
    /// Executes a statement.
    pub(crate) fn statement(&mut self, statement: &Statement) -> Result<(), Stop> {
        // An assignment changes something where the value is another; a condition by what it looks at.
        self.core.idling.changes |= !matches!(
            statement,
            Statement::Goto(_)
                | Statement::If { .. }
                | Statement::Mention(_)
                | Statement::Assign { persistent: false, .. }
        );
        match statement {
            Statement::Command { spec, args, span } => {
                self.span = *span;
                self.command(spec, &self.program.args[*args])
            }
            Statement::Assign { name, persistent, only_if_undefined, value, span } => {
                self.span = *span;
                self.assign(*name, *persistent, *only_if_undefined, value)
            }
            Statement::AssignMember { path, only_if_undefined, value, span } => {
                self.span = *span;
                let path = &self.program.expressions[*path];
                self.assign_member(path, *only_if_undefined, value)
            }
            Statement::If { condition, then } => {
                if self.eval_condition(condition)? {
                    self.statement(then)
                } else {
                    Ok(())
                }
            }
            Statement::Goto(target) => self.jump(target),
            Statement::Gosub(target) => self.gosub(target),
            Statement::Return => self.return_from_sub(),
            Statement::End => {
                self.end_file();
                Ok(())
            }
            Statement::EndAll => Err(self.end_run(Status::Ended)),
            Statement::ExitShopbot => Err(self.exit()),
            Statement::OnInput { switch, state, action } => {
                self.on_input(switch, state, action.is_some())
            }
            other => self.outward_statement(other),
        }
    }

    /// A two-letter command: its arguments, then its effect.
    fn command(&mut self, spec: &'static CommandSpec, args: &[Arg]) -> Result<(), Stop> {
        self.refuse_protected(spec)?;
        let arguments = Arguments::evaluate(self, spec, args)?;
        if spec.stack == Stack::Ends {
            self.settle()?;
        }
        commands::carry_out(self, spec, &arguments)
    }

    /// Refuses a typed command that sets the machine while a password protects it.
    fn refuse_protected(&self, spec: &CommandSpec) -> Result<(), Stop> {
        let options = &self.core.options;
        let typed = options.typed && self.core.flow.levels.len() == 1;
        if !(options.protected && typed && spec.sets_machine()) {
            return Ok(());
        }
        let message = format!("{} changes settings, and they are protected", spec.letters);
        Err(self.fail_at(self.span, Code::Protected, message, "give the password first"))
    }

    fn assign(
        &mut self,
        name: NameId,
        persistent: bool,
        only_new: bool,
        value: &Assigned,
    ) -> Result<(), Stop> {
        let value = self.assigned_value(value)?;
        if persistent {
            // What survives restarts must not run ahead of the motion before it.
            self.settle()?;
            let known = self
                .host
                .stored(&crate::run::eval::persistent_key(&self.name_text(name)))
                .is_some();
            if !(only_new && known) {
                self.set_persistent(name, &value);
            }
        } else if !(only_new && self.variable(name).is_some()) {
            let new = self.variable(name).is_none();
            self.set_variable(name, value);
            if new {
                self.warn_many_variables();
            }
        }
        Ok(())
    }

    /// Returns the value of an assignment.
    pub(super) fn assigned_value(&mut self, value: &Assigned) -> Result<Value, Stop> {
        match value {
            Assigned::Nothing => Ok(Value::text("")),
            Assigned::Expr(expr) => self.eval(expr),
            Assigned::Text(text) => Ok(Value::Text(text.clone())),
        }
    }

    /// The old software had room for 100 variables; files that need more are told of once.
    fn warn_many_variables(&mut self) {
        if self.core.memory.variables.count() > 100 && !self.core.memory.told_many_variables {
            self.core.memory.told_many_variables = true;
            self.warn(Code::Unusual, "more than 100 variables", "older software has room for 100");
        }
    }

    /// Goes to a label of this file.
    fn jump(&mut self, target: &Target) -> Result<(), Stop> {
        let line = self.label_line(target)?;
        if let Some(level) = self.core.flow.levels.last_mut() {
            level.next = line;
            level.gosub_left |= !level.gosubs.is_empty();
        }
        Ok(())
    }

    pub(super) fn label_line(&self, target: &Target) -> Result<u32, Stop> {
        self.program.line_of(target).ok_or_else(|| {
            let name = self.program.label_name(target.label);
            let message = format!("label {name} not found");
            self.fail_at(
                target.span,
                Code::LabelNotFound,
                message,
                "a label is a name alone on a line, ending in a colon",
            )
        })
    }

    fn gosub(&mut self, target: &Target) -> Result<(), Stop> {
        let line = self.label_line(target)?;
        self.call_sub(line)
    }

    /// Goes to a line of the innermost file; RETURN comes back to the one that would be next.
    pub(super) fn call_sub(&mut self, line: u32) -> Result<(), Stop> {
        let Some(level) = self.core.flow.levels.last_mut() else { return Ok(()) };
        let deep = level.gosubs.len() >= MOST_GOSUBS;
        if deep && level.gosub_left {
            level.gosubs.drain(..FORGOTTEN_GOSUBS);
        } else if deep {
            let message = format!("GOSUB nested deeper than {MOST_GOSUBS}");
            return Err(self.fail(Code::NestedTooDeep, message));
        }
        if let Some(level) = self.core.flow.levels.last_mut() {
            level.gosubs.push(level.next);
            level.next = line;
        }
        Ok(())
    }

    fn return_from_sub(&mut self) -> Result<(), Stop> {
        let Some(level) = self.core.flow.levels.last_mut() else { return Ok(()) };
        if let Some(line) = level.gosubs.pop() {
            level.next = line;
            return Ok(());
        }
        if matches!(level.purpose, Purpose::Handler(_)) {
            self.leave_levels(self.core.flow.levels.len() - 1);
            return Ok(());
        }
        // What was read before it is complete, as at the end of a file, and is carried out.
        self.settle()?;
        let hint = "put END before the first subroutine of the file";
        Err(self.fail_at(self.span, Code::ReturnWithoutGosub, "RETURN without GOSUB", hint))
    }

    /// An input or output number, 1 … 12.
    pub(crate) fn switch_number(&mut self, expr: &Expr) -> Result<u8, Stop> {
        let n = self.eval_number(expr)?;
        if n.fract() == 0.0 && (1.0..=12.0).contains(&n) {
            return Ok(n as u8);
        }
        let message = format!("switches are numbered 1 to 12, not {}", Value::Number(n).display());
        Err(self.fail_at(expr.span, Code::OutOfRange, message, ""))
    }

    /// A full-line comment: shown to the operator; cutter comments name tool paths.
    pub(super) fn comment_line(&mut self, program: &Program) {
        let text = comment_text(program.line_text(self.at.line));
        if let Some(start) = tool_path_comment(text) {
            self.emit(Command::ToolPath(start));
        }
        if !text.is_empty() {
            self.emit(Command::Message { text: text.into() });
        }
    }

    /// The full-line comment right above the present line.
    pub(crate) fn comment_above(&self) -> Option<String> {
        let program = self.program;
        let above = self.at.line.checked_sub(1)?;
        let node = program.lines.get(above.checked_sub(1)? as usize)?.node;
        let text = comment_text(program.line_text(above));
        (node == crate::tree::Node::Comment && !text.is_empty()).then(|| text.to_string())
    }
}

/// Text of a full-line comment without its mark.
fn comment_text(line: &str) -> &str {
    let line = line.trim();
    let rest = line
        .strip_prefix('\'')
        .or_else(|| line.get(..3).filter(|r| r.eq_ignore_ascii_case("REM")).map(|_| &line[3..]));
    rest.unwrap_or(line).trim()
}

/// `New Path`, `Toolpath Name = …` and `Tool Name = …`, which CAM programs write for the previewer.
fn tool_path_comment(text: &str) -> Option<ToolPathStart> {
    let value = |key: &str| {
        let head = text.get(..key.len())?;
        let rest = text[key.len()..].trim_start().strip_prefix('=')?;
        head.eq_ignore_ascii_case(key).then(|| Arc::from(rest.trim()))
    };
    if text.eq_ignore_ascii_case("New Path") {
        return Some(ToolPathStart::default());
    }
    if let Some(name) = value("Toolpath Name") {
        return Some(ToolPathStart { name: Some(name), tool: None });
    }
    value("Tool Name").map(|tool| ToolPathStart { name: None, tool: Some(tool) })
}
