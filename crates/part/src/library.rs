//! The G-code that a run has read: files that run again are not read again.

use crate::program::gcode_of;
use std::sync::Arc;

/// Files of G-code by the number that OpenSBP gives the file.
#[derive(Clone, Debug, Default)]
pub(crate) struct Library(Vec<Option<Arc<kerf_gcode::Program>>>);

impl Library {
    /// With the G-code of the file that was started.
    pub(crate) fn new(first: Option<Arc<kerf_gcode::Program>>) -> Self {
        Self(vec![first])
    }

    /// The G-code of a file.
    pub(crate) fn of(
        &mut self,
        file: u32,
        sbp: &kerf_sbp::Interpreter,
    ) -> Arc<kerf_gcode::Program> {
        let index = file as usize;
        if self.0.len() <= index {
            self.0.resize(index + 1, None);
        }
        let slot = &mut self.0[index];
        if let Some(known) = slot {
            return known.clone();
        }
        let read = sbp.program(file).and_then(gcode_of).unwrap_or_default();
        slot.insert(Arc::new(read)).clone()
    }
}
