//! Whoever drives: starts a move, presses STOP in the middle of it, measures how long that took to be heard.

use super::shop::{PATIENCE, Shop, socket};
use serde_json::{Value, json};
use std::net::{SocketAddr, TcpStream};
use std::time::{Duration, Instant};
use tungstenite::{Message, WebSocket};

/// The device that drives.
const DRIVER: usize = 0;
/// So far it goes to either side, inches: no stop comes too late.
const WAY_IN: f64 = 15.0;

/// A page that drives.
pub struct Driver {
    main: WebSocket<TcpStream>,
    /// STOP's own way, where the server has one.
    own: Option<WebSocket<TcpStream>>,
    shown: Shown,
    last: u64,
    turn: u64,
    /// The question that was answered last.
    answered: u64,
    address: SocketAddr,
}

/// As much of the snapshot as matters here.
#[derive(Default)]
struct Shown {
    state: String,
    speed_mm_s: f64,
    lease: u64,
    client: u64,
    question: u64,
    stop_port: u16,
    replies: Vec<(u64, Option<String>)>,
}

impl Driver {
    /// Takes the machine, arms it and makes it slow.
    pub fn at(shop: &Shop) -> Self {
        let mut driver = Self::connected(shop.address);
        driver.drive();
        assert_eq!(driver.command("VS,1,1"), None, "slow");
        driver.until("idle", |shown| shown.state == "idle");
        driver
    }

    fn connected(address: SocketAddr) -> Self {
        let main = socket(address, "/ws", address, DRIVER).expect("the driver's page connects");
        let mut driver = Self {
            main,
            own: None,
            shown: Shown::default(),
            last: 0,
            turn: 0,
            answered: 0,
            address,
        };
        driver.until("a snapshot", |shown| shown.client > 0);
        driver.own = driver.own_way();
        driver
    }

    /// STOP's own way, unless only the console's is to be measured.
    fn own_way(&self) -> Option<WebSocket<TcpStream>> {
        let Shown { client, stop_port, .. } = self.shown;
        if stop_port == 0 || std::env::var("KERF_WAY").is_ok_and(|way| way == "main") {
            return None;
        }
        let at = SocketAddr::new(self.address.ip(), stop_port);
        let socket = socket(at, &format!("/stop?client={client}"), self.address, DRIVER);
        Some(socket.expect("STOP's own way is open"))
    }

    fn drive(&mut self) {
        let reply = self.act(json!({ "do": "takeLease", "force": true }));
        assert_eq!(reply, None, "the lease");
        self.until("the lease", |shown| shown.lease > 0);
        let lease = self.shown.lease;
        assert_eq!(self.act(json!({ "do": "arm", "lease": lease })), None, "armed");
    }

    /// Presses STOP in the middle of a move and times it until it is heard; nothing where it came too late or the
    /// page was thrown out meanwhile.
    pub fn stop(&mut self, patience: Duration) -> Option<(Instant, Instant)> {
        self.turn += 1;
        let way = if self.turn.is_multiple_of(2) { WAY_IN } else { -WAY_IN };
        let begin = Instant::now();
        while self.command(&format!("MX,{way}")).is_some() {
            assert!(begin.elapsed() < PATIENCE, "a move is refused again and again");
        }
        self.until("a move", |shown| shown.speed_mm_s > 0.0);
        // Somewhere in the time between two pictures.
        std::thread::sleep(Duration::from_millis(self.turn * 7 % 33));
        let pressed = Instant::now();
        let id = self.press(json!({ "do": "stop" }));
        let heard = self.heard(id, patience);
        let before = self.answered;
        self.until("standing", |shown| shown.state == "stopped" && shown.question > before);
        let question = self.shown.question;
        self.answered = question;
        self.act(json!({ "do": "answer", "question": question, "answer": "Quit" }));
        self.until("the end", |shown| shown.state == "idle");
        heard.map(|heard| (pressed, heard))
    }

    /// Presses on both ways, as a page does.
    fn press(&mut self, act: Value) -> u64 {
        let text = json!({ "id": self.last + 1, "act": act }).to_string();
        if let Some(own) = &mut self.own {
            own.send(Message::text(text)).unwrap();
        }
        self.send(act)
    }

    /// Moment at which a press was heard, on STOP's own way where there is one.
    fn heard(&mut self, id: u64, patience: Duration) -> Option<Instant> {
        let Some(own) = &mut self.own else {
            return self.replied(id, patience).map(|_| Instant::now());
        };
        let begin = Instant::now();
        while begin.elapsed() < patience {
            let message = own.read().expect("STOP's own way stays open");
            let Message::Text(text) = message else { continue };
            let told: Value = serde_json::from_str(&text).unwrap();
            if told["id"] == id {
                return Some(Instant::now());
            }
        }
        None
    }

    fn command(&mut self, line: &str) -> Option<String> {
        let lease = self.shown.lease;
        self.act(json!({ "do": "command", "lease": lease, "line": line }))
    }

    fn act(&mut self, act: Value) -> Option<String> {
        let id = self.send(act);
        self.replied(id, PATIENCE).expect("a reply in time")
    }

    fn send(&mut self, act: Value) -> u64 {
        self.last += 1;
        let text = json!({ "id": self.last, "act": act }).to_string();
        self.main.send(Message::text(text)).unwrap();
        self.last
    }

    /// The problem that a reply tells, if it comes in time.
    fn replied(&mut self, id: u64, patience: Duration) -> Option<Option<String>> {
        let begin = Instant::now();
        loop {
            if let Some(at) = self.shown.replies.iter().position(|(of, _)| *of == id) {
                return Some(self.shown.replies.swap_remove(at).1);
            }
            if begin.elapsed() > patience {
                return None;
            }
            self.read();
        }
    }

    #[track_caller]
    fn until(&mut self, what: &str, holds: impl Fn(&Shown) -> bool) {
        let begin = Instant::now();
        while !holds(&self.shown) {
            assert!(begin.elapsed() < PATIENCE, "waited for {what}: {}", self.shown.state);
            self.read();
        }
    }

    fn read(&mut self) {
        let message = self.main.read().expect("the driver's page stays connected");
        let Message::Text(text) = message else { return };
        let told: Value = serde_json::from_str(&text).unwrap();
        match told["tell"].as_str() {
            Some("snapshot") => {
                self.shown.client = told["who"]["client"].as_u64().unwrap();
                let snapshot = &told["snapshot"];
                self.shown.stop_port = snapshot["stopPort"].as_u64().unwrap_or(0) as u16;
                for part in ["machine", "motion", "lease", "asked"] {
                    self.shown.see(part, &snapshot[part]);
                }
            }
            Some("changes") => {
                for change in told["changes"].as_array().unwrap() {
                    let part = change["change"].as_str().unwrap();
                    self.shown.see(part, &change[part]);
                }
            }
            _ => {
                let why = told["problem"]["text"].as_str().map(str::to_owned);
                self.shown.replies.push((told["id"].as_u64().unwrap(), why));
            }
        }
    }
}

impl Shown {
    fn see(&mut self, part: &str, value: &Value) {
        match part {
            "machine" => self.state = value["state"].as_str().unwrap_or_default().into(),
            "motion" => self.speed_mm_s = value["speedMmS"].as_f64().unwrap_or(0.0),
            "lease" => self.lease = value["number"].as_u64().unwrap_or(0),
            "asked" => self.question = value["number"].as_u64().unwrap_or(0),
            _ => {}
        }
    }
}
