//! Conversions in memory.

#![allow(dead_code)]

#[path = "../../../gcode/tests/support/mod.rs"]
mod quiet;

use kerf_convert::{Conversion, Converted, Language, Passage, Source, convert, passage};
use kerf_gcode::Dialect;
use kerf_program::settings::LinearUnit;
use kerf_program::{Axes, Settings};
use std::path::PathBuf;

pub const LINUXCNC: Language = Language::Gcode(Dialect::LinuxCnc);
pub const GRBL: Language = Language::Gcode(Dialect::Grbl);
pub const GENERIC: Language = Language::Gcode(Dialect::Generic);
pub const SBP: Language = Language::OpenSbp;

/// A conversion without anything special, on a machine in a unit.
pub fn plain(from: Language, to: Language, unit: LinearUnit) -> Conversion {
    let mut settings = Settings::default();
    settings.use_linear_unit(unit);
    Conversion {
        from,
        to,
        settings,
        sbp: kerf_sbp::Options { max_lines: 1_000_000, ..kerf_sbp::Options::default() },
        variables: kerf_sbp::Variables::default(),
        keep_variables: false,
        coolant_outputs: [0, 0],
        title: String::new(),
    }
}

/// Converts a text; files it names lie in a folder.
pub fn converted(name: &str, bytes: &[u8], how: &Conversion, folder: PathBuf) -> Converted {
    let source = Source { name: name.into(), bytes, language: how.from };
    convert(&source, how, &mut |follow| follow(&mut quiet::Quiet(folder.clone())))
}

/// Follows a text from zero.
pub fn followed(name: &str, bytes: &[u8], how: &Conversion, folder: PathBuf) -> Passage {
    let source = Source { name: name.into(), bytes, language: how.from };
    let mut hosts = |follow: &mut dyn FnMut(&mut dyn kerf_program::Host) -> Passage| {
        follow(&mut quiet::Quiet(folder.clone()))
    };
    passage(&source, how, &mut hosts, Axes::default())
}
