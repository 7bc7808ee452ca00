//! Settings files and what belongs to the installation: US, UR, UN, UI.

use super::{Act, CommandSpec, Group, Kind, ParamSpec, Stack, act};

pub(super) static SPECS: &[CommandSpec] = &[
    CommandSpec::new(
        "US",
        "Save settings",
        Group::Utilities,
        &[ParamSpec::keep("Name", Kind::File).about("Blank: asks for one.")],
        Stack::Ends,
        "Saves all major settings into a settings file (.sbd), which is a part file that sets them.",
        Act::Utility(act::Utility::SaveSettings),
    ),
    CommandSpec::new(
        "UR",
        "Load settings",
        Group::Utilities,
        &[
            ParamSpec::keep("Name", Kind::File).about("Blank: asks which of those there are."),
            ParamSpec::keep("Delete system log", Kind::OneOf(&[0, 1]))
                .about("1 begins the system log anew, 0 keeps it. Blank: asks."),
        ],
        Stack::Ends,
        "Runs a settings file: everything is set as it says.",
        Act::Utility(act::Utility::LoadSettings),
    ),
    CommandSpec::new(
        "UN",
        "Name the editor",
        Group::Utilities,
        &[ParamSpec::keep("Program", Kind::File).about("Blank: the built-in editor.")],
        Stack::Ends,
        "Names the program that FE starts at a terminal.",
        Act::Utility(act::Utility::Editor),
    ),
    CommandSpec::new(
        "UI",
        "Install firmware",
        Group::Utilities,
        &[],
        Stack::Ends,
        "Loads the firmware of a controller that has one.",
        Act::Utility(act::Utility::Firmware),
    ),
];
