//! The hand console: keys of a page, and what its screen shows of the simulated machine.

#![allow(clippy::unwrap_used, non_snake_case)]

mod support;

use kerf_machine::Configuration;
use serde_json::json;
use support::hand::Hand;
use support::{Page, Shop, Wanted, at, rsm, start};

/// Sixteen squares, 720 mm by 360 in all.
fn sample() -> String {
    let square = |n: u32| {
        let (x, y) = (f64::from(n % 4) * 225.0, f64::from(n / 4) * 105.0);
        format!("rect {x},{y} {},{}", x + 45.0, y + 45.0)
    };
    rsm(&(0..16).map(square).collect::<Vec<_>>().join("; "))
}

/// SIM, in a hurry.
fn shop(change: fn(&mut Configuration)) -> Shop {
    start(Wanted { rate: 8.0, machine: Some(("sim", change)), ..Wanted::default() })
}

/// A machine that is driven, with the sample open.
fn with_sample(change: fn(&mut Configuration)) -> (Shop, Hand) {
    let shop = shop(change);
    shop.write("SAMPLE.RSM", sample().as_bytes());
    let mut hand = Hand::of(&shop);
    hand.open_file("SAMPLE.RSM");
    (shop, hand)
}

/// Where the machine is, near enough for people.
fn near(page: &Page, place: [f64; 3]) -> bool {
    at(page).iter().zip(place).all(|(a, b)| (a - b).abs() < 1e-6)
}

#[test]
fn pro_console_idle() {
    let shop = shop(|_| {});
    let mut hand = Hand::of(&shop);
    hand.shows("JOB: Untitled", "0x0mm #0");
    shop.write("SAMPLE.RSM", sample().as_bytes());
    hand.open_file("SAMPLE.RSM");
    hand.shows("JOB: SAMPLE.RSM", "720x360mm #16");
}

#[test]
fn pro_console_func() {
    let shop = shop(|_| {});
    let mut hand = Hand::of(&shop);
    hand.keys("U");
    hand.shows("Enter function:", "0 Cut speed");
    hand.keys("1");
    hand.shows("Enter function:", "1 Plunge speed");
    hand.keys("5P");
    hand.shows("Enter function:", "1 Plunge speed");
    hand.keys("U");
    hand.shows("JOB: Untitled", "0x0mm #0");
}

#[test]
fn pro_console_func_unknown() {
    let shop = shop(|_| {});
    let mut hand = Hand::of(&shop);
    hand.keys("U9E");
    hand.shows("Enter function:", "9 ?");
    assert_eq!(hand.beeps(), 1);
    hand.keys("P4");
    hand.shows("Enter function:", "4 Move to origin");
}

#[test]
fn a_function_moves_the_machine() {
    let (_shop, mut hand) = with_sample(|_| {});
    hand.act(json!({ "do": "choose", "choice": { "origin": [300, 200] } }));
    hand.until("the preview", |page| page.shown["opened"]["preview"]["state"] == "ready");
    hand.keys("U4E");
    hand.shows("Move to origin", "");
    hand.until("the origin", |page| near(page, [300.0, 200.0, 0.0]));
    hand.shows("JOB: SAMPLE.RSM", "720x360mm #16");
}

#[test]
fn pro_console_idle_jog() {
    let shop = shop(|_| {});
    let mut hand = Hand::of(&shop);
    let ways = [
        ('6', [1, 0, 0]),
        ('8', [0, 1, 0]),
        ('4', [-1, 0, 0]),
        ('2', [0, -1, 0]),
        ('9', [1, 1, 0]),
        ('1', [-1, -1, 0]),
        ('6', [1, 0, 0]),
        ('7', [-1, 1, 0]),
        ('3', [1, -1, 0]),
        ('0', [0, 0, -1]),
        ('5', [0, 0, 1]),
    ];
    for (key, way) in ways {
        let before = at(&hand);
        let went = |page: &Page| {
            let ways = at(page).into_iter().zip(before).map(|(now, then)| now - then);
            ways.zip(way).all(|(went, way)| match way {
                0 => went.abs() < 1e-9,
                way => went * f64::from(way) > 1.0,
            })
        };
        hand.holds(key, &format!("{key}: {way:?} from {before:?}"), went);
    }
}
