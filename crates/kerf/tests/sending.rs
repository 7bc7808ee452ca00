//! `kerf send FILE PORT` and `kerf receive`: job files from one computer to another.
#![cfg(unix)]

use crate::shop::console::Console;
use crate::shop::{Did, Shop, until};
use kerf_transport::pretend::Cable;
use std::process::{Child, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// An office and a workshop, with a cable between them.
struct Bench {
    office: Shop,
    workshop: Shop,
    cable: Cable,
}

fn sample() -> Vec<u8> {
    (0..6000_u32).map(|i| (i.wrapping_mul(2_654_435_761) >> 13) as u8).collect()
}

impl Bench {
    /// With a cable as slow as its ports are set.
    fn new() -> Self {
        Self::with(Cable::new().unwrap())
    }

    /// With a cable that takes an eighth of the time, where how long it takes is not what is shown.
    fn hurried() -> Self {
        Self::with(Cable::hurried(8.0).unwrap())
    }

    fn with(cable: Cable) -> Self {
        let bench = Self { office: Shop::new(&[]), workshop: Shop::new(&[]), cable };
        bench.office.write("SAMPLE.RSM", &sample());
        std::fs::create_dir_all(bench.workshop.file("jobs")).unwrap();
        let [near, far] = bench.cable.ends();
        let devices = |own: &str| {
            format!("options.devices=[\"/dev/none\",\"{own}\",\"/dev/none\",\"/dev/none\"]")
        };
        for (shop, own) in [(&bench.office, near), (&bench.workshop, far)] {
            let mut command = shop.command();
            let (key, value) =
                devices(own).split_once('=').map(|(k, v)| (k.to_owned(), v.to_owned())).unwrap();
            let did = Did::of(command.args(["machine", "set", &key, &value]).output().unwrap());
            did.exits(0);
        }
        bench
    }

    fn sends(&self, words: &str) -> Child {
        start(&self.office, &format!("send SAMPLE.RSM {words}"))
    }

    fn receives(&self, words: &str) -> Child {
        let child = start(&self.workshop, &format!("receive --into jobs --once {words}"));
        // What is sent before it listens is sent again; that would only take longer.
        sleep(Duration::from_millis(300));
        child
    }

    /// Waits until part of the file is through.
    fn is_under_way(&self) {
        until("bytes on the cable", || self.cable.carried() > 1500);
    }

    fn arrived(&self) -> Option<Vec<u8>> {
        let files: Vec<_> = std::fs::read_dir(self.workshop.file("jobs")).unwrap().collect();
        assert!(files.len() <= 1, "nothing else lies in the folder: {files:?}");
        std::fs::read(self.workshop.file("jobs/SAMPLE.RSM")).ok()
    }
}

fn start(shop: &Shop, words: &str) -> Child {
    let mut command = shop.command();
    command.args(words.split_whitespace()).stdin(Stdio::null());
    command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap()
}

fn did(child: Child) -> Did {
    Did::of(child.wait_with_output().unwrap())
}

fn interrupt(child: &Child) {
    let id = nix::unistd::Pid::from_raw(child.id() as i32);
    nix::sys::signal::kill(id, nix::sys::signal::Signal::SIGINT).unwrap();
}

#[test]
fn pro_send_serial() {
    let bench = Bench::new();
    let receiver = bench.receives("");
    let begin = Instant::now();
    did(bench.sends("com2")).exits(0);
    did(receiver).exits(0);
    assert!(bench.arrived() == Some(sample()), "the file is another");
    // 19200 baud is what the settings begin with.
    let least_s = 6000.0 * 10.0 / 19_200.0;
    assert!(begin.elapsed().as_secs_f64() > least_s, "{:?}", begin.elapsed());
}

/// The largest rate that an end has told, bytes a second, and whether it told name and bytes.
#[track_caller]
fn rate(err: &str) -> f64 {
    let lines: Vec<&str> = err.lines().filter(|line| line.starts_with("SAMPLE.RSM ")).collect();
    assert!(lines.len() > 2, "{err}");
    assert!(lines.last().unwrap().contains("6000/6000 bytes") && err.contains(", done"), "{err}");
    let one = |line: &&str| line.split(", ").nth(1)?.strip_suffix(" bytes/s")?.parse::<f64>().ok();
    lines.iter().skip(1).filter_map(one).fold(0.0, f64::max)
}

#[test]
fn pro_send_monitor() {
    let bench = Bench::new();
    let receiver = bench.receives("--baud 19200");
    let sender = did(bench.sends("com2 --baud 19200"));
    for end in [sender, did(receiver)] {
        let most = rate(&end.err());
        assert!(most > 500.0 && most <= 1920.0, "{most} bytes/s");
    }
}

#[test]
fn pro_send_stop() {
    for at_sender in [true, false] {
        let bench = Bench::new();
        let (receiver, sender) = (bench.receives(""), bench.sends("com2"));
        bench.is_under_way();
        interrupt(if at_sender { &sender } else { &receiver });
        did(sender).exits(3).complains("stopped");
        did(receiver).exits(3).complains("stopped");
        assert!(bench.arrived().is_none());
    }
}

#[test]
fn pro_send_errors() {
    let bench = Bench::hurried();
    bench.cable.spoil_after(2500);
    let receiver = bench.receives("");
    did(bench.sends("com2")).exits(0);
    did(receiver).exits(0);
    assert!(bench.arrived() == Some(sample()), "the file is another");

    let bench = Bench::new();
    let (receiver, sender) = (bench.receives(""), bench.sends("com2"));
    bench.is_under_way();
    bench.cable.cut();
    let begin = Instant::now();
    did(sender).exits(1).complains("does not answer");
    did(receiver).exits(1).complains("nothing came any more");
    assert!(begin.elapsed() < Duration::from_secs(10), "{:?}", begin.elapsed());
    assert!(bench.arrived().is_none());
}

#[test]
fn pro_send_port() {
    let bench = Bench::hurried();
    let near = bench.cable.ends()[0].to_owned();
    bench.office.kerf("machine get options.devices").exits(0).says(&near);
    bench.office.kerf("machine set options.send_port 2").exits(0);
    bench.office.kerf("machine set options.send_port 5").exits(2);
    // The port of the settings is the one that is used when none is named.
    let receiver = bench.receives("com2");
    did(bench.sends("com")).exits(0);
    did(receiver).exits(0);
    assert!(bench.arrived() == Some(sample()), "the file is another");
    bench.office.kerf("send SAMPLE.RSM com5").exits(2).complains("the ports 1 to 4");
    bench.office.kerf("send SAMPLE.RSM com1").exits(1).complains("no serial port /dev/none");
}

#[test]
fn pro_send_speed() {
    let bench = Bench::hurried();
    let small: Vec<u8> = sample()[..512].to_vec();
    bench.office.write("SAMPLE.RSM", &small);
    for baud in [2400, 4800, 9600, 19_200, 38_400] {
        for shop in [&bench.office, &bench.workshop] {
            shop.kerf(&format!("machine set options.send_baud {baud}")).exits(0);
        }
        let receiver = bench.receives("");
        did(bench.sends("com2")).exits(0);
        did(receiver).exits(0);
        assert!(bench.arrived() == Some(small.clone()), "{baud}");
        std::fs::remove_file(bench.workshop.file("jobs/SAMPLE.RSM")).unwrap();
    }
    bench.office.kerf("machine set options.send_baud 12345").exits(2).complains("2400");
    bench.office.kerf("send SAMPLE.RSM com2 --baud 12345").exits(2);
    // Ends that are set differently understand nothing.
    let receiver = bench.receives("--baud 2400");
    did(bench.sends("com2")).exits(1);
    interrupt(&receiver);
    did(receiver).exits(3);
    assert!(bench.arrived().is_none());
}

const LONG: &str = "MS,1,1\nMX,6\n";

#[test]
fn pro_send_notmoving() {
    let bench = Bench::new();
    bench.workshop.write("long.sbp", LONG.as_bytes());
    let (receiver, sender) = (bench.receives(""), bench.sends("com2"));
    bench.is_under_way();
    let begin = Instant::now();
    did(start(&bench.workshop, "run long.sbp --pace real")).exits(0);
    let moved = begin.elapsed();
    assert!(bench.arrived().is_none(), "nothing is complete while the machine moves");
    did(sender).exits(0).complains("held: the machine moves");
    did(receiver).exits(0).complains("held: the machine moves");
    assert!(begin.elapsed() > moved);
    assert!(bench.arrived() == Some(sample()), "the file is another");
}

#[test]
fn pro_send_editonly() {
    let bench = Bench::hurried();
    let receiver = bench.receives("");
    did(start(&bench.office, "--edit-only send SAMPLE.RSM com2")).exits(0);
    did(receiver).exits(0);
    assert!(bench.arrived() == Some(sample()), "the file is another");
    let drawing =
        concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/10-from-a-drawing/from-a-drawing.rsg");
    bench.office.kerf(&format!("--edit-only path {drawing} -o job.rsm")).exits(0);
    assert!(bench.office.file("job.rsm").exists());
    bench.office.write("p.sbp", b"MX,1\n");
    for moves in ["run p.sbp", "send MX,1", "machine home"] {
        let refused = bench.office.kerf(&format!("--edit-only {moves}"));
        refused.exits(2).complains("not available in editing version");
    }
}

#[test]
fn pro_send_http() {
    let (office, workshop) = (Shop::new(&[]), Shop::new(&[("long.sbp", "MS,.5,.5\nMX,60\n")]));
    office.write("SAMPLE 1.RSM", &sample());
    let console = Console::begin(&workshop, &[]);
    let send = || {
        let mut command = office.command();
        command.args(["send", "SAMPLE 1.RSM", &console.url]).stdin(Stdio::null());
        command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap()
    };
    did(send()).exits(0).complains("6000/6000 bytes").complains("done");
    let there = workshop.file("SAMPLE 1.RSM");
    assert!(std::fs::read(&there).unwrap() == sample(), "the file is another");
    // While the machine moves nothing is taken; afterwards it is.
    std::fs::remove_file(&there).unwrap();
    console.carry_out("MX,60");
    while console.ask("GET /api/state", "")["machine"]["state"] != "running" {
        sleep(Duration::from_millis(10));
    }
    let child = send();
    let mut moved = false;
    while console.ask("GET /api/state", "")["machine"]["state"] == "running" {
        moved |= !there.exists();
        sleep(Duration::from_millis(10));
    }
    assert!(moved, "nothing is there while the machine moves");
    did(child).exits(0).complains("held: the machine moves");
    assert!(std::fs::read(&there).unwrap() == sample(), "the file is another");
    // Stopped while it is held, nothing is left.
    std::fs::remove_file(&there).unwrap();
    console.carry_out("MX,0");
    while console.ask("GET /api/state", "")["machine"]["state"] != "running" {
        sleep(Duration::from_millis(10));
    }
    let child = send();
    sleep(Duration::from_millis(200));
    interrupt(&child);
    did(child).exits(3);
    assert!(!there.exists());
    office.kerf("send SAMPLE.RSM http://127.0.0.1:1").exits(2);
    office.write("b.rsm", b"x");
    office.kerf("send b.rsm http://127.0.0.1:1").exits(1).complains("no server is reached");
}

#[test]
fn pro_send_serial__into_a_server_that_moves() {
    let bench = Bench::new();
    let console = Console::begin(&bench.workshop, &["--receive", "--parts", "jobs"]);
    let sender = bench.sends("com2");
    bench.is_under_way();
    console.carry_out("MX,200");
    did(sender).exits(0).complains("held: the machine moves");
    assert!(bench.arrived() == Some(sample()), "the file is another");
}
