//! Requests from their arrival to their beginning: what was stopped in between does not begin.
//!
//! ```text
//!  act arrives ── Asker: stops so far ── waits its turn, reads files ── begins, unless one came since
//!                                                                         ▲
//!  Stop, Hold, Disarm, an alarm, the lease lost ── Link counts a stop ────┘
//! ```

use crate::asker::Asker;
use crate::driving_turn::DrivingTurn;
use crate::gate::{self, Demand};
use crate::hub::Hub;
use crate::locks::lock;
use crate::machine::link::{Held, Wanted};
use crate::machine::{Link, Order};
use crate::refusal::problem;
use kerf_wire::{Change, Machine, Problem, Snapshot, State, Why};
use std::sync::mpsc::Sender;
use std::sync::{Arc, Mutex};

/// The way to the machine's thread: orders for it, and requests about what it runs.
pub struct Orders {
    hub: Arc<Hub>,
    link: Arc<Link>,
    turn: Arc<DrivingTurn>,
    sender: Mutex<Sender<Order>>,
}

impl Orders {
    /// Orders that go into a channel.
    pub fn new(
        hub: Arc<Hub>,
        link: Arc<Link>,
        turn: Arc<DrivingTurn>,
        sender: Sender<Order>,
    ) -> Self {
        Self { hub, link, turn, sender: Mutex::new(sender) }
    }

    /// Gives the machine something to do that does not move it, when it has nothing to do.
    ///
    /// # Errors
    /// It is busy.
    pub fn order(&self, order: Order) -> Result<(), Problem> {
        self.give_out(None, order, State::Running, None)
    }

    /// Gives the machine something to do that somebody asked for, when it has nothing to do.
    ///
    /// # Errors
    /// It is busy; or was stopped since, or somebody else drives it by now, where it is to move.
    pub fn order_of(&self, asker: &Asker, order: Order) -> Result<(), Problem> {
        self.give_out(Some(asker), order, State::Running, None)
    }

    /// The same, for as long as a key is held.
    ///
    /// # Errors
    /// As [`Orders::order_of`].
    pub fn order_held(&self, asker: &Asker, order: Order, held: Held) -> Result<(), Problem> {
        self.give_out(Some(asker), order, State::Jogging, Some(held))
    }

    fn give_out(
        &self,
        asker: Option<&Asker>,
        order: Order,
        state: State,
        held: Option<Held>,
    ) -> Result<(), Problem> {
        let mut begun = Ok(());
        self.hub.changing(|now| {
            begun = self.may_begin(now, asker, &order, held);
            let machine = Machine { state, why: None, ..now.machine.clone() };
            if begun.is_ok() { vec![Change::Machine { machine }] } else { Vec::new() }
        });
        begun?;
        if asker.is_some() {
            self.turn.begins(self.hub.read(|now| now.lease.as_ref().map_or(0, |it| it.number)));
        }
        self.send(order)
    }

    /// Checks whether something may begin; if so, from here on a stop counts for it.
    fn may_begin(
        &self,
        now: &Snapshot,
        asker: Option<&Asker>,
        order: &Order,
        held: Option<Held>,
    ) -> Result<(), Problem> {
        if now.machine.state != State::Idle {
            return Err(problem(Why::State, "the machine is busy"));
        }
        if !order.moves() {
            self.link.begin(None, held);
            return Ok(());
        }
        let asker = asker.ok_or_else(|| problem(Why::Lease, "nobody asked for this"))?;
        gate::pass(now, &asker.who, Demand::Order(order))?;
        if self.link.begin(Some(asker.stops()), held) { Ok(()) } else { Err(stopped()) }
    }

    /// Wants something of what runs, as [`Orders::order_of`] where the machine goes on by it.
    ///
    /// # Errors
    /// The gate does not let it pass, or the machine was stopped since.
    pub fn want_of<T>(
        &self,
        asker: &Asker,
        demand: Demand<'_>,
        change: impl FnOnce(&mut Wanted) -> T,
    ) -> Result<T, Problem> {
        self.hub.read(|now| match gate::pass(now, &asker.who, demand)?.moves() {
            true => self.link.want_since(asker.stops(), change).ok_or_else(stopped),
            false => Ok(self.link.want(change)),
        })
    }

    /// Gives the machine's thread something to do, after what it does now.
    ///
    /// # Errors
    /// It has ended.
    pub fn send(&self, order: Order) -> Result<(), Problem> {
        let sent = lock(&self.sender).send(order);
        self.link.wake();
        sent.map_err(|_| problem(Why::Server, "the machine's thread has ended; start Kerf anew"))
    }
}

fn stopped() -> Problem {
    problem(Why::State, "stopped before it began: start it again")
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::handconsole::Happening;
    use crate::machine::Planned;
    use crate::testing::{Bench, bench};
    use kerf_machine::{Configuration, Errand, Keypad};
    use kerf_program::AXES;
    use kerf_sbp::FileParameters;
    use kerf_wire::Act;
    use std::sync::mpsc::{Sender, channel};

    fn command() -> Order {
        Order::Command { line: "MX,1".into(), opened: false, file: None, draws_only: false }
    }

    /// Every order that moves the machine.
    fn moving() -> Vec<Order> {
        let way = [1.0, 0.0, 0.0, 0.0, 0.0, 0.0];
        let keypad = Keypad { way, times: None, speed: 1.0, homed: Default::default() };
        let (tells, _): (Sender<Happening>, _) = channel();
        let machine = Box::<Configuration>::default();
        vec![
            Order::File {
                work: Box::new(kerf_sbp::read_typed("a".into(), "MX,1\n").into()),
                name: String::new(),
                hash: String::new(),
                planned: Planned::default(),
                parameters: FileParameters::default(),
                opened: false,
                draws_only: false,
            },
            Order::TakeUp { hash: None, planned: Planned::default() },
            command(),
            Order::Jog { direction: [1.0; AXES], distance: None, speed: 1.0 },
            Order::Hand { errand: Errand::Keypad(keypad), machine, tells },
            Order::Nudge(kerf_program::Axis::X, 1.0),
        ]
    }

    /// Checks that no motion begins if something happens at a bench after the motion arrived.
    #[track_caller]
    fn check(meanwhile: fn(&Bench), expected: Why) {
        for order in moving() {
            let (bench, name) = (bench(), format!("{order:?}"));
            let asker = bench.app.hears(&bench.driver);
            meanwhile(&bench);
            let refused = bench.app.orders.order_of(&asker, order).map_err(|problem| problem.why);
            assert_eq!(refused, Err(expected), "{name}");
            assert!(!bench.ordered(), "{name}");
            assert_eq!(bench.app.hub.state(), State::Idle, "{name}");
        }
    }

    #[test]
    fn what_arrived_before_a_stop_does_not_move_the_machine() {
        check(|bench| bench.does(&bench.other, Act::Stop), Why::State);
        check(|bench| bench.does(&bench.other, Act::Hold), Why::State);
    }

    #[test]
    fn what_arrived_before_a_disarm_does_not_move_the_machine() {
        let disarm = |bench: &Bench| bench.does(&bench.other, Act::Disarm);
        check(disarm, Why::Disarmed);
        check(
            |bench| {
                bench.does(&bench.other, Act::Disarm);
                bench.arms();
            },
            Why::State,
        );
    }

    #[test]
    fn what_arrived_before_the_lease_was_lost_does_not_move_the_machine() {
        let take = |bench: &Bench| bench.does(&bench.other, Act::TakeLease { force: true });
        check(take, Why::Lease);
        check(
            |bench| bench.does(&bench.driver, Act::GiveLease { lease: bench.lease() }),
            Why::Lease,
        );
        check(|bench| bench.app.driving.gone(bench.driver.client), Why::Lease);
        check(
            |bench| {
                bench.does(&bench.driver, Act::GiveLease { lease: bench.lease() });
                bench.does(&bench.driver, Act::TakeLease { force: false });
                bench.arms();
            },
            Why::State,
        );
    }

    #[test]
    fn what_nothing_stopped_begins() {
        for order in moving() {
            let bench = bench();
            let asker = bench.app.hears(&bench.driver);
            bench.app.driving.gone(bench.other.client);
            assert_eq!(bench.app.orders.order_of(&asker, order), Ok(()));
            assert!(bench.ordered());
        }
    }

    #[test]
    fn what_moves_nothing_begins_behind_a_stop() {
        let bench = bench();
        bench.does(&bench.driver, Act::Disarm);
        assert_eq!(bench.app.orders.order(Order::Watched), Ok(()));
        assert!(bench.ordered());
    }

    #[test]
    fn nobody_orders_a_move_without_having_asked() {
        let bench = bench();
        assert_eq!(
            bench.app.orders.order(command()).map_err(|problem| problem.why),
            Err(Why::Lease)
        );
        assert!(!bench.ordered());
    }

    #[test]
    fn a_resume_that_arrived_before_a_disarm_does_not_go_on() {
        let bench = bench();
        let asker = bench.app.hears(&bench.driver);
        assert!(bench.app.orders.want_of(&asker, Demand::GoOn, |_| ()).is_ok());
        bench.does(&bench.other, Act::Disarm);
        bench.arms();
        let refused = bench.app.orders.want_of(&asker, Demand::GoOn, |wanted| wanted.resume = true);
        assert_eq!(refused.map_err(|problem| problem.why), Err(Why::State));
        assert!(!bench.app.link.lock().resume);
    }

    #[test]
    fn a_stop_is_told_with_its_mend() {
        let bench = bench();
        let asker = bench.app.hears(&bench.driver);
        bench.does(&bench.other, Act::Stop);
        let act = Act::Command { lease: bench.lease(), line: "MX,1".into() };
        let refused = bench.app.act(&asker, act).unwrap_err();
        assert_eq!(refused.text, "stopped before it began: start it again");
    }
}
