//! The errors of cuts, and the bounds that keep absurd numbers from exhausting memory.

use kerf_program::rounded;
use kerf_program::settings::LinearUnit;

/// The largest length, location or depth accepted: a kilometre.
///
/// No machine is larger; beyond it a value is a mistake (a missing decimal point, a wrong variable).
pub const MAX_LENGTH_MM: f64 = 1.0e6;

/// The most steps one command may make.
///
/// A pocket the size of a sheet with a small cutter needs some thousands; this is about 40 MB.
pub const MAX_STEPS: usize = 500_000;

/// Reason why a Cut command cannot be carried out. Nothing has moved when one is returned.
///
/// The text of `Display` gives lengths in millimetres; [`CutError::message`] in the user's unit.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CutError {
    /// Not a number, infinite or larger than [`MAX_LENGTH_MM`].
    #[error("the {what} is not a usable number: give one below a kilometre")]
    OutOfRange {
        /// The parameter.
        what: &'static str,
    },
    /// Zero or negative where a size is needed.
    #[error("{what} must be positive")]
    NotPositive {
        /// The parameter.
        what: &'static str,
    },
    /// The path on the inside of a shape has no room.
    #[error(
        "cutter larger than hole: the cutter is {cutter_mm} mm, the hole allows less than {hole_mm} mm; use a smaller cutter (VC) or T"
    )]
    CutterLargerThanHole {
        /// Diameter of the cutter.
        cutter_mm: f64,
        /// Largest cutter that the hole allows.
        hole_mm: f64,
    },
    /// CG whose end and start have different distances from the centre.
    #[error(
        "the end point is not on the circle: its distance from the centre is {end_radius_mm} mm, that of the start {start_radius_mm} mm; correct the end point or I and J"
    )]
    EndNotOnCircle {
        /// Distance of the start from the centre.
        start_radius_mm: f64,
        /// Distance of the end from the centre.
        end_radius_mm: f64,
    },
    /// CG by diameter whose end is too far away.
    #[error(
        "the end point is {chord_mm} mm away, farther than the diameter of {diameter_mm} mm reaches; give a larger diameter"
    )]
    ChordLongerThanDiameter {
        /// Distance from start to end.
        chord_mm: f64,
        /// The diameter.
        diameter_mm: f64,
    },
    /// CG with a diameter alone.
    #[error("end point or centre offsets needed: a circle cannot be made from a diameter alone")]
    EndOrCentreNeeded,
    /// CG with neither diameter nor offsets and nothing to repeat.
    #[error("diameter or centre offsets I, J needed: there is no earlier CG to take them from")]
    NoEarlierCentre,
    /// CG whose centre is the start.
    #[error("the centre offsets I and J are both zero; give the way from the tool to the centre")]
    CentreAtStart,
    /// A proportion of zero leaves no shape.
    #[error("proportions must not be zero")]
    ZeroProportion,
    /// Fewer than one pass.
    #[error("repetitions must be 1 or more")]
    Repetitions,
    /// The pocket feature on an arc.
    #[error("pocket needs a full circle: leave begin and end angle out, or cut the arc plain")]
    PocketNeedsFullCircle,
    /// A pocket overlap outside 0 … 100.
    #[error("the pocket overlap of VC must be 0 or more and less than 100 percent")]
    Overlap,
    /// A pocket without a cutter.
    #[error("a pocket needs the cutter diameter: set it with VC")]
    PocketNeedsCutter,
    /// A feature that this command does not have.
    #[error("feature must be {allowed}")]
    Feature {
        /// The values it may have, as text.
        allowed: &'static str,
    },
    /// More than [`MAX_STEPS`] steps.
    #[error(
        "this would make more than {MAX_STEPS} moves; use fewer repetitions, less overlap or a coarser resolution (VU)"
    )]
    TooManySteps,
    /// Tabs that follow each other without any path between and without size.
    #[error("tabs need a length or a distance: set size, lead or distance with VB")]
    EmptyTabs,
}

impl CutError {
    /// The message with lengths in the user's unit.
    pub fn message(&self, unit: LinearUnit) -> String {
        let mut scaled = self.clone();
        let factor = unit.mm();
        match &mut scaled {
            Self::CutterLargerThanHole { cutter_mm: a, hole_mm: b }
            | Self::EndNotOnCircle { start_radius_mm: a, end_radius_mm: b }
            | Self::ChordLongerThanDiameter { chord_mm: a, diameter_mm: b } => {
                *a = rounded(*a / factor, PLACES);
                *b = rounded(*b / factor, PLACES);
            }
            _ => return self.to_string(),
        }
        scaled.to_string().replace(" mm", &format!(" {}", unit.symbol()))
    }
}

/// Decimals of lengths in messages: four are what a person can compare.
const PLACES: i32 = 4;

/// Refuses what is no usable length; `what` names it.
pub(crate) fn check_length(what: &'static str, value_mm: f64) -> Result<(), CutError> {
    if value_mm.abs() <= MAX_LENGTH_MM { Ok(()) } else { Err(CutError::OutOfRange { what }) }
}

/// Refuses what is no positive, usable length.
pub(crate) fn check_positive(what: &'static str, value_mm: f64) -> Result<(), CutError> {
    check_length(what, value_mm)?;
    if value_mm > 0.0 { Ok(()) } else { Err(CutError::NotPositive { what }) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_are_told_in_the_unit_of_the_user() {
        let e = CutError::EndNotOnCircle { start_radius_mm: 50.8, end_radius_mm: 80.32191 };
        let text = e.message(LinearUnit::Inch);
        assert!(text.contains("3.1623 in") && text.contains("2 in") && !text.contains("mm"));
        assert!(e.message(LinearUnit::Mm).contains("80.3219 mm"));
    }

    #[test]
    fn lengths_are_bounded() {
        for v in [f64::NAN, f64::INFINITY, -1e300, 1.1e6] {
            assert_eq!(check_length("plunge", v), Err(CutError::OutOfRange { what: "plunge" }));
        }
        assert_eq!(check_length("plunge", -1e6), Ok(()));
        assert_eq!(check_positive("d", 0.0), Err(CutError::NotPositive { what: "d" }));
    }
}
