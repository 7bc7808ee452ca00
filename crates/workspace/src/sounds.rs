//! Sounds: files of the part folder, else of the folder of sounds in the data folder, where only the last
//! part of a name counts. So `C:\WINDOWS\Media\tada.wav` of an old part file finds `media/tada.wav`.

/// The name of the folder of sounds in the data folder.
pub const MEDIA: &str = "media";

/// The last part of a name, as any system writes it.
pub fn last_part(name: &str) -> &str {
    name.rsplit(['/', '\\']).next().unwrap_or(name).trim()
}

/// The name in the data folder of a sound that lies in the folder of sounds among these.
pub(crate) fn find(own: Vec<String>, name: &str) -> Option<String> {
    let found = own.into_iter().find(|known| known.eq_ignore_ascii_case(last_part(name)))?;
    Some(format!("{MEDIA}/{found}"))
}
