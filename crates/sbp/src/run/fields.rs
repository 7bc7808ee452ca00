//! Values between commas, as INPUT and INPUT # read them (readings, A-38).

use super::eval::number_or_text;
use crate::Value;

/// The values of a line. Text in quotes keeps its commas and loses its quotes.
pub(super) fn split(line: &str) -> Vec<Value> {
    let mut fields = Vec::new();
    let mut start = 0;
    let mut quoted = false;
    for (index, c) in line.char_indices() {
        match c {
            '"' => quoted = !quoted,
            ',' if !quoted => {
                fields.push(value(&line[start..index]));
                start = index + 1;
            }
            _ => {}
        }
    }
    fields.push(value(&line[start..]));
    fields
}

/// One field: a number when it spells one, else text without the blanks around it.
pub(super) fn value(field: &str) -> Value {
    let field = field.trim();
    let inner = field.strip_prefix('"').and_then(|rest| rest.strip_suffix('"'));
    match inner {
        Some(text) => Value::text(text),
        None => number_or_text(field),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn commas_split_and_quotes_keep() {
        let text = |t: &str| Value::text(t);
        for (line, expected) in [
            ("1, abc", vec![Value::Number(1.0), text("abc")]),
            ("\"a, b\",3", vec![text("a, b"), Value::Number(3.0)]),
            ("", vec![text("")]),
            ("1,,", vec![Value::Number(1.0), text(""), text("")]),
            ("\"1\"", vec![text("1")]),
            ("5\" pipe, 2", vec![text("5\" pipe, 2")]),
            ("\"", vec![text("\"")]),
        ] {
            assert_eq!(split(line), expected, "{line}");
        }
    }
}
