//! Spindle, coolant, outputs and dwells.

use super::Writer;
use kerf_program::{SpindleTurn, decimal};

/// Switches that are on, as far as it was written.
#[derive(Debug)]
pub(super) struct Switches {
    pub(super) turn: SpindleTurn,
    /// Mist and flood.
    coolant: [bool; 2],
}

impl Default for Switches {
    fn default() -> Self {
        Self { turn: SpindleTurn::Off, coolant: [false; 2] }
    }
}

impl Writer<'_> {
    pub(super) fn wait(&mut self, seconds: f64) {
        if seconds > 0.0 {
            self.line(&format!("G4 P{}", decimal(seconds, 3)));
        }
    }

    pub(super) fn output(&mut self, output: u8, on: bool) {
        let (mist, flood) = (self.writing.mist_output, self.writing.flood_output);
        let [has_mist, has_flood] = self.switches.coolant;
        if output == self.writing.spindle_output {
            // A program that told the direction has switched the output with it.
            match (on, self.switches.turn) {
                (true, SpindleTurn::Off) => self.turn(SpindleTurn::Clockwise),
                (false, turn) if turn != SpindleTurn::Off => self.turn(SpindleTurn::Off),
                _ => {}
            }
        } else if output == mist {
            self.coolant([on, has_flood]);
        } else if output == flood {
            self.coolant([has_mist, on]);
        } else if self.is_linuxcnc() {
            self.line(&format!("M6{} P{}", if on { 4 } else { 5 }, output.saturating_sub(1)));
        } else {
            self.unsaid(format!("output {output} {}", if on { "on" } else { "off" }));
        }
    }

    pub(super) fn pwm(&mut self, channel: u8, percent: f64) {
        let percent = decimal(percent, 3);
        if self.is_linuxcnc() {
            self.line(&format!("M68 E{} Q{percent}", channel.saturating_sub(1)));
        } else {
            self.unsaid(format!("channel {channel} at {percent} %"));
        }
    }

    pub(super) fn turn(&mut self, turn: SpindleTurn) {
        self.switches.turn = turn;
        self.line(match turn {
            SpindleTurn::Off => "M5",
            SpindleTurn::Clockwise => "M3",
            SpindleTurn::Counterclockwise | SpindleTurn::Dynamic => "M4",
        });
    }

    /// M9 ends both, so that what stays on is switched on again.
    pub(super) fn coolant(&mut self, wanted: [bool; 2]) {
        let before = std::mem::replace(&mut self.switches.coolant, wanted);
        let ends = (0..2).any(|i| before[i] && !wanted[i]);
        if ends {
            self.line("M9");
        }
        for (i, word) in ["M7", "M8"].into_iter().enumerate() {
            if !wanted[i] || before[i] && !ends {
                continue;
            }
            if word == "M7" && self.is_grbl() {
                self.unsaid("mist (M7): grbl has it only where it was built with it; --to grblhal writes it");
            } else {
                self.line(word);
            }
        }
    }

    pub(super) fn all_off(&mut self) {
        if self.switches.turn != SpindleTurn::Off {
            self.turn(SpindleTurn::Off);
        }
        self.coolant([false; 2]);
    }
}
