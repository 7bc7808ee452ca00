//! Arrays and objects, which FabMo's dialect alone has.

use super::line::{Line, Read};
use super::{ends, expression};
use crate::syntax::Dialect;
use crate::syntax::expr::{Path, PathStep};
use crate::syntax::tree::Span;
use kerf_diag::Code;

/// Hint about a file that is not in the dialect it is read in.
pub(super) const HINT: &str = "this is FabMo's dialect: --dialect fabmo";
pub(super) const ARRAYS_HINT: &str =
    "arrays and objects are FabMo's dialect: --dialect fabmo; here use plain variables";

/// Steps of one path.
const MOST_STEPS: usize = 8;

/// A hint that ends with what to do instead.
pub(super) fn or_else(instead: &str) -> String {
    format!("{HINT}; here {instead}")
}

pub(super) fn is_fabmo(l: &Line<'_, '_>) -> bool {
    l.file.program.dialect == Dialect::Fabmo
}

/// Returns `true` if a bracket or a dot behind the name of a variable says that it is a part of it.
pub(super) fn at_member(l: &Line<'_, '_>, start: usize) -> bool {
    let dotted = l.peek() == b'.' && l.byte(l.at + 1).is_ascii_alphabetic();
    l.peek() == b'[' || dotted && (is_fabmo(l) || l.byte(start) == b'$')
}

/// `&name[n].field`; the cursor stands behind the name.
pub(super) fn path(l: &mut Line<'_, '_>, start: usize) -> Read<Path> {
    if !is_fabmo(l) {
        l.foreign = true;
        let span = Span { start: start as u32, end: l.until(l.at, b' ') as u32 };
        let message = "arrays and objects are not part of the language";
        return Err(l.fault(Code::BadExpression, span, message, ARRAYS_HINT));
    }
    let persistent = l.byte(start) == b'$';
    let name = l.name(start + 1, l.at);
    let mut steps = Vec::new();
    while at_member(l, start) {
        if steps.len() >= MOST_STEPS {
            let span = l.span_from(start);
            return Err(l.fault(Code::BadExpression, span, "nested too deep", ""));
        }
        steps.push(step(l)?);
    }
    Ok(Path { persistent, name, steps })
}

fn step(l: &mut Line<'_, '_>) -> Read<PathStep> {
    let start = l.at;
    l.at += 1;
    if l.byte(start) == b'.' {
        l.at = l.word_end(l.at);
        return Ok(PathStep::Field(l.slice(start + 1, l.at).to_uppercase().into()));
    }
    if l.take(b']') {
        return Ok(PathStep::BothUnits);
    }
    // What stands between the brackets is an expression of its own.
    let stop = closing_bracket(l, start)?;
    let inner = Span { start: l.at as u32, end: stop as u32 };
    let left = (l.operators_left, l.depth_left);
    l.depth_left = l.depth_left.saturating_sub(1);
    if l.depth_left == 0 {
        let span = Span { start: start as u32, end: stop as u32 };
        return Err(l.fault(Code::BadExpression, span, "nested too deep", ""));
    }
    let index = l.within(inner, |line| {
        let index = expression::inner_expression(line)?;
        ends::expect_end(line)?;
        Ok(index)
    });
    l.operators_left = left.0.min(l.operators_left);
    l.depth_left = left.1;
    l.at = stop + 1;
    Ok(PathStep::Index(index?))
}

/// The bracket that belongs to the one at a place.
fn closing_bracket(l: &mut Line<'_, '_>, start: usize) -> Read<usize> {
    let mut open = 0_u32;
    for at in start..l.end {
        match l.byte(at) {
            b'[' => open += 1,
            b']' if open == 1 => return Ok(at),
            b']' => open -= 1,
            _ => {}
        }
    }
    let span = Span { start: start as u32, end: l.end as u32 };
    Err(l.fault(Code::UnclosedParenthesis, span, "a ] is missing", ""))
}
