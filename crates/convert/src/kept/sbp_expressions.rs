//! Expressions of OpenSBP in the words of LinuxCNC.
//!
//! Angles are radians there and degrees here; true is −1 there and 1 here, so conditions and numbers
//! are written apart.

use super::Unkept;
use kerf_sbp::tree::Program;
use kerf_sbp::{BinaryOp, Expr, ExprNode, Function, UnaryOp};

/// Degrees in a radian, with all digits that a number holds.
const DEGREES: &str = "57.29577951308232";

/// Writes expressions of a line.
#[derive(Clone, Copy)]
pub(super) struct Words<'a> {
    pub(super) program: &'a Program,
    pub(super) line: u32,
}

impl Words<'_> {
    fn unkept<T>(self, what: impl Into<String>) -> Result<T, Unkept> {
        Err(Unkept::new(self.line, what))
    }

    /// The name of a variable. LinuxCNC has names of its own that begin with an underscore.
    pub(super) fn variable(self, name: kerf_sbp::tree::NameId) -> String {
        let name = self.program.names.get(name.0 as usize).map_or("", |name| name);
        format!("#<_v_{}>", name.to_lowercase())
    }

    /// A value behind a letter, or anywhere an operand may stand.
    pub(super) fn value(self, expr: &Expr) -> Result<String, Unkept> {
        let operand = |id| self.value(&self.program.expressions[id]);
        Ok(match expr.node {
            ExprNode::Number(n) => format!("{n}"),
            ExprNode::Variable(name) => self.variable(name),
            ExprNode::System(number) => self.system(&self.program.expressions[number])?,
            ExprNode::Unary(UnaryOp::Plus, id) => operand(id)?,
            ExprNode::Unary(UnaryOp::Minus, id) => match self.program.expressions[id].node {
                ExprNode::Number(n) => format!("{}", -n),
                _ => format!("[0 - {}]", operand(id)?),
            },
            ExprNode::Binary(op, a, b) => {
                let word = match op {
                    BinaryOp::Power => "**",
                    BinaryOp::Multiply => "*",
                    BinaryOp::Divide => "/",
                    BinaryOp::Add => "+",
                    BinaryOp::Subtract => "-",
                    _ => return self.unkept(format!("{} as a number", op.symbol())),
                };
                format!("[{} {word} {}]", operand(a)?, operand(b)?)
            }
            ExprNode::Call(function, Some(id)) => self.call(function, &operand(id)?)?,
            ExprNode::Text(_) | ExprNode::Word(_) => return self.unkept("text"),
            ExprNode::Persistent(_) => return self.unkept("a value that survives ($)"),
            ExprNode::Unary(UnaryOp::Not, _) => return self.unkept("NOT as a number"),
            ExprNode::Call(Function::Pi, None) => std::f64::consts::PI.to_string(),
            ExprNode::Call(function, None) => return self.unkept(function.name()),
            ExprNode::Member(_) => return self.unkept("a value within a value"),
        })
    }

    fn call(self, function: Function, x: &str) -> Result<String, Unkept> {
        Ok(match function {
            Function::Sqr | Function::Sqrt => format!("SQRT[{x}]"),
            Function::Abs => format!("ABS[{x}]"),
            Function::Int | Function::Floor => format!("FIX[{x}]"),
            Function::Ceil => format!("FUP[{x}]"),
            Function::Round => format!("ROUND[{x}]"),
            Function::Exp => format!("EXP[{x}]"),
            Function::Log => format!("LN[{x}]"),
            Function::Sin => format!("SIN[{x} * {DEGREES}]"),
            Function::Cos => format!("COS[{x} * {DEGREES}]"),
            Function::Tan => format!("TAN[{x} * {DEGREES}]"),
            Function::Atn | Function::Atan => format!("[ATAN[{x}]/[1] / {DEGREES}]"),
            Function::Asin => format!("[ASIN[{x}] / {DEGREES}]"),
            Function::Acos => format!("[ACOS[{x}] / {DEGREES}]"),
            Function::Fix | Function::Sgn | Function::Rnd | Function::Pi => {
                return self.unkept(function.name());
            }
        })
    }

    /// The locations of the axes are the only system variables that both languages have.
    fn system(self, number: &Expr) -> Result<String, Unkept> {
        match number.node {
            ExprNode::Number(n) if (1.0..=3.0).contains(&n) && n.fract() == 0.0 => {
                Ok(format!("#{}", 5419.0 + n))
            }
            ExprNode::Number(n) => self.unkept(format!("the system variable %({n})")),
            _ => self.unkept("a system variable by number"),
        }
    }

    /// A condition, in brackets.
    pub(super) fn condition(self, expr: &Expr) -> Result<String, Unkept> {
        let part = |id| self.condition(&self.program.expressions[id]);
        let value = |id| self.value(&self.program.expressions[id]);
        if let ExprNode::Binary(op, a, b) = expr.node {
            if let Some(word) = comparison(op) {
                return Ok(format!("[{} {word} {}]", value(a)?, value(b)?));
            }
            match op {
                BinaryOp::And => return Ok(format!("[{} AND {}]", part(a)?, part(b)?)),
                BinaryOp::Or => return Ok(format!("[{} OR {}]", part(a)?, part(b)?)),
                _ => {}
            }
        }
        match expr.node {
            ExprNode::Unary(UnaryOp::Not, id) => Ok(format!("[{} EQ 0]", part(id)?)),
            _ => Ok(format!("[{} NE 0]", self.value(expr)?)),
        }
    }

    /// The contrary of a condition, in brackets.
    pub(super) fn contrary(self, expr: &Expr) -> Result<String, Unkept> {
        if let ExprNode::Binary(op, a, b) = expr.node
            && let Some(word) = opposite(op).and_then(comparison)
        {
            let value = |id| self.value(&self.program.expressions[id]);
            return Ok(format!("[{} {word} {}]", value(a)?, value(b)?));
        }
        Ok(format!("[{} EQ 0]", self.condition(expr)?))
    }

    /// Returns the value of a condition that asks for the unit, for a file in a unit (0 inches, 1 mm);
    /// nothing for other conditions: the converted file says its unit itself.
    pub(super) fn of_unit(self, expr: &Expr, unit: f64) -> Option<bool> {
        let ExprNode::Binary(op, a, b) = expr.node else { return None };
        let [a, b] = [a, b].map(|id| self.program.expressions[id]);
        let is_unit = |e: &Expr| match e.node {
            ExprNode::System(n) => self.program.expressions[n].node == ExprNode::Number(25.0),
            _ => false,
        };
        let number = match (a.node, b.node) {
            (_, ExprNode::Number(n)) if is_unit(&a) => n,
            (ExprNode::Number(n), _) if is_unit(&b) => n,
            _ => return None,
        };
        match op {
            BinaryOp::Equal => Some(number == unit),
            BinaryOp::NotEqual => Some(number != unit),
            _ => None,
        }
    }
}

const fn comparison(op: BinaryOp) -> Option<&'static str> {
    Some(match op {
        BinaryOp::Equal => "EQ",
        BinaryOp::NotEqual => "NE",
        BinaryOp::Less => "LT",
        BinaryOp::LessEqual => "LE",
        BinaryOp::Greater => "GT",
        BinaryOp::GreaterEqual => "GE",
        _ => return None,
    })
}

const fn opposite(op: BinaryOp) -> Option<BinaryOp> {
    Some(match op {
        BinaryOp::Equal => BinaryOp::NotEqual,
        BinaryOp::NotEqual => BinaryOp::Equal,
        BinaryOp::Less => BinaryOp::GreaterEqual,
        BinaryOp::LessEqual => BinaryOp::Greater,
        BinaryOp::Greater => BinaryOp::LessEqual,
        BinaryOp::GreaterEqual => BinaryOp::Less,
        _ => return None,
    })
}
