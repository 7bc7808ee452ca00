//! What a part file is written with.

use kerf_program::settings::LinearUnit;
use kerf_program::{Axes, Frame, Settings};
use std::sync::Arc;

/// Unit and starting state with which OpenSBP is written.
#[derive(Clone, Debug, PartialEq)]
pub struct Printing {
    /// The unit of the file.
    pub unit: LinearUnit,
    /// The frames at the start.
    pub frame: Frame,
    /// Place of the machine at the start, machine frame.
    pub position: Axes,
    /// The settings at the start.
    pub settings: Arc<Settings>,
    /// The file has to say how many axes there are and what A and B are measured in: those of the
    /// settings.
    pub declare_axes: bool,
    /// The output of the mist coolant; 0 for none.
    pub mist_output: u8,
    /// The output of the flood coolant; 0 for none.
    pub flood_output: u8,
    /// Comments in the first lines.
    pub title: Option<String>,
}

impl Default for Printing {
    fn default() -> Self {
        Self {
            unit: LinearUnit::Inch,
            frame: Frame::default(),
            position: Axes::default(),
            settings: Arc::default(),
            declare_axes: false,
            mist_output: 0,
            flood_output: 0,
            title: None,
        }
    }
}
