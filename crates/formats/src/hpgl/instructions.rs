//! From bytes to instructions: two letters, and what belongs to them.

/// An instruction of a plotter file.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Instruction<'a> {
    /// Two capital letters.
    pub name: [u8; 2],
    /// The numbers after it.
    pub numbers: Vec<f64>,
    /// The bytes after it, for PE and LB.
    pub bytes: &'a [u8],
    /// Its line, counted from 1.
    pub line: u32,
}

/// Ends the text of LB unless DT says otherwise: ETX.
const END_OF_LABEL: u8 = 3;

/// The instructions of a file, in order. Bytes that are none are passed over, as plotters do; escape
/// sequences of printers too.
pub(super) fn instructions(bytes: &[u8]) -> impl Iterator<Item = Instruction<'_>> {
    let mut words = Words { bytes, at: 0, line: 1, counted: 0, end_of_label: END_OF_LABEL };
    std::iter::from_fn(move || words.next())
}

struct Words<'a> {
    bytes: &'a [u8],
    at: usize,
    line: u32,
    /// Up to here the lines are counted.
    counted: usize,
    end_of_label: u8,
}

impl<'a> Words<'a> {
    fn next(&mut self) -> Option<Instruction<'a>> {
        let name = self.name()?;
        let line = self.line();
        let mut numbers = Vec::new();
        let bytes = match &name {
            b"PE" => self.until(b';'),
            b"LB" => self.until(self.end_of_label),
            b"DT" => self.label_end(),
            b"CO" => self.comment(),
            _ => {
                numbers = self.numbers();
                &[]
            }
        };
        Some(Instruction { name, numbers, bytes, line })
    }

    fn line(&mut self) -> u32 {
        let new = self.bytes[self.counted..self.at].iter().filter(|byte| **byte == b'\n').count();
        self.counted = self.at;
        self.line = self.line.saturating_add(u32::try_from(new).unwrap_or(u32::MAX));
        self.line
    }

    /// Two letters, of which the second may stand behind blanks.
    fn name(&mut self) -> Option<[u8; 2]> {
        loop {
            let first = *self.bytes.get(self.at)?;
            self.at += 1;
            if first == 0x1B {
                self.escape();
            }
            let second = self.bytes.get(self.at).copied().unwrap_or_default();
            if first.is_ascii_alphabetic() && second.is_ascii_alphabetic() {
                self.at += 1;
                return Some([first.to_ascii_uppercase(), second.to_ascii_uppercase()]);
            }
        }
    }

    /// `ESC % 0 B` and its like end with a capital letter, `ESC . (` with the character after the dot and
    /// perhaps numbers and a colon.
    fn escape(&mut self) {
        let dot = self.bytes.get(self.at) == Some(&b'.');
        let rest = &self.bytes[self.at..];
        let numbers = |byte: &u8| byte.is_ascii_digit() || *byte == b';';
        let length = if dot {
            let after = rest.iter().skip(2).take_while(|byte| numbers(byte)).count();
            2 + after + usize::from(rest.get(2 + after) == Some(&b':'))
        } else {
            rest.iter().take(20).position(u8::is_ascii_uppercase).map_or(0, |at| at + 1)
        };
        self.at = (self.at + length).min(self.bytes.len());
    }

    fn until(&mut self, end: u8) -> &'a [u8] {
        let rest = &self.bytes[self.at..];
        let length = rest.iter().position(|byte| *byte == end).unwrap_or(rest.len());
        self.at += (length + 1).min(rest.len());
        &rest[..length]
    }

    fn label_end(&mut self) -> &'a [u8] {
        let said = self.bytes.get(self.at).copied().filter(|byte| *byte != b';');
        self.end_of_label = said.unwrap_or(END_OF_LABEL);
        self.until(b';')
    }

    fn comment(&mut self) -> &'a [u8] {
        if self.bytes.get(self.at) == Some(&b'"') {
            self.at += 1;
            self.until(b'"');
        }
        self.until(b';')
    }

    /// Numbers divided by commas, blanks or their signs, up to what is none.
    fn numbers(&mut self) -> Vec<f64> {
        let mut numbers = Vec::new();
        loop {
            let rest = &self.bytes[self.at..];
            let blank = |byte: &u8| byte.is_ascii_whitespace() || *byte == b',';
            let skipped = rest.iter().take_while(|byte| blank(byte)).count();
            let rest = &rest[skipped..];
            let length = number_length(rest);
            let text = std::str::from_utf8(&rest[..length]).unwrap_or_default();
            match text.parse::<f64>() {
                Ok(number) if number.is_finite() => numbers.push(number),
                _ => return numbers,
            }
            self.at += skipped + length;
        }
    }
}

/// Counts the bytes that belong to the number in front.
fn number_length(bytes: &[u8]) -> usize {
    let sign = usize::from(matches!(bytes.first(), Some(b'-' | b'+')));
    let digit = |byte: &u8| byte.is_ascii_digit() || *byte == b'.';
    sign + bytes.iter().skip(sign).take_while(|byte| digit(byte)).count()
}
