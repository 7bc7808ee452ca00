//! The basic shapes of SVG as paths in millimetres.

use super::path::{mapped, paths};
use kerf_geom::fit::{self, Ellipse};
use kerf_geom::{Point2, Polyarc, Transform2, Vec2};
use roxmltree::Node;
use std::f64::consts::TAU;
use svgtypes::PointsParser;

/// What an element draws.
#[derive(Debug, Default)]
pub struct Drawn {
    pub paths: Vec<Polyarc>,
    /// The mistake at which the reading of it ended.
    pub wrong: Option<String>,
    /// How many segments have no length.
    pub repeated: usize,
}

/// The class of the dots by which Kerf shows places to drill.
pub const SPOT: &str = "point";

/// A place to drill.
pub fn spot(node: Node) -> Option<Point2> {
    let is_spot = node.tag_name().name() == "circle" && node.attribute("class") == Some(SPOT);
    is_spot.then(|| Point2::new(or_zero(node, "cx"), or_zero(node, "cy")))
}

/// What an element draws, or what is wrong with it. Nothing for elements that draw nothing.
pub fn drawn(node: Node, map: &Transform2, tolerance: f64) -> Option<Result<Drawn, String>> {
    let some = |path: Option<(Polyarc, usize)>| {
        let size = || format!("<{}> without a size", node.tag_name().name());
        let one = |(path, repeated)| Drawn { paths: vec![path], wrong: None, repeated };
        path.map(one).ok_or_else(size)
    };
    let one = |path: Option<Polyarc>| some(path.map(|path| (path, 0)));
    Some(match node.tag_name().name() {
        "path" => {
            let mut found = paths(node.attribute("d").unwrap_or_default(), map, tolerance);
            found.wrong = found.wrong.map(|error| format!("<path>: {error}"));
            match found.wrong {
                Some(error) if found.paths.is_empty() => Err(error),
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
        "polyline" => some(points(node, map, false)),
        "polygon" => some(points(node, map, true)),
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

/// Lines through places, and how many of them have no length.
fn points(node: Node, map: &Transform2, closed: bool) -> Option<(Polyarc, usize)> {
    let places = PointsParser::from(node.attribute("points")?);
    let places = places.map(|(x, y)| map.apply(Point2::new(x, y)));
    let lines = Polyarc::lines(places, closed);
    let repeated = lines.vertices.windows(2).filter(|pair| pair[0].at == pair[1].at).count();
    let path = lines.tidied();
    (path.segment_count() > 0).then_some((path, repeated))
}
