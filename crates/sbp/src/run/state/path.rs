//! The path that is being cut.

use kerf_cut::Tabber;
use kerf_program::At;
use serde::{Deserialize, Serialize};

/// Origin of a move in the tab filter.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Origin {
    /// Its line.
    pub(crate) at: At,
    /// The step of the run that executed the line.
    pub(crate) step: u64,
}

/// State of the path that is being cut.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(crate) struct Cutting {
    /// Tabs being cut; `None` outside tabbed paths.
    pub(crate) tabs: Option<Tabber<Origin>>,
    /// Clock angle of the last XY motion, degrees.
    pub(crate) heading: Option<f64>,
    /// I and J of the last CG, mm.
    pub(crate) last_ij: Option<[f64; 2]>,
}

impl Cutting {
    pub(crate) const fn new(heading: Option<f64>) -> Self {
        Self { tabs: None, heading, last_ij: None }
    }
}
