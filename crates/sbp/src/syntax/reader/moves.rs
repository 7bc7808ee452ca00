//! The fast road: lines that only move axes to literal places.
//!
//! Files of a million such lines are common, so they are read in one pass over their bytes, with
//! no allocation. Everything unusual is left to the careful road, which gives the same meaning.

use super::text::is_blank;
use crate::syntax::tree::{MoveCommand, Node};

/// Reads the line that begins at `start` if it is a plain move; also gives the end of the line.
///
/// Its values are appended to `numbers`; nothing is appended when the line is something else.
pub(super) fn read(bytes: &[u8], start: usize, numbers: &mut Vec<f64>) -> Option<(Node, usize)> {
    let mut scan = Scan { bytes, at: start };
    scan.blanks();
    let command = scan.command()?;
    let first = numbers.len();
    match scan.values(command.count, numbers) {
        Some(given) if given != 0 || command.count > 1 => {
            Some((Node::Move { command, given, first: first as u32 }, scan.comment_end()))
        }
        _ => {
            numbers.truncate(first);
            None
        }
    }
}

struct Scan<'a> {
    bytes: &'a [u8],
    at: usize,
}

/// Powers of ten that a double holds exactly.
const TENS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16,
    1e17, 1e18, 1e19, 1e20, 1e21, 1e22,
];

impl Scan<'_> {
    /// The byte here; a line end where the text ends.
    fn peek(&self) -> u8 {
        self.bytes.get(self.at).copied().unwrap_or(b'\n')
    }

    fn blanks(&mut self) {
        while is_blank(self.peek()) {
            self.at += 1;
        }
    }

    fn command(&mut self) -> Option<MoveCommand> {
        let jog = match self.peek() | 0x20 {
            b'm' => false,
            b'j' => true,
            _ => return None,
        };
        self.at += 1;
        let (first, count) = match self.peek() | 0x20 {
            digit @ b'2'..=b'6' => (0, digit - b'0'),
            axis @ b'x'..=b'z' => (axis - b'x', 1),
            axis @ b'a'..=b'c' => (axis - b'a' + 3, 1),
            _ => return None,
        };
        self.at += 1;
        Some(MoveCommand { jog, first, count })
    }

    /// The values behind the command: bit i of the result says that value i is given.
    fn values(&mut self, count: u8, numbers: &mut Vec<f64>) -> Option<u8> {
        match self.peek() {
            separator if separator == b',' || is_blank(separator) => self.at += 1,
            b'\n' | b'\r' | b'\'' => return Some(0),
            _ => return None,
        }
        let mut given = 0;
        for i in 0..count {
            self.blanks();
            if self.starts_number() {
                numbers.push(self.number()?);
                given |= 1 << i;
                self.blanks();
            }
            match self.peek() {
                b',' => self.at += 1,
                b'\n' | b'\r' | b'\'' => return Some(given),
                _ => return None,
            }
        }
        // Trailing empty fields mean nothing.
        while self.peek() == b',' || is_blank(self.peek()) {
            self.at += 1;
        }
        matches!(self.peek(), b'\n' | b'\r' | b'\'').then_some(given)
    }

    fn starts_number(&self) -> bool {
        matches!(self.peek(), b'0'..=b'9' | b'.' | b'-' | b'+')
    }

    fn number(&mut self) -> Option<f64> {
        let negative = self.peek() == b'-';
        self.at += usize::from(negative || self.peek() == b'+');
        let magnitude = number(self.bytes, &mut self.at)?;
        Some(if negative { -magnitude } else { magnitude })
    }

    /// The end of the line, a comment skipped.
    fn comment_end(&self) -> usize {
        match self.peek() {
            b'\'' => super::text::line_end(self.bytes, self.at).0,
            _ => self.at,
        }
    }
}

/// Reads an unsigned decimal number at `at` and goes behind it; finite numbers only.
pub(super) fn number(bytes: &[u8], at: &mut usize) -> Option<f64> {
    let text = bytes.get(*at..)?;
    let (whole, rest) = digits(0, text);
    let mut mantissa = whole;
    let mut count = text.len() - rest.len();
    let (mut after, mut places) = (rest, 0);
    if let [b'.', fraction @ ..] = rest {
        (mantissa, after) = digits(whole, fraction);
        places = fraction.len() - after.len();
        count += places;
    }
    if count == 0 {
        return None;
    }
    // Up to 15 digits fit a double and so does the power of ten: one division rounds rightly
    // (Clinger, How to read floating point numbers accurately, 1990).
    if count <= 15 && !matches!(after, [b'e' | b'E', ..]) {
        *at += text.len() - after.len();
        return Some(mantissa as i64 as f64 / TENS[places]);
    }
    let (value, length) = fast_float2::parse_partial::<f64, _>(text).ok()?;
    *at += length;
    value.is_finite().then_some(value)
}

/// Appends the decimal digits at the start of a text to a whole number; also what follows them.
///
/// Wraps when there are too many; the caller counts them.
fn digits(mut value: u64, mut text: &[u8]) -> (u64, &[u8]) {
    while let [first, rest @ ..] = text {
        let digit = first.wrapping_sub(b'0');
        if digit > 9 {
            break;
        }
        value = value.wrapping_mul(10).wrapping_add(u64::from(digit));
        text = rest;
    }
    (value, text)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(line: &str, expected: Option<(&str, u8, &[f64])>) {
        let mut numbers = vec![7.0];
        let node = read(line.as_bytes(), 0, &mut numbers);
        let Some((name, given, values)) = expected else {
            assert!(node.is_none() && numbers.len() == 1, "{line}: {node:?} {numbers:?}");
            return;
        };
        let Some((Node::Move { command, given: bits, first }, end)) = node else {
            panic!("{line}: {node:?}")
        };
        assert_eq!((bits, first, end), (given, 1, line.trim_end_matches('\n').len()), "{line}");
        assert_eq!(&numbers[1..], values, "{line}");
        let mut letters = String::from(if command.jog { "J" } else { "M" });
        match command.count {
            1 => letters.push("XYZABC".chars().nth(command.first.into()).unwrap_or('?')),
            n => letters.push_str(&n.to_string()),
        }
        assert_eq!(letters, name, "{line}");
    }

    #[test]
    fn plain_moves_take_the_fast_road() {
        check("M3,1,2,3", Some(("M3", 0b111, &[1.0, 2.0, 3.0])));
        check("m3 1.5,-.25,+5.\n", Some(("M3", 0b111, &[1.5, -0.25, 5.0])));
        check("\t JZ, .5  'pulls the bit up", Some(("JZ", 1, &[0.5])));
        check("M2,, 4.2", Some(("M2", 0b10, &[4.2])));
        check("M2 , 4.2", Some(("M2", 0b10, &[4.2])));
        check("M2\t3,4", Some(("M2", 0b11, &[3.0, 4.0])));
        check("M3,1,,,,", Some(("M3", 1, &[1.0])));
        check("J6,1,2,3,4,5,6", Some(("J6", 63, &[1.0, 2.0, 3.0, 4.0, 5.0, 6.0])));
        check("MC,1e-3", Some(("MC", 1, &[1e-3])));
        check("M2", Some(("M2", 0, &[])));
        check("MB,123456789012345678", Some(("MB", 1, &[123_456_789_012_345_678.0])));
    }

    #[test]
    fn everything_else_is_left_alone() {
        for line in [
            "",
            "MX",
            "MX,",
            "MX,1,2",
            "M3,1,2,3,4",
            "M23, 4",
            "MX5",
            "MX:",
            "MX,&a",
            "MX,1+1",
            "MX,.",
            "MX,-",
            "MX,1.2.3",
            "MX,1e999",
            "M2 3 4",
            "MD,1,2",
            "MX,1 MY,2",
            "MX,1:",
            "M3,1,2,\"3\"",
            "MX,1e",
            "MX,0x10",
            "M7,1",
            "MO",
        ] {
            check(line, None);
        }
    }

    #[test]
    fn numbers_are_rounded_as_the_standard_library_does() {
        for text in ["0.1", "123456.789012", "999999999999999", "0.000000000000001", "4.35", "1e23"]
        {
            let mut at = 0;
            assert_eq!(number(text.as_bytes(), &mut at), text.parse().ok(), "{text}");
            assert_eq!(at, text.len());
        }
    }
}
