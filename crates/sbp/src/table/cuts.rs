//! Cut commands: circles, arcs, arches and rectangles. The geometry is the crate `kerf-cut`'s.

use super::{Bound, CommandSpec, Default, Group, Kind, ParamSpec, Stack, Unit};
use crate::interp::{Arguments, Context, Stop};
use kerf_cut::{
    ArcTo, Arch, Circle, Corner, Cut, CutError, Feature, Passes, Rectangle, Side, Turn,
};
use kerf_diag::Code;
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
        arch,
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
        circle,
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
        arc_to,
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
        point_circle,
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
        rectangle,
    ),
];

impl ParamSpec {
    const fn about_direction(mut self, doc: &'static str) -> Self {
        self.doc = doc;
        self.default = Default::Number(1.0);
        self
    }
}

fn side(a: &Arguments, index: usize) -> Side {
    match a.text(index).as_deref() {
        Some("O") => Side::Out,
        Some("I") => Side::In,
        _ => Side::True,
    }
}

fn turn(a: &Arguments, index: usize) -> Turn {
    if a.number_or(index, 1.0) < 0.0 { Turn::Counter } else { Turn::Clockwise }
}

fn proportion(a: &Arguments, index: usize) -> [f64; 2] {
    [a.number_or(index, 1.0), a.number_or(index + 1, 1.0)]
}

fn feature(a: &Arguments, index: usize) -> Feature {
    let number = a.number_or(index, 0.0) as u8;
    Feature::from_number(number).unwrap_or_default()
}

/// Plunge at `plunge`, repetitions behind it; a plunge that lifts is told of.
fn passes(c: &mut Context<'_>, a: &Arguments, plunge: usize) -> Passes {
    let plunge_mm = a.number_or(plunge, 0.0);
    c.doubt_lift(plunge_mm);
    Passes {
        plunge_mm,
        repetitions: a.number_or(plunge + 1, 1.0).min(f64::from(u32::MAX)) as u32,
        ..Passes::default()
    }
}

/// Feature, no-pull-up and plunge-from-0 in a row, as four of the five commands have them.
fn with_features(passes: Passes, a: &Arguments, first: usize) -> Passes {
    Passes {
        feature: feature(a, first),
        no_pull_up: a.flag(first + 1).unwrap_or(false),
        from_zero: a.flag(first + 2).unwrap_or(false),
        ..passes
    }
}

fn round_shape(c: &mut Context<'_>, a: &Arguments, side_at: usize) -> Circle {
    let passes = passes(c, a, side_at + 4);
    Circle {
        diameter_mm: a.number_or(0, 0.0),
        side: side(a, side_at),
        turn: turn(a, side_at + 1),
        begin_deg: a.number(side_at + 2),
        end_deg: a.number(side_at + 3),
        proportion: proportion(a, side_at + 6),
        passes: with_features(passes, a, side_at + 8),
    }
}

fn circle(c: &mut Context<'_>, a: &Arguments) -> Result<(), Stop> {
    let shape = round_shape(c, a, 1);
    let cut = kerf_cut::circle(&shape, &c.cut_context());
    carry_out(c, cut, shape.passes.feature)
}

fn point_circle(c: &mut Context<'_>, a: &Arguments) -> Result<(), Stop> {
    let shape = round_shape(c, a, 3);
    let to = c.targets([(Axis::X, a.number_or(1, 0.0)), (Axis::Y, a.number_or(2, 0.0))]);
    let centre = c.core.frame.working(to);
    if c.core.working()[Axis::Z] < 0.0 {
        c.warn(
            Code::Unusual,
            "CP moves to its first point below the surface",
            "lift the tool before CP",
        );
    }
    let cut = kerf_cut::point_circle([centre[Axis::X], centre[Axis::Y]], &shape, &c.cut_context());
    carry_out(c, cut, shape.passes.feature)
}

fn arc_to(c: &mut Context<'_>, a: &Arguments) -> Result<(), Stop> {
    let passes = passes(c, a, 7);
    let given = [(Axis::X, a.number(1)), (Axis::Y, a.number(2))];
    let to = c.targets(given.into_iter().filter_map(|(axis, v)| Some((axis, v?))));
    let end = c.core.frame.working(to);
    let arc = ArcTo {
        diameter_mm: a.number(0),
        end: given.map(|(axis, v)| v.map(|_| end[axis])),
        centre_offset: [a.number(3), a.number(4)],
        side: side(a, 5),
        turn: turn(a, 6),
        proportion: proportion(a, 9),
        passes: with_features(passes, a, 11),
    };
    let made = kerf_cut::arc_to(&arc, c.core.last_ij, &c.cut_context());
    let (cut, used) = made.map_err(|e| refused(c, &e))?;
    c.core.last_ij = used;
    c.carry_out(cut, arc.passes.feature == Feature::Tab);
    Ok(())
}

fn arch(c: &mut Context<'_>, a: &Arguments) -> Result<(), Stop> {
    let passes = passes(c, a, 5);
    let shape = Arch {
        length_mm: a.number_or(0, 0.0),
        height_mm: a.number_or(1, 0.0),
        side: side(a, 2),
        turn: turn(a, 3),
        alignment_deg: a.number_or(4, 0.0),
        proportion: proportion(a, 7),
        passes: with_features(passes, a, 9),
    };
    let cut = kerf_cut::arch(&shape, &c.cut_context());
    carry_out(c, cut, shape.passes.feature)
}

fn rectangle(c: &mut Context<'_>, a: &Arguments) -> Result<(), Stop> {
    let passes = passes(c, a, 5);
    let length_x_mm = a.number_or(0, 0.0);
    let shape = Rectangle {
        length_x_mm,
        length_y_mm: a.number_or(1, length_x_mm),
        side: side(a, 2),
        turn: turn(a, 3),
        corner: Corner::from_number(a.number_or(4, 4.0) as u8).unwrap_or_default(),
        passes: Passes { feature: feature(a, 7), from_zero: a.flag(8).unwrap_or(false), ..passes },
    };
    let cut = kerf_cut::rectangle(&shape, &c.cut_context());
    carry_out(c, cut, shape.passes.feature)
}

fn carry_out(
    c: &mut Context<'_>,
    cut: Result<Cut, CutError>,
    feature: Feature,
) -> Result<(), Stop> {
    let cut = cut.map_err(|e| refused(c, &e))?;
    c.carry_out(cut, feature == Feature::Tab);
    Ok(())
}

fn refused(c: &Context<'_>, error: &CutError) -> Stop {
    let code = match error {
        CutError::EndNotOnCircle { .. } => Code::BadArc,
        _ => Code::Geometry,
    };
    c.fail(code, error.message(c.settings().linear_unit))
}

#[cfg(test)]
mod tests;
