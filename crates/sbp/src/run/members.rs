//! Arrays and objects of FabMo's dialect: families of variables.
//!
//! `&t[2].x` is the variable `T[2].X`, found by its name when it is used. So everything that holds for
//! variables (kept to the end of the session, saved, listed) holds for the parts of an object.

use super::eval::{number_or_text, persistent_key};
use super::{Context, Stop};
use crate::Value;
use crate::syntax::expr::{Path, PathStep};
use crate::tree::{Assigned, Span};
use kerf_diag::Code;
use kerf_program::settings::{LinearUnit, MM_PER_INCH};

/// Indices that `[in]` and `[mm]` stand for.
const UNITS: [(&str, &str); 2] = [("IN", "0"), ("MM", "1")];

impl Context<'_> {
    /// The value of a part of an array or object.
    pub(crate) fn member(&mut self, path: &Path, span: Span) -> Result<Value, Stop> {
        if path.steps.contains(&PathStep::BothUnits) {
            let hint = "read one of them: [0] for inches, [1] for millimetres";
            let message = "[] gives two values at once, which only an assignment can take";
            return Err(self.fail_at(span, Code::BadArithmetic, message, hint));
        }
        let name = self.member_name(path, "")?;
        Ok(self.named(path.persistent, &name).unwrap_or_default())
    }

    /// `&a[1].x = value`; `[]` keeps the value in both units.
    pub(super) fn assign_member(
        &mut self,
        path: &Path,
        only_new: bool,
        value: &Assigned,
    ) -> Result<(), Stop> {
        let value = self.assigned_value(value)?;
        if path.persistent {
            self.settle()?;
        }
        if !path.steps.contains(&PathStep::BothUnits) {
            let name = self.member_name(path, "")?;
            self.keep_named(path.persistent, only_new, &name, value);
            return Ok(());
        }
        for (unit, index) in [(LinearUnit::Inch, "0"), (LinearUnit::Mm, "1")] {
            let name = self.member_name(path, index)?;
            let value = self.in_unit(&value, unit);
            self.keep_named(path.persistent, only_new, &name, value);
        }
        Ok(())
    }

    /// A length of the unit in force in another unit; what is no number stays.
    fn in_unit(&self, value: &Value, unit: LinearUnit) -> Value {
        let present = self.settings().linear_unit;
        match value.number() {
            Some(n) if present == unit => Value::Number(n),
            Some(n) if unit == LinearUnit::Mm => Value::Number(n * MM_PER_INCH),
            Some(n) => Value::Number(n / MM_PER_INCH),
            None => value.clone(),
        }
    }

    fn named(&mut self, persistent: bool, name: &str) -> Option<Value> {
        if persistent {
            return self.host.stored(&persistent_key(name)).map(|text| number_or_text(&text));
        }
        self.core.memory.variables.get(name).cloned()
    }

    fn keep_named(&mut self, persistent: bool, only_new: bool, name: &str, value: Value) {
        if only_new && self.named(persistent, name).is_some() {
            return;
        }
        if persistent {
            self.host.store(&persistent_key(name), Some(&value.stored().display()));
        } else {
            self.core.memory.variables.set(name, value);
        }
    }

    /// The name in capitals that a path comes to; `both` stands for `[]`.
    fn member_name(&mut self, path: &Path, both: &str) -> Result<String, Stop> {
        let mut name = self.name_text(path.name);
        for step in &path.steps {
            match step {
                PathStep::Field(field) => name.push_str(&format!(".{field}")),
                PathStep::BothUnits => name.push_str(&format!("[{both}]")),
                PathStep::Index(index) => {
                    let value = self.eval_given(index)?.display().to_uppercase();
                    let unit = UNITS.iter().find(|(word, _)| *word == value).map(|unit| unit.1);
                    name.push_str(&format!("[{}]", unit.unwrap_or(&value)));
                }
            }
        }
        Ok(name)
    }
}
