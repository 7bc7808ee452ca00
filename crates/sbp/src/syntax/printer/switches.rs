//! Spindle, coolant, outputs and dwells.

use super::file::SbpPrinter;
use kerf_program::{SpindleTurn, decimal};

pub(super) fn wait(p: &mut SbpPrinter<'_>, seconds: f64) {
    if seconds > 0.0 {
        p.line(&format!("PAUSE {}", decimal(seconds, 3)));
    }
}

pub(super) fn output(p: &mut SbpPrinter<'_>, number: u8, on: bool) {
    p.line(&format!("SO,{number},{}", u8::from(on)));
}

pub(super) fn spindle(p: &mut SbpPrinter<'_>, number: u8, rpm: f64) {
    let number = if number == 1 { String::new() } else { format!(",{number}") };
    p.line(&format!("TR,{}{number}", decimal(rpm, 3)));
}

/// The output that goes with it is a command of its own.
pub(super) fn turn(p: &mut SbpPrinter<'_>, turn: SpindleTurn) {
    match turn {
        SpindleTurn::Off | SpindleTurn::Clockwise => {}
        SpindleTurn::Counterclockwise => p.unsaid("a spindle that turns counter-clockwise (M4)"),
        SpindleTurn::Dynamic => p.unsaid("a laser whose power follows the speed (M4)"),
    }
}

pub(super) fn coolant(p: &mut SbpPrinter<'_>, wanted: [bool; 2]) {
    let before = std::mem::replace(&mut p.coolant, wanted);
    let outputs = [p.printing.mist_output, p.printing.flood_output];
    let names = [
        "mist (M7): --mist-output N names its output",
        "flood (M8): --flood-output N names its output",
    ];
    for i in 0..2 {
        match outputs[i] {
            _ if wanted[i] == before[i] => {}
            0 if wanted[i] => p.unsaid(names[i]),
            0 => {}
            number => output(p, number, wanted[i]),
        }
    }
}
