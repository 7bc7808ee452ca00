//! Statements that speak to the operator, to files and to other programs.

use super::{Context, Stop};
use crate::tree::Statement;
use kerf_diag::Code;

impl Context<'_> {
    /// Executes one of them.
    pub(crate) fn outward_statement(&mut self, _statement: &Statement) -> Result<(), Stop> {
        Err(self.fail(Code::NotSupported, "this statement is not carried out yet"))
    }
}
