//! A controller against the list that every machine has to hold, over a good line and over bad ones.

use kerf_control::controller::{Connection, Line};
use kerf_driver_grbl::Grbl;
use kerf_driver_grbl::fake::Fake;
use kerf_machine::Machine;
use kerf_machine::conformance::{Bench, CASES, Case, Outcome, Seen};
use kerf_sim::chance::Chance;
use std::cell::RefCell;
use std::rc::Rc;
use std::thread::{sleep, spawn};
use std::time::{Duration, Instant};

/// A case takes no longer than this: the controller moves in real time, and its silence is an end after 10 s.
const PATIENCE: Duration = Duration::from_secs(60);

/// The input that its probe is.
const PROBE: u8 = 1;

/// Between two looks at a line on which nothing comes.
const GLANCE: Duration = Duration::from_millis(1);

/// One byte that is not what was sent.
#[derive(Clone, Copy, Debug)]
struct Spoiled {
    /// On the way to the controller.
    there: bool,
    /// Bytes of that way before it.
    after: u64,
    kind: Kind,
}

#[derive(Clone, Copy, Debug)]
enum Kind {
    Lost,
    Doubled,
    /// It has other bits.
    Garbled(u8),
}

impl Spoiled {
    fn of(seed: u64) -> Self {
        let mut chance = Chance::new(seed);
        let kinds = [Kind::Lost, Kind::Doubled, Kind::Garbled(1 << (chance.next() % 7))];
        let kind = kinds[(seed % 3) as usize];
        Self { there: seed.is_multiple_of(2), after: chance.next() % 90, kind }
    }

    /// Bytes as they arrive; the fault is over when it has happened.
    fn pass(fault: &mut Option<Self>, there: bool, bytes: &[u8]) -> Vec<u8> {
        let mut arrive = bytes.to_vec();
        let Some(spoiled) = fault.as_mut().filter(|spoiled| spoiled.there == there) else {
            return arrive;
        };
        let Some(byte) = bytes.get(spoiled.after as usize) else {
            spoiled.after -= bytes.len() as u64;
            return arrive;
        };
        let at = spoiled.after as usize;
        match spoiled.kind {
            Kind::Lost => drop(arrive.remove(at)),
            Kind::Doubled => arrive.insert(at, *byte),
            Kind::Garbled(bits) => arrive[at] ^= bits,
        }
        *fault = None;
        arrive
    }
}

/// A controller at the far end of a line, and the fault that is to come.
struct Far {
    fake: Fake,
    since: Instant,
    fault: Option<Spoiled>,
}

/// A line whose far end is a controller that is none.
struct Wire(Rc<RefCell<Far>>);

impl Line for Wire {
    fn read(&mut self, into: &mut [u8], wait: Duration) -> Result<usize, String> {
        let begin = Instant::now();
        loop {
            let mut far = self.0.borrow_mut();
            let now_s = far.since.elapsed().as_secs_f64();
            let said = far.fake.speak(now_s);
            let arrive = Spoiled::pass(&mut far.fault, false, &said);
            assert!(arrive.len() <= into.len(), "so much at a time would get lost");
            into[..arrive.len()].copy_from_slice(&arrive);
            if !arrive.is_empty() || begin.elapsed() >= wait {
                return Ok(arrive.len());
            }
            drop(far);
            sleep(GLANCE);
        }
    }

    fn write(&mut self, bytes: &[u8]) -> Result<(), String> {
        let mut far = self.0.borrow_mut();
        let now_s = far.since.elapsed().as_secs_f64();
        let arrive = Spoiled::pass(&mut far.fault, true, bytes);
        far.fake.hear(&arrive, now_s);
        Ok(())
    }
}

/// A connection to a controller that is none.
struct Connected {
    connection: Connection,
    far: Rc<RefCell<Far>>,
    begin: Instant,
}

impl Connected {
    /// The line is good until the controller has told who it is.
    fn new(fault: Option<Spoiled>) -> Self {
        let (fake, since) = (Fake::default(), Instant::now());
        let far = Rc::new(RefCell::new(Far { fake, since, fault: None }));
        let wire = Box::new(Wire(far.clone()));
        let connection = Connection::open("grbl", Box::new(Grbl::new()), wire).unwrap();
        far.borrow_mut().fault = fault;
        Self { connection, far, begin: Instant::now() }
    }
}

impl Bench for Connected {
    fn machine(&mut self) -> &mut dyn Machine {
        &mut self.connection
    }

    fn waits(&mut self) -> bool {
        self.connection.look();
        sleep(GLANCE);
        self.begin.elapsed() < PATIENCE
    }

    fn seen(&mut self) -> Option<Seen> {
        let far = &mut *self.far.borrow_mut();
        Some(Seen { place: far.fake.position(), turns: far.fake.spindle().is_some() })
    }

    fn breaks(&mut self) -> bool {
        self.far.borrow_mut().fake.hits_limit();
        true
    }

    fn moves_switch(&mut self, active: bool) -> Option<u8> {
        self.far.borrow_mut().fake.pins(if active { "P" } else { "" });
        Some(PROBE)
    }
}

/// Runs a case for each of these lines, side by side: they wait nearly all of the time.
fn outcomes(faults: &[Option<Spoiled>], case: &'static Case) -> Vec<Result<Outcome, String>> {
    let run = |fault: &Option<Spoiled>| {
        let fault = *fault;
        spawn(move || case.run(&mut Connected::new(fault)))
    };
    let running: Vec<_> = faults.iter().map(run).collect();
    running.into_iter().map(|thread| thread.join().unwrap()).collect()
}

#[test]
fn a_controller_on_a_good_line_holds_what_every_machine_has_to_hold() {
    for case in CASES {
        assert_eq!(outcomes(&[None], case), [Ok(Outcome::Held)], "{}", case.name);
    }
}

#[test]
fn a_controller_on_a_bad_line_does_what_it_is_asked_for_or_tells_that_it_does_not() {
    let (mut held, mut failed) = (0, 0);
    let spoiled: Vec<Option<Spoiled>> = (0..24).map(|seed| Some(Spoiled::of(seed))).collect();
    for case in CASES {
        for (fault, outcome) in spoiled.iter().zip(outcomes(&spoiled, case)) {
            match outcome {
                Ok(Outcome::Held) => held += 1,
                Ok(Outcome::Failed(_)) => failed += 1,
                Err(why) => panic!("{}, {fault:?}: {why}", case.name),
            }
        }
    }
    assert!(held > 0 && failed > 0, "{held} held, {failed} were told");
}
