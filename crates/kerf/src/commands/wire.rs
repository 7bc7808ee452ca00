//! `kerf machine wire klipper:PORT`: the wizard that wires a board, at a shell; it writes the machine's file.
//!
//! Nothing is written before the last answer: whoever answers `q`, or nothing any more, leaves all as it was.

use crate::commands::step_board::socket;
use crate::exit::{Exit, Usage};
use crate::machine_name::DriverName;
use crate::out;
use anyhow::{Result, anyhow, bail};
use kerf_control::controller::queued::wizard::{self, Ends, Looks, Question, Step, Watcher};
use kerf_machine::boards::KnownBoard;
use kerf_machine::contradictions::contradictions;
use kerf_machine::{Configuration, file};
use std::fs;
use std::io::{self, BufRead};
use std::path::Path;

/// Wires a board, beginning with what is known of the machine and with the pins of a board that is sold.
pub fn wire(
    name: &DriverName,
    machine: Configuration,
    into: &Path,
    known: Option<&KnownBoard>,
) -> Result<Exit> {
    if into.exists() {
        bail!(Usage(format!("{} is there already: name another file with --into", into.display())));
    }
    match wizard::wire(&socket(name)?, machine, known, &mut Shell) {
        Err(Ends::Failed(why)) => Err(anyhow!("{why}; nothing is written")),
        Err(Ends::Stopped) => {
            eprintln!("kerf: stopped; nothing is written");
            Ok(Exit::Stopped)
        }
        Ok(machine) => {
            fs::write(into, file::write(&machine))?;
            let into = into.display();
            for crossed in contradictions(&machine) {
                eprintln!("kerf: mend in {into}: {}; {}", crossed.message, crossed.hint);
            }
            out::print(&format!("written: {into}\nkerf run FILE --machine {into}\n"));
            Ok(Exit::Good)
        }
    }
}

/// Told before pins are asked for.
const PINS: &str = "Pins by the board's names (kerf machine connect lists them). ! turns a level round, ^ pulls up.\n\
    Enter keeps what stands in brackets, - takes it away, q stops.\n";

/// Whoever types at a shell.
struct Shell;

impl Watcher for Shell {
    fn ask(&mut self, question: &Question, _: &mut Looks<'_>) -> Option<String> {
        if question.step == Step::Motor && question.about == "X" {
            out::print(PINS);
        }
        out::print(&question.to_string());
        let mut line = String::new();
        let count = io::stdin().lock().read_line(&mut line).unwrap_or_default();
        (count > 0).then_some(line)
    }

    fn tell(&mut self, words: &str) {
        out::print(&format!("{words}\n"));
    }
}
