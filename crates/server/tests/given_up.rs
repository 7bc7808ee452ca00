//! Long work ends soon after nobody waits for it: whoever asks next need not wait for its end.

use crate::support::{Page, Shop, shop};
use serde_json::{Value, json};
use std::io::Write;
use std::net::TcpStream;
use std::time::{Duration, Instant};

/// So many circles that lie apart, as a DXF: their tool paths take much longer than any test waits for a reply.
fn circles(number: usize) -> String {
    let circle = |n: usize| {
        let (x, y) = (n % 500 * 3, n / 500 * 3);
        format!("0\nCIRCLE\n8\n0\n10\n{x}\n20\n{y}\n40\n1\n")
    };
    let all: String = (0..number).map(circle).collect();
    format!("0\nSECTION\n2\nENTITIES\n{all}0\nENDSEC\n0\nEOF\n")
}

fn works() -> Shop {
    let shop = shop(1.0, &[]);
    shop.write("heavy.dxf", circles(200_000).as_bytes());
    shop.write("light.dxf", circles(2).as_bytes());
    shop
}

fn machine(drawing: &str) -> Value {
    json!({ "do": "machine", "drawing": drawing, "anew": true })
}

/// Long work of a page is ended in some way; the next work is done, and nothing is left of the first.
#[track_caller]
fn check(long: &Value, ends: impl FnOnce(&Shop, Page, u64)) {
    let shop = works();
    let mut page = shop.page();
    let id = page.send(long.clone());
    // It is under way.
    std::thread::sleep(Duration::from_millis(300));
    let ended = Instant::now();
    ends(&shop, page, id);
    let mut next = shop.page();
    assert_eq!(next.act(machine("light.dxf")), None);
    println!("{long}: the next work was done {:?} after the end", ended.elapsed());
    assert!(shop.part("light.rsm").is_file() && !shop.part("heavy.rsm").exists());
}

fn given_up(mut page: Page, id: u64) {
    assert_eq!(page.act(json!({ "do": "giveUp" })), None);
    let said = page.problem(id);
    assert!(said.contains("given up"), "{said}");
}

#[test]
fn tool_paths_and_readings_are_given_up_by_whoever_asked_for_them() {
    check(&machine("heavy.dxf"), |_, page, id| given_up(page, id));
    let opening = json!({ "do": "draw", "op": { "op": "open", "name": "heavy.dxf" } });
    check(&opening, |_, page, id| given_up(page, id));
}

#[test]
fn work_ends_with_the_page_that_asked_for_it() {
    check(&machine("heavy.dxf"), |_, page, _| drop(page));
}

#[test]
fn who_asks_again_waits_for_the_newest_only() {
    check(&machine("heavy.dxf"), |_, mut page, first| {
        let second = page.send(machine("light.dxf"));
        assert_eq!(page.reply(first).as_deref(), Some("state"));
        assert_eq!(page.reply(second), None);
    });
}

#[test]
fn work_ends_with_the_connection_that_asked_for_it() {
    let shop = works();
    let body = json!({ "drawing": "heavy.dxf", "anew": true }).to_string();
    let address = shop.server.address;
    let mut stream = TcpStream::connect(address).unwrap();
    let head = format!(
        "POST /api/do/machine HTTP/1.1\r\nHost: {address}\r\nContent-Type: application/json\r\n\
         Content-Length: {}\r\n\r\n",
        body.len()
    );
    stream.write_all((head + &body).as_bytes()).unwrap();
    std::thread::sleep(Duration::from_millis(300));
    drop(stream);
    assert_eq!(shop.page().act(machine("light.dxf")), None);
    assert!(!shop.part("heavy.rsm").exists());
}
