//! LinuxCNC against the list that every machine has to hold, over a good line to its bridge and over bad ones.

use crate::over_lines::{holds_or_tells_over_bad_lines, holds_over_a_good_line};
use kerf_control::controller::Connection;
use kerf_driver_linuxcnc::LinuxCnc;
use kerf_driver_linuxcnc::fake::Fake;
use kerf_machine::Machine;
use kerf_machine::conformance::{Bench, Seen};
use kerf_transport::{Fault, Faulty, Line, LineError};
use std::cell::RefCell;
use std::rc::Rc;
use std::thread::sleep;
use std::time::{Duration, Instant};

/// A case takes no longer than this.
const PATIENCE: Duration = Duration::from_secs(60);

/// The input that its probe is.
const PROBE: u8 = 1;

/// Between two looks at a line on which nothing comes.
const GLANCE: Duration = Duration::from_millis(1);

/// A bridge at the far end of a line.
struct Far {
    fake: Fake,
    since: Instant,
}

impl Far {
    fn now_s(&self) -> f64 {
        self.since.elapsed().as_secs_f64()
    }
}

/// A line whose far end is a fake bridge.
struct Wire(Rc<RefCell<Far>>, Vec<u8>);

impl Line for Wire {
    fn read(&mut self, into: &mut [u8], wait: Duration) -> Result<usize, LineError> {
        let begin = Instant::now();
        loop {
            let mut far = self.0.borrow_mut();
            let now_s = far.now_s();
            self.1.extend(far.fake.speak(now_s));
            drop(far);
            let count = self.1.len().min(into.len());
            into[..count].copy_from_slice(&self.1[..count]);
            self.1.drain(..count);
            if count > 0 || begin.elapsed() >= wait {
                return Ok(count);
            }
            sleep(GLANCE);
        }
    }

    fn write(&mut self, bytes: &[u8]) -> Result<(), LineError> {
        let mut far = self.0.borrow_mut();
        let now_s = far.now_s();
        far.fake.hear(bytes, now_s);
        Ok(())
    }
}

struct Connected {
    connection: Connection,
    far: Rc<RefCell<Far>>,
    begin: Instant,
}

impl Connected {
    /// The line is good until the bridge has told who it is.
    fn new(fault: Option<Fault>) -> Self {
        let (fake, since) = (Fake::default(), Instant::now());
        let far = Rc::new(RefCell::new(Far { fake, since }));
        let line = Rc::new(RefCell::new(Faulty::new(Wire(far.clone(), Vec::new()), &[])));
        let driver = Box::new(LinuxCnc::new());
        let connection = Connection::open("linuxcnc", driver, Box::new(line.clone())).unwrap();
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
        let far = self.far.borrow();
        Some(Seen { place: far.fake.position(), turns: far.fake.spindle().is_some() })
    }

    fn breaks(&mut self) -> bool {
        self.far.borrow_mut().fake.presses_estop();
        true
    }

    fn moves_switch(&mut self, active: bool) -> Option<u8> {
        self.far.borrow_mut().fake.inputs = u32::from(active);
        Some(PROBE)
    }
}

#[test]
fn linuxcnc_on_a_good_line_holds_what_every_machine_has_to_hold() {
    holds_over_a_good_line(Connected::new);
}

#[test]
fn linuxcnc_on_a_bad_line_does_what_it_is_asked_for_or_tells_that_it_does_not() {
    holds_or_tells_over_bad_lines(16, 200, Connected::new);
}
