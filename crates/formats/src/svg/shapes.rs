//! The basic shapes of SVG as paths in millimetres.

use super::path::{mapped, paths};
use kerf_geom::fit::{self, Ellipse};
use kerf_geom::{Point2, Polyarc, Transform2, Vec2};
use roxmltree::Node;
use std::f64::consts::TAU;
use svgtypes::PointsParser;

/// What an element draws, or what is wrong with it. Nothing for elements that draw nothing.
pub fn drawn(node: Node, map: &Transform2, tolerance: f64) -> Option<Result<Vec<Polyarc>, String>> {
    let one = |path: Option<Polyarc>| {
        let size = || format!("<{}> without a size", node.tag_name().name());
        path.map(|path| vec![path]).ok_or_else(size)
    };
    Some(match node.tag_name().name() {
        "path" => {
            let (found, wrong) = paths(node.attribute("d").unwrap_or_default(), map, tolerance);
            match wrong {
                Some(error) if found.is_empty() => Err(format!("<path>: {error}")),
                _ => Ok(found),
            }
        }
        "rect" => one(rect(node, map, tolerance)),
        "circle" => one(number(node, "r").and_then(|r| round(node, r, r, map, tolerance))),
        "ellipse" => {
            let radii = number(node, "rx").zip(number(node, "ry"));
            one(radii.and_then(|(rx, ry)| round(node, rx, ry, map, tolerance)))
        }
        "line" => one(line(node, map)),
        "polyline" => one(points(node, map, false)),
        "polygon" => one(points(node, map, true)),
        _ => return None,
    })
}

/// A length of an element in units of the file; percent and font sizes are not known here.
pub fn number(node: Node, name: &str) -> Option<f64> {
    length(node.attribute(name)?)
}

/// A length in units of the file.
pub fn length(text: &str) -> Option<f64> {
    use svgtypes::LengthUnit as U;
    let length: svgtypes::Length = text.trim().parse().ok()?;
    let units = match length.unit {
        U::None | U::Px => 1.0,
        U::In => 96.0,
        U::Cm => 96.0 / 2.54,
        U::Mm => 96.0 / 25.4,
        U::Pt => 96.0 / 72.0,
        U::Pc => 16.0,
        U::Em | U::Ex | U::Percent => return None,
    };
    Some(length.number * units).filter(|value| value.is_finite())
}

fn or_zero(node: Node, name: &str) -> f64 {
    number(node, name).unwrap_or_default()
}

fn rect(node: Node, map: &Transform2, tolerance: f64) -> Option<Polyarc> {
    let (w, h) = number(node, "width").zip(number(node, "height"))?;
    let (x, y) = (or_zero(node, "x"), or_zero(node, "y"));
    if w <= 0.0 || h <= 0.0 {
        return None;
    }
    let rx = number(node, "rx").or(number(node, "ry")).unwrap_or_default().clamp(0.0, 0.5 * w);
    let ry = number(node, "ry").or(number(node, "rx")).unwrap_or_default().clamp(0.0, 0.5 * h);
    if rx == 0.0 || ry == 0.0 {
        let corners = [(x, y), (x + w, y), (x + w, y + h), (x, y + h)];
        return Some(Polyarc::lines(corners.map(|(x, y)| map.apply(Point2::new(x, y))), true));
    }
    // Round corners are circles where both radii are equal; else the rectangle is drawn squeezed.
    let squeeze = Transform2::scaled(Point2::new(x, y), 1.0, ry / rx);
    let (a, b) = (Point2::new(x, y), Point2::new(x + w, y + h * rx / ry));
    let round = Polyarc::rounded_rectangle(a, b, rx);
    fit::affine(&round, &squeeze.then(map), tolerance).ok()
}

fn round(node: Node, rx: f64, ry: f64, map: &Transform2, tolerance: f64) -> Option<Polyarc> {
    if rx <= 0.0 || ry <= 0.0 {
        return None;
    }
    let centre = Point2::new(or_zero(node, "cx"), or_zero(node, "cy"));
    let (major, minor) = (Vec2::new(rx, 0.0), Vec2::new(0.0, ry));
    let ellipse = Ellipse { centre, major, minor, from_rad: 0.0, to_rad: TAU };
    let mut path = mapped(&ellipse, map, tolerance);
    if !path.closed {
        path.vertices.pop();
        path.closed = true;
    }
    // Travel is counter-clockwise whatever the map does.
    Some(if path.signed_area() < 0.0 { path.reversed() } else { path })
}

fn line(node: Node, map: &Transform2) -> Option<Polyarc> {
    let end = |x, y| map.apply(Point2::new(or_zero(node, x), or_zero(node, y)));
    let (from, to) = (end("x1", "y1"), end("x2", "y2"));
    (from != to).then(|| Polyarc::lines([from, to], false))
}

fn points(node: Node, map: &Transform2, closed: bool) -> Option<Polyarc> {
    let places = PointsParser::from(node.attribute("points")?);
    let places = places.map(|(x, y)| map.apply(Point2::new(x, y)));
    let path = Polyarc::lines(places, closed).tidied();
    (path.segment_count() > 0).then_some(path)
}
