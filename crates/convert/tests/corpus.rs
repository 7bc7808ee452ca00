//! Files as shops write them: what is converted moves as before, there and back, and takes as long.

use crate::find;
use crate::support::{GENERIC, GRBL, LINUXCNC, SBP, converted, followed, plain};
use kerf_convert::{Language, cutting_s};
use kerf_diag::Code;
use kerf_program::settings::LinearUnit;
use std::path::Path;

/// Feeds may differ by this share: what VS leaves on shallow slopes.
const SAME_SHARE: f64 = 0.006;

#[test]
fn part_files_there_and_back() {
    there_and_back("sbp", SBP, &[LINUXCNC, GRBL, GENERIC], 12, 65);
}

#[test]
fn gcode_there_and_back() {
    there_and_back("gcode", GENERIC, &[SBP], 10, 55);
}

/// Converts the project's own files of a kind, and the real ones where they are at hand; of each so many at least.
fn there_and_back(kind: &str, from: Language, targets: &[Language], own: usize, real: usize) {
    folder_there_and_back(&find::own(kind), from, targets, own);
    if let Some(folder) = find::real(kind) {
        folder_there_and_back(&folder, from, targets, real);
    }
}

fn folder_there_and_back(folder: &Path, from: Language, targets: &[Language], least: usize) {
    let mut done = 0;
    for file in find::files(folder) {
        let name = file.file_name().unwrap().to_string_lossy();
        let bytes = std::fs::read(&file).unwrap();
        let known = Language::of_file(&name, Default::default()).is_some();
        // A tenth of the corpus is most of its bytes; the rest says as much.
        if !known || bytes.len() > 300_000 || ENDLESS.contains(&&*name) {
            continue;
        }
        for to in targets {
            let unit = unit_of(&bytes);
            done += usize::from(one(&name, &bytes, from, *to, unit, folder));
        }
    }
    assert!(done >= least * targets.len(), "{done} of {} were converted", folder.display());
}

/// Files that wait for an input in a loop.
const ENDLESS: [&str; 2] = ["fabmo-engine__example-ab886a.sbp", "fablab-5ax__sample_exrcis.sbp"];

/// The unit that a part file wants the machine in.
fn unit_of(bytes: &[u8]) -> LinearUnit {
    let text = String::from_utf8_lossy(bytes).replace(' ', "");
    if text.contains("%(25)=0") { LinearUnit::Mm } else { LinearUnit::Inch }
}

/// Converts there and back; false when the file does not run.
fn one(
    name: &str,
    bytes: &[u8],
    from: Language,
    to: Language,
    unit: LinearUnit,
    folder: &Path,
) -> bool {
    let how = plain(from, to, unit);
    let there = converted(name, bytes, &how, folder.into());
    let wrong = there.diagnostics.iter().find(|d| d.code == Code::ConversionDiffers);
    assert_eq!(wrong, None, "{name}");
    let Some(text) = there.text else { return false };
    let mm = text.contains("G21 G") || text.contains("'UNITS: MM");
    let unit = if mm { LinearUnit::Mm } else { LinearUnit::Inch };
    let back_how = plain(to, from, unit);
    let back = converted("there", text.as_bytes(), &back_how, folder.into());
    let wrong: Vec<_> = back.diagnostics.iter().filter(|d| d.is_error()).collect();
    assert!(back.text.is_some(), "{name} back: {wrong:?}");
    let feeds_told = there.diagnostics.iter().any(|d| d.message.contains("VS begins"));
    if !feeds_told {
        let first = cutting_s(&followed(name, bytes, &how, folder.into()), &how.settings);
        let second = followed("there", text.as_bytes(), &back_how, folder.into());
        let second = cutting_s(&second, &back_how.settings);
        assert!(
            (first - second).abs() <= SAME_SHARE * first + 1e-6,
            "{name}: {first} s, {second} s"
        );
    }
    true
}
