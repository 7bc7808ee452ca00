//! CR: rectangles, and pockets made of them.
//!
//! ```text
//!   1 ───── 2      clockwise 1 → 2 → 3 → 4 → 1; the tool is at the start corner,
//!   │       │      which decides where the rectangle lies.
//!   4 ───── 3
//! ```
//!
//! (Command reference, CR; readings, Rectangles and Pockets.)

use crate::error::check_positive;
use crate::passes::{Outline, cut};
use crate::step::{Step, Trail};
use crate::{Context, Cut, CutError, Direction, Feature, Passes, Side};
use kerf_geom::{Point2, Vec2, vec_to_clock};
use kerf_program::MoveKind;
use std::f64::consts::FRAC_1_SQRT_2;

/// The corner at which the tool is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Corner {
    /// 1: the rectangle lies right and below.
    UpperLeft,
    /// 2: left and below.
    UpperRight,
    /// 3: left and above.
    LowerRight,
    /// 4: right and above.
    #[default]
    LowerLeft,
}

impl Corner {
    /// The corner of the user's number, 1 … 4.
    pub const fn from_number(number: u8) -> Option<Self> {
        Some(match number {
            1 => Self::UpperLeft,
            2 => Self::UpperRight,
            3 => Self::LowerRight,
            4 => Self::LowerLeft,
            _ => return None,
        })
    }

    /// Signs of the way from this corner to the opposite one.
    const fn across(self) -> [f64; 2] {
        match self {
            Self::UpperLeft => [1.0, -1.0],
            Self::UpperRight => [-1.0, -1.0],
            Self::LowerRight => [-1.0, 1.0],
            Self::LowerLeft => [1.0, 1.0],
        }
    }

    /// Returns `true` if the first side runs along X.
    const fn x_first(self, turn: Direction) -> bool {
        matches!(
            (self, turn),
            (Self::UpperLeft | Self::LowerRight, Direction::Clockwise)
                | (Self::UpperRight | Self::LowerLeft, Direction::Counter)
        )
    }
}

/// Parameters of CR.
#[derive(Clone, Debug, PartialEq)]
pub struct Rectangle {
    /// Size in X, mm.
    pub length_x_mm: f64,
    /// Size in Y, mm.
    pub length_y_mm: f64,
    /// Which side the cutter runs on.
    pub side: Side,
    /// Which way round.
    pub turn: Direction,
    /// Corner at which the tool is.
    pub corner: Corner,
    /// Number and depth of the passes; the feature is plain, tab or pocket.
    pub passes: Passes,
}

impl Rectangle {
    /// A clockwise rectangle from the lower left, once, the cutter on the line.
    pub fn new(length_x_mm: f64, length_y_mm: f64) -> Self {
        Self {
            length_x_mm,
            length_y_mm,
            side: Side::True,
            turn: Direction::Clockwise,
            corner: Corner::LowerLeft,
            passes: Passes::default(),
        }
    }
}

/// CR from where the tool is.
///
/// # Errors
/// Sizes that are not positive, no room for the cutter, another feature than tab or pocket, absurd
/// numbers.
pub fn rectangle(rectangle: &Rectangle, context: &Context) -> Result<Cut, CutError> {
    context.check()?;
    if !matches!(rectangle.passes.feature, Feature::Plain | Feature::Tab | Feature::Pocket) {
        return Err(CutError::Feature { allowed: "0, 1 (tabs) or 2 (pocket): 0-2" });
    }
    cut(&Sides::new(rectangle, context)?, &rectangle.passes, context)
}

/// The path of the cutter's centre.
struct Sides {
    begin: Point2,
    /// From the begin corner to the opposite one, signed.
    across: Vec2,
    x_first: bool,
    cutter_mm: f64,
    /// Distance of pocket rings.
    step_mm: f64,
}

impl Sides {
    fn new(rectangle: &Rectangle, context: &Context) -> Result<Self, CutError> {
        check_positive("length X", rectangle.length_x_mm)?;
        check_positive("length Y", rectangle.length_y_mm)?;
        let [right, up] = rectangle.corner.across();
        let grow = 2.0 * rectangle.side.offset_mm(context.cutter_mm);
        let width = path_side(rectangle.length_x_mm, context.scale[0], grow)?;
        let height = path_side(rectangle.length_y_mm, context.scale[1], grow)?;
        Ok(Self {
            begin: context.start_xy(),
            across: Vec2::new(right * width, up * height),
            x_first: rectangle.corner.x_first(rectangle.turn),
            cutter_mm: context.cutter_mm,
            step_mm: context.cutter_mm * (1.0 - context.overlap_percent / 100.0),
        })
    }

    fn short(&self) -> f64 {
        self.across.x.abs().min(self.across.y.abs())
    }

    /// Unit steps from the begin corner inwards along both axes.
    fn inward(&self) -> Vec2 {
        Vec2::new(self.across.x.signum(), self.across.y.signum())
    }

    /// The corners after the first one of the rectangle drawn in by `inset`; the last is the first.
    fn corners(&self, inset: f64) -> [Point2; 4] {
        let first = self.begin + self.inward() * inset;
        let across = self.across - self.inward() * (2.0 * inset);
        let second = if self.x_first {
            first + Vec2::new(across.x, 0.0)
        } else {
            first + Vec2::new(0.0, across.y)
        };
        let fourth = if self.x_first {
            first + Vec2::new(0.0, across.y)
        } else {
            first + Vec2::new(across.x, 0.0)
        };
        [second, first + across, fourth, first]
    }

    fn ring_count(&self) -> f64 {
        (self.short() / (2.0 * self.step_mm) - 1e-9).ceil().max(1.0)
    }

    /// Returns the distance beyond a corner `inset` inside the ring before that the tool must go so that
    /// nothing is left between the two corners: the outer ring clears half a cutter from its sides, the
    /// round cutter in the inner corner reaches less than that diagonally.
    fn corner_reach(&self, inset: f64) -> f64 {
        inset - self.cutter_mm * (0.5 + FRAC_1_SQRT_2 / 2.0)
    }

    /// Straight out from `at` by `reach` along both axes, towards a corner, and back.
    fn nip(at: Point2, toward: Point2, reach: f64, trail: &mut Trail) {
        let way = toward - at;
        trail.line(MoveKind::Cut, at + Vec2::new(way.x.signum(), way.y.signum()) * reach);
        trail.line(MoveKind::Cut, at);
    }

    fn ring(&self, inset: f64, trail: &mut Trail) {
        let middle = self.begin + self.across * 0.5;
        let reach = self.corner_reach(self.step_mm);
        for (i, corner) in self.corners(inset).into_iter().enumerate() {
            trail.line(MoveKind::Cut, corner);
            // The way in has cleared the first corner.
            if inset > 0.0 && reach > 0.0 && i < 3 {
                Self::nip(corner, corner + (corner - middle), reach, trail);
            }
        }
    }

    /// Along the middle of the core that the last ring, `inset` inside, has left.
    fn centre_line(&self, inset: f64, trail: &mut Trail) {
        let half = self.short() / 2.0;
        let reach = self.corner_reach(half - inset);
        let ends =
            [self.begin + self.inward() * half, self.begin + self.across - self.inward() * half];
        let (mut near, mut far) = (self.corners(inset).to_vec(), Vec::new());
        near.retain(|c| {
            let stays = c.distance(ends[0]) <= c.distance(ends[1]);
            far.extend((!stays).then_some(*c));
            stays
        });
        for (end, corners) in [(ends[0], near), (ends[1], far)] {
            trail.line(MoveKind::Cut, end);
            for corner in corners {
                if reach > 0.0 {
                    Self::nip(end, corner, reach, trail);
                }
            }
        }
    }
}

impl Outline for Sides {
    fn begin(&self) -> Point2 {
        self.begin
    }

    fn is_closed(&self) -> bool {
        true
    }

    fn step_count(&self, pocket: bool) -> f64 {
        // Four sides, the way in and six for three corners; the centre line has as many.
        if pocket { 11.0 * (self.ring_count() + 1.0) } else { 4.0 }
    }

    fn follow(&self, z: [f64; 2], trail: &mut Trail) {
        for corner in self.corners(0.0) {
            trail.push(Step::Line { kind: MoveKind::Cut, to: [corner.x, corner.y, z[1]] });
        }
    }

    /// Rectangles from outside in, the corners a step further in along both axes.
    fn clear(&self, trail: &mut Trail) {
        let mut inset = 0.0;
        for ring in 0..self.ring_count() as u32 {
            inset = f64::from(ring) * self.step_mm;
            trail.line(MoveKind::Cut, self.begin + self.inward() * inset);
            self.ring(inset, trail);
        }
        if self.short() - 2.0 * inset > self.cutter_mm * (1.0 + 1e-9) {
            self.centre_line(inset, trail);
        }
    }

    fn heading_deg(&self) -> f64 {
        let [.., before, last] = self.corners(0.0);
        vec_to_clock(last - before)
    }
}

/// A side of the path: the scaled length and the cutter, with the sign of the scale.
fn path_side(length_mm: f64, scale: f64, grow: f64) -> Result<f64, CutError> {
    let nominal = length_mm * scale.abs();
    let side = nominal + grow;
    if side > 0.0 {
        return Ok(side.copysign(scale));
    }
    Err(CutError::CutterLargerThanHole { cutter_mm: -grow, hole_mm: nominal })
}
