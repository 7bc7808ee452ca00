//! Drawing through the server.

#![allow(clippy::unwrap_used)]

mod support;

use serde_json::{Value, json};
use support::{Page, shop};

fn draw(page: &mut Page, op: Value) -> Option<String> {
    page.act(json!({ "do": "draw", "op": op }))
}

#[test]
fn a_part_is_drawn_saved_and_made_a_program() {
    let shop = shop(50.0, &[]);
    let mut page = shop.page();
    assert_eq!(draw(&mut page, json!({ "op": "new" })), None);
    let clauses = "rect 10,10 60,40; select all; group red";
    assert_eq!(draw(&mut page, json!({ "op": "do", "clauses": clauses })), None);
    page.until("a shape", |page| page.shown["drawing"]["shapes"] == 1);
    let state = page.shown["drawing"].clone();
    assert_eq!((&state["canUndo"], &state["changed"]), (&json!(true), &json!(true)));
    assert_eq!(state["selection"], json!([1]));
    let shapes = shop.get("/api/drawing/shapes").json();
    assert_eq!(shapes["shapes"][0]["group"], "red");
    assert_eq!(shapes["shapes"][0]["points"].as_array().unwrap().len(), 12);
    assert_eq!(shapes["revision"], state["revision"]);

    assert_eq!(draw(&mut page, json!({ "op": "save", "name": "part.rsg" })), None);
    page.until("saved", |page| page.shown["drawing"]["changed"] == false);
    let paths = shop.get("/api/drawing/paths").json();
    assert_eq!(paths["shapes"][0]["number"], 1);
    assert_eq!(draw(&mut page, json!({ "op": "program", "name": "part.sbp" })), None);
    page.until("the program", |page| page.shown["opened"]["name"] == "part.sbp");
    assert!(shop.part("part.rsg").is_file() && shop.part("part.sbp").is_file());
}

#[test]
fn clauses_are_carried_out_all_or_none_and_taken_back() {
    let shop = shop(50.0, &[]);
    let mut page = shop.page();
    draw(&mut page, json!({ "op": "do", "clauses": "circle 0,0 10" }));
    let wrong = "select all; move 5,5; nonsense";
    assert_eq!(
        draw(&mut page, json!({ "op": "do", "clauses": wrong })).as_deref(),
        Some("mistake")
    );
    let late = "select all; move 5,5; erase; rotate 3";
    assert_eq!(draw(&mut page, json!({ "op": "do", "clauses": late })).as_deref(), Some("mistake"));
    let count = |shop: &support::Shop| {
        shop.get("/api/drawing/shapes").json()["shapes"].as_array().unwrap().len()
    };
    assert_eq!(count(&shop), 1);
    assert_eq!(draw(&mut page, json!({ "op": "undo" })), None);
    assert_eq!(count(&shop), 0);
    assert_eq!(draw(&mut page, json!({ "op": "undo" })).as_deref(), Some("state"));
    assert_eq!(draw(&mut page, json!({ "op": "redo" })), None);
    assert_eq!(count(&shop), 1);
}

#[test]
fn drawings_stay_in_the_part_folder() {
    let shop = shop(50.0, &[]);
    let mut page = shop.page();
    for name in ["../x.rsg", "/tmp/x.rsg", "x.exe"] {
        assert_eq!(draw(&mut page, json!({ "op": "save", "name": name })).as_deref(), Some("file"));
        assert_eq!(draw(&mut page, json!({ "op": "open", "name": name })).as_deref(), Some("file"));
    }
}
