//! The fast road: lines of G0 … G3 with literal values.
//!
//! Files of a million such lines are common, so they are read in one pass over their bytes, with
//! no allocation. Everything unusual is left to the careful road, which gives the same meaning.

use super::plain_move::PlainMove;
use super::text::is_blank;

/// Reads the line that begins at `start` if it is a plain move, and gives the end of the line. What is read of
/// a line that is something else means nothing.
pub(crate) fn read(bytes: &[u8], start: usize, found: &mut PlainMove) -> Option<usize> {
    line::<true>(bytes, start, found)
}

/// The same without the values, which nobody needs before the move is made.
pub(super) fn end(bytes: &[u8], start: usize, found: &mut PlainMove) -> Option<usize> {
    line::<false>(bytes, start, found)
}

fn line<const VALUES: bool>(bytes: &[u8], start: usize, found: &mut PlainMove) -> Option<usize> {
    let mut scan = Scan { bytes, at: start };
    scan.blanks();
    if scan.peek() | 0x20 == b'n' {
        scan.at += 1;
        scan.digits()?;
        scan.blanks();
    }
    found.clear();
    loop {
        let byte = scan.peek();
        if matches!(byte, b'\n' | b'\r') {
            break;
        }
        scan.at += 1;
        if byte | 0x20 == b'g' {
            if found.motion != PlainMove::MODAL {
                return None;
            }
            found.motion = scan.motion()?;
        } else {
            let slot = usize::from(SLOTS[usize::from(byte)]);
            if slot >= PlainMove::LETTERS.len() {
                return None;
            }
            scan.blanks();
            let value = scan.signed(VALUES || slot >= FIRST_RATE)?;
            if value < 0.0 && slot >= FIRST_RATE {
                return None;
            }
            found.give(slot, value)?;
        }
        if scan.skipped_blank() && matches!(scan.peek(), b'0'..=b'9' | b'.') {
            return None;
        }
    }
    (found.given != 0).then_some(scan.at)
}

/// F and S stand behind this place in [`PlainMove::LETTERS`]; they may not be negative.
const FIRST_RATE: usize = 10;

/// No letter of a move.
const NONE: u8 = 0xFF;

/// The place of each letter in [`PlainMove::LETTERS`].
const SLOTS: [u8; 256] = {
    let mut slots = [NONE; 256];
    let mut i = 0;
    while i < PlainMove::LETTERS.len() {
        slots[PlainMove::LETTERS[i] as usize] = i as u8;
        slots[(PlainMove::LETTERS[i] | 0x20) as usize] = i as u8;
        i += 1;
    }
    slots
};

struct Scan<'a> {
    bytes: &'a [u8],
    at: usize,
}

/// Powers of ten that a double holds exactly.
const TENS: [f64; 16] =
    [1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15];

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

    fn skipped_blank(&mut self) -> bool {
        let before = self.at;
        self.blanks();
        self.at > before
    }

    fn digits(&mut self) -> Option<()> {
        let start = self.at;
        while self.peek().is_ascii_digit() {
            self.at += 1;
        }
        (self.at > start && self.peek() != b'.').then_some(())
    }

    /// 0 … 3 behind a G.
    fn motion(&mut self) -> Option<u8> {
        self.blanks();
        self.at += usize::from(
            self.peek() == b'0' && self.bytes.get(self.at + 1).is_some_and(u8::is_ascii_digit),
        );
        let motion = self.peek().wrapping_sub(b'0');
        self.at += 1;
        (motion < 4 && !matches!(self.peek(), b'0'..=b'9' | b'.')).then_some(motion)
    }

    /// A number with its sign; without its value, 0 in place of it.
    fn signed(&mut self, valued: bool) -> Option<f64> {
        let negative = self.peek() == b'-';
        self.at += usize::from(negative || self.peek() == b'+');
        if valued {
            let magnitude = number(self.bytes, &mut self.at)?;
            return Some(if negative { -magnitude } else { magnitude });
        }
        match Short::read(self.bytes, self.at) {
            Some(short) => self.at = short.end,
            None => _ = number(self.bytes, &mut self.at)?,
        }
        Some(0.0)
    }
}

/// A number of at most seven digits before the point and seven behind it, read eight bytes at a time.
struct Short {
    whole: Digits,
    fraction: Digits,
    end: usize,
}

impl Short {
    /// `None` when it is longer, no number, or too close to the end of the text.
    fn read(bytes: &[u8], start: usize) -> Option<Self> {
        let whole = Digits::at(bytes, start)?;
        let mut end = start + whole.count;
        let mut fraction = Digits { bytes: 0, count: 0 };
        if bytes.get(end) == Some(&b'.') {
            fraction = Digits::at(bytes, end + 1)?;
            end += 1 + fraction.count;
        }
        (whole.count + fraction.count > 0).then_some(Self { whole, fraction, end })
    }

    /// Exact: its digits and the power of ten fit a double, so one division rounds rightly.
    fn value(&self) -> f64 {
        if self.fraction.count == 0 {
            return self.whole.value() as f64;
        }
        let ten = TENS[self.fraction.count];
        (self.whole.value() as f64 * ten + self.fraction.value() as f64) / ten
    }
}

/// Up to seven digits.
#[derive(Clone, Copy)]
struct Digits {
    /// The value of each digit in a byte of its own, the first one lowest; rubbish behind them.
    bytes: u64,
    count: usize,
}

impl Digits {
    /// The digits that begin at a byte; `None` when there are eight or more.
    fn at(text: &[u8], start: usize) -> Option<Self> {
        let eight = u64::from_le_bytes(*text.get(start..)?.first_chunk()?);
        let bytes = eight ^ 0x3030_3030_3030_3030;
        // The high bit of every byte above 9, up to the first such byte at least: a carry comes only
        // out of one that is above.
        let other = (bytes.wrapping_add(0x7676_7676_7676_7676) | bytes) & 0x8080_8080_8080_8080;
        let count = other.trailing_zeros() as usize / 8;
        (count < 8).then_some(Self { bytes, count })
    }

    /// Neighbours are put together: digits to pairs, pairs to fours, fours to all eight.
    fn value(self) -> u64 {
        if self.count == 0 {
            return 0;
        }
        let digits = self.bytes << (64 - 8 * self.count);
        let pairs = digits.wrapping_mul(10).wrapping_add(digits >> 8) & 0x00FF_00FF_00FF_00FF;
        let fours = pairs.wrapping_mul(100).wrapping_add(pairs >> 16) & 0x0000_FFFF_0000_FFFF;
        fours.wrapping_mul(10_000).wrapping_add(fours >> 32) & 0xFFFF_FFFF
    }
}

/// Reads an unsigned decimal number without exponent at `at` and goes behind it.
pub(super) fn number(bytes: &[u8], at: &mut usize) -> Option<f64> {
    if let Some(short) = Short::read(bytes, *at) {
        *at = short.end;
        return Some(short.value());
    }
    let start = *at;
    let (mut digits, mut places) = (0u64, 0);
    let mut here = start;
    while let Some(d) = digit(bytes, here) {
        digits = digits.wrapping_mul(10).wrapping_add(d);
        here += 1;
    }
    let mut count = here - start;
    if bytes.get(here) == Some(&b'.') {
        here += 1;
        let fraction = here;
        while let Some(d) = digit(bytes, here) {
            digits = digits.wrapping_mul(10).wrapping_add(d);
            here += 1;
        }
        places = here - fraction;
        count += places;
    }
    if count == 0 {
        return None;
    }
    *at = here;
    // Up to 15 digits fit a double and so does the power of ten: one division rounds rightly
    // (Clinger, How to read floating point numbers accurately, 1990).
    if count <= 15 {
        return Some(digits as f64 / TENS[places]);
    }
    let value: f64 = fast_float2::parse(&bytes[start..here]).ok()?;
    value.is_finite().then_some(value)
}

fn digit(bytes: &[u8], at: usize) -> Option<u64> {
    let d = bytes.get(at)?.wrapping_sub(b'0');
    (d < 10).then_some(u64::from(d))
}

#[cfg(test)]
mod tests {
    use super::number;

    #[test]
    fn numbers_of_every_length_are_read_rightly() {
        let digits = "9876543210123456789";
        for whole in 0..=12 {
            for places in 0..=12 {
                for tail in ["", " ", "Y1 Z2 A345", ".5", "\n:::::::", "/////////"] {
                    let point = if places > 0 { "." } else { "" };
                    let text = format!("{}{point}{}", &digits[..whole], &digits[3..3 + places]);
                    let (line, mut at) = (format!("{text}{tail}"), 0);
                    let found = number(line.as_bytes(), &mut at);
                    if tail == ".5" && places == 0 {
                        assert_eq!(found, format!("0{text}.5").parse().ok(), "{line}");
                        continue;
                    }
                    let expected =
                        if text.is_empty() { None } else { format!("0{text}").parse().ok() };
                    assert_eq!((found, at), (expected, text.len()), "{line}");
                }
            }
        }
    }
}
