//! What editors and fill-in sheets ask.

#![allow(clippy::unwrap_used)]

mod support;

use serde_json::json;
use support::shop;

#[test]
fn sheets_are_made_from_the_table_with_the_settings_of_now() {
    let shop = shop(50.0, &[]);
    let mut page = shop.driver();
    page.command("VC,.375");
    let commands = shop.get("/api/commands").json();
    let commands = commands.as_array().unwrap();
    assert!(commands.len() > 100);
    let vc = commands.iter().find(|c| c["letters"] == "VC").unwrap();
    assert_eq!(vc["parameters"][0]["present"], "0.375");
}

#[test]
fn a_text_is_checked_completed_explained_and_formatted() {
    let shop = shop(1.0, &[]);
    let ask = |what: &str, body| shop.post(&format!("/api/language/{what}"), body, &[]).json();
    let found = ask("check", json!({ "name": "a.sbp", "text": "MX,1\nQQ,2\n" }));
    assert_eq!(found["findings"][0]["line"], 2);
    let at = json!({ "name": "a.sbp", "text": "MX,1", "line": 1, "column": 2 });
    assert!(ask("complete", at.clone()).as_array().unwrap().iter().any(|w| w["label"] == "MX"));
    assert!(ask("hover", at)["text"].as_str().unwrap().contains('X'));
    let formatted = ask("format", json!({ "name": "a.sbp", "text": "mx,1\n" }));
    assert_eq!(formatted["text"], "MX,1\n");
}
