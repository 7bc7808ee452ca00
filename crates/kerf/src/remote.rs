//! Lines that are sent to a running server instead of the machine of the data folder.

use anyhow::{Context, Result, bail};
use serde_json::{Value, json};
use std::io::{Read, Write};
use std::net::TcpStream;
use std::thread::sleep;
use std::time::Duration;

/// How often it is looked whether the machine is done.
const LOOK: Duration = Duration::from_millis(50);

/// What to do where a page has the machine.
const BESIDE: &str = "the lines were not sent. A line that may be carried out beside a page that drives is \
    passed in: kerf registry set uCommand 'MX,2'";

/// A server.
pub struct Remote {
    address: String,
}

impl Remote {
    /// The server of an address, as `http://127.0.0.1:8710`.
    pub fn new(url: &str) -> Result<Self> {
        let address = url.strip_prefix("http://").context("an address begins with http://")?;
        Ok(Self { address: address.trim_end_matches('/').to_owned() })
    }

    /// Carries lines out and waits for their end; what it was, as the trace writes it.
    pub fn send(&self, lines: &str) -> Result<String> {
        let before = self.state()?;
        self.act("takeLease", json!({ "force": false })).context(BESIDE)?;
        let lease = self.state()?["lease"]["number"].clone();
        let (driven, before) = (!before["lease"].is_null(), before["job"]["run"].as_u64());
        let before = before.unwrap_or_default();
        let sent = self.act("command", json!({ "lease": lease, "line": lines }));
        let ended = sent.and_then(|()| self.until_over(before));
        if !driven {
            self.act("giveLease", json!({ "lease": lease }))?;
        }
        ended
    }

    /// Gives the password of the settings: for a while they may be changed from here.
    pub fn unlock(&self, password: &str) -> Result<()> {
        self.act("unlock", json!({ "password": password }))
    }

    fn until_over(&self, before: u64) -> Result<String> {
        loop {
            let job = self.state()?["job"].clone();
            if let (Some(ended), true) = (job["ended"].as_str(), job["run"].as_u64() > Some(before))
            {
                return Ok(ended.to_owned());
            }
            sleep(LOOK);
        }
    }

    fn state(&self) -> Result<Value> {
        self.ask("GET", "/api/state", "")
    }

    fn act(&self, name: &str, fields: Value) -> Result<()> {
        self.ask("POST", &format!("/api/do/{name}"), &fields.to_string()).map(drop)
    }

    /// One request, one connection.
    fn ask(&self, method: &str, path: &str, body: &str) -> Result<Value> {
        let reached = || format!("no server is reached at {}", self.address);
        let mut stream = TcpStream::connect(&self.address).with_context(reached)?;
        let (host, length) = (&self.address, body.len());
        let head = "Connection: close\r\nContent-Type: application/json";
        let request = format!(
            "{method} {path} HTTP/1.1\r\nHost: {host}\r\n{head}\r\nContent-Length: {length}\r\n\r\n{body}"
        );
        stream.write_all(request.as_bytes())?;
        let mut answer = Vec::new();
        stream.read_to_end(&mut answer)?;
        let answer = String::from_utf8_lossy(&answer);
        let (head, body) = answer.split_once("\r\n\r\n").with_context(reached)?;
        let value: Value = serde_json::from_str(body).unwrap_or_default();
        if head.split(' ').nth(1) != Some("200") {
            bail!("{}", value["text"].as_str().unwrap_or(body));
        }
        Ok(value)
    }
}
