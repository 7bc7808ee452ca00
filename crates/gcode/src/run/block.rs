//! The words of a block with the values of now, and the parameters that it sets.

use super::context::Context;
use super::controllers::{self, need_words};
use super::core::Core;
use super::expression::{Assigned, evaluate};
use super::parameters::{moves_zero, set_named, set_numbered};
use super::stop::Stop;
use crate::syntax::gathered::{Fault, Gathered};
use crate::syntax::tree::{Block, Program, Span, Value, Word};
use kerf_diag::Code;

/// The words of a block with the values of now.
pub(super) fn gather(
    core: &Core,
    program: &Program,
    block: &Block,
    span: Span,
) -> Result<Gathered, Stop> {
    let words = program.words_of(block);
    if !block.computed {
        let value = |w: &Word| match w.value {
            Value::Number(n) => Ok(n),
            Value::Computed(_) => Ok(0.0),
        };
        return Ok(Gathered::of(words, value, |_| {}));
    }
    need_words(core.options.dialect, controllers::EXPRESSIONS)?;
    let parameters = core.parameters();
    let mut first = None;
    let value = |w: &Word| match w.value {
        Value::Number(n) => Ok(n),
        Value::Computed(index) => match program.exprs.get(index as usize) {
            Some(expr) => evaluate(&parameters, program, expr, w.span),
            None => Ok(0.0),
        },
    };
    let gathered = Gathered::of(words, value, |f| {
        first.get_or_insert(f);
    });
    gathered.needs(span, &mut |f| {
        first.get_or_insert(f);
    });
    match first {
        Some(fault) => Err(fault.into()),
        None => Ok(gathered),
    }
}

/// Sets parameters.
pub(super) fn assign(
    c: &mut Context<'_>,
    program: &Program,
    values: Vec<(Assigned, Span)>,
) -> Result<(), Stop> {
    for (assigned, span) in values {
        let scheme = c.core.scheme();
        let (state, calls) = (&mut c.core.state, &mut c.core.calls);
        match assigned {
            Assigned::Number(number, value) => {
                set_numbered(state, calls, scheme, (number, value, span))?;
                if moves_zero(number) {
                    c.relocate();
                }
            }
            Assigned::Name(id, value) => {
                let name = program.names.get(id as usize).cloned().unwrap_or_default();
                set_named(state, calls, name, value);
            }
        }
    }
    Ok(())
}

/// A line that the reader refused.
pub(super) fn bad(c: &mut Context<'_>, program: &Program) -> Result<(), Stop> {
    if c.core.options.keep_going {
        c.core.told.motion_lost = true;
        return Ok(());
    }
    let line = c.at.line;
    let known = program.diagnostics.iter().find(|d| d.place.line == line && d.is_error());
    Err(match known.or(program.diagnostics.first()) {
        Some(diagnostic) => Stop::Failed(Box::new(diagnostic.clone())),
        None => Fault::new(Code::BadBlock, c.span, "this line cannot be read").into(),
    })
}
