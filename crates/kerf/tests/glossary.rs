//! Words of the field, explained in the program.

use crate::shop::Shop;

/// Answer of `kerf help` to some words.
fn help(words: &str) -> String {
    let shop = Shop::new(&[]);
    let did = shop.kerf(&format!("help {words}"));
    did.exits(0);
    did.out()
}

fn says(words: &str, parts: &[&str]) {
    let text = help(words);
    parts.iter().for_each(|part| assert!(text.contains(part), "{words}: {text}"));
}

#[test]
fn pro_glossary_help() {
    let manual = [
        "basic block",
        "bulge",
        "CNC",
        "DXF",
        "RSG",
        "RSM",
        "polyline",
        "polyarc",
        "simple polygon",
        "hand console",
        "card",
    ];
    let terms = help("terms");
    for term in manual {
        let row = terms.lines().find(|line| line.starts_with(term)).unwrap_or_default();
        assert!(row.len() > 30, "{term}: {row}");
        assert!(help(&format!("term {term}")).starts_with(&format!("{term}: ")));
    }
}

#[test]
fn pro_glossary_cnc() {
    says("term cnc", &["G-code", "G0, G1, G2, G3, G17, G18, G19, G70, G71"]);
}

#[test]
fn pro_glossary_dxf() {
    says("term dxf", &["exchange", "Release 12"]);
    let line = "  0\nSECTION\n  2\nHEADER\n  9\n$ACADVER\n  1\nAC1009\n  0\nENDSEC\n  0\nSECTION\n  2\n\
                ENTITIES\n  0\nLINE\n 10\n0\n 20\n0\n 11\n10\n 21\n5\n  0\nENDSEC\n  0\nEOF\n";
    let shop = Shop::new(&[("a.dxf", line)]);
    shop.kerf("draw a.dxf --list").exits(0).says("\"points\":[[0.0,0.0,0.0],[10.0,5.0,0.0]]");
}

#[test]
fn pro_glossary_rsg() {
    says("term rsg", &["drawing", "groups", "arrays"]);
    let shop = Shop::new(&[]);
    let script = "line 0,0 5,5; select all; group red; set red offset=3; array block 2x3 gap 1,2";
    let made = shop.command().args(["draw", "--do", script, "-o", "a.rsg"]).output().unwrap();
    assert!(made.status.success());
    shop.kerf("draw a.rsg --list").exits(0).says("\"group\":\"red\"");
    shop.kerf("toolpath a.rsg -o a.rsm").exits(0);
    assert_eq!(shop.kerf("draw a.rsm --list").out().lines().count(), 6);
}

#[test]
fn pro_glossary_rsm() {
    says("term rsm", &["tool path", "same name"]);
}

#[test]
fn pro_glossary_block() {
    says("term basic block", &["before the arrays"]);
}

#[test]
fn pro_glossary_console() {
    says("term console", &["2 × 20", "16 keys"]);
}

#[test]
fn pro_glossary_card() {
    says("term card", &["inputs and outputs", "kerf io map"]);
    // What it names is there.
    let map = Shop::new(&[]).kerf("io map --card pci").exits(0).out();
    assert!(map.lines().count() > 20 && map.contains("output"), "{map}");
}

#[test]
fn commands_and_words_are_told_apart() {
    says("run", &["Usage:", "--units"]);
    says("", &["Usage: kerf"]);
    says("bulge", &["tangent of a quarter"]);
    Shop::new(&[]).kerf("help flywheel").exits(2).complains("`kerf help terms` lists all terms");
}

/// The first shape of a DXF with one polyline of these places, not marked as closed.
fn polyline(places: &[(f64, f64, f64)]) -> serde_json::Value {
    let vertex = |(x, y, bulge): &(f64, f64, f64)| format!(" 10\n{x}\n 20\n{y}\n 42\n{bulge}\n");
    let vertices: String = places.iter().map(vertex).collect();
    let file = format!(
        "  0\nSECTION\n  2\nENTITIES\n  0\nLWPOLYLINE\n 90\n{}\n 70\n0\n{vertices}  0\nENDSEC\n  0\nEOF\n",
        places.len()
    );
    let list = Shop::new(&[("a.dxf", file.as_str())]).kerf("draw a.dxf --list");
    list.exits(0);
    serde_json::from_str(list.out().lines().next().unwrap()).unwrap()
}

#[test]
fn pro_glossary_polyline() {
    let square = [(0., 0., 0.), (9., 0., 0.), (9., 9., 0.), (0., 9., 0.), (0., 0., 0.)];
    let shape = polyline(&square);
    assert_eq!((&shape["closed"], shape["points"].as_array().unwrap().len()), (&true.into(), 4));
    assert_eq!(polyline(&square[..4])["closed"], false);
}

#[test]
fn pro_glossary_polyarc() {
    let circle = [(25.0, 0.0, 1.0), (-25.0, 0.0, 1.0), (25.0, 0.0, 0.0)];
    let shape = polyline(&circle);
    assert_eq!((&shape["closed"], shape["points"].as_array().unwrap().len()), (&true.into(), 2));
    assert!((shape["length"].as_f64().unwrap() - 157.08).abs() < 0.01);
}
