//! The memory of G-code: modes, offsets, parameters, tools.

use kerf_program::settings::{AxisUnit, LinearUnit};
use kerf_program::{Axes, Axis, PathControl, Settings, SpindleTurn, Tool, ToolTable};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::sync::Arc;

/// The plane of arcs and cycles.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Plane {
    /// G17.
    #[default]
    Xy,
    /// G18.
    Zx,
    /// G19.
    Yz,
}

impl Plane {
    /// The plane of G17, G18 or G19, in tenths.
    pub(super) const fn of_code(code: i32) -> Self {
        match code {
            180 => Self::Zx,
            190 => Self::Yz,
            _ => Self::Xy,
        }
    }

    /// Indices of the first, second and third axis: the third is the one that drills, and turning
    /// from the first to the second is counter-clockwise.
    pub const fn axes(self) -> [usize; 3] {
        match self {
            Self::Xy => [0, 1, 2],
            Self::Zx => [2, 0, 1],
            Self::Yz => [1, 2, 0],
        }
    }
}

/// Meaning of F.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum FeedMode {
    /// G93: one over the minutes a move takes.
    Inverse,
    /// G94: units a minute.
    #[default]
    PerMinute,
    /// G95: units a turn of the spindle.
    PerTurn,
}

/// The side of the path that compensation keeps the tool on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[allow(missing_docs)]
pub enum Side {
    Left,
    Right,
}

/// A feed, for moves of X, Y, Z and for those of rotary axes alone.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Rates {
    /// Millimetres in a minute or in a turn.
    pub linear: f64,
    /// Degrees in a minute or in a turn.
    pub rotary: f64,
}

impl Rates {
    /// The rates of an F word; `None` for F0.
    pub(super) fn new(f: f64, unit_mm: f64) -> Option<Self> {
        (f > 0.0).then_some(Self { linear: f * unit_mm, rotary: f })
    }
}

/// The modes in force.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Modal {
    /// The motion that a place alone makes, as ten times its G number; `None` after G80.
    pub motion: Option<i32>,
    /// G0 or G1, whichever was in force before a cycle: on many controls it goes on behind G80.
    #[serde(default)]
    pub before_cycle: Option<i32>,
    /// The plane.
    pub plane: Plane,
    /// G91.
    pub relative: bool,
    /// G90.1: arc centres are places.
    pub arc_absolute: bool,
    /// Meaning of F.
    pub feed_mode: FeedMode,
    /// The unit of the file.
    pub unit: LinearUnit,
    /// The file said which unit it has.
    pub unit_said: bool,
    /// Cutter compensation: the side and the radius of the tool, mm.
    pub compensation: Option<(Side, f64)>,
    /// G99: cycles return to R, not to where they began.
    pub return_to_r: bool,
    /// The coordinate system, 0 for G54.
    pub system: usize,
    /// G61, G61.1, G64.
    pub path: PathControl,
    /// The feed; `None` until F is given.
    pub feed: Option<Rates>,
    /// Revolutions a minute (S).
    pub rpm: f64,
    /// Spindle direction.
    pub turn: SpindleTurn,
    /// M7.
    pub mist: bool,
    /// M8.
    pub flood: bool,
    /// Feed and spindle overrides hold.
    pub overrides: [bool; 2],
}

impl Default for Modal {
    fn default() -> Self {
        Self {
            motion: None,
            before_cycle: None,
            plane: Plane::Xy,
            relative: false,
            arc_absolute: false,
            feed_mode: FeedMode::PerMinute,
            unit: LinearUnit::Inch,
            unit_said: false,
            compensation: None,
            return_to_r: false,
            system: 0,
            path: PathControl::Blend { tolerance_mm: None, merge_mm: None },
            feed: None,
            rpm: 0.0,
            turn: SpindleTurn::Off,
            mist: false,
            flood: false,
            overrides: [true; 2],
        }
    }
}

impl Modal {
    /// Millimetres or degrees of one unit in the file, without the proportions of FP. A, B and C that the
    /// machine has as linear axes are measured like X.
    pub(super) fn unit_of(&self, settings: &Settings, axis: Axis) -> f64 {
        match settings.axis_unit(axis) {
            AxisUnit::Linear(_) => self.unit.mm(),
            AxisUnit::Degrees => 1.0,
        }
    }
}

/// A coordinate system of G54 … G59.3.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct CoordinateSystem {
    /// Its zero in the machine frame, mm and degrees.
    pub offset: Axes,
    /// Turn about Z, degrees.
    pub rotation_deg: f64,
}

impl CoordinateSystem {
    /// A displacement of this system as one of the machine frame.
    pub(super) fn turn(&self, place: Axes) -> Axes {
        turned(place, self.rotation_deg)
    }

    /// A displacement of the machine frame as one of this system.
    pub(super) fn unturn(&self, place: Axes) -> Axes {
        turned(place, -self.rotation_deg)
    }
}

fn turned(mut place: Axes, degrees: f64) -> Axes {
    let (sin, cos) = degrees.to_radians().sin_cos();
    let [x, y, ..] = place.0;
    if degrees != 0.0 {
        (place.0[0], place.0[1]) = (x * cos - y * sin, x * sin + y * cos);
    }
    place
}

/// State that G-code remembers between blocks and between runs. All lengths are millimetres.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct State {
    /// The modes.
    pub modal: Modal,
    /// G54, G55 … G59.3.
    pub systems: [CoordinateSystem; 9],
    /// The shift of G92 and G52.
    pub shift: Axes,
    /// The shift that G92.3 brings back.
    pub shift_kept: Axes,
    /// The tool offset in force (G43, G43.1).
    pub tool_offset: Axes,
    /// The tool in the spindle.
    pub tool: u32,
    /// The tool that M6 puts in (T).
    pub selected: u32,
    /// Places to which G28 and G30 go, machine frame.
    pub home: [Axes; 2],
    /// End of the last probe move, machine frame.
    pub probed: Axes,
    /// The last probe move made contact.
    pub probe_hit: bool,
    /// Numbered parameters from 31 on.
    pub parameters: BTreeMap<u32, f64>,
    /// Named parameters that begin with an underscore.
    pub globals: BTreeMap<Arc<str>, f64>,
    /// The tool table.
    pub tools: BTreeMap<u32, Tool>,
}

impl State {
    /// The coordinate system in force.
    pub(super) fn system(&self) -> CoordinateSystem {
        self.systems[self.modal.system.min(8)]
    }

    /// Returns the tools that are known, and the one in the spindle.
    pub fn tool_table(&self) -> ToolTable {
        ToolTable { tools: self.tools.clone(), in_spindle: self.tool }
    }

    /// Takes over the tools that another language has changed.
    pub fn use_tools(&mut self, table: &ToolTable) {
        self.tools.clone_from(&table.tools);
        self.tool = table.in_spindle;
    }
}
