//! The hand console as a page presses its keys, and the job that the manual shows on it.

use super::{Page, Shop, Wanted, rsm, start};
use kerf_machine::Configuration;
use serde_json::json;
use std::ops::{Deref, DerefMut};
use std::time::{Duration, Instant};

/// Sixteen squares, 720 mm by 360 in all.
pub fn sample() -> String {
    let square = |n: u32| {
        let (x, y) = (f64::from(n % 4) * 225.0, f64::from(n / 4) * 105.0);
        format!("rect {x},{y} {},{}", x + 45.0, y + 45.0)
    };
    rsm(&(0..16).map(square).collect::<Vec<_>>().join("; "))
}

/// SIM, in a hurry.
pub fn shop(change: fn(&mut Configuration)) -> Shop {
    start(Wanted { rate: 8.0, machine: Some(("sim", change)), ..Wanted::default() })
}

/// A page with the hand console open, which drives.
pub struct Hand {
    pub page: Page,
    /// Number of the last key.
    pub seq: u32,
}

impl Deref for Hand {
    type Target = Page;

    fn deref(&self) -> &Page {
        &self.page
    }
}

impl DerefMut for Hand {
    fn deref_mut(&mut self) -> &mut Page {
        &mut self.page
    }
}

impl Hand {
    pub fn of(shop: &Shop) -> Self {
        Self { page: shop.driver(), seq: 0 }
    }

    pub fn press(&mut self, key: char) {
        self.seq += 1;
        let (lease, seq) = (self.lease, self.seq);
        let act = json!({ "do": "key", "lease": lease, "seq": seq, "key": key });
        assert_eq!(self.act(act), None, "{key:?}");
    }

    /// Presses keys one after the other: their characters, `E` for Enter.
    pub fn keys(&mut self, keys: &str) {
        keys.chars().for_each(|key| self.press(if key == 'E' { '\r' } else { key }));
    }

    /// Holds a key until something is so, and waits until the machine stands.
    #[track_caller]
    pub fn holds(&mut self, key: char, what: &str, holds: impl Fn(&Page) -> bool) {
        self.press(key);
        let (lease, seq, begin) = (self.lease, self.seq, Instant::now());
        while !holds(&self.page) {
            assert!(begin.elapsed() < Duration::from_secs(20), "waited for {what}");
            let clock_ms = self.clock_ms();
            self.act(json!({ "do": "jogRenew", "lease": lease, "seq": seq, "clockMs": clock_ms }));
        }
        self.act(json!({ "do": "jogStop", "seq": seq }));
        self.until_state("idle");
    }

    /// Waits until the machine stands, and has the last key's screen.
    #[track_caller]
    pub fn settles(&mut self) {
        let begin = Instant::now();
        while begin.elapsed() < Duration::from_millis(150) {
            self.read();
        }
        self.until_state("idle");
    }

    /// Waits for the two lines of the screen.
    #[track_caller]
    pub fn shows(&mut self, top: &str, bottom: &str) {
        let lines = json!([top, bottom]);
        let shown = |page: &Page| page.shown["handConsole"]["lines"] == lines;
        self.until(&format!("{top} / {bottom}"), shown);
    }

    pub fn beeps(&self) -> u64 {
        self.shown["handConsole"]["beeps"].as_u64().unwrap()
    }
}

/// A machine that is driven, with the sample open.
pub fn with_sample(change: fn(&mut Configuration)) -> (Shop, Hand) {
    let shop = shop(change);
    shop.write("SAMPLE.RSM", sample().as_bytes());
    let mut hand = Hand::of(&shop);
    hand.open_file("SAMPLE.RSM");
    (shop, hand)
}
