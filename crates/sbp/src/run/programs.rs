//! PLAY, SHELL and custom cuts: sounds and programs that lie outside the part file.

use super::{Context, FileParameters, Stop, cutting, eval, levels, questions, tool_changes};
use crate::syntax::Dialect;
use crate::tree::{DialogText, Shell};
use crate::{Expr, Value};
use kerf_diag::Code;
use kerf_program::{Command, FileRequest, Folder, HostError, ShellCall};
use std::task::Poll;

/// Ways in which a window can be shown: hidden, normal, minimised, maximised with focus; normal and
/// minimised without.
const DISPLAYS: [u8; 6] = [0, 1, 2, 3, 4, 6];

/// The custom cut that changes the tool.
const TOOL_CHANGE: i64 = 9;

/// The custom cut that loads the owner's variables; many machines have none.
const MY_VARIABLES: i64 = 90;

/// PLAY: starts a sound and goes on.
pub(super) fn play(c: &mut Context<'_>, path: &DialogText) -> Result<(), Stop> {
    let path = questions::dialog_text(c, path)?;
    let name = path.trim();
    c.settle()?;
    let request = FileRequest { folder: Folder::Media, name: name.into() };
    if let Err(HostError::NotFound(_)) = c.host.source(&request) {
        let message = format!("there is no sound {name}");
        c.warn(Code::NoSound, message, "the part file goes on in silence");
    }
    c.emit(Command::Sound { path: name.into() });
    Ok(())
}

/// SHELL: starts another program, and with SYNC waits for its end.
pub(super) fn shell(c: &mut Context<'_>, shell: &Shell) -> Result<(), Stop> {
    let line = questions::dialog_text(c, &shell.line)?.trim().to_string();
    let display = shell.display.as_ref().map_or(Ok(1), |d| display_option(c, d))?;
    c.settle()?;
    match c.host.shell(&ShellCall { line, display, wait: shell.wait }) {
        Poll::Pending => Err(Stop::Waiting),
        Poll::Ready(done) => done.map_err(|e| c.refused(e)),
    }
}

fn display_option(c: &mut Context<'_>, display: &Expr) -> Result<u8, Stop> {
    let n = eval::eval_number(c, display)?;
    let known = DISPLAYS.into_iter().find(|d| f64::from(*d) == n);
    known.ok_or_else(|| {
        let message = format!(
            "display option must be 0, 1, 2, 3, 4 or 6, not {}",
            Value::Number(n).display()
        );
        c.fail_at(display.span, Code::OutOfRange, message, "1 is a normal window")
    })
}

/// C#,n, CN,n and Cn: runs CustomN.sbc (readings, A-130).
pub(super) fn custom_cut(c: &mut Context<'_>, number: &Expr) -> Result<(), Stop> {
    let n = eval::eval_number(c, number)?;
    if n.fract() != 0.0 || !(0.0..1e6).contains(&n) {
        let message = format!("custom cuts have whole numbers, not {}", Value::Number(n).display());
        return Err(c.fail_at(number.span, Code::OutOfRange, message, ""));
    }
    let n = n as i64;
    let file = custom_file(c, n);
    match levels::call_file(c, file, FileParameters::default()) {
        Err(Stop::Failed(d)) if n == MY_VARIABLES && d.code == Code::FileNotFound => {
            c.warn(d.code, d.message, "the variables it would set are missing");
            Ok(())
        }
        Ok(()) if n == TOOL_CHANGE => {
            tool_changes::begin(c);
            Ok(())
        }
        outcome => outcome,
    }
}

/// M6 of G-code: runs the custom cut that changes the tool, which `&Tool` names. The line of G-code goes on behind it.
pub(super) fn change_tool(c: &mut Context<'_>, tool: u32) -> Result<(), Stop> {
    let file = custom_file(c, TOOL_CHANGE);
    levels::call_file(c, file, FileParameters::default())?;
    c.core.memory.variables.set("TOOL", Value::Number(f64::from(tool)));
    tool_changes::begin(c);
    let goes_on = c.core.flow.gcode_line.take();
    if let Some(level) = c.core.flow.levels.last_mut() {
        level.goes_on = goes_on;
    }
    Ok(())
}

/// The file of a custom cut; FabMo has macros instead, where there is one.
fn custom_file(c: &mut Context<'_>, n: i64) -> FileRequest {
    let file = |name| FileRequest { folder: Folder::Custom, name };
    if c.core.options.dialect == Dialect::Fabmo {
        // A profile of FabMo has them in a folder of their own.
        let names = ["", "macros/"].map(|folder| format!("{folder}macro_{n}.sbp"));
        let own = names.map(file).into_iter().find(|own| c.host.source(own).is_ok());
        if let Some(own) = own {
            return own;
        }
    }
    file(format!("Custom{n}.sbc"))
}

/// A line of G-code: whoever runs both languages takes it from here.
pub(super) fn gcode_statement(c: &mut Context<'_>) -> Result<(), Stop> {
    levels::need_gcode(c, "G-code in a part file cannot be carried out here")?;
    cutting::end_tabs(c);
    c.core.flow.gcode_line = Some(c.at);
    Ok(())
}
