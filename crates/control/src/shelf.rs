//! Everything of a run that lies on a disk: part files, custom cuts, files that programs read and
//! write, stored values, external programs.

use crate::files::{Disk, Folders, MemoryDisk, OpenFiles, Purpose, Scratch, Shipped, custom_name};
use crate::gcode_file::GCODE_FILE;
use crate::part_log;
use crate::settings_file::SETTINGS_FILE;
use crate::stored::Stored;
use kerf_program::{FileMode, FileRequest, Folder, HostError, ShellCall, SourceFile};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// Files larger than this are no part files, bytes.
pub const MOST_BYTES: usize = 1 << 29;

/// Which files lists show at first: part files, settings files, custom cuts.
const MASK: &str = "*.sb?";

/// What the name of a part file's log ends with.
const LOG: &str = "log";

/// Files and values that programs reach.
pub struct Shelf {
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
}

/// What SHELL does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Shell {
    /// It is refused.
    #[default]
    Refused,
    /// It is allowed, but starts nothing: a preview.
    Skipped,
    /// It starts programs.
    Started,
}

impl Shelf {
    /// Programs change these files.
    pub fn new(disk: Box<dyn Disk>, folders: Folders, stored: Stored, data: PathBuf) -> Self {
        let (open, shell) = (OpenFiles::default(), Shell::Refused);
        Self { disk, folders, open, stored, data, shell, mask: None }
    }

    /// Programs see these files; what they write stays in a scratch space.
    pub fn preview(
        disk: impl Disk + 'static,
        folders: Folders,
        stored: &Stored,
        data: PathBuf,
    ) -> Self {
        Self::new(Box::new(Scratch::over(disk)), folders, stored.copy(), data)
    }

    /// Files in memory only.
    pub fn in_memory(disk: MemoryDisk) -> Self {
        let folders = Folders::new(PathBuf::new(), vec!["custom".into()], Vec::new());
        Self::new(Box::new(disk), folders, Stored::default(), PathBuf::new())
    }

    /// The same with another answer to SHELL.
    #[must_use]
    pub const fn with_shell(mut self, shell: Shell) -> Self {
        self.shell = shell;
        self
    }

    /// Puts values that changed into their file.
    pub fn save(&mut self) -> std::io::Result<()> {
        self.stored.save(&mut *self.disk)
    }

    /// The text of the settings file; `None` when there is none yet.
    ///
    /// # Errors
    /// Whatever the disk says.
    pub fn settings_text(&self) -> std::io::Result<Option<String>> {
        self.data_text(SETTINGS_FILE)
    }

    /// Writes the settings file, whole or not at all.
    ///
    /// # Errors
    /// Whatever the disk says.
    pub fn keep_settings(&mut self, text: &str) -> std::io::Result<()> {
        self.keep_data(SETTINGS_FILE, text)
    }

    /// The text of the file of what G-code remembers; `None` when there is none yet.
    ///
    /// # Errors
    /// Whatever the disk says.
    pub fn gcode_text(&self) -> std::io::Result<Option<String>> {
        self.data_text(GCODE_FILE)
    }

    /// Writes the file of what G-code remembers, whole or not at all.
    ///
    /// # Errors
    /// Whatever the disk says.
    pub fn keep_gcode(&mut self, text: &str) -> std::io::Result<()> {
        self.keep_data(GCODE_FILE, text)
    }

    fn data_text(&self, name: &str) -> std::io::Result<Option<String>> {
        let path = self.data.join(name);
        if !self.disk.is_file(&path) {
            return Ok(None);
        }
        Ok(Some(String::from_utf8_lossy(&self.disk.read(&path)?).into_owned()))
    }

    fn keep_data(&mut self, name: &str, text: &str) -> std::io::Result<()> {
        self.disk.make_folder(&self.data)?;
        self.disk.write(&self.data.join(name), text.as_bytes())
    }

    /// Adds to the log of a part file, which lies beside it. A file that comes with the program has
    /// none.
    pub(crate) fn add_to_log(&mut self, file: &str, entry: &str) -> std::io::Result<()> {
        if !self.disk.is_file(Path::new(file)) {
            return Ok(());
        }
        let text = self.log_of(file).unwrap_or_default() + entry;
        self.disk.write(&Path::new(file).with_extension(LOG), text.as_bytes())
    }

    /// The line of a part file that was executed last, when its last run ended early.
    pub fn last_line(&self, file: &str) -> Option<u32> {
        part_log::last_line(&self.log_of(file)?)
    }

    fn log_of(&self, file: &str) -> Option<String> {
        let path = Path::new(file).with_extension(LOG);
        let bytes = self.disk.is_file(&path).then(|| self.disk.read(&path).ok()).flatten()?;
        Some(String::from_utf8_lossy(&bytes).into_owned())
    }

    /// Whether there is such a file in the part folder.
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

    /// Names of what lies in the part folder.
    pub(crate) fn names(&self) -> std::io::Result<Vec<String>> {
        self.disk.names(self.folders.parts())
    }

    /// Whether a folder of this name lies in the part folder.
    pub(crate) fn is_folder(&self, name: &str) -> bool {
        self.disk.is_folder(&self.folders.parts().join(name))
    }

    /// The path of a file from the root on; the name itself when there is no such file.
    pub(crate) fn full_path(&self, name: &str) -> String {
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

    pub(crate) fn source(&mut self, request: &FileRequest) -> Result<SourceFile, HostError> {
        let found = self.folders.find(&*self.disk, request.folder, &request.name, Purpose::Read);
        let path = match found {
            Ok(path) => path,
            Err(error @ HostError::NotFound(_)) => {
                return shipped(request).ok_or(error);
            }
            Err(error) => return Err(error),
        };
        let bytes = self.disk.read(&path).map_err(|e| cannot("read", &path, &e))?;
        if bytes.len() > MOST_BYTES {
            return Err(HostError::Refused(format!("{} is too large", path.display())));
        }
        Ok(SourceFile { name: path.display().to_string().into(), bytes: bytes.into() })
    }

    pub(crate) fn enter(&mut self, folder: Option<&str>) -> Result<String, HostError> {
        self.folders.enter(&*self.disk, folder)?;
        Ok(self.folders.parts().display().to_string())
    }

    pub(crate) fn open(
        &mut self,
        number: u8,
        name: &str,
        mode: FileMode,
    ) -> Result<String, HostError> {
        let purpose = if mode == FileMode::Input { Purpose::Read } else { Purpose::Write };
        let path = self.folders.find(&*self.disk, Folder::Parts, name, purpose)?;
        self.open.open(&*self.disk, number, path.clone(), mode)?;
        Ok(path.display().to_string())
    }

    pub(crate) fn write(&mut self, number: u8, text: &str) -> Result<(), HostError> {
        self.open.write(number, text)
    }

    pub(crate) fn read_line(&mut self, number: u8) -> Result<String, HostError> {
        self.open.read_line(number)
    }

    pub(crate) fn close(&mut self, number: u8) -> Result<(), HostError> {
        self.open.close(&mut *self.disk, number)
    }

    pub(crate) fn shell(&self, call: &ShellCall) -> Result<(), HostError> {
        match self.shell {
            Shell::Started => {}
            Shell::Skipped => return Ok(()),
            Shell::Refused => {
                let what = "external programs are disabled; --allow-shell lets a run start them";
                return Err(HostError::Disabled(what.into()));
            }
        }
        let mut command = shell_command(&call.line);
        let folder = self.disk.real_path(self.folders.parts());
        command.current_dir(folder).stdin(Stdio::null());
        let started =
            if call.wait { command.status().map(drop) } else { command.spawn().map(drop) };
        started.map_err(|e| HostError::Refused(format!("cannot start '{}': {e}", call.line)))
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

impl std::fmt::Debug for Shelf {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Shelf").field("folders", &self.folders).finish_non_exhaustive()
    }
}

/// A custom cut that comes with the program.
fn shipped(request: &FileRequest) -> Option<SourceFile> {
    let name = match request.folder {
        Folder::Custom => Some(request.name.as_str()),
        Folder::Parts => None,
    };
    let name = name.map(str::to_owned).or_else(|| custom_name(&request.name))?;
    let file = Shipped::find(&name)?;
    Some(SourceFile { name: file.name.into(), bytes: file.text.as_bytes().into() })
}

fn cannot(what: &str, path: &Path, error: &std::io::Error) -> HostError {
    HostError::Refused(format!("cannot {what} {}: {error}", path.display()))
}

#[cfg(windows)]
fn shell_command(line: &str) -> Command {
    let mut command = Command::new("cmd");
    command.arg("/C").arg(line);
    command
}

#[cfg(not(windows))]
fn shell_command(line: &str) -> Command {
    let mut command = Command::new("sh");
    command.arg("-c").arg(line);
    command
}
