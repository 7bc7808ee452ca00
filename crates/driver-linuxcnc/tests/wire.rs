//! A driver on a line with a fake bridge at its other end.

use kerf_driver_linuxcnc::LinuxCnc;
use kerf_driver_linuxcnc::fake::Fake;
use kerf_machine::driver::{Driver, Garbled, Link, Reply, Sent, Signal, Wired};

/// A driver on a line with a fake bridge at its other end.
pub struct Wire {
    pub driver: LinuxCnc,
    pub fake: Fake,
    /// Spoils the byte with this number to the bridge, or from it.
    pub spoils_to: Option<usize>,
    pub spoils_from: Option<usize>,
    /// Begins before the clock of whoever looks.
    ahead_s: f64,
}

impl Wire {
    pub fn new(fake: Fake) -> Self {
        let (driver, ahead_s) = (LinuxCnc::new(), 5.0);
        let mut wire = Self { driver, fake, spoils_to: None, spoils_from: None, ahead_s };
        (0..300).for_each(|tick| wire.carry(-5.0 + 0.01 * f64::from(tick)));
        wire.ahead_s = 5.0;
        wire
    }

    pub fn carry(&mut self, now_s: f64) {
        let now_s = now_s + self.ahead_s;
        let mut bytes = self.driver.speak(now_s);
        spoil(&mut bytes, &mut self.spoils_to);
        self.fake.hear(&bytes, now_s);
        let mut bytes = self.fake.speak(now_s);
        spoil(&mut bytes, &mut self.spoils_from);
        self.driver.hear(&bytes, now_s);
    }
}

/// Turns the byte with a number over when it passes.
fn spoil(bytes: &mut [u8], at: &mut Option<usize>) {
    let Some(left) = at else { return };
    match bytes.get_mut(*left) {
        Some(byte) => {
            *byte ^= 0x11;
            *at = None;
        }
        None => *left -= bytes.len(),
    }
}

impl Driver for Wire {
    fn send(&mut self, sent: &Sent, now_s: f64) {
        self.driver.send(sent, now_s + self.ahead_s);
    }

    fn signal(&mut self, signal: Signal, now_s: f64) {
        self.driver.signal(signal, now_s + self.ahead_s);
    }

    fn replies(&mut self, now_s: f64) -> Vec<Result<Reply, Garbled>> {
        self.carry(now_s);
        self.driver.replies(now_s)
    }

    fn window(&self) -> usize {
        self.driver.window()
    }
}

/// Lets time pass until everything is done, or 60 s.
pub fn run(link: &mut Link<Wire>, from_s: f64, mut each: impl FnMut(&mut Link<Wire>, f64)) -> f64 {
    let mut now_s = from_s;
    while !link.is_idle() && now_s < from_s + 60.0 {
        now_s += 0.005;
        link.poll(now_s);
        each(link, now_s);
    }
    now_s
}
