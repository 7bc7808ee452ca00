//! Motors: which drives what, which way, and how it is pulsed (Profiler reference, "Motor
//! Parameters", "Microstepping Drive Parameters").

use super::words;
use kerf_program::{AXES, Axis, AxisSet};

/// Motors a machine can have.
pub const MOTORS: usize = 6;

words! {
    /// A motor, by the name on its step and direction terminals.
    #[allow(missing_docs)]
    Motor { X = "x", Y = "y", Z = "z", W = "w", Q = "q", R = "r" }
}

impl Motor {
    /// All motors in order.
    pub const ALL: [Self; MOTORS] = [Self::X, Self::Y, Self::Z, Self::W, Self::Q, Self::R];

    /// Its place in lists of motors.
    pub const fn index(self) -> usize {
        self as usize
    }
}

words! {
    /// A motor that may drive any of the further axes; X, Y and Z drive their own.
    #[allow(missing_docs)]
    FreeMotor { W = "w", Q = "q", R = "r" }
}

impl From<FreeMotor> for Motor {
    fn from(motor: FreeMotor) -> Self {
        match motor {
            FreeMotor::W => Self::W,
            FreeMotor::Q => Self::Q,
            FreeMotor::R => Self::R,
        }
    }
}

words! {
    /// Which way a motor turns for a positive move.
    Direction {
        /// The direction bit is 1 for a positive move.
        Forwards = "forwards",
        /// The direction bit is 0 for a positive move.
        Backwards = "backwards",
    }
}

/// The motors of the machine.
#[derive(Clone, Debug, PartialEq)]
pub struct Motors {
    /// Second motor of X; runs with it except while homing.
    pub x2: Option<FreeMotor>,
    /// Second motor of Y; runs with it except while homing.
    pub y2: Option<FreeMotor>,
    /// Motor of the second head, which is axis A of part files.
    pub z2: Option<FreeMotor>,
    /// Motor of axis A where it is no second head.
    pub a: Option<FreeMotor>,
    /// Motor of axis B.
    pub b: Option<FreeMotor>,
    /// Motor of the tangential or rotary axis `w`, axis C of part files.
    pub w: Option<FreeMotor>,
    /// Positive direction of each axis' motor: X, Y, Z, A, B, C (`w`).
    pub direction: [Direction; AXES],
    /// From a change of direction to the step, beside the output delay, nanoseconds; 0 outputs both
    /// at once.
    pub dir_delay_ns: u32,
    /// Widens the step pulse, nanoseconds.
    pub step_delay_ns: u32,
}

impl Motors {
    /// The motors beside X, Y and Z, each with the key of its setting.
    pub const fn further(&self) -> [(&'static str, Option<FreeMotor>); 6] {
        [
            ("motors.x2", self.x2),
            ("motors.y2", self.y2),
            ("motors.z2", self.z2),
            ("motors.a", self.a),
            ("motors.b", self.b),
            ("motors.w", self.w),
        ]
    }

    /// The motors of an axis, its own first.
    pub fn of_axis(&self, axis: Axis) -> Vec<Motor> {
        Motor::ALL.into_iter().filter(|motor| self.axis_of(*motor) == Some(axis)).collect()
    }

    /// The axis that people call by a letter: by its name in the Profiler tables, else in OpenSBP.
    pub fn axis_called(&self, letter: char) -> Option<Axis> {
        let is_called = |axis: &Axis| self.axis_name(*axis).starts_with(letter);
        Axis::ALL.into_iter().find(is_called).or_else(|| Axis::from_letter(letter))
    }

    /// The axes that have a motor.
    pub fn axes(&self) -> AxisSet {
        let moved = Axis::ALL.into_iter().filter(|axis| !self.of_axis(*axis).is_empty());
        moved.fold(AxisSet::EMPTY, AxisSet::with)
    }

    /// Returns the name of an axis in the Profiler tables: A is `z2` where it is the second head, C is `w`.
    pub const fn axis_name(&self, axis: Axis) -> &'static str {
        match axis {
            Axis::X => "x",
            Axis::Y => "y",
            Axis::Z => "z",
            Axis::A if self.z2.is_some() => "z2",
            Axis::A => "a",
            Axis::B => "b",
            Axis::C => "w",
        }
    }

    /// The axis that a motor drives, if it drives one.
    pub fn axis_of(&self, motor: Motor) -> Option<Axis> {
        let further = [
            (self.x2, Axis::X),
            (self.y2, Axis::Y),
            (self.z2, Axis::A),
            (self.a, Axis::A),
            (self.b, Axis::B),
            (self.w, Axis::C),
        ];
        match motor {
            Motor::X => Some(Axis::X),
            Motor::Y => Some(Axis::Y),
            Motor::Z => Some(Axis::Z),
            free => {
                let drives = |given: Option<FreeMotor>| given.map(Motor::from) == Some(free);
                further.into_iter().find(|(given, _)| drives(*given)).map(|(_, axis)| axis)
            }
        }
    }
}

impl Default for Motors {
    fn default() -> Self {
        Self {
            x2: None,
            y2: None,
            z2: None,
            a: None,
            b: None,
            w: None,
            direction: [Direction::Forwards; AXES],
            dir_delay_ns: 0,
            step_delay_ns: 0,
        }
    }
}
