//! Over a serial line.

use super::Shown;
use crate::transfer::{Receiver, Sender, State};
use anyhow::Result;
use kerf_files::{Disk, RealDisk, versions::Versions};
use kerf_transport::Port;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// Duration of one look at the line when nothing comes.
const NAP: Duration = Duration::from_millis(5);

/// An end that is done stays on the line for so long: its last answer may have been lost.
const LINGERS: Duration = Duration::from_secs(2);

/// Sends a file; gives how it ended.
pub fn send_over_line(
    mut port: Port,
    mut sender: Sender,
    stopped: &dyn Fn() -> bool,
    shown: &mut Shown,
) -> Result<State> {
    let since = Instant::now();
    let mut bytes = [0; 512];
    loop {
        if stopped() {
            sender.stop();
        }
        let out = sender.speak(since.elapsed().as_secs_f64());
        port.write(&out)?;
        shown.tell(sender.state(), &sender.progress());
        if sender.state().is_over() {
            return Ok(sender.state().clone());
        }
        let count = port.read(&mut bytes, NAP)?;
        sender.hear(&bytes[..count], since.elapsed().as_secs_f64());
    }
}

/// Place for files that are received, and when none may come.
pub struct Folder<'a> {
    /// The folder.
    pub path: &'a Path,
    /// Returns `true` while the machine moves.
    pub moves: &'a dyn Fn() -> bool,
    /// Versions, which keep what a file was that is written over.
    pub versions: &'a Versions,
    /// A file was kept.
    pub kept: &'a dyn Fn(),
}

impl Folder<'_> {
    /// Keeps a file: whole, or not at all.
    fn keep(&self, name: &str, bytes: &[u8]) -> Result<PathBuf, String> {
        let path = self.path.join(name);
        // Nobody sits here who could be asked: what was there comes back from its versions.
        let kept = if path.is_file() { self.versions.keep(name, &path) } else { Ok(()) };
        kept.and_then(|()| RealDisk.write(&path, bytes))
            .map_err(|error| format!("{name} cannot be kept: {error}"))?;
        (self.kept)();
        Ok(path)
    }
}

/// Receives one file; gives how it ended, and its name.
pub fn receive_over_line(
    port: &mut Port,
    folder: &Folder<'_>,
    stopped: &dyn Fn() -> bool,
    shown: &mut Shown,
) -> Result<(State, String)> {
    let since = Instant::now();
    let mut receiver = Receiver::default();
    let mut bytes = [0; 512];
    let mut over: Option<Instant> = None;
    loop {
        if stopped() {
            receiver.stop();
            over.get_or_insert_with(Instant::now);
        }
        let count = port.read(&mut bytes, NAP)?;
        receiver.hear(&bytes[..count], (folder.moves)(), since.elapsed().as_secs_f64());
        if over.is_none() && receiver.state().is_over() {
            over = Some(Instant::now());
            let kept = receiver.file().map(|(name, bytes)| folder.keep(name, bytes));
            match kept {
                Some(Ok(_)) => receiver.kept(),
                Some(Err(why)) => receiver.refuse(&why),
                None => {}
            }
        }
        port.write(&receiver.speak())?;
        shown.tell(receiver.state(), &receiver.progress());
        let lingers = *receiver.state() == State::Done;
        if over.is_some_and(|at| !lingers || at.elapsed() >= LINGERS) {
            return Ok((receiver.state().clone(), receiver.progress().name));
        }
    }
}
