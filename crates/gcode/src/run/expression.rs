//! Values of expressions.

use super::parameters::Parameters;
use crate::syntax::expr::{Expr, Operator};
use crate::syntax::gathered::Fault;
use crate::syntax::tree::{Program, Setting, Span, Target};
use kerf_diag::Code;

/// A value on its way into a parameter.
#[derive(Clone, Copy, Debug)]
pub(super) enum Assigned {
    Number(u32, f64),
    Name(u32, f64),
}

/// The value of an expression.
pub(super) fn evaluate(
    parameters: &Parameters<'_>,
    program: &Program,
    expr: &Expr,
    span: Span,
) -> Result<f64, Fault> {
    let value = match expr {
        Expr::Number(n) => *n,
        Expr::Numbered(number) => {
            let n = evaluate(parameters, program, number, span)?;
            parameters.numbered(whole_number(n, span)?, span)?
        }
        Expr::Named(id) => {
            let name = program.names.get(*id as usize).cloned().unwrap_or_default();
            parameters.named(&name).ok_or_else(|| no_value(&name, span))?
        }
        Expr::Exists(id) => {
            let name = program.names.get(*id as usize).cloned().unwrap_or_default();
            f64::from(u8::from(parameters.named(&name).is_some()))
        }
        Expr::Call(function, x) => function.of(evaluate(parameters, program, x, span)?),
        Expr::Atan(y, x) => {
            let (y, x) =
                (evaluate(parameters, program, y, span)?, evaluate(parameters, program, x, span)?);
            y.atan2(x).to_degrees()
        }
        Expr::Binary(operator, a, b) => {
            let (a, b) =
                (evaluate(parameters, program, a, span)?, evaluate(parameters, program, b, span)?);
            if b == 0.0 && matches!(operator, Operator::Over | Operator::Mod) {
                return Err(Fault::new(Code::DivisionByZero, span, "division by zero")
                    .hint("which parameter in it is zero? a parameter that was never set is 0"));
            }
            operator.of(a, b)
        }
    };
    if value.is_finite() {
        return Ok(value);
    }
    Err(Fault::new(Code::BadArithmetic, span, "the calculation has no result")
        .hint("the root of a negative number, a logarithm of zero, or a value far too large"))
}

/// The values of settings: all are worked out before any is set.
pub(super) fn evaluate_settings(
    parameters: &Parameters<'_>,
    program: &Program,
    settings: &[Setting],
) -> Result<Vec<(Assigned, Span)>, Fault> {
    let mut values = Vec::with_capacity(settings.len());
    for Setting { target, value, span } in settings {
        let value = evaluate(parameters, program, value, *span)?;
        let assigned = match target {
            Target::Named(id) => Assigned::Name(*id, value),
            Target::Numbered(number) => {
                let number = evaluate(parameters, program, number, *span)?;
                Assigned::Number(whole_number(number, *span)?, value)
            }
        };
        values.push((assigned, *span));
    }
    Ok(values)
}

fn whole_number(value: f64, span: Span) -> Result<u32, Fault> {
    let rounded = value.round();
    if (value - rounded).abs() < 1e-4 && (0.0..1e6).contains(&rounded) {
        return Ok(rounded as u32);
    }
    let message = format!("the number of a parameter is whole, not {value}");
    Err(Fault::new(Code::BadParameter, span, message))
}

fn no_value(name: &str, span: Span) -> Fault {
    let hint = if name.starts_with("_ini[") || name.starts_with("_hal[") || name.starts_with('/') {
        "values of a controller's own configuration are not there"
    } else {
        "set it before it is used, as in #<depth>=5"
    };
    Fault::new(Code::NoValue, span, format!("#<{name}> has no value")).hint(hint)
}
