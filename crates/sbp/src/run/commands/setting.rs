//! The settings behind the parameters of a command.

use crate::run::{Arguments, Context};
use kerf_program::Settings;

/// The settings as they will be when the values given are put where they belong.
pub(super) fn changed(c: &Context<'_>, a: &Arguments) -> Settings {
    let mut settings = c.settings().clone();
    for (index, param) in a.params().iter().enumerate() {
        if let (Some(setting), Some(value)) = (param.setting, a.value(index)) {
            (setting.write)(&mut settings, value);
        }
    }
    settings
}

/// Sets what is given, without further check.
pub(super) fn set(c: &mut Context<'_>, a: &Arguments) {
    let settings = changed(c, a);
    c.change_settings(|s| *s = settings);
}
