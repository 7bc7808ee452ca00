//! A machine that hangs on a fake controller, which moves in the time of the world.

use kerf_control::controller::{Controller, Ends, First, Place, Socket};
use kerf_driver_grbl::Grbl;
use kerf_driver_grbl::fake::Fake;
use kerf_server::Workshop;
use kerf_transport::{Line, LineError};
use std::sync::{Arc, Mutex};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// The line to it.
struct Wire {
    fake: Arc<Mutex<Fake>>,
    since: Instant,
}

impl Line for Wire {
    fn read(&mut self, into: &mut [u8], wait: Duration) -> Result<usize, LineError> {
        sleep(wait.min(Duration::from_millis(1)));
        let came = self.fake.lock().unwrap().speak(self.since.elapsed().as_secs_f64());
        into[..came.len()].copy_from_slice(&came);
        Ok(came.len())
    }

    fn write(&mut self, bytes: &[u8]) -> Result<(), LineError> {
        self.fake.lock().unwrap().hear(bytes, self.since.elapsed().as_secs_f64());
        Ok(())
    }
}

/// The workshop, its machine on this controller.
pub fn attached(mut workshop: Workshop, fake: Arc<Mutex<Fake>>) -> Workshop {
    let since = Instant::now();
    let opens = move || {
        let wire = Wire { fake: fake.clone(), since };
        let ends: Ends = (Box::new(Grbl::new()), Box::new(wire));
        Ok(ends)
    };
    let (name, port) = ("grbl:pretended".into(), "pretended".into());
    let place = Place::Followed(Socket { name, port, opens: Arc::new(opens), log: Arc::default() });
    let Workshop { session, workspace, .. } = &mut workshop;
    let first = First { beside_card: true, ..First::default() };
    let attached = Controller::attach(place, first, session, workspace, || false);
    let (controller, told) = attached.unwrap();
    Workshop { controller: Some(controller), told, ..workshop }
}
