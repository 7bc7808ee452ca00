//! The settings behind the parameters of the V commands.
//!
//! A V command shows and changes settings by position. Each of its parameters names the place of
//! its value, so that one function carries all V commands out and another writes the present values
//! back as the lines of a part file: for fill-in sheets, UV and the settings file.

use super::{CommandSpec, Kind, ParamSpec};
use crate::syntax::{Value, format_number};
use kerf_program::Settings;
use kerf_program::settings::to_user;

/// The place of a value in the settings.
#[derive(Clone, Copy, Debug)]
pub struct Setting {
    /// The value that holds, in internal units; `None` when it has none.
    pub read: fn(&Settings) -> Option<Value>,
    /// Puts a checked value in internal units there.
    pub write: fn(&mut Settings, &Value),
}

/// The place of a number: `real!(cutter.diameter_mm)`.
macro_rules! real {
    ($($place:tt)+) => {
        $crate::syntax::table::Setting {
            read: |s| Some($crate::syntax::Value::Number(s.$($place)+)),
            write: |s, v| s.$($place)+ = v.number().unwrap_or(s.$($place)+),
        }
    };
}

/// The place of a whole number.
macro_rules! whole {
    ($($place:tt)+) => {
        $crate::syntax::table::Setting {
            read: |s| Some($crate::syntax::Value::Number(f64::from(s.$($place)+))),
            write: |s, v| if let Some(n) = v.number() { s.$($place)+ = n as _ },
        }
    };
}

/// The place of something that is on (1) or off (0).
macro_rules! flag {
    ($($place:tt)+) => {
        $crate::syntax::table::Setting {
            read: |s| Some($crate::syntax::Value::Number(f64::from(u8::from(s.$($place)+)))),
            write: |s, v| s.$($place)+ = v.number().map_or(s.$($place)+, |n| n != 0.0),
        }
    };
}

/// The place of an axis.
macro_rules! axis {
    ($($place:tt)+) => {
        $crate::syntax::table::Setting {
            read: |s| Some($crate::syntax::Value::text(s.$($place)+.letter().to_string())),
            write: |s, v| {
                let letter = v.display().chars().next();
                s.$($place)+ = letter.and_then(Axis::from_letter).unwrap_or(s.$($place)+);
            },
        }
    };
}

pub(super) use {axis, flag, real, whole};

impl ParamSpec {
    /// The value that holds, as a part file writes it in the user's units.
    pub fn present(&self, settings: &Settings) -> Option<String> {
        let value = (self.setting?.read)(settings)?;
        Some(match (self.kind, value) {
            (Kind::Number(unit) | Kind::NumberOrOff(unit), Value::Number(n)) => {
                plain(to_user(n, unit.scale(settings)))
            }
            (_, value) => value.display(),
        })
    }

    /// The value a fresh machine has, in inches.
    pub fn factory(&self) -> Option<String> {
        self.present(&Settings::default())
    }
}

impl CommandSpec {
    /// The line of a part file that sets the values which hold; `None` for other commands.
    pub fn present(&self, settings: &Settings) -> Option<String> {
        self.params.iter().find(|p| p.setting.is_some())?;
        let values = self.params.iter().map(|p| p.present(settings).unwrap_or_default());
        let line = values.fold(self.letters.to_string(), |line, value| line + "," + &value);
        Some(line.trim_end_matches(',').to_string())
    }
}

/// A number with all its digits, for files that are read again; short where that loses nothing.
pub(super) fn plain(n: f64) -> String {
    let short = format_number(n);
    if short.parse() == Ok(n) { short } else { format!("{n}") }
}
