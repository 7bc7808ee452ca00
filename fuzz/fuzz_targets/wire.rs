//! Any bytes as requests of a page, a line each: done or refused with words, never a panic, and a stop is heard afterwards.
#![no_main]

#[path = "../../crates/server/tests/requests/mod.rs"]
mod requests;

use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| requests::check(bytes));
