//! Tells whether a file moves Z by itself.

use crate::Program;
use crate::table::{Group, Kind, Unit};
use crate::tree::{ArgKind, Node, Statement};
use kerf_program::Axis;

/// True when a line of the program is a move or jog that gives Z a value, or lifts it (MH, JH).
pub(super) fn moves_z(program: &Program) -> bool {
    program.lines.iter().any(|line| match line.node {
        Node::Move { command, given, .. } => {
            (0..command.count).any(|i| command.first + i == 2 && given & (1 << i) != 0)
        }
        Node::Statement(index) => {
            program.statements.get(index as usize).is_some_and(|s| statement_moves_z(program, s))
        }
        _ => false,
    })
}

fn statement_moves_z(program: &Program, statement: &Statement) -> bool {
    match statement {
        Statement::If { then, .. } => statement_moves_z(program, then),
        Statement::Command { spec, args, .. } => {
            matches!(spec.letters, "MH" | "JH")
                || matches!(spec.group, Group::Move | Group::Jog)
                    && spec.params.iter().zip(&program.args[*args]).any(|(param, arg)| {
                        param.kind == Kind::Number(Unit::Axis(Axis::Z))
                            && arg.kind != ArgKind::Blank
                    })
        }
        _ => false,
    }
}
