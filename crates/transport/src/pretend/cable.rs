//! A null modem cable between two pretended ports. It is as slow as the ports are set, spoils every byte
//! when they are set differently, and can be damaged.

use super::Plug;
use crate::LineError;
use std::collections::VecDeque;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

/// A byte takes 10 bits on the line: 1 start bit, 8 data bits, 1 stop bit.
const BITS: f64 = 10.0;

/// Bytes that are on the line at a time; the rest waits with the sender.
const ON_THE_LINE: usize = 256;

/// Damage that the cable does to bytes, and the bytes it has carried.
#[derive(Debug, Default)]
struct Damage {
    /// No byte passes any more.
    cut: bool,
    /// Bytes from the first end that get through before one is spoiled.
    spoil_after: VecDeque<u64>,
    /// Both plugs are pulled, and the thread ends.
    pulled: bool,
    /// Bytes that have come out of either end.
    carried: u64,
}

/// Two pretended ports and the cable between them. Dropped, both ports are gone.
#[derive(Debug)]
pub struct Cable {
    ends: [String; 2],
    damage: Arc<Mutex<Damage>>,
    pump: Option<JoinHandle<()>>,
}

impl Cable {
    /// A new cable with its two ports.
    ///
    /// # Errors
    /// When the computer has no more ports to pretend.
    pub fn new() -> Result<Self, LineError> {
        Self::hurried(1.0)
    }

    /// A cable that carries bytes so many times faster than the rate of its ports: for tests of what is said over it,
    /// not of how long that takes.
    ///
    /// # Errors
    /// When the computer has no more ports to pretend.
    pub fn hurried(times: f64) -> Result<Self, LineError> {
        let plugs = [Plug::new()?, Plug::new()?];
        let ends = [plugs[0].path().to_owned(), plugs[1].path().to_owned()];
        let damage = Arc::new(Mutex::new(Damage::default()));
        let shared = Arc::clone(&damage);
        let pump = std::thread::spawn(move || pump(plugs, times, &shared));
        Ok(Self { ends, damage, pump: Some(pump) })
    }

    /// Returns the paths by which its two ends are opened.
    pub fn ends(&self) -> [&str; 2] {
        [&self.ends[0], &self.ends[1]]
    }

    /// Cuts it: both ports stay, no byte passes.
    pub fn cut(&self) {
        lock(&self.damage).cut = true;
    }

    /// Bytes that have come out of either end.
    pub fn carried(&self) -> u64 {
        lock(&self.damage).carried
    }

    /// Spoils a bit of one byte from the first end to the second, after so many bytes from now on.
    pub fn spoil_after(&self, bytes: u64) {
        lock(&self.damage).spoil_after.push_back(bytes);
    }
}

impl Drop for Cable {
    fn drop(&mut self) {
        lock(&self.damage).pulled = true;
        if let Some(pump) = self.pump.take() {
            // A panic of the thread was printed by it.
            let _ = pump.join();
        }
    }
}

fn lock(damage: &Mutex<Damage>) -> MutexGuard<'_, Damage> {
    damage.lock().unwrap_or_else(PoisonError::into_inner)
}

fn pump(mut plugs: [Plug; 2], times: f64, damage: &Mutex<Damage>) {
    let mut wires = [Wire::new(0, times), Wire::new(1, times)];
    while !lock(damage).pulled {
        for wire in &mut wires {
            if wire.carry(&mut plugs, damage).is_err() {
                return;
            }
        }
    }
}

/// One direction.
struct Wire {
    from: usize,
    /// Bytes with the time at which their last bit is through.
    under_way: VecDeque<(Instant, u8)>,
    free_at: Instant,
    /// How many times faster than the rate of the ports.
    times: f64,
}

impl Wire {
    fn new(from: usize, times: f64) -> Self {
        Self { from, under_way: VecDeque::new(), free_at: Instant::now(), times }
    }

    /// Takes what the sender has, hands over what is through.
    fn carry(&mut self, plugs: &mut [Plug; 2], damage: &Mutex<Damage>) -> Result<(), LineError> {
        let mut bytes = [0; ON_THE_LINE];
        let room = ON_THE_LINE - self.under_way.len();
        let count = plugs[self.from].read(&mut bytes[..room], Duration::from_millis(1))?;
        if count > 0 {
            self.take(&mut bytes[..count], plugs, damage)?;
        } else if self.under_way.is_empty() {
            self.free_at = self.free_at.max(Instant::now());
        }
        let through = self.through();
        lock(damage).carried += through.len() as u64;
        plugs[1 - self.from].write(&through)
    }

    fn take(
        &mut self,
        bytes: &mut [u8],
        plugs: &[Plug; 2],
        damage: &Mutex<Damage>,
    ) -> Result<(), LineError> {
        let (sender, receiver) = (plugs[self.from].baud()?, plugs[1 - self.from].baud()?);
        let byte_s = BITS / f64::from(sender.max(1)) / self.times;
        let mut damage = lock(damage);
        for byte in bytes {
            self.free_at += Duration::from_secs_f64(byte_s);
            let spoiled = sender != receiver || (self.from == 0 && damage.strikes());
            if !damage.cut {
                self.under_way
                    .push_back((self.free_at, if spoiled { *byte ^ 0x24 } else { *byte }));
            }
        }
        Ok(())
    }

    fn through(&mut self) -> Vec<u8> {
        let now = Instant::now();
        let count = self.under_way.iter().take_while(|(at, _)| *at <= now).count();
        self.under_way.drain(..count).map(|(_, byte)| byte).collect()
    }
}

impl Damage {
    /// Returns `true` if this byte of the first end is one to spoil.
    fn strikes(&mut self) -> bool {
        match self.spoil_after.front_mut() {
            Some(0) => self.spoil_after.pop_front().is_some(),
            Some(left) => {
                *left -= 1;
                false
            }
            None => false,
        }
    }
}
