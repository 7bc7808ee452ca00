//! Expressions of G-code in the words of OpenSBP.
//!
//! Angles are degrees there and radians here.

use super::Unkept;
use kerf_gcode::{Expr, Function, Operator, Program};

/// Degrees in a radian, as OpenSBP reads numbers.
const DEGREES: &str = "57.29577951308232";
/// Parameters above this belong to the machine.
const LAST_FREE: f64 = 4999.0;

/// The parameters that tell where the tool is.
const LOCATIONS: std::ops::RangeInclusive<f64> = 5420.0..=5422.0;

fn is_location(number: f64) -> bool {
    LOCATIONS.contains(&number) && number.fract() == 0.0
}

/// Writes the place of an axis, as the file counts: `%(1)` counts from the working zero, whatever FP does.
pub(super) fn location(axis: usize) -> String {
    format!("((%({}) - %({})) / %({}))", axis + 1, axis + 61, axis + 66)
}

/// Calls a function with every expression within another, itself first.
pub(super) fn each(expr: &Expr, found: &mut dyn FnMut(&Expr)) {
    found(expr);
    match expr {
        Expr::Number(_) | Expr::Named(_) | Expr::Exists(_) => {}
        Expr::Numbered(a) | Expr::Call(_, a) => each(a, found),
        Expr::Atan(a, b) | Expr::Binary(_, a, b) => {
            each(a, found);
            each(b, found);
        }
    }
}

/// The parameter of an expression `#n`.
pub(super) fn number_of(expr: &Expr) -> Option<f64> {
    match expr {
        Expr::Numbered(number) => match **number {
            Expr::Number(n) => Some(n),
            _ => None,
        },
        _ => None,
    }
}

/// Returns `true` if an expression asks where the tool is.
pub(super) fn asks_location(expr: &Expr) -> bool {
    let mut asks = false;
    each(expr, &mut |part| asks |= number_of(part).is_some_and(is_location));
    asks
}

/// Writes expressions of a line. Parameters of a subroutine carry its name.
#[derive(Clone, Copy)]
pub(super) struct Words<'a> {
    pub(super) program: &'a Program,
    pub(super) line: u32,
    pub(super) sub: Option<&'a str>,
}

impl Words<'_> {
    fn unkept<T>(self, what: impl Into<String>) -> Result<T, Unkept> {
        Err(Unkept::new(self.line, what))
    }

    /// `#n`: those up to 30 belong to the subroutine.
    pub(super) fn numbered(self, number: &Expr) -> Result<String, Unkept> {
        match number {
            Expr::Number(n) if n.fract() == 0.0 && (1.0..=LAST_FREE).contains(n) => {
                Ok(match self.sub.filter(|_| *n <= 30.0) {
                    Some(sub) => format!("&{sub}_p{n}"),
                    None => format!("&p{n}"),
                })
            }
            Expr::Number(n) if is_location(*n) => Ok(location((*n - 5420.0) as usize)),
            Expr::Number(n) => self.unkept(format!("the parameter #{n}")),
            _ => self.unkept("a parameter whose number is computed"),
        }
    }

    /// `#<name>`: names without an underscore before them belong to the subroutine.
    pub(super) fn named(self, index: u32) -> Result<String, Unkept> {
        self.called(self.program.names.get(index as usize).map_or("", |name| name))
    }

    /// The variable of a parameter's name.
    pub(super) fn called(self, name: &str) -> Result<String, Unkept> {
        let plain = name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
        if name.is_empty() || !plain {
            return self.unkept(format!("the parameter #<{name}>"));
        }
        Ok(match (name.strip_prefix('_'), self.sub) {
            (Some(global), _) => format!("&g_{global}"),
            (None, Some(sub)) => format!("&{sub}_v_{name}"),
            (None, None) => format!("&v_{name}"),
        })
    }

    /// A value.
    pub(super) fn value(self, expr: &Expr) -> Result<String, Unkept> {
        Ok(match expr {
            Expr::Number(n) => format!("{n}"),
            Expr::Numbered(number) => self.numbered(number)?,
            Expr::Named(index) => self.named(*index)?,
            Expr::Exists(_) => return self.unkept("EXISTS"),
            Expr::Atan(..) => return self.unkept("ATAN"),
            Expr::Call(Function::Negate, x) if matches!(**x, Expr::Number(_)) => {
                format!("-{}", self.value(x)?)
            }
            Expr::Call(function, x) => self.call(*function, &self.value(x)?)?,
            Expr::Binary(operator, a, b) => {
                let (a, b) = (self.operand(a)?, self.operand(b)?);
                match operator {
                    Operator::Power => format!("({a} ^ {b})"),
                    Operator::Times => format!("({a} * {b})"),
                    Operator::Over => format!("({a} / {b})"),
                    Operator::Mod => format!("({a} - ABS({b}) * INT({a} / ABS({b})))"),
                    Operator::Plus => format!("({a} + {b})"),
                    Operator::Minus => format!("({a} - {b})"),
                    _ => return self.unkept("a comparison as a number"),
                }
            }
        })
    }

    /// A value beside an operator: `-3 ^ 2` is −9 in OpenSBP and 9 in G-code.
    fn operand(self, expr: &Expr) -> Result<String, Unkept> {
        let text = self.value(expr)?;
        Ok(if text.starts_with('-') { format!("({text})") } else { text })
    }

    /// A value that stands alone, without the parentheses around it.
    pub(super) fn alone(self, expr: &Expr) -> Result<String, Unkept> {
        let text = self.value(expr)?;
        let inner = match expr {
            Expr::Binary(..) => text.strip_prefix('(').and_then(|t| t.strip_suffix(')')),
            _ => None,
        };
        Ok(inner.map_or_else(|| text.clone(), str::to_owned))
    }

    fn call(self, function: Function, x: &str) -> Result<String, Unkept> {
        Ok(match function {
            Function::Negate => format!("(0 - {x})"),
            Function::Abs => format!("ABS({x})"),
            Function::Sqrt => format!("SQR({x})"),
            Function::Exp => format!("EXP({x})"),
            Function::Ln => format!("LOG({x})"),
            Function::Fix => format!("INT({x})"),
            Function::Fup => format!("(0 - INT(0 - {x}))"),
            Function::Sin => format!("SIN({x} / {DEGREES})"),
            Function::Cos => format!("COS({x} / {DEGREES})"),
            Function::Tan => format!("TAN({x} / {DEGREES})"),
            Function::Round | Function::Acos | Function::Asin => {
                return self.unkept("ROUND, ACOS or ASIN");
            }
        })
    }

    /// A condition; with `holds` false its contrary.
    pub(super) fn condition(self, expr: &Expr, holds: bool) -> Result<String, Unkept> {
        let Expr::Binary(operator, a, b) = expr else {
            let sign = if holds { "<>" } else { "=" };
            return Ok(format!("({} {sign} 0)", self.value(expr)?));
        };
        let signs = match operator {
            Operator::Eq => ["=", "<>"],
            Operator::Ne => ["<>", "="],
            Operator::Gt => [">", "<="],
            Operator::Ge => [">=", "<"],
            Operator::Lt => ["<", ">="],
            Operator::Le => ["<=", ">"],
            Operator::And | Operator::Or => {
                // De Morgan: the contrary of both is either contrary.
                let word = if (*operator == Operator::And) == holds { "AND" } else { "OR" };
                let (a, b) = (self.condition(a, holds)?, self.condition(b, holds)?);
                return Ok(format!("({a} {word} {b})"));
            }
            _ => ["<>", "="],
        };
        let sign = signs[usize::from(!holds)];
        if matches!(
            operator,
            Operator::Eq | Operator::Ne | Operator::Gt | Operator::Ge | Operator::Lt | Operator::Le
        ) {
            return Ok(format!("({} {sign} {})", self.value(a)?, self.value(b)?));
        }
        Ok(format!("({} {sign} 0)", self.value(expr)?))
    }
}
