//! A line that is lost on the way, and takes long to open.

use kerf_control::controller::{Connection, Ends};
use kerf_driver_grbl::Grbl;
use kerf_driver_grbl::fake::Fake;
use kerf_machine::Machine;
use kerf_transport::{Line, LineError};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

/// A line to a fake controller, which can be pulled.
struct Wire {
    fake: Arc<Mutex<Fake>>,
    pulled: Arc<AtomicBool>,
    since: Instant,
}

impl Wire {
    fn passes(&self) -> Result<f64, LineError> {
        let pulled = self.pulled.load(Ordering::Relaxed);
        if pulled { Err(LineError::Closed) } else { Ok(self.since.elapsed().as_secs_f64()) }
    }
}

impl Line for Wire {
    fn read(&mut self, into: &mut [u8], _: Duration) -> Result<usize, LineError> {
        let now_s = self.passes()?;
        let came = self.fake.lock().unwrap().speak(now_s);
        into[..came.len()].copy_from_slice(&came);
        Ok(came.len())
    }

    fn write(&mut self, bytes: &[u8]) -> Result<(), LineError> {
        let now_s = self.passes()?;
        self.fake.lock().unwrap().hear(bytes, now_s);
        Ok(())
    }
}

#[test]
fn a_line_that_takes_long_to_open_holds_nobody_up() {
    let (fake, since) = (Arc::new(Mutex::new(Fake::default())), Instant::now());
    let pulled = Arc::new(AtomicBool::new(false));
    let wire = move || Wire { fake: fake.clone(), pulled: pulled.clone(), since };
    let pulled = wire().pulled;
    let line = Box::new(wire());
    let mut connection = Connection::open("grbl", Box::new(Grbl::new()), line).unwrap();
    // Whoever opens it waits until the test lets it.
    let gate = Arc::new(Mutex::new(()));
    let closed = gate.lock().unwrap();
    let (at, wire) = (gate.clone(), Mutex::new(wire));
    let opens = move || {
        drop(at.lock().unwrap());
        let wire = wire.lock().unwrap()();
        let ends: Ends = (Box::new(Grbl::new()), Box::new(wire));
        Ok(ends)
    };
    connection.opens_again(Arc::new(opens));
    pulled.store(true, Ordering::Relaxed);
    let begin = Instant::now();
    while begin.elapsed() < Duration::from_secs(1) {
        // It returns although nobody can open the line.
        connection.look();
    }
    assert!(connection.waits().is_some_and(|why| why.contains("its line is gone")));
    pulled.store(false, Ordering::Relaxed);
    drop(closed);
    while connection.waits().is_some() {
        assert!(begin.elapsed() < Duration::from_secs(30), "it does not come back");
        connection.look();
    }
    assert_eq!(connection.fault(), None);
}
