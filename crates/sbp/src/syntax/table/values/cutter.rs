//! VC: the cutter, safe heights, and the output that Z or A switches.

use crate::syntax::Value;
use crate::syntax::table::setting::{axis, flag, real, whole};
use crate::syntax::table::{
    Act, Bound, CommandSpec, Group, Kind, ParamSpec, Setting, Stack, Unit, act,
};
use kerf_program::Axis;
use kerf_program::settings::PlungeSign;

const LENGTH: Kind = Kind::Number(Unit::Length);

static PARAMS: [ParamSpec; 12] = [
    ParamSpec::of("Cutter diameter", LENGTH, real!(cutter.diameter_mm)).within(Bound::NotNegative),
    ParamSpec::obsolete(),
    ParamSpec::obsolete(),
    ParamSpec::of("Safe-Z", Kind::NumberOrOff(Unit::Length), SAFE_Z)
        .about("Height for MH, JH and travel; OFF lifts nothing."),
    ParamSpec::of("Plunge direction", Kind::Word(&["-", "+", "0", "1", "-1"]), PLUNGE).about(
        "- when negative plunges go down, + when positive ones do. Older files write 0 for -.",
    ),
    ParamSpec::of(
        "Pocket overlap",
        Kind::Number(Unit::Percent),
        real!(cutter.pocket_overlap_percent),
    )
    .within(Bound::Below(0.0, 100.0))
    .about("How much of the cutter runs over the ring before."),
    ParamSpec::of("Safe-A", Kind::Number(Unit::Axis(Axis::A)), real!(cutter.safe_a_mm))
        .about("Height of the A axis for MH and JH."),
    ParamSpec::of("Triggered output", Kind::OneOf(&[0, 1]), flag!(cutter.trigger.active))
        .about("1 switches an output by vertical moves, until the part file ends."),
    ParamSpec::of("Trigger on threshold", LENGTH, real!(cutter.trigger.on_at_mm))
        .about("On when a plunge passes this location."),
    ParamSpec::of("Trigger off threshold", LENGTH, real!(cutter.trigger.off_at_mm))
        .about("Off when a pull-up passes this location."),
    ParamSpec::of("Axis monitored", Kind::Word(&["Z", "A"]), axis!(cutter.trigger.axis)),
    ParamSpec::of(
        "Triggered output number",
        Kind::OneOf(&[3, 5, 6, 7, 8, 9, 10, 11, 12]),
        whole!(cutter.trigger.output),
    ),
];

const SAFE_Z: Setting = Setting {
    read: |s| Some(s.cutter.safe_z_mm.map_or_else(|| Value::text("OFF"), Value::Number)),
    write: |s, v| s.cutter.safe_z_mm = v.number(),
};

const PLUNGE: Setting = Setting {
    read: |s| Some(Value::text(if s.cutter.plunge == PlungeSign::Plus { "+" } else { "-" })),
    write: |s, v| {
        let plus = matches!(v.display().as_str(), "+" | "1");
        s.cutter.plunge = if plus { PlungeSign::Plus } else { PlungeSign::Minus };
    },
};

pub(super) static VC: CommandSpec = CommandSpec::new(
    "VC",
    "Values: cutter",
    Group::Values,
    &PARAMS,
    Stack::Ends,
    "Cutter diameter for inside and outside cuts, safe heights, the sign of a plunge, the overlap of \
     pockets, and an output that vertical moves of Z or A switch.",
    Act::Value(act::Value::Cutter),
);
