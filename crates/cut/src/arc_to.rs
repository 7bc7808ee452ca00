//! CG: an arc from the tool to an end point, by its centre or by its diameter.
//!
//! The centre is `tool + (I, J)`. By diameter, of the two centres the one to the right of travel
//! serves a clockwise arc, the one to the left a counter-clockwise one, so that the arc is half a
//! turn at most. Everything is worked out on the nominal circle, as the user wrote it; proportions
//! and the cutter come afterwards, as in CC (readings, Circle angles, A-63).

use crate::circle::check_proportion;
use crate::curve::{Anchor, Curve, SAME_PLACE_MM, Shape};
use crate::error::{check_length, check_positive};
use crate::passes::cut;
use crate::{Context, Cut, CutError, Direction, Passes, Side};
use kerf_geom::{Arc2, Point2, Vec2, vec_to_clock};

/// Largest distance of the end from the circle, and largest excess of the chord over the diameter: .01 in.
///
/// Files carry three or four decimals; more than this is a wrong number.
pub const ARC_TOLERANCE_MM: f64 = 0.254;

/// Parameters of CG.
#[derive(Clone, Debug, PartialEq)]
pub struct ArcTo {
    /// Diameter, mm; when given, the offsets are ignored.
    pub diameter_mm: Option<f64>,
    /// End point, a location in the frame of [`Context::start`]; blank is where the tool is.
    pub end: [Option<f64>; 2],
    /// I and J, the way from the tool to the centre, mm; blank is what the last CG had.
    pub centre_offset: [Option<f64>; 2],
    /// Which side the cutter runs on.
    pub side: Side,
    /// Which way round.
    pub turn: Direction,
    /// Proportions in X and Y, about the tool.
    pub proportion: [f64; 2],
    /// Number and depth of the passes.
    pub passes: Passes,
}

impl ArcTo {
    /// A clockwise arc, once, the cutter on the line.
    pub fn new(end: [Option<f64>; 2], centre_offset: [Option<f64>; 2]) -> Self {
        Self {
            diameter_mm: None,
            end,
            centre_offset,
            side: Side::True,
            turn: Direction::Clockwise,
            proportion: [1.0; 2],
            passes: Passes::default(),
        }
    }
}

/// CG from where the tool is, and the I, J that the next CG falls back to.
///
/// `previous` are those of the last CG of this run.
///
/// # Errors
/// No circle through both points, the end not on the circle, nothing to make a circle from, and
/// what [`crate::circle`] refuses.
pub fn arc_to(
    arc: &ArcTo,
    previous: Option<[f64; 2]>,
    context: &Context,
) -> Result<(Cut, Option<[f64; 2]>), CutError> {
    context.check()?;
    check_proportion(arc.proportion)?;
    let chord = Chord::new(arc, context)?;
    let (circle, used) = match arc.diameter_mm {
        Some(diameter) => (chord.by_diameter(diameter, arc.turn)?, previous),
        None => {
            let used = centre_offset(arc.centre_offset, previous)?;
            (chord.by_centre(Vec2::new(used[0], used[1]), arc.turn)?, Some(used))
        }
    };
    let shape = circle.shape(arc);
    let curve = Curve::new(&shape, Anchor::Begin(context.start_xy()), context)?;
    // The cutter beside the line moves the end; on the line it is the user's.
    let exact = arc.side == Side::True && !chord.returns;
    let curve = if exact { curve.ending_at(chord.end) } else { curve };
    Ok((cut(&curve, &arc.passes, context)?, used))
}

/// I and J with blanks taken from the last CG; a lone one without that is beside a zero.
fn centre_offset(
    given: [Option<f64>; 2],
    previous: Option<[f64; 2]>,
) -> Result<[f64; 2], CutError> {
    if given == [None, None] && previous.is_none() {
        return Err(CutError::NoEarlierCentre);
    }
    let before = previous.unwrap_or_default();
    let used = [0, 1].map(|i| given[i].unwrap_or(before[i]));
    used.iter().try_for_each(|v| check_length("centre offset", *v))?;
    if used == [0.0, 0.0] { Err(CutError::CentreAtStart) } else { Ok(used) }
}

/// Chord of the arc: nominal, and really on the table.
struct Chord {
    /// From the tool to the end before any proportion.
    nominal: Vec2,
    /// The end on the table.
    end: Point2,
    /// The end is the start.
    returns: bool,
}

impl Chord {
    fn new(arc: &ArcTo, context: &Context) -> Result<Self, CutError> {
        let start = context.start_xy();
        let given = Point2::new(arc.end[0].unwrap_or(start.x), arc.end[1].unwrap_or(start.y));
        check_length("end point", given.x)?;
        check_length("end point", given.y)?;
        let way = given - start;
        let [px, py] = arc.proportion;
        let plain = arc.proportion == [1.0, 1.0];
        Ok(Self {
            nominal: way.scaled(1.0 / context.scale[0], 1.0 / context.scale[1]),
            end: if plain { given } else { start + way.scaled(px, py) },
            returns: way.length() <= SAME_PLACE_MM,
        })
    }

    fn by_diameter(&self, diameter: f64, turn: Direction) -> Result<NominalCircle, CutError> {
        check_positive("diameter", diameter)?;
        if self.returns {
            return Err(CutError::EndOrCentreNeeded);
        }
        let half = self.nominal.length() / 2.0;
        if 2.0 * half > diameter + ARC_TOLERANCE_MM {
            return Err(CutError::ChordLongerThanDiameter {
                chord_mm: 2.0 * half,
                diameter_mm: diameter,
            });
        }
        let height = (diameter * diameter / 4.0 - half * half).max(0.0).sqrt();
        let aside = self.nominal.left().normalized().unwrap_or_default() * height;
        let centre = self.nominal * 0.5 - aside * turn.sign();
        Ok(NominalCircle { centre, sweep_deg: self.sweep_deg(centre, turn) })
    }

    fn by_centre(&self, centre: Vec2, turn: Direction) -> Result<NominalCircle, CutError> {
        let start_radius_mm = centre.length();
        let end_radius_mm = (self.nominal - centre).length();
        if self.returns {
            return Ok(NominalCircle { centre, sweep_deg: 360.0 });
        }
        if (start_radius_mm - end_radius_mm).abs() > ARC_TOLERANCE_MM {
            return Err(CutError::EndNotOnCircle { start_radius_mm, end_radius_mm });
        }
        let centre = self.evened(centre, turn).unwrap_or(centre);
        Ok(NominalCircle { centre, sweep_deg: self.sweep_deg(centre, turn) })
    }

    /// The centre moved along the chord until start and end are equally far, so that rounded numbers
    /// still give a true circle; nothing if that would move the path by more than the tolerance.
    ///
    /// It would where start and end are near each other on a nearly whole circle; that one keeps its
    /// centre and is closed by a straight move no longer than the tolerance.
    fn evened(&self, centre: Vec2, turn: Direction) -> Option<Vec2> {
        let along = self.nominal.normalized()?;
        let moved = centre + along * (self.nominal.length() / 2.0 - centre.dot(along));
        let sweep_rad = -turn.sign() * self.sweep_deg(moved, turn).to_radians();
        let start = Point2::default();
        let path = Arc2 { start, centre: start + moved, sweep_rad };
        let beside = |eighth: i32| {
            let place = path.at(f64::from(eighth) / 8.0);
            (place.distance(start + centre) - centre.length()).abs()
        };
        (1..8).all(|eighth| beside(eighth) <= ARC_TOLERANCE_MM).then_some(moved)
    }

    /// From the start to the end about a centre, more than 0 to 360.
    fn sweep_deg(&self, centre: Vec2, turn: Direction) -> f64 {
        let begin = vec_to_clock(-centre);
        let end = vec_to_clock(self.nominal - centre);
        let sweep = ((end - begin) * turn.sign()).rem_euclid(360.0);
        if sweep == 0.0 { 360.0 } else { sweep }
    }
}

/// The circle through the tool, relative to it.
struct NominalCircle {
    centre: Vec2,
    sweep_deg: f64,
}

impl NominalCircle {
    fn shape(&self, arc: &ArcTo) -> Shape {
        Shape {
            radius_mm: self.centre.length(),
            side: arc.side,
            turn: arc.turn,
            begin_deg: vec_to_clock(-self.centre),
            sweep_deg: self.sweep_deg,
            proportion: arc.proportion,
        }
    }
}
