//! Requests of every kind, whole and mutated by dice: each is done or refused with words. The fuzz target `wire` throws more of them.

use crate::requests;
use std::path::Path;

fn seeds() -> Vec<Vec<u8>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/seeds/wire");
    let files = std::fs::read_dir(folder).unwrap();
    let mut paths: Vec<_> = files.map(|file| file.unwrap().path()).collect();
    paths.sort();
    paths.into_iter().map(|path| std::fs::read(path).unwrap()).collect()
}

/// Every act that a page may ask for is in a seed.
#[test]
fn every_act_is_in_a_seed() {
    let schema = serde_json::to_value(schemars::schema_for!(kerf_wire::Act)).unwrap();
    let acts = schema["oneOf"].as_array().unwrap();
    assert!(acts.len() > 30, "{}", acts.len());
    let text: String =
        seeds().iter().map(|seed| String::from_utf8_lossy(seed).into_owned()).collect();
    for act in acts {
        let word = act["properties"]["do"]["const"].as_str().unwrap();
        assert!(text.contains(&format!("\"do\":\"{word}\"")), "no seed of {word}");
    }
    for line in text.lines().filter(|line| line.starts_with('{')) {
        serde_json::from_str::<kerf_wire::Request>(line)
            .map_err(|e| format!("{line}: {e}"))
            .unwrap();
    }
}

#[test]
fn requests_by_dice_are_done_or_refused_with_words() {
    let seeds = seeds();
    seeds.iter().for_each(|seed| requests::check(seed));
    let wanted = std::env::var("MUTATIONS").ok().and_then(|n| n.parse().ok()).unwrap_or(60);
    let mut state = 0x2545_f491_4f6c_dd1d_u64;
    let mut dice = |below: usize| {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 16) as usize % below
    };
    for _ in 0..wanted {
        let mut seed = seeds[dice(seeds.len())].clone();
        for _ in 0..=dice(3) {
            let at = dice(seed.len());
            match dice(3) {
                0 => seed[at] = b"0123456789-eE.\"{}[],:nulltrue"[dice(29)],
                1 => drop(seed.drain(at..(at + dice(12)).min(seed.len()))),
                _ => {
                    let piece: Vec<u8> = seed[at..].iter().copied().take(dice(20)).collect();
                    seed.splice(at..at, piece).for_each(drop);
                }
            }
            if seed.is_empty() {
                break;
            }
        }
        requests::check(&seed);
    }
}
