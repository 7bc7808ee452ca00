//! The list that every machine has to hold, over good lines and bad ones.

use kerf_machine::conformance::{Bench, CASES, Case, Outcome};
use kerf_sim::random::SeededRandom;
use kerf_transport::{Damage, Fault};
use std::thread::spawn;

/// One byte that is not what was sent, by a seed: one of the first `bytes`.
fn spoiled(seed: u64, bytes: u64) -> Fault {
    let mut chance = SeededRandom::new(seed);
    let damages = [Damage::Lost, Damage::Doubled, Damage::Flipped(1 << (chance.next() % 7))];
    let damage = damages[(seed % 3) as usize];
    Fault { there: seed.is_multiple_of(2), after: chance.next() % bytes, damage }
}

/// Runs a case for each of these lines, side by side: they wait nearly all of the time.
fn outcomes<B: Bench + 'static>(
    faults: &[Option<Fault>],
    case: &'static Case,
    connects: fn(Option<Fault>) -> B,
) -> Vec<Result<Outcome, String>> {
    let run = |fault: &Option<Fault>| {
        let fault = *fault;
        spawn(move || case.run(&mut connects(fault)))
    };
    let running: Vec<_> = faults.iter().map(run).collect();
    running.into_iter().map(|thread| thread.join().unwrap()).collect()
}

/// Every case is held over a good line.
pub fn holds_over_a_good_line<B: Bench + 'static>(connects: fn(Option<Fault>) -> B) {
    for case in CASES {
        assert_eq!(outcomes(&[None], case, connects), [Ok(Outcome::Held)], "{}", case.name);
    }
}

/// Every case is held, or told as failed, over as many lines as `seeds`, each with one of its first `bytes` spoiled.
pub fn holds_or_tells_over_bad_lines<B: Bench + 'static>(
    seeds: u64,
    bytes: u64,
    connects: fn(Option<Fault>) -> B,
) {
    let (mut held, mut failed) = (0, 0);
    let bad: Vec<Option<Fault>> = (0..seeds).map(|seed| Some(spoiled(seed, bytes))).collect();
    for case in CASES {
        for (fault, outcome) in bad.iter().zip(outcomes(&bad, case, connects)) {
            match outcome {
                Ok(Outcome::Held) => held += 1,
                Ok(Outcome::Failed(_)) => failed += 1,
                Err(why) => panic!("{}, {fault:?}: {why}", case.name),
            }
        }
    }
    assert!(held > 0 && failed > 0, "{held} held, {failed} were told");
}
