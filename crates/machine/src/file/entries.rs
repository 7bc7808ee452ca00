//! Entries of a TOML text: dotted keys, their values and where they stand.

use crate::value::Value;
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// One key with its value.
pub(super) struct Entry {
    /// The key with its sections, dotted.
    pub key: String,
    /// Place of the key, bytes.
    pub key_span: Range<usize>,
    /// The value; nothing for dates, which no setting is.
    pub value: Option<Value>,
    /// Place of the value, bytes.
    pub value_span: Range<usize>,
}

/// Text that is no TOML.
pub(super) struct Unreadable {
    /// The mistake in words.
    pub message: String,
    /// Place of the mistake, bytes.
    pub span: Range<usize>,
}

/// The entries in order of their place, and what cannot be read.
pub(super) fn entries(text: &str) -> (Vec<Entry>, Vec<Unreadable>) {
    let (table, errors) = DeTable::parse_recoverable(text);
    let mut out = Vec::new();
    flatten(table.get_ref(), "", &mut out);
    out.sort_by_key(|entry| entry.key_span.start);
    let unreadable = |e: &toml::de::Error| Unreadable {
        message: e.message().to_owned(),
        span: e.span().unwrap_or_default(),
    };
    (out, errors.iter().map(unreadable).collect())
}

fn flatten(table: &DeTable<'_>, section: &str, out: &mut Vec<Entry>) {
    for (name, value) in table {
        let key = match section {
            "" => name.get_ref().to_string(),
            section => format!("{section}.{}", name.get_ref()),
        };
        match value.get_ref() {
            DeValue::Table(inner) => flatten(inner, &key, out),
            _ => out.push(Entry {
                key,
                key_span: name.span(),
                value: plain(value),
                value_span: value.span(),
            }),
        }
    }
}

fn plain(value: &Spanned<DeValue<'_>>) -> Option<Value> {
    Some(match value.get_ref() {
        DeValue::Boolean(flag) => Value::Flag(*flag),
        DeValue::String(text) => Value::Text(text.to_string()),
        DeValue::Integer(number) => {
            let whole = i64::from_str_radix(number.as_str(), number.radix()).ok()?;
            Value::Number(whole as f64)
        }
        DeValue::Float(number) => Value::Number(number.as_str().parse().ok()?),
        DeValue::Array(values) => Value::List(values.iter().map(plain).collect::<Option<_>>()?),
        DeValue::Datetime(_) | DeValue::Table(_) => return None,
    })
}
