//! The units that a person types and reads.

use serde::{Deserialize, Serialize};

/// Millimetres in an inch.
pub const MM_PER_INCH: f64 = 25.4;

/// The unit a person types and reads lengths in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum LinearUnit {
    /// Inches, the manuals' default.
    #[default]
    Inch,
    /// Millimetres.
    Mm,
}

impl LinearUnit {
    /// Millimetres in one unit.
    pub const fn mm(self) -> f64 {
        match self {
            Self::Inch => MM_PER_INCH,
            Self::Mm => 1.0,
        }
    }

    /// `in` or `mm`.
    pub const fn symbol(self) -> &'static str {
        match self {
            Self::Inch => "in",
            Self::Mm => "mm",
        }
    }
}

/// Unit in which an axis is measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum AxisUnit {
    /// A length, shown in this unit.
    Linear(LinearUnit),
    /// Degrees, never converted.
    Degrees,
}

impl AxisUnit {
    /// Internal units (mm or degrees) in one unit of the user.
    pub const fn scale(self) -> f64 {
        match self {
            Self::Linear(unit) => unit.mm(),
            Self::Degrees => 1.0,
        }
    }
}

/// An internal value in a user unit of `scale` internal units.
///
/// The decimal that converts back to this value, give or take the last bit, is taken where there
/// is one, so that 3 in is read back as 3 and not as 2.9999999999999996, and as 76.2 in mm.
pub fn to_user(internal: f64, scale: f64) -> f64 {
    let quotient = internal / scale;
    if internal == 0.0 {
        return quotient;
    }
    let decimal = (quotient * 1e9).round() / 1e9;
    if (decimal * scale - internal).abs() <= 2.0 * f64::EPSILON * internal.abs() {
        decimal
    } else {
        quotient
    }
}

/// So many inches, in millimetres.
pub(super) const fn inch(v: f64) -> f64 {
    v * MM_PER_INCH
}
