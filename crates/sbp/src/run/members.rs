//! Arrays and objects of FabMo's dialect: families of variables.
//!
//! `&t[2].x` is the variable `T[2].X`, found by its name when it is used. So everything that holds for
//! variables (kept to the end of the session, saved, listed) holds for the parts of an object.

use super::eval::{number_or_text, persistent_key};
use super::{Context, Stop, eval};
use crate::Value;
use crate::syntax::expr::{Path, PathStep};
use crate::tree::{Assigned, Span};
use kerf_diag::Code;
use kerf_program::settings::{LinearUnit, MM_PER_INCH};

/// Indices that `[in]` and `[mm]` stand for.
const UNITS: [(&str, &str); 2] = [("IN", "0"), ("MM", "1")];

/// The value of a part of an array or object.
pub(crate) fn member(c: &mut Context<'_>, path: &Path, span: Span) -> Result<Value, Stop> {
    if path.steps.contains(&PathStep::BothUnits) {
        let hint = "read one of them: [0] for inches, [1] for millimetres";
        let message = "[] gives two values at once, which only an assignment can take";
        return Err(c.fail_at(span, Code::BadArithmetic, message, hint));
    }
    let name = member_name(c, path, "")?;
    Ok(named(c, path.persistent, &name).unwrap_or_default())
}

/// `&a[1].x = value`; `[]` keeps the value in both units.
pub(super) fn assign_member(
    c: &mut Context<'_>,
    path: &Path,
    only_new: bool,
    value: &Assigned,
) -> Result<(), Stop> {
    let value = eval::assigned_value(c, value)?;
    if path.persistent {
        c.settle()?;
    }
    if !path.steps.contains(&PathStep::BothUnits) {
        let name = member_name(c, path, "")?;
        keep_named(c, path.persistent, only_new, &name, value);
        return Ok(());
    }
    for (unit, index) in [(LinearUnit::Inch, "0"), (LinearUnit::Mm, "1")] {
        let name = member_name(c, path, index)?;
        let value = in_unit(c, &value, unit);
        keep_named(c, path.persistent, only_new, &name, value);
    }
    Ok(())
}

/// A length of the unit in force in another unit; what is no number stays.
fn in_unit(c: &Context<'_>, value: &Value, unit: LinearUnit) -> Value {
    let present = c.settings().linear_unit;
    match value.number() {
        Some(n) if present == unit => Value::Number(n),
        Some(n) if unit == LinearUnit::Mm => Value::Number(n * MM_PER_INCH),
        Some(n) => Value::Number(n / MM_PER_INCH),
        None => value.clone(),
    }
}

fn named(c: &mut Context<'_>, persistent: bool, name: &str) -> Option<Value> {
    if persistent {
        return c.host.stored(&persistent_key(name)).map(|text| number_or_text(&text));
    }
    c.core.memory.variables.get(name).cloned()
}

fn keep_named(c: &mut Context<'_>, persistent: bool, only_new: bool, name: &str, value: Value) {
    if only_new && named(c, persistent, name).is_some() {
        return;
    }
    if persistent {
        c.host.store(&persistent_key(name), Some(&value.stored().display()));
    } else {
        c.core.memory.variables.set(name, value);
    }
}

/// The name in capitals that a path comes to; `both` stands for `[]`.
fn member_name(c: &mut Context<'_>, path: &Path, both: &str) -> Result<String, Stop> {
    let mut name = eval::name_text(c, path.name);
    for step in &path.steps {
        match step {
            PathStep::Field(field) => name.push_str(&format!(".{field}")),
            PathStep::BothUnits => name.push_str(&format!("[{both}]")),
            PathStep::Index(index) => {
                let value = eval::eval_given(c, index)?.display().to_uppercase();
                let unit = UNITS.iter().find(|(word, _)| *word == value).map(|unit| unit.1);
                name.push_str(&format!("[{}]", unit.unwrap_or(&value)));
            }
        }
    }
    Ok(name)
}
