//! The recorder: commands that were typed, kept outside the program under a key.

use super::{Context, FileParameters, Stop, levels};
use crate::tree::{Node, Statement};
use kerf_diag::Code;
use kerf_program::{FileMode, Host, HostError};
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

/// RA, RI.
pub(crate) fn set_recording(host: &mut dyn Host, on: bool) {
    host.store(RECORDING, (!on).then_some("0"));
}

/// RZ.
pub(crate) fn forget_recorded(host: &mut dyn Host) {
    host.store(RECORDED, None);
}

/// The recorded commands, oldest first.
pub(crate) fn recorded(host: &mut dyn Host) -> Vec<String> {
    let text = host.stored(RECORDED).unwrap_or_default();
    text.lines().map(str::to_owned).collect()
}

/// Records the line that was typed and carried out. Commands of the recorder are not recorded.
pub(super) fn record(c: &mut Context<'_>, node: Node) {
    if !is_recorded(c, node) || c.host.stored(RECORDING).as_deref() == Some("0") {
        return;
    }
    let line = c.program.line_text(c.at.line);
    let lines = with_recorded(recorded(c.host), line);
    c.host.store(RECORDED, Some(&lines.join("\n")));
}

fn is_recorded(c: &Context<'_>, node: Node) -> bool {
    match node {
        Node::Move { .. } => true,
        Node::Statement(index) => match c.program.statements.get(index as usize) {
            Some(Statement::Command { spec, .. }) => !spec.letters.starts_with('R'),
            Some(Statement::Custom { .. } | Statement::Gcode(_)) => true,
            _ => false,
        },
        _ => false,
    }
}

/// Runs recorded commands again, as a file that is called.
pub(crate) fn replay(c: &mut Context<'_>, replay: Replay<'_>) -> Result<(), Stop> {
    c.settle()?;
    if c.core.flow.levels.len() >= super::levels::MOST_LEVELS {
        return Err(c.fail(Code::NestedTooDeep, "recorded commands replay themselves"));
    }
    let text = replay.lines.join("\n");
    let program = crate::read_as(Arc::from(NAME), text.as_bytes(), c.core.options.dialect);
    let parameters = FileParameters { repetitions: replay.times, ..FileParameters::default() };
    levels::open_level(c, Arc::new(program), parameters);
    Ok(())
}

/// Writes lines into a file of the part folder.
pub(crate) fn save_recorded(c: &mut Context<'_>, name: &str, lines: &[String]) -> Result<(), Stop> {
    c.settle()?;
    let mut save = || -> Result<(), HostError> {
        c.host.open(OWN_FILE, name, FileMode::Output)?;
        c.host.write(OWN_FILE, &(lines.join("\n") + "\n"))?;
        c.host.close(OWN_FILE)
    };
    save().map_err(|error| c.refused(error))
}
