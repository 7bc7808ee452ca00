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
mod tests {
    use crate::testing::{Ran, run};
    use kerf_program::{Arc, Command};

    fn arcs(ran: &Ran) -> Vec<Arc> {
        let arc = |c: &kerf_program::Sourced| match c.command {
            Command::Arc(a) => Some(a),
            _ => None,
        };
        ran.commands.iter().filter_map(arc).collect()
    }

    /// Runs a program with one arc; checks its end, centre and sweep (clockwise positive) in inches and degrees.
    #[track_caller]
    fn arc(text: &str, end: (f64, f64), centre: (f64, f64), clockwise: f64) {
        let ran = run(text);
        let made = arcs(&ran);
        assert_eq!(made.len(), 1, "{text}: {:?}", ran.error);
        let [x, y] = made[0].centre.map(|v| v / 25.4);
        let near = |a: f64, b: f64| (a - b).abs() < 5e-4;
        assert!(near(x, centre.0) && near(y, centre.1), "{text}: centre {x},{y}");
        assert!(near(-made[0].sweep_rad.to_degrees(), clockwise), "{text}: {}", made[0].sweep_rad);
        ran.ends_at(end.0, end.1, ran.location().0[2]);
    }

    #[test]
    fn parameters_reach_the_geometry() {
        arc("CC,4", (0.0, 0.0), (0.0, -2.0), 360.0);
        arc("CC,4,T,-1,90,-180", (-2.0, -2.0), (-2.0, 0.0), -270.0);
        arc("CC,4,O,1,90,180", (-2.125, -2.125), (-2.125, 0.0), 90.0);
        arc("CP,4,10,10,T,-1,90,180", (10.0, 8.0), (10.0, 10.0), -270.0);
        arc("CG,,2,-2,0,-2,T,1", (2.0, -2.0), (0.0, -2.0), 90.0);
        arc("CG,4,2,-2,9,9,T,-1", (2.0, -2.0), (2.0, 0.0), -90.0);
        arc("CA,10,2.5,I", (9.8, 0.0), (4.9, -3.675), 106.2602);
    }

    #[test]
    fn sbp_cut_cp_relative() {
        arc("M2,5,5 ⏎ SR ⏎ CP,4,10,10", (15.0, 17.0), (15.0, 15.0), 360.0);
    }

    #[test]
    fn sbp_cut_cg_modal() {
        let ran = run("CG,,2,-2,0,-2 ⏎ M2,0,0 ⏎ CG,,2,-2");
        assert_eq!(arcs(&ran).len(), 2);
        assert_eq!(arcs(&ran)[0].centre, arcs(&ran)[1].centre);
        run("CG,,2,-2").fails_with("centre");
    }

    #[test]
    fn sbp_cut_relative_mode() {
        for shape in ["CC,4", "CR,10,5", "CA,10,2.5"] {
            let absolute = run(&format!("M2,1,1 ⏎ {shape}"));
            let relative = run(&format!("M2,1,1 ⏎ SR ⏎ {shape}"));
            assert_eq!(absolute.location(), relative.location(), "{shape}");
            assert_eq!(
                (absolute.moves(), arcs(&absolute)),
                (relative.moves(), arcs(&relative)),
                "{shape}"
            );
        }
    }

    #[test]
    fn refusals_say_what_is_wrong() {
        for (text, part) in [
            ("CC", "diameter expected"),
            ("CC,0", "must be positive"),
            ("CC,-2", "must be positive"),
            ("CC,.2,I", "cutter larger than hole"),
            ("CC,4,T,2", "one of 1, -1"),
            ("CC,4,X", "one of O, I, T"),
            ("CC,4,,,,,,,,,5", "0-4"),
            ("CC,4,T,1,0,90,0,1,1,1,2", "full circle"),
            ("CC,4,,,,,-.1,1.5", "whole number"),
            ("CC,4,,,,,-.1,0", "at least 1"),
            ("CP,4", "centre expected"),
            ("CG,4", "end point"),
            ("CG,2,2,-2", "diameter"),
            ("CG,,3,-3,0,-2", "not on the circle"),
            ("CR", "length x expected"),
            ("CR,-10,5", "positive"),
            ("CR,2,1,,,,,,3", "0-2"),
            ("CA,10", "height expected"),
            ("CA,10,0", "positive"),
        ] {
            let ran = run(text);
            ran.fails_with(part).ends_at(0.0, 0.0, 0.0);
        }
    }

    #[test]
    fn sbp_cut_cc_from0() {
        let z = |text: &str| run(text).moves().iter().map(|m| m.1[2]).collect::<Vec<_>>();
        assert_eq!(z("MZ,.5 ⏎ CC,4,T,1,0,360,-.25,2,1,1,0,0,1"), [0.5, 0.0, -0.25, -0.5, 0.5]);
        assert_eq!(z("MZ,.5 ⏎ CC,4,T,1,0,360,-.25,2"), [0.5, 0.25, 0.0, 0.5]);
    }

    #[test]
    fn sbp_cut_cc_tab() {
        let ran = run("CC,12,T,1,0,360,-.5,2,1,1,1");
        let made = arcs(&ran);
        // First pass whole; on the second six tabs at 4, 10 … 34, each up, flat, down.
        assert!((made[0].sweep_rad.abs() - std::f64::consts::TAU).abs() < 1e-9);
        let z: Vec<_> = made[1..].iter().map(|a| (a.to.0[2] / 25.4 * 1e6).round() / 1e6).collect();
        assert_eq!(z[..5], [-1.0, -0.9, -0.9, -1.0, -1.0]);
        assert_eq!(z.iter().filter(|z| **z == -0.9).count(), 12);
        let first = made[1].sweep_rad.abs() * 6.0;
        assert!((first - 4.0).abs() < 1e-6, "{first}");
    }

    #[test]
    fn plunges_are_added_to_z_and_lifts_are_told_of() {
        let told = |ran: &Ran| {
            ran.commands.iter().any(|c| matches!(&c.command, Command::Diagnostic(d) if d.code == kerf_diag::Code::Lifts))
        };
        let up = run("CC,4,T,1,0,360,.25,1,1,1,0,1");
        assert!(told(up.ends_at(0.0, 0.0, 0.25)));
        assert!(!told(run("CC,4,T,1,0,360,-.25,1,1,1,0,1").ends_at(0.0, 0.0, -0.25)));
    }

    #[test]
    fn sbp_cut_cc_pullup_height() {
        run("MZ,.5 ⏎ CC,4,T,1,0,360,-.75").ends_at(0.0, 0.0, 0.5);
        assert!(run("CC,4").moves().is_empty());
    }

    #[test]
    fn sbp_cut_cc_nopullup() {
        run("MZ,.2 ⏎ CC,4,T,1,0,360,-.3,1,1,1,0,1").ends_at(0.0, 0.0, -0.1);
        run("MZ,.2 ⏎ CC,4,T,1,0,360,-.3").ends_at(0.0, 0.0, 0.2);
    }

    #[test]
    fn vb_tabs_hold_for_the_last_pass_of_a_cut_only() {
        let ran = run("VB,,,,,1 ⏎ CR,10,6,T,1,4,-.5,2");
        let high = ran.moves().iter().filter(|m| (m.1[2] + 0.9).abs() < 1e-6).count();
        assert!(high >= 10, "{:?} {:?}", ran.moves(), ran.error);
        assert!(!ran.moves().iter().any(|m| (m.1[2] + 0.4).abs() < 1e-6));
    }
}
