//! A jog over a bad link: when its key is let go the machine stands as soon as over a good one.
//!
//! A program of its own: what runs beside it would be measured with it.

#![allow(clippy::unwrap_used, clippy::print_stdout)]

mod support;

use crate::support::rough::{Roughness, rough};
use crate::support::{Page, Shop, shop};
use serde_json::{Value, json};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::{Duration, Instant};

/// Jogs that are made over the bad link.
const JOGS: u64 = 42;

/// From the moment when a key was let go, to that when the machine begins to slow down.
const BOUND: Duration = Duration::from_millis(300);

/// A wireless link that is far away.
const BAD: Roughness = Roughness { delay_ms: [60, 140], stalls_percent: 5, stall_ms: [200, 400] };

/// Somebody beside the machine, who sees when it moves; and how long this computer itself stood still meanwhile.
struct Watcher {
    seen: Arc<Mutex<Seen>>,
    over: Arc<AtomicBool>,
}

#[derive(Default)]
struct Seen {
    /// Since when the machine moves, or stands.
    jogs: Option<(bool, Instant)>,
    /// Moments at which the computer stood still, each with its length.
    stalls: Vec<(Instant, Duration)>,
}

impl Watcher {
    fn of(shop: &Shop) -> Self {
        let (seen, over) = (Arc::<Mutex<Seen>>::default(), Arc::<AtomicBool>::default());
        let (mut page, eyes, ends) = (shop.page(), seen.clone(), over.clone());
        thread::spawn(move || {
            while !ends.load(Ordering::Relaxed) && page.read() {
                let jogs = page.shown["machine"]["state"] == "jogging";
                let mut seen = eyes.lock().unwrap();
                if seen.jogs.is_none_or(|(before, _)| before != jogs) {
                    seen.jogs = Some((jogs, Instant::now()));
                }
            }
        });
        let (eyes, ends) = (seen.clone(), over.clone());
        thread::spawn(move || {
            let nap = Duration::from_millis(2);
            while !ends.load(Ordering::Relaxed) {
                let begin = Instant::now();
                thread::sleep(nap);
                let late = begin.elapsed().saturating_sub(nap);
                if late > nap {
                    eyes.lock().unwrap().stalls.push((Instant::now(), late));
                }
            }
        });
        Self { seen, over }
    }

    /// Tells whether the machine moves.
    fn jogs(&self) -> bool {
        self.seen.lock().unwrap().jogs.is_some_and(|(jogs, _)| jogs)
    }

    /// Waits until the machine stands; how long it moved on from a moment, without the time in which the computer
    /// stood still.
    fn stands_after(&self, released: Instant) -> Duration {
        while self.jogs() {
            thread::sleep(Duration::from_millis(2));
        }
        let seen = self.seen.lock().unwrap();
        let (_, stood) = seen.jogs.unwrap();
        let meanwhile = |(at, _): &&(Instant, Duration)| *at > released && *at <= stood;
        let stalled: Duration = seen.stalls.iter().filter(meanwhile).map(|(_, late)| *late).sum();
        stood.saturating_duration_since(released).saturating_sub(stalled)
    }
}

impl Drop for Watcher {
    fn drop(&mut self) {
        self.over.store(true, Ordering::Relaxed);
    }
}

/// Result of a jog.
#[derive(Debug, PartialEq)]
enum Jogged {
    /// The machine moved when the key was let go, and so long after.
    On(Duration),
    /// It had ended before, or had not begun.
    Ended,
}

/// Holds a key for a while and lets it go.
fn jog(page: &mut Page, watcher: &Watcher, seq: u64, held: Duration) -> Jogged {
    let way = if seq.is_multiple_of(2) { 1.0 } else { -1.0 };
    let lease = page.lease;
    page.send(json!({ "do": "jogStart", "lease": lease, "seq": seq, "clockMs": page.clock_ms(),
        "direction": [way, 0.0, 0.0, 0.0, 0.0, 0.0], "distance": Value::Null, "speedShare": 0.5 }));
    let begin = Instant::now();
    while begin.elapsed() < held {
        let next = Instant::now() + Duration::from_millis(50);
        while Instant::now() < next {
            page.read();
        }
        let clock_ms = page.clock_ms();
        page.send(json!({ "do": "jogRenew", "lease": lease, "seq": seq, "clockMs": clock_ms }));
    }
    let (released, moved) = (Instant::now(), watcher.jogs());
    page.send(json!({ "do": "jogStop", "seq": seq }));
    let took = watcher.stands_after(released);
    // What is under way still is no part of the next one.
    page.measure();
    if moved { Jogged::On(took) } else { Jogged::Ended }
}

#[test]
fn run_on_over_a_bad_link_is_bounded_like_over_a_good_one() {
    let shop = shop(1.0, &[]);
    let watcher = Watcher::of(&shop);
    let mut near = shop.driver();
    let clean =
        (1..=5).filter_map(|seq| match jog(&mut near, &watcher, seq, Duration::from_millis(500)) {
            Jogged::On(took) => Some(took),
            Jogged::Ended => None,
        });
    let ramp = clean.min().expect("a jog over a good link");
    drop(near);
    let mut far = Page::through(rough(shop.server.address, BAD), shop.server.address, &[]).unwrap();
    far.drive();
    (0..4).for_each(|_| far.measure());
    let jogged = (1..=JOGS)
        .map(|seq| jog(&mut far, &watcher, seq, Duration::from_millis(400 + 37 * (seq % 8))));
    let mut on: Vec<Duration> = jogged
        .filter_map(|jogged| match jogged {
            Jogged::On(took) => Some(took),
            Jogged::Ended => None,
        })
        .collect();
    on.sort();
    println!("ramp {ramp:?}, {} of {JOGS} moved when let go: {on:?}", on.len());
    assert!(on.len() > JOGS as usize / 4, "{} of {JOGS} were held to their end", on.len());
    let most = on.last().unwrap();
    assert!(*most <= BOUND + ramp, "{most:?}, and a good link takes {ramp:?}");
}
