//! The saved form of an interpreter: the text of its programs once, then the state.

use super::{Core, Interpreter};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Saved form: programs as name and text, read again when restored.
#[derive(Serialize, Deserialize)]
pub(super) struct Saved {
    programs: Vec<(String, String)>,
    core: Core,
}

impl From<Interpreter> for Saved {
    fn from(interpreter: Interpreter) -> Self {
        let core = interpreter.core;
        let programs =
            core.programs.iter().map(|p| (p.name.to_string(), p.text.to_string())).collect();
        Self { programs, core }
    }
}

impl From<Saved> for Interpreter {
    fn from(saved: Saved) -> Self {
        let Saved { programs, mut core } = saved;
        core.programs = programs
            .into_iter()
            .map(|(name, text)| {
                Arc::new(crate::syntax::reader::read_text(name.into(), Arc::new(text)))
            })
            .collect();
        Self { core }
    }
}
