//! Everything of a run that lies on a disk: part files, custom cuts, files that programs read and
//! write, stored values, external programs.

use crate::program_file::{cannot, program_file};
use crate::settings_files::{self, Found};
use crate::shell;
use crate::sounds;
use crate::stored::Stored;
use crate::system_log::SystemLog;
use kerf_files::{Disk, Folders, MemoryDisk, OpenFiles, Purpose, Scratch};
use kerf_journal::{Journal, Kind, Shell, Surroundings, Tape};
use kerf_program::{FileMode, FileRequest, Folder, HostError, ShellCall, SourceFile};
use kerf_sbp::{PART_FILE, RECORDED, RECORDING};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Which files lists show at first: part files, settings files, custom cuts.
const MASK: &str = "*.sb?";

/// Extension of a part file's log.
const LOG: &str = "log";

/// Files and values that programs reach.
pub struct Workspace {
    disk: Box<dyn Disk>,
    folders: Folders,
    open: OpenFiles,
    /// Values that survive.
    pub stored: Stored,
    /// Folder of settings and values.
    data: PathBuf,
    shell: Shell,
    /// Which files lists show, when somebody chose.
    mask: Option<String>,
    /// Tape of what the world tells the run under way.
    pub tape: Tape,
    /// The log of the session, where one is wanted.
    pub system_log: Option<SystemLog>,
    /// Address of the server of this machine.
    url: Option<String>,
    /// The part file that a tool made last.
    pub made: Option<String>,
    /// Keys that were set while the tape played: they may not be in the journal yet.
    replayed: BTreeSet<String>,
    /// Loads the firmware of a real controller, from a command.
    firmware: Option<Firmware>,
    /// Program files that were called and lie on the disk, with their bytes; kept by previews only.
    called: Option<BTreeMap<PathBuf, Arc<[u8]>>>,
}

/// Loads firmware with a program that is started by the function it is handed, and tells what the
/// controller is after that.
pub type Firmware =
    Box<dyn FnMut(&mut dyn FnMut(&str) -> Result<(), HostError>) -> Result<String, HostError>>;

impl Workspace {
    /// Programs change these files.
    pub fn new(disk: Box<dyn Disk>, folders: Folders, stored: Stored, data: PathBuf) -> Self {
        let (open, shell) = (OpenFiles::default(), Shell::Refused);
        let (tape, replayed) = (Tape::default(), BTreeSet::new());
        Self {
            disk,
            folders,
            open,
            stored,
            data,
            shell,
            mask: None,
            tape,
            system_log: None,
            url: None,
            made: None,
            replayed,
            firmware: None,
            called: None,
        }
    }

    /// Programs see these files; what they write stays in a scratch space.
    pub fn preview(
        disk: impl Disk + 'static,
        folders: Folders,
        stored: &Stored,
        data: PathBuf,
    ) -> Self {
        let workspace = Self::new(Box::new(Scratch::over(disk)), folders, stored.copy(), data);
        Self { called: Some(BTreeMap::new()), ..workspace }
    }

    /// The program files that a preview called, as it read them: those that FP and the custom commands
    /// name. What a program wrote itself is not among them.
    pub fn take_called(&mut self) -> BTreeMap<PathBuf, Arc<[u8]>> {
        self.called.as_mut().map(std::mem::take).unwrap_or_default()
    }

    /// The text of the answers that stand beside a part file for whoever only looks at it; none where there is no such file.
    pub fn answers_beside(&self, file: &str) -> Option<String> {
        let beside = PathBuf::from(format!("{file}.answers"));
        let bytes = if self.disk.is_file(&beside) { self.disk.read(&beside).ok() } else { None };
        bytes.map(|bytes| String::from_utf8_lossy(&bytes).into_owned())
    }

    /// The same, for a machine whose controller has firmware that can be loaded.
    #[must_use]
    pub fn with_firmware(self, firmware: Firmware) -> Self {
        Self { firmware: Some(firmware), ..self }
    }

    /// Loads the firmware of the controller (UI).
    pub fn install_firmware(&mut self) -> Result<String, HostError> {
        let none = "no firmware on the simulated machine";
        let Some(load) = &mut self.firmware else { return Err(HostError::Refused(none.into())) };
        let (allowed, folder) = (self.shell, self.disk.real_path(self.folders.parts()));
        load(&mut |line| shell::run_to_its_end(allowed, &folder, line))
    }

    /// Files in memory only.
    pub fn in_memory(disk: MemoryDisk) -> Self {
        let folders = Folders::new(PathBuf::new(), vec!["custom".into()], Vec::new());
        Self::new(Box::new(disk), folders, Stored::default(), PathBuf::new())
    }

    /// Programs that are started are told where the server of this machine is reached.
    pub fn reached_at(&mut self, url: &str) {
        self.url = Some(url.to_owned());
    }

    /// The part file that a tool made since this was asked last.
    pub fn take_made(&mut self) -> Option<String> {
        self.made.take()
    }

    /// The same with another answer to SHELL.
    #[must_use]
    pub const fn with_shell(mut self, shell: Shell) -> Self {
        self.shell = shell;
        self
    }

    /// The journal of the machine; `None` when nothing is kept.
    pub const fn journal(&self) -> Option<&Journal> {
        self.stored.journal()
    }

    /// Returns everything that a run reaches, as it finds it.
    pub fn surroundings(&self) -> Surroundings {
        let values = self.stored.iter().map(|(key, value)| (key.to_owned(), value.to_owned()));
        Surroundings { values: values.collect(), folders: self.folders.clone(), shell: self.shell }
    }

    /// Looks for files where a run did that was cut short.
    pub fn as_it_was(&mut self, folders: &Folders, shell: Shell) {
        (self.folders, self.shell) = (folders.clone(), shell);
    }

    /// A value that survives, as it is now.
    pub fn value(&mut self, key: &str) -> Option<String> {
        let stored = &self.stored;
        let owes = self.tape.owes(key);
        let news = || stored.news(key).filter(|_| !owes);
        if let Some(now) = self.tape.hear_rarely(Kind::Value, news) {
            self.stored.learn(key, now.as_deref());
        }
        self.stored.get(key).map(str::to_owned)
    }

    /// Keeps a value.
    pub fn set_value(&mut self, key: &str, value: Option<&str>) {
        if self.tape.plays() {
            self.stored.learn(key, value);
            self.replayed.insert(key.to_owned());
            return;
        }
        let news = self.stored.learn(key, value);
        if news && !(self.stored.is_kept_value(key) && self.tape.gives(key, value)) {
            self.stored.keep(key);
        }
    }

    /// Makes a file the one that FP, FE and GetPartFileName mean from now on.
    pub fn make_current(&mut self, path: &Path) {
        self.stored.set(PART_FILE, Some(&path.display().to_string()));
    }

    /// The tape is over: values that were set meanwhile are in the journal from now on.
    pub fn goes_live(&mut self) {
        for key in std::mem::take(&mut self.replayed) {
            self.stored.keep(&key);
        }
    }

    /// Returns why the journal cannot be written, when that was not told yet.
    pub fn new_trouble(&mut self) -> Option<String> {
        self.tape.new_trouble().or_else(|| self.stored.new_trouble())
    }

    /// Adds a line to a file of the data folder.
    pub fn add_to_data(&mut self, name: &str, line: &str) -> Result<(), String> {
        let (disk, path) = (&mut self.disk, self.data.join(name));
        let add = || {
            let folder = path.parent().map_or(Ok(()), |folder| disk.make_folder(folder));
            folder.and_then(|()| disk.append(&path, line.as_bytes())).map_err(|e| e.to_string())
        };
        self.tape.change(Kind::Log, add)
    }

    /// Puts a file into the data folder, whole or not at all.
    pub fn put_data(&mut self, name: &str, text: &str) -> Result<(), String> {
        let (disk, path) = (&mut self.disk, self.data.join(name));
        let put = || {
            let folder = path.parent().map_or(Ok(()), |folder| disk.make_folder(folder));
            folder.and_then(|()| disk.write(&path, text.as_bytes())).map_err(|e| e.to_string())
        };
        self.tape.change(Kind::Log, put)
    }

    /// The text of a file of the data folder.
    pub fn data_text(&self, name: &str) -> Option<String> {
        let bytes = self.disk.read(&self.data.join(name)).ok()?;
        Some(String::from_utf8_lossy(&bytes).into_owned())
    }

    /// The text of a file of the data folder, for tests.
    pub fn data_file(&self, name: &str) -> Option<String> {
        self.data_text(name)
    }

    /// A folder in the data folder.
    pub fn data_folder(&self, name: &str) -> PathBuf {
        self.data.join(name)
    }

    /// Names in a folder of the computer.
    pub fn names_in(&self, folder: &Path) -> Vec<String> {
        self.disk.names(folder).unwrap_or_default()
    }

    /// The bytes of a file of the computer.
    pub fn bytes_of(&self, path: &Path) -> Option<Vec<u8>> {
        self.disk.read(path).ok()
    }

    /// Names in a folder of the data folder.
    pub fn names_in_data(&self, folder: &str) -> Vec<String> {
        self.disk.names(&self.data.join(folder)).unwrap_or_default()
    }

    /// Names of the settings files there are.
    pub fn settings_files(&self) -> Vec<String> {
        settings_files::names(self.names_in_data(settings_files::FOLDER))
    }

    /// Keeps a settings file; returns where.
    ///
    /// # Errors
    /// Its name is none, or the disk does not take it.
    pub fn keep_settings_file(&mut self, name: &str, text: &str) -> Result<String, HostError> {
        let place = settings_files::place(name)?;
        self.put_data(&place, text).map_err(HostError::Refused)?;
        Ok(PathBuf::from(self.app_path()).join(place).display().to_string())
    }

    /// A program file of the data folder.
    pub fn data_source(&mut self, name: &str) -> Result<SourceFile, HostError> {
        let (disk, path) = (&*self.disk, self.data.join(name));
        let (name, bytes) = self.tape.hear_file(Kind::Source, || {
            let bytes = disk.read(&path).map_err(|e| cannot("read", &path, &e))?;
            Ok((path.display().to_string(), bytes))
        })?;
        Ok(SourceFile { name: name.into(), bytes: bytes.into() })
    }

    /// Writes a file that a tool made, whole or not at all.
    pub fn put_made(&mut self, folder: Folder, name: &str, text: &str) -> Result<(), HostError> {
        let path = match folder {
            Folder::Custom => {
                let folder = self.folders.custom().ok_or_else(|| {
                    HostError::Refused("there is no folder of custom cuts".into())
                })?;
                let made = self.disk.make_folder(folder);
                made.map_err(|e| cannot("make", folder, &e))?;
                folder.join(name)
            }
            _ => self.folders.find(&*self.disk, folder, name, Purpose::Write)?,
        };
        let disk = &mut self.disk;
        let write = || disk.write(&path, text.as_bytes()).map_err(|e| cannot("write", &path, &e));
        self.tape.change(Kind::Close, write)
    }

    /// Adds to the log of a part file, which lies beside it. A file that comes with the program has
    /// none.
    pub fn add_to_log(&mut self, file: &str, entry: &str) -> std::io::Result<()> {
        if !self.disk.is_file(Path::new(file)) {
            return Ok(());
        }
        let text = self.log_of(file).unwrap_or_default() + entry;
        let disk = &mut self.disk;
        let mut write = || disk.write(&Path::new(file).with_extension(LOG), text.as_bytes());
        let written = self.tape.change(Kind::Log, || write().map_err(|error| error.to_string()));
        written.map_err(std::io::Error::other)
    }

    /// The line of a part file that was executed last, when its last run ended early.
    pub fn last_line(&self, file: &str) -> Option<u32> {
        last_line(&self.log_of(file)?)
    }

    fn log_of(&self, file: &str) -> Option<String> {
        let path = Path::new(file).with_extension(LOG);
        let bytes = self.disk.is_file(&path).then(|| self.disk.read(&path).ok()).flatten()?;
        Some(String::from_utf8_lossy(&bytes).into_owned())
    }

    /// Tells whether there is such a file in the part folder.
    pub fn has(&self, name: &str) -> bool {
        self.folders.find(&*self.disk, Folder::Parts, name, Purpose::Read).is_ok()
    }

    /// Puts a file into the part folder, whole or not at all.
    ///
    /// # Errors
    /// Whatever the disk says.
    pub fn put(&mut self, name: &str, bytes: &[u8]) -> std::io::Result<()> {
        self.disk.write(&self.folders.parts().join(name), bytes)
    }

    /// The text of a file in the part folder, as a run left it; for tests.
    pub fn text(&self, name: &str) -> Option<String> {
        let path = self.folders.find(&*self.disk, Folder::Parts, name, Purpose::Read).ok()?;
        let bytes = self.disk.read(&path).ok()?;
        Some(String::from_utf8_lossy(&bytes).into_owned())
    }

    /// Which files lists of the part folder show.
    pub fn mask(&self) -> &str {
        self.mask.as_deref().unwrap_or(MASK)
    }

    /// Chooses which files lists show (FS); those of OpenSBP when nothing is given.
    pub fn set_mask(&mut self, mask: Option<&str>) {
        self.mask = mask.map(str::to_owned);
    }

    /// Tells whether what is typed is recorded, and returns the lines, oldest first.
    pub fn recorder(&mut self) -> (bool, Vec<String>) {
        let lines = self.value(RECORDED).unwrap_or_default();
        (self.value(RECORDING).as_deref() != Some("0"), lines.lines().map(str::to_owned).collect())
    }

    /// Puts a line at the end of the recorder's list.
    pub fn record(&mut self, line: &str) {
        let lines = kerf_sbp::with_recorded(self.recorder().1, line);
        self.set_value(RECORDED, Some(&lines.join("\n")));
    }

    /// Names of what lies in the part folder.
    pub fn names(&self) -> std::io::Result<Vec<String>> {
        self.disk.names(self.folders.parts())
    }

    /// Tells whether a folder of this name lies in the part folder.
    pub fn is_folder(&self, name: &str) -> bool {
        self.disk.is_folder(&self.folders.parts().join(name))
    }

    /// Tells whether there is such a file.
    pub fn is_file(&self, name: &str) -> bool {
        self.disk.is_file(Path::new(name))
    }

    /// The path of a file from the root on; the name itself when there is no such file.
    pub fn full_path(&self, name: &str) -> String {
        let path = Path::new(name);
        if self.disk.is_file(path) {
            return self.disk.real_path(path).display().to_string();
        }
        name.to_owned()
    }

    /// The current part folder.
    pub fn part_folder(&self) -> &Path {
        self.folders.parts()
    }

    /// A program file, a settings file or a sound by its name.
    ///
    /// # Errors
    /// There is none, or it cannot be read.
    pub fn source(&mut self, request: &FileRequest) -> Result<SourceFile, HostError> {
        match request.folder {
            Folder::Settings => self.settings_file(&request.name),
            Folder::Media => self.sound(&request.name),
            Folder::Parts | Folder::Custom => self.program_file(request),
        }
    }

    fn settings_file(&mut self, name: &str) -> Result<SourceFile, HostError> {
        match settings_files::find(self.names_in_data(settings_files::FOLDER), name)? {
            Found::Own(name) => self.data_source(&name),
            Found::Shipped(file) => Ok(file),
        }
    }

    fn sound(&mut self, name: &str) -> Result<SourceFile, HostError> {
        let part = FileRequest { folder: Folder::Parts, name: name.into() };
        if let Ok(found) = self.program_file(&part) {
            return Ok(found);
        }
        let found = sounds::find(self.names_in_data(sounds::MEDIA), name);
        self.data_source(&found.ok_or_else(|| HostError::NotFound(name.into()))?)
    }

    fn program_file(&mut self, request: &FileRequest) -> Result<SourceFile, HostError> {
        let (disk, folders) = (&*self.disk, &self.folders);
        let (name, bytes) =
            self.tape.hear_file(Kind::Source, || program_file(disk, folders, request))?;
        let bytes: Arc<[u8]> = bytes.into();
        let path = PathBuf::from(&name);
        if let Some(called) = &mut self.called
            && disk.is_file(&path)
            && !disk.is_scratch(&path)
        {
            called.insert(path, bytes.clone());
        }
        Ok(SourceFile { name: name.into(), bytes })
    }

    /// Chooses the part folder (FS), by a name below the present one or a path; the one at the start
    /// when nothing is given. Tells its path.
    ///
    /// # Errors
    /// There is no such folder, or it may not be used.
    pub fn enter(&mut self, folder: Option<&str>) -> Result<String, HostError> {
        self.folders.enter(&*self.disk, folder)?;
        Ok(self.folders.parts().display().to_string())
    }

    /// Opens a file of a program under a number; returns its path.
    ///
    /// # Errors
    /// It is not there, or may not be used.
    pub fn open(&mut self, number: u8, name: &str, mode: FileMode) -> Result<String, HostError> {
        let purpose = if mode == FileMode::Input { Purpose::Read } else { Purpose::Make };
        let (disk, folders) = (&mut *self.disk, &self.folders);
        let (path, bytes) = self.tape.hear_file(Kind::Open, || {
            let path = folders.find(disk, Folder::Parts, name, purpose)?;
            if mode != FileMode::Input {
                kerf_files::make_way(disk, &path)?;
            }
            let bytes = kerf_files::to_open(disk, &path, mode)?;
            Ok((path.display().to_string(), bytes))
        })?;
        self.open.open(number, PathBuf::from(&path), mode, &bytes);
        Ok(path)
    }

    /// Writes to an open file; the disk has it when it is closed.
    ///
    /// # Errors
    /// It is not open for writing.
    pub fn write(&mut self, number: u8, text: &str) -> Result<(), HostError> {
        self.open.write(number, text)
    }

    /// The next line of an open file.
    ///
    /// # Errors
    /// It is not open for reading, or at its end.
    pub fn read_line(&mut self, number: u8) -> Result<String, HostError> {
        self.open.read_line(number)
    }

    /// Closes a file, and writes what a program wrote to it.
    ///
    /// # Errors
    /// The disk does not take it.
    pub fn close(&mut self, number: u8) -> Result<(), HostError> {
        let Some((path, text)) = self.open.take(number) else { return Ok(()) };
        let disk = &mut self.disk;
        let write = || disk.write(&path, text.as_bytes()).map_err(|e| cannot("write", &path, &e));
        self.tape.change(Kind::Close, write)
    }

    /// Starts an external program (SHELL).
    ///
    /// # Errors
    /// None may be started, or it cannot be.
    pub fn shell(&mut self, call: &ShellCall) -> Result<(), HostError> {
        let (allowed, folder) = (self.shell, self.disk.real_path(self.folders.parts()));
        let told = [("KERF_URL", self.url.clone()), ("KERF_DATA", Some(self.app_path()))];
        self.tape.change(Kind::Shell, || shell::start(allowed, &folder, call, told))
    }

    /// Folder of the user's data.
    pub fn user_path(&self) -> String {
        self.disk.real_path(self.folders.parts()).display().to_string()
    }

    /// Folder of settings and stored values.
    pub fn app_path(&self) -> String {
        self.disk.real_path(&self.data).display().to_string()
    }
}

impl std::fmt::Debug for Workspace {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Workspace").field("folders", &self.folders).finish_non_exhaustive()
    }
}

/// The line at which the last run in a log ended early.
pub fn last_line(log: &str) -> Option<u32> {
    let mut fields = log.lines().next_back()?.split(',');
    (fields.next() == Some("TERMINATED")).then(|| fields.next()?.parse().ok()).flatten()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_line_of_a_log() {
        assert_eq!(last_line("a.sbp,MOVE\nTERMINATED,57,user\n"), Some(57));
        assert_eq!(last_line("TERMINATED,57,user\na.sbp,MOVE\nCOMPLETED\n"), None);
        for text in ["", "TERMINATED", "TERMINATED,x,user", "57"] {
            assert_eq!(last_line(text), None, "{text}");
        }
    }
}
