//! The height map that programs follow, and changes of it.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use ts_rs::TS;

/// Most places of a map that pages are told one by one.
pub const PLACES_TOLD: usize = 2500;

/// The height map in force: heights of a surface at the places of a grid, counted from working zero.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct HeightMap {
    /// Places along X.
    pub columns: u32,
    /// Places along Y.
    pub rows: u32,
    /// Corner with the least X and Y.
    #[ts(type = "[Mm, Mm]")]
    pub low: [f64; 2],
    /// Corner with the greatest X and Y.
    #[ts(type = "[Mm, Mm]")]
    pub high: [f64; 2],
    /// Lowest height.
    #[ts(type = "Mm")]
    pub lowest: f64,
    /// Highest height.
    #[ts(type = "Mm")]
    pub highest: f64,
    /// X of each column; none of a map with more than 2500 places, as the next two.
    #[ts(type = "Mm[]")]
    pub xs: Vec<f64>,
    /// Y of each row.
    #[ts(type = "Mm[]")]
    pub ys: Vec<f64>,
    /// The heights row by row, along X.
    #[ts(type = "Mm[]")]
    pub zs: Vec<f64>,
}

impl HeightMap {
    /// A grid of these columns and rows, with the heights row by row along X, mm.
    pub fn of(xs: &[f64], ys: &[f64], zs: &[f64]) -> Self {
        let ends = |all: &[f64]| [all.first(), all.last()].map(|end| end.copied().unwrap_or(0.0));
        let ([x0, x1], [y0, y1]) = (ends(xs), ends(ys));
        let told = |all: &[f64]| if zs.len() <= PLACES_TOLD { all.to_vec() } else { Vec::new() };
        Self {
            columns: xs.len() as u32,
            rows: ys.len() as u32,
            low: [x0, y0],
            high: [x1, y1],
            lowest: zs.iter().copied().fold(f64::INFINITY, f64::min),
            highest: zs.iter().copied().fold(f64::NEG_INFINITY, f64::max),
            xs: told(xs),
            ys: told(ys),
            zs: told(zs),
        }
    }
}

/// A change of the height map in force.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase", tag = "to", deny_unknown_fields)]
pub enum HeightMapChange {
    /// A file of heights is taken into force.
    File {
        /// Its name below the part folder.
        name: String,
    },
    /// The map is taken off: surfaces are flat.
    Off,
}
