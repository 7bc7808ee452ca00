//! Sorts of files, by their names.

use kerf_import::job_file;
use kerf_wire::FileKind;
use kerf_workspace::parts;

/// Returns the sort of file that a name belongs to.
pub fn kind_of(name: &str) -> FileKind {
    match extension(name).as_str() {
        job_file::EXTENSION => FileKind::Job,
        "rsg" | "dxf" | "svg" | "plt" | "hpg" | "hpgl" => FileKind::Drawing,
        _ => FileKind::Program,
    }
}

/// Returns the sort of file as which one is opened, nothing for one that is none, by the mask of part files.
pub fn opens(name: &str, mask: &str) -> Option<FileKind> {
    let is_part = kerf_sbp::is_gcode_name(name) || parts::fits(mask, name);
    match kind_of(name) {
        FileKind::Program => (is_part && extension(name) != "log").then_some(FileKind::Program),
        kind => Some(kind),
    }
}

/// The extension of a name, in small letters.
pub fn extension(name: &str) -> String {
    name.rsplit_once('.').map(|(_, extension)| extension.to_ascii_lowercase()).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_can_be_opened_is_told_by_its_name() {
        for (name, mask, kind) in [
            ("a.sbp", "*.sb?", Some(FileKind::Program)),
            ("a.nc", "*.sb?", Some(FileKind::Program)),
            ("a.cut", "*.cut", Some(FileKind::Program)),
            ("a.sbp", "*.cut", None),
            ("a.PLT", "*.sb?", Some(FileKind::Drawing)),
            ("a.rsm", "*.sb?", Some(FileKind::Job)),
            ("a.log", "*.*", None),
            ("a.txt", "*.sb?", None),
        ] {
            assert_eq!(opens(name, mask), kind, "{name} {mask}");
        }
    }
}
