//! Cut commands: circles, arcs, arches and rectangles. The geometry is the crate `kerf-cut`'s.

use super::{Act, Bound, CommandSpec, Default, Group, Kind, ParamSpec, Stack, Unit, act};
use kerf_program::Axis;

const LENGTH: Kind = Kind::Number(Unit::Length);

const ANGLE: Kind = Kind::Number(Unit::Degrees);

const SIDE: ParamSpec = ParamSpec::word("O/I/T", &["O", "I", "T"], "T")
    .about("O: the part left inside has the size; I: the hole has the size; T: the cutter centre runs on the shape.");

const DIRECTION: ParamSpec = ParamSpec::number("Direction", Kind::OneOf(&[1, -1]), 1.0)
    .about("1 clockwise, -1 counter-clockwise.");

const BEGIN: ParamSpec = ParamSpec::keep("Begin angle", ANGLE)
    .special()
    .about("Clock degrees, 0 at the top. Blank: 0 clockwise, 360 counter-clockwise.");

const END: ParamSpec =
    ParamSpec::keep("End angle", ANGLE).special().about("Clock degrees. Blank: a full circle.");

const PLUNGE: ParamSpec = ParamSpec::number("Plunge", LENGTH, 0.0)
    .about("Change of Z before each repetition; negative is down.");

const REPETITIONS: ParamSpec = ParamSpec::number("Repetitions", Kind::Whole, 1.0)
    .within(Bound::AtLeast(1.0))
    .about("How many passes.");

const PROPORTION_X: ParamSpec = ParamSpec::number("Proportion X", Kind::Number(Unit::None), 1.0)
    .about("Scales in X; negative mirrors.");

const PROPORTION_Y: ParamSpec = ParamSpec::number("Proportion Y", Kind::Number(Unit::None), 1.0)
    .about("Scales in Y; negative mirrors.");

const FEATURE: ParamSpec = ParamSpec::number("Feature", Kind::Whole, 0.0)
    .within(Bound::Range(0.0, 4.0))
    .about("0 none, 1 tabs, 2 pocket, 3 spiral plunge, 4 spiral plunge with a flat last pass.");

const NO_PULL_UP: ParamSpec = ParamSpec::number("No pull-up", Kind::OneOf(&[0, 1]), 0.0)
    .about("1: stay at depth afterwards.");

const FROM_ZERO: ParamSpec = ParamSpec::number("Plunge from 0", Kind::OneOf(&[0, 1]), 0.0)
    .about("1: move Z to 0 first and plunge from there.");

pub(super) static SPECS: &[CommandSpec] = &[
    CommandSpec::new(
        "CA",
        "Cut Arch",
        Group::Cut,
        &[
            ParamSpec::required("Length", LENGTH).about("Span of the arch."),
            ParamSpec::required("Height", LENGTH).about("Rise of the arch."),
            SIDE,
            DIRECTION.about_direction("1 to the right, -1 to the left; it always rises."),
            ParamSpec::number("Alignment angle", ANGLE, 0.0).about("Turns the arch clockwise."),
            PLUNGE,
            REPETITIONS,
            PROPORTION_X,
            PROPORTION_Y,
            ParamSpec::number("Tabs", Kind::OneOf(&[0, 1]), 0.0)
                .about("1: leave tabs on the last pass."),
            NO_PULL_UP,
            FROM_ZERO,
        ],
        Stack::Joins,
        "Cuts an arch of a span and a rise from where the tool is.",
        Act::Cut(act::Cut::Arch),
    ),
    CommandSpec::new(
        "CC",
        "Cut Circle",
        Group::Cut,
        &[
            ParamSpec::required("Diameter", LENGTH).within(Bound::Any),
            SIDE,
            DIRECTION,
            BEGIN,
            END,
            PLUNGE,
            REPETITIONS,
            PROPORTION_X,
            PROPORTION_Y,
            FEATURE,
            NO_PULL_UP,
            FROM_ZERO,
        ],
        Stack::Joins,
        "Cuts a circle or an arc that begins where the tool is.",
        Act::Cut(act::Cut::Circle),
    ),
    CommandSpec::new(
        "CG",
        "Cut G-code Circle",
        Group::Cut,
        &[
            ParamSpec::keep("Diameter", LENGTH)
                .about("Instead of the centre; the arc is half a turn at most."),
            ParamSpec::keep("X end", Kind::Number(Unit::Axis(Axis::X)))
                .about("Blank: where the tool is."),
            ParamSpec::keep("Y end", Kind::Number(Unit::Axis(Axis::Y)))
                .about("Blank: where the tool is."),
            ParamSpec::keep("X centre offset I", LENGTH)
                .about("From the tool to the centre; blank: as in the last CG."),
            ParamSpec::keep("Y centre offset J", LENGTH)
                .about("From the tool to the centre; blank: as in the last CG."),
            SIDE,
            DIRECTION,
            PLUNGE,
            REPETITIONS,
            PROPORTION_X,
            PROPORTION_Y,
            FEATURE,
            NO_PULL_UP,
            FROM_ZERO,
        ],
        Stack::Joins,
        "Cuts an arc from where the tool is to an end point, by its centre or its diameter, as G2 and G3 do.",
        Act::Cut(act::Cut::ArcTo),
    ),
    CommandSpec::new(
        "CP",
        "Cut Circle from Center Point",
        Group::Cut,
        &[
            ParamSpec::required("Diameter", LENGTH),
            ParamSpec::required("X centre", Kind::Number(Unit::Axis(Axis::X))),
            ParamSpec::required("Y centre", Kind::Number(Unit::Axis(Axis::Y))),
            SIDE,
            DIRECTION,
            BEGIN,
            END,
            PLUNGE,
            REPETITIONS,
            PROPORTION_X,
            PROPORTION_Y,
            FEATURE,
            NO_PULL_UP,
            FROM_ZERO,
        ],
        Stack::Joins,
        "Cuts a circle or an arc about a centre. The tool first moves straight to its first point, at the present Z.",
        Act::Cut(act::Cut::PointCircle),
    ),
    CommandSpec::new(
        "CR",
        "Cut Rectangle",
        Group::Cut,
        &[
            ParamSpec::required("Length X", LENGTH),
            ParamSpec::keep("Length Y", LENGTH).special().about("Blank: a square."),
            SIDE,
            DIRECTION,
            ParamSpec::number("Start corner", Kind::OneOf(&[1, 2, 3, 4]), 4.0).about(
                "Where the tool is: 1 upper left, 2 upper right, 3 lower right, 4 lower left.",
            ),
            PLUNGE,
            REPETITIONS,
            ParamSpec::number("Feature", Kind::Whole, 0.0)
                .within(Bound::Range(0.0, 2.0))
                .about("0 none, 1 tabs, 2 pocket."),
            FROM_ZERO,
            // Files in use carry one more value that the manuals do not describe.
            ParamSpec::obsolete(),
        ],
        Stack::Joins,
        "Cuts a rectangle one of whose corners is where the tool is.",
        Act::Cut(act::Cut::Rectangle),
    ),
];

impl ParamSpec {
    const fn about_direction(mut self, doc: &'static str) -> Self {
        self.doc = doc;
        self.default = Default::Number(1.0);
        self
    }
}
