//! Units: whether the file says which one it is written in, and whether that fits.

use super::facts::Facts;
use crate::syntax::expr::{BinaryOp, Expr, ExprNode};
use crate::syntax::tree::{Span, Statement};
use kerf_diag::{Code, Diagnostic, Severity};
use kerf_program::settings::LinearUnit;

/// The system variable that tells the unit: 0 inches, 1 mm.
const UNIT_VARIABLE: f64 = 25.0;

/// A note for files that cut at literal places and neither test nor set the unit.
pub(super) fn missing_guard(facts: &Facts<'_>) -> Vec<Diagnostic> {
    if asks_unit(facts) || sets_unit(facts) {
        return Vec::new();
    }
    let Some(line) = facts.first_cut() else { return Vec::new() };
    let hint = "begin with IF %(25) = 1 THEN GOTO UNIT_ERROR (0 for files in mm)";
    let message = "the file does not say whether it is in inches or mm";
    let span = facts.whole(line);
    let found = facts.finding(Code::MissingUnitGuard, line, span, message, hint);
    vec![found.severity(Severity::Note)]
}

/// A header in one unit: against the guard, or against the unit set when nothing guards.
pub(super) fn mismatch(facts: &Facts<'_>) -> Vec<Diagnostic> {
    let Some((line, written)) = header(facts) else { return Vec::new() };
    let name = unit_name(written);
    let told = |line, span, message: String, hint: &str| {
        vec![facts.finding(Code::UnitsMismatch, line, span, message, hint)]
    };
    if let Some((guard_line, span, expected)) = guard(facts) {
        if expected == written {
            return Vec::new();
        }
        let message =
            format!("line {line} says {name}, this lets only {} pass", unit_name(expected));
        return told(guard_line, span, message, "%(25) is 0 for inches and 1 for mm");
    }
    if written == facts.unit || asks_unit(facts) || sets_unit(facts) {
        return Vec::new();
    }
    let message = format!("the file is in {name}, the machine is set to {}", unit_name(facts.unit));
    told(line, facts.comment(line), message, "set the unit with VD before the run")
}

fn unit_name(unit: LinearUnit) -> &'static str {
    match unit {
        LinearUnit::Inch => "inches",
        LinearUnit::Mm => "mm",
    }
}

fn is_unit_variable(facts: &Facts<'_>, node: &ExprNode) -> bool {
    let ExprNode::System(index) = node else { return false };
    facts.program.expressions[*index].node == ExprNode::Number(UNIT_VARIABLE)
}

/// Returns `true` if %(25) is read anywhere.
fn asks_unit(facts: &Facts<'_>) -> bool {
    let mut found = false;
    for (_, statement) in facts.statements() {
        facts.parts(statement, &mut |part| found |= is_unit_variable(facts, &part.node));
    }
    found
}

/// Returns `true` if VD changes the unit.
fn sets_unit(facts: &Facts<'_>) -> bool {
    facts.statements().any(|(_, statement)| {
        matches!(statement, Statement::Command { spec, args, .. } if spec.letters == "VD" && facts.given(*args, 2))
    })
}

/// Returns the unit that the comments at the head say, and its line: `FILE IN INCHES`, `UNITS:MM`.
fn header(facts: &Facts<'_>) -> Option<(u32, LinearUnit)> {
    let end = facts.literal_moves().next().map_or(u32::MAX, |(line, ..)| line);
    facts.comments().take_while(|(line, _)| *line < end).find_map(|(line, text)| {
        let text = text.to_uppercase();
        let unit = match text.split_once("FILE IN ") {
            Some((_, unit)) => unit,
            None => text.strip_prefix("UNITS")?.trim_start_matches([' ', ':', '=']),
        };
        let is = |names: &[&str]| names.iter().any(|name| unit.trim().starts_with(name));
        if is(&["INCH"]) {
            return Some((line, LinearUnit::Inch));
        }
        (unit.trim() == "MM" || is(&["MM ", "MILLIM", "METRIC"])).then_some((line, LinearUnit::Mm))
    })
}

/// `IF %(25) = n THEN GOTO …ERROR`: its line, its condition, and the unit that passes.
fn guard(facts: &Facts<'_>) -> Option<(u32, Span, LinearUnit)> {
    facts.lines().find_map(|(line, statement)| {
        let Statement::If { condition, .. } = statement else { return None };
        let target = statement.target()?;
        if !facts.program.label_name(target.label).contains("ERROR") {
            return None;
        }
        let refused = refused_unit(facts, condition)?;
        let passes = if refused == LinearUnit::Inch { LinearUnit::Mm } else { LinearUnit::Inch };
        Some((line, condition.span, passes))
    })
}

/// The unit that a condition `%(25) = n` is true for.
fn refused_unit(facts: &Facts<'_>, condition: &Expr) -> Option<LinearUnit> {
    let ExprNode::Binary(BinaryOp::Equal, a, b) = condition.node else { return None };
    let operands = &facts.program.expressions;
    let number = match (&operands[a].node, &operands[b].node) {
        (variable, ExprNode::Number(n)) if is_unit_variable(facts, variable) => *n,
        (ExprNode::Number(n), variable) if is_unit_variable(facts, variable) => *n,
        _ => return None,
    };
    match number {
        0.0 => Some(LinearUnit::Inch),
        1.0 => Some(LinearUnit::Mm),
        _ => None,
    }
}
