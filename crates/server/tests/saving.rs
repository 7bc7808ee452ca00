//! Files that are written over: never without leave, and what they were comes back.

use crate::support;
use crate::support::{Answer, Shop, shop};
use serde_json::{Value, json};

/// A script that draws.
fn draw(shop: &Shop, op: &Value) -> Answer {
    shop.post("/api/do/draw", json!({ "op": op }), &[])
}

fn does(shop: &Shop, clauses: &str) {
    assert_eq!(draw(shop, &json!({ "op": "do", "clauses": clauses })).status, 200, "{clauses}");
}

/// Reason that nothing was done; nothing when it was.
fn why(answer: &Answer) -> Value {
    answer.json()["why"].clone()
}

fn read(shop: &Shop, name: &str) -> String {
    std::fs::read_to_string(shop.part(name)).unwrap()
}

fn put(shop: &Shop, path: &str, headers: &[(&str, &str)], text: &str) -> Answer {
    shop.ask(&format!("PUT /api/files/{path}"), headers, text.as_bytes())
}

/// The hash that an answer carries.
fn hash(answer: &Answer) -> String {
    let line = answer.head.lines().find_map(|line| line.strip_prefix("etag: ")).unwrap();
    line.trim_matches('"').to_owned()
}

fn versions(shop: &Shop, name: &str) -> Vec<u64> {
    let list = shop.get(&format!("/api/files/{name}?versions")).json();
    list.as_array().unwrap().iter().map(|it| it["number"].as_u64().unwrap()).collect()
}

#[test]
fn a_put_replaces_a_file_with_leave_only() {
    let shop = shop(1.0, &[("a.sbp", "MX,1\nMX,2\n")]);
    let refused = put(&shop, "a.sbp", &[], "MX,3");
    assert_eq!((refused.status, why(&refused)), (409, json!("replaces")));
    let told = refused.json()["text"].as_str().unwrap().to_owned();
    assert!(told.contains("a.sbp is there already, a part program of 2 lines, 10 bytes"), "{told}");
    let read_first = hash(&shop.get("/api/files/a.sbp"));
    assert_eq!(put(&shop, "a.sbp", &[("If-Match", "\"0000\"")], "MX,3").status, 409);
    assert_eq!(read(&shop, "a.sbp"), "MX,1\nMX,2\n");

    let matched = format!("\"{read_first}\"");
    let saved = put(&shop, "a.sbp", &[("If-Match", &matched)], "MX,3");
    assert_eq!((saved.status, read(&shop, "a.sbp").as_str()), (200, "MX,3"));
    assert_eq!(put(&shop, "a.sbp", &[("If-Match", &matched)], "MX,4").status, 409, "it is another");
    assert_eq!(put(&shop, "a.sbp", &[("If-Match", &hash(&saved))], "MX,4").status, 200);
    assert_eq!(put(&shop, "a.sbp?replace=1", &[], "MX,5").status, 200);
    assert_eq!(put(&shop, "a.sbp", &[("If-Match", "*")], "MX,6").status, 200);
    assert_eq!(put(&shop, "a.sbp", &[], "MX,6").status, 200, "nothing is lost");
    assert_eq!(put(&shop, "b.sbp", &[], "MX,1").status, 200, "nothing is there");
}

#[test]
fn what_a_file_is_and_was_is_told_and_brought_back() {
    let shop = shop(1.0, &[("a.sbp", "MX,1\n")]);
    let about = shop.get("/api/files/a.sbp?about").json();
    assert_eq!((&about["what"], &about["bytes"]), (&json!("a part program of 1 line"), &json!(5)));
    assert_eq!(about["hash"], hash(&shop.get("/api/files/a.sbp")));
    assert_eq!(versions(&shop, "a.sbp"), [0; 0]);
    for text in ["MX,2\n", "MX,3\n"] {
        assert_eq!(put(&shop, "a.sbp?replace=1", &[], text).status, 200);
    }
    assert_eq!(versions(&shop, "a.sbp"), [2, 1]);
    assert_eq!(shop.get("/api/files/a.sbp?version=1").body, b"MX,1\n");
    let restore =
        |number: u32| shop.ask(&format!("POST /api/files/a.sbp?restore={number}"), &[], b"");
    assert_eq!(restore(1).status, 200);
    assert_eq!(read(&shop, "a.sbp"), "MX,1\n");
    assert_eq!(versions(&shop, "a.sbp"), [3, 2, 1], "what it took the place of is kept too");
    assert_eq!(restore(9).status, 404);
    for outside in ["..%2Fdata%2Fx", "%2Fetc%2Fpasswd"] {
        assert_eq!(shop.get(&format!("/api/files/{outside}?versions")).status, 404, "{outside}");
    }
    // In the data folder: the part folder has nothing but part files.
    assert_eq!(std::fs::read_dir(shop.part("")).unwrap().count(), 1);
}

#[test]
fn a_file_that_went_comes_back_from_its_versions() {
    let shop = shop(1.0, &[("a.sbp", "MX,1\n")]);
    put(&shop, "a.sbp?replace=1", &[], "MX,2\n");
    std::fs::remove_file(shop.part("a.sbp")).unwrap();
    assert_eq!(shop.ask("POST /api/files/a.sbp?restore=1", &[], b"").status, 200);
    assert_eq!(read(&shop, "a.sbp"), "MX,1\n");
}

#[test]
fn a_file_is_deleted_into_the_bin_and_comes_back_or_goes_for_good() {
    let shop = shop(1.0, &[("a.sbp", "MX,1\n"), ("b.sbp", "MX,2\n")]);
    let bin = || {
        let list = shop.get("/api/files?bin").json();
        let names =
            list.as_array().unwrap().iter().map(|it| it["name"].as_str().unwrap().to_owned());
        names.collect::<Vec<_>>()
    };
    let about = shop.get("/api/files/a.sbp?about").json();
    let tag = format!("\"{}\"", about["hash"].as_str().unwrap());
    let delete = |path: &str, tag: &str| {
        shop.ask(&format!("DELETE /api/files/{path}"), &[("if-match", tag)], b"")
    };
    assert_eq!(why(&delete("a.sbp", "\"0000\"")), "replaces");
    assert_eq!(why(&delete("c.sbp", &tag)), "file");
    assert_eq!(why(&delete("../a.sbp", &tag)), "file");
    assert_eq!((bin(), read(&shop, "a.sbp")), (Vec::new(), "MX,1\n".into()));
    assert_eq!(delete("a.sbp", &tag).status, 200);
    assert!(!shop.part("a.sbp").exists());
    assert_eq!(bin(), ["a.sbp"]);
    let number = versions(&shop, "a.sbp")[0];
    let back = shop.ask(&format!("POST /api/files/a.sbp?restore={number}"), &[], b"");
    assert_eq!((back.status, read(&shop, "a.sbp"), bin()), (200, "MX,1\n".into(), Vec::new()));
    assert_eq!(why(&delete("b.sbp?forget", &tag)), "file");
    assert_eq!(delete("a.sbp", &tag).status, 200);
    assert_eq!(delete("a.sbp?forget", "").status, 200);
    assert!(bin().is_empty() && versions(&shop, "a.sbp").is_empty());
}

#[test]
fn a_drawing_and_its_program_replace_no_file_without_leave() {
    let shop = shop(1.0, &[("door.rsg", "by hand"), ("door.sbp", "MX,1"), ("door.dxf", "old")]);
    does(&shop, "rect 0,0 10,5");
    for (op, name) in [("save", "door.rsg"), ("save", "door.dxf"), ("program", "door.sbp")] {
        let before = read(&shop, name);
        let about = shop.get(&format!("/api/files/{name}?about")).json();
        for replaces in [Value::Null, json!("0000")] {
            let refused = draw(&shop, &json!({ "op": op, "name": name, "replaces": replaces }));
            assert_eq!(why(&refused), "replaces", "{name}");
            assert_eq!(read(&shop, name), before);
        }
        let done = draw(&shop, &json!({ "op": op, "name": name, "replaces": about["hash"] }));
        assert_eq!((done.status, versions(&shop, name)), (200, vec![1]), "{name}");
        assert_eq!(shop.get(&format!("/api/files/{name}?version=1")).body, before.as_bytes());
    }
}

#[test]
fn the_file_that_is_drawn_on_is_saved_without_a_question_unless_it_was_changed() {
    let shop = shop(1.0, &[]);
    let save = json!({ "op": "save", "name": "part.rsg" });
    does(&shop, "rect 0,0 10,5");
    assert_eq!(draw(&shop, &save).status, 200);
    does(&shop, "circle 0,0 10");
    assert_eq!(draw(&shop, &save).status, 200);
    draw(&shop, &json!({ "op": "open", "name": "part.rsg" }));
    does(&shop, "circle 50,0 10");
    assert_eq!(draw(&shop, &save).status, 200);
    shop.write("part.rsg", b"another program wrote this");
    does(&shop, "circle 70,0 10");
    assert_eq!(why(&draw(&shop, &save)), "replaces");
    assert_eq!(read(&shop, "part.rsg"), "another program wrote this");
}

#[test]
fn a_dxf_that_was_opened_is_not_what_would_be_written() {
    let shop = shop(1.0, &[]);
    does(&shop, "rect 0,0 10,5");
    assert_eq!(draw(&shop, &json!({ "op": "save", "name": "a.dxf" })).status, 200);
    draw(&shop, &json!({ "op": "open", "name": "a.dxf" }));
    does(&shop, "circle 50,0 10");
    assert_eq!(why(&draw(&shop, &json!({ "op": "save", "name": "a.dxf" }))), "replaces");
}

#[test]
fn what_a_dxf_has_no_place_for_is_told_and_stays_unsaved() {
    let shop = shop(1.0, &[]);
    does(&shop, "rect 0,0 10,5; select all; group red");
    for name in ["a.dxf", "a.svg"] {
        let done = draw(&shop, &json!({ "op": "save", "name": name })).json();
        let told = format!("{name}: groups and arrays will not be saved; .rsg keeps them");
        assert_eq!(done["notes"], json!([told]));
        let drawing = &shop.get("/api/state").json()["drawing"];
        assert_eq!((&drawing["changed"], &drawing["name"]), (&json!(true), &Value::Null));
        assert!(shop.part(name).is_file());
    }
    draw(&shop, &json!({ "op": "save", "name": "a.rsg" }));
    assert_eq!(shop.get("/api/state").json()["drawing"]["changed"], false);
}

#[test]
fn tool_paths_that_were_opened_are_saved_as_tool_paths() {
    let shop = shop(1.0, &[("plate.rsg", "the drawing")]);
    shop.write("plate.rsm", support::rsm("rect 0,0 40,30; set black offset=2").as_bytes());
    let opened = draw(&shop, &json!({ "op": "open", "name": "plate.rsm" })).json();
    let told = opened["notes"].to_string();
    assert_eq!(told.matches("These are tool paths").count(), 1, "{told}");
    does(&shop, "select all; move 5,0");
    assert_eq!(why(&draw(&shop, &json!({ "op": "save", "name": "plate.rsg" }))), "replaces");
    let saved = draw(&shop, &json!({ "op": "save", "name": "plate.rsm" }));
    assert_eq!(saved.status, 200, "{:?}", saved.json());
    assert_eq!(read(&shop, "plate.rsg"), "the drawing");
    // The paths are cut as they are, to 47 mm: nothing is offset twice.
    let program = draw(&shop, &json!({ "op": "program", "name": "plate.nc" }));
    assert_eq!(program.status, 200, "{:?}", program.json());
    assert!(read(&shop, "plate.nc").contains("X1.8503937 "), "{}", read(&shop, "plate.nc"));
    let machine = json!({ "drawing": null, "anew": true });
    assert_eq!(why(&shop.post("/api/do/machine", machine, &[])), "state");
    let (job, _) = kerf_toolpath::read(read(&shop, "plate.rsm").as_bytes());
    assert_eq!((job.edited, job.paths.len()), (true, 1));
    // A drawing is no job: its paths are made.
    draw(&shop, &json!({ "op": "new" }));
    does(&shop, "rect 0,0 10,5");
    assert_eq!(why(&draw(&shop, &json!({ "op": "save", "name": "new.rsm" }))), "file");
}

/// The server ends and another one begins in the same folders.
fn begun_again(shop: Shop) -> Shop {
    let Shop { server, dir } = shop;
    drop(server);
    support::kept(dir)
}

fn draft(name: &str, text: &str, base: &str) -> Value {
    json!({ "name": name, "text": text, "ends": "\n", "base": base, "changedOnDisk": false })
}

fn keep(shop: &Shop, draft: &Value) -> u16 {
    let json = [("Content-Type", "application/json")];
    shop.ask("PUT /api/texts", &json, draft.to_string().as_bytes()).status
}

#[test]
fn what_is_typed_is_there_again_when_kerf_begins_anew() {
    let shop = support::kept(tempfile::tempdir().unwrap());
    shop.write("a.sbp", b"MX,1");
    let base = hash(&shop.get("/api/files/a.sbp"));
    let (of_file, of_new) = (draft("a.sbp", "MX,1\nMX,2", &base), draft("", "MY,1", ""));
    assert_eq!((keep(&shop, &of_file), keep(&shop, &of_new)), (200, 200));
    let shop = begun_again(shop);
    let mut texts = shop.get("/api/texts").json();
    for text in texts.as_array_mut().unwrap() {
        let text = text.as_object_mut().unwrap();
        assert_eq!(text.remove("page"), Some(json!("")), "no page wrote it");
        assert!(text.remove("revision").is_some());
        assert_eq!(text.remove("edits"), Some(json!(null)), "a short text is kept whole");
    }
    assert_eq!(texts, json!([of_new, of_file]), "the newest first");
    shop.write("a.sbp", b"MX,7");
    assert_eq!(shop.get("/api/texts").json()[1]["changedOnDisk"], true);
    assert_eq!(shop.ask("DELETE /api/texts?name=", &[], b"").status, 200);
    assert_eq!(shop.get("/api/texts").json().as_array().unwrap().len(), 1);
}

#[test]
fn a_drawing_that_is_there_again_says_that_its_file_was_changed() {
    let shop = support::kept(tempfile::tempdir().unwrap());
    let save = json!({ "op": "save", "name": "part.rsg" });
    does(&shop, "rect 0,0 10,5");
    draw(&shop, &save);
    does(&shop, "circle 0,0 10");
    let shop = begun_again(shop);
    let notes = |shop: &Shop| shop.get("/api/state").json()["drawing"]["notes"].clone();
    assert!(!notes(&shop).to_string().contains("was changed"), "{}", notes(&shop));
    does(&shop, "circle 9,9 1");
    shop.write("part.rsg", b"another program wrote this");
    let shop = begun_again(shop);
    assert!(notes(&shop).to_string().contains("Its file was changed"), "{}", notes(&shop));
    assert_eq!(why(&draw(&shop, &save)), "replaces");
}

#[test]
fn tool_paths_that_are_there_again_are_still_tool_paths() {
    let shop = support::kept(tempfile::tempdir().unwrap());
    shop.write("plate.rsm", support::rsm("rect 0,0 40,30").as_bytes());
    draw(&shop, &json!({ "op": "open", "name": "plate.rsm" }));
    does(&shop, "select all; move 5,0");
    let shop = begun_again(shop);
    let saved = draw(&shop, &json!({ "op": "save", "name": "plate.rsm" }));
    assert_eq!(saved.status, 200, "{:?}", saved.json());
    assert!(kerf_toolpath::read(read(&shop, "plate.rsm").as_bytes()).0.edited);
}
