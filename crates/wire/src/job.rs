//! Files and jobs as a page shows them.

use crate::{FileKind, Finding, JobChoice, State};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use ts_rs::TS;

/// A file of the part folder.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct FileInfo {
    /// Its name below the part folder, `/` between folders.
    pub name: String,
    /// It is a folder.
    pub folder: bool,
    /// Bytes.
    #[ts(type = "number")]
    pub bytes: u64,
    /// Time of its last change: seconds since 1970.
    #[ts(type = "UnixSeconds")]
    pub changed: u64,
    /// Text of its head about the job.
    pub header: Option<String>,
    /// It is a part file: one that the mask of the part folder lets through, or G-code.
    pub part: bool,
    /// The sort of file as which it is opened; nothing for a folder, a log, and whatever else is none.
    pub opens: Option<FileKind>,
}

/// Parameters with which a part file is run: those of FP.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase", default, deny_unknown_fields)]
#[ts(optional_fields = false)]
pub struct FileParameters {
    /// Scales X, Y and Z.
    pub proportion: [f64; 3],
    /// Number of runs of the file, at least one.
    pub repetitions: u32,
    /// 0: places as written. 1: the present place is X 0, Y 0, Z 0 of the file. 2: X 0, Y 0.
    pub offset: u8,
    /// Distance that Z moves before each repetition, mm.
    #[ts(type = "Mm")]
    pub plunge: f64,
    /// Leave tabs on the last repetition.
    pub tabs: bool,
    /// Z moves to 0 before the first plunge.
    pub plunge_from_zero: bool,
}

impl Default for FileParameters {
    fn default() -> Self {
        let (proportion, plunge) = ([1.0; 3], 0.0);
        Self { proportion, repetitions: 1, offset: 0, plunge, tabs: false, plunge_from_zero: false }
    }
}

/// A pause of so many seconds, while it lasts.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct Pause {
    /// The comment of the program right above it; empty where there is none.
    pub text: String,
    /// Machine time since the run began at which it is over, seconds.
    #[ts(type = "Seconds")]
    pub until: f64,
}

/// A sound that a program started (PLAY).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct Sound {
    /// Sounds are counted: each is heard once.
    pub number: u32,
    /// Name by which it is fetched, below `/api/media/`.
    pub name: String,
}

/// The folder that part files are chosen from.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct Folder {
    /// Its name below the folder that the server was given; empty for that itself.
    pub name: String,
    /// Which files lists show: `*` any characters, `?` one.
    pub mask: String,
}

/// Commands that were typed, and can be run again.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct Recorder {
    /// Typed commands are recorded (RA, RI).
    pub on: bool,
    /// The lines, oldest first.
    pub lines: Vec<String>,
}

/// The file that is open, to be looked at and run.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct Opened {
    /// Its name below the part folder.
    pub name: String,
    /// Hash by which it is run, in hexadecimal digits: SHA-256 of its bytes; of more, where its parameters are
    /// others than the usual, or when the preview is ready and knows the program files that it calls.
    pub hash: String,
    /// SHA-256 of its bytes alone.
    pub content: String,
    /// Sort of file.
    pub kind: FileKind,
    /// Parameters with which it is run, when it is a part program.
    pub parameters: FileParameters,
    /// Choices with which it is cut, when it is a job.
    pub choice: JobChoice,
    /// The origin of a job on the table, X and Y from home, mm; nothing of other files.
    #[ts(type = "[Mm, Mm] | null")]
    pub origin: Option<[f64; 2]>,
    /// Shapes that were added to a job since it was saved.
    pub added: u32,
    /// Lines; paths of a job.
    pub lines: u32,
    /// The words of its head about the job; the comments of a drawing that became one.
    pub header: Option<String>,
    /// The preview, which is made when it is opened.
    pub preview: PreviewState,
    /// Planned time, seconds; 0 until the preview is there.
    #[ts(type = "Seconds")]
    pub seconds: f64,
    /// Mistakes in it, and whatever else is worth knowing.
    pub findings: Vec<Finding>,
    /// The questions that it asked while it was previewed, with the sample answers that it got.
    pub samples: Vec<SampleAnswer>,
    /// It has mistakes that keep it from running: the first errors of the findings.
    pub broken: bool,
    /// Its last run since Kerf began, as the file is now; nothing where it has not run.
    pub ran: Option<LastRun>,
    /// The picture was cleared (SP given in preview): it is empty until the file is drawn again.
    pub cleared: bool,
}

/// A question that a program asked while it was previewed, with its sample answer.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct SampleAnswer {
    /// The line that asks.
    pub line: u32,
    /// The text of the question.
    pub text: String,
    /// The words on its buttons; none where a value is entered.
    pub buttons: Vec<String>,
    /// The answer that it got: empty where a value counts as 0.
    pub answer: String,
    /// The file of answers beside the program says so.
    pub given: bool,
}

/// The last run of a file, when it is over.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct LastRun {
    /// Word for its end, as [`CurrentRun`] has it.
    pub ended: String,
    /// Time of its end: seconds since 1970.
    #[ts(type = "UnixSeconds")]
    pub at: u64,
    /// The line of the last move; the path of a job.
    pub line: u32,
    /// Time that it took, seconds of whoever waited; 0 where it is not known.
    #[serde(default)]
    #[ts(type = "Seconds")]
    pub seconds: f64,
}

/// State of a preview.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase", tag = "state")]
pub enum PreviewState {
    /// It is being made.
    #[default]
    Working,
    /// It can be asked for with this key: `/api/preview/KEY`.
    Ready {
        /// Changes whenever the preview does.
        key: String,
    },
    /// The program does not run.
    Failed {
        /// Reason of the failure.
        why: String,
    },
}

/// A run that was cut short or given up, and can be taken up where it was.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct Interrupted {
    /// The part file.
    pub file: String,
    /// The text of a part file: SHA-256, in hexadecimal digits. Nothing of a job.
    pub hash: Option<String>,
    /// The line of the last move that was made, or the path of a job; 0 before the first.
    pub line: u32,
    /// Which run it was and where it ended, in a sentence.
    pub text: String,
    /// The operator stopped it; else Kerf was killed or the power failed.
    pub stopped: bool,
    /// The machine moved when Kerf ended: it is not sure to be where it is believed to be.
    pub moved: bool,
}

/// The run that is under way, or the last one.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct CurrentRun {
    /// Number of the run since the server began.
    pub run: u32,
    /// The part file; empty for a command that somebody typed.
    pub file: String,
    /// Its hash, when it is a file.
    pub hash: Option<String>,
    /// The command line, when somebody typed it.
    pub command: Option<String>,
    /// The controller runs the file from a card of its own.
    pub from_card: bool,
    /// Planned time, seconds; 0 when it is not known.
    #[ts(type = "Seconds")]
    pub seconds: f64,
    /// It began in preview on a machine that nobody armed: it is only drawn to its end.
    pub draws_only: bool,
    /// VD without comments was carried out and nothing was printed since: the message screen is closed.
    pub silent: bool,
    /// The open files, outermost first, with the line that is read.
    pub calls: Vec<Call>,
    /// The file whose line the tool makes ([`Motion::line`](crate::Motion)): one of those, or one that is read to
    /// its end; empty before the first move.
    pub tool_file: String,
    /// Z of travel, of the surface of the material and of the lowest place of the tool: from home, mm, as they
    /// are in force in a job. Pauses and height control change them.
    #[ts(type = "[Mm, Mm, Mm] | null")]
    pub heights: Option<[f64; 3]>,
    /// Settings as a pause has changed them for the rest of a job; nothing while they are as they were set.
    pub in_force: Option<InForce>,
    /// Word for its end: `ok`, `ended`, `failed`, `stopped`, `limit`; nothing while it runs.
    pub ended: Option<String>,
    /// The error that ended it, when one did.
    pub error: Option<Finding>,
    /// Summary, for whoever had it run and sees no page; nothing while it runs.
    #[ts(skip)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub summary: Option<RunSummary>,
}

/// Summary of a run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct RunSummary {
    /// Machine time.
    pub seconds: f64,
    /// Lines that were executed.
    pub lines: u64,
    /// Straight moves.
    pub moves: u64,
    /// Arcs.
    pub arcs: u64,
    /// Length of the cutting moves.
    pub cut_mm: f64,
    /// Length of the jogs.
    pub jog_mm: f64,
    /// Lowest and highest X, Y and Z of the cutting moves, mm; nothing where nothing was cut.
    pub bounds: Option<[[f64; 3]; 2]>,
    /// The person reads millimetres, else inches.
    pub millimetres: bool,
}

/// Settings that hold for the rest of a job.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct InForce {
    /// Highest cutting speed.
    #[ts(type = "MmPerS")]
    pub cut_mm_s: f64,
    /// Plunging speed.
    #[ts(type = "MmPerS")]
    pub plunge_mm_s: f64,
    /// The tool rises in pauses.
    pub raise: bool,
}

/// A file that a run is in.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct Call {
    /// The file.
    pub file: String,
    /// The line that is read next.
    pub line: u32,
}

/// A question that a job waits for. It belongs to the job: any page may answer.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct Asked {
    /// Its number; an answer names it, so that none goes to another question.
    pub number: u32,
    /// `input`, `msgbox`, `pause`, `spindle`, `limit`, `keypad`, `editor`, `speed`, `hold`, `step`, `paused`.
    pub kind: String,
    /// The text.
    pub text: String,
    /// The title.
    pub title: String,
    /// The words on its buttons.
    pub buttons: Vec<String>,
    /// The button that ENTER presses: its place in the list.
    pub default: u32,
    /// Text that stands in the entry field.
    pub prefill: String,
    /// It has an entry field.
    pub entry: bool,
    /// 0 none, 16 critical, 32 question, 48 warning, 64 information.
    pub icon: u32,
    /// The file that is to be shown in the editor (FE): its name below the part folder, empty for a new
    /// one. Nothing for other questions.
    pub edits: Option<String>,
    /// The file that asks.
    pub file: String,
    /// Its line.
    pub line: u32,
    /// State that the machine was in.
    pub was: State,
}

/// Sort of message.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub enum Tone {
    /// Something that happened.
    #[default]
    Note,
    /// A comment of the program for the operator.
    Program,
    /// Something to look at.
    Warning,
    /// Something went wrong.
    Error,
}

/// A line of the message area.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct Message {
    /// Its sort.
    pub tone: Tone,
    /// Code of a finding, by which a page tells it in another language; empty where it is none.
    pub code: String,
    /// The text, which does not repeat the place.
    pub text: String,
    /// A way to mend it; empty where none is told.
    pub hint: String,
    /// The run it belongs to; 0 when to none.
    pub run: u32,
    /// The place in a file that it is about, with the line that stands there; nothing where it is about none.
    pub place: Option<Call>,
}

/// The operator's overrides.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct Overrides {
    /// Cuts run at so much of the speed asked for, 10 … 200.
    pub feed_percent: f64,
    /// Rapid moves run at so much of their speed, up to 100; nothing where the machine does not override them by
    /// itself.
    pub rapid_percent: Option<u8>,
    /// The spindle turns at so much of the speed asked for, 10 … 200; nothing where the machine does not override it.
    pub spindle_percent: Option<u8>,
}

impl Default for Overrides {
    fn default() -> Self {
        Self { feed_percent: 100.0, rapid_percent: None, spindle_percent: None }
    }
}
