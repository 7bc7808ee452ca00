//! INPUT: values typed by the operator.

use super::{Context, Stop, eval, fields, questions};
use crate::Value;
use crate::tree::Input;
use kerf_diag::Code;

/// Asks for values and puts them into variables.
pub(super) fn input(c: &mut Context<'_>, input: &Input) -> Result<(), Stop> {
    let Input { text, default, variables, .. } = input;
    let text = text.as_ref().map_or(Ok(String::new()), |t| eval::eval_text(c, t))?;
    let prefill = default.as_ref().map_or(Ok(Value::Empty), |d| eval::eval(c, d))?.display();
    let typed = questions::values_typed(c, &questions::entry(c, text, prefill), variables.len())?;
    for (name, value) in variables.iter().zip(typed_values(c, &typed, variables.len())?) {
        eval::set_variable(c, *name, value);
    }
    Ok(())
}

/// One variable takes all that was typed; several take fields between commas.
fn typed_values(c: &mut Context<'_>, typed: &str, wanted: usize) -> Result<Vec<Value>, Stop> {
    if wanted <= 1 {
        return Ok(vec![fields::value(typed).typed()]);
    }
    if typed.trim().is_empty() {
        return Err(questions::terminated(c));
    }
    let values: Vec<Value> = fields::split(typed).into_iter().map(Value::typed).collect();
    if values.len() < wanted || values.iter().take(wanted).any(Value::is_blank) {
        let message = format!("expected {wanted} values, got '{typed}'");
        let hint = "type the values with commas between them";
        return Err(c.fail_at(c.span, Code::Terminated, message, hint));
    }
    if values.len() > wanted {
        let message = format!("only the first {wanted} of {} values are used", values.len());
        c.warn(Code::Unusual, message, "");
    }
    Ok(values)
}
