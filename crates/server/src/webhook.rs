//! Tells another program over HTTP when somebody is needed, and how runs end.

use crate::hub::Hub;
use kerf_wire::{Change, Snapshot, ToPage, Tone};
use serde::Serialize;
use std::io;
use std::sync::{Arc, Weak};
use std::time::Duration;
use tokio::io::{AsyncReadExt, AsyncWriteExt};
use tokio::net::TcpStream;
use tokio::sync::broadcast::error::RecvError;
use tokio::time::timeout;

/// Longest time for one message.
const LONGEST: Duration = Duration::from_secs(10);

/// Address of the messages: `http://HOST[:PORT]/PATH`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Webhook {
    host: String,
    path: String,
}

impl Webhook {
    /// Reads an address.
    ///
    /// # Errors
    /// It is none of plain HTTP.
    pub fn read(address: &str) -> Result<Self, String> {
        let rest = address
            .strip_prefix("http://")
            .filter(|rest| !rest.contains(|sign: char| sign.is_control() || sign == ' '));
        let rest = rest.ok_or("a webhook begins with http://, without spaces")?;
        let (host, path) = rest.split_once('/').unwrap_or((rest, ""));
        if host.is_empty() || host.contains('@') {
            return Err("a webhook has the name of a host behind http://".into());
        }
        Ok(Self { host: host.into(), path: format!("/{path}") })
    }

    /// Sends a message.
    async fn send(&self, news: &News) -> io::Result<()> {
        let body = serde_json::to_string(news)?;
        let Self { host, path } = self;
        let port = if host.rsplit_once(':').is_some_and(|(_, port)| port.parse::<u16>().is_ok()) {
            ""
        } else {
            ":80"
        };
        let mut stream = TcpStream::connect(format!("{host}{port}")).await?;
        let head = format!(
            "POST {path} HTTP/1.1\r\nHost: {host}\r\nContent-Type: application/json\r\nContent-Length: {}\r\n\
             Connection: close\r\n\r\n",
            body.len()
        );
        stream.write_all((head + &body).as_bytes()).await?;
        let mut answer = [0; 64];
        let read = stream.read(&mut answer).await?;
        let line = String::from_utf8_lossy(&answer[..read]).into_owned();
        let taken = line.split(' ').nth(1).is_some_and(|status| status.starts_with('2'));
        let said = || line.lines().next().unwrap_or_default().to_owned();
        taken.then_some(()).ok_or_else(|| io::Error::other(format!("it answered {:?}", said())))
    }

    /// Tells what happens for as long as the server runs.
    pub async fn follow(self, hub: Weak<Hub>) {
        let Some((mut told, mut heard)) =
            hub.upgrade().map(|hub| (Told::of(&hub.now()), hub.listen().1))
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
        let late = || io::Error::new(io::ErrorKind::TimedOut, "it does not answer");
        let sent = timeout(LONGEST, self.send(news)).await.unwrap_or_else(|_| Err(late()));
        if let Err(error) = sent {
            hub.say(
                Tone::Warning,
                format!("{} was not told that {}: {error}", self.host, news.text),
            );
        }
    }
}

/// A message.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
struct News {
    /// `needs you`, `done` or `failed`.
    event: &'static str,
    /// The file that ran.
    file: String,
    /// The same in a sentence.
    text: String,
}

/// The state that was told last.
#[derive(Debug, PartialEq, Eq)]
struct Told {
    asked: Option<u32>,
    run: u32,
    over: bool,
}

impl Told {
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
        let news = |event, text: String| News { event, file: file.clone(), text };
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
    use kerf_wire::{Asked, Job};

    #[test]
    fn an_address_is_one_of_plain_http() {
        let hook = |host: &str, path: &str| Ok(Webhook { host: host.into(), path: path.into() });
        assert_eq!(Webhook::read("http://hub:8123/api/x?y"), hook("hub:8123", "/api/x?y"));
        assert_eq!(Webhook::read("http://hub"), hook("hub", "/"));
        for wrong in ["https://hub", "http:///x", "http://a b/", "http://a\r\nb/", "http://me@hub/"]
        {
            assert!(Webhook::read(wrong).is_err(), "{wrong}");
        }
    }

    fn now(run: u32, ended: Option<&str>, asked: Option<u32>) -> Snapshot {
        let job = Job { run, file: "a.sbp".into(), ended: ended.map(Into::into), ..Job::default() };
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
        let mut told = Told::of(&now(1, None, None));
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
