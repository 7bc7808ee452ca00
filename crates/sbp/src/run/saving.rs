//! The saved form of an interpreter: the text of its programs once, then the states.

use super::past::Past;
use super::{Core, Interpreter};
use crate::{Dialect, Language, Program};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Saved form: programs as name and text, read again when restored.
#[derive(Serialize, Deserialize)]
pub(super) struct Saved {
    programs: Vec<SavedProgram>,
    core: Core,
    past: Past,
}

/// A program as its text; reading it again gives the same tree.
#[derive(Serialize, Deserialize)]
struct SavedProgram {
    name: Arc<str>,
    text: String,
    language: Language,
}

impl SavedProgram {
    fn of(program: &Program) -> Self {
        let Program { name, text, language, .. } = program;
        Self { name: name.clone(), text: text.to_string(), language: *language }
    }

    fn read(self, dialect: Dialect) -> Program {
        crate::syntax::reader::read_language(self.name, self.text, self.language, dialect)
    }
}

impl From<Interpreter> for Saved {
    fn from(interpreter: Interpreter) -> Self {
        let Interpreter { core, past } = interpreter;
        let programs = core.files.programs.iter().map(|p| SavedProgram::of(p)).collect();
        Self { programs, core, past }
    }
}

impl From<Saved> for Interpreter {
    fn from(saved: Saved) -> Self {
        let Saved { programs, mut core, mut past } = saved;
        let programs: Vec<Arc<Program>> =
            programs.into_iter().map(|saved| Arc::new(saved.read(core.options.dialect))).collect();
        // An older state knows the first few of the same list; knowing more changes nothing.
        for state in past.states_mut() {
            state.files.programs.clone_from(&programs);
        }
        core.files.programs = programs;
        Self { core, past }
    }
}
