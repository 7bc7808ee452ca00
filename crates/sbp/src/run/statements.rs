//! The effect of each statement. The larger families have files of their own.

use super::{
    Arguments, Context, Stop, commands, eval, interrupt, jumps, levels, lifecycle, members, outward,
};
use crate::table::{CommandSpec, Stack};
use crate::tree::{Arg, Assigned, NameId, Statement};
use kerf_diag::Code;
use kerf_program::Status;

/// Executes a statement.
pub(crate) fn execute(c: &mut Context<'_>, statement: &Statement) -> Result<(), Stop> {
    // An assignment changes something where the value is another; a condition by what it looks at.
    c.core.idling.changes |= !matches!(
        statement,
        Statement::Goto(_)
            | Statement::If { .. }
            | Statement::Mention(_)
            | Statement::Assign { persistent: false, .. }
    );
    match statement {
        Statement::Command { spec, args, span } => {
            c.span = *span;
            command(c, spec, &c.program.args[*args])
        }
        Statement::Assign { name, persistent, only_if_undefined, value, span } => {
            c.span = *span;
            assign(c, *name, *persistent, *only_if_undefined, value)
        }
        Statement::AssignMember { path, only_if_undefined, value, span } => {
            c.span = *span;
            let path = &c.program.expressions[*path];
            members::assign_member(c, path, *only_if_undefined, value)
        }
        Statement::If { condition, then } => {
            if eval::eval_condition(c, condition)? {
                execute(c, then)
            } else {
                Ok(())
            }
        }
        Statement::Goto(target) => jumps::jump(c, target),
        Statement::Gosub(target) => jumps::gosub(c, target),
        Statement::Return => jumps::return_from_sub(c),
        Statement::End => {
            levels::end_file(c);
            Ok(())
        }
        Statement::EndAll => Err(lifecycle::end_run(c, Status::Ended)),
        Statement::ExitShopbot => Err(lifecycle::exit(c)),
        Statement::OnInput { switch, state, action } => {
            interrupt::on_input(c, switch, state, action.is_some())
        }
        other => outward::outward_statement(c, other),
    }
}

/// A two-letter command: its arguments, then its effect.
fn command(c: &mut Context<'_>, spec: &'static CommandSpec, args: &[Arg]) -> Result<(), Stop> {
    refuse_protected(c, spec)?;
    let arguments = Arguments::evaluate(c, spec, args)?;
    if spec.stack == Stack::Ends {
        c.settle()?;
    }
    commands::carry_out(c, spec, &arguments)
}

/// Refuses a typed command that sets the machine while a password protects it.
fn refuse_protected(c: &Context<'_>, spec: &CommandSpec) -> Result<(), Stop> {
    let options = &c.core.options;
    let typed = options.typed && c.core.flow.levels.len() == 1;
    if !(options.protected && typed && spec.sets_machine()) {
        return Ok(());
    }
    let message = format!("{} changes settings, and they are protected", spec.letters);
    Err(c.fail_at(c.span, Code::Protected, message, "give the password first"))
}

fn assign(
    c: &mut Context<'_>,
    name: NameId,
    persistent: bool,
    only_new: bool,
    value: &Assigned,
) -> Result<(), Stop> {
    let value = eval::assigned_value(c, value)?;
    if persistent {
        // What survives restarts must not run ahead of the motion before it.
        c.settle()?;
        let known =
            c.host.stored(&crate::run::eval::persistent_key(&eval::name_text(c, name))).is_some();
        if !(only_new && known) {
            eval::set_persistent(c, name, &value);
        }
    } else if !(only_new && eval::variable(c, name).is_some()) {
        let new = eval::variable(c, name).is_none();
        eval::set_variable(c, name, value);
        if new {
            warn_many_variables(c);
        }
    }
    Ok(())
}

/// The old software had room for 100 variables; files that need more are told of once.
fn warn_many_variables(c: &mut Context<'_>) {
    if c.core.memory.variables.count() > 100 && !c.core.memory.told_many_variables {
        c.core.memory.told_many_variables = true;
        c.warn(Code::Unusual, "more than 100 variables", "older software has room for 100");
    }
}
