//! The machine that the journal knows: `machine.toml` as Kerf left it last.
//!
//! Whoever writes the file through Kerf leaves its text here, before it is in its place and after. A text that is not
//! known is somebody's edit, an older file that came back, or a file that lost its bytes: it holds, and it is told;
//! locations are confirmed once, since lengths, units and motors may be others.

use super::rows::{Table, json};
use super::settings::unusable;
use super::{Journal, JournalError};
use crate::machine_file::MachineFile;
use kerf_machine::{Configuration, table};

/// Name of the fact: texts that may lie there, the newest last. There are two while one takes the place of the other.
const KNOWN: &str = "machine";

/// So many settings are named of those that are others.
const NAMED: usize = 4;

/// The machine that a journal knows.
pub struct KnownMachine<'a>(pub &'a Journal);

impl KnownMachine<'_> {
    /// The file is about to be written. Gives whether it is known as it is; else the next look at it tells.
    pub fn expects(&self, before: Option<&str>, text: &str) -> Result<bool, JournalError> {
        let known = self.texts()?;
        let before = before.map(str::to_owned);
        if !known.is_empty() && !known.contains(&before) {
            return Ok(false);
        }
        self.keep(&[before, Some(text.to_owned())])?;
        Ok(true)
    }

    /// The file says this from now on.
    pub fn is(&self, text: Option<&str>) -> Result<(), JournalError> {
        self.keep(&[text.map(str::to_owned)])
    }

    /// Looks at the file. Where it describes another machine than Kerf left, that is told, once.
    pub fn meet(&self) -> Result<Option<String>, JournalError> {
        let file = self.0.machine_file();
        // Another file is its owner's: Kerf is told of it at every start.
        if !file.is_of(self.0.folder()) {
            return Ok(None);
        }
        let (text, known) = (file.text().map_err(unusable)?, self.texts()?);
        match known.last() {
            Some(last) if !known.contains(&text) => self.meet_another(&file, text, last.as_deref()),
            Some(_) if known.len() == 1 => Ok(None),
            _ => self.is(text.as_deref()).map(|()| None),
        }
    }

    fn meet_another(
        &self,
        file: &MachineFile,
        text: Option<String>,
        known: Option<&str>,
    ) -> Result<Option<String>, JournalError> {
        // Its mistakes are told by whoever needs it, and nothing moves with them.
        let Ok(now) = file.read(text.as_deref().unwrap_or_default()) else { return Ok(None) };
        let before = file.read(known.unwrap_or_default()).unwrap_or_default();
        let others = others(&before, &now);
        if others.is_empty() {
            return self.is(text.as_deref()).map(|()| None);
        }
        let kept = known.map(|known| file.keep_beside(known)).transpose().map_err(unusable)?;
        let mend = kept.map_or_else(String::new, |kept| {
            format!(
                "; as Kerf left it, it is kept as {}: put that in its place to have it back",
                kept.display()
            )
        });
        self.is(text.as_deref())?;
        let how = match text.as_deref().map(str::trim) {
            None => "is gone",
            Some("") => "is empty",
            Some(_) => "is not as Kerf left it",
        };
        Ok(Some(format!(
            "{} {how}: {others}{mend}. Locations are not verified: home the machine, zero its axes anew, or confirm them",
            file.name()
        )))
    }

    fn texts(&self) -> Result<Vec<Option<String>>, JournalError> {
        let text = self.0.read(|rows| rows.text(Table::Fact, KNOWN))?;
        Ok(self.0.parsed(KNOWN, text)?.unwrap_or_default())
    }

    fn keep(&self, texts: &[Option<String>]) -> Result<(), JournalError> {
        self.0.write(|rows| rows.put(Table::Fact, KNOWN, &json(&texts)?))
    }
}

/// The settings that are others, in words. Nobody reads the hash of a password.
fn others(before: &Configuration, now: &Configuration) -> String {
    let changed: Vec<_> = table::changed(before, now).collect();
    let one = |setting: &&table::Setting| match setting.key {
        "options.password" => "options.password is another".to_owned(),
        key => format!("{key} was {} and is {}", setting.get(before), setting.get(now)),
    };
    let mut told = changed.iter().take(NAMED).map(one).collect::<Vec<_>>().join(", ");
    if changed.len() > NAMED {
        told += &format!(", and {} more", changed.len() - NAMED);
    }
    told
}
