//! Variables: never given a value, or counted in fractions and tested for equality.

use super::facts::Facts;
use crate::syntax::expr::{BinaryOp, Expr, ExprNode};
use crate::syntax::tree::{Assigned, NameId, Span, Statement};
use crate::syntax::value::single;
use kerf_diag::{Code, Diagnostic};
use std::collections::BTreeSet;

/// Variables that are used as numbers and that nothing in the file gives a value.
///
/// Variables are shared between files and outlast them, so this is silent for files that run others
/// or load variables with a custom cut, and tells each variable once.
pub(super) fn never_assigned(facts: &Facts<'_>) -> Vec<Diagnostic> {
    if facts.calls_files || facts.customs {
        return Vec::new();
    }
    let mut told: BTreeSet<NameId> =
        facts.statements().flat_map(|(_, s)| s.assigned().iter().copied()).collect();
    // A message box leaves its answer here.
    told.extend(
        facts.program.names.iter().position(|n| &**n == "MSGANSWER").map(|i| NameId(i as u32)),
    );
    let mut found = Vec::new();
    for (line, statement) in facts.statements() {
        for (name, span) in numbers_in(facts, statement) {
            if told.insert(name) {
                let text = facts.program.names.get(name.0 as usize).map_or("", |n| n);
                let message = format!("nothing in this file gives &{text} a value");
                let hint = "assign it, or ask for it with INPUT; another file may have set it";
                found.push(facts.finding(Code::NeverAssigned, line, span, message, hint));
            }
        }
    }
    found
}

/// The variables that a statement needs as numbers, and where.
fn numbers_in(facts: &Facts<'_>, statement: &Statement) -> Vec<(NameId, Span)> {
    let operands = &facts.program.expressions;
    let mut found = Vec::new();
    if matches!(statement, Statement::Command { .. }) {
        statement.expressions(facts.program, &mut |expr| found.extend(operands.variables(expr)));
    }
    facts.parts(statement, &mut |part| {
        if let ExprNode::Binary(op, a, b) = part.node
            && op.precedence() >= BinaryOp::Add.precedence()
        {
            for side in [&operands[a], &operands[b]] {
                if let ExprNode::Variable(name) = side.node {
                    found.push((name, side.span));
                }
            }
        }
    });
    found
}

/// `&i = &i + .1` somewhere and `IF &i = 1` elsewhere.
pub(super) fn fractional_counters(facts: &Facts<'_>) -> Vec<Diagnostic> {
    let counters: BTreeSet<NameId> =
        facts.statements().filter_map(|(_, s)| fractional_step(facts, s)).collect();
    let operands = &facts.program.expressions;
    let mut found = Vec::new();
    for (line, statement) in facts.lines() {
        let Statement::If { condition, .. } = statement else { continue };
        operands.each(condition, &mut |expr| {
            let ExprNode::Binary(BinaryOp::Equal | BinaryOp::NotEqual, a, b) = expr.node else {
                return;
            };
            let counter =
                [&operands[a], &operands[b]].into_iter().find_map(|side| match side.node {
                    ExprNode::Variable(name) if counters.contains(&name) => Some(name),
                    _ => None,
                });
            if let Some(name) = counter {
                let text = facts.program.names.get(name.0 as usize).map_or("", |n| n);
                let message = format!("&{text} counts in fractions and may miss this value");
                let hint = "test with < or >, or count in whole numbers";
                found.push(facts.finding(Code::FloatCounter, line, expr.span, message, hint));
            }
        });
    }
    found
}

/// The variable of `&i = &i + step` when the step is a fraction that binary numbers only come near.
fn fractional_step(facts: &Facts<'_>, statement: &Statement) -> Option<NameId> {
    let Statement::Assign { name, persistent: false, value: Assigned::Expr(expr), .. } = statement
    else {
        return None;
    };
    let ExprNode::Binary(BinaryOp::Add | BinaryOp::Subtract, a, b) = expr.node else {
        return None;
    };
    let (a, b) = (&facts.program.expressions[a], &facts.program.expressions[b]);
    let is_self = |side: &Expr| side.node == ExprNode::Variable(*name);
    let step = match (&a.node, &b.node) {
        (_, ExprNode::Number(step)) if is_self(a) => *step,
        (ExprNode::Number(step), _) if is_self(b) => *step,
        _ => return None,
    };
    // .5 and .25 are exact; .1 is not.
    (single(step) != step || step * 1024.0 % 1.0 != 0.0).then_some(*name)
}
