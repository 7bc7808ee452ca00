//! Expressions to values.
//!
//! Arithmetic is double precision; variables hold single precision (command reference: values have
//! 7-8 digits). So that `IF &a = .7` is true after `&a = .7`, comparisons are made in single
//! precision too.

use super::{Context, Stop, members, sysvar};
use crate::Value;
use crate::syntax::Dialect;
use crate::syntax::expr::{BinaryOp, Expr, ExprNode, Function, UnaryOp};
use crate::syntax::operate;
use crate::syntax::value::single;
use crate::tree::{Assigned, NameId, Span};
use kerf_diag::Code;
use std::cmp::Ordering;

/// Texts may have so many bytes: a loop that joins a text to itself must not eat the memory.
const MOST_TEXT: usize = 1_000_000;

/// The value of an expression.
pub(crate) fn eval(c: &mut Context<'_>, expr: &Expr) -> Result<Value, Stop> {
    let operands = &c.program.expressions;
    match &expr.node {
        ExprNode::Number(n) => Ok(Value::Number(*n)),
        ExprNode::Text(t) | ExprNode::Word(t) => Ok(Value::Text(operands[*t].clone())),
        ExprNode::Variable(name) => Ok(variable(c, *name).cloned().unwrap_or_default()),
        ExprNode::Persistent(name) => {
            // Other programs write it too.
            c.core.idling.changes = true;
            Ok(persistent(c, *name))
        }
        ExprNode::System(index) => {
            c.core.idling.changes = true;
            let number = eval_number(c, &operands[*index])?;
            sysvar::system_variable(c, number, expr.span)
        }
        ExprNode::Unary(op, operand) => unary(c, *op, &operands[*operand]),
        ExprNode::Binary(op, left, right) => {
            binary(c, *op, &operands[*left], &operands[*right], expr.span)
        }
        ExprNode::Member(path) => {
            c.core.idling.changes = true;
            members::member(c, &operands[*path], expr.span)
        }
        ExprNode::Call(function, argument) => {
            let argument = argument.map(|id| &operands[id]);
            call(c, *function, argument, expr.span)
        }
    }
}

/// Returns the value of an assignment.
pub(super) fn assigned_value(c: &mut Context<'_>, value: &Assigned) -> Result<Value, Stop> {
    match value {
        Assigned::Nothing => Ok(Value::text("")),
        Assigned::Expr(expr) => eval(c, expr),
        Assigned::Text(text) => Ok(Value::Text(text.clone())),
    }
}

/// The value of an expression as a number.
pub(crate) fn eval_number(c: &mut Context<'_>, expr: &Expr) -> Result<f64, Stop> {
    if let ExprNode::Number(n) = expr.node {
        return Ok(n);
    }
    let value = eval(c, expr)?;
    need_number(c, expr, &value)
}

/// The value of an argument: a variable that was never set is a mistake there; one that was
/// given nothing (`&x=`, or an empty system variable) is a blank.
pub(crate) fn eval_given(c: &mut Context<'_>, expr: &Expr) -> Result<Value, Stop> {
    if let ExprNode::Variable(name) = expr.node
        && variable(c, name).is_none()
    {
        need_number(c, expr, &Value::Empty)?;
    }
    let value = eval(c, expr)?;
    if let (ExprNode::Member(_), Value::Empty) = (expr.node, &value) {
        need_number(c, expr, &value)?;
    }
    Ok(value)
}

/// True unless the expression is 0, empty or empty text.
pub(crate) fn eval_condition(c: &mut Context<'_>, expr: &Expr) -> Result<bool, Stop> {
    let value = eval(c, expr)?;
    Ok(match value {
        Value::Empty => false,
        Value::Number(n) => n != 0.0,
        Value::Text(_) | Value::Typed(_) => need_number(c, expr, &value)? != 0.0,
    })
}

/// Text of an expression for people: an undefined variable shows its own name.
pub(crate) fn eval_text(c: &mut Context<'_>, expr: &Expr) -> Result<String, Stop> {
    match &expr.node {
        ExprNode::Variable(name) if variable(c, *name).is_none() => Ok(spelled(c, expr.span)),
        ExprNode::Binary(BinaryOp::Join, left, right) => {
            let operands = &c.program.expressions;
            joined(c, &operands[*left], &operands[*right], expr.span)
        }
        _ => Ok(eval(c, expr)?.display()),
    }
}

/// Two texts one after the other.
fn joined(c: &mut Context<'_>, left: &Expr, right: &Expr, span: Span) -> Result<String, Stop> {
    let text = eval_text(c, left)? + &eval_text(c, right)?;
    bounded_text(c, text, span)
}

fn bounded_text(c: &Context<'_>, text: String, span: Span) -> Result<String, Stop> {
    if text.len() <= MOST_TEXT {
        return Ok(text);
    }
    let hint = "does a loop join it to itself?";
    Err(c.fail_at(span, Code::OutOfRange, "the text is longer than a million bytes", hint))
}

/// Returns the text of the line at a span.
pub(crate) fn spelled(c: &Context<'_>, span: Span) -> String {
    let line = c.program.line_text(c.at.line);
    line.get(span.start as usize..span.end as usize).unwrap_or("").trim().to_string()
}

/// Slot of a name of the present file.
pub(crate) fn slot(c: &Context<'_>, name: NameId) -> u32 {
    c.core.files.slot(c.at.file, name)
}

/// Value of a user variable.
pub(crate) fn variable<'a>(c: &'a Context<'_>, name: NameId) -> Option<&'a Value> {
    c.core.memory.variables.at(slot(c, name))
}

/// Gives a user variable a value.
pub(crate) fn set_variable(c: &mut Context<'_>, name: NameId, value: Value) {
    let slot = slot(c, name);
    c.core.idling.changes |= c.core.memory.variables.at(slot) != Some(&value);
    c.core.memory.variables.put(slot, value);
}

fn persistent(c: &mut Context<'_>, name: NameId) -> Value {
    let key = persistent_key(&name_text(c, name));
    c.host.stored(&key).map_or(Value::Empty, |text| number_or_text(&text))
}

/// Keeps a persistent variable.
pub(crate) fn set_persistent(c: &mut Context<'_>, name: NameId, value: &Value) {
    let key = persistent_key(&name_text(c, name));
    c.host.store(&key, Some(&value.clone().stored().display()));
}

/// A name of the present file in capitals.
pub(crate) fn name_text(c: &Context<'_>, name: NameId) -> String {
    c.program.names.get(name.0 as usize).map(ToString::to_string).unwrap_or_default()
}

fn need_number(c: &Context<'_>, expr: &Expr, value: &Value) -> Result<f64, Stop> {
    if let Some(n) = value.calculated() {
        return Ok(n);
    }
    Err(match (&expr.node, value) {
        (ExprNode::Variable(name), Value::Empty) => {
            let message = format!("variable &{} has no value", name_text(c, *name));
            c.fail_at(expr.span, Code::UndefinedVariable, message, "assign it before this line")
        }
        (_, Value::Empty) => {
            let message = format!("{} has no value", spelled(c, expr.span));
            c.fail_at(expr.span, Code::UndefinedVariable, message, "")
        }
        (node, _) => {
            let message = format!("'{}' is not a number", value.display());
            let hint = match node {
                ExprNode::Word(word) => {
                    format!("is the variable &{} meant?", c.program.expressions[*word])
                }
                _ => "a number is needed here".into(),
            };
            c.fail_at(expr.span, Code::NotANumber, message, hint)
        }
    })
}

fn unary(c: &mut Context<'_>, op: UnaryOp, operand: &Expr) -> Result<Value, Stop> {
    let n = eval_number(c, operand)?;
    Ok(match op {
        UnaryOp::Minus => Value::Number(-n),
        UnaryOp::Plus => Value::Number(n),
        UnaryOp::Not => Value::Number(bits(n).map_or(0.0, |b| !b as f64)),
    })
}

fn binary(
    c: &mut Context<'_>,
    op: BinaryOp,
    left: &Expr,
    right: &Expr,
    span: Span,
) -> Result<Value, Stop> {
    match op {
        BinaryOp::Join => joined(c, left, right, span).map(Value::text),
        BinaryOp::Equal
        | BinaryOp::NotEqual
        | BinaryOp::Less
        | BinaryOp::LessEqual
        | BinaryOp::Greater
        | BinaryOp::GreaterEqual => compare(c, op, left, right),
        BinaryOp::Add if c.core.options.dialect == Dialect::Fabmo => {
            add_or_join(c, left, right, span)
        }
        _ => {
            let a = eval_number(c, left)?;
            let b = eval_number(c, right)?;
            arithmetic(c, op, a, b, span, right.span)
        }
    }
}

/// FabMo's `+`: the sum of two numbers, or texts one after the other.
fn add_or_join(c: &mut Context<'_>, left: &Expr, right: &Expr, span: Span) -> Result<Value, Stop> {
    let (a, b) = (eval(c, left)?, eval(c, right)?);
    let is_text = |value: &Value| value.as_text().is_some() && value.calculated().is_none();
    if is_text(&a) || is_text(&b) {
        return bounded_text(c, a.display() + &b.display(), span).map(Value::text);
    }
    let (a, b) = (need_number(c, left, &a)?, need_number(c, right, &b)?);
    arithmetic(c, BinaryOp::Add, a, b, span, span)
}

fn arithmetic(
    c: &Context<'_>,
    op: BinaryOp,
    a: f64,
    b: f64,
    span: Span,
    divisor: Span,
) -> Result<Value, Stop> {
    let result = match op {
        BinaryOp::And => Some(join_bits(a, b, |x, y| x & y)),
        BinaryOp::Or => Some(join_bits(a, b, |x, y| x | y)),
        _ => operate(op, a, b),
    };
    let zero =
        || c.fail_at(divisor, Code::DivisionByZero, "division by zero", "the divisor is 0 here");
    finite(c, result.ok_or_else(zero)?, span)
}

fn finite(c: &Context<'_>, n: f64, span: Span) -> Result<Value, Stop> {
    if n.is_finite() {
        return Ok(Value::Number(n));
    }
    let message = "the calculation has no finite result";
    Err(c.fail_at(span, Code::BadArithmetic, message, "look at the values of its variables"))
}

fn compare(c: &mut Context<'_>, op: BinaryOp, left: &Expr, right: &Expr) -> Result<Value, Stop> {
    let a = eval(c, left)?;
    let b = eval(c, right)?;
    let order = match (beside(&a, &b), beside(&b, &a)) {
        (Some(x), Some(y)) => single(x).partial_cmp(&single(y)),
        (number_a, number_b) => {
            if number_a.is_some() != number_b.is_some() && !a.is_blank() && !b.is_blank() {
                warn_text_comparison(c, op, &a, &b);
            }
            Some(a.display().to_uppercase().cmp(&b.display().to_uppercase()))
        }
    };
    let Some(order) = order else { return Ok(Value::truth(false)) };
    Ok(Value::truth(match op {
        BinaryOp::Equal => order == Ordering::Equal,
        BinaryOp::NotEqual => order != Ordering::Equal,
        BinaryOp::Less => order == Ordering::Less,
        BinaryOp::LessEqual => order != Ordering::Greater,
        BinaryOp::Greater => order == Ordering::Greater,
        _ => order != Ordering::Less,
    }))
}

/// A number and a text are compared as text; for < and > that is rarely meant.
fn warn_text_comparison(c: &mut Context<'_>, op: BinaryOp, a: &Value, b: &Value) {
    if !matches!(op, BinaryOp::Equal | BinaryOp::NotEqual) {
        let message = format!("'{}' and '{}' are compared as text", a.display(), b.display());
        c.warn(Code::Unusual, message, "one of them is no number");
    }
}

fn call(
    c: &mut Context<'_>,
    function: Function,
    argument: Option<&Expr>,
    span: Span,
) -> Result<Value, Stop> {
    let n = match argument {
        Some(expr) => eval_number(c, expr)?,
        None => 1.0,
    };
    if let Some((message, hint)) = outside(function, n) {
        return Err(c.fail_at(span, Code::BadArithmetic, message, hint));
    }
    let result = match function {
        Function::Sqr | Function::Sqrt => n.sqrt(),
        Function::Abs => n.abs(),
        Function::Int | Function::Floor => n.floor(),
        Function::Ceil => n.ceil(),
        Function::Round => n.round(),
        Function::Fix => n.trunc(),
        Function::Sgn if n == 0.0 => 0.0,
        Function::Sgn => n.signum(),
        Function::Exp => n.exp(),
        Function::Log => n.ln(),
        Function::Sin => n.sin(),
        Function::Cos => n.cos(),
        Function::Tan => n.tan(),
        Function::Atn | Function::Atan => n.atan(),
        Function::Asin => n.asin(),
        Function::Acos => n.acos(),
        Function::Pi => std::f64::consts::PI,
        Function::Rnd => {
            c.core.idling.changes = true;
            next_random(&mut c.core.memory.random)
        }
    };
    finite(c, result, span)
}

/// A value as a number in a comparison: text that is arithmetic counts beside a number only.
fn beside(value: &Value, other: &Value) -> Option<f64> {
    if matches!(other, Value::Number(_)) { value.calculated() } else { value.number() }
}

/// The message and the hint where a function has no result for a value.
fn outside(function: Function, n: f64) -> Option<(String, &'static str)> {
    let value = Value::Number(n).display();
    match function {
        Function::Sqr | Function::Sqrt if n < 0.0 => {
            Some((format!("no square root of {value}"), "the value must be 0 or greater"))
        }
        Function::Asin | Function::Acos if n.abs() > 1.0 => {
            let name = function.name();
            Some((format!("{name} has no result for {value}"), "the value must be from -1 to 1"))
        }
        _ => None,
    }
}

/// Key under which a persistent variable is stored.
pub(crate) fn persistent_key(name: &str) -> String {
    format!("${name}")
}

/// Stored text as a value: text that spells a number is one.
pub(crate) fn number_or_text(text: &str) -> Value {
    crate::syntax::value::parse_number(text).map_or_else(|| Value::text(text), Value::Number)
}

fn bits(n: f64) -> Option<i64> {
    let whole = n.round_ties_even();
    (whole.abs() < 9e15).then_some(whole as i64)
}

fn join_bits(a: f64, b: f64, f: impl Fn(i64, i64) -> i64) -> f64 {
    match (bits(a), bits(b)) {
        (Some(x), Some(y)) => f(x, y) as f64,
        _ => f64::NAN,
    }
}

/// SplitMix64 (Steele, Lea, Flood 2014), the high 24 bits as a single-precision share of 1.
fn next_random(state: &mut u64) -> f64 {
    *state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
    let mut z = *state;
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    ((z ^ (z >> 31)) >> 40) as f64 / f64::from(1u32 << 24)
}

#[cfg(test)]
mod tests {
    /// The numbers of SplitMix64 from the seed 1234567, as its authors' programs give them.
    #[test]
    fn random_numbers_are_those_of_splitmix64() {
        let mut state = 1_234_567;
        for whole in [6_457_827_717_110_365_317_u64, 3_203_168_211_198_807_973] {
            let share = (whole >> 40) as f64 / 2f64.powi(24);
            assert_eq!(super::next_random(&mut state), share);
        }
    }
}
