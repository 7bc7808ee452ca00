//! The switches of the simulated machine, as somebody left them: they stay so when Kerf is started anew,
//! and for a run that is taken up.

/// The value that holds them: `3:1 5:0`.
pub(crate) const SWITCHES: &str = "SimulatedSwitches";

/// Switches that somebody moved, and whether each was left closed.
pub(crate) type Switches = Vec<(u8, bool)>;

/// Reads them; what is no switch is left out.
pub(crate) fn read(text: &str) -> Switches {
    let one = |word: &str| {
        let (number, on) = word.split_once(':')?;
        Some((number.parse().ok()?, on == "1"))
    };
    text.split(' ').filter_map(one).collect()
}

/// As they are kept; nothing where nobody moved any.
pub(crate) fn write(switches: &[(u8, bool)]) -> Option<String> {
    let words: Vec<String> =
        switches.iter().map(|(number, on)| format!("{number}:{}", u8::from(*on))).collect();
    (!words.is_empty()).then(|| words.join(" "))
}
