//! A visit of Kerf at its machine, from start to close: what the system log tells of it, and commands
//! that other software passes in meanwhile.

use crate::clock;
use anyhow::Result;
use kerf_control::Session;
use kerf_journal::Live;
use kerf_workspace::{Workspace, command_passing, system_log::Opening, system_log::SystemLog};

/// A visit.
#[derive(Clone, Debug)]
pub struct Visit {
    /// Start of the visit.
    pub opening: Opening,
    /// End of the visit, in a word.
    pub closing: &'static str,
}

impl Default for Visit {
    fn default() -> Self {
        Self { opening: Opening::default(), closing: "NORMAL" }
    }
}

impl Visit {
    /// Kerf starts. A command that was passed in before is forgotten, and so is the answer to the spindle's question.
    pub fn begins(&self, session: &Session, workspace: &mut Workspace) -> Result<()> {
        self.begins_drawing(session, workspace, session.memory.before_preview.is_some())
    }

    /// The same, to draw only, or to move.
    pub fn begins_drawing(
        &self,
        session: &Session,
        workspace: &mut Workspace,
        draws: bool,
    ) -> Result<()> {
        let log = SystemLog::new(self.opening.clone(), clock::started);
        workspace.open_system_log(log, &session.memory.settings, draws);
        workspace.asks_for_spindle_anew();
        if let Some(journal) = workspace.journal() {
            journal.registry.take_in()?;
            command_passing::forget(journal)?;
            journal.registry.tell_rest(&session.look(Live::at_rest))?;
        }
        Ok(())
    }

    /// A command that was passed in since; one that cannot be used is told, logged and left.
    pub fn command(&self, session: &Session, workspace: &mut Workspace) -> Result<Option<String>> {
        let Some(journal) = workspace.journal() else { return Ok(None) };
        journal.registry.take_in()?;
        match command_passing::take(journal)? {
            Some(Err(why)) => {
                tell_refused(&why, session, workspace);
                Ok(None)
            }
            command => Ok(command.and_then(Result::ok)),
        }
    }

    /// A command that was passed in is not carried out.
    pub fn refuses(command: &str, why: &str, session: &Session, workspace: &mut Workspace) {
        tell_refused(&format!("{command} was not carried out: {why}"), session, workspace);
    }

    /// Kerf closes, and leaves nothing on.
    pub fn ends(&self, session: &Session, workspace: &mut Workspace) {
        // Where the disk refuses, that was told when the run ended.
        drop(workspace.journal().map(|journal| journal.registry.tell_rest(&Live::default())));
        workspace.close_system_log(&session.memory.settings, self.closing);
    }
}

fn tell_refused(why: &str, session: &Session, workspace: &mut Workspace) {
    eprintln!("kerf: {}: {why}", command_passing::COMMAND);
    let (settings, draws) = (&session.memory.settings, session.is_in_preview());
    command_passing::log_refused(workspace, settings, draws, why);
}
