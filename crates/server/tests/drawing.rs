//! Drawing through the server.

use crate::support;
use crate::support::{Page, shop};
use serde_json::{Value, json};

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
    assert_eq!(paths["paths"][0]["number"], 1);
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

/// A page with a drawing made by these clauses.
fn drawn(shop: &support::Shop, clauses: &str) -> Page {
    let mut page = shop.driver();
    assert_eq!(draw(&mut page, json!({ "op": "do", "clauses": clauses })), None);
    page.until("the drawing", |page| !page.shown["drawing"].is_null());
    page
}

#[test]
fn pro_glossary_block() {
    let shop = shop(50.0, &[]);
    let page = drawn(&shop, "line 0,0,0.5 100,0; array block 2x3 gap 5,5");
    let block = &page.shown["drawing"]["block"];
    assert_eq!(block, &json!({ "min": [0.0, -25.0], "max": [100.0, 0.0], "z": null }));
    let paths = shop.get("/api/drawing/paths").json();
    assert_eq!(paths["paths"].as_array().unwrap().len(), 6, "the array is no part of the block");
}

#[test]
fn pro_display_bounds_3d__block() {
    let shop = shop(50.0, &[]);
    shop.write("3d.dxf", kerf_formats::dxf::write(&in_space()).as_bytes());
    let mut page = shop.page();
    assert_eq!(draw(&mut page, json!({ "op": "open", "name": "3d.dxf" })), None);
    page.until("the drawing", |page| !page.shown["drawing"].is_null());
    let block = &page.shown["drawing"]["block"];
    assert_eq!(block, &json!({ "min": [0.0, 0.0], "max": [10.0, 20.0], "z": [-5.0, 3.0] }));
}

/// A line in space and a flat one, which has no height.
fn in_space() -> kerf_drawing::Drawing {
    use kerf_geom::{Polyarc, Vertex};
    let line = |x, y| Polyarc::open(vec![Vertex::new(0.0, 0.0, 0.0), Vertex::new(x, y, 0.0)]);
    let space = kerf_drawing::Shape::with_heights(line(10.0, 20.0), vec![-5.0, 3.0]);
    kerf_drawing::Drawing::of([space, kerf_drawing::Shape::flat(line(5.0, 5.0))])
}

#[test]
fn pro_display_filtered__vertices_that_are_left_out_are_told() {
    let shop = shop(50.0, &[]);
    let mut page = drawn(&shop, "line 0,0 0.01,0 10,0");
    assert_eq!(shop.get("/api/drawing/paths").json()["filtered"], json!([]));
    page.set("options.filter_mm", "0.02");
    assert_eq!(shop.get("/api/drawing/paths").json()["filtered"], json!([0.01, 0.0]));
}

#[test]
fn pro_display_smoothed__shapes_that_become_curves_are_told() {
    let shop = shop(50.0, &[]);
    let corner = |n: i32| f64::from(n) * std::f64::consts::TAU / 72.0;
    let points = (0..72).map(|n| format!("{},{}", 50.0 * corner(n).cos(), 50.0 * corner(n).sin()));
    let many = points.collect::<Vec<_>>().join(" ");
    let mut page = drawn(&shop, &format!("line {many} close; rect 200,0 300,100"));
    let numbers = |shop: &support::Shop| {
        let paths = shop.get("/api/drawing/paths").json();
        paths["smoothed"]
            .as_array()
            .unwrap()
            .iter()
            .map(|s| s["number"].clone())
            .collect::<Vec<_>>()
    };
    assert_eq!(numbers(&shop), [json!(1)]);
    page.set("smoothing.factor", "0");
    assert!(numbers(&shop).is_empty());
}

#[test]
fn pro_display_rough__paths_say_which_cut_they_are() {
    let shop = shop(50.0, &[]);
    let paths = |clauses: &str| {
        drop(drawn(&shop, clauses));
        let paths = shop.get("/api/drawing/paths").json()["paths"].clone();
        let least = |path: &Value| {
            let points = path["points"].as_array().unwrap();
            points.iter().step_by(3).filter_map(Value::as_f64).fold(f64::INFINITY, f64::min)
        };
        let path = |path: &Value| (path["pass"].as_str().unwrap().to_owned(), least(path));
        paths.as_array().unwrap().iter().map(path).collect::<Vec<_>>()
    };
    let rough = paths("rect 0,0 100,100; set black offset=3 rough=0.5");
    assert_eq!(rough, [("rough".into(), -3.5), ("final".into(), -3.0)]);
}

#[test]
fn pro_display_v3d_levels__heights_follow_the_settings() {
    let shop = shop(50.0, &[]);
    let mut page = drawn(&shop, "rect 0,0 100,100; set red height=-2");
    let heights = |page: &Page| page.shown["setup"]["heights"].clone();
    assert_eq!(heights(&page), json!({ "top": -10.0, "surface": -20.0, "bottom": -30.0 }));
    assert_eq!(page.shown["drawing"]["groups"][4]["levels"], json!([-22.0]));
    page.set("zpos.surface_mm", "-21");
    page.until("the surface", |page| page.shown["drawing"]["groups"][4]["levels"][0] == -23.0);
    assert_eq!(heights(&page)["surface"], -21.0);
}

#[test]
fn pro_edit_join_default__is_kept() {
    let shop = support::kept(tempfile::tempdir().unwrap());
    let mut page = drawn(&shop, "line 0,0 10,0; line 10.5,0 20,0; select all; join 0.7");
    page.until("the distance", |page| page.shown["drawing"]["join"] == 0.7);
    let file = shop.dir.path().join("data/machine.toml");
    page.until("the file", |_| std::fs::read_to_string(&file).is_ok_and(|t| t.contains("0.7")));
    let support::Shop { server, dir } = shop;
    drop((page, server));
    let again = support::kept(dir);
    let mut page = again.page();
    assert_eq!(draw(&mut page, json!({ "op": "new" })), None);
    page.until("the distance", |page| page.shown["drawing"]["join"] == 0.7);
}

#[test]
fn sheets_are_made_from_the_table_of_operations() {
    let shop = shop(50.0, &[]);
    let table = shop.get("/api/drawing/operations").json();
    let table = table.as_array().unwrap();
    assert_eq!(table.len(), kerf_drawing::ENTRIES.len());
    let engrave = table.iter().find(|entry| entry["name"] == "engrave").unwrap();
    let tool = &engrave["variants"][0]["parts"][1];
    let length = json!({ "is": "length", "name": "D" });
    assert_eq!((&tool["lead"], &tool["value"]), (&json!("tool="), &length));
}

#[test]
fn pro_clipboard_loadfile__in_the_console() {
    let shop = shop(50.0, &[]);
    let mut page = shop.driver();
    draw(&mut page, json!({ "op": "do", "clauses": "rect 0,0 5,5; point 9,9" }));
    draw(&mut page, json!({ "op": "save", "name": "b.dxf" }));
    draw(&mut page, json!({ "op": "new" }));
    let load = json!({ "op": "do", "clauses": "load-clipboard b.dxf" });
    assert_eq!(draw(&mut page, load), None);
    page.until("the clipboard", |page| page.shown["drawing"]["clipboard"] == 2);
    assert_eq!(page.shown["drawing"]["shapes"], 0);
    draw(&mut page, json!({ "op": "do", "clauses": "paste 0,0" }));
    page.until("the shapes", |page| page.shown["drawing"]["shapes"] == 2);
    for name in ["../b.dxf", "b.exe"] {
        let load = json!({ "op": "do", "clauses": format!("load-clipboard {name}") });
        assert_eq!(draw(&mut page, load).as_deref(), Some("file"));
    }
}

#[test]
fn pro_options_join() {
    let shop = support::kept(tempfile::tempdir().unwrap());
    let mut page = shop.driver();
    let before = page.shown["settings"].clone();
    page.set("options.join_mm", "0.5");
    page.until("the setting", |page| page.shown["settings"] != before);
    draw(&mut page, json!({ "op": "new" }));
    draw(
        &mut page,
        json!({ "op": "do", "clauses": "line 0,0 10,0; line 10.6,0 20,0; select all" }),
    );
    page.until("what is offered", |page| page.shown["drawing"]["join"] == 0.5);
    draw(&mut page, json!({ "op": "do", "clauses": "join 0.7" }));
    page.until("the last used", |page| page.shown["drawing"]["join"] == 0.7);
    let value = |shop: &support::Shop| {
        let areas = shop.get("/api/settings").json();
        let all = areas.as_array().unwrap().iter().flat_map(|a| a["settings"].as_array().unwrap());
        let mut it = all.filter(|it| it["key"] == "options.join_mm").map(|it| it["value"].clone());
        it.next().unwrap()
    };
    let file = shop.dir.path().join("data/machine.toml");
    page.until("the file", |_| std::fs::read_to_string(&file).is_ok_and(|t| t.contains("0.7")));
    page.until("the setting", |_| value(&shop) == "0.7");
    let support::Shop { server, dir } = shop;
    drop((page, server));
    assert_eq!(value(&support::kept(dir)), "0.7", "after a restart");
}

#[test]
fn pro_misc_unified() {
    // One server: a DXF is opened, offset, made a program, and run on the simulated machine.
    let shop = shop(200.0, &[]);
    let mut page = shop.driver();
    draw(&mut page, json!({ "op": "do", "clauses": "rect 10,10 60,40" }));
    assert_eq!(draw(&mut page, json!({ "op": "save", "name": "plate.dxf" })), None);
    draw(&mut page, json!({ "op": "new" }));
    assert_eq!(draw(&mut page, json!({ "op": "open", "name": "plate.dxf" })), None);
    page.until("the shape", |page| page.shown["drawing"]["shapes"] == 1);
    assert_eq!(draw(&mut page, json!({ "op": "do", "clauses": "set black offset=3" })), None);
    let paths = shop.get("/api/drawing/paths").json()["paths"].clone();
    let points = paths[0]["points"].as_array().unwrap();
    let least = points.iter().step_by(3).filter_map(Value::as_f64).fold(f64::INFINITY, f64::min);
    assert!((least - 7.0).abs() < 1e-6, "offset by 3 mm: {least}");
    assert_eq!(draw(&mut page, json!({ "op": "program", "name": "plate.sbp" })), None);
    page.until("the program", |page| page.shown["opened"]["name"] == "plate.sbp");
    page.until("its preview", |page| page.shown["opened"]["preview"]["state"] == "ready");
    assert_eq!(page.run(), None);
    let number = page.asked("spindle");
    assert_eq!(page.act(json!({ "do": "answer", "question": number, "answer": "OK" })), None);
    page.until("the end", |page| page.shown["job"]["ended"] == "ok");
}

#[test]
fn pro_plasma_arc_input() {
    let shop = shop(50.0, &[]);
    let mut page = shop.driver();
    let label = |shop: &support::Shop| {
        let lamps = shop.get("/api/inputs").json();
        let arc = kerf_machine::lines::Input::EndBottomDelay.number();
        let lamps = lamps.as_array().unwrap().clone();
        lamps.into_iter().find(|lamp| lamp["number"] == arc).unwrap()["label"].clone()
    };
    assert_eq!(label(&shop), "end_bottom_delay");
    let before = page.shown["settings"].clone();
    page.set("plasma.use", "true");
    page.until("the setting", |page| page.shown["settings"] != before);
    assert_eq!(label(&shop), "arc");
}

#[test]
fn pro_laser_use__no_page_shows_a_laser_that_is_not_there() {
    let shop = shop(50.0, &[]);
    let mut page = shop.driver();
    let keys = |shop: &support::Shop| -> Vec<String> {
        let areas = shop.get("/api/settings").json();
        let all = areas.as_array().unwrap().iter().flat_map(|a| a["settings"].as_array().unwrap());
        let keys = all.map(|it| it["key"].as_str().unwrap().to_owned());
        keys.filter(|key| key.starts_with("laser.")).collect()
    };
    assert_eq!(keys(&shop), ["laser.use", "laser.type"]);
    for (key, value) in [("laser.type", "cw"), ("laser.use", "true")] {
        let before = page.shown["settings"].clone();
        page.set(key, value);
        page.until(key, |page| page.shown["settings"] != before);
    }
    assert!(keys(&shop).len() > 10);
}

/// The server ends and another one begins in the same folders.
fn begun_again(shop: support::Shop) -> support::Shop {
    let support::Shop { server, dir } = shop;
    drop(server);
    support::kept(dir)
}

#[test]
fn a_drawing_that_was_not_saved_is_there_again_when_kerf_begins_anew() {
    let shop = support::kept(tempfile::tempdir().unwrap());
    let draft = shop.dir.path().join("data/drawing.draft");
    let mut page = shop.page();
    draw(&mut page, json!({ "op": "do", "clauses": "rect 0,0 10,5; select all; group red" }));
    draw(&mut page, json!({ "op": "save", "name": "part.rsg" }));
    draw(&mut page, json!({ "op": "do", "clauses": "circle 0,0 10; set blue offset=2" }));
    draw(&mut page, json!({ "op": "finish", "at": [3.0, 4.0] }));
    // Kept while it is drawn: a server that is killed says nothing.
    page.until("the draft", |_| {
        std::fs::read_to_string(&draft).is_ok_and(|text| text.contains("[3.0,4.0]"))
    });
    let before = shop.get("/api/drawing/shapes").json()["shapes"].clone();
    let shop = begun_again(shop);
    let mut page = shop.page();
    page.until("the drawing", |page| !page.shown["drawing"].is_null());
    assert_eq!(shop.get("/api/drawing/shapes").json()["shapes"], before);
    let state = page.shown["drawing"].clone();
    assert_eq!((&state["name"], &state["changed"]), (&json!("part.rsg"), &json!(true)));
    assert_eq!((&state["finish"], &state["shapes"]), (&json!([3.0, 4.0]), &json!(2)));
    assert_eq!(state["groups"][1]["offset"], 2.0, "{}", state["groups"]);
    assert!(state["notes"][0].as_str().unwrap().contains("not saved when Kerf ended"));
    draw(&mut page, json!({ "op": "save", "name": "part.rsg" }));
    let shop = begun_again(shop);
    assert!(!draft.exists());
    assert!(shop.page().shown["drawing"].is_null());
}

#[test]
fn a_draft_that_cannot_be_read_is_told_and_laid_aside() {
    let dir = tempfile::tempdir().unwrap();
    let data = dir.path().join("data");
    std::fs::create_dir(&data).unwrap();
    std::fs::write(data.join("drawing.draft"), "{half a").unwrap();
    let shop = support::kept(dir);
    let told = shop.page().shown["messages"].to_string();
    assert!(told.contains("cannot be read") && told.contains("drawing.unread"), "{told}");
    drop(shop.server);
    assert_eq!(std::fs::read_to_string(data.join("drawing.unread")).unwrap(), "{half a");
}
