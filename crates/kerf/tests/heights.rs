//! Height control as a user sees it: its error over a warped sheet, and the bytes of its readings.

use crate::shop;
use crate::shop::Shop;

/// Folder of the book's figures, which `make figures` draws.
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

#[test]
fn a_run_without_a_sheet_cuts_nothing_and_says_so() {
    let shop = Shop::new(&[]);
    let job = format!("{FIGURES}/wave.rsg --config {FIGURES}/height-error.toml --start fresh");
    let run = shop.kerf(&format!("run {job} --trace out.jsonl"));
    run.exits(3).complains("no sheet lies on the simulated table");
    let trace = shop.read("out.jsonl");
    assert!(
        trace.contains("no height readings") && !trace.contains("\"name\":\"cut1\""),
        "{trace}"
    );
    // A plan takes the sheet to lie where the tool cuts at ZSurface.
    shop.kerf(&format!("time {FIGURES}/wave.rsg --config {FIGURES}/height-error.toml"))
        .exits(0)
        .complains("no sheet lies on the simulated table");
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

/// The data of a timing diagram of the book, from the run that draws it.
fn timing(name: &str) -> serde_json::Value {
    let shop = Shop::new(&[]);
    figure(&shop, "timing", "line", name, "-o data.json").exits(0);
    figure(&shop, "timing", "line", name, "-o drawn.svg").exits(0);
    let in_book = std::fs::read_to_string(format!("{FIGURES}/{name}.svg")).unwrap();
    assert_eq!(shop.read("drawn.svg"), in_book, "{name}.svg is not of this run: make figures");
    serde_json::from_str(&shop.read("data.json")).unwrap()
}

/// Edges as the rows tell them, to a millisecond: `router 0.300 7.190`, on and off in turn.
#[track_caller]
fn edges(data: &serde_json::Value, expected: &[&str]) {
    for row in expected {
        let (name, times) = row.split_once(' ').unwrap();
        let told = data["tracks"][name]["edges"].as_array().unwrap_or_else(|| panic!("no {name}"));
        let times: Vec<f64> = times.split(' ').map(|t| t.parse().unwrap()).collect();
        assert_eq!(told.len(), times.len(), "{name}: {told:?}");
        for (i, (edge, time)) in told.iter().zip(&times).enumerate() {
            let (t_s, on) = (edge[0].as_f64().unwrap(), edge[1].as_bool().unwrap());
            assert!((t_s - time).abs() <= 0.001 && on == (i % 2 == 0), "{name}: {told:?}");
        }
    }
}

/// Checks when a value leaves one place and comes to the next: `x 4.840 5.940` are moments of the rows.
#[track_caller]
fn moves(data: &serde_json::Value, axis: &str, expected: &[[f64; 3]]) {
    let points = data["tracks"][axis]["points"].as_array().unwrap();
    let place = |t_s: f64| {
        let near = points.iter().min_by(|a, b| {
            let away = |p: &serde_json::Value| (p[0].as_f64().unwrap() - t_s).abs();
            away(a).total_cmp(&away(b))
        });
        let near = near.unwrap();
        (near[0].as_f64().unwrap(), near[1].as_f64().unwrap())
    };
    for [begin_s, end_s, to] in expected {
        for (t_s, arrived) in [(begin_s, false), (end_s, true)] {
            let (at_s, value) = place(*t_s);
            assert!((at_s - t_s).abs() <= 0.001, "{axis} at {t_s}: {at_s}");
            assert!(((value - to).abs() < 1e-6) == arrived, "{axis} at {t_s}: {value}");
        }
    }
}

#[test]
fn the_router_of_the_book_keeps_the_times_of_the_rows() {
    let data = timing("timing-router");
    let rows =
        ["job_running 0.000 7.890", "router 0.300 7.190", "tool1 2.300 6.690", "cut1 3.840 5.940"];
    edges(&data, &rows);
    moves(&data, "z, mm", &[[0.0, 0.3, -10.0], [2.8, 3.84, -30.0], [6.19, 6.69, -10.0]]);
    moves(&data, "x, mm", &[[4.84, 5.94, 100.0], [7.19, 7.89, 0.0]]);
}

#[test]
fn the_laser_with_input_of_the_book_keeps_the_times_of_the_rows() {
    let data = timing("timing-input");
    let rows = [
        "router 0.300 7.190",
        "tool1 2.300 6.690",
        "cut1 3.840 5.940",
        "end_bottom_delay 4.640 4.840",
    ];
    edges(&data, &rows);
    moves(&data, "x, mm", &[[4.84, 5.94, 100.0], [7.19, 7.89, 0.0]]);
}

#[test]
fn the_piercing_laser_of_the_book_keeps_the_times_of_the_rows() {
    let data = timing("timing-pierce");
    let rows = [
        "job_running 0.000 6.380",
        "router 0.300 5.680",
        "tool2 2.590 3.680",
        "tool1 3.680 5.680",
        "cut1 2.890 3.390 4.030 5.130",
    ];
    edges(&data, &rows);
    moves(&data, "z, mm", &[[2.3, 2.59, -15.0], [3.39, 3.68, -20.0], [5.38, 5.68, -10.0]]);
    let hz = data["tracks"]["pulses, Hz"]["points"].as_array().unwrap();
    let rises: Vec<(f64, f64)> = hz
        .windows(2)
        .filter(|pair| pair[0][1] != pair[1][1])
        .map(|pair| (pair[1][0].as_f64().unwrap(), pair[1][1].as_f64().unwrap()))
        .collect();
    assert_eq!(rises.iter().map(|(_, hz)| *hz).collect::<Vec<_>>(), [500.0, 5000.0]);
    assert!((rises[0].0 - 2.89).abs() <= 0.001 && (rises[1].0 - 4.03).abs() <= 0.001, "{rises:?}");
}

#[test]
fn the_plasma_of_the_book_keeps_the_times_of_the_rows() {
    let data = timing("timing-plasma");
    let rows =
        ["job_running 0.000 4.390", "router 0.300 3.690", "tool1 0.300 3.690", "cut1 1.120 3.220"];
    edges(&data, &rows);
    moves(&data, "z, mm", &[[0.3, 0.86, -20.4], [0.86, 1.12, -16.0], [3.47, 3.69, -10.0]]);
    moves(&data, "x, mm", &[[2.12, 3.22, 100.0], [3.69, 4.39, 0.0]]);
    let close = data["tracks"]["whome"]["edges"][0][0].as_f64().unwrap();
    assert!((close - 0.82).abs() <= 0.001, "{close}");
}
