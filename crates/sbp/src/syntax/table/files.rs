//! File commands: run a part file, choose the part folder, show a file.

use super::{Act, Bound, CommandSpec, Group, Kind, ParamSpec, Stack, Unit, act};

const PROPORTION: Kind = Kind::Number(Unit::None);

/// The parameters of FP and FG.
static RUN: [ParamSpec; 11] = [
    ParamSpec::required("File name", Kind::File).about(
        "Looked for in the current part folder, ignoring case; may carry a path or be a variable. \
         Without an extension .sbp is tried as well.",
    ),
    ParamSpec::number("Proportion X", PROPORTION, 1.0).about("Scales every X value of the file."),
    ParamSpec::number("Proportion Y", PROPORTION, 1.0).about("Scales every Y value of the file."),
    ParamSpec::number("Proportion Z", PROPORTION, 1.0).about(
        "Scales every Z value of the file. Calls with .5, .85 and 1 cut a file in three passes.",
    ),
    ParamSpec::number("Repetitions", Kind::Whole, 1.0)
        .within(Bound::Range(0.0, 4_294_967_295.0))
        .about("How often the whole file runs, each time from where the tool is; 0 as 1."),
    ParamSpec::number("Offset", Kind::OneOf(&[0, 1, 2]), 0.0).about(
        "0: locations as written. 1: the present X, Y, Z counts as 0,0,0 in the file. 2: only the \
         present X, Y; Z as written.",
    ),
    ParamSpec::number("Plunge", Kind::Number(Unit::Length), 0.0).about(
        "How far Z moves before each repetition; negative is down unless VC says otherwise. Z \
         returns after the last one. For files without Z moves.",
    ),
    ParamSpec::number("Tabs", Kind::OneOf(&[0, 1]), 0.0)
        .about("1: leave tabs (see VB) on the last repetition, also in files that this one calls."),
    ParamSpec::number("Plunge from Z 0", Kind::OneOf(&[0, 1]), 0.0)
        .about("1: Z moves to 0 first, so that plunges count from there."),
    // Files in use carry two more values that the manuals do not describe.
    ParamSpec::obsolete(),
    ParamSpec::obsolete(),
];

pub(super) static SPECS: &[CommandSpec] = &[
    CommandSpec::new(
        "FP",
        "Run part file",
        Group::File,
        &RUN,
        Stack::Ends,
        "Runs another part file and comes back when it ends. Proportions and offset add to those \
         of the calling file. Up to eight files may be open within each other.",
        Act::File(act::File::Run),
    ),
    CommandSpec::new(
        "FG",
        "Step through part file",
        Group::File,
        &RUN,
        Stack::Ends,
        "Opens a file to go through it line by line. Before each line the operator steps, goes to \
         another line, lets the file run from here, or quits. When nobody answers it runs as with \
         FP.",
        Act::File(act::File::StepThrough),
    ),
    CommandSpec::new(
        "FE",
        "Edit file",
        Group::File,
        &[ParamSpec::keep("File name", Kind::File)
            .special()
            .about("The file to show. Blank: the last one that ran, or an empty page.")],
        Stack::Ends,
        "Opens a file in the editor. In a part file it shows the file to the operator; the part \
         file goes on when the editor is closed.",
        Act::File(act::File::Edit),
    ),
    CommandSpec::new(
        "FN",
        "New file",
        Group::File,
        &[],
        Stack::Ends,
        "Opens the editor with a new, empty part file.",
        Act::File(act::File::New),
    ),
    CommandSpec::new(
        "FS",
        "Set part folder",
        Group::File,
        &[
            ParamSpec::keep("Folder", Kind::File).special().about(
                "A path, or a name below the present folder, or .. for the one above. Blank: the \
                 folder at the start, unless only a mask is given.",
            ),
            ParamSpec::keep("Search mask", Kind::Text)
                .special()
                .about("Which files lists show: *.sb? at first. It has no effect on a run."),
        ],
        Stack::Ends,
        "Sets the folder that part files are looked for in. It stays when the file ends.",
        Act::File(act::File::Folder),
    ),
    CommandSpec::new(
        "FC",
        "Convert file",
        Group::File,
        &[ParamSpec::keep("File name", Kind::File)
            .special()
            .about("A .dxf, .plt, .hpg, .nc, .tap, .bmp, .jpg or .png file. Blank: asks for one.")],
        Stack::Ends,
        "Converts a drawing, a picture or a G-code file to a part file. Asks what the file does not say: \
         its unit, how deep is cut, how far above the surface the tool travels, how large it becomes.",
        Act::File(act::File::Convert),
    ),
];
