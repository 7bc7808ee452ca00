//! Any bytes as what a board with step queues says: never a panic, and nothing moves by itself.
#![no_main]
#![allow(dead_code)]

#[path = "../../crates/driver-klipper/tests/bytes/mod.rs"]
mod bytes;
#[path = "../../crates/driver-klipper/tests/world.rs"]
mod world;

use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| bytes::check(data));
