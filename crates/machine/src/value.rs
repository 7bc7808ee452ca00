//! Values of settings, whatever their type: what is read from a file, typed, shown.

use std::fmt;

/// A value as a person writes it.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// `true` or `false`.
    Flag(bool),
    /// A number; whole numbers too.
    Number(f64),
    /// A word or a text; `none` where a value may be absent.
    Text(String),
    /// Several values.
    List(Vec<Value>),
}

/// The word of a value that is absent.
pub const NONE: &str = "none";

impl Value {
    /// Returns the value that stands for an absent one.
    pub fn none() -> Self {
        Self::Text(NONE.into())
    }

    /// Returns `true` if this says that there is no value.
    pub fn is_none(&self) -> bool {
        matches!(self, Self::Text(text) if text.eq_ignore_ascii_case(NONE))
    }

    /// A value as it is typed after `kerf machine set KEY`: a list is separated by commas, quotes
    /// are not needed.
    pub fn typed(text: &str) -> Self {
        let text = text.trim();
        let inner = text.strip_prefix('[').and_then(|rest| rest.strip_suffix(']'));
        if let Some(inner) = inner {
            return Self::List(split(inner));
        }
        if text.contains(',') {
            return Self::List(split(text));
        }
        Self::single(text)
    }

    fn single(text: &str) -> Self {
        let text = text.trim().trim_matches('"');
        match (text.to_ascii_lowercase().as_str(), text.parse()) {
            ("true" | "yes" | "on", _) => Self::Flag(true),
            ("false" | "no" | "off", _) => Self::Flag(false),
            (_, Ok(number)) => Self::Number(number),
            _ => Self::Text(text.into()),
        }
    }
}

fn split(text: &str) -> Vec<Value> {
    if text.trim().is_empty() {
        return Vec::new();
    }
    text.split(',').map(Value::single).collect()
}

/// From here on not every whole number is a number of its own.
const LARGE: f64 = 9e15;

/// As TOML writes it.
impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Flag(flag) => write!(f, "{flag}"),
            Self::Number(number) if number.is_infinite() => {
                f.write_str(if *number > 0.0 { "inf" } else { "-inf" })
            }
            // Without an exponent it would be a whole number, and TOML has none that large.
            Self::Number(number) if number.abs() >= LARGE => write!(f, "{number:e}"),
            Self::Number(number) => write!(f, "{}", number + 0.0),
            Self::Text(text) => f.write_str(&quoted(text)),
            Self::List(values) => {
                let all: Vec<_> = values.iter().map(Self::to_string).collect();
                write!(f, "[{}]", all.join(", "))
            }
        }
    }
}

/// A text as a basic string of TOML.
fn quoted(text: &str) -> String {
    let mut out = String::from("\"");
    for c in text.chars() {
        match c {
            '"' | '\\' => out.extend(['\\', c]),
            c if c.is_control() => out.push_str(&format!("\\u{:04X}", c as u32)),
            c => out.push(c),
        }
    }
    out.push('"');
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(typed: &str, shown: &str) {
        assert_eq!(Value::typed(typed).to_string(), shown, "{typed}");
    }

    #[test]
    fn typed_values_are_read_as_people_write_them() {
        check("yes", "true");
        check("OFF", "false");
        check(" 2.50 ", "2.5");
        check("1,2, 3", "[1, 2, 3]");
        check("[x, z]", "[\"x\", \"z\"]");
        check("[]", "[]");
        check("proportional", "\"proportional\"");
        check("\"a\\b\"", "\"a\\\\b\"");
        check("1e19", "1e19");
        check("-9300000000000000000", "-9.3e18");
        check("1e15", "1000000000000000");
    }
}
