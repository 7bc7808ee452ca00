//! Sounds: files of the part folder, else of the folder of sounds in the data folder, where only the last
//! part of a name counts. So `C:\WINDOWS\Media\tada.wav` of an old part file finds `media/tada.wav`.

use crate::Workspace;
use kerf_program::{FileRequest, Folder, HostError, SourceFile};

/// The name of the folder of sounds in the data folder.
pub const MEDIA: &str = "media";

/// The last part of a name, as any system writes it.
pub fn last_part(name: &str) -> &str {
    name.rsplit(['/', '\\']).next().unwrap_or(name).trim()
}

/// A sound by its name.
pub fn sound(workspace: &mut Workspace, name: &str) -> Result<SourceFile, HostError> {
    let part = FileRequest { folder: Folder::Parts, name: name.into() };
    if let Ok(found) = workspace.source(&part) {
        return Ok(found);
    }
    let same = |known: &String| known.eq_ignore_ascii_case(last_part(name));
    match workspace.names_in_data(MEDIA).into_iter().find(same) {
        Some(found) => workspace.data_source(&format!("{MEDIA}/{found}")),
        None => Err(HostError::NotFound(name.into())),
    }
}
