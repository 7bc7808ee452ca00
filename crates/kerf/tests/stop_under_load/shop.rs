//! A server of its own: its process, the devices that are paired with it, and how it is asked.

use super::loads::{circles, long_part};
use serde_json::{Value, json};
use sha2::{Digest, Sha256};
use std::io::{BufRead, BufReader, Read, Write};
use std::net::{SocketAddr, TcpStream};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::Duration;
use tempfile::TempDir;
use tungstenite::client::IntoClientRequest;
use tungstenite::http::HeaderValue;
use tungstenite::{WebSocket, client};

/// Longest wait for an answer that has to come.
pub const PATIENCE: Duration = Duration::from_secs(30);

/// Paired devices of each role.
const ROLES: [&str; 4] = ["operator", "observer", "operator", "setter"];
/// Devices besides the one that drives.
const DEVICES: usize = 12;

/// A server that runs until it is dropped.
pub struct Shop {
    process: Child,
    pub address: SocketAddr,
    _folder: TempDir,
}

/// Token by which a device is known: its number among the paired ones.
pub fn token(device: usize) -> String {
    format!("{device:064x}")
}

impl Shop {
    /// A server whose devices are paired already, on a disk that takes so much longer for each write.
    pub fn on(disk: Duration) -> Self {
        let folder = tempfile::tempdir().unwrap();
        let (parts, data) = (folder.path().join("parts"), folder.path().join("data"));
        std::fs::create_dir(&parts).unwrap();
        std::fs::create_dir(&data).unwrap();
        std::fs::write(data.join("devices.json"), devices().to_string()).unwrap();
        std::fs::write(parts.join("circles.dxf"), circles(6000)).unwrap();
        std::fs::write(parts.join("long.sbp"), long_part(20_000)).unwrap();
        let mut server = Command::new(program());
        if !disk.is_zero() {
            server.env("LD_PRELOAD", slow_disk(folder.path()));
            server.env("SLOW_DISK_MS", disk.as_millis().to_string());
        }
        let mut process = server
            .args(["serve", "--lan", "--listen", "127.0.0.1:0", "--parts"])
            .arg(&parts)
            .arg("--data")
            .arg(&data)
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let mut line = String::new();
        BufReader::new(process.stdout.take().unwrap()).read_line(&mut line).unwrap();
        let told = line.trim().rsplit("http://").next().unwrap();
        let address = told.split(['/', '?']).next().unwrap().parse().unwrap();
        Self { process, address, _folder: folder }
    }

    /// The most memory that the server has had, bytes; nothing where that is not told.
    pub fn peak(&self) -> u64 {
        let told = std::fs::read_to_string(format!("/proc/{}/status", self.process.id()));
        let told = told.unwrap_or_default();
        let line = told.lines().find_map(|line| line.strip_prefix("VmHWM:"));
        let kib = line.and_then(|text| text.trim().split(' ').next()?.parse::<u64>().ok());
        kib.unwrap_or(0) * 1024
    }
}

impl Drop for Shop {
    fn drop(&mut self) {
        drop(self.process.kill());
        drop(self.process.wait());
    }
}

/// The library that makes a disk slow. Whoever built Kerf has a C compiler: SQLite needs it.
fn slow_disk(folder: &Path) -> PathBuf {
    let library = folder.join("slow_disk.so");
    let source = folder.join("slow_disk.c");
    std::fs::write(&source, include_str!("slow_disk.c")).unwrap();
    let compiled = Command::new("cc")
        .args(["-shared", "-fPIC", "-o"])
        .arg(&library)
        .arg(&source)
        .status()
        .unwrap();
    assert!(compiled.success(), "cc makes a library of slow_disk.c");
    library
}

/// The list of paired devices: the first one drives.
fn devices() -> Value {
    let device = |number: usize| {
        let hash: String =
            Sha256::digest(token(number).as_bytes()).iter().map(|b| format!("{b:02x}")).collect();
        let role = if number == 0 { "setter" } else { ROLES[number % ROLES.len()] };
        json!({ "number": number + 1, "name": format!("device {number}"), "role": role, "hash": hash })
    };
    (0..=DEVICES).map(device).collect()
}

/// The load's device with a role, one after the other.
pub fn with_role(role: &str, turn: usize) -> usize {
    let all: Vec<usize> = (1..=DEVICES).filter(|n| ROLES[n % ROLES.len()] == role).collect();
    all[turn % all.len()]
}

/// A socket of a device, its snapshot not read yet.
pub fn socket(
    address: SocketAddr,
    path: &str,
    origin: SocketAddr,
    device: usize,
) -> Option<WebSocket<TcpStream>> {
    let stream = TcpStream::connect(address).ok()?;
    stream.set_nodelay(true).ok()?;
    stream.set_read_timeout(Some(PATIENCE)).ok()?;
    let mut request = format!("ws://{address}{path}").into_client_request().ok()?;
    let mut put = |name: &'static str, value: String| {
        request.headers_mut().insert(name, HeaderValue::from_str(&value).unwrap());
    };
    put("origin", format!("http://{origin}"));
    put("authorization", format!("Bearer {}", token(device)));
    put("x-forwarded-for", format!("192.0.2.{device}"));
    client(request, stream).ok().map(|(socket, _)| socket)
}

/// An HTTP request of a device; its status, 0 when there is no answer.
pub fn ask(
    address: SocketAddr,
    device: usize,
    request: &str,
    kind: &str,
    body: &[u8],
) -> (u16, Vec<u8>) {
    let asked = || -> std::io::Result<Vec<u8>> {
        let mut stream = TcpStream::connect(address)?;
        stream.set_read_timeout(Some(PATIENCE))?;
        stream.set_write_timeout(Some(PATIENCE))?;
        let head = format!(
            "{request} HTTP/1.1\r\nHost: {address}\r\nConnection: close\r\nX-Forwarded-For: 192.0.2.{device}\r\n\
             Authorization: Bearer {}\r\nContent-Type: {kind}\r\nContent-Length: {}\r\n\r\n",
            token(device),
            body.len()
        );
        stream.write_all(head.as_bytes())?;
        stream.write_all(body)?;
        let mut answer = Vec::new();
        stream.read_to_end(&mut answer)?;
        Ok(answer)
    };
    let answer = asked().unwrap_or_default();
    let status = String::from_utf8_lossy(&answer[..answer.len().min(16)])
        .split(' ')
        .nth(1)
        .and_then(|status| status.parse().ok());
    let end =
        answer.windows(4).position(|four| four == b"\r\n\r\n").map_or(answer.len(), |at| at + 4);
    (status.unwrap_or(0), answer[end..].to_vec())
}

/// The server that is measured: that of this build, or another that `KERF` names.
fn program() -> String {
    std::env::var("KERF").unwrap_or_else(|_| env!("CARGO_BIN_EXE_kerf").into())
}
