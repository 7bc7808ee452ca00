//! JSON with plain decimal numbers.
//!
//! Numbers are rounded to a billionth and written without exponent, so that traces are equal on all
//! machines, can be compared as text and read by the simplest tools.

use crate::{Event, Sink};
use kerf_program::decimal;
use serde::Serialize;
use serde_json::ser::{CompactFormatter, Formatter};
use std::io::{self, Write};

/// Decimal places that are kept.
const PLACES: usize = 9;

/// Below this the digits of a number fit into 64 bits with [`PLACES`] behind the point.
const FAST_BELOW: f64 = 9.0e9;

/// Writes each event as a line of JSON.
pub struct JsonLines<W: Write> {
    out: W,
    /// The first failure to write; nothing is written after it.
    failed: Option<io::Error>,
}

impl<W: Write> JsonLines<W> {
    /// Writes to `out`, which should be buffered.
    pub const fn new(out: W) -> Self {
        Self { out, failed: None }
    }

    /// Writes what is buffered; tells the first failure of all.
    pub fn finish(mut self) -> io::Result<()> {
        match self.failed {
            Some(error) => Err(error),
            None => self.out.flush(),
        }
    }
}

impl<W: Write> Sink for JsonLines<W> {
    fn event(&mut self, event: &Event) {
        if self.failed.is_some() {
            return;
        }
        let written = write_line(&mut self.out, event);
        self.failed = written.err();
    }
}

fn write_line(out: &mut impl Write, event: &Event) -> io::Result<()> {
    write(out, event)?;
    out.write_all(b"\n")
}

/// Writes a value as JSON on one line.
pub fn write(out: &mut impl Write, value: &impl Serialize) -> io::Result<()> {
    let mut serializer =
        serde_json::Serializer::with_formatter(out, PlainNumbers(CompactFormatter));
    Ok(value.serialize(&mut serializer)?)
}

/// A value as JSON on one line.
pub fn to_string(value: &impl Serialize) -> String {
    let mut bytes = Vec::new();
    // Writing to memory does not fail, and the formatter writes UTF-8.
    let _ = write(&mut bytes, value);
    String::from_utf8(bytes).unwrap_or_default()
}

struct PlainNumbers(CompactFormatter);

impl Formatter for PlainNumbers {
    fn write_f64<W: ?Sized + Write>(&mut self, out: &mut W, value: f64) -> io::Result<()> {
        if value.abs() < FAST_BELOW {
            return write_fast(out, value);
        }
        write_decimal(out, value)
    }
}

/// Integer digits: rounding, dividing and cutting zeros without the general machinery.
fn write_fast<W: ?Sized + Write>(out: &mut W, value: f64) -> io::Result<()> {
    let mut buffer = [0u8; 24];
    let mut at = buffer.len();
    let mut digits = (value.abs() * 1e9).round() as u64;
    let negative = value < 0.0 && digits > 0;
    let mut places = PLACES;
    while places > 0 && digits.is_multiple_of(10) {
        digits /= 10;
        places -= 1;
    }
    for _ in 0..places {
        at -= 1;
        buffer[at] = b'0' + (digits % 10) as u8;
        digits /= 10;
    }
    if places > 0 {
        at -= 1;
        buffer[at] = b'.';
    }
    loop {
        at -= 1;
        buffer[at] = b'0' + (digits % 10) as u8;
        digits /= 10;
        if digits == 0 {
            break;
        }
    }
    if negative {
        at -= 1;
        buffer[at] = b'-';
    }
    out.write_all(&buffer[at..])
}

fn write_decimal<W: ?Sized + Write>(out: &mut W, value: f64) -> io::Result<()> {
    out.write_all(decimal(value, PLACES).as_bytes())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(value: f64, expected: &str) {
        assert_eq!(to_string(&value), expected);
    }

    #[test]
    fn numbers_are_plain_decimals() {
        check(0.0, "0");
        check(-0.0, "0");
        check(-1e-12, "0");
        check(1.0, "1");
        check(-2.5, "-2.5");
        check(0.1 + 0.2, "0.3");
        check(1.0 / 3.0, "0.333333333");
        check(1e-7, "0.0000001");
        check(123_456.789, "123456.789");
        check(100.0, "100");
        check(1e16, "10000000000000000");
        check(12_345_678_901.5, "12345678901.5");
        check(f64::NAN, "null");
        check(f64::INFINITY, "null");
    }

    #[test]
    fn a_huge_number_has_no_exponent() {
        let text = to_string(&-1e300);
        assert!(text.starts_with("-1000") && !text.contains('e'), "{text}");
    }
}
