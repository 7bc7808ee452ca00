//! Preview mode between commands of a shell: SP holds for what is typed next, until SM.
//!
//! A running server remembers it by itself. Runs of files do not begin in it: who says `kerf run` wants the machine to
//! move.

use crate::session::Session;
use kerf_program::settings::Mode;
use kerf_program::{Axes, Frame};
use kerf_sbp::BeforePreview;
use kerf_workspace::{Workspace, stored::PREVIEW};
use serde::{Deserialize, Serialize};

/// Place that a preview has come to.
#[derive(Serialize, Deserialize)]
struct Previewed {
    frame: Frame,
    position: Axes,
    offset_applied: Axes,
}

impl Session {
    /// Tells whether what is typed is only drawn.
    pub fn is_in_preview(&self) -> bool {
        self.memory.before_preview.is_some()
    }

    /// Goes on in preview where the command before has left it so.
    pub fn go_on_in_preview(&mut self, workspace: &Workspace) {
        let kept = workspace.stored.get(PREVIEW).and_then(|text| serde_json::from_str(text).ok());
        let Some(Previewed { frame, position, offset_applied }) = kept else { return };
        let memory = &mut self.memory;
        memory.before_preview = Some(Box::new(BeforePreview {
            frame: std::mem::replace(&mut memory.frame, frame),
            position: std::mem::replace(&mut memory.position, position),
            offset_applied: std::mem::replace(&mut memory.offset_applied, offset_applied),
        }));
        memory.settings.mode = Mode::Preview;
    }

    /// Keeps for the next command that the machine is in preview, or that it is not any more.
    pub fn keep_preview(&self, workspace: &mut Workspace) {
        let kerf_sbp::Session { frame, position, offset_applied, .. } = self.memory;
        let place = Previewed { frame, position, offset_applied };
        let kept = self.is_in_preview().then(|| serde_json::to_string(&place).ok()).flatten();
        if workspace.stored.get(PREVIEW) != kept.as_deref() {
            workspace.stored.set(PREVIEW, kept.as_deref());
            workspace.stored.keep(PREVIEW);
        }
    }
}
