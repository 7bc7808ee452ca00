//! A board with step queues as a machine, in simulated time: the list that every machine has to hold.

use kerf_control::controller::queued::{BoardPort, Queued, Wiring};
use kerf_control::{Requests, RunContext, Session};
use kerf_driver_klipper::board::{News, Options};
use kerf_driver_klipper::crew::Crew;
use kerf_driver_klipper::fake::{Board as Fake, Faults, Wired};
use kerf_driver_klipper::mailbox::{Answer, Mailbox, Progress, Request};
use kerf_files::MemoryDisk;
use kerf_journal::RunOptions;
use kerf_machine::conformance::{Bench, CASES, Case, Outcome, Seen};
use kerf_machine::settings::board::Board;
use kerf_machine::{Configuration, Driven, Machine};
use kerf_program::{Axes, Axis};
use kerf_trace::{Sink, Summary};
use kerf_workspace::Workspace;
use std::cell::RefCell;
use std::ops::{Deref, DerefMut};
use std::panic::resume_unwind;
use std::rc::Rc;
use std::time::Duration;

/// Grain of simulated time, seconds.
const GRAIN_S: f64 = 0.001;
/// A case that takes longer does not come to its end, seconds.
const PATIENCE_S: f64 = 60.0;

/// The machine's file of the tests.
const FILE: &str = "[steps]\nper_unit = [100, 100, 200, 100, 100, 100]\n[board]\nx = \"gpio0 gpio1\"\n\
    y = \"gpio2 gpio3\"\nz = \"gpio4 gpio5\"\noutputs = \"1 gpio20\"\nspindle = \"gpio21\"\ninputs = \"3 gpio22\"\n\
    both_edges = true\npulse_us = 0.1";

pub fn machine() -> Configuration {
    machine_of(FILE)
}

pub fn machine_of(file: &str) -> Configuration {
    kerf_machine::file::read(&"board.toml".into(), file).unwrap()
}

/// A switch that closes below a count of a motor of another board: board and pin, board and motor, count.
pub type Far = ((usize, u32), (usize, u8), i64);

/// Pins with their levels.
pub type Levels = Vec<(u32, bool)>;

/// A host, and boards that are none with their lines.
pub struct World {
    /// The boards, the first one first.
    pub wired: Vec<Wired>,
    pub mailbox: Mailbox,
    pub now_s: f64,
    /// The host does nothing up to a moment.
    pub stalls_until_s: f64,
    /// The host is killed at a moment.
    pub dies_s: f64,
    pub far: Vec<Far>,
    /// Share of the full voltage at all pins that measure one, by the places of the motors.
    pub voltage: Option<fn(&Fake) -> f64>,
    /// Levels of pins, by the places of the motors.
    pub levels: Option<fn(&Fake) -> Levels>,
    heard: Vec<Answer>,
}

impl Deref for World {
    type Target = Wired;

    fn deref(&self) -> &Wired {
        &self.wired[0]
    }
}

impl DerefMut for World {
    fn deref_mut(&mut self) -> &mut Wired {
        &mut self.wired[0]
    }
}

/// A host that knows nothing of its boards yet.
fn mailbox(wiring: &Wiring, board: &Board, now_s: f64) -> Mailbox {
    let (deadline_s, error_s) = (board.deadline_s, 1e-6 * board.error_us);
    // Somebody has looked why a board is shut down.
    let clears = now_s > 0.0;
    let options = Options { linger_s: 1.0, error_s, deadline_s, clears };
    let crew = Crew::new(&wiring.setup, &wiring.pins.boards, options, now_s);
    Mailbox::new(crew.expect("a setup"))
}

impl World {
    pub fn new(seed: u64, faults: Faults, wiring: &Wiring, board: &Board) -> Self {
        let seeds = (seed..).take(wiring.pins.boards.len());
        let wired = seeds.map(|seed| Wired::new(seed, faults)).collect();
        let mailbox = mailbox(wiring, board, 0.0);
        let (stalls_until_s, dies_s) = (0.0, f64::INFINITY);
        let (far, voltage, levels, heard) = (Vec::new(), None, None, Vec::new());
        Self { wired, mailbox, now_s: 0.0, stalls_until_s, dies_s, far, voltage, levels, heard }
    }

    /// Another host has the boards from now on.
    pub fn begin_anew(&mut self, wiring: &Wiring, board: &Board) {
        self.mailbox = mailbox(wiring, board, self.now_s);
        (self.stalls_until_s, self.dies_s) = (0.0, f64::INFINITY);
        self.heard.clear();
    }

    /// The host is dead: it does nothing more, and nothing that it still wants is done.
    pub fn is_dead(&self) -> bool {
        self.now_s >= self.dies_s
    }

    /// Lets a grain of time go by.
    pub fn pass(&mut self) {
        self.now_s += GRAIN_S;
        let (now_s, sleeps) = (self.now_s, self.now_s < self.stalls_until_s || self.is_dead());
        for (n, wired) in self.wired.iter_mut().enumerate() {
            let crew = self.mailbox.crew();
            wired.pass(now_s, sleeps, |heard| {
                crew.receive(n, heard, now_s);
                crew.transmit(n, now_s).bytes
            });
        }
        for ((board, pin), (of, motor), count) in self.far.clone() {
            let is_on = self.wired[of].fake.steppers[&motor].position < count;
            let fake = &mut self.wired[board].fake;
            fake.driven.insert(pin, vec![(fake.now, is_on)]);
        }
        if let Some(voltage) = self.voltage {
            let fake = &mut self.wired[0].fake;
            let reading = (voltage(fake).clamp(0.0, 1.0) * 4095.0).round() as u32;
            let pins: Vec<u32> = fake.analogs.values().map(|analog| analog.pin).collect();
            fake.voltages.extend(pins.into_iter().map(|pin| (pin, reading)));
        }
        if let Some(levels) = self.levels {
            let fake = &mut self.wired[0].fake;
            let now = fake.now;
            let levels = levels(fake).into_iter().map(|(pin, is_on)| (pin, vec![(now, is_on)]));
            fake.driven.extend(levels);
        }
        if !sleeps {
            self.heard.extend(self.mailbox.answers());
        }
    }

    /// Ends whatever the host does, where it is dead.
    fn mourn(&self) {
        if self.is_dead() {
            resume_unwind(Box::new("the host is killed"));
        }
    }

    /// Waits until the boards are ready: the versions of their programs, and the counts of their motors.
    pub fn ready(&mut self) -> (String, Vec<i64>) {
        for _ in 0..20_000 {
            self.pass();
            self.mourn();
            let heard = std::mem::take(&mut self.heard);
            let faults = heard.iter().find(|answer| matches!(answer, Answer::News(News::Fault(_))));
            assert!(faults.is_none(), "the board is not ready: {faults:?}");
            let ready = heard.into_iter().find_map(|answer| match answer {
                Answer::News(News::Ready { version, counts }) => Some((version, counts)),
                _ => None,
            });
            if let Some(ready) = ready {
                return ready;
            }
        }
        panic!("the board is not ready");
    }
}

/// The world as the machine reaches it.
pub struct Virtual(pub Rc<RefCell<World>>);

impl BoardPort for Virtual {
    fn request(&mut self, request: Request) {
        let world = &mut *self.0.borrow_mut();
        if !world.is_dead() {
            world.mailbox.take(request, world.now_s);
        }
    }

    fn look(&mut self, wait: Duration) -> (Progress, Vec<Answer>) {
        let world = &mut *self.0.borrow_mut();
        let until_s = world.now_s + wait.as_secs_f64();
        while world.now_s < until_s || world.now_s < world.stalls_until_s {
            world.pass();
            world.mourn();
        }
        world.heard.extend(world.mailbox.answers());
        (world.mailbox.progress(world.now_s), std::mem::take(&mut world.heard))
    }
}

/// A machine of a world.
pub struct Shop {
    pub world: Rc<RefCell<World>>,
    pub queued: Queued,
    begin_s: f64,
}

impl Shop {
    /// The line is good until the board is known.
    pub fn new(seed: u64, faults: Faults) -> Self {
        Self::of(&machine(), seed, faults, |_| {})
    }

    /// One of another machine, whose board is prepared.
    pub fn of(
        machine: &Configuration,
        seed: u64,
        faults: Faults,
        prepares: impl Fn(&mut Fake),
    ) -> Self {
        let wiring = Wiring::of(machine).unwrap();
        let mut world = World::new(seed, Faults::default(), &wiring, &machine.board);
        world.wired.iter_mut().for_each(|wired| prepares(&mut wired.fake));
        let (version, counts) = world.ready();
        world.wired.iter_mut().for_each(|wired| wired.spoil(faults));
        let begin_s = world.now_s;
        let world = Rc::new(RefCell::new(world));
        let per_unit = machine.program.resolution.steps_per_unit;
        let port = Box::new(Virtual(world.clone()));
        let queued = Queued::new("board", &version, (wiring, per_unit), counts, port);
        Self { world, queued, begin_s }
    }
}

impl Bench for Shop {
    fn machine(&mut self) -> &mut dyn Machine {
        &mut self.queued
    }

    fn waits(&mut self) -> bool {
        self.world.borrow_mut().pass();
        self.world.borrow().now_s < self.begin_s + PATIENCE_S
    }

    fn seen(&mut self) -> Option<Seen> {
        let world = self.world.borrow();
        let x_mm = world.fake.steppers[&0].position as f64 / 100.0;
        let mut place = Axes::default();
        place[Axis::X] = x_mm;
        let mut outputs = world.wired.iter().flat_map(|wired| wired.fake.outputs.values());
        let turns = outputs.any(|output| output.value > 0);
        Some(Seen { place, turns })
    }

    fn breaks(&mut self) -> bool {
        self.world.borrow_mut().fake.shut("ADC out of range");
        true
    }
}

/// A run that is over.
pub struct Ran {
    pub summary: Summary,
    pub session: Session,
    pub queued: Rc<RefCell<Queued>>,
}

/// Runs lines of a part file on a machine, with somebody who asks for something meanwhile.
pub fn ran(
    queued: Queued,
    machine: Configuration,
    lines: &str,
    sink: &mut dyn Sink,
    requests: &mut dyn Requests,
) -> Ran {
    let mut session = Session::default();
    session.hold(machine);
    let mut workspace = Workspace::in_memory(MemoryDisk::default());
    let program = kerf_sbp::read("part.sbp".into(), lines.as_bytes());
    let queued = Rc::new(RefCell::new(queued));
    let driven: Driven = queued.clone();
    let context = RunContext { sink, operator: &mut (), requests, machine: driven.into() };
    let summary = session.run(program, RunOptions::default(), &mut workspace, context);
    Ran { summary, session, queued }
}

fn outcome(seed: u64, faults: Faults, case: &Case) -> Result<Outcome, String> {
    case.run(&mut Shop::new(seed, faults))
}

#[test]
fn a_board_on_a_good_line_holds_what_every_machine_has_to_hold() {
    for case in CASES {
        assert_eq!(outcome(1, Faults::default(), case), Ok(Outcome::Held), "{}", case.name);
    }
}

#[test]
fn a_board_on_a_bad_line_does_what_it_is_asked_for_or_tells_that_it_does_not() {
    for share in [0.01, 0.05, 0.3] {
        for seed in 0..4 {
            for case in CASES {
                let told = outcome(seed, Faults::all(share / 6.0), case);
                assert!(told.is_ok(), "{}, seed {seed}, {share}: {told:?}", case.name);
            }
        }
    }
}
