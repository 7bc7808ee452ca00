//! Turns at driving, and the arming of the machine.
//!
//! A turn that nobody gave up ends as well: that of a page by its going; that of a script, which has no connection that
//! could end, by its silence; and both when their device is revoked.

use crate::asker::Asker;
use crate::driving_turn::{DrivingTurn, SILENCE};
use crate::gate::{Demand, driven_by, pass};
use crate::hub::Hub;
use crate::machine::Link;
use crate::people::{Pages, is_script};
use crate::refusal::problem;
use kerf_wire::{Change, Lease, Machine, Problem, State, Who, Why};
use std::sync::atomic::{AtomicU32, Ordering};
use std::sync::{Arc, Weak};
use std::time::Duration;

/// Time between two looks whether a script is silent.
const LOOK: Duration = Duration::from_millis(250);

/// Turns at driving: who drives, and what ends with a turn.
pub struct Driving {
    hub: Arc<Hub>,
    link: Arc<Link>,
    pages: Arc<Pages>,
    turn: Arc<DrivingTurn>,
    /// Number of the last turn.
    leases: AtomicU32,
}

impl Driving {
    /// Nobody drives.
    pub fn new(hub: Arc<Hub>, link: Arc<Link>, pages: Arc<Pages>, turn: Arc<DrivingTurn>) -> Self {
        Self { hub, link, pages, turn, leases: AtomicU32::new(0) }
    }

    /// The machine is disarmed, whose stop has come already.
    pub fn tell_disarmed(&self, why: &str) {
        self.hub.changing(|now| {
            self.link.arrived().disarmed();
            vec![disarmed(&now.machine, why)]
        });
    }

    /// Arms the machine: until arming ends, orders of the driver may move it.
    ///
    /// # Errors
    /// It is in alarm.
    pub fn arm(&self) -> Result<(), Problem> {
        let mut alarm = false;
        self.hub.changing(|now| {
            alarm = now.machine.state == State::Alarm;
            let machine = Machine { armed: true, why: None, ..now.machine.clone() };
            if alarm { Vec::new() } else { vec![Change::Machine { machine }] }
        });
        if alarm { Err(problem(Why::State, "take note of the alarm first")) } else { Ok(()) }
    }

    /// Takes note of an alarm, which is over then; the machine is disarmed.
    pub fn acknowledge(&self) {
        self.hub.changing(|now| {
            if now.machine.state != State::Alarm {
                return Vec::new();
            }
            let machine = Machine { state: State::Idle, armed: false, ..now.machine.clone() };
            vec![Change::Machine { machine }]
        });
    }

    /// Takes the turn at driving; from somebody else only by force, and while nobody jogs.
    ///
    /// # Errors
    /// Somebody else drives.
    pub fn take_lease(&self, who: &Who, force: bool) -> Result<(), Problem> {
        let mut taken = Ok(());
        self.hub.changing(|now| {
            let jogs = now.machine.state == State::Jogging;
            match &now.lease {
                Some(lease) if lease.client == who.client => return Vec::new(),
                Some(lease) if !force || jogs => {
                    taken = Err(driven_by(lease));
                    return Vec::new();
                }
                Some(_) => self.link.forestall(),
                None => {}
            }
            let (number, device) =
                (self.leases.fetch_add(1, Ordering::Relaxed) + 1, who.device.clone());
            self.turn.heard();
            let lease = Some(Lease { number, client: who.client, device });
            // Whoever drives now has not armed it.
            let armed = now.machine.armed && now.lease.is_none();
            let machine = Machine { armed, ..now.machine.clone() };
            vec![Change::Lease { lease }, Change::Machine { machine }]
        });
        taken
    }

    /// Takes the lease away and disarms the machine; a job that runs goes on.
    pub fn drop_lease(&self, is_it: impl FnOnce(&Lease) -> bool, why: &str) {
        self.hub.changing(|now| {
            if !now.lease.as_ref().is_some_and(is_it) {
                return Vec::new();
            }
            self.link.forestall();
            self.link.release(|_| true);
            vec![Change::Lease { lease: None }, disarmed(&now.machine, why)]
        });
    }

    /// Tells pages who is connected, after somebody came or went.
    pub fn tell_clients(&self) {
        self.hub.change(vec![Change::Clients { clients: self.pages.list() }]);
    }

    /// A page has gone: its jog ends, and its turn at driving.
    pub fn gone(&self, client: u32) {
        self.link.release(|held| held.client == client);
        self.drop_lease(|lease| lease.client == client, "the controlling browser disconnected");
    }

    /// The same somebody as the one who drives, where that is a page or a script of the same device. What it may do
    /// stays that of its own role.
    pub fn at_wheel(&self, asker: &Asker) -> Asker {
        let own = self.pages.device_of(asker.who.client);
        let driver = self.hub.read(|now| now.lease.as_ref().map(|lease| lease.client));
        let same = driver.filter(|driver| own.is_some() && self.pages.device_of(*driver) == own);
        let client = same.unwrap_or(asker.who.client);
        asker.clone().by(client)
    }

    /// The number of somebody's turn at driving the machine, which is armed.
    ///
    /// # Errors
    /// Somebody else drives, or nobody, or the machine is disarmed.
    pub fn drives(&self, who: &Who) -> Result<u32, Problem> {
        self.hub.read(|now| {
            pass(now, who, Demand::GoOn)?;
            Ok(now.lease.as_ref().map_or(0, |lease| lease.number))
        })
    }

    /// Notes that a client was heard; it counts where that client drives.
    pub fn hears_driver(&self, who: &Who) {
        let drives = |now: &kerf_wire::Snapshot| {
            now.lease.as_ref().is_some_and(|lease| lease.client == who.client)
        };
        if self.hub.read(drives) {
            self.turn.heard();
        }
    }

    /// The turn of a script ends that is not heard any more.
    pub fn end_silent_turn(&self) {
        let runs = !matches!(self.hub.state(), State::Idle | State::Alarm);
        let why = format!("the controlling program was not heard for {} s", SILENCE.as_secs());
        self.drop_lease(
            |lease| is_script(lease.client) && self.turn.is_silent(lease.number, runs),
            &why,
        );
    }
}

/// Looks after the turns of scripts, as long as the server runs.
pub async fn watch(driving: Weak<Driving>) {
    while let Some(driving) = driving.upgrade() {
        driving.end_silent_turn();
        drop(driving);
        tokio::time::sleep(LOOK).await;
    }
}

/// The machine is disarmed from now on. The reason of an alarm is what a person has to know, whoever comes or goes.
fn disarmed(machine: &Machine, why: &str) -> Change {
    let alarm = machine.why.clone().filter(|_| machine.state == State::Alarm);
    let why = alarm.or_else(|| Some(why.to_owned()));
    Change::Machine { machine: Machine { armed: false, why, ..machine.clone() } }
}
