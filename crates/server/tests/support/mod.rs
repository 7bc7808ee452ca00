//! A server on a free port with its own folders, and pages and scripts that ask it.

#![allow(dead_code, clippy::unwrap_used)]

pub mod board;
pub mod hand;
pub mod rough;
mod wired;

use kerf_control::Session;
use kerf_drawing::{Editor, script};
use kerf_driver_grbl::fake::Fake;
use kerf_files::{Folders, RealDisk};
use kerf_journal::Journal;
use kerf_program::AxisSet;
use kerf_server::{Builders, Options, Server, Workshop};
use kerf_workspace::{Workspace, stored::Stored};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::io::{Read, Write};
use std::net::{SocketAddr, TcpStream};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};
use tempfile::TempDir;
use tungstenite::client::IntoClientRequest;
use tungstenite::{Message, WebSocket, client};

/// Longest wait for something that has to come.
const PATIENCE: Duration = Duration::from_secs(20);

/// The job of a drawing made by a script, as its file.
pub fn rsm(clauses: &str) -> String {
    let mut editor = Editor::default();
    for (_, operation) in script(clauses).unwrap() {
        editor.apply(&operation).unwrap();
    }
    let (job, _) = kerf_toolpath::job(&editor.drawing).unwrap();
    kerf_toolpath::write(&job)
}

/// Location of the machine, X Y Z of its own frame.
pub fn at(page: &Page) -> [f64; 3] {
    [0, 1, 2].map(|axis| page.shown["motion"]["at"]["machine"][axis].as_f64().unwrap())
}

/// The tokens of servers that let others in, by their addresses: whoever asks in a test sits at the machine, unless
/// it says that it does not.
static TOKENS: Mutex<BTreeMap<SocketAddr, String>> = Mutex::new(BTreeMap::new());

/// The header that shows that somebody sits at the machine; nothing where that is not asked for, or where other
/// headers say who asks.
fn at_machine(address: SocketAddr, headers: &[(&str, &str)]) -> Option<String> {
    let says = [
        "x-forwarded-for",
        "x-real-ip",
        "forwarded",
        "x-forwarded-host",
        "authorization",
        "cookie",
    ];
    let says_who = |(name, _): &(&str, &str)| says.contains(&name.to_lowercase().as_str());
    let token = TOKENS.lock().unwrap().get(&address).cloned();
    token.filter(|_| !headers.iter().any(says_who)).map(|token| format!("Bearer {token}"))
}

/// A server with a part folder of its own.
pub struct Shop {
    pub server: Server,
    pub dir: TempDir,
}

/// Change that a test makes to a machine.
pub type Change = fn(&mut kerf_machine::Configuration);

/// Attaches a controller to a workshop.
pub type Attach = Arc<dyn Fn(&mut Workshop) + Send + Sync>;

/// Differences of a test's server from the usual.
pub struct Wanted {
    pub rate: f64,
    pub lan: bool,
    pub files: Vec<(&'static str, &'static str)>,
    pub settings: fn(&mut kerf_program::Settings),
    /// A ready-made machine, and what is changed of it.
    pub machine: Option<(&'static str, Change)>,
    /// The controller that makes what is planned.
    pub attach: Option<Attach>,
    /// Its axes were homed.
    pub homed: bool,
    pub drawing_only: bool,
    pub start: Option<kerf_server::StartUp>,
    /// The start-up line.
    pub begin_with: Vec<&'static str>,
    /// The fake controller that the machine hangs on.
    pub controller: Option<Arc<Mutex<Fake>>>,
}

impl Default for Wanted {
    fn default() -> Self {
        Self {
            rate: 1.0,
            lan: false,
            files: Vec::new(),
            settings: |_| {},
            machine: None,
            attach: None,
            homed: true,
            drawing_only: false,
            start: None,
            begin_with: Vec::new(),
            controller: None,
        }
    }
}

/// A server with these files; machine time runs so much faster than the world's.
pub fn shop(rate: f64, files: &[(&'static str, &'static str)]) -> Shop {
    start(Wanted { rate, files: files.to_vec(), ..Wanted::default() })
}

pub fn start(wanted: Wanted) -> Shop {
    let dir = tempfile::tempdir().unwrap();
    let parts = dir.path().join("parts");
    std::fs::create_dir(&parts).unwrap();
    for (name, text) in &wanted.files {
        std::fs::write(parts.join(name), text).unwrap();
    }
    let options = Options {
        listen: SocketAddr::from(([127, 0, 0, 1], 0)),
        lan: wanted.lan,
        names: Vec::new(),
        parts: parts.clone(),
        data: dir.path().join("data"),
        drawing_only: wanted.drawing_only,
        open: None,
        closes_with_program: false,
        webhook: None,
        rate: wanted.rate,
        start: wanted.start,
        begin_with: wanted.begin_with.into_iter().map(str::to_owned).collect(),
    };
    let mut builders = builders(&parts, wanted.settings);
    if let Some((name, change)) = wanted.machine {
        let plain = builders.workshop;
        let homed = if wanted.homed { AxisSet::first(3) } else { AxisSet::EMPTY };
        builders.workshop = Arc::new(move || {
            let mut workshop = equipped(plain()?, name, change);
            workshop.session.homed = homed;
            Ok(workshop)
        });
    }
    if let Some(attach) = wanted.attach {
        let plain = builders.workshop;
        builders.workshop = Arc::new(move || {
            let mut workshop = plain()?;
            attach(&mut workshop);
            Ok(workshop)
        });
    }
    if let Some(fake) = wanted.controller {
        let plain = builders.workshop;
        builders.workshop = Arc::new(move || Ok(wired::attached(plain()?, fake.clone())));
    }
    let server = Server::start(options, builders).unwrap();
    if let Some((_, token)) = server.way_in().split_once("token=") {
        TOKENS.lock().unwrap().insert(server.address, token.to_owned());
    }
    Shop { server, dir }
}

/// A workshop with a ready-made machine.
fn equipped(mut workshop: Workshop, name: &str, change: Change) -> Workshop {
    let mut machine = kerf_machine::profile::profile(name).unwrap().configuration().unwrap();
    change(&mut machine);
    workshop.session.memory.settings = machine.program.clone();
    workshop.session.machine_is = Arc::new(machine);
    workshop
}

pub fn builders(parts: &Path, settings: fn(&mut kerf_program::Settings)) -> Builders {
    let (own, previews) = (parts.canonicalize().unwrap(), parts.canonicalize().unwrap());
    let folders = |parts: &PathBuf| Folders::new(parts.clone(), Vec::new(), Vec::new());
    let workshop = move || {
        let stored = Stored::in_memory(Default::default());
        let workspace = Workspace::new(Box::new(RealDisk), folders(&own), stored, own.join("data"));
        let mut session = Session::default();
        settings(&mut session.memory.settings);
        Ok(Workshop {
            session,
            workspace,
            controller: None,
            told: Default::default(),
            kept: false,
            started: || None,
        })
    };
    let preview = move || {
        let stored = Stored::in_memory(Default::default());
        Ok(Workspace::preview(RealDisk, folders(&previews), &stored, previews.join("data")))
    };
    Builders { workshop: Arc::new(workshop), preview: Arc::new(preview) }
}

/// A machine that is kept in a folder: a server on it again knows what was set.
pub fn kept(dir: TempDir) -> Shop {
    let (parts, data) = (dir.path().join("parts"), dir.path().join("data"));
    std::fs::create_dir_all(&parts).unwrap();
    let (own, kept) = (parts.canonicalize().unwrap(), data.clone());
    let workshop = move || {
        let journal = Journal::open(&kept).unwrap().0;
        let folders = Folders::new(own.clone(), Vec::new(), Vec::new());
        let stored = Stored::of(journal.clone()).unwrap();
        let mut workspace = Workspace::new(Box::new(RealDisk), folders, stored, kept.clone());
        let (session, _) = Session::recall(&journal, &mut workspace).unwrap();
        let workspace = workspace.with_shell(kerf_journal::Shell::Started);
        Ok(Workshop {
            session,
            workspace,
            controller: None,
            told: Default::default(),
            kept: true,
            started: || None,
        })
    };
    let options = Options {
        listen: SocketAddr::from(([127, 0, 0, 1], 0)),
        lan: false,
        names: Vec::new(),
        parts: parts.clone(),
        data,
        drawing_only: false,
        open: None,
        closes_with_program: false,
        webhook: None,
        rate: 1.0,
        start: None,
        begin_with: Vec::new(),
    };
    let builders = Builders { workshop: Arc::new(workshop), ..builders(&parts, |_| {}) };
    Shop { server: Server::start(options, builders).unwrap(), dir }
}

impl Shop {
    /// Puts a file into the part folder.
    pub fn write(&self, name: &str, bytes: &[u8]) {
        std::fs::write(self.part(name), bytes).unwrap();
    }

    pub fn part(&self, name: &str) -> PathBuf {
        self.dir.path().join("parts").join(name)
    }

    /// A page that is connected.
    pub fn page(&self) -> Page {
        Page::open(self.server.address, &[]).unwrap()
    }

    /// A page that drives.
    pub fn driver(&self) -> Page {
        let mut page = self.page();
        page.drive();
        page
    }

    /// An HTTP request: status, head and body.
    pub fn ask(&self, request: &str, headers: &[(&str, &str)], body: &[u8]) -> Answer {
        let mut stream = TcpStream::connect(self.server.address).unwrap();
        let mut text = format!("{request} HTTP/1.1\r\nConnection: close\r\n");
        if !headers.iter().any(|(name, _)| name.eq_ignore_ascii_case("host")) {
            text += &format!("Host: {}\r\n", self.server.address);
        }
        for (name, value) in headers {
            text += &format!("{name}: {value}\r\n");
        }
        let shows = at_machine(self.server.address, headers);
        shows.iter().for_each(|token| text += &format!("Authorization: {token}\r\n"));
        text += &format!("Content-Length: {}\r\n\r\n", body.len());
        // In one piece: a server that refuses by the head alone closes, and resets a line on which more comes.
        stream.write_all(&[text.as_bytes(), body].concat()).unwrap();
        let mut bytes = Vec::new();
        stream.read_to_end(&mut bytes).unwrap();
        Answer::of(&bytes)
    }

    pub fn get(&self, path: &str) -> Answer {
        self.ask(&format!("GET {path}"), &[], b"")
    }

    pub fn post(&self, path: &str, body: Value, headers: &[(&str, &str)]) -> Answer {
        let mut all = vec![("Content-Type", "application/json")];
        all.extend(headers);
        self.ask(&format!("POST {path}"), &all, body.to_string().as_bytes())
    }
}

/// An answer over HTTP.
#[derive(Debug)]
pub struct Answer {
    pub status: u16,
    pub head: String,
    pub body: Vec<u8>,
}

impl Answer {
    fn of(bytes: &[u8]) -> Self {
        let end = bytes.windows(4).position(|w| w == b"\r\n\r\n").unwrap_or(bytes.len());
        let head = String::from_utf8_lossy(&bytes[..end]).into_owned();
        let status = head.split(' ').nth(1).and_then(|s| s.parse().ok()).unwrap_or(0);
        Self {
            status,
            head: head.to_lowercase(),
            body: bytes[(end + 4).min(bytes.len())..].to_vec(),
        }
    }

    pub fn json(&self) -> Value {
        serde_json::from_slice(&self.body).unwrap_or(Value::Null)
    }
}

/// The server's clock, as a page reckons it from pings: at a moment it was between two times, ms.
#[derive(Clone, Copy, Debug)]
pub struct Reckoned {
    moment: Instant,
    low_ms: f64,
    high_ms: f64,
}

impl Default for Reckoned {
    fn default() -> Self {
        Self { moment: Instant::now(), low_ms: f64::NEG_INFINITY, high_ms: f64::INFINITY }
    }
}

impl Reckoned {
    fn heard(&mut self, sent: Instant, got: Instant, clock_ms: f64) {
        let since_ms = |moment: Instant| (moment - self.moment).as_secs_f64() * 1e3;
        self.low_ms = self.low_ms.max(clock_ms - since_ms(got));
        self.high_ms = self.high_ms.min(clock_ms - since_ms(sent));
    }

    fn now_ms(&self) -> f64 {
        let middle = f64::midpoint(self.low_ms, self.high_ms);
        let middle = if middle.is_finite() { middle } else { 0.0 };
        middle + self.moment.elapsed().as_secs_f64() * 1e3
    }
}

/// A page: its socket and what it shows.
pub struct Page {
    socket: WebSocket<TcpStream>,
    pub shown: Value,
    pub who: Value,
    pub lease: u64,
    /// The server's clock.
    pub reckoned: Reckoned,
    last: u64,
    /// Replies that came while something else was waited for.
    replies: Vec<Value>,
}

impl Page {
    pub fn open(address: SocketAddr, headers: &[(&str, &str)]) -> Result<Self, u16> {
        Self::through(address, address, headers)
    }

    /// A page whose way to the server is through another address.
    pub fn through(
        way: SocketAddr,
        address: SocketAddr,
        headers: &[(&str, &str)],
    ) -> Result<Self, u16> {
        let stream = TcpStream::connect(way).unwrap();
        stream.set_read_timeout(Some(Duration::from_millis(20))).unwrap();
        let mut request = format!("ws://{address}/ws").into_client_request().unwrap();
        request.headers_mut().insert("origin", format!("http://{address}").parse().unwrap());
        for (name, value) in headers {
            let name = tungstenite::http::HeaderName::from_bytes(name.as_bytes()).unwrap();
            if value.is_empty() {
                request.headers_mut().remove(name);
            } else {
                request.headers_mut().insert(name, value.parse().unwrap());
            }
        }
        if let Some(token) = at_machine(address, headers) {
            request.headers_mut().insert("authorization", token.parse().unwrap());
        }
        stream.set_read_timeout(Some(PATIENCE)).unwrap();
        let socket = match client(request, stream) {
            Ok((socket, _)) => socket,
            Err(tungstenite::HandshakeError::Failure(tungstenite::Error::Http(answer))) => {
                return Err(answer.status().as_u16());
            }
            Err(other) => panic!("{other}"),
        };
        socket.get_ref().set_read_timeout(Some(Duration::from_millis(10))).unwrap();
        let mut page = Self {
            socket,
            shown: Value::Null,
            who: Value::Null,
            lease: 0,
            reckoned: Reckoned::default(),
            last: 0,
            replies: Vec::new(),
        };
        page.until("a snapshot", |page| !page.shown.is_null());
        Ok(page)
    }

    /// Reads what is there; false when the connection has ended.
    pub fn read(&mut self) -> bool {
        let message = match self.socket.read() {
            Ok(Message::Text(text)) => serde_json::from_str::<Value>(&text).unwrap(),
            Ok(Message::Close(_)) => return false,
            Ok(_) => return true,
            Err(tungstenite::Error::Io(error))
                if error.kind() == std::io::ErrorKind::WouldBlock =>
            {
                return true;
            }
            Err(_) => return false,
        };
        match message["tell"].as_str() {
            Some("snapshot") => {
                self.shown = message["snapshot"].clone();
                self.who = message["who"].clone();
            }
            Some("changes") => {
                message["changes"].as_array().unwrap().iter().for_each(|c| self.change(c));
            }
            _ => self.replies.push(message),
        }
        true
    }

    fn change(&mut self, change: &Value) {
        let mut snapshot: kerf_wire::Snapshot = serde_json::from_value(self.shown.clone()).unwrap();
        snapshot.apply(serde_json::from_value(change.clone()).unwrap());
        self.shown = serde_json::to_value(snapshot).unwrap();
    }

    #[track_caller]
    pub fn until(&mut self, what: &str, holds: impl Fn(&Self) -> bool) {
        let begin = Instant::now();
        while !holds(self) {
            assert!(begin.elapsed() < PATIENCE, "waited for {what}: {:#}", self.shown);
            assert!(self.read(), "the connection ended before {what}");
        }
    }

    /// Waits for a state of the machine.
    #[track_caller]
    pub fn until_state(&mut self, state: &str) {
        self.until(state, |page| page.shown["machine"]["state"] == state);
    }

    /// Sends without waiting for the reply; gives the id.
    pub fn send(&mut self, act: Value) -> u64 {
        self.last += 1;
        let text = json!({ "id": self.last, "act": act }).to_string();
        self.socket.send(Message::text(text)).unwrap();
        self.last
    }

    /// Sends a message as it is.
    pub fn send_raw(&mut self, message: Message) {
        self.socket.send(message).unwrap();
    }

    /// Sends what no browser does: a message that is longer than any that is taken.
    pub fn garble(&mut self) {
        let length = (16_u64 << 20).to_be_bytes();
        self.socket.get_mut().write_all(&[&[0x81, 0xff], &length[..], b"mask"].concat()).unwrap();
    }

    /// Sends an act and waits for its reply: the sort of problem, or nothing.
    #[track_caller]
    pub fn act(&mut self, act: Value) -> Option<String> {
        let id = self.send(act);
        self.reply(id)
    }

    #[track_caller]
    pub fn reply(&mut self, id: u64) -> Option<String> {
        self.until("a reply", |page| page.replies.iter().any(|r| r["id"] == id));
        let place = self.replies.iter().position(|r| r["id"] == id).unwrap();
        let reply = self.replies.remove(place);
        reply["problem"]["why"].as_str().map(str::to_owned)
    }

    /// Problem that the reply to a request tells.
    #[track_caller]
    pub fn problem(&mut self, id: u64) -> String {
        self.until("a reply", |page| page.replies.iter().any(|r| r["id"] == id));
        let reply = self.replies.iter().find(|r| r["id"] == id).unwrap();
        reply["problem"]["text"].as_str().unwrap_or_default().to_owned()
    }

    /// Takes the machine and arms it.
    #[track_caller]
    pub fn drive(&mut self) {
        assert_eq!(self.act(json!({ "do": "takeLease", "force": true })), None);
        let mine = |page: &Self| page.shown["lease"]["client"] == page.who["client"];
        self.until("the lease", mine);
        self.lease = self.shown["lease"]["number"].as_u64().unwrap();
        assert_eq!(self.act(json!({ "do": "arm", "lease": self.lease })), None);
        self.measure();
    }

    /// Measures how far the server's clock is ahead, by a ping.
    pub fn measure(&mut self) {
        let sent = Instant::now();
        let id = self.send(json!({ "do": "ping" }));
        self.until("a pong", |page| page.replies.iter().any(|r| r["id"] == id));
        let place = self.replies.iter().position(|r| r["id"] == id).unwrap();
        let clock_ms = self.replies.remove(place)["clockMs"].as_f64().unwrap();
        self.reckoned.heard(sent, Instant::now(), clock_ms);
    }

    /// The server's clock now, ms.
    pub fn clock_ms(&self) -> f64 {
        self.reckoned.now_ms()
    }

    /// Opens a file and waits for its preview.
    #[track_caller]
    pub fn open_file(&mut self, name: &str) {
        assert_eq!(self.act(json!({ "do": "open", "name": name })), None);
        let ready = |page: &Self| {
            let opened = &page.shown["opened"];
            opened["name"] == name && opened["preview"]["state"] != "working"
        };
        self.until("the preview", ready);
    }

    /// Runs the open file.
    #[track_caller]
    pub fn run(&mut self) -> Option<String> {
        let (lease, hash) = (self.lease, self.shown["opened"]["hash"].clone());
        self.act(json!({ "do": "run", "lease": lease, "hash": hash }))
    }

    #[track_caller]
    pub fn command(&mut self, line: &str) {
        let lease = self.lease;
        assert_eq!(self.act(json!({ "do": "command", "lease": lease, "line": line })), None);
        self.until_state("idle");
    }

    pub fn x(&self) -> f64 {
        self.shown["motion"]["at"]["working"][0].as_f64().unwrap()
    }

    /// Changes a setting, and waits until it holds.
    #[track_caller]
    pub fn set(&mut self, key: &str, value: &str) {
        let before = self.shown["settings"].clone();
        let act = json!({ "do": "set", "lease": self.lease, "key": key, "value": value });
        assert_eq!(self.act(act), None);
        self.until("the setting", |page| page.shown["settings"] != before);
        self.until_state("idle");
    }

    /// The question that is open: number and kind.
    #[track_caller]
    pub fn asked(&mut self, kind: &str) -> u64 {
        self.until(kind, |page| page.shown["asked"]["kind"] == kind);
        self.shown["asked"]["number"].as_u64().unwrap()
    }
}
