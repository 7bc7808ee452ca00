//! The hand console at a serial port: a cable without hardware, as slow as a real one.

#![cfg(unix)]

use crate::support;
use crate::support::hand::{Hand, sample, shop};
use crate::support::{Page, Shop, Wanted, at, start};
use kerf_transport::Port;
use kerf_transport::pretend::{Cable, Plug};
use serde_json::json;
use std::sync::OnceLock;
use std::time::{Duration, Instant};

/// The console itself: its keyboard and its display.
struct Device {
    port: Port,
    /// The display as it is drawn, its two lines one after the other.
    drawn: String,
    beeps: u32,
    /// Bytes since the display was emptied last.
    count: usize,
}

impl Device {
    fn at(path: &str) -> Self {
        let port = Port::open(path, 2400).unwrap();
        Self { port, drawn: String::new(), beeps: 0, count: 0 }
    }

    fn presses(&mut self, keys: &str) {
        let bytes: Vec<u8> =
            keys.bytes().map(|key| if key == b'E' { b'\r' } else { key }).collect();
        self.port.write(&bytes).unwrap();
    }

    fn look(&mut self) {
        let mut bytes = [0; 16];
        let count = self.port.read(&mut bytes, Duration::from_millis(5)).unwrap();
        for byte in &bytes[..count] {
            match byte {
                0x0c => (self.drawn, self.count) = (String::new(), 0),
                0x07 => self.beeps += 1,
                character => self.drawn.push(char::from(*character)),
            }
            self.count += 1;
        }
    }

    fn beeps_once(&mut self) {
        while self.beeps == 0 {
            self.look();
        }
        assert_eq!(self.beeps, 1);
    }

    #[track_caller]
    fn shows(&mut self, top: &str, bottom: &str) {
        let (begin, wanted) = (Instant::now(), format!("{top:20}{bottom:20}"));
        while self.drawn != wanted {
            let drawn = &self.drawn;
            assert!(begin.elapsed() < Duration::from_secs(20), "{drawn:?} is not {wanted:?}");
            self.look();
        }
    }
}

/// A server with the hand console at a port; nobody drives.
fn at_port(shop: &Shop, path: &str) -> Page {
    let mut page = shop.driver();
    let devices = format!("{path},/dev/none1,/dev/none2,/dev/none3");
    page.set("options.devices", &devices);
    page.set("options.console", "true");
    let there = format!("at {path}");
    page.until("the link", |page| page.shown["handConsole"]["link"] == there.as_str());
    let lease = page.lease;
    assert_eq!(page.act(json!({ "do": "giveLease", "lease": lease })), None);
    page
}

#[test]
fn pro_console_serial() {
    let (shop, cable) = (shop(|_| {}), Cable::new().unwrap());
    shop.write("SAMPLE.RSM", sample().as_bytes());
    let [near, far] = cable.ends();
    let mut device = Device::at(far);
    let mut page = at_port(&shop, near);
    device.shows("JOB: Untitled", "0x0mm #0");
    // A cable spoils what is sent at another rate than it is listened to.
    assert_eq!(device.port.baud().unwrap(), 2400);
    device.presses("U18F1");
    device.shows("Enter function:", "18.1 X set point");
    let lines = json!(["Enter function:", "18.1 X set point"]);
    page.until("the same", |page| page.shown["handConsole"]["lines"] == lines);
    assert_eq!(device.count, 41);
    assert!(device.count as f64 * 10.0 / 2400.0 <= 0.18, "of a whole redraw");
    device.presses("UF");
    device.shows("Select File (1):", "SAMPLE.RSM");
    device.presses("E");
    device.shows("JOB: SAMPLE.RSM", "720x360mm #16");
    page.open_file("SAMPLE.RSM");
    // Whoever nobody let drive does nothing, and is told so.
    device.presses("S");
    device.shows("Nobody drives", "Enter takes control");
    device.beeps_once();
    device.presses("E");
    device.shows("JOB: SAMPLE.RSM", "720x360mm #16");
    page.until("the driver", |page| page.shown["lease"]["device"] == "hand console");
    device.presses("S");
    page.until("a cut", |page| page.shown["motion"]["cutting"] == true);
    device.presses("P");
    page.until_state("stopped");
    // A busy computer may hear the key behind the first shape.
    let shape = page.shown["asked"]["line"].as_u64().unwrap();
    assert!((1..=16).contains(&shape), "{shape}");
    device.shows("Paused", &format!("Shape {shape} of 16"));
}

#[test]
fn a_key_that_is_held_moves_the_tool_until_no_more_bytes_come() {
    let (shop, cable) = (shop(|_| {}), Cable::new().unwrap());
    let [near, far] = cable.ends();
    let mut device = Device::at(far);
    let mut page = at_port(&shop, near);
    device.presses("8");
    device.shows("Nobody drives", "Enter takes control");
    device.presses("E");
    page.until("armed", |page| page.shown["machine"]["armed"] == true);
    let begin = Instant::now();
    while at(&page)[1] < 500.0 {
        assert!(begin.elapsed() < Duration::from_secs(20), "{:?}", at(&page));
        device.presses("8");
        page.read();
    }
    page.until_state("idle");
    let [x, y, _] = at(&page);
    assert!(x == 0.0 && y < 1250.0, "{x} {y}: it went on to the end of the axis");
}

#[test]
fn a_console_that_is_unplugged_no_longer_drives_and_may_come_back() {
    let (shop, plug) = (shop(|_| {}), Plug::new().unwrap());
    let mut page = at_port(&shop, plug.path());
    let mut plug = plug;
    plug.write(b"4").unwrap();
    let asks = json!(["Nobody drives", "Enter takes control"]);
    page.until("the offer", |page| page.shown["handConsole"]["lines"] == asks);
    plug.write(b"\r").unwrap();
    page.until("the driver", |page| page.shown["lease"]["device"] == "hand console");
    let path = plug.path().to_owned();
    drop(plug);
    page.until("nobody", |page| page.shown["lease"].is_null());
    page.until("disarmed", |page| page.shown["machine"]["armed"] == false);
    let told = |page: &Page| page.shown["messages"].to_string().contains(&path);
    page.until("a warning", told);
    let again = Plug::new().unwrap();
    let mut hand = Hand { page, seq: 0 };
    hand.drive();
    hand.set("options.devices", &format!("{},b,c,d", again.path()));
    let there = format!("at {}", again.path());
    hand.until("the link", |page| page.shown["handConsole"]["link"] == there.as_str());
}

/// The port of the machine that both versions know.
static PLUGGED: OnceLock<String> = OnceLock::new();

#[test]
fn pro_options_machineonly() {
    let mut plug = Plug::new().unwrap();
    PLUGGED.set(plug.path().to_owned()).unwrap();
    let console: support::Change = |machine| {
        machine.options.console = true;
        machine.options.devices[0] = PLUGGED.get().unwrap().clone();
    };
    let start_up = |drawing_only| {
        let machine = Some(("sim", console));
        start(Wanted { drawing_only, machine, ..Wanted::default() })
    };
    let mut bytes = [0; 64];
    let edits = start_up(true);
    let mut page = edits.page();
    assert_eq!(plug.read(&mut bytes, Duration::from_secs(1)).unwrap(), 0, "it opened the port");
    assert_eq!(page.shown["handConsole"], json!({ "lines": ["", ""], "beeps": 0, "link": "" }));
    let id = page.send(json!({ "do": "key", "lease": 0, "seq": 1, "key": "P" }));
    assert!(page.problem(id).contains("editing version"));
    // The machine version has the same settings, and does.
    let _machine = start_up(false);
    assert!(plug.read(&mut bytes, Duration::from_secs(20)).unwrap() > 0);
    assert_eq!(plug.baud().unwrap(), 2400);
}
