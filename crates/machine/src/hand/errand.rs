//! Errands: the moves that a person orders by hand.

use super::WarmStep;
use crate::settings::Configuration;
use kerf_geom::{Point2, Polyarc, Segment};
use kerf_program::job::{Job, JobShape};
use kerf_program::{AXES, Axes, Axis, AxisSet, Settings};
use std::sync::Arc;

/// Without a bound a key that is held moves so far, mm or degrees.
pub const FAR: f64 = 10_000.0;

/// A move that a person orders by hand.
#[derive(Clone, Debug, PartialEq)]
pub enum Errand {
    /// Find the home switches of these axes.
    FindHome(AxisSet),
    /// To home on these axes, Z first.
    Home(AxisSet),
    /// To the job origin in X and Y, Z at least at Z top.
    Origin,
    /// To the finish position of jobs, in the same way.
    Finish,
    /// To a place; axes without a value stay.
    To {
        /// X and Y from the job origin, the others from home; or all from where the tool is.
        place: [Option<f64>; AXES],
        /// From where the tool is.
        relative: bool,
        /// X and Y first, then the others; else all together.
        flat: bool,
    },
    /// In X and Y at Z top, from the job origin.
    CutMoveTo([f64; 2]),
    /// Along lines and arcs, one after the other. A stop ends it for good where the tool stands then.
    Along(Arc<[Stretch]>),
    /// Spindle on in these steps while the machine stands. Whatever stops it ends it for good, with the spindle off.
    WarmUp(Arc<[WarmStep]>),
    /// For as long as a key is held.
    Held(Held),
    /// For as long as a key of the keypad of part files is held.
    Keypad(Keypad),
}

impl Errand {
    /// Returns its name.
    pub const fn name(&self) -> &'static str {
        match self {
            Self::FindHome(_) => "homing",
            Self::Home(_) => "move to home",
            Self::Origin => "move to origin",
            Self::Finish => "move to finish",
            Self::To { .. } => "move to",
            Self::CutMoveTo(_) => "cut move to",
            Self::Along(_) => "move along",
            Self::WarmUp(_) => "warm-up",
            Self::Held(_) => "key",
            Self::Keypad(_) => "keypad",
        }
    }
}

/// A part of a way that is followed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stretch {
    /// A line or an arc, millimetres from the job origin. A line begins where the tool is.
    pub path: Segment,
    /// Z at its end, millimetres from home; without it Z stays.
    pub z_mm: Option<f64>,
}

/// A key that is held.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Held {
    /// Which way, −1, 0 or 1 an axis.
    pub way: [i8; AXES],
    /// Share of the highest speeds, 0.01 … 1.
    pub speed: f64,
    /// Share of the highest accelerations, 0.01 … 1.
    pub accel: f64,
    /// Z may go below Z bottom, which is being set.
    pub sets_bottom: bool,
}

/// A key of the keypad of part files (command reference, SK): it moves as jogs do, with the keypad's own
/// ramp.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Keypad {
    /// Which way, mm or degrees of each axis.
    pub way: [f64; AXES],
    /// Greatest number of times it moves that way; without it, the key moves as far as the axes go.
    pub times: Option<f64>,
    /// Share of the jog speeds, 0.01 … 1.
    pub speed: f64,
    /// Axes that were homed.
    pub homed: AxisSet,
}

/// The settings with which the keypad moves: a share of the jog speeds, its own ramp, no warning.
pub fn keypad_settings(settings: &Settings, share: f64) -> Settings {
    let mut settings = settings.clone();
    let jog = &mut settings.speeds.jog;
    for speed in [&mut jog.xy, &mut jog.z, &mut jog.a, &mut jog.b, &mut jog.c] {
        *speed *= share.clamp(0.01, 1.0);
    }
    settings.ramps.jog_rate_mm = settings.ramps.keypad_rate_mm;
    settings.warning_s = 0.0;
    settings
}

/// CutMoveTo with cutting: a job of one line from where the tool is, cut through, that ends at its end.
pub fn cut_move(machine: &Configuration, position: Axes, [x, y]: [f64; 2]) -> Job {
    let [x0, y0] = machine.job.origin_mm;
    let (origin, to) = (Point2::new(x0, y0), Point2::new(x, y));
    let from = Point2::new(position[Axis::X] - x0, position[Axis::Y] - y0);
    let shape = JobShape::through(1, Polyarc::lines([from, to], false));
    Job {
        name: "cut move to".into(),
        shapes: [shape].into(),
        origin: Some(origin),
        finish: Some(to),
        ..Job::default()
    }
}
