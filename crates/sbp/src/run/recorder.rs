//! The recorder: commands that were typed, kept outside the program under a key.

use super::{Context, FileParameters, Stop};
use crate::tree::{Node, Statement};
use kerf_diag::Code;
use kerf_program::{FileMode, HostError};
use std::sync::Arc;

/// Key of the recorded commands, a line each.
pub const RECORDED: &str = "Recorded";

/// Key that reads 0 while nothing is recorded; recording is the usual.
pub const RECORDING: &str = "Recording";

/// So many lines are kept.
const MOST: usize = 100;

/// The name that recorded commands have as a file.
const NAME: &str = "recorded commands";

/// The number under which Kerf itself writes a file; those of programs begin at 1.
const OWN_FILE: u8 = 0;

/// Recorded commands that are run again.
pub struct Replay<'a> {
    /// The lines.
    pub lines: &'a [String],
    /// Number of times that the lines run.
    pub times: u32,
}

/// The recorder's list with another line at its end; the oldest ones fall out.
pub fn with_recorded(mut lines: Vec<String>, line: &str) -> Vec<String> {
    lines.push(line.trim().to_owned());
    let first = lines.len().saturating_sub(MOST);
    lines.split_off(first)
}

impl Context<'_> {
    /// RA, RI.
    pub(crate) fn set_recording(&mut self, on: bool) {
        self.host.store(RECORDING, (!on).then_some("0"));
    }

    /// RZ.
    pub(crate) fn forget_recorded(&mut self) {
        self.host.store(RECORDED, None);
    }

    /// The recorded commands, oldest first.
    pub(crate) fn recorded(&mut self) -> Vec<String> {
        let text = self.host.stored(RECORDED).unwrap_or_default();
        text.lines().map(str::to_owned).collect()
    }

    /// Records the line that was typed and carried out. Commands of the recorder are not recorded.
    pub(super) fn record(&mut self, node: Node) {
        if !self.is_recorded(node) || self.host.stored(RECORDING).as_deref() == Some("0") {
            return;
        }
        let line = self.program.line_text(self.at.line);
        let lines = with_recorded(self.recorded(), line);
        self.host.store(RECORDED, Some(&lines.join("\n")));
    }

    fn is_recorded(&self, node: Node) -> bool {
        match node {
            Node::Move { .. } => true,
            Node::Statement(index) => match self.program.statements.get(index as usize) {
                Some(Statement::Command { spec, .. }) => !spec.letters.starts_with('R'),
                Some(Statement::Custom { .. } | Statement::Gcode(_)) => true,
                _ => false,
            },
            _ => false,
        }
    }

    /// Runs recorded commands again, as a file that is called.
    pub(crate) fn replay(&mut self, replay: Replay<'_>) -> Result<(), Stop> {
        self.settle()?;
        if self.core.flow.levels.len() >= super::levels::MOST_LEVELS {
            return Err(self.fail(Code::NestedTooDeep, "recorded commands replay themselves"));
        }
        let text = replay.lines.join("\n");
        let program = crate::read_as(Arc::from(NAME), text.as_bytes(), self.core.options.dialect);
        let parameters = FileParameters { repetitions: replay.times, ..FileParameters::default() };
        self.open_level(Arc::new(program), parameters);
        Ok(())
    }

    /// Writes lines into a file of the part folder.
    pub(crate) fn save_recorded(&mut self, name: &str, lines: &[String]) -> Result<(), Stop> {
        self.settle()?;
        let mut save = || -> Result<(), HostError> {
            self.host.open(OWN_FILE, name, FileMode::Output)?;
            self.host.write(OWN_FILE, &(lines.join("\n") + "\n"))?;
            self.host.close(OWN_FILE)
        };
        save().map_err(|error| self.refused(error))
    }
}
