//! Loads that keep a server busy, bounded in number and time: each is a few threads of low priority that end when
//! they are told to.

use super::shop::{ask, socket, with_role};
use serde_json::json;
use std::io::{Read, Write};
use std::net::{SocketAddr, TcpStream};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

/// No load lasts longer, whatever becomes of whoever began it.
const LONGEST: Duration = Duration::from_secs(600);

/// A load that goes on until it is dropped.
pub struct Load {
    over: Arc<AtomicBool>,
    threads: Vec<JoinHandle<()>>,
}

/// Flag that stays true as long as a load goes on.
#[derive(Clone)]
pub struct Going {
    over: Arc<AtomicBool>,
    begun: Instant,
}

impl Going {
    pub fn on(&self) -> bool {
        !self.over.load(Ordering::Relaxed) && self.begun.elapsed() < LONGEST
    }
}

impl Load {
    /// So many threads that do this again and again.
    pub fn of(number: usize, work: impl Fn(usize, &Going) + Send + Sync + 'static) -> Self {
        let (over, work) = (Arc::<AtomicBool>::default(), Arc::new(work));
        let one = |turn: usize| {
            let (going, work) = (Going { over: over.clone(), begun: Instant::now() }, work.clone());
            thread::spawn(move || {
                lower();
                while going.on() {
                    work(turn, &going);
                }
            })
        };
        let threads = (0..number).map(one).collect();
        Self { over, threads }
    }
}

impl Drop for Load {
    fn drop(&mut self) {
        self.over.store(true, Ordering::Relaxed);
        for thread in self.threads.drain(..) {
            drop(thread.join());
        }
    }
}

/// This thread is less important than whoever drives, and the control thread.
fn lower() {
    // Where the system refuses, the load weighs more: that is a harder test.
    _ = rustix::process::setpriority_process(None, 10);
}

/// Sockets that send pings as fast as they go, and read or do not read what comes back.
pub fn pings(address: SocketAddr, sockets: usize, role: &'static str, reads: bool) -> Load {
    let ping = json!({ "id": 1, "act": { "do": "ping" } }).to_string();
    flood(address, sockets, role, reads, frame(&ping).repeat(200))
}

/// Sockets that send nothing but what makes no sense, three kilobytes at a time, and read nothing.
pub fn nonsense(address: SocketAddr, sockets: usize) -> Load {
    let text = format!(r#"{{"id":1,"act":{{"do":"{}"}}}}"#, "x".repeat(3000));
    flood(address, sockets, "observer", false, frame(&text).repeat(10))
}

/// Sockets that send the same bytes again and again.
fn flood(
    address: SocketAddr,
    sockets: usize,
    role: &'static str,
    reads: bool,
    bytes: Vec<u8>,
) -> Load {
    Load::of(sockets, move |turn, going| {
        let Some(mut socket) = socket(address, "/ws", address, with_role(role, turn)) else {
            return thread::sleep(Duration::from_millis(100));
        };
        let stream = socket.get_mut();
        drop(stream.set_nonblocking(true));
        let (mut sent, mut read) = (0, vec![0; 1 << 16]);
        while going.on() {
            match stream.write(&bytes[sent..]) {
                Ok(0) => break,
                Ok(more) => sent = (sent + more) % bytes.len(),
                Err(error) if waits(&error) => thread::sleep(Duration::from_millis(1)),
                Err(_) => break,
            }
            match if reads { stream.read(&mut read) } else { Ok(1) } {
                Ok(0) => break,
                Err(error) if !waits(&error) => break,
                _ => {}
            }
        }
    })
}

/// A text as a frame of a WebSocket, its mask zero.
fn frame(text: &str) -> Vec<u8> {
    let length = match text.len() {
        short @ ..126 => vec![0x80 | short as u8],
        long => [&[0x80 | 126], &(long as u16).to_be_bytes()[..]].concat(),
    };
    [&[0x81], &length[..], &[0; 4], text.as_bytes()].concat()
}

/// Tells whether a socket has nothing to read, or no room to write, for now.
pub fn waits(error: &std::io::Error) -> bool {
    matches!(error.kind(), std::io::ErrorKind::WouldBlock | std::io::ErrorKind::TimedOut)
}

/// Connections of strangers that send half a request and then nothing, opened anew where they are closed.
pub fn half_sent(address: SocketAddr, connections: usize) -> Load {
    Load::of(1, move |_, going| {
        let mut open = Vec::new();
        while going.on() {
            if open.len() == connections {
                thread::sleep(Duration::from_secs(1));
                open.clear();
            }
            let Ok(mut stream) = TcpStream::connect(address) else {
                thread::sleep(Duration::from_millis(10));
                continue;
            };
            drop(stream.write_all(b"POST /api/pair HTTP/1.1\r\nHost: 127"));
            open.push(stream);
        }
    })
}

/// Devices that put files of so many megabytes into the part folder.
pub fn uploads(address: SocketAddr, devices: usize, megabytes: usize) -> Load {
    Load::of(devices, move |turn, _| {
        let body = vec![b'x'; megabytes << 20];
        let request = format!("PUT /api/files/load-{turn}.bin");
        ask(address, with_role("operator", turn), &request, "application/octet-stream", &body);
    })
}

/// Devices that have texts of almost a megabyte checked.
pub fn checks(address: SocketAddr, devices: usize) -> Load {
    let text = "M3,1,2,3\nJZ,0.5\n&a = 7 * (3 + 4)\n".repeat(20_000);
    let body = json!({ "name": "a.sbp", "text": text }).to_string();
    Load::of(devices, move |turn, _| {
        let device = with_role("observer", turn);
        ask(address, device, "POST /api/language/check", "application/json", body.as_bytes());
    })
}

/// Devices that try passwords.
pub fn passwords(address: SocketAddr, devices: usize) -> Load {
    Load::of(devices, move |turn, _| {
        let body = json!({ "password": format!("guess {turn}") }).to_string();
        let device = with_role("setter", turn);
        ask(address, device, "POST /api/do/unlock", "application/json", body.as_bytes());
    })
}

/// The settings have a password from now on.
pub fn protect(address: SocketAddr) {
    let body = json!({ "password": null, "new": ["a password", "a password"] }).to_string();
    let device = with_role("setter", 0);
    ask(address, device, "POST /api/do/protect", "application/json", body.as_bytes());
}

/// Devices that have the tool path of six thousand circles made, again and again.
pub fn tool_paths(address: SocketAddr, devices: usize) -> Load {
    let body = json!({ "drawing": "circles.dxf", "anew": true }).to_string();
    Load::of(devices, move |turn, _| {
        let device = with_role("operator", turn);
        ask(address, device, "POST /api/do/machine", "application/json", body.as_bytes());
    })
}

/// Devices that open a long part file again and again: each time its preview is made.
pub fn previews(address: SocketAddr, devices: usize) -> Load {
    let body = json!({ "name": "long.sbp" }).to_string();
    Load::of(devices, move |turn, _| {
        let device = with_role("operator", turn);
        ask(address, device, "POST /api/do/open", "application/json", body.as_bytes());
        thread::sleep(Duration::from_millis(50));
    })
}

/// Devices that ask for everything that pages show, and for the description of the interface.
pub fn states(address: SocketAddr, devices: usize) -> Load {
    Load::of(devices, move |turn, _| {
        let path = if turn % 2 == 0 { "GET /api/state" } else { "GET /api/openapi.json" };
        ask(address, with_role("observer", turn), path, "application/json", b"");
    })
}

/// A part file of so many moves.
pub fn long_part(moves: usize) -> String {
    (0..moves).map(|n| format!("M3,{},{},-0.1\n", n % 97, n % 89)).collect()
}

/// So many circles as a DXF.
pub fn circles(number: usize) -> String {
    let mut text = String::from("0\nSECTION\n2\nENTITIES\n");
    for n in 0..number {
        let (x, y) = (n % 100 * 3, n / 100 * 3);
        text += &format!("0\nCIRCLE\n8\n0\n10\n{x}\n20\n{y}\n40\n1\n");
    }
    text + "0\nENDSEC\n0\nEOF\n"
}
