//! Any bytes as damage to the files of the journal: it opens or says why not, and nothing is lost without a word.
#![no_main]

#[path = "../../crates/control/tests/damaged/mod.rs"]
mod damaged;

use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| damaged::check(bytes));
