//! Values that programs and other software keep under a key.

use crate::facts::is_fact;

/// Refuses a key or a value that other programs could not read: they see a line each, `key=value`; and keys of
/// which the machine tells the value.
///
/// # Errors
/// What is wrong, for the user.
pub fn check_value(key: &str, value: Option<&str>) -> Result<(), String> {
    let breaks = |text: &str| text.contains(char::is_control);
    match value {
        _ if key.trim().is_empty() => Err("a value has a key: its name is empty".into()),
        _ if breaks(key) || key.contains('=') => {
            Err(format!("{key:?} is no key: it takes no line break and no ="))
        }
        _ if is_fact(key) => Err(format!("the machine tells {key}, nobody sets it")),
        Some(value) if breaks(value) => Err(format!(
            "a value is one line, and that of {key} has a line break or another control character"
        )),
        _ => Ok(()),
    }
}
