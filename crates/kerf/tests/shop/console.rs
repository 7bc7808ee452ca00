//! A `kerf serve` that runs beside a test.

use super::Shop;

/// A console that is served, and ends with the test.
pub struct Console {
    pub child: std::process::Child,
    pub url: String,
}

impl Console {
    pub fn begin(shop: &Shop, options: &[&str]) -> Self {
        Self::begin_with(shop, options, |command| command)
    }

    /// The same, started in another way.
    pub fn begin_with(
        shop: &Shop,
        options: &[&str],
        started: impl FnOnce(std::process::Command) -> std::process::Command,
    ) -> Self {
        use std::io::{BufRead, BufReader};
        let mut command = shop.command();
        command.args(["serve", "--rate", "50"]).args(options);
        if !options.contains(&"--listen") {
            command.args(["--listen", "127.0.0.1:0"]);
        }
        let mut child = started(command).stdout(std::process::Stdio::piped()).spawn().unwrap();
        let mut line = String::new();
        BufReader::new(child.stdout.take().unwrap()).read_line(&mut line).unwrap();
        Self { child, url: line.trim().rsplit(' ').next().unwrap().to_owned() }
    }

    pub fn ask(&self, request: &str, body: &str) -> serde_json::Value {
        self.answer(request, body).1
    }

    /// The status of an answer, and what it says.
    pub fn answer(&self, request: &str, body: &str) -> (u16, serde_json::Value) {
        use std::io::{Read, Write};
        let address = self.url.strip_prefix("http://").unwrap();
        let mut stream = std::net::TcpStream::connect(address).unwrap();
        let length = body.len();
        let head = "Connection: close\r\nContent-Type: application/json";
        let text = format!(
            "{request} HTTP/1.1\r\nHost: {address}\r\n{head}\r\nContent-Length: {length}\r\n\r\n{body}"
        );
        stream.write_all(text.as_bytes()).unwrap();
        let mut answer = String::new();
        stream.read_to_string(&mut answer).unwrap();
        let (head, body) = answer.split_once("\r\n\r\n").unwrap();
        let status = head.split(' ').nth(1).and_then(|status| status.parse().ok());
        (status.unwrap_or(0), serde_json::from_str(body).unwrap_or_default())
    }

    /// Arms the machine and has a line carried out.
    pub fn carry_out(&self, line: &str) {
        self.ask("POST /api/do/takeLease", r#"{"force":true}"#);
        let lease = self.ask("GET /api/state", "")["lease"]["number"].clone();
        self.ask("POST /api/do/arm", &format!("{{\"lease\":{lease}}}"));
        self.ask("POST /api/do/command", &format!("{{\"lease\":{lease},\"line\":\"{line}\"}}"));
    }
}

impl Drop for Console {
    fn drop(&mut self) {
        drop(self.child.kill());
        drop(self.child.wait());
    }
}
