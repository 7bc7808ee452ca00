//! A running server instead of the machine of the data folder: lines, files and values go to it over HTTP.

mod card;
mod ended;
mod runs;
mod values;

pub use card::Card;
pub use ended::Ended;
pub use runs::{Along, How};

use crate::data_args::{DataArgs, data_folder};
use crate::exit::Usage;
use crate::machine_choice::MachineChoice;
use crate::served;
use anyhow::{Context, Result, bail};
use ended::number_of_run;
use kerf_server::TOKEN_FILE;
use kerf_wire::ByHand;
use serde_json::{Value, json};
use std::io::{Read, Write};
use std::net::{TcpStream, ToSocketAddrs};
use std::thread::sleep;
use std::time::Duration;

/// Interval at which it is looked whether the machine is done.
const LOOK: Duration = Duration::from_millis(50);

/// Reason why a server does not heed an option, and what to do instead.
pub const OWN_MACHINE: &str = "by a server, which has its own machine, folders and settings: leave it out, set the \
    machine at the server (kerf set, its console), or run it here without --server";

/// Mend where a page drives the machine that is to be moved.
const DRIVEN: &str = "the machine was not moved: a page drives it. Press \"Give up control\" there, or move the \
    machine from that page";

/// Advice where a page has the machine.
const BESIDE: &str = "the lines were not sent. A line that may be carried out beside a page that drives is \
    passed in: kerf registry set uCommand 'MX,2'";

/// Error of a request that a server refused.
#[derive(Debug, thiserror::Error)]
#[error("{text}")]
struct Refused {
    text: String,
    /// The program has mistakes.
    mistake: bool,
}

/// A server.
pub struct Remote {
    address: String,
    /// Token that shows that this is the user of the server's computer, where the server asks for it.
    token: Option<String>,
}

impl Remote {
    /// The server of an address, as `http://127.0.0.1:8710`. One of this computer that lets others in asks for the
    /// token that is in the address it printed, or lies in its data folder.
    pub fn new(url: &str, data: &DataArgs) -> Result<Self> {
        let address = url.strip_prefix("http://").context("an address begins with http://")?;
        let (address, behind) = address.split_once('/').unwrap_or((address, ""));
        let (address, named) = (address.to_owned(), behind.strip_prefix("?token="));
        let kept = || is_here(&address).then(|| token(data)).flatten();
        let token = named.map(str::to_owned).or_else(kept);
        Ok(Self { address, token })
    }

    /// Carries lines out, after arming the machine where that is wanted, and waits for their end.
    pub fn send(&self, lines: &str, arm: bool) -> Result<Ended> {
        let sends = |lease: &Value, before: &Value| {
            self.act("command", json!({ "lease": lease, "line": lines }))?;
            self.until_over(number_of_run(before))
        };
        self.driving(BESIDE, arm, sends)
    }

    /// Has the server write a setting into the controller that it drives; returns what it tells of that.
    ///
    /// # Errors
    /// Its machine keeps none by number, or its controller refuses this one.
    pub fn keeps_setting(&self, number: u16, value: &str) -> Result<String> {
        self.driving(BESIDE, false, |lease, _| {
            self.act("command", json!({ "lease": lease, "line": format!("${number}={value}") }))?;
            loop {
                let now = self.state()?;
                let told = now["messages"].as_array().and_then(|all| all.last());
                let text = told.map_or("", |it| it["text"].as_str().unwrap_or_default()).to_owned();
                match told.map(|it| it["tone"] == "error") {
                    _ if now["machine"]["state"] != "idle" => sleep(LOOK),
                    Some(true) => bail!(text),
                    _ => return Ok(text),
                }
            }
        })
    }

    /// Moves the machine as whoever drives it, after arming it where that is wanted, and waits for the end.
    pub fn go(&self, way: &ByHand, arm: bool) -> Result<Ended> {
        self.driving(DRIVEN, arm, |lease, before| {
            self.act("go", json!({ "lease": lease, "way": way }))?;
            self.until_over(number_of_run(before))
        })
    }

    /// Does something as the one who drives, with the number of that turn and the state before it, after arming the
    /// machine where that is wanted. Whoever drove before goes on driving.
    fn driving<T>(
        &self,
        beside: &'static str,
        arm: bool,
        does: impl FnOnce(&Value, &Value) -> Result<T>,
    ) -> Result<T> {
        let before = self.state()?;
        self.act("takeLease", json!({ "force": false })).context(beside)?;
        let lease = self.state()?["lease"]["number"].clone();
        let armed = if arm { self.act("arm", json!({ "lease": lease })) } else { Ok(()) };
        let done = armed.and_then(|()| does(&lease, &before));
        if before["lease"].is_null() {
            self.act("giveLease", json!({ "lease": lease }))?;
        }
        done
    }

    /// Gives the password of the settings: for a while they may be changed from here.
    pub fn unlock(&self, password: &str) -> Result<()> {
        self.act("unlock", json!({ "password": password }))
    }

    fn until_over(&self, before: u64) -> Result<Ended> {
        let mut last = before;
        loop {
            let now = self.state()?;
            if let Some(ended) = Ended::of(&now, before) {
                return Ok(ended);
            }
            last = still_the_same(&now, last)?;
            sleep(LOOK);
        }
    }

    fn state(&self) -> Result<Value> {
        self.ask("GET", "/api/state", "")
    }

    fn act(&self, name: &str, fields: Value) -> Result<()> {
        self.ask("POST", &format!("/api/do/{name}"), &fields.to_string()).map(drop)
    }

    fn ask(&self, method: &str, path: &str, body: &str) -> Result<Value> {
        let answer = self.request(method, path, body)?;
        Ok(serde_json::from_str(&answer).unwrap_or_default())
    }

    /// One request, one connection; the text of the answer.
    fn request(&self, method: &str, path: &str, body: &str) -> Result<String> {
        let reached = || format!("no server is reached at {}", self.address);
        let mut stream = TcpStream::connect(&self.address).with_context(reached)?;
        let (host, length) = (&self.address, body.len());
        let head = "Connection: close\r\nContent-Type: application/json";
        let shows = self.token.iter().map(|token| format!("Authorization: Bearer {token}\r\n"));
        let shows: String = shows.collect();
        let request = format!(
            "{method} {path} HTTP/1.1\r\nHost: {host}\r\n{head}\r\n{shows}Content-Length: {length}\r\n\r\n{body}"
        );
        stream.write_all(request.as_bytes())?;
        let mut answer = Vec::new();
        stream.read_to_end(&mut answer)?;
        let answer = String::from_utf8_lossy(&answer);
        let (head, body) = answer.split_once("\r\n\r\n").with_context(reached)?;
        if head.split(' ').nth(1) != Some("200") {
            let problem: Value = serde_json::from_str(body).unwrap_or_default();
            let text = problem["text"].as_str().unwrap_or(body).to_owned();
            bail!(Refused { text, mistake: problem["why"] == "mistake" });
        }
        Ok(body.to_owned())
    }
}

/// The server that has the machine of a data folder, where one runs.
///
/// # Errors
/// Another machine is named: the server has its own.
pub fn beside(data: &DataArgs, choice: &MachineChoice) -> Result<Option<Remote>> {
    let Some(address) = served::address(&data_folder(data)?)? else { return Ok(None) };
    if let Some(name) = choice.configuration() {
        let name = name.display();
        bail!(Usage(format!(
            "--machine {name} is not heeded: a kerf serve at {address} has the machine of this data folder; leave it \
             out, or name another folder with --data"
        )));
    }
    let server = Remote::new(&address, data)?;
    if let Some(named) = choice.controller() {
        let name = server.state()?["machine"]["name"].clone();
        if name != named.words {
            let name = name.as_str().unwrap_or_default();
            bail!(Usage(format!(
                "--machine {named} is not heeded: a kerf serve at {address} has the machine of this data folder, \
                 {name}; leave it out, or name another folder with --data"
            )));
        }
    }
    Ok(Some(server))
}

/// Returns `true` if an address is one of this computer: the token is for nobody else.
fn is_here(address: &str) -> bool {
    let found = address.to_socket_addrs();
    found.is_ok_and(|mut all| all.all(|one| one.ip().to_canonical().is_loopback()))
}

/// The token in a data folder. A server that lets nobody else in needs none, and has none.
fn token(data: &DataArgs) -> Option<String> {
    let file = data_folder(data).ok()?.join(TOKEN_FILE);
    std::fs::read_to_string(file).ok()
}

/// The number of the run that a state tells of; refuses one before the last: the server that knew that has ended.
fn still_the_same(state: &Value, last: u64) -> Result<u64> {
    let number = number_of_run(state);
    if number < last {
        bail!("the server was started anew meanwhile: the run is over, and can be taken up there");
    }
    Ok(number)
}
