//! A drawing on paper, described once and written as SVG or painted as PNG.
//!
//! The page frame is millimetres with Y down, as both outputs have it; the working frame is the
//! program's own with Y up, so that numbers in the SVG are the numbers of the program. A page
//! position is the working position with Y negated.

mod outline;
mod simplify;

pub use outline::{Op, Outline, arc_pieces};
pub use simplify::simplify;

use crate::palette::Rgb;
use kerf_geom::Point2;

/// The frame of a layer's coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Frame {
    /// Working coordinates, Y up.
    Working,
    /// Page coordinates, Y down.
    Page,
}

/// A rectangle in the page frame, mm.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rect {
    /// Left edge.
    pub x: f64,
    /// Upper edge.
    pub y: f64,
    /// Width.
    pub w: f64,
    /// Height.
    pub h: f64,
}

/// A line of constant width.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stroke {
    /// Colour.
    pub colour: Rgb,
    /// Width, mm.
    pub width: f64,
    /// Lengths of dash and gap, mm.
    pub dash: Option<[f64; 2]>,
}

/// Paint of a path; the stroke lies over the fill.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Paint {
    /// Inside.
    pub fill: Option<Rgb>,
    /// Edge.
    pub stroke: Option<Stroke>,
}

/// Place of text relative to its point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Anchor {
    /// Begins there.
    Start,
    /// Has its middle there.
    Middle,
    /// Ends there.
    End,
}

/// One line of text.
#[derive(Clone, Debug, PartialEq)]
pub struct Text {
    /// On the base line, page frame.
    pub at: Point2,
    /// Height of the em, mm.
    pub size: f64,
    /// Alignment.
    pub anchor: Anchor,
    /// Heavy letters.
    pub bold: bool,
    /// Colour.
    pub colour: Rgb,
    /// A white rim, for text over lines.
    pub halo: bool,
    /// The text.
    pub text: String,
}

/// One thing on the sheet.
#[derive(Clone, Debug, PartialEq)]
pub enum Mark {
    /// A path.
    Path {
        /// Outline.
        outline: Outline,
        /// Paint.
        paint: Paint,
    },
    /// A line of text.
    Text(Text),
}

/// Marks that belong together, drawn in order.
#[derive(Clone, Debug, PartialEq)]
pub struct Layer {
    /// Name in the SVG.
    pub id: &'static str,
    /// Frame of its coordinates.
    pub frame: Frame,
    /// The layer ends at the drawing's frame.
    pub clip: bool,
    /// Marks of the layer.
    pub marks: Vec<Mark>,
}

/// The whole drawing.
#[derive(Clone, Debug, PartialEq)]
pub struct Sheet {
    /// Heading.
    pub title: String,
    /// A sentence for those who do not see the picture.
    pub description: String,
    /// The page, relative to `origin`.
    pub page: Rect,
    /// The drawing's frame, relative to `origin`.
    pub panel: Rect,
    /// Working position that lies at 0,0 of the page frame. It is 0,0 itself unless the drawing is
    /// so far away that single precision, which browsers draw with, would show.
    pub origin: Point2,
    /// Decimals of coordinates.
    pub decimals: u32,
    /// From bottom to top.
    pub layers: Vec<Layer>,
}

impl Rect {
    /// The right edge.
    pub fn right(&self) -> f64 {
        self.x + self.w
    }

    /// The lower edge.
    pub fn bottom(&self) -> f64 {
        self.y + self.h
    }

    /// The same, larger by so much on each side.
    pub fn grown(&self, by: f64) -> Self {
        Self { x: self.x - by, y: self.y - by, w: self.w + 2.0 * by, h: self.h + 2.0 * by }
    }

    /// The smallest rectangle around both.
    pub fn around(&self, other: &Self) -> Self {
        let (x, y) = (self.x.min(other.x), self.y.min(other.y));
        let (right, bottom) = (self.right().max(other.right()), self.bottom().max(other.bottom()));
        Self { x, y, w: right - x, h: bottom - y }
    }

    /// The longer side.
    pub fn longer(&self) -> f64 {
        self.w.max(self.h)
    }
}

impl Layer {
    /// An empty layer.
    pub fn new(id: &'static str, frame: Frame, clip: bool) -> Self {
        Self { id, frame, clip, marks: Vec::new() }
    }

    /// Adds a path, unless there is nothing in it.
    pub fn path(&mut self, outline: Outline, paint: Paint) {
        if !outline.ops.is_empty() {
            self.marks.push(Mark::Path { outline, paint });
        }
    }
}

impl Paint {
    /// A solid line.
    pub fn line(colour: Rgb, width: f64) -> Self {
        Self { fill: None, stroke: Some(Stroke { colour, width, dash: None }) }
    }

    /// A dashed line.
    pub fn dashed(colour: Rgb, width: f64, dash: [f64; 2]) -> Self {
        Self { fill: None, stroke: Some(Stroke { colour, width, dash: Some(dash) }) }
    }

    /// An area.
    pub fn fill(colour: Rgb) -> Self {
        Self { fill: Some(colour), stroke: None }
    }

    /// An area with an edge.
    pub fn edged(colour: Rgb, edge: Rgb, width: f64) -> Self {
        Self { fill: Some(colour), ..Self::line(edge, width) }
    }
}
