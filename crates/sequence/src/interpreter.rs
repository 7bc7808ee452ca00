//! A sequence as whoever runs programs sees it.

use crate::sequence::Sequence;
use crate::sheet::FAULTS;
use crate::watches;
use kerf_machine::lines::{Input, Output};
use kerf_machine::state::Event;
use kerf_program::{
    At, Axes, Frame, Halted, Host, Interpreter, Settings, Sourced, Status, Step as Stepped,
    StoppedBy, Watch,
};
use std::sync::Arc;

impl Interpreter for Sequence {
    fn step(&mut self, host: &mut dyn Host, out: &mut Vec<Sourced>) -> Stepped {
        match &self.over {
            Some((status, diagnostic)) => Stepped::Done(*status, diagnostic.clone()),
            None => self.carry_on(host, out),
        }
    }

    fn run(&mut self, host: &mut dyn Host, out: &mut Vec<Sourced>, lines: u64) -> Stepped {
        for _ in 0..lines.max(1) {
            match self.step(host, out) {
                Stepped::Ran => {}
                other => return other,
            }
        }
        Stepped::Ran
    }

    fn fired(&mut self, halted: &Halted) {
        self.halt.began = *halted;
    }

    fn interrupt(&mut self, watch: &Watch, _motion: Option<u64>, position: Axes) {
        let halted = Halted { stands: position, ..self.halt.began };
        let Some(input) = Input::of_number(watch.input) else { return };
        for output in Output::ALL.iter().filter(|output| watch.drops.contains(&output.number())) {
            self.head.switch(*output, false);
        }
        if input == Input::EmergencyStop && watch.on == self.setup.machine.estop.active {
            self.halt(Event::EmergencyStop, "emergency stop", &halted);
        } else if self.take_input(input, halted.began) {
            self.head.position = position;
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
        self.head.position = position;
    }

    fn nudge(&mut self, _by: Axes) {}

    fn carried_out(&mut self, _motion: u64) {}

    fn stop(&mut self, _host: &mut dyn Host, out: &mut Vec<Sourced>) -> Stepped {
        self.all_off(out);
        self.end(Status::Stopped)
    }

    fn limit(&mut self, _host: &mut dyn Host, out: &mut Vec<Sourced>) -> Stepped {
        self.all_off(out);
        self.end(Status::Limit)
    }

    fn watches(&self) -> Vec<Watch> {
        let Self { setup, start, sheet, queue, halt, .. } = self;
        watches::of(setup, start, sheet, queue, halt.state)
    }

    fn file_name(&self, file: u32) -> Option<Arc<str>> {
        (file == 0).then(|| self.setup.job.name.clone())
    }

    fn call_stack(&self) -> Vec<At> {
        vec![self.progress.at(&self.setup.job)]
    }

    fn motions(&self) -> u64 {
        self.head.motions
    }

    fn lines(&self) -> u64 {
        self.progress.cut
    }

    fn settings(&self) -> &Arc<Settings> {
        &self.setup.settings
    }

    fn frame(&self) -> &Frame {
        &self.setup.frame
    }

    fn position(&self) -> Axes {
        self.head.position
    }

    fn variables(&self) -> Vec<(String, String)> {
        Vec::new()
    }
}
