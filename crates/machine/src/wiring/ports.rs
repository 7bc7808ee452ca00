//! The bits of the ports.

/// A port of the card, a byte each.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Port {
    /// Steps of X, Y, Z, W; of inputs: switches and sensors.
    A,
    /// Tools, cuts, router; of inputs: jigs.
    B,
    /// Jigs; steps of Q and R.
    C,
}

impl Port {
    /// Its letter.
    pub const fn letter(self) -> char {
        match self {
            Self::A => 'A',
            Self::B => 'B',
            Self::C => 'C',
        }
    }
}

/// One bit of a port.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bit {
    /// Its port.
    pub port: Port,
    /// Its place, 0 to 7.
    pub place: u8,
    /// Its name.
    pub name: &'static str,
    /// Other names.
    pub aliases: &'static [&'static str],
    /// Its purpose.
    pub about: &'static str,
}

impl Bit {
    /// Port and place: `B2`.
    pub fn address(&self) -> String {
        format!("{}{}", self.port.letter(), self.place)
    }

    /// The byte in which only this bit is set.
    pub const fn mask(&self) -> u8 {
        1 << self.place
    }

    /// Returns `true` if a word means it: its name, another name of it, its address.
    pub fn is_called(&self, word: &str) -> bool {
        let named = |name: &&str| name.eq_ignore_ascii_case(word);
        named(&self.name) || self.aliases.iter().any(named) || named(&self.address().as_str())
    }
}

/// The output or input of a name; an output where both are called so.
pub fn bit(word: &str) -> Option<(bool, &'static Bit)> {
    let input = word.strip_prefix("in.").unwrap_or(word);
    let output = word.strip_prefix("out.").unwrap_or(word);
    let found = |bits: &'static [Bit], word: &str| bits.iter().find(|bit| bit.is_called(word));
    let as_output = if word.starts_with("in.") { None } else { found(OUTPUT_BITS, output) };
    as_output.map(|bit| (true, bit)).or_else(|| Some((false, found(INPUT_BITS, input)?)))
}

const fn of(
    port: Port,
    place: u8,
    name: &'static str,
    aliases: &'static [&'static str],
    about: &'static str,
) -> Bit {
    Bit { port, place, name, aliases, about }
}

use Port::{A, B, C};

/// Every output bit.
pub const OUTPUT_BITS: &[Bit] = &[
    of(A, 0, "xdir", &["x_dir"], "direction of motor X"),
    of(A, 1, "xstep", &["x_step"], "step of motor X"),
    of(A, 2, "ydir", &["y_dir"], "direction of motor Y"),
    of(A, 3, "ystep", &["y_step"], "step of motor Y"),
    of(A, 4, "zdir", &["z_dir"], "direction of motor Z"),
    of(A, 5, "zstep", &["z_step"], "step of motor Z"),
    of(A, 6, "wdir", &["w_dir"], "direction of motor W"),
    of(A, 7, "wstep", &["w_step"], "step of motor W"),
    of(B, 0, "tool1", &[], "tool 1: on while the tool is down"),
    of(B, 1, "cut1", &[], "cut 1: on while material is cut"),
    of(B, 2, "tool2", &[], "tool 2"),
    of(B, 3, "cut2", &[], "cut 2"),
    of(B, 4, "tool3", &[], "tool 3"),
    of(B, 5, "cut3", &[], "cut 3"),
    of(B, 6, "router", &["shutter"], "router or shutter: off in a pause"),
    of(B, 7, "job_running", &["run", "ex"], "a job runs, pauses included"),
    of(C, 0, "jig1", &[], "jig 1 is being cut"),
    of(C, 1, "jig2", &[], "jig 2 is being cut"),
    of(C, 2, "c2", &["router2"], "unassigned"),
    of(C, 3, "c3", &[], "unassigned"),
    of(C, 4, "qdir", &["q_dir", "r0"], "direction of motor Q"),
    of(C, 5, "qstep", &["q_step", "r1"], "step of motor Q"),
    of(C, 6, "rdir", &["r_dir", "q0"], "direction of motor R"),
    of(C, 7, "rstep", &["r_step", "q1"], "step of motor R"),
];

/// Every input bit.
pub const INPUT_BITS: &[Bit] = &[
    of(A, 0, "zhome", &["z2home"], "switch of Z, and of the second head"),
    of(
        A,
        1,
        "whome",
        &["too_close", "door"],
        "switch of W; too close of a plasma head; external start",
    ),
    of(A, 2, "xhome", &["x2home"], "switch of X, and of its second motor"),
    of(A, 3, "yhome", &["y2home"], "switch of Y, and of its second motor"),
    of(A, 4, "zhigh", &["hc-t"], "the head is too high"),
    of(A, 5, "end_bottom_delay", &["bdel", "arc"], "end of the bottom delay; with plasma the arc"),
    of(A, 6, "estop", &["stop"], "emergency stop"),
    of(A, 7, "zlow", &["hc-b"], "the head is too low"),
    of(B, 0, "jig1", &[], "jig 1 is ready"),
    of(B, 1, "jig2", &[], "jig 2 is ready"),
    of(B, 2, "b2", &["end_bottom_delay2"], "unassigned"),
    of(B, 3, "b3", &[], "unused"),
    of(B, 4, "b4", &[], "unused"),
    of(B, 5, "b5", &[], "unused"),
    of(B, 6, "b6", &[], "unused"),
    of(B, 7, "b7", &[], "unused"),
];
