//! Words of boards, whole and mutated by dice. The fuzz target `board` throws more of it.

use crate::bytes;
use kerf_driver_klipper::fake::Dice;
use std::fs;
use std::path::Path;

/// Bytes that are changed in a mutated one.
const CHANGES: u64 = 4;

fn seeds() -> Vec<Vec<u8>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/seeds/board");
    let mut paths: Vec<_> =
        fs::read_dir(folder).expect("seeds").map(|entry| entry.expect("a file").path()).collect();
    paths.sort();
    paths.iter().map(|path| fs::read(path).expect("a seed")).collect()
}

#[test]
fn whatever_a_board_says_nothing_panics_and_nothing_moves_by_itself() {
    let wanted = std::env::var("MUTATIONS").ok().and_then(|n| n.parse().ok());
    let (seeds, mut dice) = (seeds(), Dice(1));
    assert!(seeds.len() >= 5);
    seeds.iter().for_each(|seed| bytes::check(seed));
    for _ in 0..wanted.unwrap_or(400) {
        let mut bytes = seeds[dice.below(seeds.len() as u64) as usize].clone();
        for _ in 0..1 + dice.below(CHANGES) {
            let at = dice.below(bytes.len() as u64 - 1) as usize + 1;
            bytes[at] = dice.roll() as u8;
        }
        bytes.truncate(1 + dice.below(bytes.len() as u64 * 2) as usize);
        bytes::check(&bytes);
    }
}
