//! Binary DXF: the same pairs, values by the type of their group code.

use super::tag::{Tag, Value};
use crate::finding::Findings;

/// First bytes of a binary file (DXF reference, "Binary DXF files").
const SENTINEL: &[u8] = b"AutoCAD Binary DXF\r\n\x1a\0";

/// Returns what follows the sentinel, when it is a binary file.
pub fn body(bytes: &[u8]) -> Option<&[u8]> {
    bytes.strip_prefix(SENTINEL)
}

/// The pairs of a binary file. Where it cannot be read on, the rest is told and left out.
pub fn tags<'a>(body: &'a [u8], findings: &mut Findings) -> Vec<Tag<'a>> {
    // Release 12 has codes of one byte, later ones of two: the first pair, `0 SECTION`, tells.
    let wide = body.get(1) == Some(&0);
    let mut reader = Reader { rest: body, at: SENTINEL.len(), wide };
    let mut tags = Vec::with_capacity(body.len() / 8);
    while !reader.rest.is_empty() {
        // Bytes beyond a u32 are more than any such file has.
        let line = reader.at as u32;
        let Some(tag) = reader.tag(line) else {
            findings.warn("end", line, "the file breaks off within a value; the rest is left out");
            break;
        };
        let is_end = tag.code == 0 && tag.name() == b"EOF";
        tags.push(tag);
        if is_end {
            break;
        }
    }
    tags
}

struct Reader<'a> {
    rest: &'a [u8],
    at: usize,
    wide: bool,
}

impl<'a> Reader<'a> {
    fn tag(&mut self, line: u32) -> Option<Tag<'a>> {
        let code = self.code()?;
        Some(Tag { code, value: self.value(code)?, line })
    }

    fn code(&mut self) -> Option<u16> {
        if self.wide {
            return self.bytes().map(u16::from_le_bytes);
        }
        let [short] = self.bytes()?;
        if short == u8::MAX { self.bytes().map(u16::from_le_bytes) } else { Some(short.into()) }
    }

    fn value(&mut self, code: u16) -> Option<Value<'a>> {
        Some(match code {
            10..=59 | 110..=149 | 210..=239 | 460..=469 | 1010..=1059 => {
                Value::Real(f64::from_le_bytes(self.bytes()?))
            }
            60..=79 | 170..=179 | 270..=289 | 370..=389 | 400..=409 | 1060..=1070 => {
                Value::Whole(i16::from_le_bytes(self.bytes()?).into())
            }
            90..=99 | 420..=429 | 440..=459 | 1071 => {
                Value::Whole(i32::from_le_bytes(self.bytes()?).into())
            }
            160..=169 => Value::Whole(i64::from_le_bytes(self.bytes()?)),
            290..=299 => Value::Whole(self.bytes::<1>()?[0].into()),
            310..=319 | 1004 => {
                let [length] = self.bytes()?;
                Value::Text(self.take(length.into())?)
            }
            _ => Value::Text(self.text()?),
        })
    }

    fn bytes<const N: usize>(&mut self) -> Option<[u8; N]> {
        self.take(N)?.try_into().ok()
    }

    fn take(&mut self, count: usize) -> Option<&'a [u8]> {
        let (taken, rest) = self.rest.split_at_checked(count)?;
        self.rest = rest;
        self.at += count;
        Some(taken)
    }

    /// Text ends with a zero byte.
    fn text(&mut self) -> Option<&'a [u8]> {
        let end = memchr::memchr(0, self.rest)?;
        let text = self.take(end)?;
        self.take(1)?;
        Some(text)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(body: &[u8]) -> (String, usize) {
        let mut findings = Findings::default();
        let words: Vec<_> = tags(body, &mut findings)
            .iter()
            .map(|tag| format!("{}={}", tag.code, tag.text()))
            .collect();
        (words.join(" "), findings.finish().len())
    }

    #[test]
    fn codes_have_one_byte_in_release_12_and_two_later() {
        let number = 2.5f64.to_le_bytes();
        let short = [b"\0LINE\0\x0a".as_slice(), &number, b"\0EOF\0"].concat();
        assert_eq!(shown(&short), ("0=LINE 10=2.5 0=EOF".into(), 0));
        let wide = [b"\0\0LINE\0\x0a\0".as_slice(), &number, b"\0\0EOF\0"].concat();
        assert_eq!(shown(&wide), ("0=LINE 10=2.5 0=EOF".into(), 0));
    }

    #[test]
    fn a_file_that_breaks_off_keeps_what_came_before() {
        assert_eq!(shown(b"\0LINE\0\x0a\x01\x02"), ("0=LINE".into(), 1));
    }
}
