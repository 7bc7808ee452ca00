//! The turn at driving that goes on, and when whoever has it was heard last.

use crate::clock::Clock;
use crate::locks::lock;
use std::sync::Mutex;
use std::time::Duration;

/// Silence after which a script loses its turn at driving.
pub const SILENCE: Duration = Duration::from_secs(10);

/// The turn that goes on, as far as it is known.
#[derive(Debug)]
pub struct DrivingTurn {
    clock: Clock,
    inner: Mutex<Inner>,
}

#[derive(Debug, Default)]
struct Inner {
    /// Moment when whoever drives was heard last.
    heard: Duration,
    /// The turn in which what runs was begun.
    run_of: u32,
}

impl DrivingTurn {
    /// By a clock.
    pub fn by(clock: Clock) -> Self {
        Self { clock, inner: Mutex::default() }
    }

    /// Notes that whoever drives was heard.
    pub fn heard(&self) {
        lock(&self.inner).heard = self.clock.now();
    }

    /// Something begins in this turn.
    pub fn begins(&self, lease: u32) {
        lock(&self.inner).run_of = lease;
    }

    /// Returns `true` if whoever has this turn is not heard any more. While something of the turn runs it goes on.
    pub fn is_silent(&self, lease: u32, runs: bool) -> bool {
        let mut inner = lock(&self.inner);
        if runs && inner.run_of == lease {
            inner.heard = self.clock.now();
        }
        self.clock.now().saturating_sub(inner.heard) > SILENCE
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::people::script;
    use crate::testing::{Bench, bench};
    use kerf_wire::{Act, Role, Who, Why};

    /// A script drives, with the machine armed.
    fn scripted() -> (Bench, Who) {
        let bench = bench();
        let who = Who { client: script(7), role: Role::Operator, device: "script".into() };
        bench.does(&who, Act::TakeLease { force: true });
        bench.does(&who, Act::Arm { lease: bench.lease() });
        (bench, who)
    }

    fn drives(bench: &Bench) -> bool {
        bench.app.driving.end_silent_turn();
        bench.app.hub.read(|now| now.lease.is_some() && now.machine.armed)
    }

    #[test]
    fn a_script_that_is_not_heard_drives_no_longer() {
        let (bench, who) = scripted();
        for _ in 0..3 {
            bench.app.clock.forward(SILENCE * 9 / 10);
            assert!(drives(&bench));
            bench.does(&who, Act::Ping);
        }
        bench.app.clock.forward(SILENCE * 11 / 10);
        assert!(!drives(&bench));
        assert_eq!(bench.app.hub.read(|now| now.lease.clone()), None);
    }

    #[test]
    fn a_page_drives_as_long_as_it_is_there() {
        let bench = bench();
        bench.app.clock.forward(SILENCE * 100);
        assert!(drives(&bench));
    }

    #[test]
    fn a_script_drives_while_its_own_run_goes_on() {
        let (bench, who) = scripted();
        bench.does(&who, Act::Command { lease: bench.lease(), line: "MX,1".into() });
        bench.app.clock.forward(SILENCE * 100);
        assert!(drives(&bench));
        bench.stands();
        bench.app.clock.forward(SILENCE * 9 / 10);
        assert!(drives(&bench), "it counts from the end of the run");
        bench.app.clock.forward(SILENCE);
        assert!(!drives(&bench));
    }

    #[test]
    fn the_run_of_another_turn_keeps_no_script_at_the_wheel() {
        let bench = bench();
        bench.does(&bench.driver, Act::Command { lease: bench.lease(), line: "MX,1".into() });
        let who = Who { client: script(7), role: Role::Operator, device: "script".into() };
        bench.does(&who, Act::TakeLease { force: true });
        bench.does(&who, Act::Arm { lease: bench.lease() });
        bench.app.clock.forward(SILENCE * 2);
        assert!(!drives(&bench));
    }

    /// Two pages of one device, of which the first drives the armed machine.
    fn two_pages() -> (Bench, Who, Who) {
        let bench = bench();
        let [first, second] =
            [(); 2].map(|()| bench.app.pages.enter(Role::Setter, "tablet".into(), 7).unwrap().0);
        bench.does(&first, Act::TakeLease { force: true });
        bench.does(&first, Act::Arm { lease: bench.lease() });
        (bench, first, second)
    }

    #[test]
    fn a_turn_and_a_password_belong_to_a_page_and_not_to_its_device() {
        let (bench, first, second) = two_pages();
        let asks = |who: &Who, act| {
            bench.app.act(&bench.app.hears(who), act).map_err(|problem| problem.why)
        };
        let moves = || Act::Command { lease: bench.lease(), line: "MX,1".into() };
        assert_eq!(asks(&second, moves()), Err(Why::Lease), "the other page of the tablet");
        assert_eq!(asks(&second, Act::Arm { lease: bench.lease() }), Err(Why::Lease));
        bench.app.settings.unlocked.add(first.client);
        assert!(!bench.app.settings.unlocked.has(second.client));
        bench.app.driving.gone(second.client);
        assert!(drives(&bench), "the page that drives is there");
        assert!(asks(&first, moves()).is_ok());
    }

    #[test]
    fn the_other_page_of_a_device_stops_disarms_and_does_not_take_the_turn_over() {
        let (bench, first, second) = two_pages();
        bench.does(&second, Act::Stop);
        assert!(drives(&bench), "a stop disarms nothing");
        bench.does(&second, Act::Disarm);
        assert!(!drives(&bench));
        bench.does(&first, Act::Arm { lease: bench.lease() });
        bench.app.driving.gone(first.client);
        assert!(!drives(&bench), "nobody drives: the other page does not step in");
        assert_eq!(bench.app.hub.read(|now| now.lease.clone()), None);
    }

    #[test]
    fn a_device_that_is_revoked_loses_the_turn_of_each_of_its_pages() {
        for drives_at in [0, 1] {
            let (bench, first, second) = two_pages();
            let driver = [first, second][drives_at].clone();
            bench.does(&driver, Act::TakeLease { force: true });
            bench.does(&driver, Act::Arm { lease: bench.lease() });
            bench.app.settings.unlocked.add(driver.client);
            bench.app.revoke(7).unwrap();
            assert!(!drives(&bench) && !bench.app.settings.unlocked.has(driver.client));
            assert_eq!(bench.app.hub.read(|now| now.lease.clone()), None);
        }
    }

    #[test]
    fn a_device_that_is_revoked_has_nothing_of_the_machine() {
        let (bench, who) = scripted();
        bench.app.settings.unlocked.add(who.client);
        bench.app.revoke(7).unwrap();
        assert!(!drives(&bench));
        assert!(!bench.app.settings.unlocked.has(who.client));
        let page = bench.app.pages.enter(Role::Setter, "page".into(), 8).unwrap().0;
        bench.does(&page, Act::TakeLease { force: false });
        bench.does(&page, Act::Arm { lease: bench.lease() });
        bench.app.revoke(7).unwrap();
        assert!(drives(&bench), "it is another");
        bench.app.revoke(8).unwrap();
        assert!(!drives(&bench));
    }
}
