//! Frames on the line.
//!
//! ```text
//!  0x16 0x4b  kind  number (4)  length (2)  payload  CRC-32 of kind … payload (4)      little-endian
//! ```

/// First bytes of a frame.
const MARK: [u8; 2] = [0x16, 0x4b];

/// Bytes of a frame before its payload.
const HEAD: usize = 9;

/// Bytes of a frame beside its payload.
pub const AROUND: usize = HEAD + 4;

/// Bytes of a file in a frame.
pub const BLOCK: usize = 256;

/// A longer payload is none.
const LONGEST: usize = 512;

/// A frame.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Frame {
    /// A file is offered: size and checksum of its bytes.
    Offer { size: u32, crc: u32, name: String },
    /// A piece of the file, counted from 0.
    Block { number: u32, bytes: Vec<u8> },
    /// The receiver has everything before this block.
    Next(u32),
    /// The machine moves.
    Hold,
    /// One end stops; why, in words, or empty when a person did.
    Stop(String),
}

impl Frame {
    /// As bytes.
    pub fn bytes(&self) -> Vec<u8> {
        let (kind, number, payload) = match self {
            Self::Offer { size, crc, name } => {
                (1, *size, [&crc.to_le_bytes(), name.as_bytes()].concat())
            }
            Self::Block { number, bytes } => (2, *number, bytes.clone()),
            Self::Next(number) => (3, *number, Vec::new()),
            Self::Hold => (4, 0, Vec::new()),
            Self::Stop(why) => (5, 0, why.clone().into_bytes()),
        };
        let mut body = vec![kind];
        body.extend(number.to_le_bytes());
        body.extend((payload.len() as u16).to_le_bytes());
        body.extend(payload);
        let crc = crc32fast::hash(&body).to_le_bytes();
        [&MARK[..], &body, &crc].concat()
    }

    fn of(kind: u8, number: u32, payload: &[u8]) -> Option<Self> {
        Some(match kind {
            1 => {
                let (crc, name) = payload.split_first_chunk::<4>()?;
                let name = std::str::from_utf8(name).ok()?.to_owned();
                Self::Offer { size: number, crc: u32::from_le_bytes(*crc), name }
            }
            2 => Self::Block { number, bytes: payload.to_vec() },
            3 => Self::Next(number),
            4 => Self::Hold,
            5 => Self::Stop(String::from_utf8_lossy(payload).into_owned()),
            _ => return None,
        })
    }
}

/// Finds frames in what comes over the line.
#[derive(Debug, Default)]
pub struct Reader {
    heard: Vec<u8>,
}

impl Reader {
    /// More bytes came.
    pub fn hear(&mut self, bytes: &[u8]) {
        self.heard.extend_from_slice(bytes);
    }

    /// The next whole frame; what is none is passed over.
    pub fn next(&mut self) -> Option<Frame> {
        loop {
            let begin = self.heard.iter().position(|byte| *byte == MARK[0])?;
            self.heard.drain(..begin);
            let (kind, number, length) = head(&self.heard)?;
            let end = HEAD + length;
            if self.heard[1] == MARK[1] && length <= LONGEST {
                let crc = self.heard.get(end..end + 4)?;
                let sound = crc32fast::hash(&self.heard[2..end]).to_le_bytes() == crc;
                if let Some(frame) =
                    Frame::of(kind, number, &self.heard[HEAD..end]).filter(|_| sound)
                {
                    self.heard.drain(..end + 4);
                    return Some(frame);
                }
            }
            self.heard.drain(..1);
        }
    }
}

/// Kind, number and length of what may be a frame.
fn head(heard: &[u8]) -> Option<(u8, u32, usize)> {
    let head = heard.first_chunk::<HEAD>()?;
    let number = u32::from_le_bytes([head[3], head[4], head[5], head[6]]);
    Some((head[2], number, usize::from(u16::from_le_bytes([head[7], head[8]]))))
}
