//! Text that is arithmetic: the operator types `3/4` or `12+11/16`, and a number is needed.

use crate::syntax::Expressions;
use crate::syntax::Value;
use crate::syntax::expr::{BinaryOp, Expr, ExprNode, UnaryOp};

use crate::syntax::tree::{Assigned, Node, Statement};

/// Longest text that is calculated, bytes.
const LONGEST: usize = 200;

/// The result of text that consists of numbers, operators and parentheses; nothing for any other text, and where the
/// result is not finite.
///
/// Precedence is that of expressions in a part file: `-2 + 7/32` is minus two, plus seven thirty-seconds.
pub(crate) fn calculate(text: &str) -> Option<f64> {
    let calculates = |c: char| c.is_ascii_digit() || ". \t+-*/\\^()".contains(c);
    if text.len() > LONGEST || !text.chars().all(calculates) {
        return None;
    }
    let program = crate::syntax::read("typed".into(), format!("&A={text}").into_bytes());
    let Node::Statement(at) = program.lines.first()?.node else { return None };
    match program.statements.get(at as usize)? {
        Statement::Assign { value: Assigned::Expr(expr), .. } if program.diagnostics.is_empty() => {
            fold(&program.expressions, expr).filter(|n| n.is_finite())
        }
        _ => None,
    }
}

fn fold(operands: &Expressions, expr: &Expr) -> Option<f64> {
    match expr.node {
        ExprNode::Number(n) => Some(n),
        ExprNode::Unary(UnaryOp::Minus, a) => Some(-fold(operands, &operands[a])?),
        ExprNode::Unary(UnaryOp::Plus, a) => fold(operands, &operands[a]),
        ExprNode::Binary(op, a, b) => {
            operate(op, fold(operands, &operands[a])?, fold(operands, &operands[b])?)
        }
        _ => None,
    }
}

/// The result of an arithmetic operator on two numbers; nothing where the divisor is 0 or the operator is none of
/// arithmetic.
pub(crate) fn operate(op: BinaryOp, a: f64, b: f64) -> Option<f64> {
    // BASIC rounds both operands of \ and MOD to whole numbers first.
    let (whole_a, whole_b) = (a.round_ties_even(), b.round_ties_even());
    match op {
        BinaryOp::Power => Some(a.powf(b)),
        BinaryOp::Multiply => Some(a * b),
        BinaryOp::Divide => (b != 0.0).then(|| a / b),
        BinaryOp::IntegerDivide => (whole_b != 0.0).then(|| (whole_a / whole_b).trunc()),
        BinaryOp::Modulo => (whole_b != 0.0).then(|| whole_a % whole_b),
        BinaryOp::Add => Some(a + b),
        BinaryOp::Subtract => Some(a - b),
        _ => None,
    }
}

impl Value {
    /// As a number where one is needed: also what was typed, where it is arithmetic, as `3/4`.
    pub(crate) fn calculated(&self) -> Option<f64> {
        let typed = || {
            if let Self::Typed(t) = self { calculate(t) } else { None }
        };
        self.number().or_else(typed)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arithmetic_is_calculated_and_other_text_is_not() {
        for (text, number) in [
            ("3/4", Some(0.75)),
            (" 12+11/16 ", Some(12.6875)),
            ("-(2+7/32)", Some(-2.21875)),
            ("2^3*.5", Some(4.0)),
            ("7\\2", Some(3.0)),
            ("-5", Some(-5.0)),
            ("3/0", None),
            ("3/4 ply", None),
            ("1/4/", None),
            ("&a+1", None),
            ("SIN(1)", None),
            ("", None),
            ("(1", None),
        ] {
            assert_eq!(calculate(text), number, "{text}");
        }
        assert_eq!(calculate(&"1+".repeat(200)), None);
    }
}
