//! A server with everybody who may ask it, and the states in which they do.

use super::rows::{Asks, Row};
use crate::support::{Answer, Page, Shop, Wanted, start};
use kerf_server::Role;
use serde_json::{Value, json};
use std::cell::RefCell;
use std::thread;
use std::time::{Duration, Instant};

/// Header of a request that does not come from the machine itself.
const ELSEWHERE: (&str, &str) = ("X-Forwarded-For", "10.0.0.7");

/// Longest wait for a state.
const PATIENCE: Duration = Duration::from_secs(60);

/// So long a pause takes to be told.
const SOON: Duration = Duration::from_millis(500);

/// Caller that asks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Caller {
    NoToken,
    ForeignHost,
    ForeignOrigin,
    Observer,
    Operator,
    OperatorDriving,
    Setter,
    SetterDriving,
    Owner,
}

impl Caller {
    pub const ALL: [(Self, &'static str); 9] = [
        (Self::NoToken, "no token"),
        (Self::ForeignHost, "foreign Host"),
        (Self::ForeignOrigin, "foreign Origin"),
        (Self::Observer, "observer"),
        (Self::Operator, "operator"),
        (Self::OperatorDriving, "operator who drives"),
        (Self::Setter, "setter"),
        (Self::SetterDriving, "setter who drives"),
        (Self::Owner, "owner"),
    ];

    /// Comes through the guard.
    pub const fn is_let_in(self) -> bool {
        !matches!(self, Self::NoToken | Self::ForeignHost | Self::ForeignOrigin)
    }

    pub const fn drives(self) -> bool {
        matches!(self, Self::OperatorDriving | Self::SetterDriving)
    }
}

/// State of the machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Doing {
    Disarmed,
    Armed,
    Running,
    Stopped,
    /// Whoever drove has gone since it was stopped.
    StoppedDisarmed,
    Asking,
    /// Whoever drove has gone since it asked.
    AskingDisarmed,
}

impl Doing {
    pub const ALL: [(Self, char); 7] = [
        (Self::Disarmed, 'D'),
        (Self::Armed, 'A'),
        (Self::Running, 'R'),
        (Self::Stopped, 'S'),
        (Self::StoppedDisarmed, 's'),
        (Self::Asking, 'Q'),
        (Self::AskingDisarmed, 'q'),
    ];

    pub const fn is_armed(self) -> bool {
        !matches!(self, Self::Disarmed | Self::StoppedDisarmed | Self::AskingDisarmed)
    }
}

/// Somebody's device, by the token of its scripts.
struct Device {
    role: Role,
    bearer: String,
    /// Its number as a driver.
    client: u64,
    /// The page at which it drives, where it asks at one.
    page: RefCell<Option<Page>>,
}

/// Number of the scripts of the machine itself as a driver; those of devices count down from it.
const SCRIPTS: u64 = u32::MAX as u64;

pub struct Workshop {
    shop: Shop,
    /// An observer, an operator, a setter, an owner; an operator and a setter who drive in turn.
    devices: Vec<Device>,
    seq: u64,
}

const ROLES: [Role; 6] =
    [Role::Observer, Role::Operator, Role::Setter, Role::Owner, Role::Operator, Role::Setter];

impl Workshop {
    /// Machine time runs so much faster than the world's.
    pub fn open(rate: f64) -> Self {
        let shop = start(Wanted { lan: true, rate, ..Wanted::default() });
        let device = |(role, number): (Role, u64)| {
            let code = shop.server.show_code(role).unwrap();
            let pair = shop.post("/api/pair", json!({ "code": code, "name": "x" }), &[ELSEWHERE]);
            let bearer = format!("Bearer {}", pair.json()["token"].as_str().unwrap());
            Device { role, bearer, client: SCRIPTS - number, page: RefCell::default() }
        };
        let devices = ROLES.into_iter().zip(1..).map(device).collect();
        Self { shop, devices, seq: 0 }
    }

    fn device(&self, caller: Caller) -> &Device {
        let at = match caller {
            Caller::Observer => 0,
            Caller::Operator => 1,
            Caller::Setter => 2,
            Caller::Owner => 3,
            Caller::SetterDriving => 5,
            _ => 4,
        };
        &self.devices[at]
    }

    /// Fetches the state that pages show now.
    pub fn shown(&self) -> Value {
        let answer = self.ask("GET /api/state", &self.devices[0], "");
        serde_json::from_slice(&answer.body).unwrap()
    }

    fn ask(&self, request: &str, device: &Device, body: &str) -> Answer {
        let token = ("Authorization", device.bearer.as_str());
        let headers = [("Content-Type", "application/json"), ELSEWHERE, token];
        self.shop.ask(request, &headers, body.as_bytes())
    }

    /// Does an act, as one of the devices: the sort of problem, or nothing.
    pub fn act(&self, who: usize, act: &Value) -> Option<String> {
        let (path, body) = request(act);
        let answer = self.ask(&path, &self.devices[who], &body).json();
        answer["why"].as_str().map(str::to_owned)
    }

    /// A page of somebody; the status of HTTP that says why there is none.
    fn page(&self, caller: Caller) -> Result<Page, u16> {
        let bearer = &self.device(caller).bearer;
        let headers: &[_] = match caller {
            Caller::NoToken => &[ELSEWHERE],
            Caller::ForeignHost => {
                &[ELSEWHERE, ("authorization", bearer), ("host", "evil.example")]
            }
            Caller::ForeignOrigin => {
                &[ELSEWHERE, ("authorization", bearer), ("origin", "http://evil.example")]
            }
            _ => &[ELSEWHERE, ("authorization", bearer)],
        };
        Page::open(self.shop.server.address, headers)
    }

    /// The number of one of the devices as a driver: at its page, where that is how it asks.
    fn client(&self, who: usize, at_page: bool) -> u64 {
        let Device { client, page, .. } = &self.devices[who];
        if !at_page {
            page.take();
            return *client;
        }
        let mut page = page.borrow_mut();
        let caller = if who == 5 { Caller::SetterDriving } else { Caller::OperatorDriving };
        let page = page.get_or_insert_with(|| self.page(caller).unwrap());
        page.who["client"].as_u64().unwrap()
    }

    /// Does an act as one of the devices: at its page, where it has one.
    fn does(&self, who: usize, act: &Value) -> Option<String> {
        let mut page = self.devices[who].page.borrow_mut();
        match page.as_mut() {
            Some(page) => page.act(act.clone()),
            None => self.act(who, act),
        }
    }

    /// Answer at a page of somebody who asks for that.
    fn told_at_page(&self, caller: Caller, mut act: Value) -> String {
        if caller.drives() {
            let device = self.device(caller);
            return word(act_at(device.page.borrow_mut().as_mut().unwrap(), act).as_deref());
        }
        match self.page(caller) {
            Ok(mut page) => word(act_at(&mut page, act.take()).as_deref()),
            Err(status) => status.to_string(),
        }
    }

    /// Answer to somebody who asks for that while the machine does this, in a word: `+` for who may.
    pub fn told(&mut self, row: &Row, caller: Caller, doing: Doing) -> String {
        let driver = if caller == Caller::SetterDriving { 5 } else { 4 };
        let shown = self.bring_to(row, driver, doing);
        match &row.asks {
            Asks::Act(act) => self.told_of_act(caller, &shown, act.clone()),
            Asks::Page(act) => {
                let act = self.filled_in(&shown, act.clone());
                self.told_at_page(caller, act)
            }
            Asks::Answer { words, .. } => {
                let question = &shown["asked"]["number"];
                let act = json!({ "do": "answer", "question": question, "answer": words });
                let told = self.told_of_act(caller, &shown, act);
                // What was answered is asked no more, before somebody else answers.
                let begun = Instant::now();
                while told == "+" && &self.shown()["asked"]["number"] == question {
                    assert!(begun.elapsed() < PATIENCE, "{} is not heard", row.name);
                    thread::sleep(Duration::from_millis(1));
                }
                told
            }
            Asks::Value { key, value } => {
                let path = format!("PUT /api/registry/{key}").replace('$', "%24");
                self.told_of_request(caller, &path, value, "text/plain")
            }
            Asks::Route(route) => {
                let lease = &shown["lease"]["number"];
                let body = match *route {
                    "POST /api/job/start" => json!({ "lease": lease, "hash": "none" }),
                    "POST /api/pair/code" => json!({ "role": "observer" }),
                    _ => json!({}),
                };
                self.told_of_request(caller, route, &body.to_string(), "application/json")
            }
        }
    }

    fn told_of_act(&mut self, caller: Caller, shown: &Value, act: Value) -> String {
        let (path, body) = request(&self.filled_in(shown, act));
        self.told_of_request(caller, &path, &body, "application/json")
    }

    /// An act with the number of the lease, and with one of its own where it is of a held key.
    fn filled_in(&mut self, shown: &Value, mut act: Value) -> Value {
        if act.get("lease").is_some() {
            act["lease"] = shown["lease"]["number"].clone();
        }
        if act.get("seq").is_some() {
            self.seq += 1;
            act["seq"] = self.seq.into();
        }
        act
    }

    fn told_of_request(&self, caller: Caller, route: &str, body: &str, sort: &str) -> String {
        let mut headers = vec![("Content-Type", sort), ELSEWHERE];
        match caller {
            Caller::ForeignHost => headers.push(("Host", "evil.example")),
            Caller::ForeignOrigin => headers.push(("Origin", "http://evil.example")),
            _ => {}
        }
        if caller != Caller::NoToken {
            headers.push(("Authorization", &self.device(caller).bearer));
        }
        let answer = self.shop.ask(route, &headers, body.as_bytes());
        match answer.status {
            401 if caller == Caller::NoToken => "401".into(),
            421 => "421".into(),
            403 if caller == Caller::ForeignOrigin => "403".into(),
            _ => word(answer.json()["why"].as_str()),
        }
    }

    /// Has the machine do this, driven by one of the drivers; what is shown then.
    fn bring_to(&self, row: &Row, driver: usize, doing: Doing) -> Value {
        let (program, kind) = match &row.asks {
            Asks::Answer { program, kind, .. } => (program.unwrap_or_default(), *kind),
            _ => ("MSGBOX(\"On?\",YesNo)", "msgbox"),
        };
        let (begun, mut last) = (Instant::now(), None);
        let client = self.client(driver, matches!(row.asks, Asks::Page(_)));
        loop {
            let shown = self.shown();
            if is_so(&shown, client, doing, kind) {
                return shown;
            }
            let (name, since) = (&row.name, begun.elapsed());
            assert!(since < PATIENCE, "{name}, {doing:?}, {last:?}: {:#}", shown["machine"]);
            // What comes about late is stopped, and then has as long to come about anew.
            let late = since.as_millis() / SOON.as_millis() % 2 == 1;
            if let Some(act) = step_towards(&shown, client, doing, kind, program, late) {
                last = Some(format!("{act}: {:?}", self.does(driver, &act)));
            }
            thread::sleep(Duration::from_millis(1));
        }
    }

    /// Whoever of the devices drives.
    pub fn driver(&self, shown: &Value) -> Option<usize> {
        self.devices.iter().position(|device| shown["lease"]["client"] == device.client)
    }

    /// The column of one of the devices in the table, and whether it drives.
    pub fn column(&self, who: usize, shown: &Value) -> (usize, bool) {
        let Device { role, client, .. } = &self.devices[who];
        let drives = shown["lease"]["client"] == *client;
        let caller = match role {
            Role::Observer => Caller::Observer,
            Role::Operator if drives => Caller::OperatorDriving,
            Role::Operator => Caller::Operator,
            _ if drives => Caller::SetterDriving,
            Role::Setter => Caller::Setter,
            Role::Owner => Caller::Owner,
        };
        let column = Caller::ALL.iter().position(|(known, _)| *known == caller).unwrap();
        (column, drives)
    }
}

/// Does an act at a page, with the server's clock where it is of a held key.
fn act_at(page: &mut Page, mut act: Value) -> Option<String> {
    if act.get("clockMs").is_some() {
        page.measure();
        act["clockMs"] = page.clock_ms().into();
    }
    page.act(act)
}

/// The request by which a script asks for an act.
fn request(act: &Value) -> (String, String) {
    let (path, mut fields) = (format!("POST /api/do/{}", act["do"].as_str().unwrap()), act.clone());
    fields.as_object_mut().unwrap().remove("do");
    (path, fields.to_string())
}

/// The reason of a refusal that says who may not; whatever else is wrong, this one may.
fn word(why: Option<&str>) -> String {
    match why {
        Some(why @ ("role" | "lease" | "disarmed" | "password")) => why.into(),
        Some("malformed") => "never".into(),
        _ => "+".into(),
    }
}

fn is_so(shown: &Value, client: u64, doing: Doing, kind: &str) -> bool {
    let (state, asks) = (shown["machine"]["state"].as_str(), shown["asked"]["kind"].as_str());
    shown["lease"]["client"] == client
        && shown["machine"]["armed"] == doing.is_armed()
        && match doing {
            Doing::Disarmed | Doing::Armed => state == Some("idle"),
            Doing::Running => state == Some("running") && shown["pause"].is_object(),
            Doing::Stopped | Doing::StoppedDisarmed => asks == Some("hold"),
            Doing::Asking | Doing::AskingDisarmed => asks == Some(kind),
        }
}

/// The one thing by which the machine comes nearer to a state; nothing where that is to be waited for.
fn step_towards(
    shown: &Value,
    client: u64,
    doing: Doing,
    kind: &str,
    program: &str,
    late: bool,
) -> Option<Value> {
    let (state, armed) = (shown["machine"]["state"].as_str().unwrap(), &shown["machine"]["armed"]);
    let (lease, pauses) = (&shown["lease"]["number"], shown["pause"].is_object());
    let stops = matches!(doing, Doing::Stopped | Doing::StoppedDisarmed);
    let stopped_first = stops || kind == "hold";
    let asks = shown["asked"]["kind"].as_str().unwrap_or_default();
    let command = |line: String| json!({ "do": "command", "lease": lease, "line": line });
    Some(match state {
        _ if shown["lease"]["client"] != client => json!({ "do": "takeLease", "force": true }),
        "alarm" => json!({ "do": "acknowledge" }),
        "idle" if doing == Doing::Disarmed => json!({ "do": "disarm" }),
        "idle" if armed == false => json!({ "do": "arm", "lease": lease }),
        "idle" if doing == Doing::Running || stopped_first => command("PAUSE 3600\n&x=0".into()),
        "idle" => command(format!("{program}\n&x=0")),
        "running" if doing == Doing::Running && armed == false => {
            json!({ "do": "arm", "lease": lease })
        }
        "running" if stopped_first && pauses => json!({ "do": "stop" }),
        // A pause that went on after a stop is told no more: it is made anew.
        "running" if !late && (doing == Doing::Running || !pauses) => return None,
        _ if doing == Doing::AskingDisarmed && asks == kind
            || doing == Doing::StoppedDisarmed && asks == "hold" =>
        {
            json!({ "do": "giveLease", "lease": lease })
        }
        _ if doing == Doing::Asking && asks == kind
            || doing == Doing::Stopped && asks == "hold" =>
        {
            json!({ "do": "arm", "lease": lease })
        }
        _ => json!({ "do": "stop" }),
    })
}
