//! Counts the offsets of hard shapes that are proved, family by family.

use crate::families::FAMILIES;
use crate::timed::processor_s;
use kerf_geom::{Coarse, offset};

/// The first few failures of each family are told, so that they can be made again.
const TOLD: usize = 5;

/// Offsets a number of shapes of each family whose name contains a word, seeds from `first`.
pub fn families(count: u64, word: &str, first: u64) {
    println!("| family | seeds | not proved | not exact | microseconds each |");
    println!("|---|---|---|---|---|");
    for (name, make) in FAMILIES.iter().filter(|family| family.0.contains(word)) {
        let (mut failed, mut coarse) = (Vec::new(), Vec::new());
        let mut spent_s = 0.0;
        for seed in first..first + count {
            let (shape, distance) = make(seed);
            let begun = processor_s();
            let found = offset(&shape, distance);
            spent_s += processor_s() - begun;
            match found {
                Err(why) => failed.push(format!("{name} {seed} by {distance}: {why}")),
                Ok(found) => {
                    coarse.extend(Coarse::of(&found).map(|c| format!("{name} {seed}: {c}")))
                }
            }
        }
        let each = spent_s * 1e6 / count as f64;
        let seeds = format!("{first} to {}", first + count - 1);
        println!("| {name} | {seeds} | {} | {} | {each:.0} |", failed.len(), coarse.len());
        failed
            .iter()
            .take(TOLD)
            .chain(coarse.iter().take(TOLD))
            .for_each(|told| println!("  {told}"));
    }
}
