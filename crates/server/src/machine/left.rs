//! State that the owner of the machine leaves for others to look at, whenever it is done with something.

use kerf_control::Session;
use kerf_journal::Journal;
use std::path::PathBuf;

/// The machine and its files as the last run left them.
#[derive(Default)]
pub struct Left {
    /// The machine.
    pub session: Session,
    /// The part folder that FS chose.
    pub folder: PathBuf,
    /// Journal of what survives.
    pub journal: Option<Journal>,
    /// Which files lists show.
    pub mask: String,
}
