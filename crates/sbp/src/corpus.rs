//! Part files as shops write them, the project's own and real ones: what is read, what is refused, and that formatting
//! keeps their meaning.

#[path = "../../../tests/corpus/find.rs"]
pub(crate) mod find;

use crate::syntax::format::tests::keeps_meaning;
use crate::{Dialect, check, read, read_as};
use kerf_diag::{Code, Diagnostic, Severity};
use kerf_program::settings::LinearUnit;
use std::collections::BTreeMap;
use std::path::Path;

/// Files that cannot run as they are; docs/conformance-notes.md says why.
const FAULTY: &[&str] = &[
    "fabmo-dev-tests-app__test_shortmotion.sbp",
    "fabmo-engine__atc_macro_102-60b353.sbp",
    "fabmo-engine__data_request_example-d485d3.sbp",
    "fabmo-engine__default_macro_301-c9b762.sbp",
    "fabmo-engine__desktop_max_macro_3-6e45a6.sbp",
    "fabmo-engine__dt_macro_3.sbp",
    "fabmo-engine__dt_macro_78.sbp",
    "fabmo-engine__dt_macro_9.sbp",
    "fabmo-engine__dtatc_macro_1.sbp",
    "fabmo-engine__dtatc_macro_205.sbp",
    "fabmo-engine__dtatc_macro_71-eaea7c.sbp",
    "fabmo-engine__dtatc_macro_71.sbp",
    "fabmo-engine__dtatc_macro_73-86c7e2.sbp",
    "fabmo-engine__dtatc_macro_73.sbp",
    "fabmo-engine__dtatc_macro_74-2f36d0.sbp",
    "fabmo-engine__dtatc_macro_74.sbp",
    "fabmo-engine__falcon_macro_9-edef06.sbp",
    "fabmo-engine__gantry_1_macro_23-857fa3.sbp",
    "fabmo-engine__gantry_1_macro_305-124003.sbp",
    "fabmo-engine__handibot-2_NEWmacro_78.sbp",
    "fabmo-engine__handibot-2_macro_77.sbp",
    "fabmo-engine__probe_digitize_example.sbp",
    "fabmo-engine__test2.sbp",
    "fabmo-macroinstall-sb-app__macro_3_new_Wbugs-adffbf.sbp",
    "fabmo-production-test-app__y-extents-390c02.sbp",
    "fabmo-production-test-app__y-extents.sbp",
    "fabmo-profile-5axis__macro_1.sbp",
    "fabmo-profile-5axis__macro_3.sbp",
    "fabmo-profile-dt__macro_3-08e495.sbp",
    "fabmo-profile-dt__macro_3-63fa2e.sbp",
    "fabmo-profile-dt__macro_3-cfa349.sbp",
    "fabmo-profile-dt__macro_9-5e19c5.sbp",
    "fabmo-profile-dt__macro_9-ed2ea2.sbp",
    "nist-shopbotpyqt__Test.sbp",
    "voxel-builder__pickup_voxel_all.sbp",
];

/// Findings of the static checks that mean something, file by file.
const DOUBTFUL: &[(&str, &str)] = &[
    ("fablab-5ax__custom4.sbc", "W019"),
    ("fabmo-engine__default_macro_77-6f3935.sbp", "W019"),
    ("fabmo-engine__dtatc_macro_19-f06c4e.sbp", "W006"),
];

/// The files of a folder by name.
fn texts(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let named = |path: &Path| path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let read = |path: &Path| std::fs::read(path).unwrap_or_else(|e| panic!("{path:?}: {e}"));
    find::files(folder).iter().map(|path| (named(path), read(path))).collect()
}

/// Calls `look` with every real file, where they are at hand.
fn with_real(look: impl FnOnce(BTreeMap<String, Vec<u8>>)) {
    if let Some(folder) = find::real("sbp") {
        look(texts(&folder));
    }
}

/// Calls `look` with the project's own files and every real one; and with what it should find, which is `of_real`
/// where real files are at hand, and nothing in the project's own.
fn with_all<T>(of_real: &[T], look: impl FnOnce(BTreeMap<String, Vec<u8>>, &[T])) {
    let mut files = texts(&find::own("sbp"));
    let real = find::real("sbp");
    files.extend(real.iter().flat_map(|folder| texts(folder)));
    look(files, if real.is_some() { of_real } else { &[] });
}

#[test]
fn the_corpus_of_real_files_is_whole() {
    with_real(|files| assert!(files.len() >= 150, "{}", files.len()));
}

#[test]
fn files_that_are_refused_are_at_fault_themselves() {
    with_all(FAULTY, |files, expected| {
        let program = |(name, bytes): (&String, &Vec<u8>)| read(name.as_str().into(), bytes);
        let faulty = files.iter().map(program).filter(|program| program.has_errors());
        let faulty: Vec<String> = faulty.map(|program| program.name.to_string()).collect();
        assert_eq!(faulty, expected);
    });
}

#[test]
fn files_of_fabmo_are_read_in_its_dialect() {
    with_real(|files| {
        let fabmo = files
            .iter()
            .filter(|(name, _)| name.starts_with("fabmo-") && FAULTY.contains(&name.as_str()));
        let program = |(name, bytes): (&String, &Vec<u8>)| {
            read_as(name.as_str().into(), bytes, Dialect::Fabmo)
        };
        let faulty = fabmo.map(program).filter(|program| program.has_errors());
        let faulty: Vec<String> = faulty.map(|program| program.name.to_string()).collect();
        let own_faults = [
            "fabmo-engine__data_request_example-d485d3.sbp",
            "fabmo-engine__falcon_macro_9-edef06.sbp",
            "fabmo-macroinstall-sb-app__macro_3_new_Wbugs-adffbf.sbp",
        ];
        assert_eq!(faulty, own_faults);
    });
}

#[test]
fn the_static_checks_raise_no_false_alarm() {
    with_all(DOUBTFUL, |files, expected| {
        let mut found = Vec::new();
        for (name, bytes) in files.iter().filter(|(name, _)| !FAULTY.contains(&name.as_str())) {
            let program = read(name.as_str().into(), bytes);
            let told = check(&program, Some(LinearUnit::Inch));
            let loud =
                |d: &&Diagnostic| d.severity != Severity::Note && d.code != Code::UnknownLabel;
            found.extend(told.iter().filter(loud).map(|d| (name.clone(), d.code.to_string())));
        }
        found.dedup();
        let found: Vec<_> = found.iter().map(|(n, c)| (n.as_str(), c.as_str())).collect();
        assert_eq!(found, expected);
    });
}

#[test]
fn formatting_keeps_every_file() {
    with_all::<()>(&[], |files, _| {
        for bytes in files.values() {
            keeps_meaning(&read("".into(), bytes).text);
        }
    });
}
