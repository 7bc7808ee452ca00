//! Over the network: to the part folder of a running `kerf serve`.

use super::Shown;
use crate::transfer::{Progress, State};
use anyhow::{Context, Result};
use serde_json::Value;
use std::io::{Read, Write};
use std::net::{TcpStream, ToSocketAddrs};
use std::thread::sleep;
use std::time::Duration;

/// A server that takes or says nothing for so long is lost.
const LOST: Duration = Duration::from_secs(8);

/// While the machine moves it is tried so often.
const AGAIN: Duration = Duration::from_secs(1);

/// Bytes that are sent at a time.
const PIECE: usize = 16 * 1024;

/// A file that is sent.
pub struct Sent<'a> {
    pub name: &'a str,
    pub bytes: &'a [u8],
    /// It may replace another one in the part folder.
    pub replaces: bool,
}

/// Sends a file; gives how it ended.
pub fn send_over_network(
    url: &str,
    file: &Sent,
    stopped: &dyn Fn() -> bool,
    shown: &mut Shown,
) -> Result<State> {
    let address = url.strip_prefix("http://").unwrap_or(url).trim_end_matches('/');
    let mut progress = Progress { name: file.name.to_owned(), done: 0, total: file.bytes.len() };
    loop {
        progress.done = 0;
        let state = once(address, file, &mut progress, stopped, shown)?;
        shown.tell(&state, &progress);
        if state.is_over() {
            return Ok(state);
        }
        for _ in 0..10 {
            if stopped() {
                return Ok(State::Stopped);
            }
            sleep(AGAIN / 10);
        }
    }
}

/// One attempt; held when the machine moves.
fn once(
    address: &str,
    file: &Sent,
    progress: &mut Progress,
    stopped: &dyn Fn() -> bool,
    shown: &mut Shown,
) -> Result<State> {
    let reached = || format!("no server is reached at {address}");
    let mut places = address.to_socket_addrs().with_context(reached)?;
    let place = places.next().with_context(reached)?;
    let mut stream = TcpStream::connect_timeout(&place, LOST).with_context(reached)?;
    stream.set_read_timeout(Some(LOST))?;
    stream.set_write_timeout(Some(LOST))?;
    // The server is asked first whether it takes it: a machine that moves takes no byte.
    stream.write_all(head(address, file).as_bytes()).with_context(reached)?;
    for piece in file.bytes.chunks(PIECE) {
        if stopped() {
            return Ok(State::Stopped);
        }
        // A server that refuses closes before it has read all; its answer says why.
        if stream.write_all(piece).is_err() {
            break;
        }
        progress.done += piece.len();
        shown.tell(&State::Sending, progress);
    }
    let mut answer = Vec::new();
    let read = stream.read_to_end(&mut answer);
    if answer.is_empty() {
        read.with_context(|| format!("the server at {address} does not answer"))?;
    }
    Ok(answered(&String::from_utf8_lossy(&answer)))
}

fn head(address: &str, file: &Sent) -> String {
    let token = std::env::var("KERF_TOKEN").ok().filter(|token| !token.is_empty());
    let token = token.map(|token| format!("Authorization: Bearer {token}\r\n")).unwrap_or_default();
    let (length, crc) = (file.bytes.len(), crc32fast::hash(file.bytes));
    let leave = if file.replaces { "?replace=1" } else { "" };
    format!(
        "PUT /api/files/{}{leave} HTTP/1.1\r\nHost: {address}\r\nConnection: close\r\n{token}\
         Content-Type: application/octet-stream\r\nKerf-Crc32: {crc:08x}\r\nContent-Length: {length}\r\n\r\n",
        encoded(file.name)
    )
}

/// A name as a part of an address.
fn encoded(name: &str) -> String {
    let plain = |byte: u8| byte.is_ascii_alphanumeric() || b"-._~".contains(&byte);
    let one =
        |byte: u8| if plain(byte) { char::from(byte).to_string() } else { format!("%{byte:02X}") };
    name.bytes().map(one).collect()
}

fn answered(answer: &str) -> State {
    let (head, body) = answer.split_once("\r\n\r\n").unwrap_or((answer, ""));
    let problem: Value = serde_json::from_str(body).unwrap_or_default();
    let text = problem["text"].as_str().unwrap_or(body).to_owned();
    match head.split(' ').nth(1) {
        Some("200") => State::Done,
        Some("409") if problem["why"] == "replaces" => {
            State::Failed(format!("{text}; kerf send --force replaces it"))
        }
        Some("409") => State::Held,
        Some(_) if !text.is_empty() => State::Failed(text),
        _ => State::Failed("the server does not answer as one of Kerf".into()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_parts_of_an_address() {
        assert_eq!(encoded("Tür 1.rsm"), "T%C3%BCr%201.rsm");
    }

    #[test]
    fn answers_say_how_it_ended() {
        assert_eq!(answered("HTTP/1.1 200 OK\r\n\r\nnull"), State::Done);
        assert_eq!(answered("HTTP/1.1 409 Conflict\r\n\r\n{}"), State::Held);
        let there = "HTTP/1.1 409 Conflict\r\n\r\n{\"why\":\"replaces\",\"text\":\"it is there\"}";
        let told = "it is there; kerf send --force replaces it";
        assert_eq!(answered(there), State::Failed(told.into()));
        let no = answered("HTTP/1.1 403 Forbidden\r\n\r\n{\"text\":\"pair first\"}");
        assert_eq!(no, State::Failed("pair first".into()));
    }
}
