//! Boards that are asked who they are, and are not configured.

use super::attached::Socket;
use super::others::address;
use kerf_driver_klipper::board::{Introduced, Introduction};
use kerf_transport::ListedPort;
use std::thread::spawn;
use std::time::{Duration, Instant};

/// A board that has not answered by then is none, seconds. How long it takes to tell who it is does not count.
const GREETING_S: f64 = 12.0;
/// The same for boards that are looked for at all ports: one that is there answers within a second.
const LOOK_S: f64 = 4.0;
/// One look at a line.
const NAP: Duration = Duration::from_millis(5);

/// Asks a board who it is. Nothing of it changes.
///
/// # Errors
/// Nobody answers, or something that is no board; in words.
pub fn introduced(socket: &Socket) -> Result<Introduced, String> {
    within(socket, GREETING_S)
}

/// Looks who answers at serial ports, all of them side by side, in some seconds. Ports that nobody else has open are opened; a
/// device that begins anew when that happens does so.
pub fn at_ports(ports: Vec<ListedPort>) -> Vec<(ListedPort, Result<Introduced, String>)> {
    let looks = ports.into_iter().map(|port| {
        spawn(move || {
            let told = address(&port.path).and_then(|place| {
                within(&Socket::of(format!("klipper:{}", port.path), place), LOOK_S)
            });
            (port, told)
        })
    });
    let looks: Vec<_> = looks.collect();
    looks.into_iter().filter_map(|look| look.join().ok()).collect()
}

fn within(socket: &Socket, patience_s: f64) -> Result<Introduced, String> {
    let mut line = (socket.opens)()?;
    let (since, mut board) = (Instant::now(), Introduction::new(0.0));
    let mut bytes = [0; 1024];
    while board.has_answered() || since.elapsed().as_secs_f64() < patience_s {
        let out = board.transmit(since.elapsed().as_secs_f64());
        if !out.bytes.is_empty() {
            line.write(&out.bytes).map_err(|why| why.to_string())?;
        }
        let count = line.read(&mut bytes, NAP).map_err(|why| why.to_string())?;
        board.receive(&bytes[..count], since.elapsed().as_secs_f64());
        if let Some(told) = board.take() {
            return told.map_err(|why| why.to_string());
        }
    }
    Err("no board answers: is this its port and its rate?".into())
}
