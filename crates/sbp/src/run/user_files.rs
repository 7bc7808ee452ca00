//! OPEN, CLOSE, INPUT # and the files behind WRITE # (handbook, OPEN … CLOSE; readings, A-38, A-48).

use super::state::UserFile;
use super::{Context, Stop, eval, fields};
use crate::tree::NameId;
use crate::{Expr, Value};
use kerf_diag::Code;
use kerf_program::{Command, FileMode, FileOp, HostError};

/// OPEN path FOR mode AS #number.
pub(super) fn open_file(
    c: &mut Context<'_>,
    path: &Expr,
    mode: FileMode,
    number: &Expr,
) -> Result<(), Stop> {
    let name = eval::eval(c, path)?.display();
    let name = name.trim();
    if name.is_empty() {
        return Err(c.fail_at(path.span, Code::FileNotFound, "file name expected", ""));
    }
    let slot = file_number(c, number)?;
    if c.core.user_files.get(slot).is_some() {
        let message = format!("file #{slot} is already open");
        let hint = format!("CLOSE #{slot} first, or take another number from 1 to 9");
        return Err(c.fail_at(number.span, Code::FileNumber, message, hint));
    }
    c.settle()?;
    let opened = c.host.open(slot, name, mode);
    let path = opened.map_err(|e| cannot(c, "open", name, e))?;
    let file = UserFile { path: path.into(), mode, fields: Vec::new() };
    tell_file(c, FileOp::Open, &file);
    c.core.user_files.put(slot, file);
    Ok(())
}

/// CLOSE #number, or CLOSE for all. A number that is not open is no mistake, as in BASIC.
pub(super) fn close(c: &mut Context<'_>, number: Option<&Expr>) -> Result<(), Stop> {
    let numbers = match number {
        Some(number) => {
            let n = file_number(c, number)?;
            n..=n
        }
        None => 1..=9,
    };
    c.settle()?;
    for number in numbers {
        close_file(c, number).map_err(|e| c.refused(e))?;
    }
    Ok(())
}

/// Closes whatever is still open when the run ends.
pub(super) fn close_user_files(c: &mut Context<'_>) {
    for number in 1..=9 {
        if let Err(error) = close_file(c, number) {
            let message = format!("file #{number} could not be closed: {error:?}");
            c.warn(Code::FileError, message, "what was written last may be missing");
        }
    }
}

fn close_file(c: &mut Context<'_>, number: u8) -> Result<(), HostError> {
    match c.core.user_files.take(number) {
        None => Ok(()),
        Some(file) => {
            tell_file(c, FileOp::Close, &file);
            c.host.close(number)
        }
    }
}

/// INPUT #number: one value a variable, taken in order across lines.
pub(super) fn input_from_file(
    c: &mut Context<'_>,
    file: &Expr,
    variables: &[NameId],
) -> Result<(), Stop> {
    let number = file_number(c, file)?;
    need_mode(c, number, "reading", |mode| mode == FileMode::Input)?;
    c.settle()?;
    for name in variables {
        let value = next_field(c, number)?;
        eval::set_variable(c, *name, value);
    }
    if let Some(file) = c.core.user_files.get(number).cloned() {
        tell_file(c, FileOp::Read, &file);
    }
    Ok(())
}

fn next_field(c: &mut Context<'_>, number: u8) -> Result<Value, Stop> {
    loop {
        let Some(file) = c.core.user_files.get_mut(number) else {
            return Err(not_open(c, number, "reading"));
        };
        if !file.fields.is_empty() {
            return Ok(file.fields.remove(0));
        }
        let line = c.host.read_line(number).map_err(|e| match e {
            HostError::EndOfFile => {
                let message = format!("end of file on #{number}");
                c.fail_at(c.span, Code::EndOfFile, message, "there are no more values")
            }
            other => c.refused(other),
        })?;
        if let Some(file) = c.core.user_files.get_mut(number) {
            file.fields = fields::split(&line);
        }
    }
}

/// Writes text to an open file.
pub(super) fn write_file(c: &mut Context<'_>, number: u8, text: &str) -> Result<(), Stop> {
    let file = need_mode(c, number, "writing", |mode| mode != FileMode::Input)?;
    c.host.write(number, text).map_err(|e| c.refused(e))?;
    tell_file(c, FileOp::Write, &file);
    Ok(())
}

/// A file number, 1 … 9.
pub(super) fn file_number(c: &mut Context<'_>, expr: &Expr) -> Result<u8, Stop> {
    let n = eval::eval_number(c, expr)?;
    if n.fract() == 0.0 && (1.0..=9.0).contains(&n) {
        return Ok(n as u8);
    }
    let message = format!("file numbers are 1 to 9, not {}", Value::Number(n).display());
    Err(c.fail_at(expr.span, Code::FileNumber, message, ""))
}

fn need_mode(
    c: &Context<'_>,
    number: u8,
    purpose: &str,
    fits: impl Fn(FileMode) -> bool,
) -> Result<UserFile, Stop> {
    let Some(file) = c.core.user_files.get(number) else {
        return Err(not_open(c, number, purpose));
    };
    if fits(file.mode) {
        return Ok(file.clone());
    }
    let message = format!("file #{number} is not open for {purpose}");
    let hint = "OPEN says FOR INPUT to read, FOR OUTPUT or FOR APPEND to write";
    Err(c.fail_at(c.span, Code::FileNotOpen, message, hint))
}

fn not_open(c: &Context<'_>, number: u8, purpose: &str) -> Stop {
    let message = format!("file #{number} is not open");
    let way = if purpose == "reading" { "INPUT" } else { "OUTPUT" };
    let hint = format!("write OPEN \"name\" FOR {way} AS #{number} before it");
    c.fail_at(c.span, Code::FileNotOpen, message, hint)
}

fn cannot(c: &Context<'_>, what: &str, name: &str, error: HostError) -> Stop {
    match c.refused(error) {
        Stop::Failed(mut diagnostic) => {
            diagnostic.message = format!("cannot {what} {name}: {}", diagnostic.message);
            Stop::Failed(diagnostic)
        }
        other => other,
    }
}

fn tell_file(c: &mut Context<'_>, op: FileOp, file: &UserFile) {
    c.emit(Command::File { op, path: file.path.clone() });
}
