//! Height control as a user sees it: its error over a warped sheet, and the bytes of its readings.

#![allow(clippy::unwrap_used, clippy::expect_used, non_snake_case)] // rows and their variants

mod shop;

use shop::Shop;

/// What `make figures` draws: the folder of the book's figures.
const FIGURES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/figures");

/// The run of a figure, with the options that stand beside it.
fn figure(shop: &Shop, command: &str, drawing: &str, name: &str, more: &str) -> shop::Did {
    let options = std::fs::read_to_string(format!("{FIGURES}/{name}.txt")).unwrap();
    let options = options.replace('\n', " ");
    shop.kerf(&format!(
        "{command} {FIGURES}/{drawing}.rsg --config {FIGURES}/{name}.toml {options} {more}"
    ))
}

/// The worst error and the readings beyond the accuracy, of the line that is told.
fn measured(told: &str) -> (f64, u32) {
    let word = |before: &str| {
        let rest = told.split(before).nth(1).unwrap_or_else(|| panic!("{before} in {told}"));
        rest.split(' ').next().unwrap().to_owned()
    };
    (word("worst error ").parse().unwrap(), word("mm, ").parse::<u32>().unwrap_or_default())
}

#[test]
fn pro_height_prop_accuracy__of_the_figure() {
    let shop = Shop::new(&[]);
    let did =
        figure(&shop, "heights", "wave", "height-error", "--title Height-control -o error.svg");
    did.exits(0);
    let (worst, _) = measured(&did.out());
    assert!(worst <= 0.1 && did.out().contains(", 0 of "), "{}", did.out());
    let drawn = shop.read("error.svg");
    assert!(drawn.contains(&did.out().trim().to_owned()) && drawn.contains("6 m/min"));
    // The picture in the book is this one.
    assert_eq!(drawn, std::fs::read_to_string(format!("{FIGURES}/height-error.svg")).unwrap());
}

#[test]
fn pro_height_prop_display__in_the_picture() {
    let shop = Shop::new(&[]);
    let red = "#b3261e";
    figure(&shop, "heights", "wave", "height-error", "-o good.svg").exits(0);
    assert!(!shop.read("good.svg").contains(red), "within the accuracy from the first reading on");
    let toml = std::fs::read_to_string(format!("{FIGURES}/height-error.toml")).unwrap();
    shop.write("weak.toml", toml.replace("k = 9.5", "k = 1").as_bytes());
    let did = shop.kerf(&format!(
        "heights {FIGURES}/wave.rsg --config weak.toml --sheet=-20,0.01,0,1.5,300 -o weak.svg"
    ));
    did.exits(0);
    assert!(measured(&did.out()).0 > 0.1 && shop.read("weak.svg").contains(red), "{}", did.out());
}

#[test]
fn heights_need_a_sheet_and_readings() {
    let shop = Shop::new(&[]);
    let drawing = format!("{FIGURES}/wave.rsg");
    let none = format!("heights {drawing} --config {FIGURES}/height-error.toml");
    shop.kerf(&none).exits(2).complains("there is no sheet: --sheet=");
    shop.kerf(&format!("heights {drawing} --config sim --sheet=-20"))
        .exits(1)
        .complains("no reading came");
}

/// A pseudo terminal that passes bytes as they are.
#[cfg(unix)]
fn serial_line() -> (std::fs::File, std::path::PathBuf, std::os::fd::OwnedFd) {
    use nix::sys::termios::{SetArg, cfmakeraw, tcgetattr, tcsetattr};
    let pair = nix::pty::openpty(None, None).unwrap();
    let mut attributes = tcgetattr(&pair.slave).unwrap();
    cfmakeraw(&mut attributes);
    tcsetattr(&pair.slave, SetArg::TCSANOW, &attributes).unwrap();
    let name = nix::unistd::ttyname(&pair.slave).unwrap();
    (std::fs::File::from(pair.master), name, pair.slave)
}

#[cfg(unix)]
#[test]
fn pro_height_prop_input__on_a_serial_line() {
    use std::io::Read;
    let shop = Shop::new(&[]);
    let (mut line, device, slave) = serial_line();
    let listener = std::thread::spawn(move || {
        let mut bytes = Vec::new();
        // The end of a pseudo terminal reads as an error.
        let _ = line.read_to_end(&mut bytes);
        bytes
    });
    let more = format!("--readings {} --trace out.jsonl --quiet --start fresh", device.display());
    figure(&shop, "run", "wave", "height-error", &more).exits(0);
    drop(slave);
    let bytes = listener.join().unwrap();
    let trace = shop.read("out.jsonl");
    let events = trace.lines().map(|line| serde_json::from_str::<serde_json::Value>(line).unwrap());
    let readings = events.filter(|event| event["e"] == "height");
    let told: Vec<u8> = readings.map(|it| it["reading"].as_u64().unwrap() as u8).collect();
    assert!(told.len() > 1000, "{} readings", told.len());
    assert_eq!(bytes, told);
}
