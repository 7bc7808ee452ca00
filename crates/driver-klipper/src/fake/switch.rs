//! The latch that stops steppers, and the switch that looks at a pin.

use super::board::Board;
use super::events::Event;
use super::words::Said;

#[derive(Clone, Debug, Default)]
pub struct Trsync {
    pub armed: bool,
    pub reason: u8,
    expire_reason: u8,
    report_ticks: u64,
}

#[derive(Clone, Debug, Default)]
pub struct Endstop {
    pin: u32,
    homing: bool,
    next: u64,
    found: u8,
    first: u64,
    sample_ticks: u64,
    sample_count: u8,
    rest_ticks: u64,
    value: bool,
    trsync: u8,
    reason: u8,
}

impl Board {
    pub fn trsync_start(&mut self, said: &Said) {
        let oid = said.n("oid") as u8;
        if !self.trsyncs.contains_key(&oid) {
            return self.shut("Invalid oid type");
        }
        self.events.drop(Event::Report(oid));
        self.events.drop(Event::Expire(oid));
        let report_ticks = said.n("report_ticks") as u64;
        let expire_reason = said.n("expire_reason") as u8;
        self.trsyncs.insert(oid, Trsync { armed: true, reason: 0, expire_reason, report_ticks });
        let held = |trsync: &Option<u8>| *trsync == Some(oid);
        self.steppers.values_mut().filter(|s| held(&s.trsync)).for_each(|s| s.trsync = None);
        if report_ticks > 0 {
            self.set_timer(said.clock("report_clock"), Event::Report(oid));
        }
    }

    pub fn stop_on_trigger(&mut self, said: &Said) {
        let trsync = said.n("trsync_oid") as u8;
        match self.steppers.get_mut(&(said.n("oid") as u8)) {
            Some(stepper) if stepper.trsync.is_some() => {
                self.shut("Can't add signal that is already active");
            }
            Some(stepper) => stepper.trsync = Some(trsync),
            None => self.shut("Invalid oid type"),
        }
    }

    pub fn trsync_set_timeout(&mut self, said: &Said) {
        let oid = said.n("oid") as u8;
        if self.trsyncs.get(&oid).is_some_and(|trsync| trsync.armed) {
            self.events.drop(Event::Expire(oid));
            self.set_timer(said.clock("clock"), Event::Expire(oid));
        }
    }

    pub fn trsync_trigger(&mut self, said: &Said) {
        let oid = said.n("oid") as u8;
        self.trigger(oid, said.n("reason") as u8, false);
        self.events.drop(Event::Report(oid));
        let reason = self.trsyncs[&oid].reason;
        self.say_trsync(oid, false, reason, 0);
    }

    pub fn expire(&mut self, oid: u8) {
        let reason = self.trsyncs[&oid].expire_reason;
        self.expired += u32::from(self.trsyncs[&oid].armed);
        self.trigger(oid, reason, true);
    }

    pub fn report(&mut self, oid: u8) {
        let Trsync { armed, reason, report_ticks, .. } = self.trsyncs[&oid];
        self.say_trsync(oid, armed, reason, self.now as u32);
        self.events.set(self.now + report_ticks, Event::Report(oid));
    }

    fn trigger(&mut self, oid: u8, reason: u8, tell: bool) {
        let Some(trsync) = self.trsyncs.get_mut(&oid).filter(|trsync| trsync.armed) else { return };
        (trsync.armed, trsync.reason) = (false, reason);
        self.events.drop(Event::Expire(oid));
        let held: Vec<u8> =
            self.steppers.iter().filter(|(_, s)| s.trsync == Some(oid)).map(|(o, _)| *o).collect();
        held.into_iter().for_each(|stepper| self.stop_stepper(stepper));
        if tell {
            self.say_trsync(oid, false, reason, self.now as u32);
        }
    }

    fn say_trsync(&mut self, oid: u8, armed: bool, reason: u8, clock: u32) {
        let fields = [
            ("oid", oid.into()),
            ("can_trigger", armed.into()),
            ("trigger_reason", reason.into()),
            ("clock", clock.into()),
        ];
        self.say("trsync_state", &fields);
    }

    pub fn config_endstop(&mut self, said: &Said) {
        let endstop = Endstop { pin: said.clock("pin"), ..Endstop::default() };
        self.endstops.insert(said.n("oid") as u8, endstop);
    }

    pub fn endstop_home(&mut self, said: &Said) {
        let oid = said.n("oid") as u8;
        self.events.drop(Event::Look(oid));
        let clock = self.at(said.clock("clock"));
        let Some(endstop) = self.endstops.get_mut(&oid) else {
            return self.shut("Invalid oid type");
        };
        endstop.sample_count = said.n("sample_count") as u8;
        endstop.homing = endstop.sample_count > 0;
        if !endstop.homing {
            return;
        }
        endstop.sample_ticks = said.n("sample_ticks") as u64;
        endstop.rest_ticks = said.n("rest_ticks") as u64;
        endstop.value = said.n("pin_value") != 0;
        endstop.trsync = said.n("trsync_oid") as u8;
        endstop.reason = said.n("trigger_reason") as u8;
        (endstop.found, endstop.next) = (0, clock);
        self.set_timer(said.clock("clock"), Event::Look(oid));
    }

    pub fn look(&mut self, oid: u8) {
        let now = self.now;
        let pin = self.endstops[&oid].pin;
        let level = self.level(pin);
        let endstop = self.endstops.get_mut(&oid).unwrap();
        if level != endstop.value {
            if endstop.found > 0 {
                endstop.next = endstop.first + endstop.rest_ticks;
                endstop.found = 0;
                while endstop.next <= now {
                    endstop.next += endstop.rest_ticks;
                }
            } else {
                endstop.next = now + endstop.rest_ticks;
            }
            let next = endstop.next;
            return self.events.set(next, Event::Look(oid));
        }
        if endstop.found == 0 {
            endstop.first = now;
            endstop.next = now + endstop.rest_ticks;
        }
        endstop.found += 1;
        if endstop.found < endstop.sample_count {
            let next = now + endstop.sample_ticks;
            return self.events.set(next, Event::Look(oid));
        }
        endstop.homing = false;
        let (trsync, reason) = (endstop.trsync, endstop.reason);
        self.trigger(trsync, reason, true);
    }

    pub fn say_endstop(&mut self, oid: u8) {
        let Some(endstop) = self.endstops.get(&oid).cloned() else {
            return self.shut("Invalid oid type");
        };
        let fields = [
            ("oid", oid.into()),
            ("homing", endstop.homing.into()),
            ("next_clock", (endstop.next as u32).into()),
            ("pin_value", self.level(endstop.pin).into()),
        ];
        self.say("endstop_state", &fields);
    }
}
