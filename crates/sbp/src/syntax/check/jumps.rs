//! Jumps: labels that are missing, lines that nothing reaches, loops that never end.

use super::facts::Facts;
use crate::syntax::expr::{Expr, ExprNode, Function};
use crate::syntax::reader::did_you_mean;
use crate::syntax::tree::{NameId, Node, Statement};
use kerf_diag::{Code, Diagnostic};
use std::collections::BTreeSet;

/// Names are compared with at most so many others, so that huge files stay quick to check.
const MOST_NAMES: usize = 300;

/// Loops of more lines than this are not looked at, for the same reason.
const MOST_LINES: u32 = 1000;

/// Jumps to labels that the file has not; an error only when the jump is taken.
pub(super) fn unknown_labels(facts: &Facts<'_>) -> Vec<Diagnostic> {
    let labels = || {
        let labels = facts.program.labels.iter().take(MOST_NAMES);
        labels.map(|label| facts.program.label_name(label.name))
    };
    let mut hints = MOST_NAMES;
    let missing = facts.lines().filter_map(|(line, statement)| {
        let target = statement.target().filter(|target| facts.program.line_of(target).is_none())?;
        hints = hints.saturating_sub(1);
        let near = (hints > 0)
            .then(|| did_you_mean(facts.program.label_name(target.label), labels()))
            .flatten();
        let hint =
            near.unwrap_or_else(|| "a label is a name alone on a line, ending in a colon".into());
        let message = format!("there is no label {}", facts.program.label_name(target.label));
        Some(facts.finding(Code::UnknownLabel, line, target.span, message, hint))
    });
    missing.collect()
}

/// Lines behind an unconditional end or jump with no label before them: told once for each stretch.
pub(super) fn unreachable_lines(facts: &Facts<'_>) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    let mut ended: Option<u32> = None;
    for (index, line) in facts.program.lines.iter().enumerate() {
        let number = index as u32 + 1;
        match line.node {
            Node::Blank | Node::Comment => {}
            // A line that cannot be read may be a label that was misspelt.
            Node::Label(_) | Node::Bad => ended = None,
            node if is_end(facts, node) => ended = Some(number),
            _ => {
                if let Some(end) = ended.take() {
                    let hint = format!("line {end} goes elsewhere and no label stands between");
                    let message = "this line is never reached";
                    let span = facts.whole(number);
                    found.push(facts.finding(Code::Unreachable, number, span, message, hint));
                }
            }
        }
    }
    found
}

/// True for a line behind which the program never goes on with the next one.
fn is_end(facts: &Facts<'_>, node: Node) -> bool {
    let Node::Statement(at) = node else { return false };
    matches!(
        facts.program.statements.get(at as usize),
        Some(
            Statement::End
                | Statement::EndAll
                | Statement::ExitShopbot
                | Statement::Return
                | Statement::Goto(_)
        )
    )
}

/// Jumps back over lines that neither move, wait, ask nor leave.
///
/// A loop counts as endless when it jumps back always, or on a condition that nothing in the loop
/// can change. ON INPUT may end any loop, so files that use it are left alone.
pub(super) fn endless_loops(facts: &Facts<'_>) -> Vec<Diagnostic> {
    if facts.lines().any(|(_, s)| matches!(s, Statement::OnInput { .. })) {
        return Vec::new();
    }
    let mut found = Vec::new();
    for (line, statement) in facts.lines() {
        let Some(target) = statement.target() else { continue };
        let first = facts
            .program
            .line_of(target)
            .filter(|first| (*first..=first + MOST_LINES).contains(&line));
        let Some(first) = first else { continue };
        let condition = match statement {
            Statement::Goto(_) => None,
            Statement::If { condition, then } if matches!(**then, Statement::Goto(_)) => {
                Some(condition)
            }
            _ => continue,
        };
        if spins(facts, first, line, condition) {
            let message = format!("this loop over lines {first} to {line} never moves or ends");
            let hint = "let it move, wait with PAUSE, or leave it with IF ... THEN GOTO";
            found.push(facts.finding(Code::EndlessLoop, line, target.span, message, hint));
        }
    }
    found
}

/// Returns `true` if the lines of a loop only compute and nothing in them can end it.
fn spins(facts: &Facts<'_>, first: u32, last: u32, condition: Option<&Expr>) -> bool {
    let mut changed: BTreeSet<NameId> = BTreeSet::new();
    for line in first..last {
        match facts.program.lines.get(line as usize - 1).map(|l| l.node) {
            Some(Node::Blank | Node::Comment | Node::Label(_)) => {}
            Some(Node::Statement(at)) => {
                let Some(statement) = facts.program.statements.get(at as usize) else {
                    return false;
                };
                if !statement.with_inner().all(|s| stays(facts, s, first, last)) {
                    return false;
                }
                changed.extend(statement.with_inner().flat_map(Statement::assigned));
            }
            _ => return false,
        }
    }
    condition.is_none_or(|condition| is_fixed(facts, condition, &changed))
}

/// True for what computes or shows something and goes on within the loop.
fn stays(facts: &Facts<'_>, statement: &Statement, first: u32, last: u32) -> bool {
    match statement {
        Statement::Assign { .. } | Statement::Output(_) | Statement::If { .. } => true,
        Statement::Goto(target) => {
            facts.program.line_of(target).is_some_and(|to| (first..=last).contains(&to))
        }
        _ => false,
    }
}

/// Returns `true` if an expression keeps its value while these variables change.
fn is_fixed(facts: &Facts<'_>, expr: &Expr, changed: &BTreeSet<NameId>) -> bool {
    !facts.program.expressions.any(expr, &|node| match node {
        ExprNode::System(_) | ExprNode::Persistent(_) | ExprNode::Call(Function::Rnd, _) => true,
        ExprNode::Variable(name) => changed.contains(name),
        _ => false,
    })
}
