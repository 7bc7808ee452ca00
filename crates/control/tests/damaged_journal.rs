//! A journal whose files are damaged by dice: nothing panics, and nothing is lost without a word. The fuzz target `journal` throws
//! more of it.

use crate::damaged;

/// Damages that are tried; `MUTATIONS` asks for more.
const TRIES: u64 = 60;

#[test]
fn damage_by_dice_is_told_and_nothing_panics() {
    let wanted = std::env::var("MUTATIONS").ok().and_then(|n| n.parse().ok());
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    let mut dice = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        state as u8
    };
    damaged::check(&[]);
    for _ in 0..wanted.unwrap_or(TRIES) {
        let length = usize::from(dice() % 3 + 1) * 4;
        let bytes: Vec<u8> = (0..length).map(|_| dice()).collect();
        damaged::check(&bytes);
    }
}

#[test]
fn the_seeds_of_the_fuzz_target_hold() {
    let seeds = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/seeds/journal");
    for seed in std::fs::read_dir(seeds).unwrap() {
        damaged::check(&std::fs::read(seed.unwrap().path()).unwrap());
    }
}
