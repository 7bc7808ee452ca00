//! The controllers whose reading of the language is known.

use serde::{Deserialize, Serialize};

/// Which controller's reading of the language holds where they differ.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Dialect {
    /// LinuxCNC: everything.
    #[default]
    LinuxCnc,
    /// grbl 1.1: millimetres unless said otherwise, no cycles, no compensation, lines with `$`.
    Grbl,
    /// grblHAL: grbl with cycles, expressions, O-words, tools, more axes.
    GrblHal,
    /// Mach3: doubtful blocks only give warnings; no O-words, no named parameters.
    Mach3,
    /// Any router: everything, and doubtful blocks only give warnings.
    Generic,
}

impl Dialect {
    /// Returns `true` if doubtful blocks only give warnings.
    pub const fn is_lenient(self) -> bool {
        matches!(self, Self::Generic | Self::Mach3)
    }

    /// Returns `true` if it reads as grbl and its descendants do: millimetres, G0 at the start, lines with `$`.
    pub const fn is_of_grbl(self) -> bool {
        matches!(self, Self::Grbl | Self::GrblHal)
    }

    /// The controller's name as its makers write it.
    pub const fn title(self) -> &'static str {
        match self {
            Self::LinuxCnc => "LinuxCNC",
            Self::Grbl => "grbl",
            Self::GrblHal => "grblHAL",
            Self::Mach3 => "Mach3",
            Self::Generic => "a router",
        }
    }

    /// The name in options.
    pub const fn name(self) -> &'static str {
        match self {
            Self::LinuxCnc => "linuxcnc",
            Self::Grbl => "grbl",
            Self::GrblHal => "grblhal",
            Self::Mach3 => "mach3",
            Self::Generic => "generic",
        }
    }
}
