//! Names that are no good for a new file, though a disk would take them.

/// Names that Windows keeps for devices, with any ending.
const DEVICES: [&str; 22] = [
    "CON", "PRN", "AUX", "NUL", "COM1", "COM2", "COM3", "COM4", "COM5", "COM6", "COM7", "COM8",
    "COM9", "LPT1", "LPT2", "LPT3", "LPT4", "LPT5", "LPT6", "LPT7", "LPT8", "LPT9",
];

/// Signs that change the direction of reading or have no width: two names look alike, or one looks like another.
const HIDDEN: [std::ops::RangeInclusive<char>; 5] = [
    '\u{200B}'..='\u{200F}',
    '\u{202A}'..='\u{202E}',
    '\u{2028}'..='\u{2029}',
    '\u{2060}'..='\u{2069}',
    '\u{FEFF}'..='\u{FEFF}',
];

/// Refuses a part of a name for a new file, and says why.
pub fn why_not(part: &str) -> Option<String> {
    let stem = part.split('.').next().unwrap_or(part).trim_end().to_ascii_uppercase();
    let shown = part.escape_debug();
    let hidden = |sign: char| sign.is_control() || HIDDEN.iter().any(|signs| signs.contains(&sign));
    if part.contains(hidden) {
        Some(format!("'{shown}' has a sign that nobody sees: leave it out"))
    } else if part.ends_with(['.', ' ']) {
        Some(format!(
            "'{shown}' ends with a dot or a blank, which other computers leave out: end it otherwise"
        ))
    } else if DEVICES.contains(&stem.as_str()) {
        Some(format!("'{shown}' is a device on other computers: choose another name"))
    } else {
        None
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::why_not;

    #[test]
    fn names_that_do_not_travel_are_refused() {
        let check = |name: &str, why: &str| {
            let told = why_not(name);
            assert!(told.as_ref().is_some_and(|told| told.contains(why)), "{name:?}: {told:?}");
        };
        check("a\nb.sbp", "a\\nb.sbp' has a sign that nobody sees");
        check("a\u{202E}pbs.exe", "a sign that nobody sees");
        check("a\u{200B}.sbp", "a sign that nobody sees");
        check("a.sbp.", "ends with a dot or a blank");
        check("a.sbp ", "ends with a dot or a blank");
        check("CON", "is a device");
        check("aux.sbp", "is a device");
        for name in ["a.sbp", "Tür 2.sbp", "console.sbp", "com10.sbp", "日本.nc", "a b.sbp"] {
            assert_eq!(why_not(name), None, "{name}");
        }
    }
}
