//! Circles, arcs, arches and rectangles. The geometry is the crate `kerf-cut`'s.

use crate::run::cutting;
use crate::run::levels;
use crate::run::locate;
use crate::run::{Arguments, Context, Stop};
use crate::syntax::table::act::Cut as Act;
use kerf_cut::{
    ArcTo, Arch, Circle, Corner, Cut, CutError, Direction, Feature, Passes, Rectangle, Side,
};
use kerf_diag::Code;
use kerf_program::Axis;

/// Carries a cut command out.
pub(super) fn run(c: &mut Context<'_>, act: Act, a: &Arguments) -> Result<(), Stop> {
    match act {
        Act::Arch => arch(c, a),
        Act::Circle => circle(c, a),
        Act::ArcTo => arc_to(c, a),
        Act::PointCircle => point_circle(c, a),
        Act::Rectangle => rectangle(c, a),
    }
}

fn side(a: &Arguments, index: usize) -> Side {
    match a.text(index).as_deref() {
        Some("O") => Side::Out,
        Some("I") => Side::In,
        _ => Side::True,
    }
}

fn turn(a: &Arguments, index: usize) -> Direction {
    if a.number_or(index, 1.0) < 0.0 { Direction::Counter } else { Direction::Clockwise }
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
    levels::doubt_lift(c, plunge_mm);
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
    let cut = kerf_cut::circle(&shape, &cutting::cut_context(c));
    carry_out(c, cut, shape.passes.feature)
}

fn point_circle(c: &mut Context<'_>, a: &Arguments) -> Result<(), Stop> {
    let shape = round_shape(c, a, 3);
    let to = locate::targets(c, [(Axis::X, a.number_or(1, 0.0)), (Axis::Y, a.number_or(2, 0.0))]);
    let centre = c.core.place.frame.working(to);
    if c.core.place.working()[Axis::Z] < 0.0 {
        c.warn(
            Code::Unusual,
            "CP moves to its first point below the surface",
            "lift the tool before CP",
        );
    }
    let cut = kerf_cut::point_circle(
        [centre[Axis::X], centre[Axis::Y]],
        &shape,
        &cutting::cut_context(c),
    );
    carry_out(c, cut, shape.passes.feature)
}

fn arc_to(c: &mut Context<'_>, a: &Arguments) -> Result<(), Stop> {
    let passes = passes(c, a, 7);
    let given = [(Axis::X, a.number(1)), (Axis::Y, a.number(2))];
    let to = locate::targets(c, given.into_iter().filter_map(|(axis, v)| Some((axis, v?))));
    let end = c.core.place.frame.working(to);
    let arc = ArcTo {
        diameter_mm: a.number(0),
        end: given.map(|(axis, v)| v.map(|_| end[axis])),
        centre_offset: [a.number(3), a.number(4)],
        side: side(a, 5),
        turn: turn(a, 6),
        proportion: proportion(a, 9),
        passes: with_features(passes, a, 11),
    };
    let made = kerf_cut::arc_to(&arc, c.core.cutting.last_ij, &cutting::cut_context(c));
    let (cut, used) = made.map_err(|e| refused(c, &e))?;
    c.core.cutting.last_ij = used;
    cutting::carry_out(c, cut, arc.passes.feature == Feature::Tab);
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
    let cut = kerf_cut::arch(&shape, &cutting::cut_context(c));
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
    let cut = kerf_cut::rectangle(&shape, &cutting::cut_context(c));
    carry_out(c, cut, shape.passes.feature)
}

fn carry_out(
    c: &mut Context<'_>,
    cut: Result<Cut, CutError>,
    feature: Feature,
) -> Result<(), Stop> {
    let cut = cut.map_err(|e| refused(c, &e))?;
    cutting::carry_out(c, cut, feature == Feature::Tab);
    Ok(())
}

fn refused(c: &Context<'_>, error: &CutError) -> Stop {
    let code = match error {
        CutError::EndNotOnCircle { .. } => Code::BadArc,
        _ => Code::Geometry,
    };
    c.fail(code, error.message(c.settings().linear_unit))
}
