//! Programs and drawings made by seed that nest whatever multiplies: loops, calls, arcs with passes, cycles, blocks,
//! `use`, arrays. Whatever comes out, `kerf` ends by itself within a gibibyte, with words and without a panic.
//!
//! `KERF_FUZZ_RUNS` makes more of them than the short sample, `KERF_FUZZ_SEED` others, and with
//! `KERF_FUZZ_WHOLE=1` they are looked at up to the usual bounds.

#![cfg(unix)]

mod made;

use crate::shop::Shop;
use crate::shop::bounded::bounded;
use made::Made;
use std::env;

/// Memory a command may address, KiB.
const MOST_KIB: u64 = 1 << 20;

/// Things made in the short sample.
const FEW: u64 = 6;

fn number(name: &str, usual: u64) -> u64 {
    env::var(name).map_or(usual, |text| text.parse().unwrap())
}

/// Looks at what is made by a seed in every way; what went wrong.
fn look(seed: u64, more: &str) -> Vec<String> {
    let Made { files, commands } = made::by_seed(seed);
    let files: Vec<(&str, &str)> =
        files.iter().map(|(name, text)| (*name, text.as_str())).collect();
    let shop = Shop::new(&files);
    // One that does not end is known by the last number.
    println!("seed {seed}");
    let wrong = |command: &String| {
        let did = bounded(&shop, MOST_KIB, &command.replace("MORE", more));
        let ended = matches!(did.code, Some(0 | 1 | 3)) && did.signal.is_none();
        (!ended).then(|| {
            format!("seed {seed}: kerf {command}: {:?} {:?} {}", did.code, did.signal, did.err)
        })
    };
    commands.iter().filter_map(wrong).collect()
}

#[test]
fn what_multiplies_is_bounded_by_memory() {
    let first = number("KERF_FUZZ_SEED", 1);
    let runs = number("KERF_FUZZ_RUNS", FEW);
    let more = if number("KERF_FUZZ_WHOLE", 0) == 1 { "" } else { "--max-lines 2000" };
    let wrong: Vec<String> = (first..first + runs).flat_map(|seed| look(seed, more)).collect();
    println!("structured: {runs} made from seed {first}, {} went wrong", wrong.len());
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
