//! Statements that speak to the operator, to files and to other programs.

use super::{
    Context, Stop, dialogs, fabmo, message_box, pauses, printing, programs, registry, user_files,
};
use crate::tree::Statement;

/// Executes one of them.
pub(super) fn outward_statement(c: &mut Context<'_>, statement: &Statement) -> Result<(), Stop> {
    match statement {
        Statement::Pause { seconds: Some(seconds) } => pauses::pause_for(c, seconds),
        Statement::Pause { seconds: None } => pauses::pause(c),
        Statement::PauseUntil { switch, state } => pauses::pause_until(c, switch, state),
        Statement::WarningOff => pauses::warning_off(c),
        Statement::Output(output) => printing::output(c, output),
        Statement::Input(input) => {
            c.span = input.span;
            dialogs::input(c, input)
        }
        Statement::MsgBox(shown) => {
            c.span = shown.span;
            message_box::message_box(c, shown)
        }
        Statement::Open { path, mode, number } => user_files::open_file(c, path, *mode, number),
        Statement::Close(number) => user_files::close(c, number.as_ref()),
        Statement::InputFile { file, variables, span } => {
            c.span = *span;
            user_files::input_from_file(c, file, variables)
        }
        Statement::Play(path) => programs::play(c, path),
        Statement::Shell(shell) => {
            c.span = shell.span;
            programs::shell(c, shell)
        }
        Statement::Store { which, value, span } => {
            c.span = *span;
            registry::store(c, *which, value)
        }
        Statement::Fetch { which, variable, span } => {
            c.span = *span;
            registry::fetch(c, *which, *variable)
        }
        Statement::Custom { number, span } => {
            c.span = *span;
            programs::custom_cut(c, number)
        }
        Statement::Gcode(_) => programs::gcode_statement(c),
        Statement::Dialog(dialog) => {
            c.span = dialog.span;
            fabmo::dialog(c, dialog)
        }
        Statement::Fail(text) => fabmo::give_up(c, text.as_ref()),
        Statement::Data { request, items } => fabmo::data(c, *request, items),
        // The others are carried out by `Context::statement`.
        _ => Ok(()),
    }
}
