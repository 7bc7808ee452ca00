//! The switches of the simulated machine, as somebody left them: they stay so when Kerf is started anew,
//! and for a run that is taken up.

use crate::facts::Fact;

/// The value that holds them: `3:1 5:0`.
pub const SWITCHES: &str = Fact::SimulatedSwitches.key();

/// Switches that somebody moved, and whether each was left closed.
pub type Switches = Vec<(u8, bool)>;

/// Reads them; what is no switch is left out.
pub fn read(text: &str) -> Switches {
    let one = |word: &str| {
        let (number, on) = word.split_once(':')?;
        Some((number.parse().ok()?, on == "1"))
    };
    text.split(' ').filter_map(one).collect()
}

/// As they are kept; nothing where nobody moved any.
pub fn write(switches: &[(u8, bool)]) -> Option<String> {
    let words: Vec<String> =
        switches.iter().map(|(number, on)| format!("{number}:{}", u8::from(*on))).collect();
    (!words.is_empty()).then(|| words.join(" "))
}
