//! STOP is heard within a bound, whatever else a server is asked to do.
//!
//! A real server with a simulated machine that moves; a driver that presses STOP again and again; loads that are bounded
//! in number and time and come from this computer only. `KERF_STOPS` is how many stops are made in all (240 usually).
//!
//! A shared computer stands still now and then by itself. Control threads with the priority of the machine's thread, one
//! on each core, measure that: they sleep for a millisecond at a time, and where one wakes over a millisecond late, the
//! host stood still from the moment it was due until it woke. What of this lies between the press of STOP and its being
//! heard is taken off, once where it was so on several cores; the table tells both.
//!
//! A program of its own: what runs beside it would be measured with it.

#![allow(clippy::unwrap_used, clippy::print_stdout)]
#![cfg(target_os = "linux")]

mod driver;
mod host;
mod loads;
#[path = "../../../bench/src/page.rs"]
mod page;
mod shop;
mod table;

use driver::Driver;
use host::Host;
use loads::Load;
use shop::Shop;
use std::net::SocketAddr;
use std::time::{Duration, Instant};
use table::Row;

/// Longest until a stop is heard, and what 99 of 100 keep.
const BOUND: Duration = Duration::from_millis(100);
const USUAL: Duration = Duration::from_millis(50);
/// Time that 99 of 100 stops keep when nothing else is asked.
const ALONE: Duration = Duration::from_millis(5);
/// Most memory of the server, bytes.
const MEMORY: u64 = 500 << 20;

/// The load that is a disk like a worn SD card, and how much longer than usual each of its writes takes.
const SLOW_DISK: &str = "a disk that takes 120 ms";
const SLOWER: Duration = Duration::from_millis(120);

/// Begins a load.
type Begin = fn(SocketAddr) -> Vec<Load>;

/// Every load.
const LOADS: &[(&str, Begin)] = &[
    ("none", |_| Vec::new()),
    ("4 observers ping", |to| vec![loads::pings(to, 4, "observer", true)]),
    ("50 sockets of all roles", |to| {
        vec![
            loads::pings(to, 15, "observer", true),
            loads::pings(to, 15, "operator", false),
            loads::pings(to, 10, "setter", true),
            loads::nonsense(to, 10),
        ]
    }),
    (SLOW_DISK, |_| Vec::new()),
    ("1,000 half-sent requests", |to| vec![loads::half_sent(to, 1000)]),
    ("4 uploads of 16 MB", |to| vec![loads::uploads(to, 4, 16)]),
    ("tool paths of 6,000 circles", |to| vec![loads::tool_paths(to, 2)]),
    ("8 checks of 700 kB", |to| vec![loads::checks(to, 8)]),
    ("password tries", |to| {
        loads::protect(to);
        vec![loads::passwords(to, 8)]
    }),
    ("previews", |to| vec![loads::previews(to, 4)]),
    ("20 states and descriptions", |to| vec![loads::states(to, 20)]),
    ("all of it at once", |to| {
        loads::protect(to);
        vec![
            loads::pings(to, 20, "observer", true),
            loads::pings(to, 10, "operator", false),
            loads::nonsense(to, 10),
            loads::pings(to, 10, "setter", true),
            loads::half_sent(to, 1000),
            loads::uploads(to, 2, 16),
            loads::tool_paths(to, 1),
            loads::checks(to, 2),
            loads::passwords(to, 2),
            loads::previews(to, 1),
        ]
    }),
];

#[test]
fn stop_is_heard_under_every_load() {
    descriptors();
    let stops: usize = std::env::var("KERF_STOPS").map_or(240, |n| n.parse().unwrap());
    let only = std::env::var("KERF_LOAD").unwrap_or_default();
    let loads: Vec<_> = LOADS.iter().filter(|(name, _)| name.contains(&only)).collect();
    let each = stops.div_ceil(loads.len());
    let host = Host::watched();
    let rows: Vec<Row> = loads.iter().map(|(name, begin)| row(name, *begin, each, &host)).collect();
    host.leave();
    let table = table::markdown(&rows);
    println!("{table}");
    record(&table);
    for row in &rows {
        assert!(row.late == 0, "{}: {} stops were not heard", row.load, row.late);
        assert!(row.share(1.0) <= BOUND, "{}: at most {:?}", row.load, row.share(1.0));
        assert!(row.peak <= MEMORY, "{}: {} MB", row.load, row.peak >> 20);
        let usual = if row.load == "none" { ALONE } else { USUAL };
        // Of fewer than a hundred stops the 99th of a hundred is the longest, which has its own bound.
        if each >= 100 {
            assert!(row.share(0.99) <= usual, "{}: p99 {:?}", row.load, row.share(0.99));
        }
    }
    let usual = Row::share_of_all(&rows, 0.99);
    assert!(usual <= USUAL, "p99 of all {usual:?}");
}

/// First and last line of the table in the page of benchmarks.
const BEGIN: &str = "<!-- make bench RECORD=1 writes STOP from here -->";
const END: &str = "<!-- STOP to here -->";

/// Writes the table into the page of benchmarks where RECORD asks for it.
fn record(table: &str) {
    if std::env::var("RECORD").is_ok_and(|wanted| !wanted.is_empty()) {
        let command =
            "Command: `make bench`. Milliseconds from the press of STOP to the machine's thread";
        let text = format!("{} {command}{}.\n\n{table}", page::measured(), page::load());
        page::put(BEGIN, END, &text).unwrap();
    }
}

/// As many connections as the loads want.
fn descriptors() {
    use rustix::process::{Resource, Rlimit, getrlimit, setrlimit};
    let Rlimit { maximum, .. } = getrlimit(Resource::Nofile);
    setrlimit(Resource::Nofile, Rlimit { current: maximum, maximum }).unwrap();
}

/// Stops under one load, on a server of its own.
fn row(name: &'static str, begin: Begin, stops: usize, host: &Host) -> Row {
    let shop = Shop::on(if name == SLOW_DISK { SLOWER } else { Duration::ZERO });
    let mut driver = Driver::at(&shop);
    let from = Instant::now();
    let load = begin(shop.address);
    let mut row = Row::new(name);
    for _ in 0..stops {
        match driver.stop(Duration::from_secs(15)) {
            Some((pressed, heard)) => {
                row.add(heard - pressed, host.stood_still(pressed, heard));
            }
            None => row.late += 1,
        }
    }
    (row.peak, row.stall) = (shop.peak(), host.longest(from));
    drop(load);
    row.took = from.elapsed();
    row
}
