//! A file on its way to the card of a controller, by the packets of XMODEM and YMODEM.
//!
//! ```text
//!  YMODEM (grblHAL)  ── 0: name, size ──►            the sender begins
//!                    ◄─ ACK, C ──
//!                    ── 1 ──► ◄─ ACK ── …            1024 bytes each; NAK: the packet comes again
//!                    ── EOT ──► ◄─ ACK ──
//!  XMODEM (FluidNC)  ◄─ C ──                         the receiver begins; no packet 0
//! ```
//!
//! A packet is `SOH` or `STX`, its number, that number inverted, 128 or 1024 bytes, and their CRC-16.

/// Begins a packet of 128 bytes, and one of 1024.
const SOH: u8 = 0x01;
const STX: u8 = 0x02;

/// Ends a file.
const EOT: u8 = 0x04;

/// Answers to a packet: it is right, it is spoiled; and the end from either side, twice.
const ACK: u8 = 0x06;
const NAK: u8 = 0x15;
const CANCEL: u8 = 0x18;

/// The receiver of XMODEM is ready.
const READY: u8 = b'C';

/// Bytes of a short packet and of a long one.
const SHORT: usize = 128;
const LONG: usize = 1024;

/// Fills the last packet.
const FILL: u8 = 0x1a;

/// A packet is sent so often at most.
const TRIES: u32 = 10;

/// A packet that is not answered is sent again after this, seconds: a receiver that waits says so every second.
const ANSWER_S: f64 = 3.0;

/// Whoever says nothing for so long is gone, seconds.
const SILENT_S: f64 = 12.0;

/// State of an upload.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Went {
    /// So many bytes are there.
    On(usize),
    /// All of it is there.
    Well,
    /// It is given up, for a reason.
    Wrong(&'static str),
}

/// A file that is sent.
#[derive(Clone, Debug)]
pub(crate) struct Upload {
    content: Vec<u8>,
    /// The packet that comes before the file, with name and size.
    head: Option<Vec<u8>>,
    /// Waits until the receiver is ready.
    waits: bool,
    /// Bytes that are there, and those of the packet on its way.
    done: usize,
    length: usize,
    number: u8,
    tries: u32,
    cancels: u32,
    /// A line of text comes between the answers.
    in_words: bool,
    /// The packet on its way has been sent.
    sent_s: Option<f64>,
    heard_s: Option<f64>,
    went: Option<Went>,
}

impl Upload {
    /// By YMODEM: the name goes with the file.
    pub(crate) fn named(name: &str, content: Vec<u8>) -> Self {
        let mut head = name.as_bytes().to_vec();
        head.push(0);
        head.extend(content.len().to_string().bytes());
        head.push(0);
        head.resize(SHORT, 0);
        Self { head: Some(head), waits: false, ..Self::bare(content) }
    }

    /// By XMODEM: the receiver knows the name.
    pub(crate) fn bare(content: Vec<u8>) -> Self {
        Self {
            content,
            head: None,
            waits: true,
            done: 0,
            length: 0,
            number: 1,
            tries: 0,
            cancels: 0,
            in_words: false,
            sent_s: None,
            heard_s: None,
            went: None,
        }
    }

    /// Size of the file, bytes.
    pub(crate) const fn size(&self) -> usize {
        self.content.len()
    }

    /// Returns how it went so far.
    pub(crate) fn went(&self) -> Went {
        self.went.clone().unwrap_or(Went::On(self.done))
    }

    /// A byte came.
    pub(crate) fn hear(&mut self, byte: u8, now_s: f64) {
        self.heard_s = Some(now_s);
        if self.in_words || byte == b'[' {
            self.in_words = byte != b'\n';
            return;
        }
        self.cancels = if byte == CANCEL { self.cancels + 1 } else { 0 };
        match byte {
            CANCEL if self.cancels > 1 => {
                self.went = Some(Went::Wrong(
                    "the controller has given it up: its card may be full, missing or locked",
                ));
            }
            READY if self.waits => self.waits = false,
            ACK if self.sent_s.is_some() => self.is_there(),
            NAK if self.sent_s.is_some() => self.sent_s = None,
            _ => {}
        }
    }

    /// The packet on its way is there.
    fn is_there(&mut self) {
        (self.sent_s, self.tries) = (None, 0);
        if self.head.take().is_some() {
            return;
        }
        if self.done == self.content.len() {
            self.went = Some(Went::Well);
        }
        self.done += self.length;
        self.number = self.number.wrapping_add(1);
    }

    /// Returns what is to be sent now.
    pub(crate) fn speak(&mut self, now_s: f64) -> Vec<u8> {
        let silent_s = now_s - *self.heard_s.get_or_insert(now_s);
        if self.went.is_none() && (silent_s > SILENT_S || self.tries > TRIES) {
            self.went = Some(Went::Wrong(match silent_s > SILENT_S {
                true => "the controller does not answer",
                false => "too much was spoiled on its way: look at the cable",
            }));
            return vec![CANCEL; 2];
        }
        let is_due = self.sent_s.is_none_or(|sent_s| now_s - sent_s > ANSWER_S);
        if self.went.is_some() || self.waits || !is_due {
            return Vec::new();
        }
        (self.sent_s, self.tries) = (Some(now_s), self.tries + 1);
        self.packet()
    }

    /// The packet on its way: the head, a piece of the file, or its end.
    fn packet(&mut self) -> Vec<u8> {
        if let Some(head) = &self.head {
            return packet(0, head);
        }
        let rest = &self.content[self.done..];
        self.length = rest.len().min(if rest.len() > SHORT { LONG } else { SHORT });
        if rest.is_empty() {
            return vec![EOT];
        }
        let mut bytes = rest[..self.length].to_vec();
        bytes.resize(if self.length > SHORT { LONG } else { SHORT }, FILL);
        packet(self.number, &bytes)
    }

    /// Returns what ends it before all of it is there.
    pub(crate) fn cancel(&mut self) -> Vec<u8> {
        self.went = Some(Went::Wrong("it was stopped"));
        vec![CANCEL; 2]
    }
}

fn packet(number: u8, bytes: &[u8]) -> Vec<u8> {
    let mut packet = vec![if bytes.len() == LONG { STX } else { SOH }, number, !number];
    packet.extend(bytes);
    packet.extend(crc(bytes).to_be_bytes());
    packet
}

/// Returns `true` for an answer to a packet, which belongs to no line.
pub(crate) const fn is_receipt(byte: u8) -> bool {
    matches!(byte, ACK | NAK | CANCEL)
}

/// CRC-16 of XMODEM: the polynomial x¹⁶ + x¹² + x⁵ + 1, from 0.
pub(crate) fn crc(bytes: &[u8]) -> u16 {
    bytes.iter().fold(0, |crc, byte| {
        (0..8).fold(crc ^ u16::from(*byte) << 8, |crc, _| {
            if crc & 0x8000 == 0 { crc << 1 } else { crc << 1 ^ 0x1021 }
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_checksum_is_that_of_the_protocol() {
        assert_eq!(crc(b"123456789"), 0x31c3);
    }

    #[test]
    fn a_packet_comes_again_when_it_was_spoiled_or_is_not_answered() {
        let mut upload = Upload::named("a.nc", vec![b'G'; 1100]);
        let head = upload.speak(0.0);
        assert_eq!((head.len(), &head[..12]), (133, &b"\x01\x00\xffa.nc\x001100"[..]));
        upload.hear(NAK, 0.1);
        assert_eq!(upload.speak(0.1), head);
        assert!(upload.speak(3.0).is_empty(), "it waits for an answer");
        assert_eq!(upload.speak(3.2), head);
        [ACK, READY].into_iter().for_each(|byte| upload.hear(byte, 3.3));
        assert_eq!(upload.speak(3.3).len(), 1029);
        upload.hear(ACK, 3.4);
        assert_eq!(upload.went(), Went::On(1024));
        assert_eq!(upload.speak(3.4)[..3], [SOH, 2, 253]);
        upload.hear(ACK, 3.5);
        assert_eq!(upload.speak(3.5), [EOT]);
        upload.hear(ACK, 3.6);
        assert_eq!(upload.went(), Went::Well);
    }

    #[test]
    fn a_receiver_begins_where_it_knows_the_name_and_its_words_are_no_answers() {
        let mut upload = Upload::bare(b"G0X1\n".to_vec());
        assert!(upload.speak(0.0).is_empty());
        b"[MSG:INFO: Card]\n".iter().for_each(|byte| upload.hear(*byte, 0.1));
        assert!(upload.speak(0.1).is_empty());
        upload.hear(READY, 0.2);
        assert_eq!(upload.speak(0.2)[..3], [SOH, 1, 254]);
    }

    #[test]
    fn silence_and_a_receiver_that_gives_up_end_it() {
        let mut silent = Upload::named("a.nc", vec![0; 4]);
        let sent: usize = (0..200).map(|tick| silent.speak(f64::from(tick) * 0.1).len()).sum();
        assert_eq!(sent, 4 * 133 + 2);
        assert_eq!(silent.went(), Went::Wrong("the controller does not answer"));
        let mut full = Upload::named("a.nc", vec![0; 4]);
        full.speak(0.0);
        [CANCEL, CANCEL].into_iter().for_each(|byte| full.hear(byte, 0.1));
        assert!(matches!(full.went(), Went::Wrong(why) if why.contains("full")));
    }
}
