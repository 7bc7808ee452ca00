//! PLAY, SHELL and custom cuts: sounds and programs that lie outside the part file.

use super::flow::Purpose;
use super::{Context, FileParameters, Stop};
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

impl Context<'_> {
    /// PLAY: starts a sound and goes on.
    pub(super) fn play(&mut self, path: &DialogText) -> Result<(), Stop> {
        let path = self.dialog_text(path)?;
        let name = path.trim();
        self.settle()?;
        let request = FileRequest { folder: Folder::Media, name: name.into() };
        if let Err(HostError::NotFound(_)) = self.host.source(&request) {
            let message = format!("there is no sound {name}");
            self.warn(Code::NoSound, message, "the part file goes on in silence");
        }
        self.emit(Command::Sound { path: name.into() });
        Ok(())
    }

    /// SHELL: starts another program, and with SYNC waits for its end.
    pub(super) fn shell(&mut self, shell: &Shell) -> Result<(), Stop> {
        let line = self.dialog_text(&shell.line)?.trim().to_string();
        let display = shell.display.as_ref().map_or(Ok(1), |d| self.display_option(d))?;
        self.settle()?;
        match self.host.shell(&ShellCall { line, display, wait: shell.wait }) {
            Poll::Pending => Err(Stop::Waiting),
            Poll::Ready(done) => done.map_err(|e| self.refused(e)),
        }
    }

    fn display_option(&mut self, display: &Expr) -> Result<u8, Stop> {
        let n = self.eval_number(display)?;
        let known = DISPLAYS.into_iter().find(|d| f64::from(*d) == n);
        known.ok_or_else(|| {
            let message = format!(
                "display option must be 0, 1, 2, 3, 4 or 6, not {}",
                Value::Number(n).display()
            );
            self.fail_at(display.span, Code::OutOfRange, message, "1 is a normal window")
        })
    }

    /// C#,n, CN,n and Cn: runs CustomN.sbc (readings, A-130).
    pub(super) fn custom_cut(&mut self, number: &Expr) -> Result<(), Stop> {
        let n = self.eval_number(number)?;
        if n.fract() != 0.0 || !(0.0..1e6).contains(&n) {
            let message =
                format!("custom cuts have whole numbers, not {}", Value::Number(n).display());
            return Err(self.fail_at(number.span, Code::OutOfRange, message, ""));
        }
        let n = n as i64;
        let file = self.custom_file(n);
        match self.call_file(file, FileParameters::default()) {
            Err(Stop::Failed(d)) if n == MY_VARIABLES && d.code == Code::FileNotFound => {
                self.warn(d.code, d.message, "the variables it would set are missing");
                Ok(())
            }
            Ok(()) if n == TOOL_CHANGE => {
                self.begin_tool_change();
                Ok(())
            }
            outcome => outcome,
        }
    }

    /// The file of a custom cut; FabMo has macros instead, where there is one.
    fn custom_file(&mut self, n: i64) -> FileRequest {
        let file = |name| FileRequest { folder: Folder::Custom, name };
        if self.core.options.dialect == Dialect::Fabmo {
            // A profile of FabMo has them in a folder of their own.
            let names = ["", "macros/"].map(|folder| format!("{folder}macro_{n}.sbp"));
            let own = names.map(file).into_iter().find(|own| self.host.source(own).is_ok());
            if let Some(own) = own {
                return own;
            }
        }
        file(format!("Custom{n}.sbc"))
    }

    /// The file just opened changes the tool; its end is told when it is left.
    fn begin_tool_change(&mut self) {
        if let Some(level) = self.core.flow.levels.last_mut() {
            level.purpose = Purpose::ToolChange;
            self.emit(Command::ToolChange { begin: true });
        }
    }
}
