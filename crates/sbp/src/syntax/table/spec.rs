//! The entries of the command table.

use super::{Act, Setting};
use kerf_program::{Axis, Settings};

/// One command.
#[derive(Debug)]
pub struct CommandSpec {
    /// Its two letters, capitals.
    pub letters: &'static str,
    /// Its name, as a menu shows it.
    pub name: &'static str,
    /// The menu it belongs to.
    pub group: Group,
    /// Its parameters in part-file order.
    pub params: &'static [ParamSpec],
    /// Effect on the stack of moves.
    pub stack: Stack,
    /// Description of its effect, a sentence or two in our own words, with the manual's section where useful.
    pub doc: &'static str,
    /// Its effect.
    pub act: Act,
}

impl PartialEq for CommandSpec {
    fn eq(&self, other: &Self) -> bool {
        self.letters == other.letters
    }
}

/// The groups of commands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[allow(missing_docs)]
pub enum Group {
    Move,
    Jog,
    Cut,
    File,
    Settings,
    Values,
    Zero,
    Record,
    Tools,
    Utilities,
    Help,
}

/// Effect of a command on the stack of moves (readings, A-95).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stack {
    /// Belongs to the stack, or does not disturb it (moves, cuts, VS).
    Joins,
    /// Motion comes to rest before it and everything given so far is carried out.
    Ends,
}

/// One parameter.
#[derive(Clone, Copy, Debug)]
pub struct ParamSpec {
    /// Its name, as a form shows it.
    pub name: &'static str,
    /// Kind of value that may be written.
    pub kind: Kind,
    /// Meaning when left blank.
    pub default: Default,
    /// Values it accepts.
    pub bound: Bound,
    /// Purpose; may be empty when the name says it.
    pub doc: &'static str,
    /// The place in the settings that it shows and changes, for parameters of that sort.
    pub setting: Option<Setting>,
}

/// Kind of value that may be written for a parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// A number in a unit; the argument arrives in mm, mm/s, degrees … (see [`Unit`]).
    Number(Unit),
    /// A whole number.
    Whole,
    /// One of these numbers.
    OneOf(&'static [i32]),
    /// One of these words or letters, in any case; the argument arrives as written in the list.
    Word(&'static [&'static str]),
    /// A number in a unit or the word OFF.
    NumberOrOff(Unit),
    /// Text, a bare word or a text expression.
    Text,
    /// A file or folder name.
    File,
    /// An axis letter.
    AxisLetter,
    /// Accepted and ignored.
    Obsolete,
}

/// The unit of a number as the user writes it, and so how it is converted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Unit {
    /// A plain number.
    None,
    /// A length in the user's linear unit → mm.
    Length,
    /// A speed in linear units a second → mm/s.
    Speed,
    /// A location or distance in the unit of an axis → mm or degrees.
    Axis(Axis),
    /// A speed in units of an axis a second → mm/s or degrees/s.
    AxisSpeed(Axis),
    /// Steps for one unit of an axis → steps for one mm or degree.
    StepsPer(Axis),
    /// Degrees.
    Degrees,
    /// Seconds.
    Seconds,
    /// Percent.
    Percent,
    /// 1/1440 inch.
    Twips,
}

/// Meaning of a blank parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Default {
    /// It must be given.
    Required,
    /// It must be given, which the command says in words of its own.
    Demanded,
    /// The present value stays, or the axis does not move.
    Keep,
    /// This number, in the user's unit.
    Number(f64),
    /// This word.
    Word(&'static str),
    /// As the documentation of the parameter says.
    Special,
}

/// The values that are accepted. Lengths and speeds are compared in inches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Bound {
    /// Any finite number.
    Any,
    /// Greater than 0.
    Positive,
    /// 0 or greater.
    NotNegative,
    /// From … to, both included.
    Range(f64, f64),
    /// At least.
    AtLeast(f64),
    /// From … up to, the second not included.
    Below(f64, f64),
    /// Anything but 0.
    NotZero,
}

impl Unit {
    /// Internal units in one unit as the user writes it.
    pub fn scale(self, settings: &Settings) -> f64 {
        match self {
            Self::Length | Self::Speed => settings.linear_unit.mm(),
            Self::Axis(axis) | Self::AxisSpeed(axis) => settings.axis_scale(axis),
            Self::StepsPer(axis) => 1.0 / settings.axis_scale(axis),
            Self::None | Self::Degrees | Self::Seconds | Self::Percent | Self::Twips => 1.0,
        }
    }
}

impl Kind {
    /// The unit of a number.
    pub const fn unit(self) -> Unit {
        match self {
            Self::Number(unit) | Self::NumberOrOff(unit) => unit,
            _ => Unit::None,
        }
    }
}

impl ParamSpec {
    /// A parameter of a kind that may be left blank to keep the present value.
    pub const fn keep(name: &'static str, kind: Kind) -> Self {
        Self { name, kind, default: Default::Keep, bound: Bound::Any, doc: "", setting: None }
    }

    /// A parameter that must be given.
    pub const fn required(name: &'static str, kind: Kind) -> Self {
        Self { name, kind, default: Default::Required, bound: Bound::Any, doc: "", setting: None }
    }

    /// A parameter with a default number.
    pub const fn number(name: &'static str, kind: Kind, default: f64) -> Self {
        Self {
            name,
            kind,
            default: Default::Number(default),
            bound: Bound::Any,
            doc: "",
            setting: None,
        }
    }

    /// A parameter with a default word.
    pub const fn word(
        name: &'static str,
        words: &'static [&'static str],
        default: &'static str,
    ) -> Self {
        Self {
            name,
            kind: Kind::Word(words),
            default: Default::Word(default),
            bound: Bound::Any,
            doc: "",
            setting: None,
        }
    }

    /// A parameter that old files fill and nothing reads.
    pub const fn obsolete() -> Self {
        Self {
            name: "(obsolete)",
            kind: Kind::Obsolete,
            default: Default::Keep,
            bound: Bound::Any,
            doc: "Accepted and ignored.",
            setting: None,
        }
    }

    /// The same within bounds.
    pub const fn within(mut self, bound: Bound) -> Self {
        self.bound = bound;
        self
    }

    /// The same, and the command says in its own words that it must be given.
    pub const fn demanded(mut self) -> Self {
        self.default = Default::Demanded;
        self
    }

    /// The same with a default that its documentation explains.
    pub const fn special(mut self) -> Self {
        self.default = Default::Special;
        self
    }

    /// A parameter that shows and changes a setting; blank keeps it.
    pub const fn of(name: &'static str, kind: Kind, setting: Setting) -> Self {
        let mut param = Self::keep(name, kind);
        param.setting = Some(setting);
        param
    }

    /// The same with documentation.
    pub const fn about(mut self, doc: &'static str) -> Self {
        self.doc = doc;
        self
    }
}

impl CommandSpec {
    /// An entry; see the fields.
    pub const fn new(
        letters: &'static str,
        name: &'static str,
        group: Group,
        params: &'static [ParamSpec],
        stack: Stack,
        doc: &'static str,
        act: Act,
    ) -> Self {
        Self { letters, name, group, params, stack, doc, act }
    }

    /// Returns `true` if all it does is to call the place where the tool stands by another number.
    pub const fn names_place(&self) -> bool {
        use super::act::Value;
        matches!(self.act, Act::Zero(_) | Act::Value(Value::Locations(_)))
    }

    /// Returns `true` if it can neither move nor switch anything, nor call a place by another number.
    pub fn moves_nothing(&self) -> bool {
        use super::act::{Mode, Move, Record, Utility, Value};
        match self.act {
            Act::Help | Act::Move(Move::Speeds) => true,
            Act::Mode(mode) => matches!(
                mode,
                Mode::Distance(_)
                    | Mode::MoveCut
                    | Mode::Preview
                    | Mode::ClearVariables
                    | Mode::Warning
            ),
            // Torch, laser and heater are switched by their values, outputs by their modes; the tool offset is a place.
            Act::Value(value) => {
                !matches!(value, Value::Locations(_) | Value::Height)
                    && !matches!(self.letters, "VN" | "VO")
            }
            Act::Record(record) => {
                matches!(record, Record::Switch(_) | Record::Save | Record::Clear)
            }
            Act::Utility(utility) => !matches!(utility, Utility::LoadSettings | Utility::Firmware),
            _ => false,
        }
    }

    /// Returns `true` if it changes what the machine is set to, which a password may protect.
    pub fn sets_machine(&self) -> bool {
        let value = self.group == Group::Values && self.letters != "VA";
        value || self.letters == "UR" || self.params.iter().any(|param| param.setting.is_some())
    }
}
