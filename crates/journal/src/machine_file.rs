//! `machine.toml`: the one place where it is written down what a machine is.
//!
//! V commands, `kerf machine set`, the Profiler tables and the forms of the console are views of it.
//! What a V command changes is written back when the run is over, each value in its place, so that
//! comments and everything else stay as somebody wrote them.

use crate::JournalError;
use crate::known_machine::KnownMachine;
use kerf_diag::Diagnostic;
use kerf_files::{Disk, RealDisk, write_private};
use kerf_machine::profile::PROFILES;
use kerf_machine::{Configuration, Value, contradictions, file, table};
use kerf_program::Settings;
use std::fs::File;
use std::io;
use std::path::{Path, PathBuf};

/// Its name in the data folder.
pub const MACHINE_FILE: &str = "machine.toml";

/// File with the configuration of a machine.
#[derive(Clone, Debug)]
pub struct MachineFile {
    path: PathBuf,
    /// Knows the text that Kerf leaves in it.
    known: Option<KnownMachine>,
}

/// Reason for which a configuration cannot be read or changed.
#[derive(Debug, thiserror::Error)]
pub enum MachineFileError {
    /// The disk.
    #[error("{}: {why}", path.display())]
    Disk {
        /// The file.
        path: PathBuf,
        /// Words of the system.
        why: io::Error,
    },
    /// Its mistakes, a line each.
    #[error("{0}")]
    Mistakes(String),
    /// The journal cannot keep what the file says.
    #[error("{0}")]
    Journal(String),
    /// The settings that a run has made do not go together.
    #[error("{message} ({hint}); the machine's settings stay as they were")]
    Contradiction {
        /// Settings that do not go together, in words.
        message: String,
        /// Remedy.
        hint: String,
    },
}

impl MachineFile {
    /// A file.
    pub fn at(path: impl Into<PathBuf>) -> Self {
        Self { path: path.into(), known: None }
    }

    /// The one of a data folder.
    pub fn of_data(folder: &Path) -> Self {
        Self::at(folder.join(MACHINE_FILE))
    }

    /// The same; a journal knows what Kerf leaves in it, and tells when somebody else leaves another machine there.
    pub(crate) fn known_to(self, known: KnownMachine) -> Self {
        Self { known: Some(known), ..self }
    }

    /// Tells the one of a data folder from others.
    pub(crate) fn is_of(&self, folder: &Path) -> bool {
        self.path == folder.join(MACHINE_FILE)
    }

    /// Its name, for messages.
    pub fn name(&self) -> String {
        self.path.display().to_string()
    }

    /// Locks the files of its folder for as long as this is held: two who change a setting each at the same
    /// moment both do. Where the system has no such locks there is none.
    #[must_use]
    pub fn alone(&self) -> Option<File> {
        let folder = self.path.parent().filter(|folder| !folder.as_os_str().is_empty());
        let folder = folder.unwrap_or(Path::new("."));
        // One that cannot be made is told where the file is written.
        drop(RealDisk.make_folder(folder));
        let folder = File::open(folder).ok()?;
        folder.lock().ok().map(|()| folder)
    }

    /// Puts another machine in its place. What was there is kept beside it, under the name that is given, unless it
    /// is a machine that comes with Kerf.
    ///
    /// # Errors
    /// If it cannot be written, or read.
    pub fn replace(&self, text: &str) -> Result<Option<PathBuf>, MachineFileError> {
        let _alone = self.alone();
        let before = self.text()?.filter(|before| before != text);
        let own = before.filter(|before| PROFILES.iter().all(|ready| ready.text != before));
        self.read(text)?;
        let kept = own.map(|own| self.keep_beside(&own)).transpose()?;
        self.write(text)?;
        Ok(kept)
    }

    /// Keeps a text beside the file, under a name that is free.
    pub(crate) fn keep_beside(&self, text: &str) -> Result<PathBuf, MachineFileError> {
        let name = |n: u32| match n {
            1 => PathBuf::from(format!("{}.before", self.name())),
            n => PathBuf::from(format!("{}.before-{n}", self.name())),
        };
        let free = (1..).map(name).find(|path| !path.exists()).unwrap_or_else(|| name(0));
        write_private(&free, text.as_bytes()).map_err(|error| self.of_disk(error))?;
        Ok(free)
    }

    /// Reads its text; `None` where it is not there.
    ///
    /// # Errors
    /// If it cannot be read.
    pub fn text(&self) -> Result<Option<String>, MachineFileError> {
        match RealDisk.read(&self.path) {
            Ok(bytes) => Ok(Some(String::from_utf8_lossy(&bytes).into_owned())),
            Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
            Err(error) => Err(self.of_disk(error)),
        }
    }

    /// The machine that a text of it describes.
    ///
    /// # Errors
    /// Every mistake in it.
    pub fn read(&self, text: &str) -> Result<Configuration, MachineFileError> {
        let read = file::read(&self.name().into(), text);
        read.map_err(|found| MachineFileError::Mistakes(mistake_lines(&found)))
    }

    /// Puts a text in its place, whole or not at all, once it is known that it can be read.
    ///
    /// # Errors
    /// If it cannot be written, or read.
    pub fn write(&self, text: &str) -> Result<(), MachineFileError> {
        self.read(text)?;
        let known = self.known.as_ref();
        let before = self.text()?;
        let expects = known.map(|known| known.expects(before.as_deref(), text));
        let expected = expects.transpose().map_err(not_known)?.unwrap_or_default();
        let folder = self.path.parent().unwrap_or(Path::new(""));
        let made = RealDisk.make_folder(folder);
        // It may hold the hash of a password.
        let written = made.and_then(|()| write_private(&self.path, text.as_bytes()));
        written.map_err(|error| self.of_disk(error))?;
        let known = known.filter(|_| expected).map(|known| known.is(Some(text)));
        known.transpose().map_err(not_known).map(drop)
    }

    /// Writes back what a run has changed of the settings it began with. What somebody else changed in
    /// the file meanwhile stays. Gives what the file says then.
    ///
    /// # Errors
    /// If it cannot be written, or the changes do not go together with the rest.
    pub fn keep(
        &self,
        began: &Settings,
        settings: &Settings,
    ) -> Result<Option<String>, MachineFileError> {
        let _alone = self.alone();
        let text = self.text()?;
        let (began, ended) = (of_settings(began), of_settings(settings));
        if table::changed(&began, &ended).next().is_none() {
            return Ok(text);
        }
        let before = text.unwrap_or_default();
        let said = self.read(&before)?;
        let mut wanted = said.clone();
        // A value that the table does not allow holds for this visit only.
        let mut takes = |setting: &table::Setting| {
            setting.set(&mut wanted, &without_noise(setting.get(&ended))).is_ok()
        };
        let mut changed: Vec<_> =
            table::changed(&began, &ended).filter(|setting| takes(setting)).collect();
        // The unit takes that of A, B and C with it, unless they have another.
        let beside = |it: &&'static table::Setting| {
            it.get(&began) == it.get(&ended) && !changed.iter().any(|c| c.key == it.key)
        };
        let besides: Vec<_> = table::changed(&said, &wanted).filter(beside).collect();
        for setting in besides {
            changed.extend(setting.set(&mut wanted, &setting.get(&said)).map(|()| setting));
        }
        self.put(&before, &changed, &wanted).map(Some)
    }

    /// Keeps one setting of a machine. What else holds otherwise than the file says is not kept.
    ///
    /// # Errors
    /// If it cannot be written, or does not go together with the rest of the file.
    pub fn keep_one(
        &self,
        setting: &'static table::Setting,
        machine: &Configuration,
    ) -> Result<(), MachineFileError> {
        let _alone = self.alone();
        let before = self.text()?.unwrap_or_default();
        let mut wanted = self.read(&before)?;
        // What the machine has was checked when it was set.
        drop(setting.set(&mut wanted, &setting.get(machine)));
        self.put(&before, &[setting], &wanted).map(drop)
    }

    /// Keeps every setting of a machine, of which the file gets those that it does not say already. Gives
    /// their number.
    ///
    /// # Errors
    /// If it cannot be written, or the settings do not go together.
    pub fn keep_all(&self, machine: &Configuration) -> Result<usize, MachineFileError> {
        let _alone = self.alone();
        let before = self.text()?.unwrap_or_default();
        let changed: Vec<_> = table::changed(&self.read(&before)?, machine).collect();
        self.put(&before, &changed, machine)?;
        Ok(changed.len())
    }

    /// Puts settings into a text of the file, if they go together with the rest. Gives what it says then.
    fn put(
        &self,
        before: &str,
        changed: &[&'static table::Setting],
        wanted: &Configuration,
    ) -> Result<String, MachineFileError> {
        if let Some(crossed) = contradictions::contradictions(wanted).into_iter().next() {
            let (message, hint) = (crossed.message, crossed.hint.to_string());
            return Err(MachineFileError::Contradiction { message, hint });
        }
        let after = file::edit_all(before, changed, wanted);
        if after != before {
            self.write(&after)?;
        }
        Ok(after)
    }

    fn of_disk(&self, why: io::Error) -> MachineFileError {
        MachineFileError::Disk { path: self.path.clone(), why }
    }
}

fn not_known(error: JournalError) -> MachineFileError {
    MachineFileError::Journal(error.to_string())
}

/// Numbers without the noise in the last digit that a conversion from inches leaves.
fn without_noise(value: Value) -> Value {
    let short = |n: f64| format!("{n:.11e}").parse().unwrap_or(n);
    match value {
        Value::Number(n) if (short(n) - n).abs() <= 2.0 * f64::EPSILON * n.abs() => {
            Value::Number(short(n))
        }
        Value::List(values) => Value::List(values.into_iter().map(without_noise).collect()),
        value => value,
    }
}

/// Settings as a configuration whose other areas say nothing.
fn of_settings(settings: &Settings) -> Configuration {
    Configuration { program: settings.clone(), ..Configuration::default() }
}

/// Mistakes of a configuration, a line each.
pub fn mistake_lines(found: &[Diagnostic]) -> String {
    let line = |it: &Diagnostic| {
        let (place, code) = (&it.place, it.code);
        format!(
            "{}:{}:{}: {} [{code}] {}",
            place.file, place.line, place.column, it.message, it.hint
        )
    };
    found.iter().map(line).collect::<Vec<_>>().join("\n")
}
