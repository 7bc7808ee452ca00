//! The receiver of XMODEM in the fake: one that keeps a packet until the next one is there, and cuts the filling off the last.

use crate::upload::crc;

/// Bytes of XMODEM.
const SOH: u8 = 0x01;
const STX: u8 = 0x02;
const EOT: u8 = 0x04;
const ACK: u8 = 0x06;
const NAK: u8 = 0x15;
const CANCEL: u8 = 0x18;
const FILL: u8 = 0x1a;

/// It rests before its first question, seconds.
const RESTS_S: f64 = 1.0;

/// It waits for a packet so long before it asks once more, seconds; so often.
const ASKS_S: f64 = 2.0;
const ASKS: u32 = 16;

/// A packet of which nothing more comes is spoiled after this, seconds.
const PACKET_S: f64 = 1.0;

/// Silence that ends a spoiled packet which is thrown away, seconds.
const QUIET_S: f64 = 0.1;

/// It takes a packet that it has so often.
const REPEATS: u32 = 3;

/// The way in which it ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// All of the file is there.
    Whole,
    /// There is no room for it.
    Full,
    /// One of the two has given it up.
    GivenUp,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Waits {
    /// For the first byte of a packet.
    Packet,
    /// For the rest of it.
    Rest,
    /// For silence; then the packet is asked for again, or it ends.
    Silence(Option<End>),
}

/// A file that comes.
#[derive(Clone, Debug)]
pub struct Xmodem {
    pub name: String,
    pub content: Vec<u8>,
    /// Bytes for which there is room; nothing for more than anybody sends.
    pub room: Option<usize>,
    held: Vec<u8>,
    next: u8,
    has_begun: bool,
    repeats: u32,
    packet: Vec<u8>,
    cancels: u32,
    waits: Waits,
    /// Time when something came last, or it asked.
    heard_s: Option<f64>,
    asked: u32,
    out: Vec<u8>,
}

impl Xmodem {
    pub const fn new(name: String) -> Self {
        Self {
            name,
            content: Vec::new(),
            room: None,
            held: Vec::new(),
            next: 1,
            has_begun: false,
            repeats: REPEATS,
            packet: Vec::new(),
            cancels: 0,
            waits: Waits::Packet,
            heard_s: None,
            asked: 0,
            out: Vec::new(),
        }
    }

    /// A byte comes.
    pub fn hear(&mut self, byte: u8, now_s: f64) {
        self.heard_s = Some(now_s);
        if self.waits == Waits::Packet {
            self.cancels = if byte == CANCEL { self.cancels + 1 } else { 0 };
        }
        match (self.waits, byte) {
            (Waits::Packet, SOH | STX) => {
                (self.packet, self.waits) = (vec![byte], Waits::Rest);
                self.has_begun = true;
            }
            (Waits::Packet, EOT) => {
                let filled = self.held.iter().rev().take_while(|byte| **byte == FILL).count();
                self.held.truncate(self.held.len() - filled);
                if self.keeps() {
                    self.ends(&[ACK], End::Whole);
                }
            }
            (Waits::Packet, CANCEL) if self.cancels == 2 => self.ends(&[ACK], End::GivenUp),
            (Waits::Rest, _) => self.packet.push(byte),
            _ => {}
        }
    }

    fn ends(&mut self, says: &[u8], end: End) {
        self.out.extend(says);
        self.waits = Waits::Silence(Some(end));
    }

    /// Writes the packet that it has kept; tells whether there was room.
    fn keeps(&mut self) -> bool {
        self.content.append(&mut self.held);
        let has_room = self.room.is_none_or(|room| self.content.len() <= room);
        if !has_room {
            self.ends(&[CANCEL; 3], End::Full);
        }
        has_room
    }

    /// Returns what it says up to a time, and its end. `faults` are how many packets come spoiled, how many do not come at all,
    /// and how many of its answers do not.
    pub fn speak(&mut self, now_s: f64, faults: [&mut u32; 3]) -> (Vec<u8>, Option<End>) {
        let [spoils, loses, mutes] = faults;
        let strikes = |fault: &mut u32| std::mem::replace(fault, fault.saturating_sub(1)) > 0;
        let length = if self.packet.first() == Some(&SOH) { 128 } else { 1024 };
        if self.waits == Waits::Rest && self.packet.len() >= length + 5 {
            self.waits = Waits::Packet;
            if !strikes(loses) {
                let answer = self.packet_comes(length, strikes(spoils));
                self.out.extend(answer.filter(|_| !strikes(mutes)));
            }
        }
        let end = self.passes(now_s);
        (std::mem::take(&mut self.out), end)
    }

    /// A whole packet is there; returns the answer.
    fn packet_comes(&mut self, length: usize, is_spoiled: bool) -> Option<u8> {
        let packet = std::mem::take(&mut self.packet);
        let (bytes, sum) = packet[3..length + 5].split_at(length);
        let is_known = packet[1] == self.next || packet[1] == self.next.wrapping_sub(1);
        let is_right = crc(bytes).to_be_bytes() == sum && packet[1] == !packet[2];
        if is_spoiled || !is_known || !is_right {
            self.waits = Waits::Silence(None);
            return None;
        }
        if packet[1] == self.next {
            if !self.keeps() {
                return None;
            }
            (self.held, self.next) = (bytes.to_vec(), self.next.wrapping_add(1));
            self.repeats = REPEATS + 1;
        }
        self.repeats -= 1;
        if self.repeats == 0 {
            self.ends(&[CANCEL; 3], End::GivenUp);
            return None;
        }
        Some(ACK)
    }

    /// Time passes in which nothing comes.
    fn passes(&mut self, now_s: f64) -> Option<End> {
        // It asks as soon as its rest is over.
        let silent_s = now_s - *self.heard_s.get_or_insert(now_s + RESTS_S - ASKS_S);
        match self.waits {
            Waits::Packet if silent_s >= ASKS_S && self.asked >= 2 * ASKS => {
                self.ends(&[CANCEL; 3], End::GivenUp);
            }
            Waits::Packet if silent_s >= ASKS_S => {
                (self.heard_s, self.asked) = (Some(now_s), self.asked + 1);
                let asks = if self.asked > ASKS { NAK } else { b'C' };
                self.out.extend(Some(asks).filter(|_| !self.has_begun));
            }
            Waits::Rest if silent_s >= PACKET_S => self.waits = Waits::Silence(None),
            Waits::Silence(None) if silent_s >= QUIET_S => {
                self.waits = Waits::Packet;
                self.out.push(NAK);
            }
            Waits::Silence(end) if silent_s >= QUIET_S => return end,
            _ => {}
        }
        None
    }
}
