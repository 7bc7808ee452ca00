//! Requests of pages to the shop besides driving: the run parameters of a file, its folder, the recorder, watched
//! variables, switches of the simulated machine, the configuration.

use crate::support;
use crate::support::{Page, shop};
use serde_json::{Value, json};

/// Sends an act that carries the lease.
#[track_caller]
fn drive(page: &mut Page, mut act: Value) -> Option<String> {
    act["lease"] = page.lease.into();
    page.act(act)
}

#[test]
fn a_file_is_previewed_and_run_with_the_parameters_of_fp() {
    let shop = shop(100.0, &[("a.sbp", "MX,1\nMX,0\n")]);
    let mut page = shop.driver();
    page.open_file("a.sbp");
    let plain = page.shown["opened"].clone();
    assert_eq!(plain["parameters"]["repetitions"], 1);
    let parameters = json!({ "proportion": [2, 1, 1], "repetitions": 3, "plunge": -1 });
    assert_eq!(page.act(json!({ "do": "parameters", "parameters": parameters })), None);
    page.until("another preview", |page| {
        let opened = &page.shown["opened"];
        opened["hash"] != plain["hash"] && opened["preview"]["state"] == "ready"
    });
    let key = page.shown["opened"]["preview"]["key"].as_str().unwrap().to_owned();
    let info = shop.get(&format!("/api/preview/{key}")).json();
    let far = info["bounds"][1][0].as_f64().unwrap();
    assert!((far - 50.8).abs() < 1e-5, "twice as far: {info}");
    assert_eq!(info["bounds"][0][2], -3.0, "three plunges");
    // The hash of before is that of another cut.
    let old = json!({ "do": "run", "hash": plain["hash"] });
    assert_eq!(drive(&mut page, old).as_deref(), Some("changed"));
    assert_eq!(page.run(), None);
    page.until_state("idle");
    assert_eq!(page.shown["job"]["ended"], "ok");
    let wrong =
        [json!({ "repetitions": 0 }), json!({ "offset": 3 }), json!({ "proportion": [0, 1, 1] })];
    for parameters in wrong {
        let act = json!({ "do": "parameters", "parameters": parameters });
        assert_eq!(page.act(act).as_deref(), Some("malformed"), "{parameters}");
    }
    let opened = json!({ "do": "open", "name": "a.sbp", "parameters": { "tabs": true } });
    assert_eq!(page.act(opened), None);
    assert_eq!(page.shown["opened"]["parameters"]["tabs"], true);
}

#[test]
fn sbp_file_fs_dialog() {
    let shop = shop(100.0, &[]);
    let doors = shop.part("doors");
    std::fs::create_dir(&doors).unwrap();
    std::fs::write(doors.join("in.sbp"), "MX,3\n").unwrap();
    std::fs::write(doors.join("notes.txt"), "x").unwrap();
    let mut page = shop.driver();
    assert_eq!(page.shown["folder"], json!({ "name": "", "mask": "*.sb?" }));
    let folder = |name: &str| json!({ "do": "folder", "name": name, "mask": "*.sbp" });
    assert_eq!(page.act(folder("doors")), None);
    page.until("the folder", |page| page.shown["folder"]["name"] == "doors");
    page.until_state("idle");
    page.command("FP,in.sbp");
    assert!((page.x() - 76.2).abs() < 1e-6, "the file of that folder: {}", page.x());
    let names = |path: &str| {
        let list = shop.get(path).json();
        list.as_array().unwrap().iter().map(|f| f["name"].clone()).collect::<Vec<_>>()
    };
    assert_eq!(names("/api/files?folder=doors&mask=*.sbp"), ["doors/in.sbp"]);
    assert_eq!(names("/api/files?folder=doors").len(), 2);
    let values = shop.get("/api/values").json();
    assert_eq!(values["folder"]["name"], "doors");
    // FS in a line tells pages as well.
    page.command("FS,..");
    assert_eq!(page.shown["folder"]["name"], "");
    // Where a file is opened, the next one is looked for.
    page.open_file("doors/in.sbp");
    page.until("the folder", |page| page.shown["folder"]["name"] == "doors");
    page.until_state("idle");
    page.command("FS,..");
    for name in ["..", "no", "/etc"] {
        assert_eq!(page.act(folder(name)).as_deref(), Some("file"), "{name}");
    }
}

#[test]
fn the_recorder_is_shown_and_takes_lines_of_the_keypad() {
    let shop = shop(100.0, &[]);
    let mut page = shop.driver();
    assert_eq!(page.shown["recorder"]["on"], true);
    page.command("MX,1");
    page.until("the line", |page| page.shown["recorder"]["lines"] == json!(["MX,1"]));
    assert_eq!(page.act(json!({ "do": "record", "line": "J2,3,4" })), None);
    page.until("the place", |page| page.shown["recorder"]["lines"] == json!(["MX,1", "J2,3,4"]));
    page.command("RR,1");
    assert!((page.x() - 76.2).abs() < 1e-6, "{}", page.x());
    page.command("RI");
    page.until("the sign", |page| page.shown["recorder"]["on"] == false);
    page.command("RZ");
    page.until("nothing", |page| page.shown["recorder"]["lines"] == json!([]));
    let wrong = json!({ "do": "record", "line": "QQ,1" });
    assert_eq!(page.act(wrong).as_deref(), Some("mistake"));
}

#[test]
fn watched_variables_are_shown_while_a_program_runs() {
    let text = "&a=1\nPAUSE\n&a=&a+1\n&b=\"left\"\nPAUSE\n";
    let shop = shop(100.0, &[("a.sbp", text)]);
    let mut page = shop.driver();
    assert_eq!(page.act(json!({ "do": "watch", "names": ["&A", "&b", "&c"] })), None);
    page.open_file("a.sbp");
    assert_eq!(page.run(), None);
    let ok = |page: &mut Page| {
        let question = page.asked("pause");
        page.act(json!({ "do": "answer", "question": question, "answer": "OK" }));
        question
    };
    let value = |name: &str, value: &str| json!({ "name": name, "value": value });
    let first = page.asked("pause");
    page.until("a first value", |page| page.shown["watched"] == json!([value("&A", "1")]));
    ok(&mut page);
    page.until("the next pause", |page| page.shown["asked"]["number"].as_u64() > Some(first));
    let both = json!([value("&A", "2"), value("&b", "left")]);
    page.until("both", |page| page.shown["watched"] == both);
    ok(&mut page);
    page.until_state("idle");
    assert_eq!(page.shown["watched"], both, "what a run leaves stays");
    page.command("&b = 5");
    page.until("the typed one", |page| page.shown["watched"][1]["value"] == "5");
    let wrong = json!({ "do": "watch", "names": ["a"] });
    assert_eq!(page.act(wrong).as_deref(), Some("malformed"));
}

#[test]
fn switches_of_the_simulated_machine_are_moved_by_hand() {
    let text = "ON INPUT(3,1) GOTO away\nMX,20\nEND\naway:\nPRINT \"handled\"\nEND\n";
    let shop = shop(5.0, &[("a.sbp", text), ("b.sbp", "PAUSE UNTIL 2,1\nMX,2\n")]);
    let mut page = shop.driver();
    assert_eq!(shop.get("/api/inputs").json().as_array().unwrap().len(), 28);
    let input = |number: u8, on: bool| json!({ "do": "input", "number": number, "on": on });
    // While it stands; the lamp says so, and the next run finds it there.
    assert_eq!(drive(&mut page, input(1, true)), None);
    page.until("the lamp", |page| page.shown["io"]["inputs"][0]["on"] == true);
    page.until_state("idle");
    page.command("&on = %(51)");
    let values = shop.get("/api/values").json();
    assert_eq!(values["variables"][0]["value"], "1", "{values}");
    // In the middle of a move.
    page.open_file("a.sbp");
    assert_eq!(page.run(), None);
    page.until("a move", |page| page.x() > 5.0);
    assert_eq!(drive(&mut page, input(3, true)), None);
    page.until("the handler", |page| page.shown["printed"] == json!(["handled"]));
    page.until_state("idle");
    assert!(page.x() < 500.0, "it did not go on to 20 in: {}", page.x());
    // While a program waits for it.
    page.open_file("b.sbp");
    assert_eq!(page.run(), None);
    page.asked("pause");
    assert_eq!(drive(&mut page, input(2, true)), None);
    page.until("the end", |page| page.shown["job"]["ended"] == "ok");
    page.until_state("idle");
    assert!((page.x() - 50.8).abs() < 1e-6);
    assert_eq!(drive(&mut page, input(29, true)).as_deref(), Some("malformed"));
    assert_eq!(page.shown["io"]["inputs"][3]["duty"], "stop");
}

#[test]
fn a_switch_that_is_moved_in_an_alarm_is_moved() {
    let shop = shop(100.0, &[]);
    let mut page = shop.driver();
    // A stop circuit that is open reads on.
    let input = |open: bool| json!({ "do": "input", "number": 4, "on": !open });
    let lamp = |on: bool| move |page: &Page| page.shown["io"]["inputs"][3]["on"] == on;
    assert_eq!(drive(&mut page, input(true)), None);
    page.until("the lamp", lamp(true));
    assert_eq!(drive(&mut page, json!({ "do": "command", "line": "MX,1" })), None);
    page.until_state("alarm");
    let why = page.shown["machine"]["why"].clone();
    assert!(why.is_string(), "{why}");
    assert_eq!(drive(&mut page, input(false)), None);
    page.until("no lamp", lamp(false));
    assert_eq!(page.shown["machine"]["state"], "alarm", "nobody took note of it");
    assert_eq!(page.shown["machine"]["why"], why);
    assert_eq!(page.act(json!({ "do": "acknowledge" })), None);
    page.drive();
    page.command("MX,1");
    assert!((page.x() - 25.4).abs() < 1e-6, "{}", page.x());
}

#[test]
fn the_configuration_is_a_form_and_a_change_names_what_is_wrong() {
    let shop = shop(100.0, &[]);
    let mut page = shop.driver();
    let find = |key: &str| {
        let areas = shop.get("/api/settings").json();
        let areas = areas.as_array().unwrap().clone();
        let mut all = areas.iter().flat_map(|area| area["settings"].as_array().unwrap().clone());
        all.find(|entry| entry["key"] == key).unwrap_or_else(|| panic!("{key}"))
    };
    let diameter = find("cutter.diameter_mm");
    assert_eq!(diameter["unit"], "mm");
    assert_eq!(diameter["kind"], json!({ "is": "number", "none": false }));
    assert_eq!((&diameter["value"], &diameter["default"]), (&json!("6.35"), &json!("6.35")));
    assert_eq!(find("units")["kind"], json!({ "is": "choice", "words": ["in", "mm"] }));
    let set = |key: &str, value: &str| json!({ "do": "set", "key": key, "value": value });
    let before = page.shown["settings"].clone();
    assert_eq!(drive(&mut page, set("cutter.diameter_mm", "9.5")), None);
    page.until("the change", |page| page.shown["settings"] != before);
    page.until_state("idle");
    assert_eq!(find("cutter.diameter_mm")["value"], "9.5");
    let changes = shop.get("/api/settings?changes").json();
    assert_eq!(changes.as_array().unwrap().len(), 1, "{changes}");
    assert_eq!(changes[0]["key"], "cutter.diameter_mm");
    assert_eq!((&changes[0]["from"], &changes[0]["to"]), (&json!("6.35"), &json!("9.5")));
    assert_eq!(changes[0]["by"], "");
    // One machine: the V command shows it, and changes it.
    let lines = shop.get("/api/values").json()["settings"].to_string();
    assert!(lines.contains("VC,0.3740157"), "{lines}");
    page.command("VC,.5");
    assert_eq!(find("cutter.diameter_mm")["value"], "12.7");
    let changes = shop.get("/api/settings?changes").json();
    assert_eq!(changes.as_array().unwrap().len(), 2, "{changes}");
    let typed = &changes[0];
    assert_eq!((&typed["from"], &typed["to"]), (&json!("9.5"), &json!("12.7")));
    assert_eq!((&typed["key"], &typed["through"]), (&json!("cutter.diameter_mm"), &json!("VC,.5")));
    assert_eq!(drive(&mut page, set("delays.router_start_s", "3")), None);
    page.until_state("idle");
    assert_eq!(find("delays.router_start_s")["value"], "3");
    let id = page.send(
        json!({ "do": "set", "lease": page.lease, "key": "cutter.diameter_mm", "value": "-1" }),
    );
    let refused = page.problem(id);
    assert!(refused.contains("cutter.diameter_mm must be greater than 0"), "{refused}");
    for (key, value) in [("cutter.diametr_mm", "1"), ("units", "ell"), ("axes", "9")] {
        assert_eq!(drive(&mut page, set(key, value)).as_deref(), Some("mistake"), "{key} {value}");
    }
}

#[test]
fn diagnostics_come_with_the_values() {
    let shop = shop(100.0, &[]);
    let mut page = shop.driver();
    page.command("SO,7,1");
    let values = shop.get("/api/values").json();
    let of = |name: &str| {
        let all = values["diagnostics"].as_array().unwrap();
        all.iter().find(|row| row["name"] == name).map(|row| row["value"].clone())
    };
    assert_eq!(of("outputs on"), Some(json!("7")));
    assert!(of("software").is_some() && of("firmware").is_some());
    assert!(values["data"].as_str().unwrap().contains("data"));
}

#[test]
fn a_file_that_a_program_shows_is_named_for_the_editor() {
    let shop = shop(100.0, &[("a.sbp", "FE,notes.txt\nMX,1\n"), ("notes.txt", "hello")]);
    let mut page = shop.driver();
    page.open_file("a.sbp");
    assert_eq!(page.run(), None);
    let question = page.asked("editor");
    assert_eq!(page.shown["asked"]["edits"], "notes.txt");
    assert_eq!(page.x(), 0.0, "it waits");
    page.act(json!({ "do": "answer", "question": question, "answer": "OK" }));
    page.until_state("idle");
    assert!((page.x() - 25.4).abs() < 1e-6);
}

/// A server whose machine is kept.
fn kept_shop() -> support::Shop {
    support::kept(tempfile::tempdir().unwrap())
}

#[test]
fn sbp_ctl_reg__over_http() {
    let shop = kept_shop();
    let put = |key: &str, value: &str| {
        shop.ask(
            &format!("PUT /api/registry/{key}"),
            &[("Content-Type", "text/plain")],
            value.as_bytes(),
        )
    };
    let get = |key: &str| {
        let answer = shop.get(&format!("/api/registry/{key}"));
        (answer.status, String::from_utf8(answer.body).unwrap())
    };
    assert_eq!(put("ShopBot/UserData/uValue", "seven").status, 200);
    assert_eq!(get("ShopBot/UserData/uValue"), (200, "seven".into()));
    assert_eq!(get("ShopBot/UserData/Status"), (200, "0".into()));
    let mut page = shop.driver();
    let lease = page.lease;
    let line = "GetUsrVal &a\nPAUSE\nSetUsrVal eight";
    assert_eq!(page.act(json!({ "do": "command", "lease": lease, "line": line })), None);
    let question = page.asked("pause");
    let status: u32 = get("Status").1.parse().unwrap();
    assert_eq!(status & 8, 8, "it pauses: {status}");
    page.act(json!({ "do": "answer", "question": question, "answer": "OK" }));
    page.until_state("idle");
    assert_eq!(get("uValue"), (200, "eight".into()));
    assert_eq!(shop.get("/api/values").json()["variables"][0]["value"], "seven");
    let all = shop.get("/api/registry").json().to_string();
    assert!(all.contains("OutPutSwitches"), "{all}");
    assert_eq!(put("uValue", "").status, 200);
    assert_eq!(get("uValue").0, 404);
}

#[test]
fn sbp_ctl_reg_ucommand__in_the_server() {
    let shop = kept_shop();
    let put = |value: &str| {
        let answer = shop.ask("PUT /api/registry/uCommand", &[], value.as_bytes());
        (answer.status, answer.json()["why"].as_str().unwrap_or_default().to_owned())
    };
    let mut page = shop.page();
    assert_eq!(put("MX,1"), (403, "lease".into()), "nobody drives");
    page.drive();
    assert_eq!(page.act(json!({ "do": "disarm" })), None);
    assert_eq!(put("MX,1"), (403, "disarmed".into()));
    assert_eq!(page.x(), 0.0);
    page.drive();
    assert_eq!(put("MX,2").0, 200, "it is of the device that drives");
    page.until("the move", |page| (page.x() - 50.8).abs() < 1e-6);
    page.until_state("idle");
    assert_eq!(shop.get("/api/registry/uCommand").status, 404, "it is carried out once");
    // What a program writes into the watched file counts as well.
    let data = shop.dir.path().join("data");
    std::fs::write(data.join("new"), "uCommand=MX,3\n").unwrap();
    std::fs::rename(data.join("new"), data.join("registry.in")).unwrap();
    page.until("the move", |page| (page.x() - 76.2).abs() < 1e-6);
    let told =
        |text: &'static str| move |page: &Page| page.shown["messages"].to_string().contains(text);
    page.until(
        "who passed it in",
        told("passed in by a program on this computer (uCommand): MX,3"),
    );
    assert_eq!(put("QQ,1"), (422, "mistake".into()));
    page.until_state("idle");
    std::fs::write(data.join("new"), "uCommand=QQ,1\n").unwrap();
    std::fs::rename(data.join("new"), data.join("registry.in")).unwrap();
    page.until("a refusal", told("QQ,1"));
}

#[test]
fn sbp_tool_system() {
    let shop = kept_shop();
    let data = shop.dir.path().join("data");
    let letters = || {
        let all = shop.get("/api/commands").json();
        let tool = |c: &&Value| c["group"] == "tools";
        all.as_array()
            .unwrap()
            .iter()
            .filter(tool)
            .map(|c| c["letters"].clone())
            .collect::<Vec<_>>()
    };
    assert!(letters().contains(&json!("TD")) && !letters().contains(&json!("TQ")));
    std::fs::create_dir_all(shop.part("data")).unwrap();
    let ini = "[Q]\nName = Nesting\nCommand = echo $KERF_URL > told.txt; echo\n";
    for folder in [data, shop.part("data")] {
        std::fs::write(folder.join("virtualtools.ini"), ini).unwrap();
    }
    assert!(letters().contains(&json!("TQ")), "the menu shows it");
    let mut page = shop.driver();
    page.command("TQ, 1");
    let told = std::fs::read_to_string(shop.part("told.txt")).unwrap();
    assert_eq!(told.trim(), format!("http://{}", shop.server.address), "it can reach the machine");
    page.command("TX");
    let error = page.shown["job"]["error"]["message"].as_str().unwrap();
    assert!(error.contains("no such tool"), "{error}");
}

#[test]
fn what_a_tool_makes_is_opened_and_previewed() {
    let shop = kept_shop();
    let mut page = shop.driver();
    page.command("TD,24,12,.5,2 3 1; 6 3 .25,.25,.5,2,no,surface,in,drilled.sbp");
    page.until("the preview", |page| {
        let opened = &page.shown["opened"];
        opened["name"] == "drilled.sbp" && opened["preview"]["state"] == "ready"
    });
    let key = page.shown["opened"]["preview"]["key"].as_str().unwrap().to_owned();
    let info = shop.get(&format!("/api/preview/{key}")).json();
    assert!((info["bounds"][0][2].as_f64().unwrap() + 12.7).abs() < 1e-3, "{info}");
}

#[test]
fn sbp_flow_exit_shopbot__in_the_server() {
    let shop = shop(100.0, &[("a.sbp", "VS,9\nSO,3,1\nMX,1\nEXIT SHOPBOT\nMX,9\n")]);
    let mut page = shop.driver();
    let before = page.shown["speeds"].clone();
    page.open_file("a.sbp");
    assert_eq!(page.run(), None);
    page.until("the end", |page| page.shown["job"]["ended"] == "ended");
    page.until_state("idle");
    assert!(page.shown["messages"].to_string().contains("closed by part file"));
    assert!((page.x() - 25.4).abs() < 1e-6, "earlier moves are made, later ones not");
    assert_eq!(page.shown["speeds"], before, "settings are given back");
    assert_eq!(page.shown["io"]["outputs"][2]["on"], false, "outputs are off");
    page.command("MX,2");
    assert!((page.x() - 50.8).abs() < 1e-6, "the server stays");
}

#[test]
fn variables_are_changed_and_added_by_their_lines() {
    let shop = shop(100.0, &[]);
    let mut page = shop.driver();
    page.command("&A = 2");
    page.command("&A = 3\n&B = \"four\"");
    let values = shop.get("/api/values").json();
    let variables = values["variables"].to_string();
    assert!(variables.contains(r#""value":"3""#) && variables.contains("four"), "{variables}");
}

#[test]
fn sbp_ctl_api__positions_ten_times_a_second() {
    let shop = shop(1.0, &[]);
    let mut page = shop.driver();
    // 2 in/s: two seconds and its ramps.
    let typed = json!({ "do": "command", "lease": page.lease, "line": "MX,4" });
    assert_eq!(page.act(typed), None);
    let places = std::cell::RefCell::new(Vec::new());
    page.until("the end of the move", |page| {
        let x = page.x();
        places.borrow_mut().push(x);
        (x - 101.6).abs() < 1e-6
    });
    let mut places = places.into_inner();
    places.dedup();
    assert!(places.is_sorted() && places.len() > 20, "{} places in 2 s", places.len());
}

#[test]
fn a_message_carries_its_place_and_its_code_apart_from_its_words() {
    let shop = shop(100.0, &[("a.sbp", "&a = 0\nMX,1/&a\nEND\n")]);
    let mut page = shop.driver();
    page.command("FP,a.sbp");
    let told = |page: &Page| page.shown["messages"].as_array().unwrap().last().cloned();
    page.until("the message", |page| told(page).is_some_and(|it| it["tone"] == "error"));
    let message = told(&page).unwrap();
    assert_eq!(message["place"], json!({ "file": "a.sbp", "line": 2 }));
    let text = message["text"].as_str().unwrap();
    assert!(!text.contains("line 2") && !text.is_empty(), "{text}");
    assert_eq!(message["code"], "R003", "pages tell it in their language by its code");
}
