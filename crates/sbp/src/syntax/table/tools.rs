//! T commands: virtual tools, those of Kerf and those that somebody added.

use super::{Act, CommandSpec, Group, Kind, ParamSpec, Stack};

const fn value(name: &'static str) -> ParamSpec {
    ParamSpec::keep(name, Kind::Text)
}

/// Values with which a tool is started.
const VALUES: &[ParamSpec] = &[
    value("Value 1").about(
        "Handed to the tool as it is. Tools of Kerf take KEY=VALUE, or values in the order of their form.",
    ),
    value("Value 2"),
    value("Value 3"),
    value("Value 4"),
    value("Value 5"),
    value("Value 6"),
    value("Value 7"),
    value("Value 8"),
    value("Value 9"),
    value("Value 10"),
    value("Value 11"),
    value("Value 12"),
    value("Value 13"),
    value("Value 14"),
    value("Value 15"),
    value("Value 16"),
    value("Value 17"),
    value("Value 18"),
];

macro_rules! tools {
    ($($letters:literal $letter:literal $name:literal $doc:literal)*) => {
        [$(CommandSpec::new($letters, $name, Group::Tools, VALUES, Stack::Ends, $doc, Act::Tool($letter))),*]
    };
}

pub(super) static SPECS: [CommandSpec; 10] = tools! {
    "TC" 'C' "Copy machine" "Makes a file by probing an object."
    "TD" 'D' "Drill press" "Makes a part file that drills holes."
    "TF" 'F' "Fluter" "Makes a part file that cuts flutes."
    "TH" 'H' "Header writer" "Writes a head into a part file."
    "TI" 'I' "Indexer" "Makes a part file that turns the indexer."
    "TM" 'M' "Height map" "Makes a part file that probes a surface on a grid."
    "TP" 'P' "Probe" "Makes a program that finds a place or an angle by touch, and sets zero there."
    "TS" 'S' "Setup" "Records how the machine is equipped for zeroing."
    "TT" 'T' "Typesetter" "Makes a part file that carves text."
    "TU" 'U' "Tabletop surfacer" "Makes a part file that planes the table."
};

/// The letters that are left for tools which somebody adds.
pub(crate) static ADDED: [CommandSpec; 15] = tools! {
    "TA" 'A' "Added tool" "" "TB" 'B' "Added tool" "" "TE" 'E' "Added tool" ""
    "TG" 'G' "Added tool" "" "TJ" 'J' "Added tool" "" "TK" 'K' "Added tool" ""
    "TL" 'L' "Added tool" "" "TN" 'N' "Added tool" ""
    "TO" 'O' "Added tool" "" "TQ" 'Q' "Added tool" ""
    "TV" 'V' "Added tool" "" "TW" 'W' "Added tool" "" "TX" 'X' "Added tool" ""
    "TY" 'Y' "Added tool" "" "TZ" 'Z' "Added tool" ""
};
