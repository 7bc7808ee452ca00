//! The card of the fake: files that it lists, takes, deletes, and runs by itself; its words and YMODEM are those of grblHAL.

use super::xmodem::Xmodem;
use crate::upload::crc;
use std::collections::BTreeMap;

/// Bytes of YMODEM.
const SOH: u8 = 0x01;
const STX: u8 = 0x02;
const EOT: u8 = 0x04;
const ACK: u8 = 0x06;
const NAK: u8 = 0x15;
const CANCEL: u8 = 0x18;

/// A receiver that hears nothing asks again after this, seconds.
const ASKS_S: f64 = 1.0;

/// It gives up after so many questions.
const ASKS: u32 = 10;

/// Its refusals: a file that cannot be opened, one that cannot be deleted, and a card that is not there.
const NO_FILE: u16 = 84;
const NOT_DELETED: u16 = 61;
const NO_CARD: u16 = 64;

/// Its refusal while it moves.
const BUSY: u16 = 8;

/// The card.
#[derive(Clone, Debug, Default)]
pub struct Card {
    /// Files by their names.
    pub files: BTreeMap<String, Vec<u8>>,
    /// It is taken out.
    pub is_out: bool,
    /// Bytes that it can take; nothing for more than anybody sends.
    pub room: Option<usize>,
    /// Packets of a file that it takes to be spoiled, for tests.
    pub spoils: u32,
    /// Packets that do not come through to it, for tests (XMODEM).
    pub loses: u32,
    /// Answers to packets that do not come through from it, for tests (XMODEM).
    pub mutes: u32,
    /// It has the words of `FluidNC`.
    pub(super) fluid: bool,
    /// A file that comes by XMODEM.
    pub(super) xmodem: Option<Xmodem>,
    running: Option<Running>,
    receiving: Option<Receiving>,
}

/// A file that is run.
#[derive(Clone, Debug)]
struct Running {
    name: String,
    content: Vec<u8>,
    read: usize,
    line: u32,
}

/// A file that comes.
#[derive(Clone, Debug, Default)]
struct Receiving {
    packet: Vec<u8>,
    name: Option<String>,
    size: usize,
    content: Vec<u8>,
    next: u8,
    heard_s: f64,
    asked: u32,
    /// The rest of a spoiled packet is thrown away.
    purges: bool,
}

impl Card {
    pub(super) fn with(files: &[(&str, &str)]) -> Self {
        let files = files.iter().map(|(name, text)| ((*name).into(), text.as_bytes().to_vec()));
        Self { files: files.collect(), ..Self::default() }
    }

    pub(super) fn of_fluid(self) -> Self {
        Self { fluid: true, ..self }
    }

    /// The reset of the controller ends what is run.
    pub(super) fn ends(&mut self) {
        (self.running, self.receiving, self.xmodem) = (None, None, None);
    }

    pub(super) const fn runs(&self) -> bool {
        self.running.is_some()
    }

    /// The line that is run next; nothing at the end of the file.
    pub(super) fn next_line(&mut self) -> Option<String> {
        let running = self.running.as_mut()?;
        let rest = &running.content[running.read..];
        if rest.is_empty() {
            return None;
        }
        let end = rest.iter().position(|byte| *byte == b'\n').map_or(rest.len(), |at| at + 1);
        let line = bare(&String::from_utf8_lossy(&rest[..end]));
        (running.read, running.line) = (running.read + end, running.line + 1);
        Some(line)
    }

    /// The field of a status report, while a file is run.
    pub(super) fn field(&self) -> Option<String> {
        let Running { name, content, read, .. } = self.running.as_ref()?;
        let percent = *read as f64 / content.len().max(1) as f64 * 100.0;
        if self.fluid {
            let told = format!("|SD:{percent:.2},/sd/{name}");
            return Some(if *read > 0 { told } else { "|".to_owned() });
        }
        let percent = percent.min(99.9);
        Some(format!("|SD:{percent:.1},{name}"))
    }

    /// The line of the file that is read, and the file.
    pub(super) fn line(&self) -> (u32, &str) {
        self.running.as_ref().map_or((0, ""), |running| (running.line, &running.name))
    }
}

/// A line without what is no word of it: comments, blanks, a per cent sign.
fn bare(line: &str) -> String {
    let mut depth = 0;
    let mut bare = String::new();
    for c in line.chars().take_while(|c| *c != ';') {
        match c {
            '(' => depth += 1,
            ')' => depth -= 1,
            '%' => {}
            c if depth == 0 && !c.is_whitespace() => bare.push(c),
            _ => {}
        }
    }
    bare
}

impl Card {
    /// Somebody begins a file; tells whether it is there.
    pub(super) fn begins(&mut self, name: &str) -> bool {
        let Some(content) = self.files.get(name).cloned() else { return false };
        self.running = Some(Running { name: name.to_owned(), content, read: 0, line: 0 });
        true
    }

    /// Carries out a command about the card, of a controller that stands or does not; returns the lines that it answers, or
    /// nothing where it is no such command.
    pub(super) fn command(&mut self, command: &str, stands: bool) -> Option<Vec<String>> {
        let error = |number: u16| vec![format!("error:{number}")];
        if self.fluid {
            return self.fluid_command(command, stands);
        }
        if !command.starts_with('F') {
            return None;
        }
        if self.is_out {
            return Some(error(NO_CARD));
        }
        let (word, name) = command.split_once('=').unwrap_or((command, ""));
        let name = name.trim_start_matches('/').to_owned();
        let told: Vec<String> = match (word, self.files.get(&name)) {
            ("F" | "F+", _) if name.is_empty() => {
                let files = self.files.iter();
                files.map(|(name, it)| format!("[FILE:/{name}|SIZE:{}]", it.len())).collect()
            }
            ("FD", None) => return Some(error(NOT_DELETED)),
            (_, None) => return Some(error(NO_FILE)),
            ("F<", Some(it)) => String::from_utf8_lossy(it).lines().map(str::to_owned).collect(),
            ("FD", _) => {
                self.files.remove(&name);
                Vec::new()
            }
            // It answers, and begins the file behind that.
            ("F", _) if stands => Vec::new(),
            _ => return Some(error(BUSY)),
        };
        Some(told.into_iter().chain(["ok".to_owned()]).collect())
    }

    /// Takes a byte of a file that comes; returns what it answers, or nothing where none comes.
    pub(super) fn hears(&mut self, byte: u8, now_s: f64) -> Option<Vec<u8>> {
        if self.fluid {
            return self.xmodem.as_mut().map(|file| {
                file.hear(byte, now_s);
                Vec::new()
            });
        }
        if self.receiving.is_none() && (!matches!(byte, SOH | STX) || self.runs()) {
            return None;
        }
        let file = self.receiving.get_or_insert_with(Receiving::default);
        file.heard_s = now_s;
        if file.purges {
            return Some(Vec::new());
        }
        file.packet.push(byte);
        match file.packet[..] {
            [EOT] => {
                self.files.extend(file.name.take().map(|name| (name, file.content.clone())));
                self.receiving = None;
                return Some(vec![ACK, b'C']);
            }
            [CANCEL, CANCEL] => self.receiving = None,
            [SOH | STX, ..] => return Some(self.packet_comes()),
            [CANCEL] => {}
            _ => file.purges = true,
        }
        Some(Vec::new())
    }

    /// A packet is there when its last byte is; returns the answer.
    fn packet_comes(&mut self) -> Vec<u8> {
        let Some(file) = &mut self.receiving else { return Vec::new() };
        let length = if file.packet[0] == SOH { 128 } else { 1024 };
        if file.packet.len() < length + 5 {
            return Vec::new();
        }
        let packet = std::mem::take(&mut file.packet);
        let (bytes, sum) = packet[3..].split_at(length);
        let is_spoiled = self.spoils > 0;
        self.spoils = self.spoils.saturating_sub(1);
        if is_spoiled || crc(bytes).to_be_bytes() != sum || packet[1] != !packet[2] {
            file.purges = true;
            return Vec::new();
        }
        if packet[1] == 0 && file.name.is_none() {
            let mut words = bytes.split(|byte| *byte == 0);
            let mut word =
                || String::from_utf8_lossy(words.next().unwrap_or_default()).into_owned();
            (file.name, file.size) = (Some(word()), word().trim().parse().unwrap_or(0));
            file.next = 1;
            return vec![ACK, b'C'];
        }
        if packet[1] == file.next {
            file.next = file.next.wrapping_add(1);
            let rest = file.size - file.content.len();
            file.content.extend(&bytes[..rest.min(length)]);
        }
        if self.room.is_some_and(|room| file.content.len() > room) {
            self.receiving = None;
            return vec![CANCEL; 2];
        }
        vec![ACK]
    }

    /// A receiver that hears nothing asks again, and gives up some day.
    pub(super) fn waits(&mut self, now_s: f64) -> Vec<u8> {
        if self.fluid {
            self.takes_file(now_s)
        } else {
            self.asks_again(now_s).into_iter().collect()
        }
    }

    fn asks_again(&mut self, now_s: f64) -> Option<u8> {
        let file = self.receiving.as_mut().filter(|file| now_s - file.heard_s >= ASKS_S)?;
        (file.heard_s, file.asked, file.purges) = (now_s, file.asked + 1, false);
        file.packet.clear();
        if file.asked > ASKS {
            self.receiving = None;
            return None;
        }
        Some(NAK)
    }
}
