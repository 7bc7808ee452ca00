//! A board on the bench, at what is called zero from where it stands.

use crate::controller;
use crate::machine_name::DriverName;
use anyhow::{Result, anyhow, bail};
use kerf_control::controller::{Connection, Place, Socket};
use kerf_machine::conformance::{Bench, Seen};
use kerf_machine::{Going, Machine};
use kerf_motion::{Mover, Plan, plan_stack};
use kerf_program::{At, Axes, Feed, Line, MoveKind, Settings};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// A case takes no longer than this.
const PATIENCE: Duration = Duration::from_secs(60);

/// Between two looks at the board.
const GLANCE: Duration = Duration::from_millis(1);

/// The room that the list needs in plus X, mm.
const ROOM_MM: f64 = 50.0;

/// A board on the bench.
pub struct OnBench<M = Connection> {
    pub board: M,
    begin: Instant,
    /// Things that a case asked for, and that nobody can do on a bench.
    pub lacks: Option<&'static str>,
}

impl<M: Machine> OnBench<M> {
    /// A board for one case.
    pub fn new(board: M) -> Self {
        Self { board, begin: Instant::now(), lacks: None }
    }
}

impl<M: Machine> Bench for OnBench<M> {
    fn machine(&mut self) -> &mut dyn Machine {
        &mut self.board
    }

    fn waits(&mut self) -> bool {
        self.board.look();
        sleep(GLANCE);
        self.begin.elapsed() < PATIENCE
    }

    fn seen(&mut self) -> Option<Seen> {
        None
    }

    fn breaks(&mut self) -> bool {
        self.lacks = Some("nothing is broken on a bench");
        false
    }

    fn moves_switch(&mut self, _: bool) -> Option<u8> {
        self.lacks = Some("nobody moves a switch on a bench");
        None
    }
}

/// A way along X, mm.
#[derive(Clone, Copy)]
pub struct Way {
    pub from_mm: f64,
    pub to_mm: f64,
    pub kind: MoveKind,
    pub speed_mm_s: f64,
}

impl Way {
    fn plan(self) -> Plan {
        let mut settings = Settings::default();
        (settings.speeds.cut.xy, settings.speeds.jog.xy) = (self.speed_mm_s, self.speed_mm_s);
        let mut mover = Mover::new(Axes::xyz(self.from_mm, 0.0, 0.0), &settings);
        let to = Axes::xyz(self.to_mm, 0.0, 0.0);
        let line = mover.line(At::default(), &Line { kind: self.kind, to, feed: Feed::Axis });
        plan_stack(line.into_iter().collect(), &settings.ramps)
    }
}

/// Returns where a controller of this name hangs.
pub fn socket(name: &DriverName) -> Result<Socket> {
    match controller::socket(name) {
        Place::Followed(socket) => Ok(socket),
        Place::Queued(_) => {
            bail!("{name}: Kerf has no proof for boards with step queues yet, only for grbl")
        }
    }
}

impl OnBench {
    /// A board as it stands, at what is called zero from here on.
    pub fn as_it_stands(name: &DriverName) -> Result<Self> {
        let socket = socket(name)?;
        let (driver, line) = (socket.opens)().map_err(|why| anyhow!(why))?;
        let opened = Connection::open(&socket.name, driver, line);
        let mut connection = opened.map_err(|why| anyhow!(why))?;
        connection.is_at(Axes::default());
        Ok(Self::new(connection))
    }

    /// A board that takes orders, with room for the list.
    pub fn open(name: &DriverName) -> Result<Self> {
        let mut bench = Self::as_it_stands(name)?;
        if let Some(locked) = bench.board.locked() {
            bail!(locked);
        }
        if bench.lacks_room() {
            bail!("{name}: X needs {ROOM_MM} mm of room in plus: move it away from its end first");
        }
        Ok(bench)
    }

    fn lacks_room(&mut self) -> bool {
        let x_mm = self.board.stands().0[0];
        let most_mm = self.board.facts().travel_mm[0].map(|(_, most_mm)| most_mm);
        most_mm.is_some_and(|most_mm| x_mm + ROOM_MM > most_mm)
    }

    /// Goes home, and from there to where it has room.
    pub fn homes(&mut self) -> Result<()> {
        self.board.go_home(|| false).map_err(|why| anyhow!(why))?;
        self.board.is_at(Axes::default());
        if self.lacks_room() {
            let (to_mm, kind) = (-1.2 * ROOM_MM, MoveKind::Cut);
            self.goes(Way { from_mm: 0.0, to_mm, kind, speed_mm_s: 10.0 }, |_, _| {})?;
        }
        Ok(())
    }

    /// Goes a way to its end; in the middle of it something may be done. Returns how long it took, seconds.
    pub fn goes(
        &mut self,
        way: Way,
        mut midway: impl FnMut(&mut Connection, &Going<'_>),
    ) -> Result<f64> {
        let (plan, begin) = (way.plan(), Instant::now());
        let (mut now_s, end_s, mut is_due) = (0.0, plan.duration_s(), true);
        let watches = &[];
        let going = Going { plan: &plan, index: 0, t0_s: 0.0, until: 1, part: 1.0, watches };
        self.board.begin_plan();
        while now_s < end_s {
            now_s = self.board.advance(&going, now_s, end_s).reached_s.min(end_s);
            if is_due && now_s > 0.4 * end_s {
                is_due = false;
                midway(&mut self.board, &going);
            }
            self.goes_on()?;
        }
        while self.board.settle() {
            self.goes_on()?;
        }
        self.goes_on()?;
        Ok(begin.elapsed().as_secs_f64())
    }

    fn goes_on(&self) -> Result<()> {
        if let Some(fault) = self.board.fault() {
            bail!("{}", fault.message);
        }
        if self.begin.elapsed() > PATIENCE {
            bail!("it does not come to an end");
        }
        Ok(())
    }

    /// Looks at it for a while.
    pub fn looks(&mut self, seconds: f64) {
        let begin = Instant::now();
        while begin.elapsed().as_secs_f64() < seconds {
            self.board.look();
            sleep(GLANCE);
        }
    }

    /// Where X stands, mm.
    pub fn x_mm(&mut self) -> f64 {
        Machine::place(&mut self.board).map_or(f64::NAN, |place| place.0[0])
    }
}
