//! The requests of an interpreter to the world around it.
//!
//! Preview, a real run and a test differ only in the host.

use crate::AXES;
use crate::settings::LinearUnit;
use kerf_diag::Code;
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use std::task::Poll;

/// A question to the operator.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Question {
    /// Kind of box.
    pub kind: QuestionKind,
    /// The text in it.
    pub text: String,
    /// Its title.
    pub title: String,
    /// The buttons, in order.
    pub buttons: Vec<Button>,
    /// Index of the button that ENTER presses.
    pub default: usize,
    /// Text in the entry field at first, for INPUT.
    pub prefill: String,
    /// Icon of a MSGBOX: 0, 16, 32, 48 or 64.
    pub icon: u16,
    /// For PAUSE UNTIL: the input and the state waited for, which answers as OK does.
    pub until: Option<(u8, bool)>,
}

impl Question {
    /// Returns the answer that ENTER alone gives.
    pub fn default_answer(&self) -> Answer {
        if self.kind.takes_text() {
            return Answer::Text(self.prefill.clone());
        }
        Answer::Button(self.buttons.get(self.default).copied().unwrap_or(Button::OK))
    }
}

/// The kinds of questions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum QuestionKind {
    /// INPUT: text is wanted.
    Input,
    /// MSGBOX.
    Msgbox,
    /// PAUSE without a time, PAUSE UNTIL.
    Pause,
    /// The spindle is about to start.
    Spindle,
    /// A move would leave the table limits.
    Limit,
    /// SK: the keypad is open; OK closes it.
    Keypad,
    /// FE: a file is shown; OK closes it.
    Editor,
    /// TR without a spindle that can be set: the operator sets the speed.
    Speed,
    /// The operator stopped the machine: it goes on, is nudged, or the run is given up.
    Hold,
    /// FG: the next line of a file that is stepped through.
    Step,
    /// A job is paused: it goes on, is changed, or is given up.
    Paused,
    /// Before a run: whether the machine is where it is believed to be.
    Location,
}

impl QuestionKind {
    /// Returns `true` if the answer is a value, whatever it reads like.
    pub const fn takes_text(self) -> bool {
        matches!(self, Self::Input)
    }
}

/// A button of a question.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[allow(missing_docs)]
pub enum Button {
    OK,
    Cancel,
    Abort,
    Retry,
    Ignore,
    Yes,
    No,
    Continue,
    End,
    Resume,
    Quit,
    Step,
    Run,
}

impl Button {
    /// Every button.
    pub const ALL: [Self; 13] = [
        Self::OK,
        Self::Cancel,
        Self::Abort,
        Self::Retry,
        Self::Ignore,
        Self::Yes,
        Self::No,
        Self::Continue,
        Self::End,
        Self::Resume,
        Self::Quit,
        Self::Step,
        Self::Run,
    ];

    /// The word on it.
    pub const fn word(self) -> &'static str {
        match self {
            Self::OK => "OK",
            Self::Cancel => "Cancel",
            Self::Abort => "Abort",
            Self::Retry => "Retry",
            Self::Ignore => "Ignore",
            Self::Yes => "Yes",
            Self::No => "No",
            Self::Continue => "Continue",
            Self::End => "End",
            Self::Resume => "Resume",
            Self::Quit => "Quit",
            Self::Step => "Step",
            Self::Run => "Run",
        }
    }
}

/// The operator's answer.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Answer {
    /// A button was pressed.
    Button(Button),
    /// OK was pressed with this text in the entry field.
    Text(String),
}

/// Which file an interpreter wants to run.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct FileRequest {
    /// Folder in which it is looked for.
    pub folder: Folder,
    /// The name as the program gives it: any case, `/` or `\`, perhaps a drive.
    pub name: String,
}

/// The folders a program may name files in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Folder {
    /// The current part folder.
    Parts,
    /// The folder of custom cuts (`CustomN.sbc`).
    Custom,
    /// The folder of settings files (`.sbd`).
    Settings,
    /// The folder of sounds (PLAY), behind the part folder.
    Media,
}

/// A program file that was read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SourceFile {
    /// The name shown to people.
    pub name: Arc<str>,
    /// Its bytes.
    pub bytes: Arc<[u8]>,
}

/// Mode in which a user file is opened.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum FileMode {
    /// For reading.
    Input,
    /// For writing, emptied first.
    Output,
    /// For writing at the end.
    Append,
}

/// A program SHELL wants to start.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct ShellCall {
    /// The command line.
    pub line: String,
    /// Appearance of its window: 0-4 or 6.
    pub display: u8,
    /// Wait until it ends.
    pub wait: bool,
}

/// A virtual tool that a program starts (T commands).
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct ToolCall {
    /// The letter behind the T.
    pub letter: char,
    /// Arguments of the tool, as they stand in the line.
    pub arguments: String,
}

/// Reason why the host did not do what was asked.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum HostError {
    /// There is no such file; the text tells where it was looked for.
    NotFound(String),
    /// Outside the folders that may be used.
    NotAllowed(String),
    /// Past the end of a file.
    EndOfFile,
    /// The function is switched off (SHELL).
    Disabled(String),
    /// The system or the machine refused; the text tells why.
    Refused(String),
}

impl HostError {
    /// The code and the message that tell a person of it.
    pub fn into_message(self) -> (Code, String) {
        match self {
            Self::NotFound(what) => (Code::FileNotFound, what),
            Self::NotAllowed(what) => (Code::FileNotAllowed, what),
            Self::EndOfFile => (Code::EndOfFile, "end of file".into()),
            Self::Disabled(what) => (Code::ShellDisabled, what),
            Self::Refused(what) => (Code::FileError, what),
        }
    }
}

/// Key under which [`Host::store`] keeps `1` while the spindle counts as active: then nobody is asked
/// before it starts (SetSpindleStatus).
pub const SPINDLE_STATUS: &str = "SpindleStatus";
/// The output that starts the spindle.
pub const SPINDLE_OUTPUT: u8 = 1;

/// Outcome of a request to convert a file (FC).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum FileConversion {
    /// It was written here.
    Made(String),
    /// There is a file of this name already, and nothing was written.
    Exists(String),
    /// The name does not say what the file is.
    Unknown,
    /// The file says no unit, and nothing was written. Usual is that of the machine.
    Unit(LinearUnit),
    /// The file does not say how it is cut, and nothing was written. This is usual.
    Cut(CutChoice),
}

/// A file that is to become a part file (FC), and what was answered about it so far.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ConversionRequest {
    /// The file, in the part folder.
    pub name: String,
    /// Kind of the file, where its name does not say it: an extension as `nc` or `dxf`.
    pub kind: Option<String>,
    /// Writes over a part file that is there already.
    pub overwrite: bool,
    /// The unit of the part file, where the file says none.
    pub unit: Option<LinearUnit>,
    /// Choices for cutting a drawing or a picture.
    pub cut: Option<CutChoice>,
}

/// Choices for cutting a drawing or a picture, which its file does not say.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct CutChoice {
    /// Depth of the cut, or of the deepest place of a picture, mm.
    pub depth_mm: f64,
    /// Height of travel above the surface, mm.
    pub safe_mm: f64,
    /// Factor of enlargement; nothing where it has a size of its own.
    pub scale: Option<f64>,
    /// White is deepest, not black; nothing for drawings.
    pub white_deepest: Option<bool>,
}

/// The world around an interpreter, which answers its requests.
///
/// Every method that may have to wait returns [`Poll`]; on `Pending` the interpreter's step has no
/// effect and is repeated later. Methods without `Poll` answer at once.
pub trait Host {
    /// Ready when every command given so far has been carried out.
    fn settle(&mut self) -> Poll<()>;

    /// State of an input, 1 … 12. Called only after [`Host::settle`] was ready.
    fn input(&mut self, number: u8) -> bool;

    /// State of an output, 1 … 12. Called only after [`Host::settle`] was ready.
    fn output(&mut self, number: u8) -> bool;

    /// Asks the operator.
    fn ask(&mut self, question: &Question) -> Poll<Answer>;

    /// Reads a program file.
    fn source(&mut self, request: &FileRequest) -> Result<SourceFile, HostError>;

    /// Changes the current part folder (FS); `None` restores the one at the start. Returns the new one.
    fn set_part_folder(&mut self, folder: Option<&str>) -> Result<String, HostError>;

    /// Chooses which files lists of the part folder show (FS): `*` any characters, `?` one.
    fn set_file_mask(&mut self, _mask: &str) {}

    /// Which files lists of the part folder show.
    fn file_mask(&mut self) -> String {
        "*.sb?".into()
    }

    /// The path of a file from the root on, where there is such a thing.
    fn full_path(&mut self, name: &str) -> String {
        name.to_owned()
    }

    /// Opens a user file under a number 1 … 9; returns the path it resolved to.
    fn open(&mut self, number: u8, path: &str, mode: FileMode) -> Result<String, HostError>;

    /// Appends text to an open file.
    fn write(&mut self, number: u8, text: &str) -> Result<(), HostError>;

    /// Reads one line of an open file, without its line end.
    fn read_line(&mut self, number: u8) -> Result<String, HostError>;

    /// Closes a user file.
    fn close(&mut self, number: u8) -> Result<(), HostError>;

    /// The line of a program file that was executed last when a run of it ended early, before.
    fn last_line(&mut self, _file: &str) -> Option<u32> {
        None
    }

    /// A value that survives restarts (`uValue`, `$name`, settings of the external control).
    fn stored(&mut self, key: &str) -> Option<String>;

    /// Keeps a value under a key; `None` removes it.
    fn store(&mut self, key: &str, value: Option<&str>);

    /// Converts a file of the part folder to a part file beside it (FC), or tells what it has to know
    /// before.
    fn convert(&mut self, request: &ConversionRequest) -> Result<FileConversion, HostError> {
        Err(HostError::Disabled(format!("{}: files are not converted here", request.name)))
    }

    /// Starts an external program.
    fn shell(&mut self, call: &ShellCall) -> Poll<Result<(), HostError>>;

    /// True position of an independent axis or after a stop: where the machine really is, machine frame.
    /// Called only after [`Host::settle`] was ready.
    fn machine_position(&mut self) -> [f64; AXES];

    /// Folder of the user's data (GetUsrPath).
    fn user_path(&mut self) -> String;

    /// Folder of the program's settings and logs (GetAppPath).
    fn app_path(&mut self) -> String;

    /// Keeps what helps to find a fault where a person finds it (UD).
    fn keep_problem_log(&mut self, _text: &str) -> Result<(), HostError> {
        Ok(())
    }

    /// Names of the settings files there are (UR).
    fn settings_files(&mut self) -> Vec<String> {
        Vec::new()
    }

    /// Keeps a settings file (US); returns where.
    fn keep_settings(&mut self, name: &str, _text: &str) -> Result<String, HostError> {
        Err(HostError::Disabled(format!("{name}: settings files are not kept here")))
    }

    /// Begins the system log anew (UR).
    fn forget_system_log(&mut self) -> Result<(), HostError> {
        Ok(())
    }

    /// Starts a virtual tool, and waits for it unless it runs beside; returns what a person should know.
    fn tool(&mut self, call: &ToolCall) -> Result<Vec<String>, HostError> {
        Err(HostError::NotFound(no_such_tool(call.letter)))
    }

    /// Loads the firmware of the controller (UI); returns what was loaded.
    fn install_firmware(&mut self) -> Result<String, HostError> {
        Err(HostError::Refused("no firmware on the simulated machine".into()))
    }

    /// Returns the name of what drives the machine.
    fn driver(&mut self) -> String {
        "simulated machine".into()
    }

    /// Returns `true` while the controller answers.
    fn is_connected(&mut self) -> bool {
        true
    }

    /// Version number of the firmware, `%(49)`.
    fn firmware(&mut self) -> i32;
}

/// Returns the message for a letter that no tool has.
pub fn no_such_tool(letter: char) -> String {
    format!("no such tool: T{letter}")
}
