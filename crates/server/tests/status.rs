//! The status of the machine for other programs, as `/api/registry/Status` tells it while a passed command runs.

use crate::support::{Page, Shop, kept};
use serde_json::json;

/// One stack of motion, read to its end long before it is made.
const PART: &str = "SA\nMX,2\nMX,3\nMX,1\n";

const RUNNING: u8 = 1;
const PREVIEW: u8 = 2;
const STOPPED: u8 = 16;
const MOVING: u8 = 32;

fn shop() -> Shop {
    let shop = kept(tempfile::tempdir().unwrap());
    shop.write("p4.sbp", PART.as_bytes());
    shop
}

fn status(shop: &Shop) -> u8 {
    let answer = shop.get("/api/registry/Status");
    assert_eq!(answer.status, 200);
    String::from_utf8(answer.body).unwrap().parse().unwrap()
}

/// Passes a command in: the code of the answer and its reason.
fn pass(shop: &Shop, command: &str) -> (u16, String) {
    let answer = shop.ask("PUT /api/registry/uCommand", &[], command.as_bytes());
    (answer.status, answer.json()["why"].as_str().unwrap_or_default().to_owned())
}

fn type_line(page: &mut Page, line: &str) {
    let lease = page.lease;
    assert_eq!(page.act(json!({ "do": "command", "lease": lease, "line": line })), None);
}

/// Everything that is told from now on until the machine is idle, each status once in a row.
fn until_idle(shop: &Shop, page: &mut Page) -> Vec<u8> {
    let mut told = vec![status(shop)];
    while page.shown["machine"]["state"] != "idle" {
        assert!(page.read(), "the connection ended");
        told.push(status(shop));
    }
    told.dedup();
    told
}

#[test]
fn sbp_ctl_reg_bit1__over_http() {
    let shop = shop();
    let mut page = shop.driver();
    assert_eq!(status(&shop), 0);
    assert_eq!(pass(&shop, "FP,p4.sbp").0, 200);
    page.until_state("running");
    page.until("the way", |page| page.x() > 5.0);
    assert_eq!(status(&shop), RUNNING + MOVING, "the file was read to its end, and runs still");
    // Held on the way it runs as well, and so it does behind the question.
    assert_eq!(page.act(json!({ "do": "stop" })), None);
    let question = page.asked("hold");
    assert_eq!(status(&shop), RUNNING + STOPPED);
    let on = json!({ "do": "answer", "question": question, "answer": "Resume" });
    assert_eq!(page.act(on), None);
    page.until_state("running");
    page.until("the way on", |page| page.x() > 55.0);
    assert_eq!(status(&shop), RUNNING + MOVING);
    let told = until_idle(&shop, &mut page);
    let last = told.len() - 1;
    assert!(told[..last].iter().all(|status| status & RUNNING != 0), "{told:?}");
    assert_eq!(status(&shop), 0);
    assert!((page.x() - 25.4).abs() < 1e-6, "{}", page.x());
    // A line that is passed in is no file.
    assert_eq!(pass(&shop, "MX,2").0, 200);
    page.until_state("running");
    page.until("its way", |page| page.x() > 30.0);
    assert_eq!(status(&shop), MOVING);
}

#[test]
fn sbp_ctl_reg_bit2__over_http() {
    let shop = shop();
    let mut page = shop.driver();
    for (line, expected) in [("SP", PREVIEW), ("MX,3", PREVIEW), ("SM", 0), ("MX,.1", 0)] {
        type_line(&mut page, line);
        page.until_state("idle");
        assert_eq!(status(&shop), expected, "after {line}");
    }
    assert!((page.x() - 2.54).abs() < 1e-6, "preview moved nothing");
}

/// A command that a disarmed machine drops is answered so, and is not kept for later.
#[test]
fn sbp_ctl_reg_ucommand__at_a_disarmed_machine() {
    let shop = shop();
    let mut page = shop.driver();
    assert_eq!(page.act(json!({ "do": "disarm" })), None);
    for command in ["MX,1", "FP,p4.sbp"] {
        let answer = shop.ask("PUT /api/registry/uCommand", &[], command.as_bytes());
        assert_eq!((answer.status, answer.json()["why"].clone()), (403, json!("disarmed")));
        assert!(answer.json()["text"].as_str().unwrap().contains("arm"), "{}", answer.json());
    }
    assert_eq!(shop.get("/api/registry/uCommand").status, 404);
    page.drive();
    assert_eq!(pass(&shop, "MX,.5").0, 200);
    page.until("the passed move", |page| (page.x() - 12.7).abs() < 1e-6);
    page.until_state("idle");
    assert!((page.x() - 12.7).abs() < 1e-6, "what was dropped is not made up for");
}
