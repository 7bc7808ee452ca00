//! News of a controller that comes between two looks at its line.

use kerf_control::controller::Connection;
use kerf_driver_grbl::Grbl;
use kerf_driver_grbl::fake::Fake;
use kerf_machine::{Going, Machine};
use kerf_motion::{Mover, Plan, plan_stack};
use kerf_program::{At, Axes, Feed, Line as Straight, MoveKind, Settings};
use kerf_transport::{Line, LineError};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// A line on which bytes come only while nobody waits for them, once it is slow.
struct Wire {
    fake: Arc<Mutex<Fake>>,
    slow: Arc<AtomicBool>,
    since: Instant,
}

impl Line for Wire {
    fn read(&mut self, into: &mut [u8], wait: Duration) -> Result<usize, LineError> {
        if !wait.is_zero() {
            sleep(Duration::from_millis(1));
            if self.slow.load(Ordering::Relaxed) {
                return Ok(0);
            }
        }
        let came = self.fake.lock().unwrap().speak(self.since.elapsed().as_secs_f64());
        into[..came.len()].copy_from_slice(&came);
        Ok(came.len())
    }

    fn write(&mut self, bytes: &[u8]) -> Result<(), LineError> {
        self.fake.lock().unwrap().hear(bytes, self.since.elapsed().as_secs_f64());
        Ok(())
    }
}

/// A move up, away from a contact.
fn up() -> Plan {
    let to = Axes::xyz(0.0, 0.0, 5.0);
    let line = Straight { kind: MoveKind::Cut, to, feed: Feed::Path(20.0) };
    let settings = Settings::default();
    let made = Mover::new(Axes::default(), &settings).line(At::default(), &line);
    plan_stack(made.into_iter().collect(), &settings.ramps)
}

#[test]
fn an_input_that_opened_on_the_way_is_told_before_the_end_of_the_way() {
    let (fake, slow) = (Arc::new(Mutex::new(Fake::default())), Arc::new(AtomicBool::new(false)));
    fake.lock().unwrap().plate_mm = Some(4.999);
    let wire = Wire { fake, slow: slow.clone(), since: Instant::now() };
    let mut connection = Connection::open("grbl", Box::new(Grbl::new()), Box::new(wire)).unwrap();
    slow.store(true, Ordering::Relaxed);
    let plan = up();
    // At some moments of a run the sum of beginning and duration is rounded down, and the place alone reaches it.
    let (mut inputs, t0_s) = (Vec::new(), 10.0);
    let end_s = t0_s + plan.duration_s() * (1.0 - 1e-12);
    let going = Going { plan: &plan, index: 0, t0_s, until: 1, part: 1.0, watches: &[] };
    connection.begin_plan();
    loop {
        let news = connection.advance(&going, t0_s, end_s);
        inputs.extend(news.input);
        assert_eq!(connection.fault(), None);
        if news.reached_s >= end_s && news.input.is_none() {
            break;
        }
    }
    assert_eq!(inputs, [(1, true), (1, false)]);
}
