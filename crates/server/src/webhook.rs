//! Tells another program over HTTP when somebody is needed, and how runs end.

use crate::hub::Hub;
use kerf_wire::{Change, Snapshot, ToPage, Tone};
use serde::Serialize;
use std::io;
use std::sync::{Arc, Weak};
use std::time::Duration;
use tokio::sync::broadcast::error::RecvError;
use tokio::task::spawn_blocking;
use ureq::Agent;

/// Longest time for one message.
const LONGEST: Duration = Duration::from_secs(10);

/// Address of the messages: `http://HOST[:PORT]/PATH` or `https://…`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Webhook {
    address: String,
    host: String,
}

impl Webhook {
    /// Reads an address.
    ///
    /// # Errors
    /// It is none of HTTP, or carries a name and a password.
    pub fn read(address: &str) -> Result<Self, String> {
        let rest = ["http://", "https://"].iter().find_map(|scheme| address.strip_prefix(scheme));
        let rest = rest
            .filter(|rest| !rest.contains(|sign: char| sign.is_control() || sign == ' '))
            .ok_or("a webhook begins with http:// or https://, without spaces")?;
        let host = rest.split(['/', '?', '#']).next().unwrap_or_default();
        if host.is_empty() || host.contains('@') {
            return Err("a webhook has the name of a host behind http:// or https://".into());
        }
        Ok(Self { address: address.into(), host: host.into() })
    }

    /// Sends a message; waits for the answer.
    fn send(&self, news: &News) -> Result<(), ureq::Error> {
        let config = Agent::config_builder().timeout_global(Some(LONGEST)).max_redirects(0);
        let agent = config.build().new_agent();
        let body = serde_json::to_vec(news).map_err(io::Error::from)?;
        let answer = agent.post(&self.address).content_type("application/json").send(&body)?;
        // A redirection is no failure to the library: the message is not taken all the same.
        let status = answer.status();
        status.is_success().then_some(()).ok_or(ureq::Error::StatusCode(status.as_u16()))
    }

    /// Tells what happens for as long as the server runs.
    pub async fn follow(self, hub: Weak<Hub>) {
        let Some((mut told, mut heard)) =
            hub.upgrade().map(|hub| (LastNews::of(&hub.now()), hub.listen().1))
        else {
            return;
        };
        loop {
            match heard.recv().await {
                Ok(message) => {
                    let ToPage::Changes { changes } = message.message() else { continue };
                    if !changes
                        .iter()
                        .any(|change| matches!(change, Change::Job { .. } | Change::Asked { .. }))
                    {
                        continue;
                    }
                }
                Err(RecvError::Lagged(_)) => {}
                Err(RecvError::Closed) => return,
            }
            let Some(hub) = hub.upgrade() else { return };
            for news in told.news(&hub.now()) {
                self.tell(&hub, &news).await;
            }
        }
    }

    async fn tell(&self, hub: &Arc<Hub>, news: &News) {
        let (hook, told) = (self.clone(), news.clone());
        let sent = spawn_blocking(move || hook.send(&told).map_err(|error| error.to_string()));
        let why = match sent.await {
            Ok(Ok(())) => return,
            Ok(Err(why)) => why,
            Err(error) => error.to_string(),
        };
        let text = format!("{} was not told that {}: {why}", self.host, news.text);
        hub.say(Tone::Warning, text);
    }
}

/// A message.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
struct News {
    /// `needs you`, `done` or `failed`.
    event: &'static str,
    /// The machine, where several are served together.
    #[serde(skip_serializing_if = "String::is_empty")]
    machine: String,
    /// The file that ran.
    file: String,
    /// The same in a sentence.
    text: String,
}

/// The state that was told last.
#[derive(Debug, PartialEq, Eq)]
struct LastNews {
    asked: Option<u32>,
    run: u32,
    over: bool,
}

impl LastNews {
    fn of(now: &Snapshot) -> Self {
        let job = now.job.as_ref();
        Self {
            asked: now.asked.as_ref().map(|asked| asked.number),
            run: job.map_or(0, |job| job.run),
            over: job.is_some_and(|job| job.ended.is_some()),
        }
    }

    /// Tells what is new of it: files only, a typed line has whoever typed it beside it.
    fn news(&mut self, now: &Snapshot) -> Vec<News> {
        let before = std::mem::replace(self, Self::of(now));
        let Some(job) =
            now.job.as_ref().filter(|job| job.command.is_none() && !job.file.is_empty())
        else {
            return Vec::new();
        };
        let file = &job.file;
        let machine = now.together.iter().find(|one| one.here).map(|one| one.name.clone());
        let machine = machine.unwrap_or_default();
        let news = |event, text| News { event, machine: machine.clone(), file: file.clone(), text };
        let mut all = Vec::new();
        if let Some(asked) = now.asked.as_ref().filter(|asked| before.asked != Some(asked.number)) {
            all.push(news("needs you", format!("{file} needs you: {}", asked.text)));
        }
        let fresh = !before.over || before.run != job.run;
        match job.ended.as_deref().filter(|_| fresh) {
            None => {}
            Some("ok" | "ended") => all.push(news("done", format!("{file} is done"))),
            Some(how) => all.push(news("failed", format!("{file} failed: {how}"))),
        }
        all
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use kerf_wire::{Asked, CurrentRun};
    use std::io::{Read, Write};
    use std::net::TcpListener;
    use std::thread;

    #[test]
    fn an_address_is_one_of_http() {
        let check = |address: &str, host: Option<&str>| {
            let read = Webhook::read(address).ok().map(|hook| hook.host);
            assert_eq!(read.as_deref(), host, "{address}");
        };
        check("http://hub:8123/api/x?y", Some("hub:8123"));
        check("https://hub", Some("hub"));
        check("https://hub?topic=kerf", Some("hub"));
        for wrong in ["ftp://hub", "http:///x", "http://a b/", "http://a\r\nb/", "http://me@hub/"] {
            check(wrong, None);
        }
    }

    /// Sends a message to a server that reads and answers so; gives what it read first, and the reason of a failure.
    fn sent(scheme: &str, answer: &'static str) -> (Vec<u8>, Option<String>) {
        let server = TcpListener::bind("127.0.0.1:0").unwrap();
        let address = format!("{scheme}://{}/x", server.local_addr().unwrap());
        let serves = thread::spawn(move || {
            let (mut stream, _) = server.accept().unwrap();
            let mut read = vec![0; 4096];
            let length = stream.read(&mut read).unwrap();
            read.truncate(length);
            stream.write_all(answer.as_bytes()).unwrap();
            read
        });
        let news = News {
            event: "done",
            machine: String::new(),
            file: "a".into(),
            text: "a is done".into(),
        };
        let failed = Webhook::read(&address).unwrap().send(&news).err();
        (serves.join().unwrap(), failed.map(|error| error.to_string()))
    }

    #[test]
    fn a_message_is_taken_or_the_reason_told() {
        let (read, failed) = sent("http", "HTTP/1.1 204 No Content\r\n\r\n");
        assert!(read.starts_with(b"POST /x HTTP/1.1\r\n"), "{}", String::from_utf8_lossy(&read));
        assert_eq!(failed, None);
        let (_, failed) = sent("http", "HTTP/1.1 404 Not Found\r\nContent-Length: 0\r\n\r\n");
        assert_eq!(failed.as_deref(), Some("http status: 404"));
        let away = "HTTP/1.1 302 Found\r\nLocation: /y\r\nContent-Length: 0\r\n\r\n";
        assert!(sent("http", away).1.is_some());
    }

    #[test]
    fn a_message_over_https_begins_with_a_greeting_of_tls() {
        let (read, failed) = sent("https", "HTTP/1.1 200 OK\r\n\r\n");
        assert_eq!(read[..2], [0x16, 3]);
        assert!(failed.is_some());
    }

    fn now(run: u32, ended: Option<&str>, asked: Option<u32>) -> Snapshot {
        let job = CurrentRun {
            run,
            file: "a.sbp".into(),
            ended: ended.map(Into::into),
            ..CurrentRun::default()
        };
        let mut now = Snapshot { job: Some(job), ..Snapshot::default() };
        now.asked = asked.map(asked_of);
        now
    }

    fn asked_of(number: u32) -> Asked {
        serde_json::from_value(serde_json::json!({
            "number": number, "kind": "msgbox", "text": "Clamps?", "title": "", "buttons": [], "default": 0,
            "prefill": "", "entry": false, "icon": 0, "edits": null, "file": "", "line": 0, "was": "running",
        }))
        .unwrap()
    }

    #[test]
    fn each_thing_is_told_once() {
        let mut told = LastNews::of(&now(1, None, None));
        let mut events = |next: &Snapshot| -> Vec<String> {
            told.news(next).into_iter().map(|news| news.text).collect()
        };
        assert_eq!(events(&now(1, None, Some(3))), ["a.sbp needs you: Clamps?"]);
        assert!(events(&now(1, None, Some(3))).is_empty());
        assert!(events(&now(1, None, None)).is_empty());
        assert_eq!(events(&now(1, Some("ok"), None)), ["a.sbp is done"]);
        assert!(events(&now(1, Some("ok"), None)).is_empty());
        assert_eq!(events(&now(2, Some("stopped"), None)), ["a.sbp failed: stopped"]);
        let mut typed = now(3, Some("ok"), None);
        typed.job.as_mut().unwrap().command = Some("MX,1".into());
        assert!(events(&typed).is_empty());
    }
}
