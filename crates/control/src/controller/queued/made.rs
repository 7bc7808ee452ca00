//! A board with step queues as the trait [`Machine`] has it.

use super::machine::{Queued, State};
use crate::controller::connection::NAP;
use crate::controller::lacks::out_of_reach;
use kerf_driver_klipper::desk::Request;
use kerf_machine::driver::Facts;
use kerf_machine::{Actuator, Fault, Going, Machine, News};
use kerf_motion::Move;
use kerf_program::{Axes, Axis, Beam, Settings};
use std::sync::Arc;
use std::time::Duration;

impl Machine for Queued {
    fn name(&self) -> &str {
        &self.name
    }

    fn facts(&self) -> &Facts {
        &self.facts
    }

    fn in_real_time(&self) -> bool {
        true
    }

    fn refuses(&self, mv: &Move) -> Option<String> {
        let axes = self.wiring.axes();
        let stays = |axis: &Axis| axes.contains(*axis) || mv.from[*axis] == mv.to[*axis];
        let lacks = Axis::ALL.into_iter().find(|axis| !stays(axis));
        let lacks = lacks.map(|axis| format!("has no motor of axis {}", axis.letter()));
        let why = lacks.or_else(|| out_of_reach(&self.facts, mv.from, mv.to, Axes::default()))?;
        Some(format!("{} {why}", self.name))
    }

    fn use_settings(&mut self, settings: &Arc<Settings>) {
        self.wiring.inputs.iter_mut().for_each(|input| input.follow(&settings.io));
    }

    fn begin(&mut self) {
        self.stood = None;
        self.check_drivers();
    }

    fn begin_plan(&mut self) {
        self.feeder.begin_plan();
    }

    fn set(&mut self, actuator: &Actuator) {
        match self.outputs.set(actuator, &self.wiring, &self.facts) {
            Ok(changes) => self.changes.extend(changes),
            Err(why) => self.fail(why, "", false),
        }
        self.feeder.follow = self.outputs.follow(&self.wiring);
        if self.is_made() {
            self.switch_now();
        }
    }

    fn beam(&mut self, beam: &Beam) {
        if let Some(changes) = self.outputs.shine(beam, &self.wiring) {
            self.changes.extend(changes);
            self.feeder.follow = self.outputs.follow(&self.wiring);
            if self.is_made() {
                self.switch_now();
            }
        }
    }

    fn advance(&mut self, going: &Going<'_>, from_s: f64, _: f64) -> News {
        (self.stood, self.at) = (None, going.made().map(|made| made.at));
        let end_s = going.t0_s + going.plan.span_s(going.index).1;
        if let Some(news) = self.touched(from_s, end_s) {
            return news;
        }
        if self.fault.is_some() {
            self.tend(NAP);
            return News { reached_s: from_s, input: None };
        }
        if self.late {
            let why = "the computer was late: the machine has slowed down on the path and stands";
            self.fail(why.into(), "its place is known: begin again at this line", false);
            return News { reached_s: from_s, input: None };
        }
        self.elsewhere = None;
        if !self.watches(going) {
            self.tend(NAP);
            return News { reached_s: from_s, input: self.inputs.pop_front() };
        }
        if !self.feeder.follow(going).is_empty() {
            self.count_anew();
        }
        let wait = if self.hand_on() { Duration::ZERO } else { NAP };
        if self.probe.is_armed() && self.feeder.rests {
            // Whether an input stopped it is known when its motion is over.
            self.berth.request(Request::LetRest);
        }
        self.tend(wait);
        if let Some(news) = self.touched(from_s, end_s) {
            return news;
        }
        let reached_s = self.reached_s(going);
        self.told_s = reached_s.min(end_s);
        News { reached_s, input: self.inputs.pop_front() }
    }

    fn stand(&mut self, from_s: f64, until_s: f64) -> News {
        let before = self.stood.filter(|(told_s, _)| *told_s == from_s);
        let (_, since_s) = before.unwrap_or((from_s, self.progress.at_s));
        self.switch_now();
        if until_s > from_s {
            self.tend(NAP);
        }
        let reached_s = (from_s + self.progress.at_s - since_s).min(until_s);
        self.stood = Some((reached_s, self.progress.at_s));
        News { reached_s, input: self.inputs.pop_front() }
    }

    fn tells(&mut self) -> Option<String> {
        self.told_drivers.take().or_else(|| self.lead_changed())
    }

    fn look(&mut self) {
        self.tend(Duration::ZERO);
    }

    fn settle(&mut self) -> bool {
        if self.homing.is_some() {
            return self.homes_on() || self.fault.is_some() && self.fault().is_none();
        }
        if self.fault.is_some() {
            self.tend(NAP);
            return self.fault().is_none();
        }
        if !self.is_made() {
            self.tend(NAP);
        }
        let made = self.is_made();
        if made {
            self.switch_now();
        }
        if made && std::mem::take(&mut self.late) {
            // Nothing of the plan follows: it was stopped.
            self.feeder.forget();
        }
        !made && self.fault().is_none()
    }

    fn home(&mut self) {
        self.begin_homing();
    }

    fn halt(&mut self) {
        self.drop_all();
        self.berth.request(Request::LetRest);
        if !self.wait_until(|it| it.state == State::Rest) {
            self.fail(
                "it does not say that it has stopped".into(),
                "press its emergency stop",
                true,
            );
        }
    }

    fn place(&mut self) -> Option<Axes> {
        self.elsewhere
    }

    fn stop(&mut self, going: &Going<'_>) -> Option<f64> {
        self.stands_s(going)
    }

    fn feed(&mut self, _: f32) {}

    fn give_up(&mut self) {
        let why = "it was stopped before it had made its last moves";
        self.fail(why.into(), "look why it was held", false);
    }

    fn fault(&self) -> Option<&Fault> {
        self.fault.as_ref().filter(|_| self.progress.at_s >= self.tells_s)
    }
}
