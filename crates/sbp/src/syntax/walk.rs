//! Going through the tree: the expressions, variables and jumps of a statement.

use crate::syntax::Program;
use crate::syntax::expr::{Expr, ExprNode, Expressions, Path, PathStep};
use crate::syntax::tree::{ArgKind, Assigned, DialogText, NameId, Span, Statement, Target};

impl Statement {
    /// The statement itself and the one behind its THEN or ON INPUT.
    pub(crate) fn with_inner(&self) -> impl Iterator<Item = &Self> {
        let inner = match self {
            Self::If { then, .. } => Some(&**then),
            Self::OnInput { action, .. } => action.as_deref(),
            _ => None,
        };
        std::iter::once(self).chain(inner)
    }

    /// The label that it jumps to, itself or behind THEN or ON INPUT.
    pub(crate) fn target(&self) -> Option<&Target> {
        self.with_inner().find_map(|s| match s {
            Self::Goto(target) | Self::Gosub(target) => Some(target),
            _ => None,
        })
    }

    /// Calls `f` with each of its own expressions, not those of an inner statement.
    pub(crate) fn expressions<'a>(&'a self, program: &'a Program, f: &mut impl FnMut(&'a Expr)) {
        match self {
            Self::Command { args, .. } => {
                for arg in &program.args[*args] {
                    if let ArgKind::Expr(expr) = &arg.kind {
                        f(expr);
                    }
                }
            }
            Self::Assign { value: Assigned::Expr(expr), .. }
            | Self::Fail(Some(expr))
            | Self::If { condition: expr, .. }
            | Self::Pause { seconds: Some(expr) }
            | Self::InputFile { file: expr, .. }
            | Self::Close(Some(expr))
            | Self::Custom { number: expr, .. } => f(expr),
            Self::OnInput { switch: a, state: b, .. }
            | Self::PauseUntil { switch: a, state: b }
            | Self::Open { path: a, number: b, .. } => [a, b].into_iter().for_each(f),
            Self::Output(output) => output.file.iter().chain(&output.items).for_each(f),
            Self::Input(input) => input.text.iter().chain(&input.default).for_each(f),
            Self::AssignMember { path, value, .. } => {
                program.expressions[*path].indexes().for_each(&mut *f);
                if let Assigned::Expr(expr) = value {
                    f(expr);
                }
            }
            Self::Dialog(d) => {
                let words = [&d.title, &d.detail, &d.ok, &d.cancel, &d.seconds];
                [&d.text].into_iter().chain(words.into_iter().flatten()).for_each(f);
            }
            Self::Data { items, .. } => items.iter().for_each(f),
            Self::Shell(shell) => {
                shell.display.iter().chain(shell.line.expression()).for_each(f);
            }
            _ => self
                .dialog_texts()
                .into_iter()
                .flatten()
                .filter_map(DialogText::expression)
                .for_each(f),
        }
    }

    /// The texts that are shown to people or given to programs.
    pub(crate) fn dialog_texts(&self) -> [Option<&DialogText>; 3] {
        match self {
            Self::MsgBox(shown) => [Some(&shown.body), Some(&shown.style), Some(&shown.title)],
            Self::Play(text) | Self::Store { value: text, .. } => [Some(text), None, None],
            Self::Shell(shell) => [Some(&shell.line), None, None],
            _ => [None; 3],
        }
    }

    /// The variables it gives a value.
    pub(crate) fn assigned(&self) -> &[NameId] {
        match self {
            Self::Assign { name, persistent: false, .. } => std::slice::from_ref(name),
            Self::Input(input) => &input.variables,
            Self::InputFile { variables, .. } => variables,
            Self::Fetch { variable, .. } => std::slice::from_ref(variable),
            Self::Dialog(dialog) => dialog.variable.as_slice(),
            _ => &[],
        }
    }
}

impl DialogText {
    /// The expression, if it is one.
    pub(crate) fn expression(&self) -> Option<&Expr> {
        match self {
            Self::Expr(expr) => Some(expr),
            Self::Parts(_) => None,
        }
    }
}

impl Expressions {
    /// True when something holds for an expression or for one inside it.
    pub(crate) fn any(&self, expr: &Expr, holds: &impl Fn(&ExprNode) -> bool) -> bool {
        let mut found = false;
        self.each(expr, &mut |part| found |= holds(&part.node));
        found
    }

    /// True when a bare word stands somewhere in an expression.
    pub(crate) fn has_words(&self, expr: &Expr) -> bool {
        self.any(expr, &|node| matches!(node, ExprNode::Word(_)))
    }

    /// True when a variable, system variable or function stands in it.
    pub(crate) fn has_values(&self, expr: &Expr) -> bool {
        use ExprNode::{Call, Member, Persistent, System, Variable};
        self.any(expr, &|node| {
            matches!(node, Variable(_) | Persistent(_) | System(_) | Call(..) | Member(_))
        })
    }

    /// Calls `f` with an expression and every expression inside it.
    pub(crate) fn each<'a>(&'a self, expr: &'a Expr, f: &mut impl FnMut(&'a Expr)) {
        f(expr);
        match expr.node {
            ExprNode::System(a) | ExprNode::Unary(_, a) | ExprNode::Call(_, Some(a)) => {
                self.each(&self[a], f);
            }
            ExprNode::Binary(_, a, b) => {
                self.each(&self[a], f);
                self.each(&self[b], f);
            }
            ExprNode::Member(path) => self[path].indexes().for_each(|index| self.each(index, f)),
            _ => {}
        }
    }

    /// The variables in an expression and where they stand.
    pub(crate) fn variables(&self, expr: &Expr) -> Vec<(NameId, Span)> {
        let mut found = Vec::new();
        self.each(expr, &mut |part| {
            if let ExprNode::Variable(name) = part.node {
                found.push((name, part.span));
            }
        });
        found
    }
}

impl Path {
    /// The expressions between its brackets.
    pub(crate) fn indexes(&self) -> impl Iterator<Item = &Expr> {
        self.steps.iter().filter_map(|step| match step {
            PathStep::Index(index) => Some(index),
            _ => None,
        })
    }
}
