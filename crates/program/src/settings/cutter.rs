//! The cutter, tabs, the temporary tool offset and the output that Z switches (VC, VB, VO).

use super::unit::inch;
use crate::{Axes, Axis};
use serde::{Deserialize, Serialize};

/// The sign of a plunge that goes down.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum PlungeSign {
    /// Negative is down.
    #[default]
    Minus,
    /// Positive is down: Z counts downwards.
    Plus,
}

/// The output that Z or A switches (VC 8-12).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Trigger {
    /// The trigger is active; ends with the part file.
    pub active: bool,
    /// ON when passing this working location downwards, mm.
    pub on_at_mm: f64,
    /// OFF when passing this working location upwards, mm.
    pub off_at_mm: f64,
    /// Z or A.
    pub axis: Axis,
    /// Output number.
    pub output: u8,
}

impl Default for Trigger {
    fn default() -> Self {
        Self { active: false, on_at_mm: 0.0, off_at_mm: 0.0, axis: Axis::Z, output: 8 }
    }
}

/// Cutter values (VC).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Cutter {
    /// Cutter diameter, mm.
    pub diameter_mm: f64,
    /// Height for MH, JH and travel; `None` when turned off.
    pub safe_z_mm: Option<f64>,
    /// Height of the A axis for MH and JH.
    pub safe_a_mm: f64,
    /// Which sign plunges down.
    pub plunge: PlungeSign,
    /// Overlap of pocket rings, percent.
    pub pocket_overlap_percent: f64,
    /// The triggered output.
    pub trigger: Trigger,
}

impl Default for Cutter {
    fn default() -> Self {
        Self {
            diameter_mm: inch(0.25),
            safe_z_mm: Some(inch(1.0)),
            safe_a_mm: inch(1.0),
            plunge: PlungeSign::Minus,
            pocket_overlap_percent: 10.0,
            trigger: Trigger::default(),
        }
    }
}

/// Tabs (VB).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Tabs {
    /// Thickness of a tab, mm.
    pub up_mm: f64,
    /// Path between tabs, mm.
    pub next_mm: f64,
    /// Length of the flat top, mm.
    pub size_mm: f64,
    /// Length of each incline along the path, mm.
    pub lead_mm: f64,
    /// On inside a file.
    pub on: bool,
    /// Insert so many, then stop.
    pub count: Option<u32>,
    /// Path to the first tab when not `next_mm`.
    pub start_mm: Option<f64>,
}

impl Default for Tabs {
    fn default() -> Self {
        Self {
            up_mm: inch(0.1),
            next_mm: inch(4.0),
            size_mm: inch(1.0),
            lead_mm: inch(0.5),
            on: false,
            count: None,
            start_mm: None,
        }
    }
}

/// Temporary tool offset (VO).
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ToolOffset {
    /// In force.
    pub on: bool,
    /// The offsets; they add to the commanded axes.
    pub offset: Axes,
}
