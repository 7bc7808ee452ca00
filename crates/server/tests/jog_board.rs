//! The dead man's handle on a board with step queues: whatever ends the hold, the machine slows down on its ramp and stands.

use crate::support::board::{STEPS_MM, Shared, shop};
use crate::support::{Page, Shop};
use serde_json::{Value, json};
use std::time::{Duration, Instant};

/// From the end of a hold to the last step, seconds of the board: the key's lease, the lead and the ramp.
const BOUND_S: f64 = 1.2;

/// The end of a hold.
enum End {
    Released,
    PageClosed,
    LinkLost,
    Stopped,
}

fn jog(page: &Page, seq: u32, what: &str) -> Value {
    let mut act =
        json!({ "do": what, "lease": page.lease, "seq": seq, "clockMs": page.clock_ms() });
    if what == "jogStart" {
        act["direction"] = json!([1.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
        (act["distance"], act["speedShare"]) = (Value::Null, json!(0.5));
    }
    act
}

/// Clock of the board and steps of X.
fn seen(board: &Shared) -> (u64, i64) {
    let board = board.lock().unwrap();
    (board.now, board.steppers.values().next().map_or(0, |x| x.position))
}

/// Holds the key until X has made 10 mm; returns its number. Where a busy computer is late with a renewal, which disarms
/// the machine, the key is pressed again.
fn hold(page: &mut Page, board: &Shared) -> u32 {
    for seq in 1..20 {
        page.until_state("idle");
        page.drive();
        let ends = seen(board).1 + (10.0 * STEPS_MM) as i64;
        assert_eq!(page.act(jog(page, seq, "jogStart")), None);
        while seen(board).1 < ends {
            let next = Instant::now() + Duration::from_millis(50);
            while Instant::now() < next {
                page.read();
            }
            if page.act(jog(page, seq, "jogRenew")).is_some() {
                break;
            }
        }
        if page.shown["machine"]["state"] == "jogging" && seen(board).1 >= ends {
            return seq;
        }
    }
    panic!("it does not move on");
}

/// The machine slows down and stands at the end of a hold. Where a busy computer keeps Kerf waiting for longer than the
/// board's deadline, the board stands at once, as it should: then it is tried again.
fn stands_after(end: &End) -> (Shop, Page) {
    for _ in 0..3 {
        let (shop, page, in_time) = ends_hold(end);
        if in_time {
            return (shop, page);
        }
    }
    panic!("the board's deadline passes each time");
}

/// Tells besides whether the board heard Kerf in time.
fn ends_hold(end: &End) -> (Shop, Page, bool) {
    let (shop, board) = shop();
    let (mut page, mut watcher) = (shop.driver(), shop.page());
    let seq = hold(&mut page, &board);
    watcher.until_state("jogging");
    let (ended, _) = seen(&board);
    let page = match end {
        End::Released => {
            page.send(json!({ "do": "jogStop", "seq": seq }));
            Some(page)
        }
        End::PageClosed => None,
        // Nothing comes of it any more, and its socket stays open.
        End::LinkLost => Some(page),
        End::Stopped => {
            watcher.send(json!({ "do": "stop" }));
            Some(page)
        }
    };
    watcher.until_state("idle");
    let (_, stood) = seen(&board);
    std::thread::sleep(Duration::from_millis(300));
    assert_eq!(seen(&board).1, stood, "nothing moves any more");
    let fake = board.lock().unwrap();
    let made: Vec<f64> = fake.steppers[&0].made.iter().map(|(at, _)| fake.time_at(*at)).collect();
    let took_s = made.last().unwrap() - fake.time_at(ended);
    assert!(took_s < BOUND_S, "{took_s} s");
    let gap_s = |n: usize| made[n] - made[n - 1];
    let (cruise_s, last_s) = (gap_s(made.len() / 2), gap_s(made.len() - 1));
    println!("{took_s:.3} s to the last step, {} deadlines passed", fake.expired);
    let in_time = fake.expired == 0;
    assert!(!in_time || last_s > 1.3 * cruise_s, "it slows down: {cruise_s} {last_s}");
    assert_eq!(fake.reason(), None, "the board was late for nothing");
    drop(fake);
    let stands_mm = stood as f64 / STEPS_MM;
    watcher.until("the place by the counts", |page| {
        let x_mm = page.shown["motion"]["at"]["machine"][0].as_f64().unwrap();
        (x_mm - stands_mm).abs() < 0.01
    });
    drop(page);
    (shop, watcher, in_time)
}

#[test]
fn a_key_that_is_released_has_the_board_stand() {
    stands_after(&End::Released);
}

#[test]
fn a_page_that_is_closed_has_the_board_stand() {
    let (_shop, mut watcher) = stands_after(&End::PageClosed);
    watcher.until("disarmed", |page| page.shown["machine"]["armed"] == false);
}

#[test]
fn a_link_over_which_nothing_comes_has_the_board_stand() {
    stands_after(&End::LinkLost);
}

#[test]
fn stop_of_another_page_has_the_board_stand() {
    stands_after(&End::Stopped);
}
