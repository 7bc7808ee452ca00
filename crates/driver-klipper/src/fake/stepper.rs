//! A stepper of the board: its queue, its pins, its count.

use super::board::Board;
use super::events::Event;
use super::words::Said;
use std::collections::VecDeque;

#[derive(Clone, Copy, Debug)]
struct Steps {
    interval: u32,
    count: u32,
    add: i32,
    dir: bool,
}

#[derive(Clone, Debug, Default)]
pub struct Stepper {
    pub step_pin: u32,
    pub dir_pin: u32,
    /// Each edge is a step.
    both: bool,
    idle_high: bool,
    pulse: u64,
    level: bool,
    pub dir: bool,
    next_dir: bool,
    /// Steps made forward less steps made backward.
    pub position: i64,
    /// Clock of the last step by the formula.
    grid: u64,
    /// A stop made the grid void.
    void: bool,
    active: Option<Steps>,
    queue: VecDeque<Steps>,
    /// The step pin stands at the level of a step.
    high: bool,
    earliest: u64,
    pub trsync: Option<u8>,
    /// Clock and direction of each step made.
    pub made: Vec<(u64, bool)>,
}

impl Board {
    pub fn config_stepper(&mut self, said: &Said) {
        let invert = said.n("invert_step");
        let idle_high = invert == 1;
        let stepper = Stepper {
            step_pin: said.clock("step_pin"),
            dir_pin: said.clock("dir_pin"),
            both: invert == 255,
            idle_high,
            level: idle_high,
            pulse: said.n("step_pulse_ticks") as u64,
            ..Stepper::default()
        };
        self.steppers.insert(said.n("oid") as u8, stepper);
    }

    pub fn queue_step(&mut self, said: &Said) {
        let oid = said.n("oid") as u8;
        let Some(stepper) = self.steppers.get_mut(&oid) else {
            return self.shut("Invalid oid type");
        };
        let count = said.n("count") as u32;
        if count == 0 {
            return self.shut("Invalid count parameter");
        }
        let steps = Steps {
            interval: said.clock("interval"),
            count,
            add: said.n("add") as i32,
            dir: stepper.next_dir,
        };
        if stepper.void {
            return;
        }
        if stepper.active.is_none() && !stepper.high {
            return self.load(oid, steps, true);
        }
        stepper.queue.push_back(steps);
        self.places += 1;
        self.most_places = self.most_places.max(self.places);
        if self.places > self.move_count {
            self.shut("Move queue overflow");
        }
    }

    fn load(&mut self, oid: u8, steps: Steps, idle: bool) {
        let now = self.now;
        let stepper = self.steppers.get_mut(&oid).unwrap();
        if stepper.dir != steps.dir {
            stepper.dir = steps.dir;
            stepper.earliest = stepper.earliest.max(now + stepper.pulse);
            let pin = stepper.dir_pin;
            self.edge(pin, steps.dir);
        }
        let stepper = self.steppers.get_mut(&oid).unwrap();
        stepper.active = Some(steps);
        let due = stepper.grid.wrapping_add(u64::from(steps.interval));
        if idle && (due < now || due - now >= 1 << 31) {
            return self.shut("Timer too close");
        }
        let margin = u64::from(self.frequency as u32 / 1000);
        if !idle && !stepper.both && due + margin < stepper.earliest {
            return self.shut("Stepper too far in past");
        }
        let at = if stepper.both { due } else { due.max(stepper.earliest) };
        stepper.grid = due;
        self.events.set(at, Event::Step(oid));
    }

    pub fn step(&mut self, oid: u8) {
        let now = self.now;
        let stepper = self.steppers.get_mut(&oid).unwrap();
        stepper.level = !stepper.level;
        let lost = self.loses.iter().position(|it| *it == (oid, stepper.made.len()));
        match lost {
            Some(lost) => _ = self.loses.remove(lost),
            None => {
                stepper.position += if stepper.dir { 1 } else { -1 };
                stepper.made.push((now, stepper.dir));
            }
        }
        let (pin, level) = (stepper.step_pin, stepper.level);
        if stepper.both {
            self.edge(pin, level);
            return self.after_step(oid);
        }
        stepper.high = true;
        let back = now + stepper.pulse;
        stepper.earliest = back + stepper.pulse;
        self.edge(pin, level);
        self.events.set(back, Event::Unstep(oid));
    }

    pub fn unstep(&mut self, oid: u8) {
        let stepper = self.steppers.get_mut(&oid).unwrap();
        stepper.level = stepper.idle_high;
        stepper.high = false;
        let (pin, level) = (stepper.step_pin, stepper.level);
        self.edge(pin, level);
        self.after_step(oid);
    }

    fn after_step(&mut self, oid: u8) {
        let stepper = self.steppers.get_mut(&oid).unwrap();
        let mut steps = stepper.active.take().unwrap();
        steps.count -= 1;
        if steps.count > 0 {
            steps.interval = steps.interval.wrapping_add(steps.add as u32);
            stepper.active = Some(steps);
            stepper.grid += u64::from(steps.interval);
            let at = if stepper.both { stepper.grid } else { stepper.grid.max(stepper.earliest) };
            self.events.set(at.max(self.now), Event::Step(oid));
            return;
        }
        if let Some(next) = stepper.queue.pop_front() {
            self.places -= 1;
            self.load(oid, next, false);
        }
    }

    pub fn set_next_dir(&mut self, said: &Said) {
        match self.steppers.get_mut(&(said.n("oid") as u8)) {
            Some(stepper) => stepper.next_dir = said.n("dir") != 0,
            None => self.shut("Invalid oid type"),
        }
    }

    pub fn reset_step_clock(&mut self, said: &Said) {
        let clock = self.at(said.clock("clock"));
        match self.steppers.get_mut(&(said.n("oid") as u8)) {
            Some(stepper) if stepper.active.is_some() || stepper.high => {
                self.shut("Can't reset time when stepper active");
            }
            Some(stepper) => {
                stepper.grid = clock;
                stepper.void = false;
            }
            None => self.shut("Invalid oid type"),
        }
    }

    pub fn is_stepping(&self, oid: u8) -> bool {
        self.steppers[&oid].active.is_some()
    }

    pub fn stop_stepper(&mut self, oid: u8) {
        self.events.drop(Event::Step(oid));
        self.events.drop(Event::Unstep(oid));
        let stepper = self.steppers.get_mut(&oid).unwrap();
        self.places -= stepper.queue.len();
        stepper.queue.clear();
        stepper.active = None;
        stepper.void = true;
        stepper.next_dir = false;
        stepper.trsync = None;
        let (dir, high) = (stepper.dir, stepper.high);
        (stepper.dir, stepper.high) = (false, false);
        let pins = (stepper.dir_pin, stepper.step_pin, stepper.idle_high);
        if high {
            stepper.level = stepper.idle_high;
        }
        if dir {
            self.edge(pins.0, false);
        }
        if high {
            self.edge(pins.1, pins.2);
        }
    }
}
