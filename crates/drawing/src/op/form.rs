//! The forms of the table as values: what a sheet of an operation asks for, in order.
//!
//! ```text
//!  rotate ANGLE [about X,Y] | rotate to ANGLE from X,Y X,Y
//!         ─────  ─────────           ────────
//!         value  may be left out     word before a value
//! ```
//!
//! Small letters are words as they are written, capitals are values, `|` between words is a choice, `…`
//! lets the part before it be said again.

use super::Entry;

/// One way to say an operation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Variant {
    /// As the table writes it.
    pub form: String,
    /// Parts that follow the operation's name, in order.
    pub parts: Vec<Part>,
}

/// A part of what is said.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Part {
    /// Text before the value: `about `, `tool=`. Without a value, a word.
    pub lead: String,
    /// Value to be entered; nothing for a word alone.
    pub value: Option<Value>,
    /// It may be left out.
    pub optional: bool,
    /// It may be said several times.
    pub repeats: bool,
}

/// Kind of value that is entered for a part.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Value {
    /// `x,y`: a place or a displacement.
    Pair,
    /// `x,y` or `x,y,bulge`.
    Vertex,
    /// `x,y,z`.
    Triple,
    /// Millimetres, with the name in the table.
    Length(String),
    /// A number that is no length, with the name in the table.
    Number(String),
    /// A radius and an angle, `r,a`.
    Arc,
    /// Rows by columns, `2x3`.
    Grid,
    /// The number of a shape.
    Shape,
    /// Numbers of shapes, `1,3-5`.
    Shapes,
    /// A group.
    Group,
    /// Groups with commas between.
    Groups,
    /// One of these words; or a length or number of that name.
    Words(Vec<String>, Option<Box<Value>>),
    /// A drawing of the part folder.
    File,
    /// Anything.
    Text,
}

impl Entry {
    /// The ways to say the operation.
    pub fn variants(&self) -> Vec<Variant> {
        let name = self.name;
        self.form
            .split(" | ")
            .map(|form| Variant {
                form: form.into(),
                parts: parts(form.strip_prefix(name).unwrap_or(form).trim()),
            })
            .collect()
    }
}

fn parts(text: &str) -> Vec<Part> {
    let mut found: Vec<Part> = Vec::new();
    let mut lead: Option<&str> = None;
    for token in tokens(text) {
        if token == "…" {
            found.iter_mut().last().into_iter().for_each(|part| part.repeats = true);
        } else if let Some(inner) = token.strip_prefix('[') {
            flush(&mut found, &mut lead);
            let inner = parts(inner.trim_end_matches(']'));
            found.extend(inner.into_iter().map(|part| Part { optional: true, ..part }));
        } else if is_word(token) {
            flush(&mut found, &mut lead);
            lead = Some(token);
        } else {
            found.push(valued(token, lead.take()));
        }
    }
    flush(&mut found, &mut lead);
    found
}

/// A word that no value followed.
fn flush(found: &mut Vec<Part>, lead: &mut Option<&str>) {
    if let Some(word) = lead.take() {
        found.push(Part { lead: word.into(), value: None, optional: false, repeats: false });
    }
}

fn valued(token: &str, lead: Option<&str>) -> Part {
    let (lead, value) = match token.split_once('=') {
        Some((key, value)) => (format!("{key}="), value),
        None => (lead.map(|word| format!("{word} ")).unwrap_or_default(), token),
    };
    Part { lead, value: Some(value_of(value)), optional: false, repeats: false }
}

/// Words of a form; what is in brackets is one.
fn tokens(text: &str) -> Vec<&str> {
    let (mut found, mut rest) = (Vec::new(), text);
    while !rest.is_empty() {
        let end =
            if rest.starts_with('[') { rest.find(']').map(|at| at + 1) } else { rest.find(' ') };
        let (token, after) = rest.split_at(end.unwrap_or(rest.len()));
        found.push(token);
        rest = after.trim_start();
    }
    found
}

/// Tells whether a token is written as it stands.
fn is_word(token: &str) -> bool {
    !token.contains(['|', '=']) && token.chars().all(|c| c.is_ascii_lowercase() || c == '-')
}

fn value_of(text: &str) -> Value {
    if !text.contains('|') {
        return plain(text);
    }
    let (words, values): (Vec<&str>, Vec<&str>) =
        text.split('|').partition(|word| !word.chars().any(|c| c.is_ascii_uppercase()));
    match values.as_slice() {
        [] => Value::Words(words.into_iter().map(Into::into).collect(), None),
        [one] => {
            Value::Words(words.into_iter().map(Into::into).collect(), Some(Box::new(plain(one))))
        }
        _ => Value::Text,
    }
}

fn plain(name: &str) -> Value {
    match kind(name.as_bytes()) {
        Some(Kind::Pair) => Value::Pair,
        Some(Kind::Vertex) => Value::Vertex,
        Some(Kind::Triple) => Value::Triple,
        Some(Kind::Arc) => Value::Arc,
        Some(Kind::Grid) => Value::Grid,
        Some(Kind::Shape) => Value::Shape,
        Some(Kind::Shapes) => Value::Shapes,
        Some(Kind::Group) => Value::Group,
        Some(Kind::Groups) => Value::Groups,
        Some(Kind::File) => Value::File,
        Some(Kind::Length) => Value::Length(name.into()),
        Some(Kind::Number) => Value::Number(name.into()),
        Some(Kind::Text) | None => Value::Text,
    }
}

/// Kind of a value, by its name in a form.
#[derive(Clone, Copy)]
enum Kind {
    Pair,
    Vertex,
    Triple,
    Length,
    Number,
    Arc,
    Grid,
    Shape,
    Shapes,
    Group,
    Groups,
    File,
    Text,
}

/// The kind of the value that a form calls by a name; `None` for a name that is not known.
const fn kind(name: &[u8]) -> Option<Kind> {
    Some(match name {
        b"X,Y" | b"W,H" => Kind::Pair,
        b"X,Y,B" => Kind::Vertex,
        b"X,Y,Z" => Kind::Triple,
        b"RADIUS" | b"LENGTH" | b"DISTANCE" | b"MM" | b"D" | b"Z" => Kind::Length,
        b"ANGLE" | b"FACTOR" | b"B" | b"N" | b"S" | b"MM/S" | b"MM/S2" => Kind::Number,
        b"R,A" => Kind::Arc,
        b"RxC" => Kind::Grid,
        b"SHAPE" => Kind::Shape,
        b"SHAPES" => Kind::Shapes,
        b"COLOUR" => Kind::Group,
        b"COLOURS" => Kind::Groups,
        b"FILE" => Kind::File,
        b"WORDS" | b"ramp,A" | b"helix,R,A" => Kind::Text,
        _ => return None,
    })
}

/// Refuses, while Kerf is built, a form with a name of a value that [`kind`] does not know. A sheet that took it for a
/// plain number would read the inches that somebody enters as millimetres.
///
/// # Panics
/// The form has such a name; the compiler tells file, line and column of the entry.
#[track_caller]
pub(super) const fn check(form: &str) {
    assert!(
        !has_unknown(form.as_bytes()),
        "a form calls a value by a name that `kind` in op/form.rs does not know"
    );
}

/// Tells whether a form has a word with capitals that is no known name.
const fn has_unknown(mut rest: &[u8]) -> bool {
    while !rest.is_empty() {
        let (mut length, mut is_value) = (0, false);
        while length < rest.len() && !matches!(rest[length], b' ' | b'[' | b']' | b'|' | b'=') {
            is_value |= rest[length].is_ascii_uppercase();
            length += 1;
        }
        let (word, behind) = rest.split_at(length);
        if is_value && kind(word).is_none() {
            return true;
        }
        rest = match behind {
            [_, behind @ ..] => behind,
            [] => behind,
        };
    }
    false
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::op::ENTRIES;

    /// Returns what a person would write for a part; places of a clause differ.
    fn said(part: usize, value: &Value) -> String {
        match value {
            Value::Pair | Value::Vertex => format!("10,{part}"),
            Value::Triple => format!("10,{part},-3"),
            Value::Length(_) | Value::Number(_) => "4".into(),
            Value::Arc => "5,90".into(),
            Value::Grid => "2x3".into(),
            Value::Shape => "1".into(),
            Value::Shapes => "1,3-5".into(),
            Value::Group => "red".into(),
            Value::Groups => "red,black".into(),
            Value::Words(words, _) => words[0].clone(),
            Value::File => "a.dxf".into(),
            Value::Text => "straight".into(),
        }
    }

    fn clause(entry: &Entry, variant: &Variant, all: bool) -> String {
        let mut words = vec![entry.name.to_owned()];
        for (n, part) in variant.parts.iter().enumerate().filter(|(_, it)| all || !it.optional) {
            let value = part.value.as_ref().map(|value| said(n, value)).unwrap_or_default();
            let times = if part.repeats && all { 2 } else { 1 };
            words.extend(std::iter::repeat_n(format!("{}{value}", part.lead), times));
        }
        words.join(" ")
    }

    /// Words that stand for others, so that a form may ask for one of them at least.
    const NEEDS_SOMETHING: &[&str] = &["set"];

    #[test]
    fn every_form_is_read_as_it_says_with_and_without_what_may_be_left_out() {
        for entry in ENTRIES {
            for variant in entry.variants() {
                let long = clause(entry, &variant, true);
                crate::script(&long).unwrap_or_else(|error| panic!("{error}"));
                let short = clause(entry, &variant, false);
                let read = crate::script(&short);
                assert_eq!(read.is_ok(), !NEEDS_SOMETHING.contains(&entry.name), "{short}");
            }
        }
    }

    fn check(form: &'static str, expected: &[(&str, Option<Value>, bool)]) {
        let found = parts(form);
        let found: Vec<_> =
            found.iter().map(|p| (p.lead.as_str(), p.value.clone(), p.optional)).collect();
        assert_eq!(found, expected);
    }

    #[test]
    fn words_choices_and_values_are_told_apart() {
        check(
            "to ANGLE from X,Y X,Y [raw]",
            &[
                ("to ", Some(Value::Number("ANGLE".into())), false),
                ("from ", Some(Value::Pair), false),
                ("", Some(Value::Pair), false),
                ("raw", None, true),
            ],
        );
        let corners = Value::Words(vec!["bl".into(), "br".into()], None);
        check("rect [start bl|br]", &[("rect", None, false), ("start ", Some(corners), true)]);
        let pass = Value::Words(vec!["off".into()], Some(Box::new(Value::Length("MM".into()))));
        check("[pass=MM|off]", &[("pass=", Some(pass), true)]);
        assert!(parts("SHAPE X,Y …")[1].repeats);
    }

    #[test]
    fn a_value_of_an_unknown_name_is_refused() {
        let check = |form: &str, unknown: bool| {
            assert_eq!(has_unknown(form.as_bytes()), unknown, "{form}");
        };
        check("slot WIDTH", true);
        check("slot [width=WIDTH|off] X,Y", true);
        check("slot X,Y MMM", true);
        check("slot [width=MM|off] X,Y \u{2026} N", false);
        check("", false);
    }
}
