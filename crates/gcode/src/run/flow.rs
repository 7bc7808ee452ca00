//! O-words: subroutines, branches, loops.

use super::context::{Context, Stop};
use super::core::{Call, CallKind, LOCALS};
use crate::syntax::tree::{Flow, Keyword, Label, Program};
use kerf_diag::Code;
use kerf_program::{FileRequest, Folder, HostError};
use std::sync::Arc;

/// Calls within calls; more is a subroutine that calls itself for ever.
const MOST_CALLS: usize = 100;

impl Context<'_> {
    pub(super) fn flow(&mut self, program: &Arc<Program>, flow: &Flow) -> Result<(), Stop> {
        if !is_linked(flow) {
            return self.bad(program);
        }
        match flow.keyword {
            // A definition met on the way is passed by.
            Keyword::Sub => self.go_on_at(flow.target),
            Keyword::Endsub | Keyword::Return => return self.return_with(program, flow),
            Keyword::Call => return self.call_flow(program, flow),
            Keyword::If => {
                if !self.holds(program, flow)? {
                    return self.next_branch(program, flow.target);
                }
            }
            // Met at the end of the branch that was taken.
            Keyword::Elseif | Keyword::Else => self.go_on_at(flow.end),
            Keyword::While => {
                if !self.holds(program, flow)? {
                    self.go_on_at(flow.target);
                }
            }
            Keyword::Endwhile => self.go_on_at(flow.target - 1),
            Keyword::DoWhile => {
                if self.holds(program, flow)? {
                    self.go_on_at(flow.target);
                }
            }
            Keyword::Repeat => self.repeat(program, flow)?,
            Keyword::Endrepeat => self.end_turn(flow.target),
            Keyword::Break => self.leave_loop(flow),
            Keyword::Continue => self.next_turn(program, flow),
            Keyword::Do | Keyword::Endif | Keyword::Program => {}
        }
        Ok(())
    }

    fn value(&self, program: &Program, flow: &Flow) -> Result<f64, Stop> {
        match flow.values.first() {
            Some(expr) => self.evaluate(program, expr, flow.span),
            None => Ok(0.0),
        }
    }

    fn holds(&self, program: &Program, flow: &Flow) -> Result<bool, Stop> {
        Ok(self.value(program, flow)? != 0.0)
    }

    /// Looks for the branch to take from a line on: `elseif`, `else` or `endif`.
    fn next_branch(&mut self, program: &Arc<Program>, mut line: u32) -> Result<(), Stop> {
        while let Some(flow) = flow_at(program, line) {
            let taken = match flow.keyword {
                Keyword::Elseif => self.holds(program, flow)?,
                _ => true,
            };
            if taken {
                break;
            }
            line = flow.target;
        }
        self.go_on_at(line);
        Ok(())
    }

    fn repeat(&mut self, program: &Program, flow: &Flow) -> Result<(), Stop> {
        let times = self.value(program, flow)?.round_ties_even().max(0.0) as u64;
        if times == 0 {
            self.go_on_at(flow.target);
        } else if let Some(call) = self.core.calls.last_mut() {
            call.loops.retain(|(line, _)| *line != self.at.line);
            call.loops.push((self.at.line, times - 1));
        }
        Ok(())
    }

    /// The end of a turn of the counted loop that begins at a line.
    fn end_turn(&mut self, line: u32) {
        let Some(call) = self.core.calls.last_mut() else { return };
        let Some(at) = call.loops.iter().rposition(|(l, _)| *l == line) else { return };
        if call.loops[at].1 == 0 {
            call.loops.truncate(at);
            return;
        }
        call.loops[at].1 -= 1;
        call.next = line;
    }

    fn leave_loop(&mut self, flow: &Flow) {
        if let Some(call) = self.core.calls.last_mut() {
            call.loops.retain(|(line, _)| *line != flow.target);
        }
        self.go_on_at(flow.end);
    }

    fn next_turn(&mut self, program: &Program, flow: &Flow) {
        match flow_at(program, flow.target).map(|f| f.keyword) {
            Some(Keyword::While) => self.go_on_at(flow.target - 1),
            // The last line decides whether there is another turn.
            _ => self.go_on_at(flow.end - 1),
        }
    }

    fn call_flow(&mut self, program: &Arc<Program>, flow: &Flow) -> Result<(), Stop> {
        let mut values = Vec::with_capacity(LOCALS);
        for expr in &flow.values {
            values.push(self.evaluate(program, expr, flow.span)?);
        }
        let label = match (&flow.label, &flow.computed) {
            (Some(label), _) => label.clone(),
            (None, Some(expr)) => {
                Label::Number(self.evaluate(program, expr, flow.span)?.round().max(0.0) as u32)
            }
            (None, None) => return Ok(()),
        };
        self.call(&label, CallKind::Sub, values)
    }

    /// Calls a subroutine of this file, or a file of its name.
    pub(super) fn call(
        &mut self,
        label: &Label,
        kind: CallKind,
        mut values: Vec<f64>,
    ) -> Result<(), Stop> {
        if self.core.calls.len() >= MOST_CALLS {
            let message = format!("more than {MOST_CALLS} calls within each other");
            return Err(self.fail(
                Code::NestedTooDeep,
                message,
                "does a subroutine call itself for ever?",
            ));
        }
        let (file, line) = self.find(label)?;
        let kind = match kind {
            CallKind::Fanuc { again, .. } => CallKind::Fanuc { again, first: line },
            kind => kind,
        };
        let mut call = Call::new(file, line, kind);
        if kind == CallKind::Sub {
            values.resize(LOCALS, 0.0);
            call.locals = values;
        }
        self.core.calls.push(call);
        Ok(())
    }

    /// The file and the first line (index) of a subroutine.
    fn find(&mut self, label: &Label) -> Result<(u32, u32), Stop> {
        let known = |p: &Program| p.subs.get(label).copied();
        if let Some(line) = known(&self.program()) {
            return Ok((self.at.file, line));
        }
        // The file that was started may hold what a file it called needs.
        let loaded = self.core.programs.iter().enumerate();
        let mut loaded = loaded.filter_map(|(i, p)| Some((i as u32, known(p)?)));
        if let Some(found) = loaded.next() {
            return Ok(found);
        }
        self.load(label)
    }

    fn load(&mut self, label: &Label) -> Result<(u32, u32), Stop> {
        let stem = match label {
            Label::Number(n) => format!("{n}"),
            Label::Name(name) => name.to_string(),
        };
        for ending in ["ngc", "nc"] {
            let request = FileRequest { folder: Folder::Parts, name: format!("{stem}.{ending}") };
            let source = match self.host.source(&request) {
                Ok(source) => source,
                Err(HostError::NotFound(_)) => continue,
                Err(error) => return Err(self.refused(error)),
            };
            let program = crate::read(source.name, &source.bytes);
            if let Some(error) = program.diagnostics.iter().find(|d| d.is_error()) {
                return Err(Stop::Failed(Box::new(error.clone())));
            }
            // A file without a subroutine of this name is the subroutine.
            let line = program.subs.get(label).copied().unwrap_or_default();
            return Ok((self.core.load(program), line));
        }
        let message = format!("there is no subroutine {label}");
        let hint = format!("define it with {label} sub, or put it into a file {stem}.ngc");
        Err(self.fail(Code::NoSubroutine, message, hint))
    }

    fn return_with(&mut self, program: &Program, flow: &Flow) -> Result<(), Stop> {
        let value = match flow.values.first() {
            Some(expr) => Some(self.evaluate(program, expr, flow.span)?),
            None => None,
        };
        if self.core.calls.len() > 1 {
            return self.leave_call(value);
        }
        // An endsub that is run into without a call: the definition is just text.
        if flow.keyword == Keyword::Return {
            return Err(self.fail(
                Code::BadFlow,
                "return outside a subroutine",
                "M2 or M30 ends a program",
            ));
        }
        Ok(())
    }

    /// Goes back to the caller, or begins the subroutine again when it is called repeatedly.
    pub(super) fn leave_call(&mut self, value: Option<f64>) -> Result<(), Stop> {
        if let Some(call) = self.core.calls.last_mut()
            && let CallKind::Fanuc { again, first } = &mut call.kind
            && *again > 0
        {
            *again -= 1;
            call.next = *first;
            return Ok(());
        }
        let Some(call) = self.core.calls.pop() else { return Ok(()) };
        if call.kind == CallKind::Sub {
            self.set_named("_value".into(), value.unwrap_or_default());
            self.set_named("_value_returned".into(), f64::from(u8::from(value.is_some())));
        }
        if let Some(kept) = call.kept.filter(|_| call.restore) {
            self.restore_modes(&kept);
        }
        Ok(())
    }
}

/// Returns `true` if an O-word has the partner it needs; the reader told where it has not.
fn is_linked(flow: &Flow) -> bool {
    match flow.keyword {
        Keyword::Elseif | Keyword::Else | Keyword::Break | Keyword::Continue => flow.end > 0,
        Keyword::Sub
        | Keyword::If
        | Keyword::While
        | Keyword::Endwhile
        | Keyword::DoWhile
        | Keyword::Repeat
        | Keyword::Endrepeat => flow.target > 0,
        _ => true,
    }
}

fn flow_at(program: &Program, line: u32) -> Option<&Flow> {
    let node = program.line(line)?.node();
    let crate::syntax::tree::Node::Block(index) = node else { return None };
    let block = program.blocks.get(index as usize)?;
    program.extra_of(block)?.flow.as_ref()
}
