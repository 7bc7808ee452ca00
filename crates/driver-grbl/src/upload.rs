//! A file on its way to the card of a controller, by the packets of XMODEM and YMODEM.
//!
//! ```text
//!  YMODEM (grblHAL)  ── 0: name, size ──►            the sender begins
//!                    ◄─ ACK, C ──
//!                    ── 1 ──► ◄─ ACK ── …            1024 bytes each; NAK: the packet comes again
//!                    ── EOT ──► ◄─ ACK ──
//!  XMODEM (FluidNC)  ◄─ C ──                         the receiver begins; no packet 0
//!                    ── EOT ──► ◄─ ACK, [MSG:INFO: Received 13 bytes to file …], ok ──
//! ```
//!
//! A packet is `SOH` or `STX`, its number, that number inverted, 128 or 1024 bytes, and their CRC-16.
//!
//! The receiver of XMODEM was told its file by a line, and answers that line when it is through: `ok`, or `error:160` behind a
//! message. Before that it takes no other line, so an upload ends with that answer, whatever it was ended by.

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

/// Opening of a line of words between the answers: a message, a report, `ok`, `error`, `ALARM`.
const WORDS: &[u8] = b"[<oeA";

/// A line longer than this is none.
const LONGEST: usize = 512;

/// Fills the last packet.
const FILL: u8 = 0x1a;

/// A packet is sent so often at most.
const TRIES: u32 = 10;

/// A packet that is not answered is sent again after this, seconds: a receiver that waits says so every second.
const ANSWER_S: f64 = 3.0;

/// Silence after which a receiver counts as gone, seconds.
const SILENT_S: f64 = 12.0;

/// A receiver of XMODEM that has ended answers its line within this, seconds.
const ENDS_S: f64 = 5.0;

/// It is told so often that it is to end, seconds: one that throws the rest of a spoiled packet away does not hear it.
const CANCEL_S: f64 = 1.5;

/// A receiver that lost the first byte of a packet takes the number behind it for [`EOT`], and what follows for lines to be
/// obeyed: behind a packet whose number is that, nothing is sent for so long, in which it would tell of the end, seconds.
const DOUBT_S: f64 = 0.4;

/// Said where a receiver gives up without a reason.
const GIVEN_UP: &str = "the controller has given it up: its card may be full, missing or locked";

/// State of an upload.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Went {
    /// So many bytes are there.
    On(usize),
    /// All of it is there.
    Well,
    /// It is given up, for a reason.
    Wrong(String),
}

/// A file that is sent.
#[derive(Clone, Debug)]
pub(crate) struct Upload {
    content: Vec<u8>,
    /// The packet that comes before the file, with name and size.
    head: Option<Vec<u8>>,
    /// The receiver was told its file by a line, which it answers at the end: XMODEM.
    by_line: bool,
    /// Waits until the receiver is ready.
    waits: bool,
    /// Bytes that are there, and those of the packet on its way.
    done: usize,
    length: usize,
    number: u8,
    tries: u32,
    cancels: u32,
    /// The line of words that comes between the answers.
    words: Vec<u8>,
    /// The packet on its way, or what ends it, has been sent.
    sent_s: Option<f64>,
    heard_s: Option<f64>,
    /// Nothing is sent before this.
    rests_s: f64,
    /// The way in which it is over once the receiver has answered its line, and the moment at which that became known.
    ends: Option<(Went, f64)>,
    /// Somebody has ended it: the receiver is to know.
    is_left: bool,
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
        Self { head: Some(head), by_line: false, waits: false, ..Self::bare(content) }
    }

    /// By XMODEM: the receiver knows the name.
    pub(crate) fn bare(content: Vec<u8>) -> Self {
        Self {
            content,
            head: None,
            by_line: true,
            waits: true,
            done: 0,
            length: 0,
            number: 1,
            tries: 0,
            cancels: 0,
            words: Vec::new(),
            sent_s: None,
            heard_s: None,
            rests_s: 0.0,
            ends: None,
            is_left: false,
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

    /// Somebody has ended it, and the receiver has not answered that yet.
    pub(crate) const fn is_left(&self) -> bool {
        self.is_left
    }

    /// A byte came.
    pub(crate) fn hear(&mut self, byte: u8, now_s: f64) {
        self.heard_s = Some(now_s);
        if self.hears_words(byte, now_s) {
            return;
        }
        self.cancels = if byte == CANCEL { self.cancels + 1 } else { 0 };
        match byte {
            CANCEL if self.cancels == 2 => self.is_over(Went::Wrong(GIVEN_UP.into()), now_s),
            READY if self.waits => self.waits = false,
            ACK if self.sent_s.is_some() && self.ends.is_none() => self.is_there(now_s),
            NAK if self.sent_s.is_some() => self.sent_s = None,
            _ => {}
        }
    }

    /// Takes a byte of a line of words; tells whether it is one. A byte of the protocol ends what looked like one.
    fn hears_words(&mut self, byte: u8, now_s: f64) -> bool {
        if self.words.is_empty() && !WORDS.contains(&byte) {
            return false;
        }
        match byte {
            b'\n' => {
                let line = String::from_utf8_lossy(&std::mem::take(&mut self.words)).into_owned();
                self.hears_line(line.trim(), now_s);
            }
            b'\r' | b'\t' | b' '.. if self.words.len() < LONGEST => self.words.push(byte),
            _ => {
                self.words.clear();
                return false;
            }
        }
        true
    }

    /// Takes a line that a receiver of XMODEM tells when it is through.
    fn hears_line(&mut self, line: &str, now_s: f64) {
        if !self.by_line {
            return;
        }
        let early = || Went::Wrong("the controller ended it before all of it was there".into());
        if let Some(why) = line.strip_prefix("[MSG:").and_then(|told| self.told_end(told)) {
            let is_known = |went: &Went| matches!(went, Went::Wrong(why) if why != GIVEN_UP);
            if !self.ends.as_ref().is_some_and(|(went, _)| is_known(went)) {
                self.ends = Some((Went::Wrong(why), now_s));
            }
        } else if line == "ok" {
            self.went = Some(self.ends.take().map_or_else(early, |(went, _)| went));
        } else if let Some(number) = line.strip_prefix("error:") {
            let refused = || Went::Wrong(format!("the controller refused it: error {number}"));
            let ends = self.ends.take().map(|(went, _)| went).filter(|went| *went != Went::Well);
            self.went = Some(ends.unwrap_or_else(refused));
        }
    }

    /// Returns what is wrong by a message of a receiver that has ended; nothing where it is right, or none.
    fn told_end(&self, told: &str) -> Option<String> {
        let size = self.content.len();
        if let Some((_, rest)) = told.split_once("Received ") {
            let came: usize = rest.split(' ').next()?.parse().ok()?;
            return (came != size).then(|| format!("{came} of {size} bytes have come there"));
        }
        let opens =
            "it cannot open the file: its card is missing or locked, or the folder is not there";
        [("Cannot open", opens), ("free space", "its card is full")]
            .into_iter()
            .find_map(|(known, why)| told.contains(known).then(|| why.to_owned()))
    }

    /// It is over, as soon as the receiver has answered its line.
    fn is_over(&mut self, went: Went, now_s: f64) {
        match self.by_line {
            true => self.ends = self.ends.take().or(Some((went, now_s))),
            false => self.went = Some(went),
        }
    }

    /// The packet on its way is there.
    fn is_there(&mut self, now_s: f64) {
        (self.sent_s, self.tries) = (None, 0);
        if self.head.take().is_some() {
            return;
        }
        if self.done == self.content.len() {
            self.is_over(Went::Well, now_s);
        }
        if self.by_line && [self.number, !self.number].contains(&EOT) {
            self.rests_s = now_s + DOUBT_S;
        }
        self.done += self.length;
        self.number = self.number.wrapping_add(1);
    }

    /// Returns what is to be sent now.
    pub(crate) fn speak(&mut self, now_s: f64) -> Vec<u8> {
        let silent_s = now_s - *self.heard_s.get_or_insert(now_s);
        if self.went.is_some() || self.ends.is_some() {
            return self.ends(now_s);
        }
        if silent_s > SILENT_S {
            self.went = Some(Went::Wrong("the controller does not answer".into()));
            return vec![CANCEL; 2];
        }
        if self.tries > TRIES {
            let why = "too much was spoiled on its way: look at the cable";
            return self.cancel(why, now_s);
        }
        let is_due = self.sent_s.is_none_or(|sent_s| now_s - sent_s > ANSWER_S);
        if self.waits || !is_due || now_s < self.rests_s {
            return Vec::new();
        }
        (self.sent_s, self.tries) = (Some(now_s), self.tries + 1);
        self.packet()
    }

    /// Waits for the answer to the line of a receiver, and tells it again that it is to end.
    fn ends(&mut self, now_s: f64) -> Vec<u8> {
        let late = self.ends.take_if(|(_, since_s)| now_s - *since_s > ENDS_S);
        self.went = self.went.take().or(late.map(|(went, _)| went));
        let is_due = self.sent_s.is_none_or(|sent_s| now_s - sent_s > CANCEL_S);
        if self.went.is_some() || !self.is_left || !is_due {
            return Vec::new();
        }
        self.sent_s = Some(now_s);
        vec![CANCEL; 2]
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

    /// Ends it before all of it is there; returns what tells the receiver.
    pub(crate) fn cancel(&mut self, why: &str, now_s: f64) -> Vec<u8> {
        self.is_over(Went::Wrong(why.to_owned()), now_s);
        (self.is_left, self.sent_s) = (true, Some(now_s));
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
        assert_eq!(silent.went(), Went::Wrong("the controller does not answer".into()));
        let mut full = Upload::named("a.nc", vec![0; 4]);
        full.speak(0.0);
        [CANCEL, CANCEL].into_iter().for_each(|byte| full.hear(byte, 0.1));
        assert!(matches!(full.went(), Went::Wrong(why) if why.contains("full")));
    }

    fn told(upload: &mut Upload, words: &[u8], now_s: f64) {
        words.iter().for_each(|byte| upload.hear(*byte, now_s));
    }

    #[test]
    fn a_receiver_of_xmodem_is_through_when_it_has_answered_its_line() {
        let check = |words: &[u8], went: Result<(), &str>| {
            let mut upload = Upload::bare(b"G0X1\n".to_vec());
            // A report that was asked for before has the letter of its question in it.
            told(&mut upload, b"<Idle|WCO:0,0,0>\r\n", 0.0);
            assert!(upload.speak(0.0).is_empty());
            told(&mut upload, b"C", 0.1);
            assert_eq!(upload.speak(0.1).len(), 133);
            told(&mut upload, &[ACK], 0.2);
            assert_eq!(upload.speak(0.2), [EOT]);
            told(&mut upload, &[ACK], 0.3);
            assert_eq!(upload.went(), Went::On(5), "its answer is still to come");
            told(&mut upload, words, 0.4);
            upload.speak(6.0);
            match (upload.went(), went) {
                (Went::Well, Ok(())) => {}
                (Went::Wrong(why), Err(known)) => assert!(why.contains(known), "{why}"),
                (went, _) => panic!("{went:?}"),
            }
        };
        check(b"[MSG:INFO: Received 5 bytes to file /sd/a.nc]\r\nok\r\n", Ok(()));
        check(b"", Ok(()));
        check(
            b"[MSG:INFO: Received 4 bytes to file /sd/a.nc]\r\nok\r\n",
            Err("4 of 5 bytes have come there"),
        );
    }

    #[test]
    fn a_receiver_that_takes_a_number_for_the_end_is_heard_before_more_is_sent() {
        let mut upload = Upload::bare(vec![b'\n'; 8000]);
        told(&mut upload, b"C", 0.0);
        for _ in 0..4 {
            assert_eq!(upload.speak(0.1).len(), 1029);
            told(&mut upload, &[ACK], 0.1);
        }
        // Behind packet 4 what comes next would be lines that move the machine.
        assert!(upload.speak(0.3).is_empty());
        let mut goes_on = upload.clone();
        assert_eq!(goes_on.speak(0.6).len(), 1029);
        told(&mut upload, b"[MSG:INFO: Received 3072 bytes to file /sd/a.nc]\r\nok\r\n", 0.4);
        assert!(upload.speak(0.6).is_empty());
        assert!(matches!(upload.went(), Went::Wrong(why) if why.contains("3072 of 8000")));
    }

    #[test]
    fn a_receiver_that_does_not_hear_the_end_is_told_again() {
        let mut upload = Upload::bare(vec![b'\n'; 8000]);
        told(&mut upload, b"C", 0.0);
        upload.speak(0.1);
        assert_eq!(upload.cancel("it was stopped", 0.2), [CANCEL; 2]);
        assert!(upload.speak(0.3).is_empty());
        told(&mut upload, &[NAK], 0.4);
        assert_eq!(upload.speak(0.4), [CANCEL; 2]);
        assert_eq!(upload.went(), Went::On(0));
        told(
            &mut upload,
            b"\x06[MSG:INFO: Reception failed or was canceled]\r\nerror:160\r\n",
            0.5,
        );
        assert_eq!(upload.went(), Went::Wrong("it was stopped".into()));
    }

    #[test]
    fn a_spoiled_answer_that_looks_like_words_does_not_swallow_the_next() {
        let mut upload = Upload::bare(vec![b'\n'; 8000]);
        told(&mut upload, b"C", 0.0);
        upload.speak(0.1);
        told(&mut upload, b"e", 0.2);
        upload.speak(3.2);
        told(&mut upload, &[ACK], 3.3);
        assert_eq!(upload.went(), Went::On(1024));
    }
}
