//! One table of files for two languages.
//!
//! Each interpreter counts the files it has read from 0; whoever follows a run knows one count.

use kerf_program::{At, Sourced};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// The files of a run, in the order in which they were first met.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(crate) struct Files {
    names: Vec<Arc<str>>,
    /// For each file of OpenSBP its number here.
    sbp: Vec<u32>,
}

impl Files {
    /// Name of a file; `None` when so many were not met.
    pub(crate) fn name(&self, file: u32) -> Option<Arc<str>> {
        self.names.get(file as usize).cloned()
    }

    /// Learns the names of files of OpenSBP that are new.
    pub(crate) fn learn_sbp(&mut self, sbp: &kerf_sbp::Interpreter) {
        while let Some(program) = sbp.program(self.sbp.len() as u32) {
            self.sbp.push(self.names.len() as u32);
            self.names.push(program.name.clone());
        }
    }

    /// The number here of a file of OpenSBP.
    pub(crate) fn of_sbp(&self, file: u32) -> u32 {
        self.sbp.get(file as usize).copied().unwrap_or(file)
    }

    /// The number in OpenSBP of a file that it knows.
    pub(crate) fn to_sbp(&self, file: u32) -> Option<u32> {
        self.sbp.iter().position(|here| *here == file).map(|there| there as u32)
    }

    /// The places of commands that OpenSBP gave, as numbers here.
    pub(crate) fn translate_sbp(&self, given: &mut [Sourced]) {
        let same = self.sbp.iter().zip(0..).all(|(here, there)| *here == there);
        if !same {
            for sourced in given {
                sourced.at.file = self.of_sbp(sourced.at.file);
            }
        }
    }

    /// The numbers here of the files that G-code has read, the first of which is known.
    pub(crate) fn learn_gcode(&mut self, known: &mut Vec<u32>, gcode: &kerf_gcode::Interpreter) {
        while let Some(program) = gcode.program(known.len() as u32) {
            known.push(self.names.len() as u32);
            self.names.push(program.name.clone());
        }
    }
}

/// A place in the files that G-code has read, as numbers here.
pub(crate) fn translated(known: &[u32], at: At) -> At {
    At { file: known.get(at.file as usize).copied().unwrap_or(at.file), ..at }
}
