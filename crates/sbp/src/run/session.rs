//! The state and options from which a run starts, and the state that stays after it.

use super::Variables;
use crate::syntax::Dialect;
use kerf_program::{Axes, AxisSet, FileCall, Frame, GoTo, Settings};
use serde::{Deserialize, Serialize};

/// The state of the machine's memory between runs.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Session {
    /// The settings.
    pub settings: Settings,
    /// The frames.
    pub frame: Frame,
    /// Place of the machine, machine frame.
    pub position: Axes,
    /// The user's variables.
    pub variables: Variables,
    /// Axes that MI keeps moving.
    #[serde(default)]
    pub independent: AxisSet,
    /// The part of the position that the tool offset of VO contributes.
    #[serde(default)]
    pub offset_applied: Axes,
    /// Clock angle of the last XY motion, degrees; a typed MD turns from it, a file begins without.
    #[serde(default)]
    pub heading: Option<f64>,
    /// In preview mode: what SM returns to.
    #[serde(default)]
    pub before_preview: Option<Box<BeforePreview>>,
}

/// Place of the machine when SP was given: a preview moves nothing.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct BeforePreview {
    /// The frames.
    pub frame: Frame,
    /// True place of the machine, machine frame.
    pub position: Axes,
    /// The part of it that the tool offset of VO contributes.
    pub offset_applied: Axes,
}

/// The parameters of FP for the file at the top.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct FileParameters {
    /// Proportions X, Y, Z.
    pub proportion: [f64; 3],
    /// Number of times that the file runs.
    pub repetitions: u32,
    /// 0 none, 1 the present X, Y, Z is the temporary zero, 2 only X and Y.
    pub offset: u8,
    /// Change of Z before each repetition, mm.
    pub plunge_mm: f64,
    /// Leave tabs on the last repetition.
    pub tabs: bool,
    /// Start plunges from Z 0.
    pub plunge_from_zero: bool,
    /// Go through it line by line, as FG does.
    #[serde(default)]
    pub stepped: bool,
    /// Start of the file, the first time; its first line when nothing is given.
    #[serde(default)]
    pub from: Option<GoTo>,
}

impl FileParameters {
    /// Returns those that are told to whoever looks at the run.
    pub const fn call(&self) -> FileCall {
        let Self { proportion, offset, repetitions, plunge_mm, tabs, plunge_from_zero, .. } = *self;
        FileCall { proportion, offset, repetitions, plunge_mm, tabs, plunge_from_zero }
    }
}

impl Default for FileParameters {
    fn default() -> Self {
        Self {
            proportion: [1.0; 3],
            repetitions: 1,
            offset: 0,
            plunge_mm: 0.0,
            tabs: false,
            plunge_from_zero: false,
            stepped: false,
            from: None,
        }
    }
}

/// Options with which a program is run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Options {
    /// Which reading of the language.
    pub dialect: Dialect,
    /// Bound on executed lines; 0 is none.
    pub max_lines: u64,
    /// Seed of RND.
    pub seed: u64,
    /// The parameters of FP.
    pub file: FileParameters,
    /// Run a file with errors up to the first bad line that is reached.
    pub allow_errors: bool,
    /// `%(22)` reads 1 although no SP was given: this run is a preview.
    pub preview: bool,
    /// The text is what the operator typed, not a file: the values it sets stay, and what belongs
    /// into files only is refused.
    #[serde(default)]
    pub typed: bool,
    /// `%(6)` to `%(10)` and the base values of VA are locations, as the reference describes them,
    /// also where the dialect reads them as base minus working (see `interp::locate`).
    #[serde(default)]
    pub base_locations: bool,
    /// Somebody runs the G-code that comes in the way; without, it is an error.
    #[serde(default)]
    pub gcode: bool,
    /// The machine's settings are protected by a password that nobody gave: nothing typed changes
    /// them, and what a file sets ends with it.
    #[serde(default)]
    pub protected: bool,
    /// It began in preview on a machine that nobody armed: preview is not left.
    #[serde(default)]
    pub draws_only: bool,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            dialect: Dialect::Sb3,
            max_lines: 50_000_000,
            seed: 0,
            file: FileParameters::default(),
            allow_errors: false,
            preview: false,
            typed: false,
            base_locations: false,
            gcode: false,
            protected: false,
            draws_only: false,
        }
    }
}
