//! TH, the Header Writer: tells at the head of a part file what it needs.

use crate::entries::Mistake;
use crate::field::{Field, Kind, choice, text};
use crate::lines::part_name;
use crate::{Entries, FileFolder, OutputFile, Tool, ToolOutput};

const FIELDS: &[Field] = &[
    Field {
        key: "file",
        label: "Part file",
        kind: Kind::File,
        default: "",
        doc: "The file that gets the header; as it is now it is kept as .bak.",
    },
    text("contact", "Contact"),
    text("restrictions", "Restrictions"),
    text("material", "Material"),
    text("bit", "Bit"),
    choice("units", "Units", &["not told", "in", "mm"]),
    text("zero", "Zero").about("Where X, Y and Z are zero."),
    choice("offset", "Offset", &["not told", "none", "3D", "2D"]),
    text("notes", "Notes"),
    Field {
        key: "before",
        label: "Run before",
        kind: Kind::File,
        default: "",
        doc: "A part file that runs first.",
    },
    Field {
        key: "after",
        label: "Run after",
        kind: Kind::File,
        default: "",
        doc: "A part file that runs last.",
    },
];

pub const TOOL: Tool = Tool {
    letter: 'H',
    name: "Header Writer",
    doc: "Writes what a job needs at the head of its part file, and files to run before and after.",
    fields: FIELDS,
    make,
};

/// Lines that a header may have, in their order: the word, and the key of its field.
const TOLD: [(&str, &str); 8] = [
    ("Contact", "contact"),
    ("Restrictions", "restrictions"),
    ("Material", "material"),
    ("Bit", "bit"),
    ("Units", "units"),
    ("Zero", "zero"),
    ("Offset", "offset"),
    ("Notes", "notes"),
];

fn make(entries: &Entries<'_>) -> Result<ToolOutput, Vec<Mistake>> {
    let name = part_name(entries.text("file"));
    let Some(before) = entries.file(&name) else {
        let text = "the name of a part file that is there";
        return Err(vec![Mistake::new("file", text)]);
    };
    let filled =
        |(_, key): &(&str, &str)| !entries.text(key).is_empty() && entries.text(key) != "not told";
    let told: Vec<String> = TOLD
        .into_iter()
        .filter(filled)
        .map(|(label, key)| format!("{label}: {}", entries.text(key)))
        .collect();
    if told.is_empty() {
        return Err(vec![Mistake::new("", "at least one field of the header")]);
    }
    let run = |key: &str| Some(entries.text(key)).filter(|name| !name.is_empty());
    let text = with_header(&before, &told, run("before"), run("after"));
    let backup = format!("{}.bak", name.rsplit_once('.').map_or(&*name, |(stem, _)| stem));
    let file = |name, text| OutputFile { place: FileFolder::Parts, name, text };
    Ok(ToolOutput { files: vec![file(name, text), file(backup, before)], notes: Vec::new() })
}

/// A part file with a header, and files that run before and after.
pub fn with_header(
    text: &str,
    told: &[String],
    before: Option<&str>,
    after: Option<&str>,
) -> String {
    let mut lines: Vec<String> = told.iter().map(|line| format!("'{line}")).collect();
    lines.extend(before.map(|name| format!("FP,{name}")));
    lines.extend(text.lines().map(str::to_owned));
    if let Some(name) = after {
        let last = lines.iter().rposition(|line| line.trim().eq_ignore_ascii_case("END"));
        let ends = last.filter(|last| lines[last + 1..].iter().all(|l| l.trim().is_empty()));
        lines.insert(ends.unwrap_or(lines.len()), format!("FP,{name}"));
    }
    lines.join("\n") + "\n"
}

#[cfg(test)]
mod tests {
    use crate::{Folders, tool};

    /// A folder with a door in it.
    struct Door;

    impl Folders for Door {
        fn text(&self, name: &str) -> Option<String> {
            (name == "door.sbp").then(|| "MX,1\nEND\n".to_owned())
        }

        fn font(&self, name: &str) -> Result<Vec<u8>, String> {
            ().font(name)
        }
    }

    #[test]
    fn the_header_stands_first_and_the_original_is_kept() {
        let th = tool('H').expect("TH");
        let line = "file=door,contact=Ann,material=birch,units=mm,before=warm.sbp,after=park.sbp";
        let made = th.make(&th.read_line(line), false, &Door).expect("made");
        let head = "'Contact: Ann\n'Material: birch\n'Units: mm\nFP,warm.sbp\nMX,1\n";
        assert_eq!(made.files[0].text, format!("{head}FP,park.sbp\nEND\n"));
        assert_eq!((&*made.files[1].name, &*made.files[1].text), ("door.bak", "MX,1\nEND\n"));
        let wrong = |line: &str| th.make(&th.read_line(line), false, &Door).expect_err("wrong");
        assert_eq!(wrong("file=no.sbp,contact=x")[0].field, "file");
        assert!(wrong("file=door")[0].text.contains("at least one field"));
    }
}
