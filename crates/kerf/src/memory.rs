//! What the machine remembers between commands: the journal of the data folder.
//!
//! `run` and `send` go on where the last one ended; everything that only looks starts from inches
//! and zeros, so that its answer depends on nothing but the file. `--start` chooses otherwise.

use crate::args::{PlaceArgs, Start};
use anyhow::Result;
use kerf_control::journal::{Journal, Whereabouts};
use kerf_control::{Session, Shelf};
use std::path::Path;

/// Whether a command goes on from the journal; one that only looks usually does not.
pub fn is_kept(place: &PlaceArgs, looks: bool) -> bool {
    let usual = if looks { Start::Fresh } else { Start::Kept };
    place.start.unwrap_or(usual) == Start::Kept
}

/// The journal of a data folder. Who only looks leaves no trace of it; who runs makes one, and is
/// told when it had to be rescued.
pub fn journal(data: &Path, looks: bool) -> Result<Option<Journal>> {
    if looks {
        return Ok(Journal::look(data)?);
    }
    let (journal, told) = Journal::open(data)?;
    told.iter().for_each(|line| eprintln!("kerf: {line}"));
    Ok(Some(journal))
}

/// The machine as its journal remembers it.
pub fn recall(journal: &Journal, shelf: &mut Shelf, looks: bool) -> Result<Session> {
    let (session, whereabouts) = Session::recall(journal, shelf)?;
    if !looks {
        if whereabouts == Whereabouts::Moving {
            eprintln!(
                "kerf: the machine was moving when Kerf ended; its locations are not verified"
            );
        }
        if let Some(cut) = journal.cut_short()? {
            eprintln!("kerf: {}; kerf run --resume takes it up", cut.told());
        }
    }
    Ok(session)
}
