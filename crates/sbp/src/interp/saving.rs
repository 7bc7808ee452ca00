//! How an interpreter is saved: the text of its programs once, then the states.

use super::past::Past;
use super::{Core, Interpreter};
use crate::Program;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// What is written: programs as name and text, read again when restored.
#[derive(Serialize, Deserialize)]
pub(super) struct Saved {
    programs: Vec<(String, String)>,
    core: Core,
    past: Past,
}

impl From<Interpreter> for Saved {
    fn from(interpreter: Interpreter) -> Self {
        let Interpreter { core, past } = interpreter;
        let programs = core.programs.iter().map(|p| (p.name.to_string(), p.text.clone())).collect();
        Self { programs, core, past }
    }
}

impl From<Saved> for Interpreter {
    fn from(saved: Saved) -> Self {
        let Saved { programs, mut core, mut past } = saved;
        let programs: Vec<Arc<Program>> = programs
            .into_iter()
            .map(|(name, text)| Arc::new(crate::read(name.into(), text.into_bytes())))
            .collect();
        // An older state knows the first few of the same list; knowing more changes nothing.
        for state in past.states_mut() {
            state.programs.clone_from(&programs);
        }
        core.programs = programs;
        Self { core, past }
    }
}
