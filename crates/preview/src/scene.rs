//! The scene that a picture shows: the motion of one program and the facts of its legend.
//!
//! Lengths are millimetres in the working frame, times seconds. A scene is plain data: whoever ran
//! the program fills it in, and nothing in here is looked up elsewhere.

use kerf_diag::Severity;
use kerf_geom::Bounds3;
use kerf_program::MoveKind;
use kerf_program::settings::LinearUnit;

/// Farther than this from zero nothing is drawn, mm (10 km).
///
/// No machine is so large; below it sums and squares stay far from the ends of the number range.
pub const FARTHEST_MM: f64 = 1.0e7;

/// The unit a person reads.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unit {
    /// `in` or `mm`.
    pub symbol: &'static str,
    /// Millimetres in one unit.
    pub mm: f64,
}

impl Unit {
    /// Millimetres.
    pub const MM: Self = Self { symbol: "mm", mm: 1.0 };
    /// Inches.
    pub const INCH: Self = Self { symbol: "in", mm: 25.4 };
}

impl From<LinearUnit> for Unit {
    fn from(unit: LinearUnit) -> Self {
        Self { symbol: unit.symbol(), mm: unit.mm() }
    }
}

/// The table as VP describes it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TableView {
    /// Working position of the table's corner with the lowest X and Y, mm.
    pub origin: [f64; 2],
    /// Size in X, Y and Z, mm.
    pub size_mm: [f64; 3],
    /// Spacing of the grid lines, counted from the corner, mm; 0 for none.
    pub grid_mm: f64,
}

/// Course of a segment in X and Y; Z changes evenly along it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// Straight.
    Line,
    /// On a circle.
    Arc {
        /// Its centre, mm.
        centre: [f64; 2],
        /// The angle swept, positive counter-clockwise; may exceed a turn.
        sweep_rad: f64,
    },
}

/// One move.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment {
    /// Cut or jog.
    pub kind: MoveKind,
    /// Start, mm.
    pub from: [f64; 3],
    /// End, mm.
    pub to: [f64; 3],
    /// Straight or round.
    pub shape: Shape,
    /// Line of the source file, from 1; 0 when none stands for it.
    pub line: u32,
}

/// Something the run found that a person should know.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// Severity.
    pub severity: Severity,
    /// Description, one sentence.
    pub text: String,
    /// Line of the source file, 0 for none.
    pub line: u32,
}

/// A named part of the program.
#[derive(Clone, Debug, PartialEq)]
pub struct ToolPath {
    /// Its name.
    pub name: String,
    /// The tool, empty when unknown.
    pub tool: String,
    /// Duration, seconds.
    pub seconds: f64,
    /// Index of its first segment.
    pub first_segment: usize,
}

/// Cuts that are drawn in one colour, instead of the colours of depth.
#[derive(Clone, Debug, PartialEq)]
pub struct Coloured {
    /// Description of the cuts, for the legend.
    pub name: String,
    /// Red, green and blue.
    pub colour: [u8; 3],
    /// Width of the cutter, mm; 0 when it is not known.
    pub width_mm: f64,
}

/// Everything a picture shows.
///
/// Segments with a coordinate that is not finite or beyond [`FARTHEST_MM`] are left out; the legend
/// says how many. An empty scene gives a picture of the table, or of an empty sheet.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// Heading, usually the file's name.
    pub title: String,
    /// The unit of numbers in rulers and legend.
    pub unit: Unit,
    /// Table and grid, when known.
    pub table: Option<TableView>,
    /// The motion in order.
    pub segments: Vec<Segment>,
    /// End of each segment, seconds since the start; empty when motion was not planned.
    pub times_s: Vec<f32>,
    /// Colours of cuts; empty for the colours of depth. With them the picture has the bounds of the
    /// cuts and a sign where each begins.
    pub colours: Vec<Coloured>,
    /// The colour of each segment, as a place in `colours`.
    pub coloured: Vec<usize>,
    /// Draw jogs (VP).
    pub show_jogs: bool,
    /// Show the cutting fast forward when the page opens (VP).
    pub simulate: bool,
    /// Draw the cutter while the page plays (VP).
    pub draw_tool: bool,
    /// Places of the rotary axis about X at the start and at the end of each segment, degrees; empty
    /// without one. With it the page can draw the motion on a cylinder.
    pub turns_deg: Vec<[f32; 2]>,
    /// Diameter of the cutter, mm; 0 draws no width.
    pub cutter_mm: f64,
    /// The program said how wide its cutter is. Else the width is only told: drawn as wide as a
    /// cutter that nobody chose, fine work would look smeared.
    pub cutter_known: bool,
    /// Height of the material's surface, mm; depth counts down from here.
    pub surface_z_mm: f64,
    /// Planned duration, seconds.
    pub duration_s: f64,
    /// Length of cutting, mm.
    pub cut_mm: f64,
    /// Length of jogging, mm.
    pub jog_mm: f64,
    /// Bounds of the cutting moves, mm.
    pub bounds: Bounds3,
    /// Program lines executed.
    pub lines_executed: u64,
    /// Findings of the run.
    pub findings: Vec<Finding>,
    /// Named parts in order.
    pub toolpaths: Vec<ToolPath>,
}

impl Default for Scene {
    fn default() -> Self {
        Self {
            title: String::new(),
            unit: Unit::MM,
            table: None,
            segments: Vec::new(),
            times_s: Vec::new(),
            colours: Vec::new(),
            coloured: Vec::new(),
            show_jogs: true,
            simulate: false,
            draw_tool: true,
            turns_deg: Vec::new(),
            cutter_mm: 0.0,
            cutter_known: true,
            surface_z_mm: 0.0,
            duration_s: 0.0,
            cut_mm: 0.0,
            jog_mm: 0.0,
            bounds: Bounds3::default(),
            lines_executed: 0,
            findings: Vec::new(),
            toolpaths: Vec::new(),
        }
    }
}

impl Scene {
    /// The colour of a segment, when it is not that of its depth.
    pub fn colour_of(&self, segment: usize) -> Option<usize> {
        self.coloured.get(segment).copied().filter(|colour| *colour < self.colours.len())
    }

    /// The width of the widest cutter, mm.
    pub(crate) fn widest_mm(&self) -> f64 {
        self.colours.iter().map(|colour| colour.width_mm).fold(0.0, f64::max)
    }
}

impl Segment {
    /// Returns `true` if it can be drawn: every number finite and within [`FARTHEST_MM`].
    pub fn is_drawable(&self) -> bool {
        let near = |v: &f64| v.abs() <= FARTHEST_MM;
        let shape = match &self.shape {
            Shape::Line => true,
            Shape::Arc { centre, sweep_rad } => centre.iter().all(near) && near(sweep_rad),
        };
        shape && self.from.iter().chain(&self.to).all(near)
    }
}
