//! Entries of a form, checked field by field.

use crate::Folders;
use crate::field::{Field, INCH_MM, Kind};
use std::collections::BTreeMap;

/// Mistake in a field.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mistake {
    /// The field; empty when it is none of them alone.
    pub field: String,
    /// Description of the mistake, and what helps.
    pub text: String,
}

impl Mistake {
    /// Tells what is wrong with a field.
    pub fn new(field: &str, text: impl Into<String>) -> Self {
        Self { field: field.into(), text: text.into() }
    }
}

/// Entries of a form. Every field has a value that its kind allows.
pub struct Entries<'a> {
    values: BTreeMap<&'static str, String>,
    metric: bool,
    folders: &'a dyn Folders,
}

impl<'a> Entries<'a> {
    /// Checks what was entered; fields that were not keep their defaults.
    pub(crate) fn new(
        fields: &'static [Field],
        entered: &[(String, String)],
        metric: bool,
        folders: &'a dyn Folders,
    ) -> Result<Self, Vec<Mistake>> {
        let mut mistakes = Vec::new();
        for (key, _) in entered {
            if !fields.iter().any(|field| field.key.eq_ignore_ascii_case(key)) {
                let keys: Vec<_> = fields.iter().map(|field| field.key).collect();
                let text = format!("there is no such field; there are {}", keys.join(", "));
                mistakes.push(Mistake::new(key, text));
            }
        }
        let given = |field: &Field| {
            let same = |(key, _): &&(String, String)| field.key.eq_ignore_ascii_case(key);
            entered.iter().rev().find(same).map(|(_, value)| value.trim())
        };
        let metric = match fields.iter().find(|field| field.key == "units").and_then(given) {
            Some(unit) if unit.eq_ignore_ascii_case("mm") => true,
            Some(unit) if unit.eq_ignore_ascii_case("in") => false,
            _ => metric,
        };
        let mut values = BTreeMap::new();
        for field in fields {
            let value = given(field).filter(|value| !value.is_empty());
            let value = value.map_or_else(|| field.shown_default(metric), str::to_owned);
            match read_value(field, &value) {
                Ok(value) => drop(values.insert(field.key, value)),
                Err(wanted) => {
                    let text = format!("{wanted}, not '{value}'");
                    mistakes.push(Mistake::new(field.key, text));
                }
            }
        }
        let entries = Self { values, metric, folders };
        if mistakes.is_empty() { Ok(entries) } else { Err(mistakes) }
    }

    /// Returns `true` if lengths are millimetres.
    pub fn metric(&self) -> bool {
        self.metric
    }

    /// A length of so many inches in the unit of the form.
    pub fn inches(&self, inches: f64) -> f64 {
        if self.metric { inches * INCH_MM } else { inches }
    }

    /// Returns the text of a field.
    pub fn text(&self, key: &str) -> &str {
        self.values.get(key).map_or("", String::as_str)
    }

    /// The number in a field.
    pub fn number(&self, key: &str) -> f64 {
        self.text(key).parse().unwrap_or_default()
    }

    /// Returns `true` if a choice is this word.
    pub fn is(&self, key: &str, word: &str) -> bool {
        self.text(key) == word
    }

    /// The text of a file in the part folder.
    pub fn file(&self, name: &str) -> Option<String> {
        self.folders.text(name)
    }

    /// The file of an installed font.
    ///
    /// # Errors
    /// There is none, and which there are.
    pub fn font(&self, name: &str) -> Result<Vec<u8>, String> {
        self.folders.font(name)
    }
}

/// A value as it is used, or what is wanted.
fn read_value(field: &Field, value: &str) -> Result<String, String> {
    let number = || value.parse::<f64>().ok().filter(|n| n.is_finite());
    match field.kind {
        Kind::Text | Kind::File => Ok(value.to_owned()),
        Kind::Length(least) => match number().filter(|n| *n >= least) {
            Some(_) => Ok(value.to_owned()),
            None if least == f64::NEG_INFINITY => Err("a length".into()),
            None => Err(format!("a length of at least {least}")),
        },
        Kind::Number(least, most) => {
            let fits = number().filter(|n| (least..=most).contains(n));
            fits.map(|_| value.to_owned()).ok_or_else(|| format!("a number, {least} to {most}"))
        }
        Kind::Whole(least, most) => {
            let fits = value.parse::<u32>().ok().filter(|n| (least..=most).contains(n));
            fits.map(|n| n.to_string()).ok_or_else(|| format!("a whole number, {least} to {most}"))
        }
        Kind::Choice(words) => {
            let same = |word: &&&str| word.eq_ignore_ascii_case(value);
            let found = words.iter().find(same).map(|word| (*word).to_owned());
            found.ok_or_else(|| format!("one of {}", words.join(", ")))
        }
    }
}
