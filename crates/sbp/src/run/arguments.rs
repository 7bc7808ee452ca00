//! Checked and converted arguments of a command.

use super::{Context, Stop, eval};
use crate::table::{Bound, CommandSpec, Default as Blank, Kind, ParamSpec, Unit};
use crate::tree::{Arg, ArgKind, Span};
use crate::{Value, format_number};
use kerf_diag::Code;
use kerf_program::Axis;
use kerf_program::settings::MM_PER_INCH;
use std::sync::Arc;

/// The arguments of a command by position, defaults filled in, numbers in internal units.
#[derive(Debug)]
pub struct Arguments<'a> {
    values: Vec<Option<Value>>,
    params: &'static [ParamSpec],
    /// Arguments that the line gives.
    args: &'a [Arg],
    /// The command itself, where the line gives nothing.
    command: Span,
}

impl<'a> Arguments<'a> {
    /// Evaluates and checks what a line gives.
    pub(crate) fn evaluate(
        context: &mut Context<'_>,
        spec: &CommandSpec,
        args: &'a [Arg],
    ) -> Result<Self, Stop> {
        let mut values = Vec::with_capacity(spec.params.len());
        for (index, param) in spec.params.iter().enumerate() {
            let arg = args.get(index);
            let span = arg.map_or(context.span, |a| a.span);
            values.push(argument(context, param, arg, span)?);
        }
        Ok(Self { values, params: spec.params, args, command: context.span })
    }

    /// Returns `true` if the parameter has a value: given or by default.
    pub fn given(&self, index: usize) -> bool {
        self.value(index).is_some()
    }

    /// A number in internal units.
    pub fn number(&self, index: usize) -> Option<f64> {
        self.value(index).and_then(Value::number)
    }

    /// A number that has a default or is required.
    pub fn number_or(&self, index: usize, default: f64) -> f64 {
        self.number(index).unwrap_or(default)
    }

    /// A whole number.
    pub fn whole(&self, index: usize) -> Option<i64> {
        self.number(index).map(|n| n as i64)
    }

    /// 1 or 0 as true or false.
    pub fn flag(&self, index: usize) -> Option<bool> {
        self.number(index).map(|n| n != 0.0)
    }

    /// Text.
    pub fn text(&self, index: usize) -> Option<Arc<str>> {
        let value = self.value(index)?;
        Some(value.as_text().cloned().unwrap_or_else(|| value.display().into()))
    }

    /// An axis.
    pub fn axis(&self, index: usize) -> Option<Axis> {
        self.text(index)?.chars().next().and_then(Axis::from_letter)
    }

    /// The value itself.
    pub fn value(&self, index: usize) -> Option<&Value> {
        self.values.get(index)?.as_ref()
    }

    /// Returns the place of the argument, or of the command where the line does not give it.
    pub fn span(&self, index: usize) -> Span {
        self.args.get(index).map_or(self.command, |arg| arg.span)
    }

    /// The parameters of the command.
    pub const fn params(&self) -> &'static [ParamSpec] {
        self.params
    }

    /// Returns the number of parameters.
    pub fn len(&self) -> usize {
        self.values.len()
    }
}

fn argument(
    c: &mut Context<'_>,
    param: &ParamSpec,
    arg: Option<&Arg>,
    span: Span,
) -> Result<Option<Value>, Stop> {
    let value = match arg.map(|a| &a.kind) {
        None | Some(ArgKind::Blank) => None,
        Some(ArgKind::Word(word)) => Some(Value::Text(word.clone())),
        Some(ArgKind::Expr(expr)) => Some(eval::eval_given(c, expr)?),
    };
    // A text argument that is empty ("") counts as blank, as post-processors write VS,"","",1.
    match value.filter(|v| !v.is_blank()) {
        None => blank(c, param, span),
        Some(value) => given(c, param, value, span).map(Some),
    }
}

fn blank(c: &Context<'_>, param: &ParamSpec, span: Span) -> Result<Option<Value>, Stop> {
    match param.default {
        Blank::Required => {
            let message = format!("{} expected", param.name.to_lowercase());
            Err(c.fail_at(span, Code::MissingParameter, message, "this value has no default"))
        }
        Blank::Keep | Blank::Special | Blank::Demanded => Ok(None),
        Blank::Number(n) => Ok(Some(Value::Number(n * param.kind.unit().scale(c.settings())))),
        Blank::Word(word) => Ok(Some(Value::text(word))),
    }
}

fn given(c: &Context<'_>, param: &ParamSpec, value: Value, span: Span) -> Result<Value, Stop> {
    match param.kind {
        Kind::Number(_) => number(c, param, &value, span),
        Kind::NumberOrOff(_) if value.display().eq_ignore_ascii_case("off") => {
            Ok(Value::text("OFF"))
        }
        Kind::NumberOrOff(_) => number(c, param, &value, span),
        Kind::Whole => whole(c, param, &value, span),
        Kind::OneOf(list) => {
            let n = plain(c, param, &value, span)?;
            let found = list.iter().any(|v| f64::from(*v) == n);
            found.then_some(Value::Number(n)).ok_or_else(|| {
                let choices: Vec<_> = list.iter().map(ToString::to_string).collect();
                out_of_range(c, param, &value, span, &format!("one of {}", choices.join(", ")))
            })
        }
        Kind::Word(list) => {
            let text = value.display();
            let found = list.iter().find(|w| w.eq_ignore_ascii_case(text.trim()));
            found.map(|w| Value::text(*w)).ok_or_else(|| {
                out_of_range(c, param, &value, span, &format!("one of {}", list.join(", ")))
            })
        }
        Kind::AxisLetter => {
            let text = value.display();
            let mut letters = text.trim().chars();
            match (letters.next().and_then(Axis::from_letter), letters.next()) {
                (Some(axis), None) => Ok(Value::text(axis.letter().to_string())),
                _ => Err(out_of_range(c, param, &value, span, "one of X, Y, Z, A, B, C")),
            }
        }
        Kind::Text | Kind::File | Kind::Obsolete => Ok(value),
    }
}

fn plain(c: &Context<'_>, param: &ParamSpec, value: &Value, span: Span) -> Result<f64, Stop> {
    let number = value.calculated().filter(|n| n.is_finite());
    number.ok_or_else(|| {
        let message =
            format!("{} must be a number, not '{}'", param.name.to_lowercase(), value.display());
        c.fail_at(
            span,
            Code::NotANumber,
            message,
            "give a number, a variable that holds one, or an expression",
        )
    })
}

fn whole(c: &Context<'_>, param: &ParamSpec, value: &Value, span: Span) -> Result<Value, Stop> {
    let n = plain(c, param, value, span)?;
    if n.fract() != 0.0 {
        return Err(out_of_range(c, param, value, span, "a whole number"));
    }
    check(c, param, n, value, span)?;
    Ok(Value::Number(n))
}

fn number(c: &Context<'_>, param: &ParamSpec, value: &Value, span: Span) -> Result<Value, Stop> {
    let n = plain(c, param, value, span)?;
    check(c, param, n, value, span)?;
    Ok(Value::Number(n * param.kind.unit().scale(c.settings())))
}

/// Bounds of lengths and speeds are given in inches and compared in the user's unit.
fn check(
    c: &Context<'_>,
    param: &ParamSpec,
    n: f64,
    value: &Value,
    span: Span,
) -> Result<(), Stop> {
    let inches = matches!(param.kind.unit(), Unit::Length | Unit::Speed);
    let scale = if inches { MM_PER_INCH / c.settings().linear_unit.mm() } else { 1.0 };
    let shown = |bound: f64| format_number(bound * scale);
    // A hair of slack, so that 1.27 mm is not below .05 in.
    let slack = 1e-9 * scale;
    let (fits, what) = match param.bound {
        Bound::Any => return Ok(()),
        Bound::Positive => (n > 0.0, "greater than 0".to_string()),
        Bound::NotNegative => (n >= 0.0, "0 or greater".to_string()),
        Bound::NotZero => (n != 0.0, "other than 0".to_string()),
        Bound::Range(low, high) => (
            n >= low * scale - slack && n <= high * scale + slack,
            format!("{}-{}", shown(low), shown(high)),
        ),
        Bound::Below(low, high) => (
            n >= low * scale - slack && n < high * scale - slack,
            format!("{0}-{1} and less than {1}", shown(low), shown(high)),
        ),
        Bound::AtLeast(low) => (n >= low * scale - slack, format!("at least {}", shown(low))),
    };
    if fits { Ok(()) } else { Err(out_of_range(c, param, value, span, &what)) }
}

fn out_of_range(c: &Context<'_>, param: &ParamSpec, value: &Value, span: Span, what: &str) -> Stop {
    let name = param.name.to_lowercase();
    let message = format!("{name} must be {what}, not {}", value.display());
    c.fail_at(span, Code::OutOfRange, message, "")
}
