//! Inputs, the emergency stop, jobs, and what else there is.

use super::Bounds;
use super::Bounds::{Any, NotNegative, OneOf, Range};
use super::setting::{Area, Setting, row};
use kerf_program::settings::SWITCHES;

pub(super) const AREAS: &[Area] = &[
    Area { title: "Inputs", manual: "Profiler, Hardware Input and Output", rows: INPUTS },
    Area { title: "Pendant", manual: "command reference, VD, Keypad remote", rows: PENDANT },
    Area { title: "Emergency stop", manual: "Profiler, Emergency Stopping", rows: ESTOP },
    Area { title: "Jobs", manual: "Profiler, Machining the Job", rows: JOB },
    Area {
        title: "Miscellaneous",
        manual: "Profiler, Miscellaneous Configuration Options",
        rows: MISC,
    },
    Area {
        title: "Options of the program",
        manual: "Profiler, General Options, Communication",
        rows: OPTIONS,
    },
];

const INPUTS: &[Setting] = &[
    row!(
        c,
        "ports.card",
        c.io.card,
        None,
        Any,
        "How inputs are wired: none, pci (active when grounded) or io (active when positive)."
    ),
    row!(
        c,
        "ports.invert_a",
        c.io.invert_a,
        None,
        Any,
        "Inputs A0 to A7 whose level is turned round."
    ),
    row!(
        c,
        "ports.invert_b",
        c.io.invert_b,
        None,
        Any,
        "Inputs B0 to B7 whose level is turned round."
    ),
];

/// Any of the switches of part files, or none.
const SWITCH: Bounds = Range(0.0, SWITCHES as f64);

/// The two keys of an axis.
macro_rules! keys {
    ($c:ident, $key:literal, $at:literal, $letter:literal) => {
        row!(
            $c,
            $key,
            $c.pendant.axes[$at],
            None,
            SWITCH,
            concat!("Inputs that are the keys ", $letter, "+ and ", $letter, "-; 0 for no key.")
        )
    };
}

const PENDANT: &[Setting] = &[
    keys!(c, "pendant.x", 0, "X"),
    keys!(c, "pendant.y", 1, "Y"),
    keys!(c, "pendant.z", 2, "Z"),
    keys!(c, "pendant.a", 3, "A"),
    keys!(c, "pendant.b", 4, "B"),
    keys!(c, "pendant.c", 5, "C"),
    row!(
        c,
        "pendant.fast",
        c.pendant.fast,
        None,
        SWITCH,
        "Input that is the key for jog speed: held, the others move so fast; 0 for no key."
    ),
    row!(
        c,
        "pendant.close",
        c.pendant.close,
        None,
        SWITCH,
        "Input that is the key which closes the keypad; 0 for no key."
    ),
];

const ESTOP: &[Setting] = &[
    row!(
        c,
        "estop.active",
        c.estop.active,
        None,
        Any,
        "The level that stops: 1, or 0 so that a broken wire stops too."
    ),
    row!(
        c,
        "estop.cuts_power",
        c.estop.cuts_power,
        None,
        Any,
        "Input 4 cuts the power of spindles at once, of motors 5 s later (alpha tools): nothing resumes."
    ),
];

const JOB: &[Setting] = &[
    row!(
        c,
        "job.origin_mm",
        c.job.origin_mm,
        Mm,
        Any,
        "Where the job origin lies: X and Y from home. A job that has one of its own keeps it."
    ),
    row!(
        c,
        "job.finish_mm",
        c.job.finish_mm,
        Mm,
        Any,
        "Where the head goes when a job is done: X and Y from the job origin."
    ),
    row!(
        c,
        "job.change_origin_at_start",
        c.job.change_origin_at_start,
        None,
        Any,
        "Each Start takes the present position as job origin."
    ),
    row!(
        c,
        "job.repeats",
        c.job.repeats,
        None,
        Range(1.0, u32::MAX as f64),
        "How often a job is cut."
    ),
    row!(
        c,
        "job.external_start",
        c.job.external_start,
        None,
        Any,
        "The input shared with W home starts jobs, or is the door that must be shut."
    ),
    row!(
        c,
        "job.heads",
        c.job.heads,
        None,
        Any,
        "Which heads cut a job: z alone, or both, the second beside the first."
    ),
    row!(c, "job.two_jigs", c.job.two_jigs, None, Any, "Two jigs with a start input each."),
    row!(
        c,
        "job.divider_mm",
        c.job.divider_mm,
        Mm,
        Any,
        "What lies left of this X from machine home is jig 1."
    ),
];

const MISC: &[Setting] = &[
    row!(
        c,
        "misc.double_start",
        c.misc.double_start,
        None,
        Any,
        "The first Start prepares and waits, the second cuts."
    ),
    row!(
        c,
        "misc.tangential",
        c.misc.tangential,
        None,
        Any,
        "The w axis keeps the tool along the path."
    ),
    row!(
        c,
        "misc.tangential_endless",
        c.misc.tangential_endless,
        None,
        Any,
        "The tangential axis turns without end: jobs do not mind the limits of C."
    ),
    row!(
        c,
        "misc.runtime_drawing",
        c.misc.runtime_drawing,
        None,
        Range(0.0, 10.0),
        "Live drawing: 0 never in motion, 10 always, n up to n tenths of the highest speed."
    ),
    row!(
        c,
        "misc.outputs_stay_on",
        c.misc.outputs_stay_on,
        None,
        Any,
        "Outputs stay on when the machine stands and is stopped, disarmed or left by whoever drove it."
    ),
];

const OPTIONS: &[Setting] = &[
    row!(c, "options.devices", c.options.devices, None, Any, "Devices of the serial ports 1 to 4."),
    row!(
        c,
        "options.console",
        c.options.console,
        None,
        Any,
        "There is a hand console at its serial port, which the machine version opens."
    ),
    row!(
        c,
        "options.console_port",
        c.options.console_port,
        None,
        Range(1.0, 4.0),
        "Serial port of the hand console."
    ),
    row!(
        c,
        "options.console_baud",
        c.options.console_baud,
        Baud,
        Range(2400.0, 2400.0),
        "Its speed."
    ),
    row!(
        c,
        "options.send_port",
        c.options.send_port,
        None,
        Range(1.0, 4.0),
        "Serial port of file sending."
    ),
    row!(
        c,
        "options.send_baud",
        c.options.send_baud,
        Baud,
        OneOf(&[2400.0, 4800.0, 9600.0, 19_200.0, 38_400.0]),
        "Its speed."
    ),
    row!(
        c,
        "options.controller",
        c.options.controller,
        None,
        Any,
        "The controller of this machine, as --machine names it: grbl:/dev/ttyUSB0; blank is the simulated machine. It is \
         driven where --machine names this file or saved machine."
    ),
    row!(
        c,
        "options.firmware",
        c.options.firmware,
        None,
        Any,
        "Command that loads firmware into a real controller (UI); {port} stands for its port."
    ),
    row!(
        c,
        "options.warm_up",
        c.options.warm_up,
        None,
        Any,
        "Steps in which the spindle warms up: percent of its greatest speed and minutes, 25:2, 50:2."
    ),
    row!(
        c,
        "options.password",
        c.options.password,
        None,
        Any,
        "Salted hash of the password that changing settings needs."
    ),
    row!(
        c,
        "options.filter_mm",
        c.options.filter_mm,
        Mm,
        NotNegative,
        "Vertices of paths nearer to each other than this are left out; 0 none."
    ),
    row!(
        c,
        "options.join_mm",
        c.options.join_mm,
        Mm,
        NotNegative,
        "Joining distance that is offered."
    ),
    row!(
        c,
        "options.pick_radius_px",
        c.options.pick_radius_px,
        Pixels,
        Range(1.0, 50.0),
        "Radius within which the mouse selects."
    ),
    row!(
        c,
        "options.window_expansion_percent",
        c.options.window_expansion_percent,
        Percent,
        Range(0.0, 100.0),
        "So much larger than what is drawn is the window that shows all of it."
    ),
];
