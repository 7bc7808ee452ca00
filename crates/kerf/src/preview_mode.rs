//! Preview mode between commands of a shell: SP holds for what is typed next, until SM.
//!
//! A running server remembers it by itself. Runs of files do not begin in it: who says `kerf run` wants the machine to
//! move.

use kerf_control::Session;
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

/// Goes on in preview where the command before has left it so.
pub fn go_on(session: &mut Session, workspace: &Workspace) {
    let kept = workspace.stored.get(PREVIEW).and_then(|text| serde_json::from_str(text).ok());
    let Some(Previewed { frame, position, offset_applied }) = kept else { return };
    let memory = &mut session.memory;
    memory.before_preview = Some(Box::new(BeforePreview {
        frame: std::mem::replace(&mut memory.frame, frame),
        position: std::mem::replace(&mut memory.position, position),
        offset_applied: std::mem::replace(&mut memory.offset_applied, offset_applied),
    }));
    memory.settings.mode = Mode::Preview;
}

/// Keeps for the next command that the machine is in preview, or that it is not any more.
pub fn keep(session: &Session, workspace: &mut Workspace) {
    let kerf_sbp::Session { frame, position, offset_applied, .. } = session.memory;
    let place = Previewed { frame, position, offset_applied };
    let kept = session.is_in_preview().then(|| serde_json::to_string(&place).ok()).flatten();
    if workspace.stored.get(PREVIEW) != kept.as_deref() {
        workspace.stored.set(PREVIEW, kept.as_deref());
        workspace.stored.keep(PREVIEW);
    }
}
