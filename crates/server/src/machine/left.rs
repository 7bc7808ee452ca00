//! What the owner of the machine leaves for others to look at, whenever it is done with something.

use kerf_control::Session;
use std::path::PathBuf;

/// The machine and its files as the last run left them.
#[derive(Default)]
pub struct Left {
    /// The machine.
    pub session: Session,
    /// The part folder that FS chose.
    pub folder: PathBuf,
    /// Which files lists show.
    pub mask: String,
}
