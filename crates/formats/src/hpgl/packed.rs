//! PE, the packed polyline of HPGL/2: numbers of base 64 (32 in the mode of seven bits), the lowest bit
//! their sign, with flags between them.

use kerf_geom::Vec2;

/// A step of a packed polyline.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Step {
    /// Another pen.
    Pen(f64),
    /// A move, with the pen down or up, to a place or by a distance.
    Move { down: bool, absolute: bool, by: Vec2 },
}

/// The steps of a packed polyline, as far as it can be read.
pub(super) fn steps(bytes: &[u8]) -> Vec<Step> {
    let mut reader = Reader { bytes, at: 0, seven_bits: false, fraction_bits: 0 };
    let (mut steps, mut down, mut absolute) = (Vec::new(), true, false);
    while let Some(flag) = reader.peek() {
        match flag {
            b'<' => (down, reader.at) = (false, reader.at + 1),
            b'=' => (absolute, reader.at) = (true, reader.at + 1),
            b'7' => (reader.seven_bits, reader.at) = (true, reader.at + 1),
            b':' => {
                reader.at += 1;
                let Some(pen) = reader.whole() else { break };
                steps.push(Step::Pen(pen));
            }
            b'>' => {
                reader.at += 1;
                let Some(bits) = reader.whole() else { break };
                reader.fraction_bits = bits.clamp(0.0, 26.0) as i32;
            }
            _ => {
                let (Some(x), Some(y)) = (reader.length(), reader.length()) else { break };
                steps.push(Step::Move { down, absolute, by: Vec2::new(x, y) });
                (down, absolute) = (true, false);
            }
        }
    }
    steps
}

struct Reader<'a> {
    bytes: &'a [u8],
    at: usize,
    seven_bits: bool,
    fraction_bits: i32,
}

/// More digits than a plotter has places for.
const MOST_DIGITS: i32 = 10;

impl Reader<'_> {
    /// The next byte that counts: blanks and what is below the digits do not.
    fn peek(&mut self) -> Option<u8> {
        while self.bytes.get(self.at).is_some_and(|byte| *byte & 0x7F <= b' ') {
            self.at += 1;
        }
        self.bytes.get(self.at).copied()
    }

    fn length(&mut self) -> Option<f64> {
        Some(self.whole()? / 2f64.powi(self.fraction_bits))
    }

    /// Digits, the lowest first. A digit of the upper half of the alphabet is the last.
    fn whole(&mut self) -> Option<f64> {
        let (base, last_from) = if self.seven_bits { (32.0, 95) } else { (64.0, 191) };
        let mut value = 0.0;
        for place in 0..MOST_DIGITS {
            let byte = self.peek()? & if self.seven_bits { 0x7F } else { 0xFF };
            self.at += 1;
            let last = byte >= last_from;
            let digit = byte.checked_sub(if last { last_from } else { 63 })?;
            value += f64::from(digit) * f64::powi(base, place);
            if last {
                let size = (value / 2.0).floor();
                return Some(if value % 2.0 == 0.0 { size } else { -size });
            }
        }
        None
    }
}
