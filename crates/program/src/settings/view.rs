//! The settings of the preview's view and of the display (VP, VD).

use super::unit::inch;
use serde::{Deserialize, Serialize};

/// The preview's view (VP).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct View {
    /// Line spacing of the grid, mm.
    pub grid_mm: f64,
    /// Table size X, Y, Z, mm.
    pub table_mm: [f64; 3],
    /// Animate cutting.
    pub simulate: bool,
    /// Draw the cutter.
    pub draw_tool: bool,
    /// Start at the tool's location, else at 0,0.
    pub start_actual: bool,
    /// Draw jogs.
    pub show_jogs: bool,
}

impl Default for View {
    fn default() -> Self {
        Self {
            grid_mm: inch(6.0),
            table_mm: [inch(96.0), inch(48.0), inch(6.0)],
            simulate: false,
            draw_tool: true,
            start_actual: true,
            show_jogs: true,
        }
    }
}

/// Display values (VD).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Display {
    /// Show the control console (obsolete field 6).
    pub console: bool,
    /// Show file comments in the message screen.
    pub comments: bool,
    /// Tap distance of the keypad, mm.
    pub keypad_fixed_mm: f64,
    /// Source of moves at the keypad: 0 mouse and keys, 1 also a pendant on inputs, 2 also another
    /// program.
    pub keypad_remote: u8,
    /// Write the part file log.
    pub part_log: bool,
    /// Write the system log.
    pub system_log: bool,
    /// Message screen X, Y, width, height in twips (1/1440 in).
    pub message_twips: [f64; 4],
    /// Turn outputs off when the keypad closes.
    pub keypad_auto_off: bool,
    /// Show file progress.
    pub progress: bool,
    /// EASY interface, else FULL.
    pub easy: bool,
}

impl Default for Display {
    fn default() -> Self {
        Self {
            console: true,
            comments: false,
            keypad_fixed_mm: inch(0.1),
            keypad_remote: 0,
            part_log: true,
            system_log: true,
            message_twips: [0.0, 0.0, 8800.0, 4600.0],
            keypad_auto_off: false,
            progress: false,
            easy: true,
        }
    }
}

impl Display {
    /// Returns `true` if keys of a pendant, wired to inputs, move the tool at the keypad.
    pub const fn has_pendant(&self) -> bool {
        self.keypad_remote == 1
    }
}
