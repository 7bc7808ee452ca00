//! Ways down that are not as they were asked for, told before anything moves.

use crate::cut::Cut;
use crate::setup::Setup;
use crate::values::Values;
use kerf_diag::{Code, Diagnostic, SourcePlace};
use kerf_program::job::JobShape;
use std::collections::BTreeSet;

/// Tells what was changed since the job was made, and the shapes whose way down is another one than they ask
/// for. What holds for all shapes of a group is told with the first of them.
pub(crate) fn mistakes(setup: &Setup, values: &Values) -> Vec<Diagnostic> {
    let mut told = BTreeSet::new();
    let noted = setup.job.notes.iter().map(|note| (note.shape, note.text.to_string()));
    let changed = setup.job.shapes.iter().filter_map(|shape: &JobShape| {
        let why = Cut { setup, values, shape }.other_entry()?;
        Some((shape.number, format!("group {}: {why}", shape.group)))
    });
    let new = noted.chain(changed).filter(|(_, message)| told.insert(message.clone()));
    let place = |number| SourcePlace::line(setup.job.name.clone(), number);
    new.map(|(number, message)| Diagnostic::new(Code::OtherEntry, place(number), message)).collect()
}
