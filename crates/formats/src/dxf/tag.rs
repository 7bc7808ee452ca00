//! DXF as pairs of a group code and a value, from text or binary.
//!
//! A file that is broken in one place is read on: a line that is no group code is told and passed
//! over, a value that is no number is told by whoever wanted one.

use super::binary;
use crate::finding::Findings;

/// A group code with its value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tag<'a> {
    /// Group code, which gives the value its meaning (DXF reference, "Group codes").
    pub code: u16,
    /// The value as it stands in the file.
    pub value: Value<'a>,
    /// Line of the value, counted from 1; in a binary file the byte.
    pub line: u32,
}

/// A value. Text files hold words for everything.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value<'a> {
    /// As it stands in the file, without the line end.
    Text(&'a [u8]),
    /// A number of a binary file.
    Real(f64),
    /// A whole number of a binary file.
    Whole(i64),
}

impl<'a> Tag<'a> {
    /// The value as a number, if it is a finite one. A comma is taken for a point.
    pub fn real(&self) -> Option<f64> {
        let value = match self.value {
            Value::Real(value) => value,
            Value::Whole(value) => value as f64,
            Value::Text(text) => real(text)?,
        };
        value.is_finite().then_some(value)
    }

    /// The value as a whole number.
    pub fn whole(&self) -> Option<i64> {
        match self.value {
            Value::Whole(value) => Some(value),
            Value::Real(value) => Some(value as i64),
            Value::Text(text) => {
                let text = text.trim_ascii();
                let word = std::str::from_utf8(text).ok()?;
                word.parse().ok().or_else(|| real(text).map(|value| value as i64))
            }
        }
    }

    /// The value as a name, without blanks around it.
    pub fn name(&self) -> &'a [u8] {
        match self.value {
            Value::Text(text) => text.trim_ascii(),
            _ => b"",
        }
    }

    /// The value as text for people: UTF-8 where it is, else Windows' western letters.
    pub fn text(&self) -> String {
        match self.value {
            Value::Text(text) => decoded(text.trim_ascii()),
            Value::Real(value) => value.to_string(),
            Value::Whole(value) => value.to_string(),
        }
    }
}

fn real(text: &[u8]) -> Option<f64> {
    let text = text.trim_ascii();
    if let Ok(value) = fast_float2::parse::<f64, _>(text) {
        return Some(value);
    }
    let point: Vec<u8> = text.iter().map(|b| if *b == b',' { b'.' } else { *b }).collect();
    fast_float2::parse::<f64, _>(&point).ok()
}

/// Text of either encoding that DXF files have. The letters 128 … 159 of Windows' page, which no name
/// of a layer needs, are taken for those of Latin-1.
pub fn decoded(bytes: &[u8]) -> String {
    match std::str::from_utf8(bytes) {
        Ok(text) => text.to_owned(),
        Err(_) => bytes.iter().map(|byte| char::from(*byte)).collect(),
    }
}

/// All pairs of a file.
pub fn tags<'a>(bytes: &'a [u8], findings: &mut Findings) -> Vec<Tag<'a>> {
    match binary::body(bytes) {
        Some(body) => binary::tags(body, findings),
        None => text_tags(bytes, findings),
    }
}

fn text_tags<'a>(bytes: &'a [u8], findings: &mut Findings) -> Vec<Tag<'a>> {
    let bytes = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
    let mut tags = Vec::with_capacity(bytes.len() / 14);
    let mut lines = Lines { rest: bytes, number: 0 };
    while let Some(line) = lines.next() {
        let Some(code) = code(line) else {
            if begins_an_entity(line, tags.last()) {
                findings.warn("code", lines.number, taken_for_an_entity(line));
                tags.push(Tag { code: 0, value: Value::Text(line), line: lines.number });
            } else if !line.trim_ascii().is_empty() {
                findings.warn("code", lines.number, not_a_code(line));
            }
            continue;
        };
        let Some(value) = lines.next() else {
            findings.warn("end", lines.number, "the file ends within a pair of code and value");
            break;
        };
        tags.push(Tag { code, value: Value::Text(value), line: lines.number });
        if code == 0 && value.trim_ascii() == b"EOF" {
            break;
        }
    }
    tags
}

/// Tells whether a line in the place of a code is the name of an entity. Where a line is missing, or one too many,
/// the `0` before the name is read as a value; the name shows it, and puts codes and values in step again.
fn begins_an_entity(line: &[u8], before: Option<&Tag>) -> bool {
    let zero = before.is_some_and(|tag| tag.name() == b"0");
    let letter = |byte: &u8| byte.is_ascii_uppercase() || byte.is_ascii_digit() || *byte == b'_';
    let name = line.trim_ascii();
    zero && name.len() > 2 && name.iter().all(letter) && !name[0].is_ascii_digit()
}

fn taken_for_an_entity(line: &[u8]) -> String {
    let shown = decoded(line.trim_ascii());
    format!(
        "`{shown}` stands where a group code should: a line before it is missing, or one too many"
    )
}

fn not_a_code(line: &[u8]) -> String {
    let shown: String = decoded(line.trim_ascii()).chars().take(30).collect();
    format!("`{shown}` is no group code; the line is passed over")
}

fn code(line: &[u8]) -> Option<u16> {
    let digits = line.trim_ascii();
    if digits.is_empty() || digits.len() > 5 {
        return None;
    }
    digits.iter().try_fold(0u16, |code, byte| {
        let digit = byte.is_ascii_digit().then(|| u16::from(byte - b'0'))?;
        code.checked_mul(10)?.checked_add(digit)
    })
}

/// Lines that end in CR LF, LF or CR.
struct Lines<'a> {
    rest: &'a [u8],
    number: u32,
}

impl<'a> Lines<'a> {
    fn next(&mut self) -> Option<&'a [u8]> {
        if self.rest.is_empty() {
            return None;
        }
        self.number += 1;
        let Some(end) = memchr::memchr2(b'\n', b'\r', self.rest) else {
            return Some(std::mem::take(&mut self.rest));
        };
        let line = &self.rest[..end];
        let both = self.rest[end..].starts_with(b"\r\n");
        self.rest = &self.rest[end + 1 + usize::from(both)..];
        Some(line)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> (String, Vec<String>) {
        let mut findings = Findings::default();
        let tags = tags(text.as_bytes(), &mut findings);
        let shown: Vec<_> =
            tags.iter().map(|tag| format!("{}={}@{}", tag.code, tag.text(), tag.line)).collect();
        let told = findings.finish().into_iter().map(|f| format!("{}: {}", f.line, f.text));
        (shown.join(" "), told.collect())
    }

    #[test]
    fn pairs_are_read_with_any_line_end() {
        for end in ["\n", "\r\n", "\r"] {
            let (tags, told) = read(&["  0", "LINE", " 10", " 1.5 ", "0", "EOF", "junk"].join(end));
            assert_eq!(tags, "0=LINE@2 10=1.5@4 0=EOF@6");
            assert_eq!(told, Vec::<String>::new());
        }
    }

    #[test]
    fn a_line_that_is_no_code_is_passed_over() {
        let (tags, told) = read("0\nLINE\nrubbish\n10\n5\n\n20\n6\n");
        assert_eq!(tags, "0=LINE@2 10=5@5 20=6@8");
        assert_eq!(told, ["3: `rubbish` is no group code; the line is passed over"]);
    }

    #[test]
    fn a_file_that_ends_early_is_told() {
        let (tags, told) = read("0\nLINE\n10");
        assert_eq!(tags, "0=LINE@2");
        assert_eq!(told, ["3: the file ends within a pair of code and value"]);
    }

    #[test]
    fn numbers_are_read_as_people_write_them() {
        let real = |text: &'static str| {
            Tag { code: 10, value: Value::Text(text.as_bytes()), line: 1 }.real()
        };
        assert_eq!(real(" 1.25 "), Some(1.25));
        assert_eq!(real("1,25"), Some(1.25));
        assert_eq!(real("-1e-3"), Some(-0.001));
        assert_eq!(real("nan"), None);
        assert_eq!(real("1.#QNAN"), None);
        assert_eq!(real(""), None);
    }
}
