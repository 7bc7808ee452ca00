//! CC, a circle or arc from where the tool is, and CP, the same about a given centre.

use crate::curve::{Anchor, Curve, Shape};
use crate::error::{check_length, check_positive};
use crate::passes::cut;
use crate::{Context, Cut, CutError, Direction, Passes, Side};
use kerf_geom::Point2;

/// Angles beyond this are mistakes; it keeps the remainder of a turn exact to a millionth degree.
const MAX_ANGLE_DEG: f64 = 1.0e6;

/// A swept angle this close to a whole turn is one: variables are single precision (readings, A-05).
const TURN_SLACK_DEG: f64 = 1e-4;

/// Parameters of CC; CP has them too.
#[derive(Clone, Debug, PartialEq)]
pub struct Circle {
    /// Nominal diameter, mm.
    pub diameter_mm: f64,
    /// Which side the cutter runs on.
    pub side: Side,
    /// Which way round.
    pub turn: Direction,
    /// Clock angle of the first place; blank is the top.
    pub begin_deg: Option<f64>,
    /// Clock angle of the last place; blank is a full turn.
    pub end_deg: Option<f64>,
    /// Proportions in X and Y.
    pub proportion: [f64; 2],
    /// Number and depth of the passes.
    pub passes: Passes,
}

impl Circle {
    /// A full clockwise circle from the top, once, the cutter on the line.
    pub fn new(diameter_mm: f64) -> Self {
        Self {
            diameter_mm,
            side: Side::True,
            turn: Direction::Clockwise,
            begin_deg: None,
            end_deg: None,
            proportion: [1.0; 2],
            passes: Passes::default(),
        }
    }

    /// Begin angle and swept angle in degrees: `((E − B)·dir) mod 360`, 0 being a whole turn.
    fn angles(&self) -> Result<(f64, f64), CutError> {
        let begin = self.begin_deg.unwrap_or(match self.turn {
            Direction::Clockwise => 0.0,
            Direction::Counter => 360.0,
        });
        check_angle("begin angle", begin)?;
        let Some(end) = self.end_deg else { return Ok((begin, 360.0)) };
        check_angle("end angle", end)?;
        let sweep = ((end - begin) * self.turn.sign()).rem_euclid(360.0);
        let whole = sweep.min(360.0 - sweep) < TURN_SLACK_DEG;
        Ok((begin, if whole { 360.0 } else { sweep }))
    }

    fn shape(&self) -> Result<Shape, CutError> {
        check_positive("diameter", self.diameter_mm)?;
        check_proportion(self.proportion)?;
        let (begin_deg, sweep_deg) = self.angles()?;
        Ok(Shape {
            radius_mm: self.diameter_mm / 2.0,
            side: self.side,
            turn: self.turn,
            begin_deg,
            sweep_deg,
            proportion: self.proportion,
        })
    }
}

/// CC: the tool is at the place of the begin angle on the path.
///
/// # Errors
/// Sizes that are not positive, no room for the cutter, a pocket on an arc, absurd numbers.
pub fn circle(circle: &Circle, context: &Context) -> Result<Cut, CutError> {
    context.check()?;
    let curve = Curve::new(&circle.shape()?, Anchor::Begin(context.start_xy()), context)?;
    cut(&curve, &circle.passes, context)
}

/// CP: the tool first moves, straight and at its present Z, to the place of the begin angle.
///
/// `centre` is a location in the frame of [`Context::start`].
///
/// # Errors
/// As [`circle`].
pub fn point_circle(centre: [f64; 2], circle: &Circle, context: &Context) -> Result<Cut, CutError> {
    context.check()?;
    centre.iter().try_for_each(|v| check_length("centre", *v))?;
    let anchor = Anchor::Centre(Point2::new(centre[0], centre[1]));
    let curve = Curve::new(&circle.shape()?, anchor, context)?;
    cut(&curve, &circle.passes, context)
}

pub(crate) fn check_angle(what: &'static str, degrees: f64) -> Result<(), CutError> {
    if degrees.abs() <= MAX_ANGLE_DEG { Ok(()) } else { Err(CutError::OutOfRange { what }) }
}

pub(crate) fn check_proportion(proportion: [f64; 2]) -> Result<(), CutError> {
    proportion.iter().try_for_each(|v| check_length("proportion", *v))?;
    if proportion.contains(&0.0) { Err(CutError::ZeroProportion) } else { Ok(()) }
}
