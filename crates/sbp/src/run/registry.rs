//! SetUsrVal … GetPartFileName: values kept outside the program (handbook, additional registry
//! commands; readings, A-43 … A-45).

use super::eval::number_or_text;
use super::{Context, Stop, eval, questions};
use crate::Value;
use crate::tree::{DialogText, NameId, Registry};
use kerf_diag::Code;
use kerf_program::settings::Mode;
use kerf_program::{Axis, AxisSet, Host};

/// Key of the value of SetUsrVal.
pub const USER_VALUE: &str = "uValue";

/// Key of the value of SetUsrValClrd.
pub(crate) const CLEARED_VALUE: &str = "uValueClrd";

/// Key of the name of the part file that was read last (GetPartFileName, FE, FP at the keyboard).
pub const PART_FILE: &str = "uPartFile";

pub use kerf_program::SPINDLE_STATUS;

/// Key of the program that shows files (UN); the built-in editor without one.
pub const EDITOR: &str = "Editor";

/// Key of the error that ended a run last, with its place.
pub const LAST_ERROR: &str = "LastError";

/// Key of the letters of axes whose base coordinates are not to be trusted: motors were without
/// power, or a run never came to its end.
pub const POSITION_LOST: &str = "PositionLost";

/// Set…: keeps a value.
pub(super) fn store(c: &mut Context<'_>, which: Registry, value: &DialogText) -> Result<(), Stop> {
    let text = questions::dialog_text(c, value)?.trim().to_string();
    let key = match which {
        Registry::SetUsrVal => USER_VALUE,
        Registry::SetUsrValClrd => CLEARED_VALUE,
        _ => {
            need_flag(c, &text)?;
            SPINDLE_STATUS
        }
    };
    c.settle()?;
    c.host.store(key, Some(&text));
    Ok(())
}

fn need_flag(c: &Context<'_>, text: &str) -> Result<(), Stop> {
    match text {
        "0" | "1" => Ok(()),
        _ => {
            let message = format!("spindle status must be 0 or 1, not '{text}'");
            let hint = "0 asks before the next start, 1 counts as running";
            Err(c.fail_at(c.span, Code::OutOfRange, message, hint))
        }
    }
}

/// Get…: puts a kept value into a variable.
pub(super) fn fetch(c: &mut Context<'_>, which: Registry, variable: NameId) -> Result<(), Stop> {
    c.settle()?;
    let value = match which {
        Registry::GetUsrVal => kept(c.host, USER_VALUE),
        Registry::GetUsrValClrd => kept(c.host, CLEARED_VALUE),
        Registry::GetSpindleStatus => match kept(c.host, SPINDLE_STATUS) {
            Value::Number(n) => Value::Number(n),
            _ => Value::Number(0.0),
        },
        Registry::GetUsrPath => Value::text(c.host.user_path()),
        Registry::GetAppPath => Value::text(c.host.app_path()),
        _ => Value::text(last_part_file(c.host)),
    };
    eval::set_variable(c, variable, value);
    Ok(())
}

/// Name of the part file that was read last, also by an earlier run; empty when there is none.
pub(crate) fn last_part_file(host: &mut dyn Host) -> String {
    host.stored(PART_FILE).unwrap_or_default()
}

/// The axes whose base coordinates are not to be trusted.
pub(crate) fn lost_axes(host: &mut dyn Host) -> AxisSet {
    let letters = host.stored(POSITION_LOST).unwrap_or_default();
    let axes = letters.chars().filter_map(Axis::from_letter);
    axes.fold(AxisSet::EMPTY, AxisSet::with)
}

/// Remembers which axes are not to be trusted; a preview moves nothing.
pub(crate) fn remember_lost(c: &mut Context<'_>, axes: AxisSet) {
    if c.settings().mode == Mode::Preview || axes == lost_axes(c.host) {
        return;
    }
    let letters: String = axes.iter().map(Axis::letter).collect();
    c.host.store(POSITION_LOST, Some(letters.as_str()).filter(|l| !l.is_empty()));
}

fn kept(host: &mut dyn Host, key: &str) -> Value {
    number_or_text(&host.stored(key).unwrap_or_default())
}
