//! VP: the preview's view.

use crate::syntax::table::setting::{flag, real};
use crate::syntax::table::{Act, Bound, CommandSpec, Group, Kind, ParamSpec, Stack, Unit, act};

const LENGTH: Kind = Kind::Number(Unit::Length);
const SWITCH: Kind = Kind::OneOf(&[0, 1]);

static PARAMS: [ParamSpec; 8] = [
    ParamSpec::of("Grid", LENGTH, real!(view.grid_mm))
        .within(Bound::Positive)
        .about("Between the lines drawn on the table."),
    ParamSpec::of("Table X", LENGTH, real!(view.table_mm[0])).within(Bound::Positive),
    ParamSpec::of("Table Y", LENGTH, real!(view.table_mm[1])).within(Bound::Positive),
    ParamSpec::of("Table Z", LENGTH, real!(view.table_mm[2]))
        .within(Bound::Positive)
        .about("Also how thick a blank is that a rotary axis turns."),
    ParamSpec::of("Simulate cutting", SWITCH, flag!(view.simulate))
        .about("1 shows the cutting fast forward, 0 the whole path at once."),
    ParamSpec::of("Draw tool", SWITCH, flag!(view.draw_tool)),
    ParamSpec::of("Start at actual location", SWITCH, flag!(view.start_actual))
        .about("0 starts previews at 0,0."),
    ParamSpec::of("Show jogs", SWITCH, flag!(view.show_jogs)),
];

pub(super) static VP: CommandSpec = CommandSpec::new(
    "VP",
    "Values: preview",
    Group::Values,
    &PARAMS,
    Stack::Ends,
    "What the preview shows: the table and its grid, the tool, jogs, and where a preview starts.",
    Act::Value(act::Value::Set),
);
