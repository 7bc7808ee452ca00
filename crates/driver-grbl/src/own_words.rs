//! Errors, alarms and settings in the words of the board, where it has lists of them (`$EE`, `$EA`, `$ES`, `$EG`,
//! `$SED`).

use std::collections::BTreeMap;

/// A setting as the board describes it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct OwnSetting {
    /// Its name, behind that of its group.
    pub name: String,
    /// The unit of its value; empty where it has none.
    pub unit: String,
    /// Least and greatest value, where it tells them.
    pub bounds: (Option<f64>, Option<f64>),
}

/// Lists of a board.
#[derive(Clone, Debug, Default)]
pub struct OwnWords {
    /// It has lists.
    pub has: bool,
    /// It was asked for those of errors and alarms.
    pub asked: bool,
    /// Its errors by their numbers.
    pub errors: BTreeMap<u16, String>,
    /// The same of its alarms.
    pub alarms: BTreeMap<u16, String>,
    /// Names of groups of settings.
    groups: BTreeMap<u16, String>,
    settings: BTreeMap<u16, OwnSetting>,
    /// It describes a setting when it is asked (`$SED`).
    pub describes: bool,
    descriptions: BTreeMap<u16, String>,
}

impl OwnWords {
    /// Learns from a line in brackets, by its name and what stands behind it.
    pub fn bracket(&mut self, name: &str, value: &str) {
        match name {
            "ERRORCODE" => self.errors.extend(worded(value)),
            "ALARMCODE" => self.alarms.extend(worded(value)),
            "SETTINGGROUP" => self.groups.extend(group(value)),
            "SETTING" => self.settings.extend(self.setting(value)),
            "SETTINGDESCR" => self.descriptions.extend(described(value)),
            _ => {}
        }
    }

    /// Returns a setting as the board describes it.
    pub fn of(&self, number: u16) -> Option<&OwnSetting> {
        self.settings.get(&number)
    }

    /// Returns what a setting does, as the board describes it; empty where it does not.
    pub fn description(&self, number: u16) -> &str {
        self.descriptions.get(&number).map_or("", String::as_str)
    }

    /// Reads `110|43|X-axis maximum rate|mm/min|6|#####0.000|0|5000|…`.
    fn setting(&self, line: &str) -> Option<(u16, OwnSetting)> {
        let fields: Vec<&str> = line.split('|').collect();
        let [number, group, name, unit, ..] = fields.as_slice() else { return None };
        let bound = |n: usize| fields.get(n).and_then(|field| field.parse::<f64>().ok());
        let group = group.parse().ok().and_then(|group| self.groups.get(&group));
        let name = group.map_or_else(|| (*name).to_owned(), |group| format!("{group}: {name}"));
        let setting = OwnSetting { name, unit: (*unit).to_owned(), bounds: (bound(6), bound(7)) };
        Some((number.parse().ok()?, setting))
    }
}

/// Reads `5||Text.` of a list of errors or alarms; nothing where it has no text.
fn worded(line: &str) -> Option<(u16, String)> {
    let (number, text) = line.split_once("||")?;
    let text = text.trim_end_matches('.');
    (!text.is_empty()).then_some((number.parse().ok()?, text.to_owned()))
}

/// Reads `110|Maximum rate.\n\nNOTE: …`, a description in which the ends of lines are written as `\n`.
fn described(line: &str) -> Option<(u16, String)> {
    let (number, text) = line.split_once('|')?;
    let lines = text.split("\\n").map(str::trim).filter(|line| !line.is_empty());
    Some((number.parse().ok()?, lines.collect::<Vec<_>>().join("\n")))
}

/// Reads `43|0|X-axis`, a group of settings.
fn group(line: &str) -> Option<(u16, String)> {
    let (number, rest) = line.split_once('|')?;
    Some((number.parse().ok()?, rest.rsplit_once('|')?.1.to_owned()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_of_a_board_are_read() {
        let mut own = OwnWords::default();
        own.bracket("SETTINGGROUP", "43|0|X-axis");
        own.bracket("SETTING", "110|43|Fastest|mm/min|6|#####0.000|1|5000|0|0");
        own.bracket("SETTING", "13|1|Inches||0||||0|0");
        own.bracket("ERRORCODE", "0||");
        own.bracket("ERRORCODE", "20||No such word.");
        own.bracket("SETTINGDESCR", "110|How fast.\\n\\nNOTE: not the others.");
        own.bracket("SETTINGDESCR", "13|");
        let bounds = (Some(1.0), Some(5000.0));
        let fastest = OwnSetting { name: "X-axis: Fastest".into(), unit: "mm/min".into(), bounds };
        assert_eq!(own.of(110), Some(&fastest));
        assert_eq!(own.of(13).map(|it| &*it.name), Some("Inches"));
        assert_eq!(own.description(110), "How fast.\nNOTE: not the others.");
        assert_eq!((own.description(13), own.description(999)), ("", ""));
        assert_eq!(own.errors.into_iter().collect::<Vec<_>>(), [(20, "No such word".into())]);
    }
}
