//! OPEN, CLOSE, INPUT # and the files behind WRITE # (handbook, OPEN … CLOSE; readings, A-38, A-48).

use super::{Context, Stop, fields};
use crate::tree::NameId;
use crate::{Expr, Value};
use kerf_diag::Code;
use kerf_program::{Command, FileMode, FileOp, HostError};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Open files by number − 1.
pub(crate) type UserFiles = [Option<UserFile>; 9];

/// A file of the user that is open.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct UserFile {
    pub(crate) path: Arc<str>,
    pub(crate) mode: FileMode,
    /// Fields of the last line read that were not taken yet.
    pub(crate) fields: Vec<Value>,
}

impl Context<'_> {
    /// OPEN path FOR mode AS #number.
    pub(super) fn open_file(
        &mut self,
        path: &Expr,
        mode: FileMode,
        number: &Expr,
    ) -> Result<(), Stop> {
        let name = self.eval(path)?.display();
        let name = name.trim();
        if name.is_empty() {
            return Err(self.fail_at(path.span, Code::FileNotFound, "file name expected", ""));
        }
        let slot = self.file_number(number)?;
        if self.user_file(slot).is_some() {
            let message = format!("file #{slot} is already open");
            let hint = format!("CLOSE #{slot} first, or take another number from 1 to 9");
            return Err(self.fail_at(number.span, Code::FileNumber, message, hint));
        }
        self.settle()?;
        let opened = self.host.open(slot, name, mode);
        let path = opened.map_err(|e| self.cannot("open", name, e))?;
        let file = UserFile { path: path.into(), mode, fields: Vec::new() };
        self.tell_file(FileOp::Open, &file);
        self.core.user_files[usize::from(slot) - 1] = Some(file);
        Ok(())
    }

    /// CLOSE #number, or CLOSE for all. A number that is not open is no mistake, as in BASIC.
    pub(super) fn close(&mut self, number: Option<&Expr>) -> Result<(), Stop> {
        let numbers = match number {
            Some(number) => {
                let n = self.file_number(number)?;
                n..=n
            }
            None => 1..=9,
        };
        self.settle()?;
        for number in numbers {
            self.close_file(number).map_err(|e| self.refused(e))?;
        }
        Ok(())
    }

    /// Closes whatever is still open when the run ends.
    pub(super) fn close_user_files(&mut self) {
        for number in 1..=9 {
            if let Err(error) = self.close_file(number) {
                let message = format!("file #{number} could not be closed: {error:?}");
                self.warn(Code::FileError, message, "what was written last may be missing");
            }
        }
    }

    fn close_file(&mut self, number: u8) -> Result<(), HostError> {
        match self.core.user_files[usize::from(number) - 1].take() {
            None => Ok(()),
            Some(file) => {
                self.tell_file(FileOp::Close, &file);
                self.host.close(number)
            }
        }
    }

    /// INPUT #number: one value a variable, taken in order across lines.
    pub(super) fn input_from_file(
        &mut self,
        file: &Expr,
        variables: &[NameId],
    ) -> Result<(), Stop> {
        let number = self.file_number(file)?;
        self.need_mode(number, "reading", |mode| mode == FileMode::Input)?;
        self.settle()?;
        for name in variables {
            let value = self.next_field(number)?;
            self.set_variable(*name, value);
        }
        if let Some(file) = self.user_file(number).cloned() {
            self.tell_file(FileOp::Read, &file);
        }
        Ok(())
    }

    fn next_field(&mut self, number: u8) -> Result<Value, Stop> {
        loop {
            let slot = self.core.user_files.get_mut(usize::from(number) - 1);
            let Some(file) = slot.and_then(Option::as_mut) else {
                return Err(self.not_open(number, "reading"));
            };
            if !file.fields.is_empty() {
                return Ok(file.fields.remove(0));
            }
            let line = self.host.read_line(number).map_err(|e| match e {
                HostError::EndOfFile => {
                    let message = format!("end of file on #{number}");
                    self.fail_at(self.span, Code::EndOfFile, message, "there are no more values")
                }
                other => self.refused(other),
            })?;
            if let Some(file) = self.core.user_files[usize::from(number) - 1].as_mut() {
                file.fields = fields::split(&line);
            }
        }
    }

    /// Writes text to an open file.
    pub(super) fn write_file(&mut self, number: u8, text: &str) -> Result<(), Stop> {
        let file = self.need_mode(number, "writing", |mode| mode != FileMode::Input)?;
        self.host.write(number, text).map_err(|e| self.refused(e))?;
        self.tell_file(FileOp::Write, &file);
        Ok(())
    }

    /// A file number, 1 … 9.
    pub(super) fn file_number(&mut self, expr: &Expr) -> Result<u8, Stop> {
        let n = self.eval_number(expr)?;
        if n.fract() == 0.0 && (1.0..=9.0).contains(&n) {
            return Ok(n as u8);
        }
        let message = format!("file numbers are 1 to 9, not {}", Value::Number(n).display());
        Err(self.fail_at(expr.span, Code::FileNumber, message, ""))
    }

    fn need_mode(
        &self,
        number: u8,
        purpose: &str,
        fits: impl Fn(FileMode) -> bool,
    ) -> Result<UserFile, Stop> {
        let Some(file) = self.user_file(number) else { return Err(self.not_open(number, purpose)) };
        if fits(file.mode) {
            return Ok(file.clone());
        }
        let message = format!("file #{number} is not open for {purpose}");
        let hint = "OPEN says FOR INPUT to read, FOR OUTPUT or FOR APPEND to write";
        Err(self.fail_at(self.span, Code::FileNotOpen, message, hint))
    }

    fn user_file(&self, number: u8) -> Option<&UserFile> {
        self.core.user_files.get(usize::from(number).checked_sub(1)?)?.as_ref()
    }

    fn not_open(&self, number: u8, purpose: &str) -> Stop {
        let message = format!("file #{number} is not open");
        let way = if purpose == "reading" { "INPUT" } else { "OUTPUT" };
        let hint = format!("write OPEN \"name\" FOR {way} AS #{number} before it");
        self.fail_at(self.span, Code::FileNotOpen, message, hint)
    }

    fn cannot(&self, what: &str, name: &str, error: HostError) -> Stop {
        match self.refused(error) {
            Stop::Failed(mut diagnostic) => {
                diagnostic.message = format!("cannot {what} {name}: {}", diagnostic.message);
                Stop::Failed(diagnostic)
            }
            other => other,
        }
    }

    fn tell_file(&mut self, op: FileOp, file: &UserFile) {
        self.emit(Command::File { op, path: file.path.clone() });
    }
}
