//! Sorts of files, by their names.

use kerf_import::job_file;
use kerf_wire::FileKind;

/// Returns the sort of file that a name belongs to.
pub fn kind_of(name: &str) -> FileKind {
    match extension(name).as_str() {
        job_file::EXTENSION => FileKind::Job,
        "rsg" | "dxf" | "svg" | "plt" | "hpg" | "hpgl" => FileKind::Drawing,
        _ => FileKind::Program,
    }
}

/// The extension of a name, in small letters.
pub fn extension(name: &str) -> String {
    name.rsplit_once('.').map(|(_, extension)| extension.to_ascii_lowercase()).unwrap_or_default()
}
