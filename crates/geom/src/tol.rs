//! The tolerances of the plane, all of them, each with what it decides.
//!
//! Lengths are millimetres. A coordinate of 1,000 mm carries a rounding of 1e-13 mm and one of
//! 1,000,000 mm (a kilometre) 1e-10 mm, so everything below stays well above what doubles lose on a
//! sheet, and well below what a machine can show (a good router repeats to 1e-2 mm).

/// Places nearer to each other than this are one place. It decides whether two segments touch at an
/// end, whether a contour is closed by its last point, and which crossings are one crossing.
pub const SAME_PLACE_MM: f64 = 1e-7;

/// Crossings are accepted this far beyond the end of a segment, and circles that miss each other by
/// less touch. Ten times smaller than [`SAME_PLACE_MM`], so that what is found from both sides of a
/// joint falls on one place.
pub const CONTACT_MM: f64 = 1e-8;

/// An arc that rises less than this above its chord is its chord. Half of [`CONTACT_MM`]: nobody can
/// tell the two apart, and the centre of such an arc lies so far away that it cannot be computed with.
pub const FLAT_MM: f64 = 5e-9;

/// Greatest error of arcs that replace a curve, unless the caller says otherwise: a tenth of the ten-micrometre
/// resolution of a good machine. Readers of drawings use it for splines and ellipses.
pub const FIT_MM: f64 = 1e-3;

/// Greatest distance between ends that are joined, unless the caller says otherwise. The manual's programs export
/// ends that miss each other by a few hundredths.
pub const JOIN_MM: f64 = 0.01;

/// Coordinates beyond this are refused: at 1e9 mm neighbouring doubles lie 1e-7 mm apart, and
/// [`SAME_PLACE_MM`] would decide nothing any more.
pub const FARTHEST_MM: f64 = 1e9;
