//! The travel of a controller bounds what moves by hand: no order is sent that it refuses.

use crate::bench::Bench;
use crate::shop::Shop;

const TRAVEL_MM: f64 = 40.0;

#[test]
fn a_held_key_ends_where_the_travel_of_the_controller_does() {
    let (shop, bench) = (Shop::new(&[]), Bench::new(&[(22, 1.0), (20, 1.0), (130, TRAVEL_MM)]));
    let by_hand =
        |words: &str| shop.kerf(&format!("machine {words} --machine grbl:{}", bench.port));
    by_hand("home").exits(0);
    let held = by_hand("move hold x- --speed 50");
    held.exits(0);
    let told = held.out() + &held.err();
    assert!(told.contains("Out of bounds: x ends at -40.000"), "{told}");
    assert!((bench.x_mm() + TRAVEL_MM).abs() < 0.01, "{}", bench.x_mm());
}
