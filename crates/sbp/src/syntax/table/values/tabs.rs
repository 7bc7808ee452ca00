//! VB: tabs.

use crate::syntax::Value;
use crate::syntax::table::setting::{flag, real};
use crate::syntax::table::{
    Act, Bound, CommandSpec, Group, Kind, ParamSpec, Setting, Stack, Unit, act,
};

const LENGTH: Kind = Kind::Number(Unit::Length);

static PARAMS: [ParamSpec; 7] = [
    ParamSpec::of("Pull-up", LENGTH, real!(tabs.up_mm))
        .within(Bound::NotNegative)
        .about("Thickness of a tab."),
    ParamSpec::of("Distance to next tab", LENGTH, real!(tabs.next_mm))
        .within(Bound::Positive)
        .about("Path between the end of a tab and the next."),
    ParamSpec::of("Size", LENGTH, real!(tabs.size_mm))
        .within(Bound::NotNegative)
        .about("Length of the flat top, at the centre of the cutter."),
    ParamSpec::of("Leads", LENGTH, real!(tabs.lead_mm))
        .within(Bound::NotNegative)
        .about("Length of the incline before and after the top."),
    ParamSpec::of("On", Kind::OneOf(&[0, 1]), flag!(tabs.on))
        .about("1 begins tabs here, 0 ends them; a file ends them too."),
    ParamSpec::of("Number", Kind::Whole, COUNT)
        .within(Bound::AtLeast(1.0))
        .about("So many tabs after 1, then none."),
    ParamSpec::of("Start", LENGTH, START)
        .within(Bound::NotNegative)
        .about("Path to the first tab after 1; blank is the distance to the next."),
];

const COUNT: Setting = Setting {
    read: |s| s.tabs.count.map(|n| Value::Number(f64::from(n))),
    write: |s, v| s.tabs.count = v.number().map(|n| n as u32),
};

const START: Setting = Setting {
    read: |s| s.tabs.start_mm.map(Value::Number),
    write: |s, v| s.tabs.start_mm = v.number(),
};

pub(super) static VB: CommandSpec = CommandSpec::new(
    "VB",
    "Values: tabs",
    Group::Values,
    &PARAMS,
    Stack::Ends,
    "Size and spacing of tabs, the small bridges left on the last pass of a cut, and tabs on or off \
     from here on.",
    Act::Value(act::Value::Tabs),
);
