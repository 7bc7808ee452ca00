//! The memory of the machine between commands: the journal of the data folder.
//!
//! `run` and `send` go on where the last one ended; everything that only looks starts from inches
//! and zeros, so that its answer depends on nothing but the file. `--start` chooses otherwise.

use crate::args::{PlaceArgs, Start};
use anyhow::Result;
use kerf_control::Session;
use kerf_journal::{Journal, JournalError, Whereabouts};
use kerf_workspace::{Workspace, unconfirmed, unverified};
use std::path::Path;

/// Returns `true` if a command goes on from the journal; one that only looks usually does not.
pub fn is_kept(place: &PlaceArgs, looks: bool) -> bool {
    let usual =
        if looks && place.machine.controller().is_none() { Start::Fresh } else { Start::Kept };
    place.start.unwrap_or(usual) == Start::Kept
}

/// The journal of a data folder. Who only looks leaves no trace of it; who runs makes one, and is
/// told when it had to be rescued.
pub fn journal(data: &Path, looks: bool) -> Result<Option<Journal>> {
    if looks {
        return Ok(Journal::look(data)?);
    }
    sweep(data);
    let (journal, told) = Journal::open(data)?;
    told.iter().for_each(|line| eprintln!("kerf: {line}"));
    Ok(Some(journal))
}

/// Removes what killed writers left half written in a folder, and says so.
pub fn sweep(folder: &Path) {
    match kerf_files::sweep(folder) {
        0 => {}
        1 => eprintln!(
            "kerf: removed a file from {} that a killed Kerf left half written",
            folder.display()
        ),
        n => eprintln!(
            "kerf: removed {n} files from {} that a killed Kerf left half written",
            folder.display()
        ),
    }
}

/// The machine as its journal remembers it.
pub fn recall(journal: &Journal, workspace: &mut Workspace, looks: bool) -> Result<Session> {
    let (session, whereabouts) = Session::recall(journal, workspace)?;
    if !looks {
        session.meet_machine(workspace)?.iter().for_each(|told| eprintln!("kerf: {told}"));
        tell(journal, workspace, whereabouts)?;
    }
    Ok(session)
}

/// Tells what is in doubt since the process before, and what it did not finish; or that it still runs.
fn tell(journal: &Journal, workspace: &Workspace, whereabouts: Whereabouts) -> Result<()> {
    let cut = journal.runs.cut_short()?;
    let moving = whereabouts == Whereabouts::Moving;
    if (moving || cut.is_some()) && matches!(journal.own(), Err(JournalError::Owned { .. })) {
        eprintln!("kerf: another Kerf runs the machine now");
        return Ok(());
    }
    let doubted = unverified(workspace);
    if moving {
        eprintln!("kerf: the machine was moving when Kerf ended; its locations are not verified");
    } else if !doubted.is_empty() {
        let letters: Vec<String> = doubted.iter().map(|axis| axis.letter().to_string()).collect();
        eprintln!("kerf: locations that are not verified: {}", letters.join(" "));
    }
    if !unconfirmed(workspace).is_empty() {
        eprintln!(
            "kerf: a new run asks first whether they are right; home the machine or zero it; a script answers \
             with --answers FILE, where FILE has the line location=Continue"
        );
    }
    if let Some(cut) = cut {
        let how = match cut.controller() {
            None => "kerf run --resume takes it up".to_owned(),
            Some(name) => format!("kerf run --resume --machine {name} takes it up"),
        };
        eprintln!("kerf: {}; {how}", cut.sentence());
    }
    Ok(())
}
