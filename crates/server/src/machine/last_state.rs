//! State that the owner of the machine leaves for others to look at, whenever it is done with something.

use crate::locks::lock;
use kerf_control::Session;
use kerf_control::controller::Lacks;
use kerf_journal::Journal;
use kerf_machine::Configuration;
use kerf_toolpath::{Heights, Shaping};
use std::path::PathBuf;
use std::sync::Mutex;

/// The machine and its files as the last run left them.
#[derive(Default)]
pub struct LastState {
    /// The machine.
    pub session: Session,
    /// The part folder that FS chose.
    pub folder: PathBuf,
    /// Journal of what survives.
    pub journal: Option<Journal>,
    /// Which files lists show.
    pub mask: String,
    /// Limits against which a file for the card of the controller is held, where it has told them.
    pub limits: Option<Lacks>,
}

impl LastState {
    /// The heights that the machine is set to.
    pub fn heights(left: &Mutex<Self>) -> Heights {
        lock(left).session.machine_is.zpos
    }

    /// Returns what is done to shapes before paths are made of them.
    pub fn shaping(left: &Mutex<Self>) -> Shaping {
        let Configuration { program, options, .. } = lock(left).session.configuration();
        Shaping { factor: program.smoothing.factor, filter_mm: options.filter_mm }
    }
}
