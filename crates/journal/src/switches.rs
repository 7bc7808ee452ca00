//! The switches of the simulated machine, as somebody left them: they stay so when Kerf is started anew,
//! and for a run that is taken up.

use crate::Press;
use crate::facts::Fact;
use crate::{Journal, JournalError};

/// The value that holds them: `3:1 5:0`.
pub const SWITCHES: &str = Fact::SimulatedSwitches.key();

/// Switches that somebody moved, and whether each was left closed.
pub type Switches = Vec<(u8, bool)>;

impl Journal {
    /// Switches of the simulated machine that somebody moved, and whether each was left closed.
    ///
    /// # Errors
    /// As the journal cannot be read.
    pub fn switches(&self) -> Result<Vec<(u8, bool)>, JournalError> {
        Ok(read(&self.value(SWITCHES)?.unwrap_or_default()))
    }

    /// Somebody moves a switch of the simulated machine, which stands; it stays there.
    ///
    /// # Errors
    /// As the journal cannot be written.
    pub fn move_switch(&self, press: Press) -> Result<(), JournalError> {
        let mut switches = self.switches()?;
        switches.retain(|(number, _)| *number != press.number);
        switches.push((press.number, press.on));
        switches.sort_unstable();
        self.state(Fact::SimulatedSwitches, write(&switches).as_deref())
    }
}

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
