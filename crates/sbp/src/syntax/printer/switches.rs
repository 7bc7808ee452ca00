//! Spindle, coolant, outputs and dwells.

use super::SbpPrinter;
use kerf_program::{Turn, decimal};

impl SbpPrinter<'_> {
    pub(super) fn wait(&mut self, seconds: f64) {
        if seconds > 0.0 {
            self.line(&format!("PAUSE {}", decimal(seconds, 3)));
        }
    }

    pub(super) fn output(&mut self, number: u8, on: bool) {
        self.line(&format!("SO,{number},{}", u8::from(on)));
    }

    pub(super) fn spindle(&mut self, number: u8, rpm: f64) {
        let number = if number == 1 { String::new() } else { format!(",{number}") };
        self.line(&format!("TR,{}{number}", decimal(rpm, 3)));
    }

    /// The output that goes with it is a command of its own.
    pub(super) fn turn(&mut self, turn: Turn) {
        match turn {
            Turn::Off | Turn::Clockwise => {}
            Turn::Counterclockwise => self.unsaid("a spindle that turns counter-clockwise (M4)"),
            Turn::Dynamic => self.unsaid("a laser whose power follows the speed (M4)"),
        }
    }

    pub(super) fn coolant(&mut self, wanted: [bool; 2]) {
        let before = std::mem::replace(&mut self.coolant, wanted);
        let outputs = [self.printing.mist_output, self.printing.flood_output];
        let names = [
            "mist (M7): --mist-output N names its output",
            "flood (M8): --flood-output N names its output",
        ];
        for i in 0..2 {
            match outputs[i] {
                _ if wanted[i] == before[i] => {}
                0 if wanted[i] => self.unsaid(names[i]),
                0 => {}
                number => self.output(number, wanted[i]),
            }
        }
    }
}
