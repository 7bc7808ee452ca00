//! One chart: a frame with numbers, and curves in it.

use super::curve::Curve;
use super::scale::Scale;
use crate::palette::{EDGE, FINE, INK, PAPER, Rgb, SOFT};
use crate::sheet::{Anchor, Layer, Mark, Outline, Paint, Rect, Text, simplify};
use kerf_geom::Point2;

/// Size of the small letters, mm.
pub const EM: f64 = 2.5;
/// A curve may leave its points by so much on the page, mm; less than half a line's width.
const DETAIL_MM: f64 = 0.03;
/// Distance of numbers along the edges, mm.
const APART_MM: [f64; 2] = [22.0, 7.0];

/// A chart's frame and scales.
pub struct Chart {
    pub area: Rect,
    pub x: Scale,
    pub y: Scale,
}

impl Chart {
    /// A chart of values `x` over an area, both in internal units.
    pub fn new(area: Rect, x: [f64; 2], y: [f64; 2], units: [f64; 2]) -> Self {
        let scale = |[low, high]: [f64; 2], start, end, unit| {
            let high = if high > low { high } else { low + unit };
            Scale { low, high, start, end, unit }
        };
        let x = scale(x, area.x, area.right(), units[0]);
        let y = scale(y, area.bottom(), area.y, units[1]).with_room();
        Self { area, x, y }
    }

    /// The ground with its grid.
    pub fn ground(&self, layer: &mut Layer) {
        layer.path(Outline::of_rect(self.area), Paint::fill(PAPER));
        let mut grid = Outline::default();
        for tick in self.x.ticks(APART_MM[0]) {
            grid.segment(
                Point2::new(tick.at, self.area.y),
                Point2::new(tick.at, self.area.bottom()),
            );
        }
        for tick in self.y.ticks(APART_MM[1]) {
            grid.segment(
                Point2::new(self.area.x, tick.at),
                Point2::new(self.area.right(), tick.at),
            );
        }
        layer.path(grid, Paint::line(FINE, 0.15));
    }

    /// The frame with numbers; those below only where nothing else stands there.
    pub fn frame(&self, layer: &mut Layer, title: &str, below: Option<&str>) {
        let area = self.area;
        if self.y.low < 0.0 {
            let mut zero = Outline::default();
            let y = self.y.at(0.0);
            zero.segment(Point2::new(area.x, y), Point2::new(area.right(), y));
            layer.path(zero, Paint::line(EDGE, 0.2));
        }
        layer.path(Outline::of_rect(area), Paint::line(EDGE, 0.25));
        let mut put = |x, y, anchor, colour, text| {
            layer.marks.push(Mark::Text(words(Point2::new(x, y), anchor, colour, text)));
        };
        for tick in self.y.ticks(APART_MM[1]) {
            put(area.x - 1.2, tick.at + 0.35 * EM, Anchor::End, SOFT, tick.text);
        }
        put(area.x, area.y - 1.2, Anchor::Start, INK, title.into());
        let Some(name) = below else { return };
        for tick in self.x.ticks(APART_MM[0]) {
            put(tick.at, area.bottom() + 1.4 * EM, Anchor::Middle, SOFT, tick.text);
        }
        put(area.right(), area.bottom() + 2.8 * EM, Anchor::End, INK, name.into());
    }

    /// A curve as a line.
    pub fn curve(&self, layer: &mut Layer, curve: &Curve, paint: Paint) {
        layer.path(simplify(&self.outline(curve), DETAIL_MM), paint);
    }

    /// The area between a curve and zero.
    pub fn area(&self, layer: &mut Layer, curve: &Curve, colour: Rgb) {
        let mut outline = simplify(&self.outline(curve), DETAIL_MM);
        let ends = [curve.points().last(), curve.points().next()];
        if let [Some(last), Some(first)] = ends {
            let zero = self.y.at(0.0);
            outline.line_to(Point2::new(self.x.at(f64::from(last[0])), zero));
            outline.line_to(Point2::new(self.x.at(f64::from(first[0])), zero));
            outline.close();
            layer.path(outline, Paint::fill(colour));
        }
    }

    fn outline(&self, curve: &Curve) -> Outline {
        let mut outline = Outline::default();
        for [x, y] in curve.points() {
            let at = Point2::new(self.x.at(f64::from(x)), self.y.at(f64::from(y)));
            if outline.ops.is_empty() { outline.move_to(at) } else { outline.line_to(at) }
        }
        outline
    }
}

/// A line of small text.
pub fn words(at: Point2, anchor: Anchor, colour: Rgb, text: String) -> Text {
    Text { at, size: EM, anchor, bold: false, colour, halo: false, text }
}
