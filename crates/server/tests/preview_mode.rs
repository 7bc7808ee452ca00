//! Preview mode on a machine that nobody armed: files and typed lines are drawn, and nothing moves.

use crate::support::{Page, Shop, at, rsm, shop};
use serde_json::json;

const PART: &str = "SA\nMSGBOX(Go on?, OK)\nMX,1\nEND\n";

/// Somebody drives, in preview and disarmed.
fn previewing(shop: &Shop) -> Page {
    let mut page = shop.driver();
    page.command("SP");
    page.until("preview", |page| page.shown["machine"]["mode"] == "preview");
    assert_eq!(page.act(json!({ "do": "disarm" })), None);
    page.until("it is disarmed", |page| page.shown["machine"]["armed"] == false);
    page
}

fn ended(page: &mut Page, run: u64, word: &str) {
    page.until("the end of the run", |page| {
        page.shown["job"]["run"].as_u64() > Some(run) && page.shown["job"]["ended"] == word
    });
    page.until_state("idle");
}

fn typed(page: &mut Page, line: &str) -> Option<String> {
    let lease = page.shown["lease"]["number"].clone();
    page.act(json!({ "do": "command", "lease": lease, "line": line }))
}

#[test]
fn a_file_is_drawn_and_asks_without_an_armed_machine() {
    let shop = shop(50.0, &[("a.sbp", PART)]);
    let mut page = previewing(&shop);
    page.open_file("a.sbp");
    let run = page.shown["job"]["run"].as_u64().unwrap();
    assert_eq!(page.run(), None);
    let question = page.asked("msgbox");
    assert_eq!(page.act(json!({ "do": "answer", "question": question, "answer": "OK" })), None);
    ended(&mut page, run, "ok");
    assert!(page.shown["machine"]["armed"] == false);
    assert_eq!(typed(&mut page, "MX,2"), None);
    ended(&mut page, run + 1, "ok");
    assert_eq!(typed(&mut page, "SM"), None);
    page.until("move mode", |page| page.shown["machine"]["mode"] != "preview");
    assert_eq!(at(&page)[0], 0.0, "nothing has moved");
    assert!(typed(&mut page, "MX,2").is_some_and(|why| why.contains("disarmed")));
}

#[test]
fn a_file_that_leaves_preview_ends_there_where_nobody_armed_the_machine() {
    let shop = shop(50.0, &[("leaves.sbp", "SM\nMX,1\nEND\n")]);
    let mut page = previewing(&shop);
    page.open_file("leaves.sbp");
    let run = page.shown["job"]["run"].as_u64().unwrap();
    assert_eq!(page.run(), None);
    ended(&mut page, run, "failed");
    assert!(
        page.shown["job"]["error"]["message"].as_str().unwrap().starts_with("SM leaves preview")
    );
    assert_eq!(typed(&mut page, "SM\nMX,1"), None);
    ended(&mut page, run + 1, "failed");
    assert_eq!(typed(&mut page, "SM"), None);
    page.until("move mode", |page| page.shown["machine"]["mode"] != "preview");
    assert_eq!(at(&page)[0], 0.0, "nothing has moved");
}

#[test]
fn a_job_is_not_cut_in_preview() {
    let job = rsm("rect 0,0 40,40");
    let shop = shop(50.0, &[]);
    shop.write("a.rsm", job.as_bytes());
    let mut page = previewing(&shop);
    page.open_file("a.rsm");
    refused(&mut page);
    let lease = page.shown["lease"]["number"].clone();
    assert_eq!(page.act(json!({ "do": "arm", "lease": lease })), None);
    refused(&mut page);
}

#[track_caller]
fn refused(page: &mut Page) {
    let (lease, hash) = (&page.shown["lease"]["number"], &page.shown["opened"]["hash"]);
    let id = page.send(json!({ "do": "run", "lease": lease, "hash": hash }));
    let why = page.problem(id);
    assert!(why.contains("only part files are drawn"), "{why}");
}
