//! Equipment of the server: the machine, its folders, how pages may reach it.

use crate::webhook::Webhook;
use kerf_control::Session;
use kerf_control::controller::{AttachReport, Controller};
use kerf_journal::Started;
use kerf_workspace::Workspace;
use std::io;
use std::net::SocketAddr;
use std::path::PathBuf;
use std::sync::Arc;

/// Options with which the server is started.
#[derive(Clone, Debug)]
pub struct Options {
    /// Address at which it listens.
    pub listen: SocketAddr,
    /// Other machines may connect, after pairing.
    pub lan: bool,
    /// Names by which other machines call this one.
    pub names: Vec<String>,
    /// The part folder.
    pub parts: PathBuf,
    /// Folder of what survives: paired devices.
    pub data: PathBuf,
    /// Only drawings are worked on.
    pub drawing_only: bool,
    /// Opened at the start: a file of the part folder.
    pub open: Option<String>,
    /// Settings of a start-up line for pages.
    pub start: Option<kerf_wire::StartUp>,
    /// Lines that are carried out at once, one after the other.
    pub begin_with: Vec<String>,
    /// EXIT SHOPBOT in a part file ends the server, not only the run.
    pub closes_with_program: bool,
    /// AttachReport when somebody is needed and how runs end.
    pub webhook: Option<Webhook>,
    /// Seconds of machine time in a second; 1 unless a test is in a hurry.
    pub rate: f64,
}

/// The machine and its files, as the thread that owns it has them.
pub struct Workshop {
    /// The machine.
    pub session: Session,
    /// Its files.
    pub workspace: Workspace,
    /// The controller that makes what is planned; without one the machine is simulated.
    pub controller: Option<Controller>,
    /// Sentences about it.
    pub told: AttachReport,
    /// Runs are on record: what they leave stays.
    pub kept: bool,
    /// The date and time of now, for the logs of part files.
    pub started: fn() -> Option<Started>,
}

/// Builds what lives on other threads.
#[derive(Clone)]
pub struct Builders {
    /// The machine, built once on its own thread.
    pub workshop: Arc<dyn Fn() -> io::Result<Workshop> + Send + Sync>,
    /// Files of a preview, which changes none.
    pub preview: Arc<dyn Fn() -> io::Result<Workspace> + Send + Sync>,
}
