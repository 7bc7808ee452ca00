//! The state of machine and file that a cut needs beside its own parameters.

use crate::CutError;
use crate::error::check_length;
use kerf_geom::Point2;
use kerf_program::Settings;

/// The state of the machine and of the file at the moment of the command.
///
/// Places are in one frame; lengths in mm.
#[derive(Clone, Debug, PartialEq)]
pub struct Context {
    /// Place of the tool.
    pub start: [f64; 3],
    /// The Z that 'plunge from 0' means.
    pub zero_z: f64,
    /// Height for travel over the work; `None` when turned off.
    pub safe_z: Option<f64>,
    /// Cutter diameter.
    pub cutter_mm: f64,
    /// Overlap of pocket rings.
    pub overlap_percent: f64,
    /// Circle segment resolution of VU.
    pub circle_mm: f64,
    /// Circles of a smaller diameter are flagged small.
    pub small_circle_mm: f64,
    /// File proportions X, Y, Z of FP; they scale shapes and plunges, not the cutter.
    pub scale: [f64; 3],
}

/// On which side of the nominal shape the cutter runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Side {
    /// Outside: what is left inside has the nominal size.
    Out,
    /// Inside: the hole has the nominal size.
    In,
    /// The centre of the cutter is on the shape.
    #[default]
    True,
}

impl Side {
    /// Returns the distance of the path outside the shape, mm.
    pub(crate) fn offset_mm(self, cutter_mm: f64) -> f64 {
        match self {
            Self::Out => cutter_mm / 2.0,
            Self::In => -cutter_mm / 2.0,
            Self::True => 0.0,
        }
    }
}

/// Which way round.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Direction {
    /// Direction 1.
    #[default]
    Clockwise,
    /// Direction −1.
    Counter,
}

impl Direction {
    /// The user's number for it; clock angles grow along direction 1.
    pub const fn sign(self) -> f64 {
        match self {
            Self::Clockwise => 1.0,
            Self::Counter => -1.0,
        }
    }
}

impl Context {
    /// The context at `start` with the values of VC, VU and VR, unscaled.
    ///
    /// Where working zero is not the frame's zero or a file is scaled, the caller sets `zero_z`,
    /// `safe_z` and `scale` afterwards.
    pub fn new(start: [f64; 3], settings: &Settings) -> Self {
        Self {
            start,
            zero_z: 0.0,
            safe_z: settings.cutter.safe_z_mm,
            cutter_mm: settings.cutter.diameter_mm,
            overlap_percent: settings.cutter.pocket_overlap_percent,
            circle_mm: settings.resolution.circle_mm,
            small_circle_mm: settings.ramps.small_circle_mm,
            scale: [1.0; 3],
        }
    }

    pub(crate) fn start_xy(&self) -> Point2 {
        Point2::new(self.start[0], self.start[1])
    }

    /// The change of Z that a plunge parameter means.
    ///
    /// The sign that VC gives for plunges never turns Z round: on a machine whose Z grows
    /// downwards a positive plunge already goes down (ledger row SBP-VAL-VC-PLUNGEDIR).
    pub(crate) fn plunge_mm(&self, value: f64) -> f64 {
        value * self.scale[2]
    }

    /// The height at which the tool travels back over the work.
    ///
    /// Without a Safe-Z it is the higher of where the command began and Z 0.
    pub(crate) fn travel_z(&self) -> f64 {
        self.safe_z.unwrap_or_else(|| self.start[2].max(self.zero_z))
    }

    /// Refuses numbers that no machine has.
    pub(crate) fn check(&self) -> Result<(), CutError> {
        self.start.iter().try_for_each(|v| check_length("location of the tool", *v))?;
        self.scale.iter().try_for_each(|v| check_length("file proportion", *v))?;
        if self.scale.contains(&0.0) {
            return Err(CutError::ZeroProportion);
        }
        check_length("zero of Z", self.zero_z)?;
        check_length("Safe-Z", self.safe_z.unwrap_or(0.0))?;
        check_length("circle resolution", self.circle_mm)?;
        check_length("cutter diameter", self.cutter_mm)?;
        if self.cutter_mm < 0.0 {
            return Err(CutError::NotPositive { what: "cutter diameter" });
        }
        Ok(())
    }
}
