//! Sorts of files, by their names.

use kerf_formats::{Content, Format, ending};
use kerf_wire::FileKind;
use kerf_workspace::parts;

/// Returns the sort of file that a name belongs to.
pub fn kind_of(name: &str) -> FileKind {
    match Format::of_file(name).map(Format::content) {
        Some(Content::Job) => FileKind::Job,
        Some(Content::Drawing) => FileKind::Drawing,
        Some(Content::Picture) | None => FileKind::Program,
    }
}

/// Returns the sort of file as which one is opened, nothing for one that is none, by the mask of part files.
pub fn opens(name: &str, mask: &str) -> Option<FileKind> {
    let is_part = kerf_sbp::is_gcode_name(name) || parts::fits(mask, name);
    match kind_of(name) {
        FileKind::Program => (is_part && ending(name) != "log").then_some(FileKind::Program),
        kind => Some(kind),
    }
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
