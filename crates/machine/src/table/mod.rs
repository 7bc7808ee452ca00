//! The one table of settings: every setting of a machine with its key, unit, bounds and meaning.
//!
//! The configuration file, its reader, `kerf machine` and every form are made from it. Keys are
//! dotted: what stands before the last dot is the section of the file.

mod board;
mod bounds;
mod drivers;
mod machine;
mod plain;
mod program;
mod setting;
mod switches;
mod tools;
mod values;

pub use bounds::{Bounds, Unit};
pub use setting::{Area, Refused, Setting};

use crate::settings::Configuration;

/// Every area, in the order in which files are written and read.
pub const AREAS: &[&[Area]] = &[
    program::AREAS,
    values::AREAS,
    machine::AREAS,
    tools::AREAS,
    switches::AREAS,
    board::AREAS,
    drivers::AREAS,
];

/// Every area.
pub fn areas() -> impl Iterator<Item = &'static Area> {
    AREAS.iter().copied().flatten()
}

/// Every setting.
pub fn settings() -> impl Iterator<Item = &'static Setting> {
    areas().flat_map(|area| area.rows)
}

/// The setting of a key.
pub fn setting(key: &str) -> Option<&'static Setting> {
    settings().find(|setting| setting.key.eq_ignore_ascii_case(key))
}

/// The settings in which two configurations differ, in the order of the table.
pub fn changed<'a>(
    before: &'a Configuration,
    after: &'a Configuration,
) -> impl Iterator<Item = &'static Setting> + 'a {
    settings().filter(|setting| setting.get(before) != setting.get(after))
}

/// Settings that an area shows beside its own: one value, two places (readings, P-99).
fn also(area: &Area) -> impl Iterator<Item = &'static Setting> {
    let keys: &[&str] = match area.title {
        "Options of the program" => {
            &["misc.double_start", "homing.at_program_start", "homing.at_job_start"]
        }
        _ => &[],
    };
    keys.iter().filter_map(|key| setting(key))
}

impl Area {
    /// The settings it shows of a machine: its own, those it shares with another, and none of a tool that
    /// is not there.
    pub fn shown<'a>(
        &'a self,
        c: &'a Configuration,
    ) -> impl Iterator<Item = &'static Setting> + 'a {
        self.rows.iter().chain(also(self)).filter(|setting| setting.applies(c))
    }
}
