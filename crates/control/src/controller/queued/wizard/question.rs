//! Questions of the wizard, for whoever shows them.

use kerf_program::Axis;
use std::fmt;

/// Way of a motor that is looked at, mm or degrees.
pub const LOOK_MM: f64 = 1.0;
/// Way of a trial, mm or degrees.
pub const WAY_MM: f64 = 20.0;

/// A list of steps with their names.
macro_rules! steps {
    ($($(#[$meta:meta])* $step:ident = $word:literal;)*) => {
        /// A step of the wizard: what is asked.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Step {
            $($(#[$meta])* $step,)*
        }

        impl Step {
            /// Its name, for pages.
            pub const fn name(self) -> &'static str {
                match self { $(Self::$step => $word,)* }
            }
        }
    };
}

steps! {
    /// Pins of step and direction of the motor of an axis.
    Motor = "motor";
    /// Those of the second motor of an axis.
    SecondMotor = "secondMotor";
    /// Pin of the home switch of an axis.
    Home = "home";
    /// That of the second motor's own switch.
    SecondHome = "secondHome";
    /// Current of a motor whose driver has registers, amperes.
    Current = "current";
    /// Second motors or a rotary axis are there.
    Further = "further";
    /// Pins that give motors their current.
    Enable = "enable";
    /// Outputs by number, with their pins.
    Outputs = "outputs";
    /// Inputs by number, with their pins.
    Inputs = "inputs";
    /// A torch is there whose height is controlled.
    Torch = "torch";
    /// Pin that measures the voltage of its arc.
    TorchVoltage = "torchVoltage";
    /// Pins of the two switches of its head: too high, too low.
    TorchSwitches = "torchSwitches";
    /// A motor is about to turn a little.
    Goes = "goes";
    /// It turned: the right way, the other way, or so far.
    Went = "went";
    /// Both motors of an axis are about to turn a little.
    BothGo = "bothGo";
    /// They turned the same way, or not.
    BothWent = "bothWent";
    /// A home switch is to be left alone.
    LeaveSwitch = "leaveSwitch";
    /// It is to be pressed.
    PressSwitch = "pressSwitch";
    /// Nothing changed: it is looked at again, or not.
    Unseen = "unseen";
    /// An output is about to go on.
    OutputGoes = "outputGoes";
    /// It went on, or not.
    OutputWent = "outputWent";
    /// Speeds of an axis are tried, or not.
    TrySpeed = "trySpeed";
    /// It came back to its place at a speed, or not.
    SpeedGood = "speedGood";
    /// Accelerations of an axis are tried, or not.
    TryAcceleration = "tryAcceleration";
    /// It came back to its place at an acceleration, or not.
    AccelerationGood = "accelerationGood";
}

/// A question.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Question {
    /// The step.
    pub step: Step,
    /// Subject: the letter of an axis or a motor, the number of an output.
    pub about: String,
    /// The value that holds now, or that was tried.
    pub value: String,
}

impl Question {
    /// A question about something.
    pub fn of(step: Step, about: impl fmt::Display, value: impl fmt::Display) -> Self {
        Self { step, about: about.to_string(), value: value.to_string() }
    }

    /// Unit of the ways that it is about.
    pub fn unit(&self) -> &'static str {
        if self.about == "A" { "degrees" } else { "mm" }
    }
}

/// Unit of the ways of an axis.
pub const fn unit(axis: Axis) -> &'static str {
    if matches!(axis, Axis::A) { "degrees" } else { "mm" }
}

impl fmt::Display for Question {
    /// Writes it as somebody at a shell is asked, with the short answers.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (about, value, unit) = (&self.about, &self.value, self.unit());
        match self.step {
            Step::Motor => write!(f, "motor {about}, step and direction [{value}]: "),
            Step::SecondMotor => {
                write!(f, "second motor of {about}, step and direction [{value}]: ")
            }
            Step::Home => write!(f, "home switch of {about} [{value}]: "),
            Step::SecondHome => {
                write!(
                    f,
                    "home switch of the second motor of {about}, - for none of its own [{value}]: "
                )
            }
            Step::Current => write!(f, "current of {about} while it turns, amperes [{value}]: "),
            Step::Further => write!(f, "Second motors of X and Y, or a rotary axis? y, n [n]: "),
            Step::Enable => write!(f, "current of the motors [{value}]: "),
            Step::Outputs => write!(f, "outputs by number (1 gpio20, 2 gpio21) [{value}]: "),
            Step::Inputs => write!(f, "inputs by number (1 ^gpio22) [{value}]: "),
            Step::Torch => write!(f, "A torch whose height is controlled? y, n [n]: "),
            Step::TorchVoltage => {
                write!(f, "pin of the voltage of its arc, - for none [{value}]: ")
            }
            Step::TorchSwitches => {
                write!(f, "switches too high and too low, two pins, - for none [{value}]: ")
            }
            Step::Goes => write!(f, "{about} goes {LOOK_MM} {unit} towards plus: Enter "),
            Step::Went => write!(f, "Did it? y, n for the other way, or how far in mm [y]: "),
            Step::BothGo => write!(f, "{about} goes {LOOK_MM} {unit} with both motors: Enter "),
            Step::BothWent => write!(f, "Did both go the same way? y, n [y]: "),
            Step::LeaveSwitch => write!(f, "{about}: leave its home switch alone, Enter "),
            Step::PressSwitch => write!(f, "{about}: press it and hold it, Enter "),
            Step::Unseen => {
                write!(f, "Nothing changed: look at its pin and its wires. Again? y, n [y]: ")
            }
            Step::OutputGoes => {
                write!(f, "Output {about} goes on for a second: Enter, s leaves it out: ")
            }
            Step::OutputWent => write!(f, "Did it? y, n [y]: "),
            Step::TrySpeed | Step::TryAcceleration => {
                let what = if self.step == Step::TrySpeed { "speed" } else { "acceleration" };
                let way = format!("{WAY_MM} {unit} there and back, more each time");
                write!(f, "{about}: try its {what}, {way}? y, n [n]: ")
            }
            Step::SpeedGood | Step::AccelerationGood => {
                let per = if self.step == Step::SpeedGood { "/s" } else { "/s²" };
                write!(
                    f,
                    "{about} at {value} {unit}{per}: did it come back to its place? y, n [y]: "
                )
            }
        }
    }
}
