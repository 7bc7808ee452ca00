//! A row of the table: a setting with its key, unit, bounds and meaning, and how it is read and set.

use super::bounds::{Bounds, Unit};
use crate::settings::Configuration;
use crate::value::Value;

/// One setting.
pub struct Setting {
    /// Its name, dotted.
    pub key: &'static str,
    /// Unit of its numbers.
    pub unit: Unit,
    /// Values that it accepts beside its type.
    pub bounds: Bounds,
    /// Its purpose.
    pub doc: &'static str,
    pub(super) get: fn(&Configuration) -> Value,
    pub(super) put: fn(&mut Configuration, &Value) -> Result<(), String>,
    pub(super) words: fn(&Configuration) -> Vec<&'static str>,
}

impl std::fmt::Debug for Setting {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.key)
    }
}

/// Settings that belong together, with the section of the manual that tells of them.
pub struct Area {
    /// Its name, as people say it.
    pub title: &'static str,
    /// Manual and section.
    pub manual: &'static str,
    /// Its settings.
    pub rows: &'static [Setting],
}

/// A value that was refused, and what the setting accepts.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{key} must be {wanted}, not {got}")]
pub struct Refused {
    /// The setting.
    pub key: &'static str,
    /// Values that it accepts.
    pub wanted: String,
    /// The value that was given.
    pub got: Value,
}

impl Setting {
    /// Returns `true` if it has a meaning on a machine: settings of a laser or plasma torch have none without one.
    pub fn applies(&self, c: &Configuration) -> bool {
        // What has to be said before there is a laser or a torch.
        let first = ["laser.use", "laser.type", "plasma.use"].contains(&self.key);
        let of = |area: &str| self.key.starts_with(area) && !first;
        (c.laser.use_laser || !of("laser.")) && (c.plasma.use_sequence || !of("plasma."))
    }

    /// Its value in a configuration.
    pub fn get(&self, configuration: &Configuration) -> Value {
        (self.get)(configuration)
    }

    /// Its value in a fresh configuration.
    pub fn default(&self) -> Value {
        self.get(&Configuration::default())
    }

    /// The words it accepts, when it is a choice of words; `none` where it may be absent.
    pub fn words(&self) -> Vec<&'static str> {
        (self.words)(&Configuration::default())
    }

    /// Sets it; a speed may carry its unit. The configuration stays as it was where the value is refused.
    ///
    /// # Errors
    /// What the setting accepts, when the value is none of it.
    pub fn set(&self, configuration: &mut Configuration, value: &Value) -> Result<(), Refused> {
        let mut changed = configuration.clone();
        let fits = self.unit.plain(value).and_then(|plain| {
            self.bounds.check(&plain)?;
            (self.put)(&mut changed, &self.bounds.meant(plain))
        });
        match fits {
            Ok(()) => *configuration = changed,
            Err(wanted) => return Err(Refused { key: self.key, wanted, got: value.clone() }),
        }
        Ok(())
    }

    /// The section of the file it stands in, and its name there.
    pub fn section(&self) -> (&'static str, &'static str) {
        self.key.rsplit_once('.').unwrap_or(("", self.key))
    }
}

/// A row: key, the field it is a view of, unit, bounds, meaning.
macro_rules! row {
    ($c:ident, $key:expr, $place:expr, $unit:ident, $bounds:expr, $doc:expr) => {
        $crate::table::Setting {
            key: $key,
            unit: $crate::table::Unit::$unit,
            bounds: $bounds,
            doc: $doc,
            get: |$c| $crate::table::plain::Plain::value(&$place),
            put: |$c, value| $crate::table::plain::Plain::put(&mut $place, value),
            words: |$c| $crate::table::plain::Plain::words(&$place),
        }
    };
}
pub(super) use row;
