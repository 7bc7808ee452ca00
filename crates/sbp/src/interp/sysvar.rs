//! System variables, `%(n)`.

use super::{Context, Stop};
use crate::Value;
use crate::tree::Span;
use kerf_diag::Code;
use kerf_program::Axis;

impl Context<'_> {
    /// The value of a system variable in the user's units.
    pub(crate) fn system_variable(&mut self, number: f64, span: Span) -> Result<Value, Stop> {
        let n = number as i64;
        if number.fract() != 0.0 || !(1..=161).contains(&n) {
            let message = format!("no system variable {}", Value::Number(number).display());
            return Err(self.fail_at(
                span,
                Code::NoSystemVariable,
                message,
                "they are numbered 1 to 161",
            ));
        }
        match n {
            1..=5 => {
                let axis = Axis::ALL[n as usize - 1];
                Ok(Value::Number(self.settings().to_user(self.core.working())[axis]))
            }
            51..=58 => {
                self.settle()?;
                Ok(Value::Number(f64::from(self.host.input((n - 50) as u8))))
            }
            _ => Ok(Value::Empty),
        }
    }
}
