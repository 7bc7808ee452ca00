//! A sequence as whoever runs programs sees it.

use crate::Sequence;
use crate::height::FAULTS;
use crate::small::Small;
use kerf_machine::lines::{Input, Output};
use kerf_machine::state::{Event, State};
use kerf_program::{
    At, Axes, Beam, Command, Frame, Halted, Host, Interpreter, Settings, Sourced, Status, Step,
    StoppedBy, Watch,
};
use std::sync::Arc;

impl Interpreter for Sequence {
    fn step(&mut self, host: &mut dyn Host, out: &mut Vec<Sourced>) -> Step {
        match &self.over {
            Some((status, diagnostic)) => Step::Done(*status, diagnostic.clone()),
            None => self.carry_on(host, out),
        }
    }

    fn run(&mut self, host: &mut dyn Host, out: &mut Vec<Sourced>, lines: u64) -> Step {
        for _ in 0..lines.max(1) {
            match self.step(host, out) {
                Step::Ran => {}
                other => return other,
            }
        }
        Step::Ran
    }

    fn fired(&mut self, halted: &Halted) {
        self.began = *halted;
    }

    fn interrupt(&mut self, watch: &Watch, _motion: Option<u64>, position: Axes) {
        let halted = Halted { stands: position, ..self.began };
        let Some(input) = Input::of_number(watch.input) else { return };
        for output in Output::ALL.iter().filter(|output| watch.drops.contains(&output.number())) {
            self.on &= !crate::sequence::bit(*output);
        }
        if input == Input::EmergencyStop && watch.on == self.machine.estop.active {
            self.halt(Event::EmergencyStop, "emergency stop", &halted);
        } else if self.came(input, halted.began) {
            self.position = position;
        } else {
            let noticed = FAULTS.iter().find(|(fault, _)| *fault == input);
            let why = match (noticed, input) {
                (Some((_, why)), _) => why,
                (None, Input::WHome) => "head too close",
                (None, _) => "arc lost",
            };
            self.halt(Event::Fault, why, &halted);
        }
    }

    fn takes_stops(&self) -> bool {
        true
    }

    fn stopped(&mut self, by: StoppedBy, halted: &Halted) {
        match by {
            StoppedBy::Operator => self.halt(Event::Stop, "", halted),
            StoppedBy::Input(number) => {
                self.halt(Event::StopInput, &format!("stop input {number}"), halted);
            }
            StoppedBy::Limit(number) => {
                self.halt(Event::Limit, &format!("stopped by limit input {number}"), halted);
            }
            StoppedBy::PowerCut => self.take_up(halted),
        }
    }

    fn comes_on(&self, halted: &Halted) -> Vec<u8> {
        self.comes_on_again(halted)
    }

    fn moved(&mut self, position: Axes) {
        self.position = position;
    }

    fn nudge(&mut self, _by: Axes) {}

    fn carried_out(&mut self, _motion: u64) {}

    fn stop(&mut self, _host: &mut dyn Host, out: &mut Vec<Sourced>) -> Step {
        self.all_off(out);
        self.end(Status::Stopped)
    }

    fn limit(&mut self, _host: &mut dyn Host, out: &mut Vec<Sourced>) -> Step {
        self.all_off(out);
        self.end(Status::Limit)
    }

    fn watches(&self) -> Vec<Watch> {
        let mut watches = self.watched_by_step();
        if !matches!(self.state, State::Emergency | State::EmergencyStopping) {
            watches.push(self.emergency());
        }
        watches
    }

    fn file_name(&self, file: u32) -> Option<Arc<str>> {
        (file == 0).then(|| self.job.name.clone())
    }

    fn call_stack(&self) -> Vec<At> {
        vec![self.at()]
    }

    fn motions(&self) -> u64 {
        self.motions
    }

    fn lines(&self) -> u64 {
        self.cut
    }

    fn settings(&self) -> &Arc<Settings> {
        &self.settings
    }

    fn frame(&self) -> &Frame {
        &self.frame
    }

    fn position(&self) -> Axes {
        self.position
    }

    fn variables(&self) -> Vec<(String, String)> {
        Vec::new()
    }
}

impl Sequence {
    /// Returns the inputs that the step at hand waits for, or that must not change during it.
    fn watched_by_step(&self) -> Vec<Watch> {
        let (arc, close) = (Input::EndBottomDelay.number(), Input::WHome.number());
        match self.steps.front() {
            Some(Small::Await(awaited)) => vec![Watch::level(awaited.input.number(), true, 0.0)],
            Some(Small::AwaitJig) => self.jig_watches().into(),
            Some(Small::Release) => vec![self.release()],
            Some(Small::Lower(_)) => vec![
                Watch::level(Input::ZHigh.number(), false, 0.0),
                Watch::level(Input::HeightSilent.number(), true, 0.0),
            ],
            Some(Small::Feel(_)) => vec![Watch::level(close, true, 0.0)],
            Some(Small::Follow) => {
                let mut watches = Vec::new();
                if self.machine.plasma.use_sequence {
                    watches.push(Watch::level(arc, false, self.machine.plasma.debounce_s));
                    watches.push(Watch::level(close, true, 0.0));
                }
                let faults = self.height_faults().iter();
                watches.extend(faults.map(|(input, _)| Watch::level(input.number(), true, 0.0)));
                watches
            }
            _ => Vec::new(),
        }
    }

    /// The emergency stop: cut outputs go off at once, the rest when the machine stands.
    fn emergency(&self) -> Watch {
        let cuts = [Output::Cut1, Output::Cut2, Output::Cut3];
        let (input, active) = (Input::EmergencyStop.number(), self.machine.estop.active);
        let drops = cuts.into_iter().map(Output::number).collect();
        Watch { drops, ..Watch::level(input, active, 0.0) }
    }

    /// The emergency stop is released.
    fn release(&self) -> Watch {
        Watch::level(Input::EmergencyStop.number(), !self.machine.estop.active, 0.0)
    }

    fn all_off(&mut self, out: &mut Vec<Sourced>) {
        for output in Output::ALL.iter().filter(|output| self.is_on(**output)) {
            self.give(Command::Output { number: output.number(), on: false }, out);
        }
        self.on = 0;
        self.give(Command::Beam(Beam::Off), out);
    }
}
