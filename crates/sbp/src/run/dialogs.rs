//! INPUT: values typed by the operator.

use super::{Context, Stop, fields};
use crate::Value;
use crate::tree::Input;
use kerf_diag::Code;

impl Context<'_> {
    /// Asks for values and puts them into variables.
    pub(super) fn input(&mut self, input: &Input) -> Result<(), Stop> {
        let Input { text, default, variables, .. } = input;
        let text = text.as_ref().map_or(Ok(String::new()), |t| self.eval_text(t))?;
        let prefill = default.as_ref().map_or(Ok(Value::Empty), |d| self.eval(d))?.display();
        let typed = self.values_typed(&self.entry(text, prefill), variables.len())?;
        for (name, value) in variables.iter().zip(self.typed_values(&typed, variables.len())?) {
            self.set_variable(*name, value);
        }
        Ok(())
    }

    /// One variable takes all that was typed; several take fields between commas.
    fn typed_values(&mut self, typed: &str, wanted: usize) -> Result<Vec<Value>, Stop> {
        if wanted <= 1 {
            return Ok(vec![fields::value(typed).typed()]);
        }
        if typed.trim().is_empty() {
            return Err(self.terminated());
        }
        let values: Vec<Value> = fields::split(typed).into_iter().map(Value::typed).collect();
        if values.len() < wanted || values.iter().take(wanted).any(Value::is_blank) {
            let message = format!("expected {wanted} values, got '{typed}'");
            let hint = "type the values with commas between them";
            return Err(self.fail_at(self.span, Code::Terminated, message, hint));
        }
        if values.len() > wanted {
            let message = format!("only the first {wanted} of {} values are used", values.len());
            self.warn(Code::Unusual, message, "");
        }
        Ok(values)
    }
}
