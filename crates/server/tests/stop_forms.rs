//! STOP is recognised in whatever form it comes, on whichever way, and counts once.

use crate::support::{Page, Shop, shop};
use serde_json::{Value, json};
use std::net::{SocketAddr, TcpStream};
use std::time::{Duration, Instant};
use tungstenite::client::IntoClientRequest;
use tungstenite::{Message, WebSocket, client};

/// Moves, has somebody stop it in some way, and waits until it has.
#[track_caller]
fn check(shop: &Shop, page: &mut Page, name: &str, stop: impl FnOnce(&Shop, &mut Page)) {
    let lease = page.lease;
    assert_eq!(page.act(json!({ "do": "command", "lease": lease, "line": "MX,0\nMX,30" })), None);
    page.until(name, |page| page.shown["motion"]["speedMmS"].as_f64() > Some(0.0));
    stop(shop, page);
    let stands = |page: &Page| {
        page.shown["machine"]["state"] == "stopped" && page.shown["asked"]["kind"] == "hold"
    };
    page.until(name, stands);
    let number = page.shown["asked"]["number"].clone();
    assert_eq!(page.act(json!({ "do": "answer", "question": number, "answer": "Quit" })), None);
    page.until_state("idle");
}

fn post(
    path: &'static str,
    kind: &'static str,
    body: &'static [u8],
) -> impl FnOnce(&Shop, &mut Page) {
    move |shop, _| {
        let kind = [("Content-Type", kind)];
        let headers = if kind[0].1.is_empty() { &kind[..0] } else { &kind[..] };
        assert_eq!(shop.ask(&format!("POST {path}"), headers, body).status, 200);
    }
}

fn text(message: &'static str) -> impl FnOnce(&Shop, &mut Page) {
    move |_, page| page.send_raw(Message::text(message))
}

#[test]
fn a_stop_over_http_needs_no_body_of_any_form() {
    let shop = shop(1.0, &[]);
    let mut page = shop.driver();
    check(&shop, &mut page, "no body", post("/api/do/stop", "", b""));
    check(&shop, &mut page, "nothing", post("/api/do/stop", "application/json", b""));
    check(&shop, &mut page, "null", post("/api/do/stop", "application/json", b"null"));
    check(&shop, &mut page, "plain", post("/api/do/stop", "text/plain", b"{}"));
    check(&shop, &mut page, "garbage", post("/api/do/STOP", "image/png", b"\xff\0"));
}

#[test]
fn a_stop_on_the_socket_needs_no_number_and_no_text() {
    let shop = shop(1.0, &[]);
    let mut page = shop.driver();
    check(&shop, &mut page, "no id", text(r#"{"act":{"do":"stop"}}"#));
    check(&shop, &mut page, "id -1", text(r#"{"id":-1,"act":{"do":"stop"}}"#));
    check(&shop, &mut page, "id 2^32", text(r#"{"id":4294967296,"act":{"do":"stop"}}"#));
    check(&shop, &mut page, "a word", text("STOP"));
    let binary = Message::binary(br#"{"id":3,"act":{"do":"stop"}}"#.to_vec());
    check(&shop, &mut page, "binary", |_, page| page.send_raw(binary));
}

/// STOP's own way, for a page.
fn own_way(shop: &Shop, page: &Page, origin: SocketAddr) -> Result<WebSocket<TcpStream>, u16> {
    let port = page.shown["stopPort"].as_u64().unwrap() as u16;
    let at = SocketAddr::new(shop.server.address.ip(), port);
    let client_number = &page.who["client"];
    let url = format!("ws://{at}/stop?client={client_number}");
    let mut request = url.into_client_request().unwrap();
    request.headers_mut().insert("origin", format!("http://{origin}").parse().unwrap());
    let stream = TcpStream::connect(at).unwrap();
    match client(request, stream) {
        Ok((socket, _)) => Ok(socket),
        Err(tungstenite::HandshakeError::Failure(tungstenite::Error::Http(answer))) => {
            Err(answer.status().as_u16())
        }
        Err(other) => panic!("{other}"),
    }
}

#[test]
fn a_press_on_both_ways_counts_once_and_is_told_when_it_was_heard() {
    let shop = shop(1.0, &[]);
    let mut page = shop.driver();
    let mut own = own_way(&shop, &page, shop.server.address).unwrap();
    check(&shop, &mut page, "both", |_, page| {
        let press = r#"{"id":900,"act":{"do":"stop"}}"#;
        own.send(Message::text(press)).unwrap();
        let told = loop {
            if let Message::Text(text) = own.read().unwrap() {
                break serde_json::from_str::<Value>(&text).unwrap();
            }
        };
        assert_eq!((&told["tell"], &told["id"]), (&json!("reply"), &json!(900)));
        page.until_state("stopped");
        // The other way is slower; a second stop would end the job that waits.
        page.send_raw(Message::text(press));
        assert_eq!(page.reply(900), None);
        std::thread::sleep(Duration::from_millis(100));
    });
}

#[test]
fn the_last_of_many_presses_waits_no_longer_than_the_first() {
    let shop = shop(1.0, &[]);
    let page = shop.driver();
    let mut own = own_way(&shop, &page, shop.server.address).unwrap();
    let press = |id| Message::text(format!(r#"{{"id":{id},"act":{{"do":"stop"}}}}"#));
    // A key that repeats, and a page that sends each press again.
    for id in 1..400 {
        own.write(press(id)).unwrap();
        own.flush().unwrap();
    }
    std::thread::sleep(Duration::from_millis(300));
    let sent = Instant::now();
    own.send(press(400)).unwrap();
    while !matches!(own.read().unwrap(), Message::Text(text) if text.contains(r#""id":400"#)) {}
    assert!(sent.elapsed() < Duration::from_secs(2), "{:?}", sent.elapsed());
}

#[test]
fn stops_own_way_hears_nothing_else_and_no_foreign_page() {
    let shop = shop(1.0, &[]);
    let page = shop.driver();
    let foreign = SocketAddr::from(([127, 0, 0, 1], 9));
    assert_eq!(own_way(&shop, &page, foreign).err(), Some(403));
    let mut own = own_way(&shop, &page, shop.server.address).unwrap();
    own.send(Message::text(r#"{"id":1,"act":{"do":"takeLease","force":true}}"#)).unwrap();
    let told = loop {
        if let Message::Text(text) = own.read().unwrap() {
            break text;
        }
    };
    assert!(told.contains("malformed"), "{told}");
}

#[test]
fn what_is_wrong_with_a_message_does_not_come_back_whole() {
    let shop = shop(1.0, &[]);
    let mut page = shop.page();
    let long = format!(r#"{{"id":1,"act":{{"do":"{}"}}}}"#, "x".repeat(3000));
    page.send_raw(Message::text(long));
    let said = page.problem(0);
    assert!((10..300).contains(&said.len()), "{said}");
}

#[test]
fn a_stop_before_the_beginning_of_a_move_keeps_the_machine_still() {
    // On a busy computer the machine may come to the move first: then the stop ends it, and another one is tried.
    assert!((0..5).any(|_| is_stopped_before_it_moves()), "the stop never came before the move");
}

/// Stops the machine while a move waits; `false` where the move began before the stop, which ended it.
fn is_stopped_before_it_moves() -> bool {
    let shop = shop(1.0, &[]);
    let mut page = shop.driver();
    let lease = page.lease;
    let command = |line: &str| json!({ "do": "command", "lease": lease, "line": line });
    // The move waits behind something that takes a while to read, and is refused.
    let slow = command(&("MX,1\n".repeat(60_000) + "QQ,1"));
    let (first, second) = (page.send(slow), page.send(command("MX,20")));
    assert_eq!(page.act(json!({ "do": "stop" })), None, "done at once");
    assert_eq!(page.reply(first).as_deref(), Some("mistake"));
    let answer = page.reply(second);
    if answer.is_none() {
        page.until_state("stopped");
        assert!(page.x() < 20.0, "it was stopped on its way");
        return false;
    }
    assert_eq!(answer.as_deref(), Some("state"));
    assert_eq!(page.shown["machine"]["state"], "idle");
    page.command("MY,0.1");
    assert_eq!(page.x(), 0.0, "what was stopped stays so");
    true
}
