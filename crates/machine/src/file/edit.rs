//! Settings changed in a text; everything else of it, comments too, stays.

use super::entries::entries;
use super::{read, write};
use crate::settings::Configuration;
use crate::table::Setting;
use std::sync::Arc;

/// The text with a setting as a configuration has it. Where the text has no good place for it, the
/// whole configuration is written anew.
pub fn edit(text: &str, setting: &'static Setting, wanted: &Configuration) -> String {
    edit_all(text, &[setting], wanted)
}

/// The same of several settings at once: what they say together has to make sense, not what each
/// says beside the old values of the others.
pub fn edit_all(text: &str, settings: &[&'static Setting], wanted: &Configuration) -> String {
    let edited = settings.iter().fold(text.to_owned(), |text, setting| put(&text, setting, wanted));
    let says = |read: &Configuration| settings.iter().all(|s| s.get(read) == s.get(wanted));
    let same = read(&Arc::from(""), &edited).is_ok_and(|read| says(&read));
    if same { edited } else { write(wanted) }
}

fn put(text: &str, setting: &Setting, wanted: &Configuration) -> String {
    let line = format!("{} = {}\n", setting.section().1, setting.get(wanted));
    replaced(text, setting, wanted)
        .or_else(|| inserted(text, setting, &line))
        .unwrap_or_else(|| appended(text, setting, &line))
}

/// The value replaced where the setting stands.
fn replaced(text: &str, setting: &Setting, wanted: &Configuration) -> Option<String> {
    let (entries, _) = entries(text);
    let span = entries.into_iter().find(|entry| entry.key == setting.key)?.value_span;
    let (before, after) = (text.get(..span.start)?, text.get(span.end..)?);
    Some(format!("{before}{}{after}", setting.get(wanted)))
}

/// A line put behind the header of its section, or first where it needs none.
fn inserted(text: &str, setting: &Setting, line: &str) -> Option<String> {
    let (section, _) = setting.section();
    if section.is_empty() {
        return Some(format!("{line}{text}"));
    }
    let header = format!("[{section}]");
    let mut at = 0;
    for existing in text.split_inclusive('\n') {
        at += existing.len();
        if existing.trim_start().starts_with(&header) && existing.ends_with('\n') {
            return Some(format!("{}{line}{}", &text[..at], &text[at..]));
        }
    }
    None
}

fn appended(text: &str, setting: &Setting, line: &str) -> String {
    let end = if text.is_empty() || text.ends_with('\n') { "" } else { "\n" };
    format!("{text}{end}[{}]\n{line}", setting.section().0)
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::table;
    use crate::value::Value;

    fn check(text: &str, key: &str, value: &str, expected: &str) {
        let setting = table::setting(key).unwrap();
        let mut wanted = read(&Arc::from("m"), text).unwrap();
        setting.set(&mut wanted, &Value::typed(value)).unwrap();
        assert_eq!(edit(text, setting, &wanted), expected);
    }

    #[test]
    fn a_setting_is_changed_in_its_place() {
        check("axes = 3 # three\n", "axes", "4", "axes = 4 # three\n");
        check(
            "# mine\n[delays]\n# first\nend_s = 1\n",
            "delays.end_s",
            "2",
            "# mine\n[delays]\n# first\nend_s = 2\n",
        );
        check(
            "[delays]\nend_s = 1\n",
            "delays.bottom_s",
            "2",
            "[delays]\nbottom_s = 2\nend_s = 1\n",
        );
        check("", "axes", "4", "axes = 4\n");
        check("axes = 4", "delays.end_s", "2", "axes = 4\n[delays]\nend_s = 2\n");
        check(
            "homing.x = { fitted = true }\n",
            "homing.x.fitted",
            "no",
            "homing.x = { fitted = false }\n",
        );
    }

    #[test]
    fn several_settings_are_changed_as_one() {
        let text = "# heights\n[zpos]\ntop_mm = -10 # up\nsurface_mm = -20\nbottom_mm = -30\n";
        let mut wanted = read(&Arc::from("m"), text).unwrap();
        let settings = ["zpos.top_mm", "zpos.surface_mm", "zpos.bottom_mm"];
        let settings = settings.map(|key| table::setting(key).unwrap());
        for (setting, value) in settings.iter().zip([-50.0, -60.0, -70.0]) {
            setting.set(&mut wanted, &Value::Number(value)).unwrap();
        }
        let expected = "# heights\n[zpos]\ntop_mm = -50 # up\nsurface_mm = -60\nbottom_mm = -70\n";
        assert_eq!(edit_all(text, &settings, &wanted), expected);
    }

    #[test]
    fn without_a_place_the_file_is_written_anew() {
        let text = "homing.x = { fitted = true }\n";
        let setting = table::setting("homing.x.fast").unwrap();
        let mut wanted = read(&Arc::from("m"), text).unwrap();
        setting.set(&mut wanted, &Value::Number(40.0)).unwrap();
        assert_eq!(read(&Arc::from("m"), &edit(text, setting, &wanted)).unwrap(), wanted);
    }
}
