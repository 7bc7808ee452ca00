//! R commands: what was typed is recorded and can be run again (readings, A-132).

use super::{Act, CommandSpec, Group, Kind, ParamSpec, Stack, act};

pub(super) static SPECS: [CommandSpec; 6] = [
    CommandSpec::new(
        "RA",
        "Record on",
        Group::Record,
        &[],
        Stack::Joins,
        "Records the commands typed from here on; that is so from the beginning.",
        Act::Record(act::Record::Switch(true)),
    ),
    CommandSpec::new(
        "RI",
        "Record off",
        Group::Record,
        &[],
        Stack::Joins,
        "Stops recording; what was recorded stays.",
        Act::Record(act::Record::Switch(false)),
    ),
    CommandSpec::new(
        "RP",
        "Play all",
        Group::Record,
        &[],
        Stack::Ends,
        "Runs all recorded commands again, 100 at most.",
        Act::Record(act::Record::PlayAll),
    ),
    CommandSpec::new(
        "RR",
        "Replay",
        Group::Record,
        &[
            ParamSpec::keep("Commands back", Kind::Text)
                .about("How many, 100 at most, or A for all; 1 when blank."),
            ParamSpec::keep("Repetitions", Kind::Whole).about("1 when blank."),
        ],
        Stack::Ends,
        "Runs the last recorded commands again, with their parameters as they were entered.",
        Act::Record(act::Record::Replay),
    ),
    CommandSpec::new(
        "RS",
        "Save recorded",
        Group::Record,
        &[
            ParamSpec::keep("File", Kind::File).about("SBTEMP.SBP when blank."),
            ParamSpec::keep("Commands back", Kind::Whole).about("All when blank."),
        ],
        Stack::Ends,
        "Writes recorded commands into a part file and opens it in the editor.",
        Act::Record(act::Record::Save),
    ),
    CommandSpec::new(
        "RZ",
        "Clear recorded",
        Group::Record,
        &[],
        Stack::Joins,
        "Forgets all recorded commands; recording goes on as it was.",
        Act::Record(act::Record::Clear),
    ),
];
