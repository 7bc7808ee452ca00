//! CA: an arch over a span.
//!
//! Span L and rise H give the circle: `R = H/2 + L²/(8H)`, swept angle `θ = 4·atan(2H/L)`. Clockwise
//! the arch begins at the clock angle −θ/2 and runs to the right; counter-clockwise it is the mirror
//! image, begins at θ/2 and runs to the left, still rising. The alignment adds to that angle, before
//! the proportions of the table are applied (readings, Arches, A-66 … A-69).

use crate::circle::{check_angle, check_proportion};
use crate::curve::{Anchor, Curve, Shape};
use crate::error::{check_length, check_positive};
use crate::passes::cut;
use crate::{Context, Cut, CutError, Direction, Feature, Passes, Side};

/// Parameters of CA.
#[derive(Clone, Debug, PartialEq)]
pub struct Arch {
    /// Span, mm.
    pub length_mm: f64,
    /// Rise, mm.
    pub height_mm: f64,
    /// Which side the cutter runs on.
    pub side: Side,
    /// Clockwise to the right, counter-clockwise to the left.
    pub turn: Direction,
    /// Turns the arch clockwise about the tool, degrees.
    pub alignment_deg: f64,
    /// Proportions in X and Y of the table.
    pub proportion: [f64; 2],
    /// Number and depth of the passes; the feature is plain or tab.
    pub passes: Passes,
}

impl Arch {
    /// A clockwise arch, once, the cutter on the line.
    pub fn new(length_mm: f64, height_mm: f64) -> Self {
        Self {
            length_mm,
            height_mm,
            side: Side::True,
            turn: Direction::Clockwise,
            alignment_deg: 0.0,
            proportion: [1.0; 2],
            passes: Passes::default(),
        }
    }

    fn shape(&self) -> Result<Shape, CutError> {
        check_positive("arch length", self.length_mm)?;
        check_positive("arch height", self.height_mm)?;
        check_angle("alignment angle", self.alignment_deg)?;
        check_proportion(self.proportion)?;
        let (length, height) = (self.length_mm, self.height_mm);
        let radius_mm = height / 2.0 + length * length / (8.0 * height);
        check_length("radius of the arch", radius_mm)?;
        let sweep_deg = 4.0 * (2.0 * height).atan2(length).to_degrees();
        Ok(Shape {
            radius_mm,
            side: self.side,
            turn: self.turn,
            begin_deg: self.alignment_deg - self.turn.sign() * sweep_deg / 2.0,
            sweep_deg,
            proportion: self.proportion,
        })
    }
}

/// CA from where the tool is.
///
/// # Errors
/// Sizes that are not positive, no room for the cutter, another feature than tab, absurd numbers.
pub fn arch(arch: &Arch, context: &Context) -> Result<Cut, CutError> {
    context.check()?;
    if !matches!(arch.passes.feature, Feature::Plain | Feature::Tab) {
        return Err(CutError::Feature { allowed: "0 or 1 (tabs)" });
    }
    let curve = Curve::new(&arch.shape()?, Anchor::Begin(context.start_xy()), context)?;
    cut(&curve, &arch.passes, context)
}
