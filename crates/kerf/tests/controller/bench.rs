//! A fake controller, at the far end of a port or of the network; unplugged when it is dropped.

use crate::shop::{Did, Shop};
use kerf_driver_grbl::fake::Fake;
use kerf_transport::pretend::Plug;
use std::fs::remove_file;
use std::io::{ErrorKind, Read, Write};
use std::net::{TcpListener, TcpStream};
use std::os::unix::fs::symlink;
use std::path::PathBuf;
use std::process::{Child, Stdio};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};
use std::thread::{JoinHandle, sleep, spawn};
use std::time::{Duration, Instant};
use tungstenite::{Error, Message, WebSocket};

/// A look at a far end on which nothing comes.
const LOOK: Duration = Duration::from_millis(2);

pub struct Bench {
    pub fake: Arc<Mutex<Fake>>,
    /// The port, as it stands behind `grbl:`.
    pub port: String,
    plugged: Arc<Mutex<bool>>,
    /// The cable is pulled, and the controller is not heard.
    pulled: Arc<Mutex<bool>>,
    player: Option<JoinHandle<()>>,
}

impl Bench {
    pub fn new(settings: &[(u16, f64)]) -> Self {
        Self::of(Fake::new(settings))
    }

    /// One on a serial port of a name of its own: the number of a pseudo terminal that is gone goes to another one.
    pub fn of(fake: Fake) -> Self {
        static MADE: AtomicUsize = AtomicUsize::new(0);
        Self::cabled(&MADE.fetch_add(1, Ordering::Relaxed).to_string(), fake)
    }

    /// One that listens at a port of the network.
    pub fn tcp() -> Self {
        let listener = TcpListener::bind("127.0.0.1:0").unwrap();
        let port = format!("tcp:{}", listener.local_addr().unwrap());
        Self::at(
            port,
            Box::new(Network { listener, speaks: accepted, talk: None }),
            Fake::default(),
        )
    }

    /// One that serves a WebSocket.
    pub fn web() -> Self {
        let listener = TcpListener::bind("127.0.0.1:0").unwrap();
        let port = format!("ws:{}", listener.local_addr().unwrap());
        Self::at(port, Box::new(Network { listener, speaks: greeted, talk: None }), Fake::default())
    }

    fn at(port: String, end: Box<dyn End>, fake: Fake) -> Self {
        let (fake, plugged) = (Arc::new(Mutex::new(fake)), Arc::new(Mutex::new(true)));
        let pulled = Arc::new(Mutex::new(false));
        let (played, until, out) = (fake.clone(), plugged.clone(), pulled.clone());
        let player = Some(spawn(move || play(end, &played, &until, &out)));
        Self { fake, port, plugged, pulled, player }
    }

    /// One on a serial port whose cable can be pulled: the port keeps its name.
    pub fn plugged_at(name: &str) -> Self {
        Self::cabled(name, Fake::default())
    }

    pub fn cabled(name: &str, fake: Fake) -> Self {
        let path = std::env::temp_dir().join(format!("kerf-{}-{name}", std::process::id()));
        let cable = Cable { path: path.clone(), plug: None };
        Self::at(path.to_str().unwrap().to_owned(), Box::new(cable.plugged()), fake)
    }

    /// Pulls the cable, or takes the network down.
    pub fn pulls(&mut self) {
        *self.pulled.lock().unwrap() = true;
    }

    /// Plugs it in again.
    pub fn plugs(&mut self) {
        *self.pulled.lock().unwrap() = false;
    }

    pub fn look<T>(&self, at: impl FnOnce(&mut Fake) -> T) -> T {
        at(&mut self.fake.lock().unwrap())
    }

    /// Waits until something holds of the controller.
    #[track_caller]
    pub fn until(&self, holds: impl Fn(&Fake) -> bool) {
        let begin = Instant::now();
        while !self.look(|fake| holds(fake)) {
            assert!(begin.elapsed() < Duration::from_secs(60), "it does not come to that");
            sleep(Duration::from_millis(5));
        }
    }

    pub fn unplug(&mut self) {
        *self.plugged.lock().unwrap() = false;
        if let Some(player) = self.player.take() {
            player.join().unwrap();
        }
    }

    pub fn x_mm(&self) -> f64 {
        self.look(|fake| fake.position().0[0])
    }

    pub fn args(&self, words: &str) -> String {
        format!("{words} --driver grbl:{} --trace t.jsonl --force", self.port)
    }

    pub fn run(&self, shop: &Shop, words: &str) -> Did {
        shop.kerf(&self.args(words))
    }

    pub fn start(&self, shop: &Shop, words: &str) -> Child {
        let mut command = shop.command();
        command.args(self.args(words).split_whitespace());
        command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap()
    }
}

impl Drop for Bench {
    fn drop(&mut self) {
        self.unplug();
    }
}

/// The far end of a line, at which the controller is.
trait End: Send {
    /// The bytes that came within a moment.
    fn hear(&mut self) -> Vec<u8>;

    fn say(&mut self, bytes: &[u8]);

    /// The line is gone from now on, until something is heard or said again.
    fn is_gone(&mut self) {}
}

/// A port with one name and a plug that comes and goes.
struct Cable {
    path: PathBuf,
    plug: Option<Plug>,
}

impl Cable {
    fn plugged(mut self) -> Self {
        self.plug();
        self
    }

    fn plug(&mut self) -> &mut Plug {
        let path = &self.path;
        self.plug.get_or_insert_with(|| {
            let plug = Plug::new().unwrap();
            let _ = remove_file(path);
            symlink(plug.path(), path).unwrap();
            plug
        })
    }
}

impl End for Cable {
    fn hear(&mut self) -> Vec<u8> {
        self.plug().hear()
    }

    fn say(&mut self, bytes: &[u8]) {
        self.plug().say(bytes);
    }

    fn is_gone(&mut self) {
        self.plug = None;
        let _ = remove_file(&self.path);
    }
}

impl Drop for Cable {
    fn drop(&mut self) {
        let _ = remove_file(&self.path);
    }
}

impl End for Plug {
    fn hear(&mut self) -> Vec<u8> {
        let mut bytes = [0; 256];
        let count = self.read(&mut bytes, LOOK).unwrap();
        bytes[..count].to_vec()
    }

    fn say(&mut self, bytes: &[u8]) {
        self.write(bytes).unwrap();
    }
}

/// A controller in the network speaks to one program at a time; whoever goes may come again.
struct Network<T> {
    listener: TcpListener,
    speaks: fn(TcpStream) -> T,
    talk: Option<T>,
}

/// A connection: what came, or nothing when it is over.
trait Talk: Send {
    fn hear(&mut self) -> Option<Vec<u8>>;

    fn say(&mut self, bytes: &[u8]) -> Option<()>;
}

impl<T: Talk> End for Network<T> {
    fn hear(&mut self) -> Vec<u8> {
        self.listener.set_nonblocking(true).unwrap();
        if let Ok((stream, _)) = self.listener.accept() {
            stream.set_nonblocking(false).unwrap();
            self.talk = Some((self.speaks)(stream));
        }
        let heard = self.talk.as_mut().and_then(Talk::hear);
        if heard.is_none() {
            self.talk = None;
            sleep(LOOK);
        }
        heard.unwrap_or_default()
    }

    fn say(&mut self, bytes: &[u8]) {
        if self.talk.as_mut().is_some_and(|talk| talk.say(bytes).is_none()) {
            self.talk = None;
        }
    }

    fn is_gone(&mut self) {
        self.talk = None;
    }
}

fn accepted(stream: TcpStream) -> TcpStream {
    stream.set_read_timeout(Some(LOOK)).unwrap();
    stream
}

impl Talk for TcpStream {
    fn hear(&mut self) -> Option<Vec<u8>> {
        let mut bytes = [0; 256];
        match self.read(&mut bytes) {
            Ok(0) => None,
            Ok(count) => Some(bytes[..count].to_vec()),
            Err(error) => is_silence(error.kind()).then(Vec::new),
        }
    }

    fn say(&mut self, bytes: &[u8]) -> Option<()> {
        self.write_all(bytes).ok()
    }
}

fn greeted(stream: TcpStream) -> WebSocket<TcpStream> {
    let mut socket = tungstenite::accept(stream).unwrap();
    // What is meant for its page is no answer to a line.
    socket.send(Message::text("CURRENT_ID:0")).unwrap();
    socket.get_ref().set_read_timeout(Some(LOOK)).unwrap();
    socket
}

impl Talk for WebSocket<TcpStream> {
    fn hear(&mut self) -> Option<Vec<u8>> {
        match self.read() {
            Ok(Message::Binary(bytes)) => Some(bytes.to_vec()),
            Ok(_) => Some(Vec::new()),
            Err(Error::Io(error)) if is_silence(error.kind()) => Some(Vec::new()),
            Err(_) => None,
        }
    }

    fn say(&mut self, bytes: &[u8]) -> Option<()> {
        // Half of it as text: controllers send both kinds.
        let (text, rest) = bytes.split_at(bytes.len() / 2);
        let text = Message::text(String::from_utf8_lossy(text).into_owned());
        self.send(text).and_then(|()| self.send(Message::binary(rest.to_vec()))).ok()
    }
}

fn is_silence(kind: ErrorKind) -> bool {
    matches!(kind, ErrorKind::WouldBlock | ErrorKind::TimedOut)
}

fn play(mut end: Box<dyn End>, fake: &Mutex<Fake>, plugged: &Mutex<bool>, pulled: &Mutex<bool>) {
    let since = Instant::now();
    while *plugged.lock().unwrap() {
        let came = if *pulled.lock().unwrap() {
            end.is_gone();
            sleep(LOOK);
            Vec::new()
        } else {
            end.hear()
        };
        let now_s = since.elapsed().as_secs_f64();
        let (out, is_pulled) = {
            let mut fake = fake.lock().unwrap();
            fake.hear(&came, now_s);
            // What it says after the cable was pulled is heard by nobody.
            (fake.speak(now_s), *pulled.lock().unwrap())
        };
        if !out.is_empty() && !is_pulled {
            end.say(&out);
        }
    }
}
