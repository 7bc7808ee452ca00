//! A small picture of a tool path, or of a drawing, from above, for lists of files.

use super::Path;
use super::path::Segment;
use kerf_drawing::Drawing;
use kerf_geom::Point2;
use kerf_wire::preview::{CUT, JOG};
use std::fmt::Write;

/// Segments that a small picture has at most.
const MOST: usize = 1500;

/// Share of its size by which vertices may be nearer than they are drawn.
const FINE: f64 = 1.0 / 200.0;

/// Chords that an arc of a drawing becomes.
const CHORDS: u32 = 16;

/// The shapes of a drawing, as [`thumbnail`] draws what is cut.
pub fn thumbnail_of(drawing: &Drawing) -> String {
    let mut path = Path::new([0.0; 3], 0.0);
    let mut to = |at: Point2, kind| {
        path.push([at.x, at.y, 0.0], Segment { end_s: 0.0, line: 0, made: 0, kind });
    };
    for shape in &drawing.shapes {
        shape.path.start().into_iter().for_each(|start| to(start, JOG));
        for segment in shape.path.segments() {
            let chords = if segment.arc().is_some() { CHORDS } else { 1 };
            (1..=chords).for_each(|n| to(segment.at(f64::from(n) / f64::from(chords)), CUT));
        }
    }
    thumbnail(&path)
}

/// The cuts of a path from above, as SVG without a colour for its ground; empty where nothing is cut.
pub fn thumbnail(path: &Path) -> String {
    let Some([low, high]) = path.cut_bounds() else { return String::new() };
    let [width, height] = [0, 1].map(|i| (high[i] - low[i]).max(1e-3));
    let size = width.max(height);
    let mut tolerance = size * FINE;
    let mut path = path.coarser(tolerance);
    while path.len() > MOST && tolerance < size {
        tolerance *= 2.0;
        path = path.coarser(tolerance);
    }
    let mut lines = String::new();
    let mut end = None;
    for (from, to, kind) in path.places().take(MOST) {
        if kind == CUT {
            // Y grows downwards in a picture.
            let at =
                |place: [f64; 3]| format!("{:.4} {:.4}", place[0] - low[0], high[1] - place[1]);
            let begins = if end == Some(from) { String::new() } else { format!("M{}", at(from)) };
            _ = write!(lines, "{begins}L{}", at(to));
            end = Some(to);
        }
    }
    let edge = size * 0.04;
    let [x, y] = [width, height].map(|length| (length - size) / 2.0 - edge);
    let side = size + 2.0 * edge;
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{x:.4} {y:.4} {side:.4} {side:.4}\" width=\"96\" \
         height=\"96\"><path d=\"{lines}\" fill=\"none\" stroke=\"#3b82c4\" stroke-width=\"2\" \
         stroke-linejoin=\"round\" vector-effect=\"non-scaling-stroke\"/></svg>"
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use kerf_drawing::Shape;
    use kerf_geom::Polyarc;

    fn path(ends: &[([f64; 2], u8)]) -> Path {
        let mut path = Path::new([0.0; 3], 0.0);
        for ([x, y], kind) in ends {
            let segment = Segment { end_s: 0.0, line: 1, made: 0, kind: *kind };
            path.push([*x, *y, 0.0], segment);
        }
        path
    }

    fn check(ends: &[([f64; 2], u8)], lines: &str) {
        let svg = thumbnail(&path(ends));
        let drawn = svg.split(" d=\"").nth(1).and_then(|rest| rest.split('"').next());
        assert_eq!(drawn.unwrap_or_default(), lines, "{svg}");
    }

    #[test]
    fn cuts_are_drawn_from_above_and_jogs_are_not() {
        check(
            &[
                ([0.0, 0.0], JOG),
                ([10.0, 0.0], CUT),
                ([10.0, 5.0], CUT),
                ([0.0, 5.0], JOG),
                ([0.0, 0.0], CUT),
            ],
            "M0.0000 5.0000L10.0000 5.0000L10.0000 0.0000M0.0000 0.0000L0.0000 5.0000",
        );
        check(&[([10.0, 0.0], JOG)], "");
    }

    #[test]
    fn a_drawing_is_its_shapes_with_arcs() {
        let circle = Polyarc::circle(Point2::new(5.0, 5.0), 5.0);
        let lines = Polyarc::lines([Point2::new(0.0, 0.0), Point2::new(10.0, 0.0)], false);
        let shapes = [circle, lines].map(Shape::flat);
        let drawing = Drawing::of(shapes);
        let svg = thumbnail_of(&drawing);
        assert!(svg.contains("viewBox=\"-0.4000 -0.4000 10.8000 10.8000\""), "{svg}");
        assert_eq!(svg.matches('M').count(), 2, "{svg}");
        assert!(svg.matches('L').count() > 20, "{svg}");
        assert_eq!(thumbnail_of(&Drawing::default()), "");
    }

    #[test]
    fn a_long_path_becomes_a_small_picture() {
        let ends: Vec<_> =
            (0..100_000).map(|n| ([f64::from(n % 300), f64::from(n / 300)], CUT)).collect();
        assert!(thumbnail(&path(&ends)).len() < 40_000);
    }
}
