//! `kerf machine wire klipper:PORT`: asks which pin does what, turns each motor a little to be looked at, looks at
//! switches and outputs, and writes the machine's file.
//!
//! Nothing is written before the last answer: whoever answers `q`, or nothing any more, leaves all as it was.

mod trials;

use crate::commands::step_board::{introduced, socket};
use crate::commands::step_way::Way;
use crate::exit::{Exit, Usage};
use crate::machine_name::DriverName;
use crate::out;
use anyhow::{Result, anyhow, bail};
use kerf_control::controller::queued::Queued;
use kerf_machine::boards::{KnownBoard, Plug};
use kerf_machine::contradictions::contradictions;
use kerf_machine::settings::motors::Motor;
use kerf_machine::table;
use kerf_machine::{Actuator, Configuration, Machine, Value, file};
use kerf_program::{Axes, Axis, OutputReason};
use std::fs;
use std::io::{self, BufRead};
use std::path::Path;
use std::thread::sleep;
use std::time::Duration;

/// Way of a motor that is looked at, mm, and its speed, mm/s.
const LOOK_MM: f64 = 1.0;
const LOOK_MM_S: f64 = 2.0;
/// Time for which an output that is looked at is on.
const ON: Duration = Duration::from_secs(1);

/// Axes that are wired here, each with its settings of pins and of its home switch.
const AXES: [(Axis, &str, &str); 4] = [
    (Axis::X, "board.x", "board.home_x"),
    (Axis::Y, "board.y", "board.home_y"),
    (Axis::Z, "board.z", "board.home_z"),
    (Axis::A, "board.r", "board.home_a"),
];
/// A motor beside those of X, Y and Z.
struct Further {
    what: &'static str,
    motor: Motor,
    /// The setting that gives it its axis.
    role: &'static str,
    home: &'static str,
}

const FURTHER: [Further; 3] = [
    Further {
        what: "second motor of X",
        motor: Motor::Q,
        role: "motors.x2",
        home: "board.home_x2",
    },
    Further {
        what: "second motor of Y",
        motor: Motor::W,
        role: "motors.y2",
        home: "board.home_y2",
    },
    Further { what: "rotary axis A", motor: Motor::R, role: "motors.a", home: "board.home_a" },
];

/// Wires a board, beginning with what is known of the machine and with the pins of a board that is sold.
pub fn wire(
    name: &DriverName,
    mut machine: Configuration,
    into: &Path,
    known: Option<&KnownBoard>,
) -> Result<Exit> {
    if into.exists() {
        bail!(Usage(format!("{} is there already: name another file with --into", into.display())));
    }
    if let Some(known) = known {
        begins_with(name, known, &mut machine)?;
    }
    let mut wizard = Wizard { name, machine, board: None };
    let told = wizard.pins().and_then(|()| wizard.motors()).and_then(|()| wizard.switches());
    let told = told.and_then(|()| wizard.outputs()).and_then(|()| wizard.trials());
    drop(wizard.board.take());
    match told {
        Err(Ends::Failed(why)) => Err(anyhow!("{why}; nothing is written")),
        Err(Ends::Stopped) => {
            eprintln!("kerf: stopped; nothing is written");
            Ok(Exit::Stopped)
        }
        Ok(()) => {
            fs::write(into, file::write(&wizard.machine))?;
            let into = into.display();
            for crossed in contradictions(&wizard.machine) {
                eprintln!("kerf: mend in {into}: {}; {}", crossed.message, crossed.hint);
            }
            out::print(&format!(
                "written: {into}\nkerf run FILE --machine {name} --machine {into}\n"
            ));
            Ok(Exit::Good)
        }
    }
}

/// Fills the pins of a board that is sold, where the one at the port has its chip.
fn begins_with(name: &DriverName, known: &KnownBoard, machine: &mut Configuration) -> Result<()> {
    let introduced = introduced(&socket(name)?).map_err(|why| anyhow!("{name}: {why}"))?;
    let chip = introduced.dictionary.text("MCU").unwrap_or("unknown");
    if !known.may_have(chip) {
        let chips = known.chips.join(" or ");
        bail!(
            "{name}: the board has the chip {chip}, and the {} has {chips}: name the board that it is (kerf \
               machine boards), or wire it without --board",
            known.title
        );
    }
    known.fill(machine);
    let plugs =
        |plugs: &[Plug]| plugs.iter().map(|it| it.name.clone()).collect::<Vec<_>>().join(", ");
    let motors: Vec<_> = known.motors.iter().map(|it| &*it.name).collect();
    out::print(&format!(
        "{}: X, Y, Z are motors {}; outputs 1 and up are {}{}\n",
        known.title,
        motors[..motors.len().min(3)].join(", "),
        plugs(&known.outputs),
        known
            .servo
            .as_ref()
            .map(|it| format!("; for the speed of a spindle: {it}"))
            .unwrap_or_default()
    ));
    Ok(())
}

/// The reason for which it does not come to its end.
enum Ends {
    Stopped,
    Failed(String),
}

type Told<T = ()> = Result<T, Ends>;

struct Wizard<'a> {
    name: &'a DriverName,
    machine: Configuration,
    /// The board, once it is configured.
    board: Option<Queued>,
}

impl Wizard<'_> {
    /// Asks for pins until the board takes them.
    fn pins(&mut self) -> Told {
        loop {
            out::print(
                "Pins by the board's names (kerf machine connect lists them). ! turns a level round, ^ pulls up.\n\
                Enter keeps what stands in brackets, - takes it away, q stops.\n",
            );
            for ((axis, pins, home), motor) in AXES.into_iter().zip([Motor::X, Motor::Y, Motor::Z])
            {
                let letter = axis.letter();
                self.setting(&format!("motor {letter}, step and direction"), pins)?;
                self.setting(&format!("home switch of {letter}"), home)?;
                self.current(motor)?;
            }
            self.further()?;
            for (axis, _, home) in AXES {
                let is_fitted = !get(&self.machine, home).is_empty();
                self.machine.homing.switches[axis.index()].fitted = is_fitted;
            }
            self.setting("current of the motors", "board.enable")?;
            self.setting("outputs by number (1 gpio20, 2 gpio21)", "board.outputs")?;
            match self.opens() {
                Ok(()) => return Ok(()),
                Err(why) => out::print(&format!("{why}\n")),
            }
        }
    }

    /// Asks for a setting until it is one.
    fn setting(&mut self, what: &str, key: &str) -> Told {
        loop {
            let kept = get(&self.machine, key);
            let answer = ask(&format!("{what} [{kept}]: "))?;
            let value = match &*answer {
                "" => return Ok(()),
                "-" => "",
                other => other,
            };
            match put(&mut self.machine, key, value) {
                Ok(()) => return Ok(()),
                Err(why) => out::print(&format!("{why}\n")),
            }
        }
    }

    /// Asks for second motors and a rotary axis.
    fn further(&mut self) -> Told {
        if ask("Second motors of X and Y, or a rotary axis? y, n [n]: ")? != "y" {
            return Ok(());
        }
        for Further { what, motor, role, home } in FURTHER {
            let key = format!("board.{}", motor.word());
            self.setting(&format!("{what}, step and direction"), &key)?;
            let is_there = !get(&self.machine, &key).is_empty();
            let turned_by = if is_there { motor.word() } else { "none" };
            put(&mut self.machine, role, turned_by).map_err(Ends::Failed)?;
            if is_there {
                self.setting(&format!("home switch of {what}, - for none of its own"), home)?;
                self.current(motor)?;
            }
        }
        Ok(())
    }

    /// Turns the second motor of an axis round until both are seen to go one way.
    fn both(&mut self, axis: Axis) -> Told {
        let Some(second) = self.machine.motors.of_axis(axis).get(1).copied() else { return Ok(()) };
        let letter = axis.letter();
        loop {
            ask(&format!("{letter} goes {LOOK_MM} mm with both motors: Enter "))?;
            for to_mm in [LOOK_MM, 0.0] {
                self.way(Way { axis, to_mm, mm_s: LOOK_MM_S })?;
            }
            if ask("Did both go the same way? y, n [y]: ")? != "n" {
                return Ok(());
            }
            self.turn(&format!("board.{}", second.word()), 1)?;
            self.opens().map_err(Ends::Failed)?;
        }
    }

    /// Asks for the current of a motor whose driver is set by its registers.
    fn current(&mut self, motor: Motor) -> Told {
        let (motor, letter) = (motor.index(), motor.word().to_uppercase());
        if self.machine.drivers.kinds[motor].is_empty() {
            return Ok(());
        }
        loop {
            let kept = self.machine.drivers.current_a[motor];
            let answer = ask(&format!("current of {letter} while it turns, amperes [{kept}]: "))?;
            match (&*answer, answer.parse::<f64>()) {
                ("", _) => return Ok(()),
                (_, Ok(current_a)) if current_a > 0.0 => {
                    self.machine.drivers.current_a[motor] = current_a;
                    return Ok(());
                }
                _ => out::print("Name it as the motor has it printed, or less: 0.8\n"),
            }
        }
    }

    /// Opens the board with what is known by now: what only the host knows may change, pins may not.
    fn opens(&mut self) -> Result<(), String> {
        self.board = None;
        let socket = socket(self.name).map_err(|why| why.to_string())?;
        let mut board = socket.open(&self.machine, false)?;
        board.is_at(Axes::default());
        self.board = Some(board);
        Ok(())
    }

    fn board(&mut self) -> Told<&mut Queued> {
        self.board.as_mut().ok_or_else(|| Ends::Failed("the board is gone".into()))
    }

    fn way(&mut self, way: Way) -> Told {
        let machine = self.machine.clone();
        way.moves(self.board()?, &machine).map_err(Ends::Failed)
    }

    /// Turns each motor a little, until somebody has seen it go the right way.
    fn motors(&mut self) -> Told {
        let axes = self.board()?.axes();
        for (axis, key, _) in AXES.into_iter().filter(|(axis, ..)| axes.contains(*axis)) {
            let (letter, unit) = (axis.letter(), unit(axis));
            loop {
                ask(&format!("{letter} goes {LOOK_MM} {unit} towards plus: Enter "))?;
                self.way(Way { axis, to_mm: LOOK_MM, mm_s: LOOK_MM_S })?;
                let answer = ask("Did it? y, n for the other way, or how far in mm [y]: ")?;
                self.way(Way { axis, to_mm: 0.0, mm_s: LOOK_MM_S })?;
                let turns = match &*answer {
                    "" | "y" => break,
                    "n" => true,
                    other => match other.parse::<f64>() {
                        Ok(way_mm) if way_mm != 0.0 && way_mm.is_finite() => {
                            self.machine.program.resolution.steps_per_unit[axis] *=
                                LOOK_MM / way_mm.abs();
                            way_mm < 0.0
                        }
                        Ok(_) => {
                            out::print("Look at its pins, its wires and its current.\n");
                            false
                        }
                        Err(_) => {
                            out::print("Answer y, n, or a number of mm.\n");
                            continue;
                        }
                    },
                };
                if turns {
                    self.turn(key, 1)?;
                }
                self.opens().map_err(Ends::Failed)?;
            }
            self.both(axis)?;
        }
        Ok(())
    }

    /// Turns the level of a pin of a setting round.
    fn turn(&mut self, key: &str, pin: usize) -> Told {
        let text = get(&self.machine, key);
        let turned =
            |(n, word): (usize, &str)| if n == pin { turned(word) } else { word.to_owned() };
        let words: Vec<String> = text.split_whitespace().enumerate().map(turned).collect();
        put(&mut self.machine, key, &words.join(" ")).map_err(Ends::Failed)
    }

    /// Looks at each home switch, left alone and pressed.
    fn switches(&mut self) -> Told {
        for (axis, _, key) in AXES {
            let letter = axis.letter();
            while let Some(switch) = self.board()?.home_switch(axis) {
                let mut looks = [false; 2];
                let words = ["leave its home switch alone", "press it and hold it"];
                for (look, words) in looks.iter_mut().zip(words) {
                    ask(&format!("{letter}: {words}, Enter "))?;
                    let seen = self.board()?.is_on(switch);
                    *look = seen.ok_or_else(|| Ends::Failed("a switch is not told".into()))?;
                }
                match looks {
                    [false, true] => {
                        out::print(&format!("{letter}: its home switch is seen\n"));
                        break;
                    }
                    [true, false] => {
                        out::print(&format!("{letter}: its home switch is seen, turned round\n"));
                        self.turn(key, 0)?;
                        self.opens().map_err(Ends::Failed)?;
                        break;
                    }
                    _ if ask(
                        "Nothing changed: look at its pin and its wires. Again? y, n [y]: ",
                    )? == "n" =>
                    {
                        break;
                    }
                    _ => {}
                }
            }
        }
        Ok(())
    }

    /// Has each output go on for a moment.
    fn outputs(&mut self) -> Told {
        for number in self.board()?.outputs() {
            let answer =
                ask(&format!("Output {number} goes on for a second: Enter, s leaves it out: "))?;
            if answer == "s" {
                continue;
            }
            for on in [true, false] {
                let board = self.board()?;
                board.set(&Actuator::Output { number, on, why: OutputReason::Program });
                if on {
                    sleep(ON);
                }
                board.look();
                if let Some(fault) = board.fault() {
                    return Err(Ends::Failed(fault.message.clone()));
                }
            }
            if ask("Did it? y, n [y]: ")? == "n" {
                out::print(&format!("Output {number}: look at its pin in board.outputs.\n"));
            }
        }
        Ok(())
    }
}

/// Unit of the ways of an axis.
const fn unit(axis: Axis) -> &'static str {
    if matches!(axis, Axis::A) { "degrees" } else { "mm" }
}

/// A pin with its level turned round.
fn turned(pin: &str) -> String {
    if pin.contains('!') { pin.replace('!', "") } else { format!("!{pin}") }
}

fn get(machine: &Configuration, key: &str) -> String {
    let told = table::setting(key).map(|setting| setting.get(machine).to_string());
    told.unwrap_or_default().trim_matches('"').to_owned()
}

fn put(machine: &mut Configuration, key: &str, value: &str) -> Result<(), String> {
    let setting = table::setting(key).ok_or_else(|| format!("there is no setting {key}"))?;
    setting.set(machine, &Value::typed(value)).map_err(|why| why.to_string())
}

/// Asks, and returns the line that was typed.
fn ask(words: &str) -> Told<String> {
    out::print(words);
    let mut line = String::new();
    let count = io::stdin().lock().read_line(&mut line).unwrap_or_default();
    let answer = line.trim();
    if count == 0 || answer == "q" { Err(Ends::Stopped) } else { Ok(answer.to_owned()) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_level_is_turned_round_and_back() {
        assert_eq!(
            [turned("^gpio4"), turned("!^gpio4"), turned("^!PA1")],
            ["!^gpio4", "^gpio4", "^PA1"]
        );
    }
}
