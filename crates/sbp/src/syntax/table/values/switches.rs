//! VN: what inputs and outputs are for.

use crate::syntax::table::setting::{flag, whole};
use crate::syntax::table::{Act, CommandSpec, Group, Kind, ParamSpec, Stack, act};

macro_rules! input {
    ($name:literal, $index:literal) => {
        ParamSpec::of($name, Kind::OneOf(&[0, 1, 2, 3, 4]), whole!(io.inputs[$index])).about(
            "0 free for programs, 1 limit normally open, 2 limit normally closed, 3 stop normally \
             open, 4 stop normally closed.",
        )
    };
}

macro_rules! output {
    ($name:literal, $index:literal) => {
        ParamSpec::of($name, Kind::OneOf(&[0, 1, 2, 3, 4, 5]), whole!(io.outputs[$index])).about(
            "By command: 0 off at the end of a file, 1 left as it is, 2 also off during a stop. On \
             with the file: 3 off at its end, 4 left on, 5 off at its end and during a stop.",
        )
    };
}

static PARAMS: [ParamSpec; 26] = [
    ParamSpec::of("Limits", Kind::OneOf(&[0, 1]), flag!(io.limits_active))
        .about("1 lets limit inputs stop motion."),
    ParamSpec::of("Input 4 mode", Kind::OneOf(&[0, 1]), flag!(io.input4_normally_open))
        .about("Input 4 is a stop: 0 normally closed, 1 normally open."),
    ParamSpec::of("Torch, laser or analog", Kind::OneOf(&[0, 1, 2, 3, 4, 5]), whole!(io.analog))
        .about("0 none, 1 torch, 2 laser, 3 analog input 1, 4 analog input 2, 5 both."),
    input!("Input 1 mode", 0),
    input!("Input 2 mode", 1),
    input!("Input 3 mode", 2),
    input!("Input 5 mode", 4),
    input!("Input 6 mode", 5),
    input!("Input 7 mode", 6),
    input!("Input 8 mode", 7),
    input!("Input 9 mode", 8),
    input!("Input 10 mode", 9),
    input!("Input 11 mode", 10),
    input!("Input 12 mode", 11),
    output!("Output 1 mode", 0),
    output!("Output 2 mode", 1),
    output!("Output 3 mode", 2),
    output!("Output 4 mode", 3),
    output!("Output 5 mode", 4),
    output!("Output 6 mode", 5),
    output!("Output 7 mode", 6),
    output!("Output 8 mode", 7),
    output!("Output 9 mode", 8),
    output!("Output 10 mode", 9),
    output!("Output 11 mode", 10),
    output!("Output 12 mode", 11),
];

pub(super) static VN: CommandSpec = CommandSpec::new(
    "VN",
    "Values: inputs and outputs",
    Group::Values,
    &PARAMS,
    Stack::Ends,
    "What each input and output is for. Output 4 follows SO,4,-1 to -4 whatever its mode here. \
     Limits on or off go back at the end of a part file, unless SV keeps them.",
    Act::Value(act::Value::Set),
);
