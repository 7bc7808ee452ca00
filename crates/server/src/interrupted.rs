//! The run that was cut short, as it is taken up: what it is known by, and how far it is in its plan.

use crate::digested::hash;
use crate::machine::Planned;
use crate::open::Open;
use crate::preview;
use kerf_control::Session;
use kerf_journal::Journal;
use kerf_wire::Interrupted;
use kerf_workspace::Workspace;

/// Returns the hash of the open file, where that is what was cut short: pages show it as that which runs.
pub fn hash_of_open(interrupted: &Interrupted, open: Open) -> Option<String> {
    let same_text = interrupted.hash.as_ref().is_none_or(|text| *text == hash(&open.bytes));
    (open.name == interrupted.file && same_text).then_some(open.hash)
}

/// The plan of the run that was cut short, from its beginning. Where it is not known what that was, there is none:
/// the run says itself why it cannot be taken up.
pub fn plan(journal: &Journal, workspace: &mut Workspace) -> Option<Planned> {
    let cut = journal.runs.cut_short().ok()??;
    let (work, options, session) = Session::begun(journal, &cut, workspace).ok()?;
    Some(preview::plan(work, options, session, workspace))
}
