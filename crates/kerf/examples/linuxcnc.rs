//! A fake LinuxCNC behind a fake bridge, at a port of this computer: to try
//! `kerf run FILE --machine linuxcnc:HOST:PORT` without LinuxCNC.
//!
//! ```text
//! cargo run -p kerf --example linuxcnc
//! kerf run box.sbp --machine linuxcnc:127.0.0.1:40123
//! ```
//!
//! `unhomed` as an argument has it begin without knowing its place. Lines on standard input work it: `estop` presses its
//! emergency stop, `on` releases it and switches it on, `pause`, `resume` and `abort` its panel, `panel G10L2P2X5` changes a
//! zero point there, `where` tells where it stands, an end of the input ends it.
#![allow(clippy::print_stdout)]

use kerf_driver_linuxcnc::fake::Fake;
use std::io::{ErrorKind, Read, Write, stdin};
use std::net::{TcpListener, TcpStream};
use std::sync::mpsc::{Receiver, TryRecvError, channel};
use std::time::{Duration, Instant};

fn main() {
    let listener = TcpListener::bind("127.0.0.1:0").expect("a port");
    listener.set_nonblocking(true).expect("a port");
    println!("{}", listener.local_addr().expect("a port"));
    let (said, says) = channel();
    std::thread::spawn(move || {
        stdin().lines().map_while(Result::ok).try_for_each(|line| said.send(line))
    });
    let mut fake = Fake::default();
    fake.homed = !std::env::args().any(|word| word == "unhomed");
    play(&listener, fake, &says);
}

fn play(listener: &TcpListener, mut fake: Fake, says: &Receiver<String>) {
    let (since, mut kerf) = (Instant::now(), None);
    loop {
        if let Ok((stream, _)) = listener.accept() {
            kerf = Some(accepted(stream));
        }
        let now_s = since.elapsed().as_secs_f64();
        let out = fake.speak(now_s);
        if let Some(stream) = &mut kerf {
            match heard(stream).filter(|_| stream.write_all(&out).is_ok()) {
                Some(bytes) => fake.hear(&bytes, now_s),
                None => {
                    fake.loses_line();
                    kerf = None;
                }
            }
        } else {
            std::thread::sleep(Duration::from_millis(2));
        }
        match says.try_recv() {
            Ok(line) => work(&mut fake, &line),
            Err(TryRecvError::Empty) => {}
            Err(TryRecvError::Disconnected) => return,
        }
    }
}

fn accepted(stream: TcpStream) -> TcpStream {
    stream.set_nonblocking(false).expect("a connection");
    stream.set_read_timeout(Some(Duration::from_millis(2))).expect("a connection");
    stream
}

/// The bytes that came; nothing when the connection is over.
fn heard(stream: &mut TcpStream) -> Option<Vec<u8>> {
    let mut bytes = [0; 4096];
    match stream.read(&mut bytes) {
        Ok(0) => None,
        Ok(count) => Some(bytes[..count].to_vec()),
        Err(error) => {
            matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::TimedOut).then(Vec::new)
        }
    }
}

fn work(fake: &mut Fake, line: &str) {
    match line.split_once(' ').unwrap_or((line, "")) {
        ("estop", _) => fake.presses_estop(),
        ("on", _) => fake.panel_switches_on(),
        ("pause", _) => fake.panel_pauses(true),
        ("resume", _) => fake.panel_pauses(false),
        ("abort", _) => fake.panel_aborts(),
        ("panel", line) => fake.panel(line),
        ("where", _) => {
            let [x, y, z, ..] = fake.position().0;
            let (stands, spindle) = (fake.stands(), fake.spindle());
            println!("{x:.3},{y:.3},{z:.3} spindle {spindle:?}, {stands} stands");
        }
        _ => println!("estop, on, pause, resume, abort, panel LINE, where"),
    }
}
