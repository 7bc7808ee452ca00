//! Text behind the end of a program: posts write notes and data there, and no controller reads them.

use crate::syntax::codes::STOP;
use crate::syntax::gathered::Gathered;
use crate::syntax::tree::{Node, Program, Value, Word};
use kerf_diag::{Diagnostic, Severity};

/// The line, from 1, of the M2 or M30 that nothing passes: no subroutine, loop or branch stands behind it.
pub(super) fn last_line(program: &Program) -> Option<u32> {
    let mut end = None;
    for (index, node) in program.lines.others() {
        let Node::Block(block) = node else { continue };
        let Some(block) = program.blocks.get(block as usize) else { continue };
        let flows = program.extra_of(block).is_some_and(|extra| extra.flow.is_some());
        if flows {
            end = None;
        } else if end.is_none() && block.delete == 0 && stops(program.words_of(block)) {
            end = Some(index + 1);
        }
    }
    end
}

fn stops(words: &[Word]) -> bool {
    let value = |word: &Word| match word.value {
        Value::Number(n) => Ok(n),
        Value::Computed(_) => Ok(f64::NAN),
    };
    matches!(Gathered::of(words, value, |_| {}).m[STOP], Some(2 | 30))
}

/// Mistakes behind the end are told, and stop nothing.
pub(super) fn never_reached(mut found: Vec<Diagnostic>, end: u32) -> Vec<Diagnostic> {
    for diagnostic in found.iter_mut().filter(|d| d.place.line > end && d.is_error()) {
        let hint = format!("never reached: it stands behind the end of the program in line {end}");
        *diagnostic = diagnostic.clone().hint(hint).severity(Severity::Warning);
    }
    found
}
