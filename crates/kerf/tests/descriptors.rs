//! Connections of strangers and devices take no descriptor from files, and no place from who sits at the machine.

#![cfg(target_os = "linux")]

use crate::shop::Shop;
use crate::shop::console::Console;
use serde_json::json;
use sha2::{Digest, Sha256};
use std::io::{Read, Write};
use std::net::TcpStream;
use std::process::Command;
use std::time::Duration;

/// Paired devices of a server.
const DEVICES: usize = 12;

fn token(device: usize) -> String {
    format!("{device:064x}")
}

/// A server with paired devices, under limits of the shell.
fn served(shop: &Shop, limits: &str) -> Console {
    let device = |n: usize| {
        let hash: String =
            Sha256::digest(token(n).as_bytes()).iter().map(|byte| format!("{byte:02x}")).collect();
        json!({ "number": n, "name": format!("pad {n}"), "role": "operator", "hash": hash })
    };
    let list: Vec<_> = (1..=DEVICES).map(device).collect();
    shop.write("data/devices.json", json!(list).to_string().as_bytes());
    let line = format!("{limits}; exec \"$0\" \"$@\"");
    Console::begin_with(shop, &["--lan"], |command| {
        let mut shell = Command::new("bash");
        shell.args(["-c", &line]).arg(command.get_program()).args(command.get_args());
        shell.current_dir(shop.path());
        shell.envs(command.get_envs().filter_map(|(name, value)| Some((name, value?))));
        shell
    })
}

/// The address of a server, and what shows that somebody sits at the machine.
fn way_in(console: &Console) -> (&str, &str) {
    let (address, token) = console.url.split_once("token=").unwrap();
    (address.strip_prefix("http://").unwrap().split('/').next().unwrap(), token)
}

/// A connection that has sent something.
fn sent(console: &Console, text: &str) -> Option<TcpStream> {
    let (address, _) = way_in(console);
    let mut stream = TcpStream::connect(address).ok()?;
    stream.set_read_timeout(Some(Duration::from_secs(20))).ok()?;
    stream.write_all(text.replace("HOST", address).as_bytes()).ok()?;
    Some(stream)
}

/// The status of a request of a device, whose connection stays open.
fn asked(console: &Console, device: usize) -> (u16, Option<TcpStream>) {
    let head =
        format!("X-Forwarded-For: 192.0.2.{device}\r\nAuthorization: Bearer {}", token(device));
    status(console, "/api/files", &head)
}

/// The status of a request at the machine itself.
fn here(console: &Console, path: &str) -> u16 {
    status(console, path, &format!("Authorization: Bearer {}", way_in(console).1)).0
}

fn status(console: &Console, path: &str, head: &str) -> (u16, Option<TcpStream>) {
    let mut stream = sent(console, &format!("GET {path} HTTP/1.1\r\nHost: HOST\r\n{head}\r\n\r\n"));
    let mut begin = [0; 12];
    let read = stream.as_mut().is_some_and(|stream| stream.read_exact(&mut begin).is_ok());
    let status = String::from_utf8_lossy(&begin[9..]).parse().ok().filter(|_| read);
    (status.unwrap_or(0), stream)
}

/// The machine's own page, and a device, are served.
#[track_caller]
fn check(console: &Console) {
    assert_eq!(here(console, "/api/files"), 200);
    assert_eq!(asked(console, 1).0, 200);
}

/// The limits of a server: how many descriptors it may have, and how many it might.
fn limits(console: &Console) -> (u64, u64) {
    let told = std::fs::read_to_string(format!("/proc/{}/limits", console.child.id())).unwrap();
    let line = told.lines().find(|line| line.starts_with("Max open files")).unwrap();
    let numbers: Vec<u64> = line.split_whitespace().filter_map(|word| word.parse().ok()).collect();
    (numbers[0], numbers[1])
}

#[test]
fn the_limit_of_descriptors_is_raised_as_far_as_it_goes() {
    let shop = Shop::new(&[]);
    let console = served(&shop, "ulimit -Sn 100; ulimit -Hn 900");
    assert_eq!(limits(&console), (900, 900));
}

#[test]
fn strangers_that_send_half_a_request_are_in_nobodys_way() {
    let shop = Shop::new(&[("a.sbp", "MX,1\n")]);
    let console = served(&shop, "ulimit -n 256");
    let half = "POST /api/pair HTTP/1.1\r\nHost: 127";
    let _held: Vec<_> = (0..400).map(|_| sent(&console, half)).collect();
    check(&console);
    assert_eq!(here(&console, "/api/files/a.sbp?about=1"), 200);
}

#[test]
fn strangers_whose_requests_do_not_end_are_in_nobodys_way() {
    let shop = Shop::new(&[]);
    let console = served(&shop, "true");
    let slow = "POST /api/pair HTTP/1.1\r\nHost: HOST\r\nContent-Type: application/json\r\nContent-Length: 900\r\n\r\n{";
    let _held: Vec<_> = (0..20).map(|_| sent(&console, slow)).collect();
    // A request that is answered in time is not broken off.
    std::thread::sleep(Duration::from_millis(1200));
    check(&console);
}

#[test]
fn devices_leave_descriptors_to_others() {
    let shop = Shop::new(&[("a.sbp", "MX,1\n")]);
    let console = served(&shop, "ulimit -n 256");
    let connect = |n: usize| asked(&console, 1 + n % DEVICES);
    let held: Vec<_> = (0..24 * DEVICES).map(connect).collect();
    let let_in = held.iter().filter(|(status, _)| *status == 200).count();
    assert!((24..200).contains(&let_in), "{let_in} of {} connections", held.len());
    assert_eq!(here(&console, "/api/files/a.sbp?about=1"), 200);
}
