//! Standing of a run: what a console shows at any time.

use kerf_program::FileCall;
use std::sync::Arc;

/// Flags of the status byte, as other software reads them (programming handbook, external control).
pub mod flag {
    /// A part file is running.
    pub const FILE_RUNNING: u8 = 1;
    /// It is only drawn.
    pub const PREVIEW: u8 = 2;
    /// The keypad is open.
    pub const KEYPAD: u8 = 4;
    /// It waits: for an answer, an input or a time.
    pub const PAUSED: u8 = 8;
    /// The operator or an input stopped it.
    pub const STOPPED: u8 = 16;
    /// A stack of moves, or a jog, is being made.
    pub const STACK_RUNNING: u8 = 32;
}

/// Standing of a run, as a console shows it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RunStatus {
    /// The sum of [`flag`]s.
    pub status: u8,
    /// The open files, outermost first.
    pub files: Vec<OpenFile>,
    /// Variables that somebody wants to see: name and value; those without a value are missing.
    pub watched: Vec<(String, String)>,
}

/// A file that is open.
#[derive(Clone, Debug, PartialEq)]
pub struct OpenFile {
    /// Its name.
    pub file: Arc<str>,
    /// The line that is read next, counted from 1; in a file that called another, the one behind the
    /// call. The line that is being made is that of the last move told.
    pub line: u32,
    /// Call of the file; nothing for the outermost.
    pub call: Option<FileCall>,
}
