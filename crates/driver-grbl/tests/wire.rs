//! A driver on a line with a fake controller at its other end.

use kerf_driver_grbl::Grbl;
use kerf_driver_grbl::fake::Fake;
use kerf_machine::driver::{
    Axes, Driver, Garbled, Link, LinkState, Order, Reply, Sent, Signal, Wired,
};

/// A driver on a line with a fake controller at its other end.
pub struct Wire {
    pub grbl: Grbl,
    pub fake: Fake,
    /// Begins before the clock of whoever looks.
    pub ahead_s: f64,
    /// The line is cut.
    pub cut: bool,
    /// The line is gone; before it was, so many bytes came through to the controller.
    pub gone: Option<usize>,
    /// Nothing comes through either way for a while, and nothing is lost.
    pub stalled: bool,
    /// The next bytes that the controller hears, or else says, suffer a fault.
    pub to_spoil: Option<(bool, u64)>,
    pub chance: u64,
    /// The wire back is broken: the controller hears and is not heard.
    pub deaf: bool,
    /// Every so many bytes of the controller one is spoiled.
    pub spoils_every: Option<usize>,
    /// Every one of these bytes arrives as another one.
    pub garbles: Option<(u8, u8)>,
    /// Words of the controller, and what arrives in their place once.
    pub garbles_told: Option<(&'static str, &'static str)>,
    pub told: usize,
}

impl Wire {
    pub fn new(fake: Fake) -> Self {
        let (grbl, ahead_s) = (Grbl::new(), 5.0);
        let mut wire = Self {
            grbl,
            fake,
            ahead_s,
            cut: false,
            gone: None,
            stalled: false,
            to_spoil: None,
            chance: 1,
            deaf: false,
            spoils_every: None,
            garbles: None,
            garbles_told: None,
            told: 0,
        };
        for tick in 0..500 {
            wire.carry(-5.0 + 0.01 * f64::from(tick));
        }
        wire
    }

    fn spoil(&mut self, heard: bool, bytes: &mut Vec<u8>) {
        let Some((_, kind)) = self.to_spoil.filter(|(to, _)| *to == heard) else { return };
        if faulty(bytes, kind, &mut Chance(self.chance)) {
            self.to_spoil = None;
        }
    }

    /// The line is gone behind so many bytes to the controller.
    pub fn loses(&mut self, passes: usize) {
        self.gone = Some(passes);
    }

    /// It is there again.
    pub fn is_back(&mut self, now_s: f64) {
        self.gone = None;
        self.grbl.line_is_back(now_s + self.ahead_s);
    }

    pub fn carry(&mut self, now_s: f64) {
        let now_s = now_s + self.ahead_s;
        if self.stalled {
            return;
        }
        if self.gone == Some(0) {
            self.fake.hear(&[], now_s);
            drop(self.fake.speak(now_s));
            return;
        }
        let mut bytes = self.grbl.speak(now_s);
        if let Some(passes) = &mut self.gone {
            bytes.truncate(*passes);
            *passes -= bytes.len();
        }
        if let Some((from, to)) = self.garbles {
            bytes.iter_mut().filter(|byte| **byte == from).for_each(|byte| *byte = to);
        }
        if self.cut {
            return;
        }
        self.spoil(true, &mut bytes);
        self.fake.hear(&bytes, now_s);
        let mut bytes = self.fake.speak(now_s);
        self.spoil(false, &mut bytes);
        let said = String::from_utf8_lossy(&bytes);
        if let Some((from, to)) = self.garbles_told.take_if(|(from, _)| said.contains(*from)) {
            bytes = said.replacen(from, to, 1).into_bytes();
        }
        for byte in &mut bytes {
            self.told += 1;
            if self.spoils_every.is_some_and(|every| self.told.is_multiple_of(every)) {
                *byte ^= 0x11;
            }
        }
        if !self.deaf {
            self.grbl.hear(&bytes, now_s);
        }
    }
}

impl Driver for Wire {
    fn send(&mut self, sent: &Sent, now_s: f64) {
        self.grbl.send(sent, now_s);
        self.carry(now_s);
    }

    fn signal(&mut self, signal: Signal, now_s: f64) {
        self.grbl.signal(signal, now_s + self.ahead_s);
        self.carry(now_s);
    }

    fn replies(&mut self, now_s: f64) -> Vec<Result<Reply, Garbled>> {
        self.carry(now_s);
        self.grbl.replies(now_s)
    }

    fn window(&self) -> usize {
        self.grbl.window()
    }

    fn quiet(&self) -> bool {
        self.grbl.quiet()
    }
}

pub fn to(x: f64, y: f64) -> Order {
    Order::Move { to: Axes::xyz(x, y, 0.0), speed_mm_s: 40.0 }
}

/// Runs until a link has nothing left to do, or is not up any more.
pub fn run(link: &mut Link<Wire>, from_s: f64, mut look: impl FnMut(&mut Link<Wire>, f64)) -> f64 {
    let mut now_s = from_s;
    while !link.is_idle() && link.state() == LinkState::Up && now_s < from_s + 120.0 {
        now_s += 0.005;
        link.poll(now_s);
        look(link, now_s);
    }
    now_s
}

/// Numbers that look like chance and are the same each time (Marsaglia's xorshift).
pub struct Chance(pub u64);

impl Chance {
    pub fn below(&mut self, bound: u64) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0 % bound
    }
}

/// Bytes on their way, one of which may be lost, spoiled or joined by noise.
pub fn faulty(bytes: &mut Vec<u8>, kind: u64, chance: &mut Chance) -> bool {
    if bytes.is_empty() {
        return false;
    }
    let at = chance.below(bytes.len() as u64) as usize;
    match kind {
        0 => drop(bytes.remove(at)),
        1 => bytes[at] ^= 1 << chance.below(7),
        2 => bytes.insert(at, chance.below(128) as u8),
        _ => bytes.clear(),
    }
    true
}
