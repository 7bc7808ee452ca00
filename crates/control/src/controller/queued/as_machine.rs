//! A board with step queues as the trait [`Machine`] has it.

use super::height::Height;
use super::machine::{Queued, State};
use crate::controller::connection::NAP;
use crate::controller::lacks::out_of_reach;
use kerf_driver_klipper::mailbox::Request;
use kerf_machine::driver::Facts;
use kerf_machine::{Actuator, Fault, Going, LiftOfMove, Machine, News};
use kerf_motion::{Move, Plan, Span};
use kerf_program::{Axes, Axis, Beam, HeightLaw, Settings};
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
        self.follow_torch(settings);
    }

    fn begin(&mut self) {
        self.stood = None;
        self.check_drivers();
        self.measures(true);
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

    fn advance(&mut self, going: &Going<'_>, from_s: f64, until_s: f64) -> News {
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
        let height = self.feeder.height.as_ref().zip(going.made());
        self.probe.listens = height.is_some_and(|(height, made)| height.listens_in(made));
        let watches = self.own_watches(going);
        let going = &Going { watches: &watches, ..*going };
        if !self.watches(going) {
            self.tend(NAP);
            return News { reached_s: from_s, input: self.inputs.pop_front() };
        }
        if !self.feeder.follow(going).is_empty() {
            self.count_anew();
        }
        // Where no time is to pass the plan is about to be left: nothing more of it is handed over.
        let hands = until_s > from_s || end_s <= from_s;
        let wait = if hands && self.hand_on() { Duration::ZERO } else { NAP };
        if self.probe.is_armed() && self.feeder.rests {
            // Whether an input stopped it is known when its motion is over.
            self.port.request(Request::LetRest);
        }
        self.tend(wait);
        if let Some(news) = self.touched(from_s, end_s) {
            return news;
        }
        let reached_s = self.reached_s(going);
        let reached_s = if hands { reached_s } else { reached_s.max(from_s) };
        if let Some((at_s, input)) = self.sensor.take() {
            // What readings tell is known sooner than that nothing else has stopped the machine.
            let reached_s = reached_s.min(end_s).max(at_s.clamp(from_s, end_s));
            self.told_s = reached_s;
            return News { reached_s, input: Some(input) };
        }
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
        let reached_s = (from_s + (self.progress.at_s - since_s)).min(until_s);
        self.stood = Some((reached_s, self.progress.at_s));
        News { reached_s, input: self.inputs.pop_front() }
    }

    fn made(&mut self, t0_s: f64, _: &Plan, span: &Span<'_>) -> LiftOfMove {
        let height = self.feeder.height.as_mut();
        height.map_or_else(LiftOfMove::default, |it| it.made([t0_s + span.t0_s, t0_s + span.t1_s]))
    }

    fn height_control(&mut self, law: Option<HeightLaw>, _: &Axes) -> Vec<(u8, bool)> {
        self.follow_sheet(law)
    }

    fn land(&mut self) {
        self.feeder.height.iter_mut().for_each(Height::land);
    }

    fn tells(&mut self) -> Option<String> {
        let behind = self.sensor.tells(&self.name, self.feeder.height.as_ref());
        self.told_drivers.take().or(behind).or_else(|| {
            let moves = matches!(self.state, State::Moving(..));
            moves.then(|| self.lead.changed(&self.name, self.progress.lead_s)).flatten()
        })
    }

    fn changed_input(&mut self) -> Option<(u8, bool)> {
        self.inputs.pop_front()
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
        self.port.request(Request::LetRest);
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
