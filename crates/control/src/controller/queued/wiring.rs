//! The machine's file as the setup of a board: which pin does what, which motor turns which axis.

use super::drivers;
use super::homing::AxisHome;
use super::others;
use super::pins::{Pins, entries};
use kerf_driver_klipper::setup::{Motor, Pin, Pulsed, Setup, Switched};
use kerf_machine::Configuration;
use kerf_machine::lines::Input;
use kerf_machine::planning::hand_settings;
use kerf_machine::settings::motors::{Direction, Motor as Name};
use kerf_model::{Duty, contact};
use kerf_program::settings::IoModes;
use kerf_program::{Axis, AxisSet, Settings};

/// A motor of the board with the axis that it turns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Turns {
    /// Its axis.
    pub axis: Axis,
    /// Its home switch among the switches, where it has one.
    pub home: Option<usize>,
}

/// A board and what hangs on it, by the names that the machine has for it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Wiring {
    /// The boards.
    pub pins: Pins,
    /// The setup of all boards together.
    pub setup: Setup,
    /// Axes of its motors, in the order of the setup.
    pub motors: Vec<Turns>,
    /// Outputs that go on and off: number of part files, place in the setup.
    pub outputs: Vec<(u8, usize)>,
    /// Outputs that give the motors their current.
    pub enables: Vec<usize>,
    /// Output of the spindle's speed, and revolutions a minute at a share of all the time.
    pub spindle: Option<(usize, f64)>,
    /// PWM channels: number of part files, place among the outputs.
    pub pwm: Vec<(u8, usize)>,
    /// The pin that measures the height of a torch, among the voltages.
    pub height: Option<usize>,
    /// Inputs that are looked at all the time, in the order of the setup.
    pub inputs: Vec<Looked>,
    /// Axes that are homed, in this order.
    pub homes: Vec<AxisHome>,
    /// Settings of the planner for homing.
    pub by_hand: Settings,
}

/// An input of part files on a board.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Looked {
    /// Its number.
    pub number: u8,
    /// The same pin among the switches that can stop motors.
    pub switch: usize,
    /// That one is active when this one is not.
    pub turned: bool,
    /// The state of the pin in which nothing moves: an emergency stop, a stop input, a door.
    pub stops: Option<bool>,
    /// Motion that comes to its limit ends, when it is active.
    pub limits: bool,
}

impl Looked {
    /// An input by its number, as a machine's settings have it.
    pub fn of(machine: &Configuration, number: u8, (switch, turned): (usize, bool)) -> Self {
        let emergency = (number == Input::EmergencyStop.number()).then_some(machine.estop.active);
        let mut looked = Self { number, switch, turned, stops: emergency, limits: false };
        looked.follow(&machine.program.io);
        looked
    }

    /// The state of the pin at which motion ends at once; while axes are homed, limits are no end of it.
    pub fn ends_motion(&self, homes: bool) -> Option<bool> {
        self.stops.or((self.limits && !homes).then_some(true))
    }

    /// Its effect on motion is that of these modes. However a contact is wired, the pin is active where it stops.
    pub fn follow(&mut self, io: &IoModes) {
        let duty = kerf_model::duty(self.number, io);
        if self.number != Input::EmergencyStop.number() {
            self.stops = (duty == Duty::Stop).then_some(true);
        }
        self.limits = duty == Duty::Limit;
    }
}

impl Wiring {
    /// The wiring that a configuration tells of.
    ///
    /// # Errors
    /// No motor has pins, or a setting cannot be read; in words.
    pub fn of(machine: &Configuration) -> Result<Self, String> {
        let mut wiring = Self::default();
        let others = others::read(&machine.board.others)?;
        wiring.pins.boards.extend(others.into_iter().map(|(name, _)| name));
        for name in Name::ALL {
            wiring.motor(machine, name)?;
        }
        if wiring.motors.is_empty() {
            return Err("the machine's file names no pins of motors: board.x = \"gpio0 gpio1\", \
                        step and direction, and so on (kerf explain board)"
                .into());
        }
        wiring.outputs(machine)?;
        for (number, pin) in wiring.pins.numbered("board.inputs", &machine.board.inputs)? {
            wiring.input(machine, number, pin);
        }
        let homes: Vec<_> = wiring.motors.iter().map(|motor| (motor.axis, motor.home)).collect();
        wiring.homes = AxisHome::all(machine, &homes);
        wiring.by_hand = hand_settings(machine);
        Ok(wiring)
    }

    fn input(&mut self, machine: &Configuration, number: u8, pin: Pin) {
        let switch = self.switch(pin.clone());
        let turned = self.setup.switches[switch].inverted != pin.inverted;
        self.inputs.push(Looked::of(machine, number, (switch, turned)));
        self.setup.buttons.push(pin);
    }

    /// The place of a pin among the switches.
    fn switch(&mut self, pin: Pin) -> usize {
        let switches = &mut self.setup.switches;
        let is_it = |other: &Pin| (other.board, &other.name) == (pin.board, &pin.name);
        switches.iter().position(is_it).unwrap_or_else(|| {
            switches.push(pin);
            switches.len() - 1
        })
    }

    /// Axes that have a motor.
    pub fn axes(&self) -> AxisSet {
        self.motors.iter().fold(AxisSet::EMPTY, |axes, motor| axes.with(motor.axis))
    }

    /// Axes that have a home switch.
    pub fn homing(&self) -> AxisSet {
        self.homes.iter().fold(AxisSet::EMPTY, |axes, home| axes.with(home.axis))
    }

    /// An input is on, with the states of the row and the modes that hold; one that is not wired is off.
    pub fn is_on(&self, pressed: u8, io: &IoModes, number: u8) -> bool {
        let bit = self.inputs.iter().position(|it| it.number == number);
        bit.is_some_and(|bit| contact(number, pressed & (1 << bit) != 0, io))
    }

    fn motor(&mut self, machine: &Configuration, name: Name) -> Result<(), String> {
        let (board, index) = (&machine.board, name.index());
        let pins = &board.motors[index];
        if pins.trim().is_empty() {
            return Ok(());
        }
        let key = ["board.x", "board.y", "board.z", "board.w", "board.q", "board.r"][index];
        let Some(axis) = machine.motors.axis_of(name) else {
            return Err(format!("{key}: no axis is turned by that motor (motors.x2, motors.a, …)"));
        };
        let [step, mut dir] = self.pins.pair(key, pins)?;
        drivers::add(&mut self.setup, &self.pins, machine, name)?;
        dir.inverted ^= machine.motors.direction[axis.index()] == Direction::Backwards;
        let second = self.motors.iter().any(|motor| motor.axis == axis);
        let home = self.home(machine, axis, second)?;
        self.motors.push(Turns { axis, home });
        self.setup.motors.push(Motor {
            step,
            dir,
            pulse_s: board.pulse_us * 1e-6,
            turn_s: board.turn_us * 1e-6,
            both_edges: board.both_edges,
            least_s: 1.0 / board.steps_s,
        });
        Ok(())
    }

    /// The home switch of a motor: its own, or that of the axis.
    fn home(
        &mut self,
        machine: &Configuration,
        axis: Axis,
        second: bool,
    ) -> Result<Option<usize>, String> {
        let board = &machine.board;
        let own =
            board.second_homes.get(axis.index()).filter(|pin| second && !pin.trim().is_empty());
        let text = own.unwrap_or(&board.homes[axis.index()]);
        if text.trim().is_empty() || !machine.homing.of(axis).fitted {
            return Ok(None);
        }
        let pin = self.pins.pin("board.home_…", text.trim())?;
        Ok(Some(self.switch(pin)))
    }

    fn outputs(&mut self, machine: &Configuration) -> Result<(), String> {
        let board = &machine.board;
        let watch_s = Some(board.watch_s);
        for (number, pin) in self.pins.numbered("board.outputs", &board.outputs)? {
            self.outputs.push((number, self.setup.outputs.len()));
            self.setup.outputs.push(Switched { pin, watch_s });
        }
        for name in entries(&board.enable) {
            self.enables.push(self.setup.outputs.len());
            let pin = self.pins.pin("board.enable", name)?;
            // Motors that lose their current lose their place: they keep it while the host is silent.
            self.setup.outputs.push(Switched { pin, watch_s: None });
        }
        if !board.spindle.trim().is_empty() {
            self.spindle = Some((self.setup.outputs.len(), board.spindle_rpm));
            let pin = self.pins.pin("board.spindle", board.spindle.trim())?;
            self.setup.pulsed.push(Pulsed { pin, cycle_s: 1.0 / board.spindle_hz, watch_s });
        }
        for (channel, pin) in self.pins.numbered("board.pwm", &board.pwm)? {
            self.pwm.push((channel, self.setup.outputs.len() + self.setup.pulsed.len()));
            self.setup.pulsed.push(Pulsed { pin, cycle_s: 1.0 / board.pwm_hz, watch_s });
        }
        if !board.height.trim().is_empty() {
            self.height = Some(self.setup.voltages.len());
            self.setup.voltages.push(self.pins.pin("board.height", board.height.trim())?);
        }
        Ok(())
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn check(lines: &str, expected: Result<usize, &str>) {
        let machine = kerf_machine::file::read(&"m.toml".into(), lines).unwrap();
        match (Wiring::of(&machine), expected) {
            (Ok(wiring), Ok(motors)) => assert_eq!(wiring.motors.len(), motors),
            (Err(why), Err(part)) => assert!(why.contains(part), "{why}"),
            (found, _) => panic!("{lines}: {found:?}"),
        }
    }

    #[test]
    fn pins_are_read_and_mistakes_are_told() {
        check("[board]\nx = \"gpio0 gpio1\"\ny = \"gpio2 !gpio3\"", Ok(2));
        check("[motors]\ny2 = \"w\"\n[board]\ny = \"a b\"\nw = \"c d\"", Ok(2));
        check("", Err("names no pins of motors"));
        check("[board]\nx = \"gpio0\"", Err("name two pins"));
        check("[board]\nw = \"c d\"", Err("no axis is turned"));
        check("[board]\nx = \"a b\"\noutputs = \"one gpio2\"", Err("no number with its pin"));
        check("[board]\nx = \"a b\"\noutputs = \"1 !\"", Err("no pin"));
    }

    #[test]
    fn motors_and_switches_are_on_several_boards() {
        let lines = "[board]\nothers = \"two /dev/ttyACM1\"\nx = \"a b\"\ny = \"two:a two:b\"\n";
        check(lines, Ok(2));
        check(&lines.replace("two:b", "b"), Ok(2));
        check(&lines.replace("two /dev", "three /dev"), Err("on no board"));
    }

    #[test]
    fn two_motors_of_an_axis_have_a_switch_each_where_there_are_two() {
        let lines = "[motors]\ny2 = \"w\"\n[homing]\ny = { fitted = true, end = \"low\" }\n\
                     [board]\ny = \"a b\"\nw = \"c d\"\nhome_y = \"^e\"";
        let wiring = |more: &str| {
            let text = format!("{lines}{more}");
            Wiring::of(&kerf_machine::file::read(&"m.toml".into(), &text).unwrap()).unwrap()
        };
        let homes = |wiring: Wiring| wiring.motors.iter().map(|m| m.home).collect::<Vec<_>>();
        assert_eq!(homes(wiring("")), [Some(0), Some(0)]);
        assert_eq!(homes(wiring("\nhome_y2 = \"^f\"")), [Some(0), Some(1)]);
    }
}
