//! The simulated machine against the list that every machine has to hold.

use kerf_machine::Machine;
use kerf_machine::conformance::{Bench, CASES, Outcome, Seen};
use kerf_sim::{Change, Clock, Simulated};

/// A clock of which a little passes at a time, seconds.
struct Slow(f64);

impl Clock for Slow {
    fn pass(&mut self, from_s: f64, until_s: f64) -> f64 {
        (from_s + self.0).min(until_s)
    }
}

/// A machine that has time for so many looks.
struct Looked<C>(Simulated<C>, u32);

impl<C: Clock> Bench for Looked<C> {
    fn machine(&mut self) -> &mut dyn Machine {
        &mut self.0
    }

    fn waits(&mut self) -> bool {
        self.1 = self.1.saturating_sub(1);
        self.1 > 0
    }

    fn seen(&mut self) -> Option<Seen> {
        None
    }

    fn breaks(&mut self) -> bool {
        false
    }

    fn moves_switch(&mut self, active: bool) -> Option<u8> {
        let input = 1;
        self.0.hands().press(Change { input, on: active, at_s: 0.0 }).then_some(input)
    }
}

#[test]
fn the_simulated_machine_holds_what_every_machine_has_to_hold() {
    for case in CASES {
        let looks = 10_000;
        let at_once = case.run(&mut Looked(Simulated::new(()), looks));
        assert_eq!(at_once, Ok(Outcome::Held), "{}", case.name);
        let slowly = case.run(&mut Looked(Simulated::new(Slow(0.007)), looks));
        assert_eq!(slowly, Ok(Outcome::Held), "{}", case.name);
    }
}

/// Passes by the moment that it is told.
struct Hasty;

impl Clock for Hasty {
    fn pass(&mut self, _: f64, until_s: f64) -> f64 {
        until_s + 1.0
    }
}

#[test]
fn a_machine_that_passes_the_end_of_its_plan_does_not_hold_it() {
    let wrong = CASES[0].run(&mut Looked(Simulated::new(Hasty), 1000)).unwrap_err();
    assert!(wrong.contains("has reached"), "{wrong}");
    // Time that never passes.
    let wrong = CASES[0].run(&mut Looked(Simulated::new(Slow(0.0)), 1000)).unwrap_err();
    assert!(wrong.contains("does not come to an end"), "{wrong}");
}
