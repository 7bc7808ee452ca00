//! A drawing as SVG: a millimetre is a unit, arcs are arcs, a group is a layer of its colour.

use super::page::ORIGIN;
use super::shapes::SPOT;
use kerf_drawing::{Drawing, Group, Kind, Shape};
use kerf_geom::{Point2, Segment};
use std::fmt::Write;

/// Radius of the dot that stands for a place to drill, millimetres.
const DOT_MM: f64 = 0.5;

/// Width of lines, millimetres: what laser programs take for a cut.
const LINE_MM: f64 = 0.1;

/// A drawing as SVG, its size in millimetres, the lower left of its bounds at that of the page, which the
/// attribute `data-origin` places. Starts and directions stay; settings of groups and arrays are lost.
pub fn write(drawing: &Drawing) -> String {
    let bounds = drawing.bounds().unwrap_or_default();
    let (corner, size) = if bounds.is_empty() {
        (Point2::default(), bounds.size())
    } else {
        (Point2::new(bounds.min.x, bounds.max.y), bounds.size())
    };
    let mut out = String::with_capacity(64 * drawing.shapes.len() + 512);
    // Writing to a string cannot fail.
    let _ = writeln!(
        out,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{w}mm\" height=\"{h}mm\" \
         viewBox=\"{x} {y} {w} {h}\" {ORIGIN}=\"{x},{low}\">",
        w = size.x,
        h = size.y,
        x = corner.x,
        y = -corner.y,
        low = corner.y - size.y,
    );
    for group in Group::ALL {
        let of_group: Vec<&Shape> =
            drawing.shapes.iter().map(AsRef::as_ref).filter(|shape| shape.group == group).collect();
        if !of_group.is_empty() {
            write_group(&mut out, group, &of_group);
        }
    }
    out.push_str("</svg>\n");
    out
}

fn write_group(out: &mut String, group: Group, shapes: &[&Shape]) {
    let colour = if group == Group::White { "#999999" } else { group.name() };
    let _ = writeln!(
        out,
        "<g id=\"{group}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"{LINE_MM}\">"
    );
    for shape in shapes {
        if shape.kind() == Kind::Point {
            let at = shape.start();
            let _ = writeln!(
                out,
                "<circle class=\"{SPOT}\" cx=\"{}\" cy=\"{}\" r=\"{DOT_MM}\"/>",
                at.x,
                -at.y + 0.0
            );
        } else {
            let _ = writeln!(out, "<path d=\"{}\"/>", data(shape));
        }
    }
    out.push_str("</g>\n");
}

/// Path data with Y downwards.
fn data(shape: &Shape) -> String {
    let start = shape.start();
    let mut data = format!("M{} {}", start.x, -start.y + 0.0);
    let path = shape.path.with_short_arcs();
    for segment in path.segments() {
        let end = segment.end();
        let (x, y) = (end.x, -end.y + 0.0);
        let _ = match segment {
            Segment::Line { .. } => write!(data, "L{x} {y}"),
            Segment::Arc { radius, sweep_rad, .. } => {
                // Y points down: what turns counter-clockwise runs against growing angles.
                let sweep = u8::from(sweep_rad < 0.0);
                write!(data, "A{radius} {radius} 0 0 {sweep} {x} {y}")
            }
        };
    }
    if shape.is_closed() {
        data.push('Z');
    }
    data
}
