//! A link that is made bad: messages are late, some of them very, and keep their order as TCP does.

use std::io::{Read, Write};
use std::net::{Shutdown, SocketAddr, TcpListener, TcpStream};
use std::sync::mpsc::{Receiver, channel};
use std::thread;
use std::time::{Duration, Instant};

/// Delay of messages on a link.
#[derive(Clone, Copy, Debug)]
pub struct Roughness {
    /// Least and most, ms.
    pub delay_ms: [u64; 2],
    /// Of a hundred messages so many stand still for a while, and with them what comes behind.
    pub stalls_percent: u64,
    /// Least and most of that while, ms.
    pub stall_ms: [u64; 2],
}

/// Numbers that are the same in every run.
struct Dice(u64);

impl Dice {
    fn throw(&mut self, [least, most]: [u64; 2]) -> u64 {
        // Xorshift (Marsaglia 2003).
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        least + self.0 % (most - least + 1)
    }
}

/// An address that leads to a server by a bad link, for as long as the test runs.
pub fn rough(server: SocketAddr, how: Roughness) -> SocketAddr {
    let listener = TcpListener::bind("127.0.0.1:0").unwrap();
    let address = listener.local_addr().unwrap();
    thread::spawn(move || {
        let mut seed = 0;
        for near in listener.incoming() {
            let (near, far) = (near.unwrap(), TcpStream::connect(server).unwrap());
            let ways = [(&near, &far), (&far, &near)];
            for (from, to) in ways.map(|(a, b)| (a.try_clone().unwrap(), b.try_clone().unwrap())) {
                seed += 1;
                to.set_nodelay(true).unwrap();
                carry(from, to, how, Dice(0x9e37_79b9_7f4a_7c15 ^ seed));
            }
        }
    });
    address
}

fn carry(mut from: TcpStream, mut to: TcpStream, how: Roughness, mut dice: Dice) {
    let (sends, waiting) = channel();
    thread::spawn(move || {
        let (mut bytes, mut free) = ([0; 65_536], Instant::now());
        while let Ok(count @ 1..) = from.read(&mut bytes) {
            let delay = Duration::from_millis(dice.throw(how.delay_ms));
            free = free.max(Instant::now() + delay);
            if dice.throw([1, 100]) <= how.stalls_percent {
                free += Duration::from_millis(dice.throw(how.stall_ms));
            }
            if sends.send((free, bytes[..count].to_vec())).is_err() {
                return;
            }
        }
    });
    thread::spawn(move || {
        deliver(&mut to, &waiting);
        drop(to.shutdown(Shutdown::Both));
    });
}

fn deliver(to: &mut TcpStream, waiting: &Receiver<(Instant, Vec<u8>)>) {
    for (at, bytes) in waiting {
        thread::sleep(at.saturating_duration_since(Instant::now()));
        if to.write_all(&bytes).is_err() {
            return;
        }
    }
}
