//! The one map of inputs and outputs: the names that jobs and people use, and the lines they stand
//! for (Profiler reference, "Hardware Input and Output"; readings, P-49 to P-62).
//!
//! Lines 1 … 12 are the switches of part files. Behind them come the ports of the card, a byte each:
//! ports B and C for outputs, ports A and B for inputs.

use crate::wiring::{Bit, Port};
use kerf_program::Axis;
use kerf_program::settings::SWITCHES;

/// Lines of one port.
pub const PORT_LINES: u8 = 8;

/// The line of a bit of a port, the first port behind the switches being 0.
const fn line(port: u8, bit: u8) -> u8 {
    SWITCHES as u8 + 1 + PORT_LINES * port + bit
}

/// The pin of an input that a line stands for: its port, A or B, and its place there.
pub(crate) const fn port_bit(line: u8) -> Option<(Port, u8)> {
    let behind = line.wrapping_sub(SWITCHES as u8 + 1);
    match behind / PORT_LINES {
        0 => Some((Port::A, behind % PORT_LINES)),
        1 => Some((Port::B, behind % PORT_LINES)),
        _ => None,
    }
}

/// The line of a pin of an input port.
pub const fn line_of_pin(bit: &Bit) -> u8 {
    line(bit.port as u8, bit.place)
}

/// A list of lines with names, ports and bits.
macro_rules! lines {
    ($(#[$meta:meta])* $name:ident { $($(#[$line_meta:meta])* $line:ident = $word:literal, $port:literal, $bit:literal;)* }) => {
        $(#[$meta])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum $name {
            $($(#[$line_meta])* $line,)*
        }

        impl $name {
            /// All of them, in the order of their lines.
            pub const ALL: &'static [Self] = &[$(Self::$line,)*];

            /// The line.
            pub const fn number(self) -> u8 {
                match self { $(Self::$line => line($port, $bit),)* }
            }

            /// The name.
            pub const fn name(self) -> &'static str {
                match self { $(Self::$line => $word,)* }
            }

            /// Returns the one with the given number, if there is one.
            pub fn of_number(number: u8) -> Option<Self> {
                Self::ALL.iter().copied().find(|line| line.number() == number)
            }

            /// The line of a name.
            pub fn of_name(name: &str) -> Option<Self> {
                Self::ALL.iter().copied().find(|line| line.name().eq_ignore_ascii_case(name))
            }
        }
    };
}

lines! {
    /// Outputs that jobs switch. Port 0 is B of the card, port 1 is C.
    Output {
        /// Tool 1: on while the tool is down.
        Tool1 = "tool1", 0, 0;
        /// Cut 1: on while material is cut.
        Cut1 = "cut1", 0, 1;
        /// Tool 2.
        Tool2 = "tool2", 0, 2;
        /// Cut 2.
        Cut2 = "cut2", 0, 3;
        /// Tool 3.
        Tool3 = "tool3", 0, 4;
        /// Cut 3.
        Cut3 = "cut3", 0, 5;
        /// Router, spindle or shutter: on through the job, off in a pause.
        Router = "router", 0, 6;
        /// A job runs, pauses included.
        JobRunning = "job_running", 0, 7;
        /// Jig 1 is being cut.
        Jig1 = "jig1", 1, 0;
        /// Jig 2 is being cut.
        Jig2 = "jig2", 1, 1;
    }
}

lines! {
    /// Inputs that jobs look at. Port 0 is A of the card, port 1 is B.
    Input {
        /// The switch of Z.
        ZHome = "zhome", 0, 0;
        /// The switch of W, Too-Close of a plasma head, or the external start and door.
        WHome = "whome", 0, 1;
        /// The switch of X.
        XHome = "xhome", 0, 2;
        /// The switch of Y.
        YHome = "yhome", 0, 3;
        /// The head is too high.
        ZHigh = "zhigh", 0, 4;
        /// The end of the bottom delay; with plasma, the arc.
        EndBottomDelay = "end_bottom_delay", 0, 5;
        /// The emergency stop.
        EmergencyStop = "estop", 0, 6;
        /// The head is too low.
        ZLow = "zlow", 0, 7;
        /// Jig 1 is ready.
        Jig1 = "jig1", 1, 0;
        /// Jig 2 is ready.
        Jig2 = "jig2", 1, 1;
        /// No wire of the card: the height sensor sends no readings.
        NoReadings = "no_readings", 2, 0;
        /// No reading for too long while height control acts, which the controller notices itself.
        HeightSilent = "height_silent", 2, 1;
        /// Too high and too low at once.
        HeightConflict = "height_conflict", 2, 2;
        /// Height control carried Z up to 0.
        HeightAtZero = "height_at_zero", 2, 3;
    }
}

/// Other names of inputs.
const ALIASES: [(&str, Input); 5] = [
    ("bdel", Input::EndBottomDelay),
    ("arc", Input::EndBottomDelay),
    ("too_close", Input::WHome),
    ("door", Input::WHome),
    ("stop", Input::EmergencyStop),
];

impl Output {
    /// Tool output 1 … 3; the first for any other number.
    pub const fn tool(number: u8) -> Self {
        match number {
            2 => Self::Tool2,
            3 => Self::Tool3,
            _ => Self::Tool1,
        }
    }

    /// Cut output 1 … 3; the first for any other number.
    pub const fn cut(number: u8) -> Self {
        match number {
            2 => Self::Cut2,
            3 => Self::Cut3,
            _ => Self::Cut1,
        }
    }
}

impl Input {
    /// The home switch of an axis.
    pub const fn home_of(axis: Axis) -> Option<Self> {
        match axis {
            Axis::X => Some(Self::XHome),
            Axis::Y => Some(Self::YHome),
            Axis::Z | Axis::A => Some(Self::ZHome),
            Axis::C => Some(Self::WHome),
            Axis::B => None,
        }
    }

    /// The line of a name or of another name of it; `port.bit` names too, as `a5` or `in.b0`.
    pub fn named(name: &str) -> Option<Self> {
        let name = name.strip_prefix("in.").unwrap_or(name);
        let alias = ALIASES.iter().find(|(word, _)| word.eq_ignore_ascii_case(name));
        Self::of_name(name).or(alias.map(|(_, input)| *input))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_lie_behind_the_switches_in_order() {
        let outputs: Vec<u8> = Output::ALL.iter().map(|line| line.number()).collect();
        assert_eq!(outputs, [13, 14, 15, 16, 17, 18, 19, 20, 21, 22]);
        let inputs: Vec<u8> = Input::ALL.iter().map(|line| line.number()).collect();
        assert_eq!(inputs, [13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 29, 30, 31, 32]);
    }

    #[test]
    fn lines_are_found_by_name_and_number() {
        assert_eq!(Output::of_number(19), Some(Output::Router));
        assert_eq!(Output::of_number(4), None);
        assert_eq!(Input::named("in.Whome"), Some(Input::WHome));
        assert_eq!(Input::named("arc"), Some(Input::EndBottomDelay));
    }
}
