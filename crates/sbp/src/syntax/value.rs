//! The values that a variable can hold.

use crate::syntax::format_number;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// A value: typeless to the program, a number or text as needed.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub enum Value {
    /// Nothing: an unassigned system variable, an empty assignment.
    #[default]
    Empty,
    /// A number.
    Number(f64),
    /// Text.
    Text(Arc<str>),
    /// Text that the operator typed: where a number is needed, arithmetic in it is calculated.
    Typed(Arc<str>),
}

impl Value {
    /// −1 for true and 0 for false, as in BASIC.
    pub const fn truth(b: bool) -> Self {
        Self::Number(if b { -1.0 } else { 0.0 })
    }

    /// Text from anything that becomes a string.
    pub fn text(text: impl AsRef<str>) -> Self {
        Self::Text(Arc::from(text.as_ref()))
    }

    /// As a number: a number itself, or text that spells one.
    pub fn number(&self) -> Option<f64> {
        match self {
            Self::Empty => None,
            Self::Number(n) => Some(*n),
            Self::Text(t) | Self::Typed(t) => parse_number(t),
        }
    }

    /// Its text, where it is text.
    pub(crate) const fn as_text(&self) -> Option<&Arc<str>> {
        match self {
            Self::Text(t) | Self::Typed(t) => Some(t),
            Self::Empty | Self::Number(_) => None,
        }
    }

    /// The same as typed by the operator.
    pub(crate) fn typed(self) -> Self {
        match self {
            Self::Text(t) => Self::Typed(t),
            other => other,
        }
    }

    /// As text: numbers in their shortest form with 7 significant digits.
    pub fn display(&self) -> String {
        match self {
            Self::Empty => String::new(),
            Self::Number(n) => format_number(*n),
            Self::Text(t) | Self::Typed(t) => t.to_string(),
        }
    }

    /// True for nothing and for empty text.
    pub fn is_blank(&self) -> bool {
        matches!(self, Self::Empty) || self.as_text().is_some_and(|text| text.is_empty())
    }

    /// As it is kept in a variable: numbers are rounded to single precision.
    #[must_use]
    pub fn stored(self) -> Self {
        match self {
            Self::Number(n) => Self::Number(single(n)),
            other => other,
        }
    }
}

/// Rounded to single precision where that has a finite result.
pub(crate) fn single(n: f64) -> f64 {
    let narrow = f64::from(n as f32);
    if narrow.is_finite() { narrow } else { n }
}

/// Reads text that is one plain decimal number, blanks around it allowed.
pub(crate) fn parse_number(text: &str) -> Option<f64> {
    let text = text.trim();
    let digits = text.trim_start_matches(['+', '-']);
    // Words that float parsers know (inf, nan) are text here.
    if !digits.starts_with(|c: char| c.is_ascii_digit() || c == '.') {
        return None;
    }
    text.strip_prefix('+').unwrap_or(text).parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_that_spells_a_number_is_one() {
        for (text, number) in
            [(" 2 ", Some(2.0)), (".5", Some(0.5)), ("-0.", Some(0.0)), ("+3", Some(3.0))]
        {
            assert_eq!(Value::text(text).number(), number, "{text}");
        }
        for text in ["", "abc", "3+4", "inf", "nan", "1 2", "--1"] {
            assert_eq!(Value::text(text).number(), None, "{text}");
        }
    }

    #[test]
    fn variables_hold_single_precision() {
        assert_eq!(Value::Number(16_777_217.0).stored().display(), "16777216");
        assert_eq!(Value::Number(1.0 / 3.0).stored().display(), "0.3333333");
    }
}
