//! A controller against the list that every machine has to hold, over a good line and over bad ones.

use crate::over_lines::{holds_or_tells_over_bad_lines, holds_over_a_good_line};
use kerf_control::controller::Connection;
use kerf_driver_grbl::Grbl;
use kerf_driver_grbl::fake::Fake;
use kerf_machine::Machine;
use kerf_machine::conformance::{Bench, Seen};
use kerf_transport::{Fault, Faulty, Line, LineError};
use std::cell::RefCell;
use std::rc::Rc;
use std::thread::sleep;
use std::time::{Duration, Instant};

/// A case takes no longer than this: the controller moves in real time, and its silence is an end after 10 s.
const PATIENCE: Duration = Duration::from_secs(60);

/// The input that its probe is.
const PROBE: u8 = 1;

/// Between two looks at a line on which nothing comes.
const GLANCE: Duration = Duration::from_millis(1);

/// A controller at the far end of a line.
struct Far {
    fake: Fake,
    since: Instant,
}

/// A line whose far end is a fake controller.
struct Wire(Rc<RefCell<Far>>);

impl Line for Wire {
    fn read(&mut self, into: &mut [u8], wait: Duration) -> Result<usize, LineError> {
        let begin = Instant::now();
        loop {
            let mut far = self.0.borrow_mut();
            let now_s = far.since.elapsed().as_secs_f64();
            let arrive = far.fake.speak(now_s);
            assert!(arrive.len() <= into.len(), "so much at a time would get lost");
            into[..arrive.len()].copy_from_slice(&arrive);
            if !arrive.is_empty() || begin.elapsed() >= wait {
                return Ok(arrive.len());
            }
            drop(far);
            sleep(GLANCE);
        }
    }

    fn write(&mut self, bytes: &[u8]) -> Result<(), LineError> {
        let mut far = self.0.borrow_mut();
        let now_s = far.since.elapsed().as_secs_f64();
        far.fake.hear(bytes, now_s);
        Ok(())
    }
}

/// A connection to a fake controller.
struct Connected {
    connection: Connection,
    far: Rc<RefCell<Far>>,
    begin: Instant,
}

impl Connected {
    /// The line is good until the controller has told who it is.
    fn new(fault: Option<Fault>) -> Self {
        let (fake, since) = (Fake::default(), Instant::now());
        let far = Rc::new(RefCell::new(Far { fake, since }));
        let line = Rc::new(RefCell::new(Faulty::new(Wire(far.clone()), &[])));
        let opened = Connection::open("grbl", Box::new(Grbl::new()), Box::new(line.clone()));
        let connection = opened.unwrap();
        fault.into_iter().for_each(|fault| line.borrow_mut().comes(fault));
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

#[test]
fn a_controller_on_a_good_line_holds_what_every_machine_has_to_hold() {
    holds_over_a_good_line(Connected::new);
}

#[test]
fn a_controller_on_a_bad_line_does_what_it_is_asked_for_or_tells_that_it_does_not() {
    holds_or_tells_over_bad_lines(24, 90, Connected::new);
}
