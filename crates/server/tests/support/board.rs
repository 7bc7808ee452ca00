//! A server whose machine is a fake board with step queues.

use super::{Shop, Wanted, start};
use kerf_control::controller::{Controller, First, Place, queued};
use kerf_driver_klipper::fake::{Board as Fake, Pace};
use kerf_transport::{Line, LineError};
use std::collections::VecDeque;
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

/// Steps a millimetre of X.
pub const STEPS_MM: f64 = 100.0;

/// The machine's file. The board is patient with a computer that does much else.
const FILE: &str = "units = \"mm\"\n[steps]\nper_unit = [100, 100, 200, 100, 100, 100]\n\
    [limits]\nlow = [-900, -900, -50, 0, 0, 0]\nhigh = [900, 900, 50, 0, 0, 0]\n\
    [board]\nx = \"gpio0 gpio1\"\ny = \"gpio2 gpio3\"\nz = \"gpio4 gpio5\"\noutputs = \"1 gpio20\"\n\
    both_edges = true\npulse_us = 0.1\ndeadline_s = 0.4";

/// The board, for whoever looks at it.
pub type Shared = Arc<Mutex<Fake>>;

/// The line to a board that stands beside: its time goes on with each look.
struct Beside {
    board: Shared,
    since: Instant,
    pace: Pace,
    said: VecDeque<u8>,
}

impl Line for Beside {
    fn read(&mut self, into: &mut [u8], wait: Duration) -> Result<usize, LineError> {
        std::thread::sleep(wait.min(Duration::from_millis(1)));
        let mut board = self.board.lock().unwrap();
        let clock = board.clock_at(self.pace.at(self.since.elapsed().as_secs_f64()));
        board.run_to(clock);
        self.said.extend(board.take());
        let count = self.said.len().min(into.len());
        into.iter_mut().zip(self.said.drain(..count)).for_each(|(to, byte)| *to = byte);
        Ok(count)
    }

    fn write(&mut self, bytes: &[u8]) -> Result<(), LineError> {
        self.board.lock().unwrap().feed(bytes);
        Ok(())
    }
}

/// A server that drives a board.
pub fn shop() -> (Shop, Shared) {
    let mut fake = Fake::of_seed(1);
    fake.records = false;
    let board = Arc::new(Mutex::new(fake));
    let beside = board.clone();
    let opens = move || -> Result<Box<dyn Line>, String> {
        let (since, pace, said) = (Instant::now(), Pace::default(), VecDeque::new());
        Ok(Box::new(Beside { board: beside.clone(), since, pace, said }))
    };
    let (name, port) = ("klipper:beside".to_owned(), "beside".to_owned());
    let socket = queued::Socket { name, port, opens: Arc::new(opens) };
    let attach: super::Attach = Arc::new(move |workshop| {
        let machine = kerf_machine::file::read(&"board.toml".into(), FILE).unwrap();
        workshop.session.hold(machine);
        let (session, workspace) = (&mut workshop.session, &mut workshop.workspace);
        let place = Place::Queued(socket.clone());
        let attached =
            Controller::attach(place, First::default(), session, workspace, || false).unwrap();
        (workshop.controller, workshop.told) = (Some(attached.0), attached.1);
    });
    (start(Wanted { attach: Some(attach), ..Wanted::default() }), board)
}
