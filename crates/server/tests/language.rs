//! Requests of editors and of fill-in sheets.

use crate::support::shop;
use serde_json::json;

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

/// Text that the fill-in sheet of a command shows for a parameter, after a line was typed.
#[track_caller]
fn shown_after(line: &str, parameter: usize) -> String {
    let shop = shop(100.0, &[]);
    shop.driver().command(line);
    let commands = shop.get("/api/commands").json();
    let commands = commands.as_array().unwrap();
    let sheet = commands.iter().find(|c| c["letters"] == line[..2]).unwrap();
    sheet["parameters"][parameter - 1]["present"].as_str().unwrap_or_default().to_owned()
}

#[test]
fn sbp_val_vr_3d__in_its_sheet() {
    assert_eq!(shown_after("VR,,,,,,,,,,,200", 11), "200");
}

#[test]
fn sbp_val_vr_mindist__in_its_sheet() {
    assert_eq!(shown_after("VR,,,,,,,,,,,,.05", 12), "0.05");
}

#[test]
fn sbp_val_vr_corner__in_its_sheet() {
    assert_eq!(shown_after("VR,,,,,,,,,,,,,90", 13), "90");
}

#[test]
fn sbp_val_vd_params__in_its_sheet() {
    let line = "VD,,4,1,2,2,,1,2.54,0,1,1,0,0,8800,4600,0,1,0";
    let shop = shop(100.0, &[]);
    shop.driver().command(line);
    let commands = shop.get("/api/commands").json();
    let vd = commands.as_array().unwrap().iter().find(|c| c["letters"] == "VD").unwrap().clone();
    let given: Vec<&str> = line.split(',').skip(1).collect();
    for (n, wanted) in given.into_iter().enumerate().filter(|(_, wanted)| !wanted.is_empty()) {
        let parameter = &vd["parameters"][n];
        assert_eq!(parameter["present"], wanted, "{parameter}");
        assert!(!parameter["name"].as_str().unwrap().is_empty());
    }
}
