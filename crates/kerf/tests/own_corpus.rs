//! The project's own part files and drawings, `tests/corpus`, through the commands that a shop uses.
//!
//! What each command makes of each file stands in `tests/corpus/summary.txt`, made to be read. When it changes for a
//! reason, `KERF_BLESS=1 cargo test -p kerf --test all own_corpus::` writes it anew; read the difference before keeping it.

use crate::find;
use crate::shop::{Did, Shop};
use serde_json::Value;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;

#[test]
fn programs_and_drawings_come_out_as_their_summary_says() {
    let corpus = find::own("");
    let shop = copied(&corpus);
    let mut told = String::new();
    for kind in ["sbp", "gcode"] {
        each(kind, |name| _ = writeln!(told, "{name}\n{}", program(&shop, name)));
    }
    for kind in ["dxf", "svg"] {
        each(kind, |name| _ = writeln!(told, "{name}\n{}", drawing(&shop, name)));
    }
    let golden = corpus.join("summary.txt");
    if std::env::var_os("KERF_BLESS").is_some() {
        fs::write(&golden, &told).unwrap();
    }
    let expected = fs::read_to_string(&golden).unwrap_or_default();
    let pairs = told.lines().zip(expected.lines()).enumerate();
    for (number, (did, expected)) in pairs {
        assert_eq!(did, expected, "{} line {}", golden.display(), number + 1);
    }
    assert_eq!(told.lines().count(), expected.lines().count(), "{}", golden.display());
}

/// A shop with all of the corpus in it: commands write beside what they read.
fn copied(corpus: &Path) -> Shop {
    let shop = Shop::new(&[]);
    for folder in ["", "sbp", "gcode", "dxf", "svg"] {
        for entry in fs::read_dir(corpus.join(folder)).unwrap().map(|e| e.unwrap().path()) {
            if entry.is_file() {
                let name = Path::new(folder).join(entry.file_name().unwrap());
                shop.write(name.to_str().unwrap(), &fs::read(&entry).unwrap());
            }
        }
    }
    shop
}

/// Calls `look` with the name of each file of a kind; there are some.
fn each(kind: &str, mut look: impl FnMut(&str)) {
    let files = find::files(&find::own(kind));
    assert!(files.len() >= 3, "{files:?}");
    for file in files {
        look(&format!("{kind}/{}", file.file_name().unwrap().to_str().unwrap()));
    }
}

/// The options of a file: the rest of its line in `options.txt`.
fn options(shop: &Shop, name: &str) -> String {
    let list = shop.read("options.txt");
    let line = list.lines().find_map(|line| line.strip_prefix(name));
    line.unwrap_or_default().to_owned()
}

/// The outcome of every command on a part file.
fn program(shop: &Shop, name: &str) -> String {
    let options = options(shop, name);
    let ran = shop.kerf(&format!("run {name} {options} --start fresh --trace -"));
    let traced = shop.kerf(&format!("trace {name} {options}"));
    assert_eq!(ran.end(), traced.end(), "{name}: a run ends as its preview");
    let mut told = format!("  check    {}\n", checked(shop, name, &options));
    let _ = writeln!(told, "  run      {}\n           {}", outcome(&ran), extent(&ran));
    let _ = writeln!(told, "  preview  {}", picture(shop, name, &options));
    let _ = writeln!(told, "  fmt      {}", formatted(shop, name, &options, &ran));
    let _ = writeln!(told, "  convert  {}", there_and_back(shop, name, &options));
    for line in ran.events().iter().filter_map(said) {
        let _ = writeln!(told, "  says     {line}");
    }
    told
}

/// The heads of what `kerf check` found.
fn checked(shop: &Shop, name: &str, options: &str) -> String {
    let did = shop.kerf(&format!("check {name} {options}"));
    let all = format!("{}{}", did.exits(0).out(), did.err());
    let heads =
        all.lines().filter(|line| line.starts_with("note[") || line.starts_with("warning["));
    let heads: Vec<&str> = heads.collect();
    if heads.is_empty() { "nothing wrong".into() } else { heads.join("; ") }
}

fn outcome(did: &Did) -> String {
    let end = did.exits(0).end();
    let outputs = did.all("output").iter().filter(|e| e["why"] == "program").count();
    let counts =
        format!("{} moves, {} arcs, outputs switched {outputs} times", end["moves"], end["arcs"]);
    format!("{}, {counts}, cut {}", end["status"].as_str().unwrap(), number(&end["cut"]))
}

fn extent(did: &Did) -> String {
    let end = did.end();
    let range = |axis: &str| {
        let corner = |which: &str| number(&end["bounds"][which][axis]);
        format!("{} {} to {}", axis.to_uppercase(), corner("min"), corner("max"))
    };
    ["x", "y", "z"].map(range).join(", ")
}

/// The words under the picture, without the time.
fn picture(shop: &Shop, name: &str, options: &str) -> String {
    shop.kerf(&format!("preview {name} {options} --force -o picture.svg")).exits(0);
    let svg = shop.read("picture.svg");
    let words = svg.split_once("<desc>").and_then(|(_, rest)| rest.split_once(" · "));
    let cuts = svg.split_once("<g id=\"cuts\"").and_then(|(_, rest)| rest.split_once("<g id="));
    let drawn = cuts.is_some_and(|(cuts, _)| cuts.contains(" d=\"M"));
    format!("{}, {}", words.unwrap().0, if drawn { "cuts drawn" } else { "no cuts" })
}

/// The number of lines that the formatter changes. Its text runs as before, and a second run changes nothing.
fn formatted(shop: &Shop, name: &str, options: &str, before: &Did) -> String {
    let text = shop.read(name);
    shop.kerf(&format!("fmt {name}")).exits(0);
    let after = shop.kerf(&format!("run {name} {options} --start fresh --trace -"));
    assert_eq!(after.end(), before.end(), "{name}: formatted it does the same");
    shop.kerf(&format!("fmt --check {name}")).exits(0);
    let new = shop.read(name);
    let changed = text.lines().zip(new.lines()).filter(|(a, b)| a != b).count();
    assert_eq!(text.lines().count(), new.lines().count(), "{name}");
    shop.write(name, text.as_bytes());
    format!("{changed} of {} lines written otherwise, runs the same", text.lines().count())
}

/// The options of a conversion, which takes every input as off.
fn without_inputs(options: &str) -> String {
    let words: Vec<&str> = options.split_whitespace().collect();
    let is_input = |at: usize| words[at] == "--input" || at > 0 && words[at - 1] == "--input";
    (0..words.len()).filter(|at| !is_input(*at)).map(|at| words[at]).collect::<Vec<_>>().join(" ")
}

/// The other language and back: what is cut then, to be compared with the run.
fn there_and_back(shop: &Shop, name: &str, options: &str) -> String {
    let (there, back) = if name.starts_with("sbp/") {
        ("there.ngc", "back.sbp")
    } else {
        ("there.sbp", "back.ngc")
    };
    shop.kerf(&format!("convert {name} {there} --force {}", without_inputs(options))).exits(0);
    let machine = machine(options);
    shop.kerf(&format!("convert {there} {back} --force {machine}")).exits(0);
    let did = shop.kerf(&format!("trace {back} {machine}"));
    format!("to {there} and back: {}\n           {}", outcome(&did), extent(&did))
}

/// The options that describe the machine; inputs and answers are used up after the way there.
fn machine(options: &str) -> String {
    let parts = options.split(" --").filter(|part| !part.is_empty());
    let kept = parts.filter(|part| part.starts_with("units ") || part.starts_with("config "));
    kept.map(|part| format!("--{part} ")).collect()
}

/// The messages that a person at the machine reads.
fn said(event: &Value) -> Option<String> {
    let text = event["text"].as_str().unwrap_or_default();
    match event["e"].as_str()? {
        "print" => Some(text.to_owned()),
        "ask" => Some(format!("{text} -> {}", event["answer"].as_str()?)),
        _ => None,
    }
}

/// The outcome of every command on a drawing: its shapes, what was found, that it is the same through the other formats, and
/// what is cut when it becomes a program.
fn drawing(shop: &Shop, name: &str) -> String {
    let listed = shop.kerf(&format!("draw {name} --list"));
    let shapes = listed.exits(0).events();
    let mut told = format!("  draw     {}\n", counted(&shapes));
    for line in listed.err().lines() {
        let _ = writeln!(told, "  finds    {line}");
    }
    for ending in ["rsg", "dxf", "svg"] {
        let copy = format!("copy.{ending}");
        shop.kerf(&format!("draw {name} --force -o {copy}")).exits(0);
        let again = counted(&shop.kerf(&format!("draw {copy} --list")).exits(0).events());
        let same = if again == counted(&shapes) { "the same" } else { &again };
        let _ = writeln!(told, "  as {ending}   {same}");
    }
    shop.kerf(&format!("convert {name} cut.sbp --force --units mm")).exits(0);
    let cut = shop.kerf("trace cut.sbp --units mm");
    let _ = writeln!(told, "  cuts     {}\n           {}", outcome(&cut), extent(&cut));
    told
}

/// Number, length and size of shapes, mm.
fn counted(shapes: &[Value]) -> String {
    let closed = shapes.iter().filter(|s| s["closed"] == true).count();
    let length: f64 = shapes.iter().map(|s| s["length"].as_f64().unwrap()).sum();
    let bound = |which: &str, axis: &str, of: fn(f64, f64) -> f64| {
        let all = shapes.iter().map(|s| s["bounds"][which][axis].as_f64().unwrap());
        all.reduce(of).unwrap_or_default()
    };
    let side = |axis: &str| bound("max", axis, f64::max) - bound("min", axis, f64::min);
    let (x, y) = (rounded(side("x"), 10.0), rounded(side("y"), 10.0));
    let open = shapes.len() - closed;
    format!("{closed} closed, {open} open, {} mm long, {x} by {y} mm", rounded(length, 10.0))
}

/// To a thousandth, without trailing zeros.
fn number(value: &Value) -> String {
    rounded(value.as_f64().expect("a number"), 1e3)
}

fn rounded(value: f64, parts: f64) -> String {
    ((value * parts).round() / parts + 0.0).to_string()
}
