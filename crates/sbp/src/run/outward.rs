//! Statements that speak to the operator, to files and to other programs.

use super::{Context, Stop};
use crate::tree::Statement;

impl Context<'_> {
    /// Executes one of them.
    pub(super) fn outward_statement(&mut self, statement: &Statement) -> Result<(), Stop> {
        match statement {
            Statement::Pause { seconds: Some(seconds) } => self.pause_for(seconds),
            Statement::Pause { seconds: None } => self.pause(),
            Statement::PauseUntil { switch, state } => self.pause_until(switch, state),
            Statement::WarningOff => self.warning_off(),
            Statement::Output(output) => self.output(output),
            Statement::Input(input) => {
                self.span = input.span;
                self.input(input)
            }
            Statement::MsgBox(shown) => {
                self.span = shown.span;
                self.message_box(shown)
            }
            Statement::Open { path, mode, number } => self.open_file(path, *mode, number),
            Statement::Close(number) => self.close(number.as_ref()),
            Statement::InputFile { file, variables, span } => {
                self.span = *span;
                self.input_from_file(file, variables)
            }
            Statement::Play(path) => self.play(path),
            Statement::Shell(shell) => {
                self.span = shell.span;
                self.shell(shell)
            }
            Statement::Store { which, value, span } => {
                self.span = *span;
                self.store(*which, value)
            }
            Statement::Fetch { which, variable, span } => {
                self.span = *span;
                self.fetch(*which, *variable)
            }
            Statement::Custom { number, span } => {
                self.span = *span;
                self.custom_cut(number)
            }
            Statement::Gcode(_) => self.gcode_statement(),
            Statement::Dialog(dialog) => {
                self.span = dialog.span;
                self.dialog(dialog)
            }
            Statement::Fail(text) => self.give_up(text.as_ref()),
            Statement::Data { request, items } => self.data(*request, items),
            // The others are carried out by `Context::statement`.
            _ => Ok(()),
        }
    }
}
