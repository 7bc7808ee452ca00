//! The wizard that wires a board: asks which pin does what, turns each motor a little to be looked at, looks at switches and
//! outputs, tries speeds, and gives the machine's configuration.
//!
//! ```text
//!  shell ───┐ Watcher: ask, tell, stop          ┌─ Socket ─► board
//!  page ────┴───────────────────► Wizard ───────┴─ Configuration
//! ```
//!
//! It knows nobody who answers: a shell and a page are both a [`Watcher`]. It takes its time, so it has a thread of its own.

mod question;
mod switches;
mod torch;
mod trials;

pub use question::{LOOK_MM, Question, Step};
pub use switches::Seen;

use super::attached::Socket;
use super::axis_move::AxisMove;
use super::introduced::introduced;
use super::machine::Queued;
use kerf_machine::boards::{KnownBoard, Plug};
use kerf_machine::settings::motors::Motor;
use kerf_machine::table;
use kerf_machine::{Actuator, Configuration, Machine, Value};
use kerf_program::{Axes, Axis, OutputReason};
use std::fmt::Display;
use std::thread::sleep;
use std::time::Duration;

/// Looks at the switches of the board; nothing where it is lost.
pub type Looks<'a> = dyn FnMut() -> Option<Vec<Seen>> + 'a;

/// Whoever sits before the machine.
pub trait Watcher {
    /// Asks, and waits for the answer: `y`, `n`, a pin, a number, nothing for what stands. Without one it is over. Meanwhile
    /// it may show switches as they are.
    fn ask(&mut self, question: &Question, looks: &mut Looks<'_>) -> Option<String>;

    /// Tells a sentence.
    fn tell(&mut self, words: &str);

    /// The machine is to stop at once.
    fn is_stopped(&self) -> bool {
        false
    }
}

/// The reason for which the wizard does not come to its end.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Ends {
    /// Somebody wanted no more.
    Stopped,
    /// It cannot go on, in words.
    Failed(String),
}

type Told<T = ()> = Result<T, Ends>;

/// Speed of a motor that is looked at, mm/s.
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
    /// The step that asks for it, and what it is about.
    asks: (Step, &'static str),
    motor: Motor,
    /// The setting that gives it its axis.
    role: &'static str,
    home: &'static str,
}

const FURTHER: [Further; 3] = [
    Further {
        asks: (Step::SecondMotor, "X"),
        motor: Motor::Q,
        role: "motors.x2",
        home: "board.home_x2",
    },
    Further {
        asks: (Step::SecondMotor, "Y"),
        motor: Motor::W,
        role: "motors.y2",
        home: "board.home_y2",
    },
    Further { asks: (Step::Motor, "A"), motor: Motor::R, role: "motors.a", home: "board.home_a" },
];

/// Wires a board, beginning with what is known of the machine and with the pins of a board that is sold. Returns the machine
/// as it is wired then, with the board as its controller.
///
/// # Errors
/// Somebody stopped it, or the board cannot be wired so.
pub fn wire(
    socket: &Socket,
    mut machine: Configuration,
    known: Option<&KnownBoard>,
    watcher: &mut dyn Watcher,
) -> Result<Configuration, Ends> {
    if let Some(known) = known {
        let told = begins_with(socket, known, &mut machine).map_err(Ends::Failed)?;
        watcher.tell(&told);
    }
    let mut wizard = Wizard { socket, machine, board: None, watcher };
    wizard.pins()?;
    wizard.motors()?;
    wizard.switches()?;
    wizard.outputs()?;
    wizard.trials()?;
    let mut machine = wizard.machine;
    machine.options.controller.clone_from(&socket.name);
    Ok(machine)
}

/// Fills the pins of a board that is sold, where the one at the port has its chip.
fn begins_with(
    socket: &Socket,
    known: &KnownBoard,
    machine: &mut Configuration,
) -> Result<String, String> {
    let introduced = introduced(socket).map_err(|why| format!("{}: {why}", socket.name))?;
    let chip = introduced.dictionary.text("MCU").unwrap_or("unknown");
    if !known.may_have(chip) {
        let chips = known.chips.join(" or ");
        return Err(format!(
            "{}: the board has the chip {chip}, and the {} has {chips}: name the board that it is (kerf \
               machine boards), or wire it without --board",
            socket.name, known.title
        ));
    }
    known.fill(machine);
    let plugs =
        |plugs: &[Plug]| plugs.iter().map(|it| it.name.clone()).collect::<Vec<_>>().join(", ");
    let motors: Vec<_> = known.motors.iter().map(|it| &*it.name).collect();
    let servo = known.servo.as_ref();
    Ok(format!(
        "{}: X, Y, Z are motors {}; outputs 1 and up are {}{}",
        known.title,
        motors[..motors.len().min(3)].join(", "),
        plugs(&known.outputs),
        servo.map(|it| format!("; for the speed of a spindle: {it}")).unwrap_or_default()
    ))
}

struct Wizard<'a, 'w> {
    socket: &'a Socket,
    machine: Configuration,
    /// The board, once it is configured.
    board: Option<Queued>,
    watcher: &'w mut dyn Watcher,
}

impl Wizard<'_, '_> {
    /// Asks, and returns the answer.
    fn ask(&mut self, question: Question) -> Told<String> {
        let board = &mut self.board;
        let mut looks = || board.as_mut().map_or_else(|| Some(Vec::new()), switches::seen);
        let answer = self.watcher.ask(&question, &mut looks);
        if let Some(fault) = self.board.as_ref().and_then(|board| board.fault()) {
            return Err(Ends::Failed(fault.message.clone()));
        }
        let answer = answer.ok_or(Ends::Stopped)?;
        let answer = answer.trim();
        if answer == "q" { Err(Ends::Stopped) } else { Ok(answer.to_owned()) }
    }

    fn tell(&mut self, words: &str) {
        self.watcher.tell(words);
    }

    /// Asks for pins until the board takes them.
    fn pins(&mut self) -> Told {
        loop {
            for ((axis, pins, home), motor) in AXES.into_iter().zip([Motor::X, Motor::Y, Motor::Z])
            {
                let letter = axis.letter();
                self.setting(Step::Motor, letter, pins)?;
                self.setting(Step::Home, letter, home)?;
                self.current(motor)?;
            }
            self.further()?;
            for (axis, _, home) in AXES {
                let is_fitted = !get(&self.machine, home).is_empty();
                self.machine.homing.switches[axis.index()].fitted = is_fitted;
            }
            self.setting(Step::Enable, "", "board.enable")?;
            self.setting(Step::Outputs, "", "board.outputs")?;
            self.setting(Step::Inputs, "", "board.inputs")?;
            self.torch()?;
            match self.opens() {
                Ok(()) => return Ok(()),
                Err(why) => self.tell(&why),
            }
        }
    }

    /// Asks for a setting until it is one.
    fn setting(&mut self, step: Step, about: impl Display, key: &str) -> Told {
        loop {
            let kept = get(&self.machine, key);
            let answer = self.ask(Question::of(step, &about, kept))?;
            let value = match &*answer {
                "" => return Ok(()),
                "-" => "",
                other => other,
            };
            match put(&mut self.machine, key, value) {
                Ok(()) => return Ok(()),
                Err(why) => self.tell(&why),
            }
        }
    }

    /// Asks for second motors and a rotary axis.
    fn further(&mut self) -> Told {
        if self.ask(Question::of(Step::Further, "", ""))? != "y" {
            return Ok(());
        }
        for Further { asks: (step, about), motor, role, home } in FURTHER {
            let key = format!("board.{}", motor.word());
            self.setting(step, about, &key)?;
            let is_there = !get(&self.machine, &key).is_empty();
            let turned_by = if is_there { motor.word() } else { "none" };
            put(&mut self.machine, role, turned_by).map_err(Ends::Failed)?;
            if is_there {
                let is_second = step == Step::SecondMotor;
                self.setting(if is_second { Step::SecondHome } else { Step::Home }, about, home)?;
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
            self.ask(Question::of(Step::BothGo, letter, ""))?;
            for to_mm in [LOOK_MM, 0.0] {
                self.way(AxisMove { axis, to_mm, mm_s: LOOK_MM_S })?;
            }
            if self.ask(Question::of(Step::BothWent, letter, ""))? != "n" {
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
            let answer = self.ask(Question::of(Step::Current, &letter, kept))?;
            match (&*answer, answer.parse::<f64>()) {
                ("", _) => return Ok(()),
                (_, Ok(current_a)) if current_a > 0.0 => {
                    self.machine.drivers.current_a[motor] = current_a;
                    return Ok(());
                }
                _ => self.tell("Name it as the motor has it printed, or less: 0.8"),
            }
        }
    }

    /// Opens the board with what is known by now: what only the host knows may change, pins may not.
    fn opens(&mut self) -> Result<(), String> {
        self.board = None;
        let mut board = self.socket.open(&self.machine, false)?;
        board.is_at(Axes::default());
        self.board = Some(board);
        Ok(())
    }

    fn board(&mut self) -> Told<&mut Queued> {
        self.board.as_mut().ok_or_else(|| Ends::Failed("the board is gone".into()))
    }

    fn way(&mut self, way: AxisMove) -> Told {
        let board = self.board.as_mut().ok_or_else(|| Ends::Failed("the board is gone".into()))?;
        let came = way.moves(board, &self.machine, || self.watcher.is_stopped());
        if came.map_err(Ends::Failed)? { Ok(()) } else { Err(Ends::Stopped) }
    }

    /// Turns each motor a little, until somebody has seen it go the right way.
    fn motors(&mut self) -> Told {
        let axes = self.board()?.axes();
        for (axis, key, _) in AXES.into_iter().filter(|(axis, ..)| axes.contains(*axis)) {
            let letter = axis.letter();
            loop {
                self.ask(Question::of(Step::Goes, letter, ""))?;
                self.way(AxisMove { axis, to_mm: LOOK_MM, mm_s: LOOK_MM_S })?;
                let answer = self.ask(Question::of(Step::Went, letter, ""))?;
                self.way(AxisMove { axis, to_mm: 0.0, mm_s: LOOK_MM_S })?;
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
                            self.tell("Look at its pins, its wires and its current.");
                            false
                        }
                        Err(_) => {
                            self.tell("Answer y, n, or a number of mm.");
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
                for (look, step) in looks.iter_mut().zip([Step::LeaveSwitch, Step::PressSwitch]) {
                    self.ask(Question::of(step, letter, ""))?;
                    let seen = self.board()?.is_on(switch);
                    *look = seen.ok_or_else(|| Ends::Failed("a switch is not told".into()))?;
                }
                match looks {
                    [false, true] => {
                        self.tell(&format!("{letter}: its home switch is seen"));
                        break;
                    }
                    [true, false] => {
                        self.tell(&format!("{letter}: its home switch is seen, turned round"));
                        self.turn(key, 0)?;
                        self.opens().map_err(Ends::Failed)?;
                        break;
                    }
                    _ if self.ask(Question::of(Step::Unseen, letter, ""))? == "n" => break,
                    _ => {}
                }
            }
        }
        Ok(())
    }

    /// Has each output go on for a moment.
    fn outputs(&mut self) -> Told {
        for number in self.board()?.outputs() {
            let answer = self.ask(Question::of(Step::OutputGoes, number, ""))?;
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
            if self.ask(Question::of(Step::OutputWent, number, ""))? == "n" {
                self.tell(&format!("Output {number}: look at its pin in board.outputs."));
            }
        }
        Ok(())
    }
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
    // Pins with commas between are one text.
    setting.set(machine, &Value::Text(value.to_owned())).map_err(|why| why.to_string())
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
