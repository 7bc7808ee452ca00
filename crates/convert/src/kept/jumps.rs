//! Jumps to labels as loops and conditions.
//!
//! LinuxCNC has no jump. What people write with labels has few forms, and these are found again:
//!
//! ```text
//!  L: … IF c THEN GOTO L        do … while [c]
//!  L: … GOTO L                  while [1] … endwhile, a jump behind it is break
//!  IF c THEN GOTO L … L:        if [not c] … endif
//!  IF c THEN GOTO A … GOTO B, A: … B:     if [c] (what stands at A) else … endif
//!  GOSUB L … L: … RETURN        sub and call
//! ```
//!
//! Any other jump is refused with its line.

use super::Unkept;
use kerf_sbp::Expr;
use kerf_sbp::tree::{Node, Program, Statement, Target};

/// An unconditional or conditional jump of a line, and where it goes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Jump {
    /// The condition; `None` when it is always made.
    pub(super) condition: Option<Expr>,
    /// The line of the label, from 1.
    pub(super) to: u32,
}

/// The statement of a line, counted from 1.
pub(super) fn statement(program: &Program, line: u32) -> Option<&Statement> {
    match program.lines.get(line.checked_sub(1)? as usize)?.node {
        Node::Statement(index) => program.statements.get(index as usize),
        _ => None,
    }
}

/// The jump of a line.
pub(super) fn jump(program: &Program, line: u32) -> Result<Option<Jump>, Unkept> {
    let (condition, target) = match statement(program, line) {
        Some(Statement::Goto(target)) => (None, target),
        Some(Statement::If { condition, then }) => match &**then {
            Statement::Goto(target) => (Some(*condition), target),
            _ => return Ok(None),
        },
        _ => return Ok(None),
    };
    Ok(Some(Jump { condition, to: line_of(program, target, line)? }))
}

/// The line of a label.
pub(super) fn line_of(program: &Program, target: &Target, line: u32) -> Result<u32, Unkept> {
    program.line_of(target).ok_or_else(|| Unkept::new(line, "a jump to a missing label"))
}

/// The last line up to `end` that jumps back to a label.
pub(super) fn last_jump_back(
    program: &Program,
    label: u32,
    end: u32,
) -> Result<Option<u32>, Unkept> {
    for line in (label + 1..end).rev() {
        if jump(program, line)?.is_some_and(|jump| jump.to == label) {
            return Ok(Some(line));
        }
    }
    Ok(None)
}

/// The first line at or behind a line that does something: labels, comments and blanks do nothing.
pub(super) fn doing(program: &Program, from: u32) -> u32 {
    let idle = |line: &u32| {
        let node = program.lines.get(*line as usize - 1).map(|l| l.node);
        matches!(node, Some(Node::Blank | Node::Comment | Node::Label(_)))
    };
    (from..).find(|line| !idle(line)).unwrap_or(from)
}

/// The last line before a line that does something, or nothing before `least`.
pub(super) fn doing_before(program: &Program, line: u32, least: u32) -> Option<u32> {
    (least..line).rev().find(|line| doing(program, *line) == *line)
}
