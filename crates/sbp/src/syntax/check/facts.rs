//! The facts about a file that the rules need.

use crate::syntax::expr::{Expr, ExprNode};
use crate::syntax::tree::{ArgKind, ArgList, Node, Program, Span, Statement};
use kerf_diag::{Code, Diagnostic};
use kerf_program::settings::LinearUnit;
use std::collections::BTreeSet;

/// A file, its lines looked up once.
pub(super) struct Facts<'a> {
    pub(super) program: &'a Program,
    /// The unit the machine is set to at the start.
    pub(super) unit: LinearUnit,
    /// Some line changes to relative distances.
    pub(super) relative: bool,
    /// Other files run within this one: FP and custom cuts, but for those of [`HARMLESS_CUSTOM`].
    pub(super) calls_files: bool,
    /// Custom cuts of any number.
    pub(super) customs: bool,
    commands: BTreeSet<&'static str>,
}

/// Custom cuts that neither switch anything nor move: variables, and the message of a wrong unit.
const HARMLESS_CUSTOM: [f64; 2] = [90.0, 91.0];

impl<'a> Facts<'a> {
    pub(super) fn new(program: &'a Program, unit: LinearUnit) -> Self {
        let mut facts = Self {
            program,
            unit,
            relative: false,
            calls_files: false,
            customs: false,
            commands: BTreeSet::new(),
        };
        for statement in program.statements.iter().flat_map(Statement::with_inner) {
            match statement {
                Statement::Command { spec, .. } => drop(facts.commands.insert(spec.letters)),
                Statement::Custom { number, .. } => {
                    facts.customs = true;
                    let known =
                        matches!(number.node, ExprNode::Number(n) if HARMLESS_CUSTOM.contains(&n));
                    facts.calls_files |= !known;
                }
                Statement::Shell(_) => facts.calls_files = true,
                _ => {}
            }
        }
        facts.relative = facts.uses("SR");
        facts.calls_files |= facts.uses("FP") || facts.uses("FG");
        facts
    }

    /// The expressions of a statement and those inside them.
    pub(super) fn parts(&self, statement: &'a Statement, f: &mut impl FnMut(&'a Expr)) {
        let operands = &self.program.expressions;
        statement.expressions(self.program, &mut |expr| operands.each(expr, f));
    }

    /// The value of an argument when it is a literal number.
    pub(super) fn literal(&self, args: ArgList, index: usize) -> Option<f64> {
        match &self.program.args[args].get(index)?.kind {
            ArgKind::Expr(Expr { node: ExprNode::Number(n), .. }) => Some(*n),
            _ => None,
        }
    }

    /// Returns `true` if an argument is given at all.
    pub(super) fn given(&self, args: ArgList, index: usize) -> bool {
        let arg = self.program.args[args].get(index);
        arg.is_some_and(|arg| arg.kind != ArgKind::Blank)
    }

    /// Returns `true` if a command stands anywhere in the file.
    pub(super) fn uses(&self, letters: &str) -> bool {
        self.commands.contains(letters)
    }

    /// Every statement with its line, those behind THEN and ON INPUT included.
    pub(super) fn statements(&self) -> impl Iterator<Item = (u32, &'a Statement)> {
        self.lines().flat_map(|(line, statement)| statement.with_inner().map(move |s| (line, s)))
    }

    /// Every statement that begins a line.
    pub(super) fn lines(&self) -> impl Iterator<Item = (u32, &'a Statement)> {
        let program = self.program;
        program.lines.iter().enumerate().filter_map(|(index, line)| match line.node {
            Node::Statement(at) => Some((index as u32 + 1, program.statements.get(at as usize)?)),
            _ => None,
        })
    }

    /// Moves with literal values: line, whether it jogs, and the value of each axis X, Y, Z.
    pub(super) fn literal_moves(&self) -> impl Iterator<Item = (u32, bool, [Option<f64>; 3])> {
        let program = self.program;
        program.lines.iter().enumerate().filter_map(|(index, line)| {
            let Node::Move { command, given, first } = line.node else { return None };
            let mut at = first as usize;
            let mut values = [None; 3];
            for i in 0..command.count {
                if given & (1 << i) == 0 {
                    continue;
                }
                if let Some(value) = values.get_mut(usize::from(command.first + i)) {
                    *value = program.numbers.get(at).copied();
                }
                at += 1;
            }
            Some((index as u32 + 1, command.jog, values))
        })
    }

    /// The first line that cuts: a move in X or Y at a literal Z below 0.
    ///
    /// None for files that use distances; where they cut is not known without running them.
    pub(super) fn first_cut(&self) -> Option<u32> {
        if self.relative {
            return None;
        }
        let mut below = false;
        self.literal_moves().find_map(|(line, jog, [x, y, z])| {
            below = z.map_or(below, |z| z < 0.0);
            (below && !jog && (x.is_some() || y.is_some())).then_some(line)
        })
    }

    /// A finding that points to a part of a line.
    pub(super) fn finding(
        &self,
        code: Code,
        line: u32,
        span: Span,
        message: impl Into<String>,
        hint: impl Into<String>,
    ) -> Diagnostic {
        Diagnostic::new(code, self.program.place(line, span), message).hint(hint)
    }

    /// The code of a line, without blanks around it and without its comment.
    pub(super) fn whole(&self, line: u32) -> Span {
        let text = self.program.line_text(line);
        let start = text.len() - text.trim_start_matches(crate::syntax::reader::blank).len();
        Span { start: start as u32, end: crate::syntax::reader::code_end(text.as_bytes()) as u32 }
    }

    /// A full-line comment without blanks around it.
    pub(super) fn comment(&self, line: u32) -> Span {
        let text = self.program.line_text(line);
        let start = text.len() - text.trim_start().len();
        Span { start: start as u32, end: text.trim_end().len() as u32 }
    }

    /// The text of a full-line comment.
    pub(super) fn comments(&self) -> impl Iterator<Item = (u32, &'a str)> {
        let program = self.program;
        let lines = program.lines.iter().enumerate();
        lines.filter(|(_, line)| line.node == Node::Comment).map(move |(index, _)| {
            let line = index as u32 + 1;
            (line, program.line_text(line).trim().trim_start_matches('\'').trim())
        })
    }
}
