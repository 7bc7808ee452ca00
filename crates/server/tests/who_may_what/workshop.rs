//! A server with everybody who may ask it, and the states in which they do.

use super::rows::{Asks, Row};
use super::walk::caught_up;
use crate::support::{Page, Shop, Wanted, start};
use kerf_server::Role;
use serde_json::{Value, json};
use std::thread;
use std::time::{Duration, Instant};

/// Who does not come from the machine itself.
const ELSEWHERE: (&str, &str) = ("X-Forwarded-For", "10.0.0.7");

/// Longest wait for a state.
const PATIENCE: Duration = Duration::from_secs(60);

/// Who asks.
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

/// What the machine is doing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Doing {
    Disarmed,
    Armed,
    Running,
    Stopped,
    Asking,
    /// Whoever drove has gone since it asked.
    AskingDisarmed,
}

impl Doing {
    pub const ALL: [(Self, char); 6] = [
        (Self::Disarmed, 'D'),
        (Self::Armed, 'A'),
        (Self::Running, 'R'),
        (Self::Stopped, 'S'),
        (Self::Asking, 'Q'),
        (Self::AskingDisarmed, 'q'),
    ];

    pub const fn is_armed(self) -> bool {
        !matches!(self, Self::Disarmed | Self::AskingDisarmed)
    }
}

/// Somebody's device: its page, and its token for scripts.
struct Device {
    page: Page,
    token: String,
}

pub struct Workshop {
    shop: Shop,
    observer: Device,
    operator: Device,
    setter: Device,
    owner: Device,
    /// An operator and a setter who drive in turn.
    drivers: [Device; 2],
    seq: u64,
}

impl Workshop {
    pub fn open() -> Self {
        let shop = start(Wanted { lan: true, rate: 20.0, ..Wanted::default() });
        let device = |role| {
            let code = shop.server.show_code(role).unwrap();
            let pair = shop.post("/api/pair", json!({ "code": code, "name": "x" }), &[ELSEWHERE]);
            let token = pair.json()["token"].as_str().unwrap().to_owned();
            let bearer = format!("Bearer {token}");
            let headers = [ELSEWHERE, ("authorization", bearer.as_str())];
            Device { page: Page::open(shop.server.address, &headers).unwrap(), token }
        };
        let [observer, operator, setter, owner] =
            [Role::Observer, Role::Operator, Role::Setter, Role::Owner].map(device);
        let drivers = [Role::Operator, Role::Setter].map(device);
        Self { shop, observer, operator, setter, owner, drivers, seq: 0 }
    }

    fn device(&mut self, caller: Caller) -> &mut Device {
        match caller {
            Caller::Observer => &mut self.observer,
            Caller::Operator => &mut self.operator,
            Caller::Setter => &mut self.setter,
            Caller::Owner => &mut self.owner,
            Caller::SetterDriving => &mut self.drivers[1],
            _ => &mut self.drivers[0],
        }
    }

    /// What somebody who asks for that is told while the machine does this, in a word: `+` for who may.
    pub fn told(&mut self, row: &Row, caller: Caller, doing: Doing) -> String {
        let driver = usize::from(caller == Caller::SetterDriving);
        self.bring_to(row, driver, doing);
        self.keep_heard(driver);
        match &row.asks {
            Asks::Act(act) => self.told_of_act(caller, driver, act.clone()),
            Asks::Answer { words, .. } => {
                let question = self.drivers[driver].page.shown["asked"]["number"].clone();
                let act = json!({ "do": "answer", "question": question, "answer": words });
                self.told_of_act(caller, driver, act)
            }
            Asks::Value { key, value } => {
                let path = format!("PUT /api/registry/{key}").replace('$', "%24");
                self.told_of_request(caller, &path, value, "text/plain")
            }
            Asks::Route(route) => self.told_of_request(caller, route, "{}", "application/json"),
        }
    }

    fn told_of_act(&mut self, caller: Caller, driver: usize, mut act: Value) -> String {
        if act.get("lease").is_some() {
            act["lease"] = self.drivers[driver].page.lease.into();
        }
        if act.get("seq").is_some() {
            self.seq += 1;
            act["seq"] = self.seq.into();
        }
        if !caller.is_let_in() {
            let path = format!("POST /api/do/{}", act["do"].as_str().unwrap());
            act.as_object_mut().unwrap().remove("do");
            return self.told_of_request(caller, &path, &act.to_string(), "application/json");
        }
        word(self.device(caller).page.act(act).as_deref())
    }

    fn told_of_request(&mut self, caller: Caller, route: &str, body: &str, sort: &str) -> String {
        let bearer = format!("Bearer {}", self.device(caller).token);
        let mut headers = vec![("Content-Type", sort), ELSEWHERE];
        match caller {
            Caller::NoToken => {}
            Caller::ForeignHost => headers.push(("Host", "evil.example")),
            Caller::ForeignOrigin => headers.push(("Origin", "http://evil.example")),
            _ => {}
        }
        if caller != Caller::NoToken {
            headers.push(("Authorization", &bearer));
        }
        let answer = self.shop.ask(route, &headers, body.as_bytes());
        match answer.status {
            401 | 421 => answer.status.to_string(),
            403 if caller == Caller::ForeignOrigin => "403".into(),
            _ => word(answer.json()["why"].as_str()),
        }
    }

    /// Everybody in the order of a walk.
    pub fn page(&mut self, who: usize) -> &mut Page {
        let [operator, setter] = &mut self.drivers;
        let all = [&mut self.observer, &mut self.operator, &mut self.setter, &mut self.owner];
        let all = all.into_iter().chain([operator, setter]);
        &mut all.into_iter().nth(who).unwrap().page
    }

    /// What one who only looks is shown by now.
    pub fn watched(&mut self) -> Value {
        caught_up(&mut self.observer.page)
    }

    /// The column of one of them in the table, and whether it drives.
    pub fn column(&mut self, who: usize, shown: &Value) -> (usize, bool) {
        let page = self.page(who);
        page.look();
        let drives = shown["lease"]["client"] == page.who["client"];
        let caller = match page.who["role"].as_str().unwrap() {
            "observer" => Caller::Observer,
            "operator" if drives => Caller::OperatorDriving,
            "operator" => Caller::Operator,
            _ if drives => Caller::SetterDriving,
            "setter" => Caller::Setter,
            _ => Caller::Owner,
        };
        let column = Caller::ALL.iter().position(|(known, _)| *known == caller).unwrap();
        (column, drives)
    }

    /// Pages that wait are heard by the server.
    fn keep_heard(&mut self, driver: usize) {
        self.drivers[driver].page.read();
        for device in [&mut self.observer, &mut self.operator, &mut self.setter, &mut self.owner] {
            device.page.look();
        }
        self.drivers[1 - driver].page.look();
    }

    /// Has the machine do this, driven by one of the drivers.
    fn bring_to(&mut self, row: &Row, driver: usize, doing: Doing) {
        let program = match &row.asks {
            Asks::Answer { program: Some(program), .. } => program,
            _ => "MSGBOX(\"On?\",YesNo)",
        };
        let kind = match &row.asks {
            Asks::Answer { kind, .. } => kind,
            _ => "msgbox",
        };
        let page = &mut self.drivers[driver].page;
        let begun = Instant::now();
        let mut last = None;
        while !is_so(page, doing, kind) {
            let late = begun.elapsed() > PATIENCE;
            assert!(!late, "{doing:?}, {kind}, {last:?}: {:#}", page.shown["machine"]);
            last = step_towards(page, doing, kind, program).or(last);
            page.read();
        }
    }
}

/// The reason of a refusal that says who may not; whatever else is wrong, this one may.
fn word(why: Option<&str>) -> String {
    match why {
        Some(why @ ("role" | "lease" | "disarmed" | "password")) => why.into(),
        Some("malformed") => "never".into(),
        _ => "+".into(),
    }
}

fn is_so(page: &mut Page, doing: Doing, kind: &str) -> bool {
    page.look();
    let (shown, who) = (&page.shown, &page.who);
    let mine = shown["lease"]["client"] == who["client"] && shown["lease"]["number"] == page.lease;
    let asks = shown["asked"]["kind"].as_str();
    mine && shown["machine"]["armed"] == doing.is_armed()
        && match doing {
            Doing::Disarmed | Doing::Armed => shown["machine"]["state"] == "idle",
            Doing::Running => shown["machine"]["state"] == "running" && shown["pause"].is_object(),
            Doing::Stopped => asks == Some("hold"),
            Doing::Asking | Doing::AskingDisarmed => asks == Some(kind),
        }
}

/// Does one thing by which the machine comes nearer to a state.
fn step_towards(page: &mut Page, doing: Doing, kind: &str, program: &str) -> Option<String> {
    let (state, armed) = (page.shown["machine"]["state"].clone(), &page.shown["machine"]["armed"]);
    let mine = page.shown["lease"]["client"] == page.who["client"];
    let stopped_first = doing == Doing::Stopped || kind == "hold";
    let asks = page.shown["asked"]["kind"].as_str().unwrap_or_default().to_owned();
    let lease = page.lease;
    let act = match state.as_str().unwrap() {
        _ if !mine => json!({ "do": "takeLease", "force": true }),
        "alarm" => json!({ "do": "acknowledge" }),
        "idle" if doing == Doing::Disarmed => json!({ "do": "disarm" }),
        "idle" if armed == false => json!({ "do": "arm", "lease": lease }),
        "idle" if doing == Doing::Running || stopped_first => {
            json!({ "do": "command", "lease": lease, "line": "PAUSE 3600" })
        }
        "idle" => json!({ "do": "command", "lease": lease, "line": program }),
        "running" if doing == Doing::Running && armed == false => {
            json!({ "do": "arm", "lease": lease })
        }
        "running" if stopped_first && page.shown["pause"].is_object() => json!({ "do": "stop" }),
        "running" if doing == Doing::Running || page.shown["pause"].is_null() => return None,
        _ if doing == Doing::AskingDisarmed && asks == kind => {
            json!({ "do": "giveLease", "lease": lease })
        }
        _ if asks == kind || doing == Doing::Stopped && asks == "hold" => {
            json!({ "do": "arm", "lease": lease })
        }
        _ => json!({ "do": "stop" }),
    };
    let takes = act["do"] == "takeLease";
    let id = page.send(act.clone());
    let told = page.problem(id);
    if takes {
        page.look();
        page.lease = page.shown["lease"]["number"].as_u64().unwrap_or_default();
    }
    thread::sleep(Duration::from_millis(1));
    Some(format!("{act}: {told}"))
}
