//! From a configuration to the commented text.

use crate::settings::Configuration;
use crate::table::{self, Area, Bounds, Setting, Unit};

/// The whole configuration as a commented file.
pub fn write(configuration: &Configuration) -> String {
    let mut out = String::from(
        "# A machine of Kerf. Numbers are millimetres, millimetres a second, degrees and seconds\n\
         # unless a line says otherwise, whatever unit you read. A line that is left out keeps its\n\
         # default.\n",
    );
    let mut section = "";
    for area in table::areas() {
        out.push_str(&format!("\n# {} ({})\n", area.title, area.manual));
        write_area(&mut out, area, configuration, &mut section);
    }
    out
}

fn write_area(
    out: &mut String,
    area: &Area,
    configuration: &Configuration,
    section: &mut &'static str,
) {
    for setting in area.rows {
        let (of, _) = setting.section();
        if of != *section {
            out.push_str(&format!("[{of}]\n"));
            *section = of;
        }
        out.push_str(&write_setting(setting, configuration));
    }
}

/// One setting: its meaning as a comment, then the line that sets it.
pub fn write_setting(setting: &Setting, configuration: &Configuration) -> String {
    let (_, name) = setting.section();
    let value = setting.get(configuration);
    format!("# {} [{}]\n{name} = {value}\n", setting.doc, setting.notes())
}

/// A long list is not repeated as default.
const LONG: usize = 100;

fn default_note(setting: &Setting) -> String {
    let default = setting.default().to_string();
    if default.len() > LONG { String::new() } else { format!("default {default}") }
}

impl Setting {
    /// Unit, bounds and default in a few words.
    pub fn notes(&self) -> String {
        let notes = [self.unit_note(), self.bounds_note(), default_note(self)];
        notes.into_iter().filter(|note| !note.is_empty()).collect::<Vec<_>>().join("; ")
    }

    fn unit_note(&self) -> String {
        match self.unit {
            Unit::None => String::new(),
            unit => unit.symbol().into(),
        }
    }

    fn bounds_note(&self) -> String {
        match self.bounds {
            Bounds::Any => String::new(),
            bounds => bounds.to_string(),
        }
    }
}
