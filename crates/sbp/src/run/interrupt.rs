//! ON INPUT: arming handlers, and what happens when one fires.
//!
//! The machine watches the inputs of the armed handlers while it moves. When one changes it stops,
//! drops what it had not begun, and tells [`Interpreter::interrupt`](super::Interpreter::interrupt),
//! which goes back to the state right behind the interrupted move. The handler's action then runs
//! as if it stood there.

use super::flow::{Level, Purpose};
use super::watch::Handler;
use super::{Context, Core, Stop, Watch};
use crate::tree::{Node, Program, Statement, Target};
use crate::{Expr, Value};
use kerf_diag::Code;
use kerf_program::Axes;

/// Takes the machine's position over and queues the handler's action; the handler is disarmed.
///
/// A handler ends with the outermost file: what arrives after its last move was made is ignored.
pub(super) fn arrive(core: &mut Core, watch: &Watch, position: Axes) {
    if core.flow.levels.is_empty() {
        return;
    }
    core.place.position = position;
    core.given.settled = true;
    // Moves that were still in the tab filter lie behind the interruption and are dropped.
    if let Some(tabs) = core.cutting.tabs.as_mut() {
        tabs.drop_buffered();
    }
    if let Some(index) = core.handlers.watches.iter().position(|h| h.watch == *watch) {
        let handler = core.handlers.watches.remove(index);
        core.handlers.fired.push(handler);
        core.answers.forget();
    }
}

impl Context<'_> {
    /// ON INPUT arms a handler, or disarms it when no action is given.
    pub(super) fn on_input(
        &mut self,
        switch: &Expr,
        state: &Expr,
        armed: bool,
    ) -> Result<(), Stop> {
        if !armed && self.eval(switch)? == Value::Empty {
            self.nothing_to_disarm(switch);
            return Ok(());
        }
        let watch = self.watch(switch, state)?;
        self.settle()?;
        self.core.handlers.watches.retain(|h| h.watch != watch);
        if armed {
            let level = self.core.flow.levels.len();
            self.core.handlers.watches.push(Handler { watch, at: self.at, level, probe: false });
        }
        Ok(())
    }

    /// Files tidy up with a variable that they never set: nothing was armed with it either.
    fn nothing_to_disarm(&mut self, switch: &Expr) {
        let message = format!("{} has no value: no ON INPUT is ended", self.spelled(switch.span));
        self.span = switch.span;
        self.warn(Code::Unusual, message, "name the switch that is no longer watched");
    }

    fn watch(&mut self, switch: &Expr, state: &Expr) -> Result<Watch, Stop> {
        let input = self.switch_number(switch)?;
        let condition = self.eval_number(state)?;
        let known =
            [(0.0, false, false), (1.0, true, false), (2.0, false, true), (3.0, true, true)];
        match known.into_iter().find(|(number, ..)| *number == condition) {
            Some((_, on, ramped)) => Ok(Watch::change(input, on, ramped)),
            None => {
                let shown = Value::Number(condition).display();
                let message = format!("condition must be 0, 1, 2 or 3, not {shown}");
                let hint = "1 on, 0 off, 3 on with a ramped stop, 2 off with a ramped stop";
                Err(self.fail_at(state.span, Code::OutOfRange, message, hint))
            }
        }
    }

    /// Runs the action of the ON INPUT line at `self.at`, which was armed at a depth of files.
    pub(super) fn handler_action(&mut self, program: &Program, depth: usize) -> Result<(), Stop> {
        let node = program.lines.get(self.at.line.saturating_sub(1) as usize).map(|l| l.node);
        let Some(Node::Statement(index)) = node else { return Ok(()) };
        match program.statements.get(index as usize) {
            Some(Statement::OnInput { action: Some(action), .. }) => self.act(action, depth),
            _ => Ok(()),
        }
    }

    fn act(&mut self, action: &Statement, depth: usize) -> Result<(), Stop> {
        match action {
            Statement::Gosub(target) => self.handler_sub(target, depth),
            // These belong to the handler's own file: files it called end.
            Statement::Goto(_) | Statement::Return | Statement::End => {
                self.need_open(depth)?;
                self.leave_levels(depth);
                self.statement(action)
            }
            other => self.statement(other),
        }
    }

    /// GOSUB as an action: RETURN goes back to the line behind the interrupted move, even when
    /// that is in a file which the handler's own file called.
    fn handler_sub(&mut self, target: &Target, depth: usize) -> Result<(), Stop> {
        let home = self.need_open(depth)?;
        let line = self.label_line(target)?;
        if self.core.flow.levels.len() == depth {
            return self.call_sub(line);
        }
        self.core.flow.levels.push(Level {
            next: line,
            gosubs: Vec::new(),
            gosub_left: false,
            repetitions_left: 0,
            start_z: None,
            skip_to: None,
            tabs: home.tabs_hold(),
            purpose: Purpose::Handler(depth),
            ..home
        });
        self.core.refresh_scale();
        self.refresh_tabs();
        Ok(())
    }

    /// The handler's own file, which must still be open for its labels to mean anything.
    fn need_open(&self, depth: usize) -> Result<Level, Stop> {
        let level = depth.checked_sub(1).and_then(|index| self.core.flow.levels.get(index));
        level.filter(|l| l.file == self.at.file).cloned().ok_or_else(|| {
            let message = "the file of this ON INPUT is over, so its labels cannot be reached";
            let hint = "set the handler in the file that has its label";
            self.fail_at(self.span, Code::LabelNotFound, message, hint)
        })
    }
}
