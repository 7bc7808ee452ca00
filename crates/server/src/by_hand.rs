//! Acts by hand, for pages, on a machine that stands: moves to somewhere, bits of the card, single steps.

use crate::asker::Asker;
use crate::hands::Hands;
use crate::locks::lock;
use crate::machine::Order;
use crate::refusal::problem;
use kerf_control::controller::{STEPS, question_in, settings_in};
use kerf_machine::hand::warm_steps;
use kerf_machine::lines::Output;
use kerf_machine::settings::io::IoMap;
use kerf_machine::settings::motors::Motor;
use kerf_machine::{Configuration, Errand, driver, wiring};
use kerf_program::{AXES, Axis, AxisSet, decimal};
use kerf_wire::{ByHand, Problem, Why, ZeroChange};
use std::sync::mpsc::channel;

impl Hands {
    /// Moves the machine to somewhere.
    ///
    /// # Errors
    /// There is no such axis or place, or the machine is busy.
    pub fn go(&self, asker: &Asker, way: ByHand) -> Result<(), Problem> {
        let machine = Box::new(self.loader.machine_by_hand());
        if let ByHand::CutMove { at, cut: true } = way {
            let at = finite(at.map(Some)).map(|()| at)?;
            return self.orders.order_of(asker, Order::CutMove { at, machine });
        }
        let homes = lock(&self.left).session.homes(&machine);
        let errand = errand(&machine, way, homes)?;
        self.hand(asker, errand, machine)
    }

    fn hand(
        &self,
        asker: &Asker,
        errand: Errand,
        machine: Box<Configuration>,
    ) -> Result<(), Problem> {
        // Pages see how it ends in what the machine tells.
        let (tells, _) = channel();
        self.orders.order_of(asker, Order::Hand { errand, machine, tells })
    }

    /// Switches an output bit of the card.
    ///
    /// # Errors
    /// There is none of that name, it belongs to a motor, or the machine is a real one.
    pub fn switch_bit(&self, asker: &Asker, name: &str, on: bool) -> Result<(), Problem> {
        self.has_card()?;
        let found = wiring::bit(name).filter(|(is_output, _)| *is_output);
        let Some((_, bit)) = found else {
            return Err(problem(Why::Malformed, format!("no output bit is called {name}")));
        };
        let Some(line) = Output::of_name(bit.name) else {
            return Err(problem(Why::State, "this bit belongs to a motor: step it instead"));
        };
        self.orders.order_of(asker, Order::Switch(line.number(), on))
    }

    /// Steps a motor once, which moves its axis by the length of a step.
    ///
    /// # Errors
    /// There is no such motor, it moves no axis alone, or the machine is a real one.
    pub fn step_motor(&self, asker: &Asker, name: &str, forward: bool) -> Result<(), Problem> {
        self.has_card()?;
        let machine = Box::new(self.loader.machine_by_hand());
        let motor = Motor::ALL.into_iter().find(|it| it.word().eq_ignore_ascii_case(name));
        let Some(axis) = motor.and_then(|motor| machine.motors.axis_of(motor)) else {
            return Err(problem(Why::Malformed, format!("no axis is moved by a motor {name}")));
        };
        if machine.motors.of_axis(axis).len() > 1 {
            let text = "two motors move this axis: a step of one of them would set it askew";
            return Err(problem(Why::State, text));
        }
        let step = 1.0 / machine.program.resolution.steps_per_unit[axis];
        let mut place = [None; AXES];
        place[axis.index()] = Some(if forward { step } else { -step });
        self.hand(asker, Errand::To { place, relative: true, flat: false }, machine)
    }

    /// Changes a zero point that the controller keeps.
    ///
    /// # Errors
    /// The machine keeps none, or none of this name; a number is none; or the machine is busy.
    pub fn zero(&self, asker: &Asker, name: String, change: ZeroChange) -> Result<(), Problem> {
        let names: Vec<_> =
            self.hub.read(|now| now.zeros.iter().map(|zero| zero.name.clone()).collect());
        if names.is_empty() {
            let text = "this machine keeps no zero points of its own: zero its axes (ZX, ZY, ZZ), or say what they read (VA)";
            return Err(problem(Why::State, text));
        }
        if !names.contains(&name) {
            let text = format!("no zero point is called {name}: {}", names.join(", "));
            return Err(problem(Why::Malformed, text));
        }
        let change = match change {
            ZeroChange::Reads { values } => {
                finite(values).map(|()| driver::ZeroChange::Reads(values))?
            }
            ZeroChange::Lies { at } => finite(at).map(|()| driver::ZeroChange::Lies(at))?,
            ZeroChange::Holds => driver::ZeroChange::Holds,
            ZeroChange::Gone => driver::ZeroChange::Gone,
        };
        self.orders.order_of(asker, Order::Zero { name, change })
    }

    /// Writes the steps of a millimetre of an axis into the controller.
    ///
    /// # Errors
    /// The machine keeps none of this axis, the number is no such number, or the machine is busy.
    pub fn keep_steps(&self, asker: &Asker, axis: char, steps: f64) -> Result<(), Problem> {
        let count = self.hub.read(|now| now.controller_steps.len());
        let axis = Axis::from_letter(axis).filter(|axis| axis.index() < count);
        let axis = axis.ok_or_else(|| {
            problem(Why::State, "the controller of this machine keeps no steps of this axis")
        })?;
        if !(steps.is_finite() && steps > 0.0) {
            return Err(problem(Why::Malformed, "steps of a millimetre are a number above 0"));
        }
        let (number, value) = (STEPS + axis.index() as u16, decimal(steps, 3));
        self.orders.order_of(asker, Order::Setting { number, value })
    }

    /// Writes a setting into the controller, where typed lines are one (`$120=300`); tells whether they are.
    ///
    /// # Errors
    /// They are several, or lines of a program stand beside it; the machine keeps no settings by number, or is busy.
    pub fn keep_setting(&self, asker: &Asker, lines: &str) -> Result<bool, Problem> {
        let mut set = settings_in(lines).map_err(|why| problem(Why::Malformed, why))?;
        let Some((number, value)) = set.pop() else { return Ok(false) };
        if !set.is_empty() {
            let text = "settings of the controller are written one at a time";
            return Err(problem(Why::Malformed, text));
        }
        if self.hub.read(|now| now.controller_settings.is_empty()) {
            let text = format!(
                "${number} is a setting of a controller of grbl's family, and this machine has none by number"
            );
            return Err(problem(Why::State, text));
        }
        self.orders.order_of(asker, Order::Setting { number, value })?;
        Ok(true)
    }

    /// Asks the controller, where a typed line is a question in its own language (`$I`); tells whether it is.
    ///
    /// # Errors
    /// The machine is busy.
    pub fn ask_controller(&self, asker: &Asker, lines: &str) -> Result<bool, Problem> {
        let is_asked = self.hub.read(|now| !now.controller_settings.is_empty());
        let Some(question) = question_in(lines).filter(|_| is_asked) else { return Ok(false) };
        self.orders.order_of(asker, Order::Question(question.to_owned()))?;
        Ok(true)
    }

    /// Returns the pins of the switches that are moved on a page.
    ///
    /// # Errors
    /// The switches of this machine are moved where they are.
    pub fn pins_moved_here(&self) -> Result<IoMap, Problem> {
        let text = "the switches of this machine are moved where they are, not on a page";
        let moved = self.hub.read(|now| now.machine.offers.inputs);
        if moved {
            Ok(lock(&self.left).session.machine_is.io)
        } else {
            Err(problem(Why::State, text))
        }
    }

    fn has_card(&self) -> Result<(), Problem> {
        let text = "this machine has no card whose bits are switched: it has outputs (SO)";
        let has = self.hub.read(|now| now.machine.offers.card);
        if has { Ok(()) } else { Err(problem(Why::State, text)) }
    }
}

fn errand(machine: &Configuration, way: ByHand, homes: AxisSet) -> Result<Errand, Problem> {
    Ok(match way {
        ByHand::FindHome { axes } => Errand::FindHome(called(machine, axes.as_deref(), homes)?),
        ByHand::Home { axes } => {
            Errand::Home(called(machine, axes.as_deref(), machine.motors.axes())?)
        }
        ByHand::Origin => Errand::Origin,
        ByHand::Finish => Errand::Finish,
        ByHand::WarmUp { steps } => {
            let steps = steps.unwrap_or_else(|| machine.options.warm_up.clone());
            let steps = warm_steps(&steps).map_err(|why| problem(Why::Malformed, why))?;
            Errand::WarmUp(steps.into())
        }
        ByHand::Place { place, relative, flat } => {
            finite(place)?;
            Errand::To { place, relative, flat }
        }
        ByHand::CutMove { at, .. } => {
            finite(at.map(Some))?;
            Errand::CutMoveTo(at)
        }
    })
}

/// Axes by their letters, out of those that can be meant; all of them for nothing.
fn called(
    machine: &Configuration,
    letters: Option<&str>,
    all: AxisSet,
) -> Result<AxisSet, Problem> {
    let axes = letters.unwrap_or_default().chars().try_fold(AxisSet::EMPTY, |set, letter| {
        let axis = machine.motors.axis_called(letter).filter(|axis| all.contains(*axis));
        let text = || format!("axis {letter} is not there, or has no home switch");
        axis.map(|axis| set.with(axis)).ok_or_else(|| problem(Why::Malformed, text()))
    })?;
    let axes = if letters.is_some() { axes } else { all };
    if axes.is_empty() {
        return Err(problem(Why::Malformed, "name the axes by their letters, as xy"));
    }
    Ok(axes)
}

/// Checks that there is a place and that its numbers are some.
fn finite<const N: usize>(place: [Option<f64>; N]) -> Result<(), Problem> {
    let mut numbers = place.into_iter().flatten().peekable();
    let some = numbers.peek().is_some();
    if some && numbers.all(f64::is_finite) {
        return Ok(());
    }
    Err(problem(Why::Malformed, "a place has a number for at least one axis"))
}
