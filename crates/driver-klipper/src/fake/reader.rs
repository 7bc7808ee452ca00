//! The board's end of the line: which frames it runs, and what it says to the others.

/// The check number, bit by bit.
pub fn crc(bytes: &[u8]) -> u16 {
    let mut crc = 0xffff_u16;
    for byte in bytes {
        crc ^= u16::from(*byte);
        for _ in 0..8 {
            crc = if crc & 1 == 1 { crc >> 1 ^ 0x8408 } else { crc >> 1 };
        }
    }
    crc
}

#[derive(Clone, Debug, Default)]
pub struct Reader {
    bytes: Vec<u8>,
    searching: bool,
    pub expected: u8,
}

/// A piece of what came.
#[derive(Clone, Debug, PartialEq)]
pub enum Piece {
    /// A frame in order, with its content. The number has been counted in.
    Run(Vec<u8>),
    /// To be answered with the number expected.
    Nak,
}

impl Reader {
    pub fn feed(&mut self, bytes: &[u8]) {
        self.bytes.extend_from_slice(bytes);
    }

    /// Drops what came together with a command that shut the board down.
    pub fn lose(&mut self) {
        self.bytes.clear();
    }

    pub fn piece(&mut self) -> Option<Piece> {
        loop {
            if self.searching {
                let Some(at) = self.bytes.iter().position(|b| *b == 0x7e) else {
                    self.bytes.clear();
                    return None;
                };
                self.bytes.drain(..=at);
                self.searching = false;
            }
            let length = usize::from(*self.bytes.first()?);
            if length == 0x7e {
                self.bytes.remove(0);
                continue;
            }
            let wrong = !(5..=64).contains(&length)
                || self.bytes.get(1).is_some_and(|number| number >> 4 != 1);
            if !wrong && self.bytes.len() < length {
                return None;
            }
            if wrong || !self.sound(length) {
                self.searching = true;
                return Some(Piece::Nak);
            }
            let frame: Vec<u8> = self.bytes.drain(..length).collect();
            if frame[1] & 0xf != self.expected {
                return Some(Piece::Nak);
            }
            self.expected = (self.expected + 1) % 16;
            return Some(Piece::Run(frame[2..length - 3].to_vec()));
        }
    }

    fn sound(&self, length: usize) -> bool {
        let frame = &self.bytes[..length];
        let told = u16::from(frame[length - 3]) << 8 | u16::from(frame[length - 2]);
        frame[length - 1] == 0x7e && crc(&frame[..length - 3]) == told
    }

    pub fn frame(&self, content: &[u8]) -> Vec<u8> {
        let mut frame = vec![content.len() as u8 + 5, 0x10 + self.expected];
        frame.extend(content);
        let crc = crc(&frame);
        frame.extend([(crc >> 8) as u8, crc as u8, 0x7e]);
        frame
    }
}
