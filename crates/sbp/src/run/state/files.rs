//! The programs that a run has read.

use super::variables::Variables;
use crate::syntax::Program;
use crate::syntax::tree::NameId;
use std::sync::Arc;

/// Programs by the number that [`At::file`](kerf_program::At) has, and the variables behind their names.
#[derive(Clone, Debug, Default)]
pub(crate) struct Files {
    pub(crate) programs: Vec<Arc<Program>>,
    /// For each program, the variable slot of each of its names. Made again after restoring.
    links: Vec<Arc<[u32]>>,
}

impl Files {
    /// Adds a program, or finds the same one read before; returns its number.
    pub(crate) fn load(&mut self, program: Arc<Program>, variables: &mut Variables) -> u32 {
        let known = |p: &Arc<Program>| {
            Arc::ptr_eq(p, &program) || p.name == program.name && p.text == program.text
        };
        if let Some(index) = self.programs.iter().position(known) {
            return index as u32;
        }
        self.programs.push(program);
        self.link(variables);
        self.programs.len() as u32 - 1
    }

    /// Finds the slots of the names of all programs that have none yet.
    pub(crate) fn link(&mut self, variables: &mut Variables) {
        for program in self.programs.iter().skip(self.links.len()) {
            self.links.push(program.names.iter().map(|name| variables.slot(name)).collect());
        }
    }

    /// A program by its number, where there is one.
    pub(crate) fn get(&self, file: u32) -> Option<&Arc<Program>> {
        self.programs.get(file as usize)
    }

    /// A program by its number; an empty one for a number that none has.
    pub(crate) fn program(&self, file: u32) -> Arc<Program> {
        self.get(file).cloned().unwrap_or_default()
    }

    /// Variable slot of a name of a file.
    pub(crate) fn slot(&self, file: u32, name: NameId) -> u32 {
        let links = self.links.get(file as usize);
        links.and_then(|l| l.get(name.0 as usize)).copied().unwrap_or(u32::MAX)
    }
}
