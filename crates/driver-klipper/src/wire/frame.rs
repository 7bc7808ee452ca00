//! Frames: `length, 0x10 | number, content, check number (high byte first), 0x7e`.
//!
//! The length counts the whole frame. From the host a frame carries whole commands, from a board one message or
//! nothing.

use super::crc::crc16;

/// Last byte of each frame.
pub const SYNC: u8 = 0x7e;
/// Bytes of a frame without content.
pub const EMPTY: usize = 5;
/// Most bytes of a frame.
pub const LONGEST: usize = 64;
/// Most bytes of content.
pub const CONTENT: usize = LONGEST - EMPTY;
/// High half of the byte with the number.
const MARK: u8 = 0x10;

/// A frame as it was received.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Frame {
    /// Four bits: from a board, the number of the frame that it expects next.
    pub number: u8,
    /// A message, or nothing.
    pub content: Vec<u8>,
}

/// Returns the bytes of a frame, with the low four bits of a number.
///
/// The content has at most [`CONTENT`] bytes; whoever makes frames sees to it.
pub fn frame(number: u64, content: &[u8]) -> Vec<u8> {
    let mut bytes = vec![(content.len() + EMPTY) as u8, MARK | (number & 0xf) as u8];
    bytes.extend_from_slice(content);
    let crc = crc16(&bytes);
    bytes.extend_from_slice(&crc.to_be_bytes());
    bytes.push(SYNC);
    bytes
}

/// Cuts a stream of bytes into frames. Damaged ones are dropped, with all up to the next `0x7e`.
#[derive(Clone, Debug, Default)]
pub struct Reader {
    /// Bytes that may be the beginning of a frame.
    pending: Vec<u8>,
    /// Everything up to the next `0x7e` is thrown away.
    searching: bool,
    /// Damaged places so far.
    damaged: u64,
}

impl Reader {
    /// Returns the frames that end in these bytes.
    pub fn read(&mut self, bytes: &[u8]) -> Vec<Frame> {
        self.pending.extend_from_slice(bytes);
        let mut frames = Vec::new();
        let mut rest = self.pending.as_slice();
        loop {
            if self.searching {
                let Some(end) = rest.iter().position(|byte| *byte == SYNC) else {
                    rest = &[];
                    break;
                };
                rest = &rest[end + 1..];
                self.searching = false;
            }
            match front(rest) {
                Front::Partial => break,
                Front::Sync => rest = &rest[1..],
                Front::Frame(frame, length) => {
                    frames.push(frame);
                    rest = &rest[length..];
                }
                Front::Damaged => {
                    self.damaged += 1;
                    self.searching = true;
                }
            }
        }
        self.pending = rest.to_vec();
        frames
    }

    /// Damaged places that were met so far.
    pub const fn damaged(&self) -> u64 {
        self.damaged
    }
}

/// The front of a stream of bytes.
enum Front {
    /// Bytes are missing.
    Partial,
    /// A byte that ends a frame, without one.
    Sync,
    /// A whole frame, and its length.
    Frame(Frame, usize),
    /// No frame.
    Damaged,
}

fn front(bytes: &[u8]) -> Front {
    let Some(&length) = bytes.first() else { return Front::Partial };
    if length == SYNC {
        return Front::Sync;
    }
    let length = usize::from(length);
    if !(EMPTY..=LONGEST).contains(&length) || bytes.get(1).is_some_and(|n| n & 0xf0 != MARK) {
        return Front::Damaged;
    }
    let Some(whole) = bytes.get(..length) else { return Front::Partial };
    let (body, end) = whole.split_at(length - 3);
    if end[2] != SYNC || crc16(body).to_be_bytes() != end[..2] {
        return Front::Damaged;
    }
    Front::Frame(Frame { number: body[1] & 0xf, content: body[2..].to_vec() }, length)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(bytes: &[u8], expected: &[(u8, &[u8])]) {
        let found = Reader::default().read(bytes);
        let found: Vec<_> = found.iter().map(|f| (f.number, f.content.as_slice())).collect();
        assert_eq!(found, expected, "{bytes:02x?}");
        let mut reader = Reader::default();
        let singly: Vec<_> = bytes.iter().flat_map(|byte| reader.read(&[*byte])).collect();
        assert_eq!(singly.len(), expected.len(), "byte for byte: {bytes:02x?}");
    }

    #[test]
    fn frames_have_the_bytes_that_boards_understand() {
        assert_eq!(frame(0, &[]), [0x05, 0x10, 0x9e, 0x81, 0x7e]);
        assert_eq!(frame(17, &[]), [0x05, 0x11, 0x8f, 0x08, 0x7e]);
        assert_eq!(frame(0, &[5]), [0x06, 0x10, 0x05, 0x2d, 0xd6, 0x7e]);
        assert_eq!(frame(1, &[8, 8]), [0x07, 0x11, 0x08, 0x08, 0xc9, 0xc1, 0x7e]);
    }

    #[test]
    fn frames_are_found_among_others() {
        let good = frame(3, &[SYNC, 7]);
        check(&good, &[(3, &[SYNC, 7])]);
        check(&[&[SYNC, SYNC][..], &good, &good].concat(), &[(3, &[SYNC, 7]), (3, &[SYNC, 7])]);
        check(&[&b"hello"[..], &[SYNC], &good].concat(), &[(3, &[SYNC, 7])]);
    }

    #[test]
    fn damaged_frames_are_dropped() {
        let good = frame(3, &[1, 2, 3]);
        for at in 0..good.len() * 8 {
            let mut bad = good.clone();
            bad[at / 8] ^= 1 << (at % 8);
            assert_eq!(Reader::default().read(&bad), [], "bit {at}");
        }
    }
}
