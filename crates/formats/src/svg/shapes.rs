//! The basic shapes of SVG as paths in millimetres.

use super::length::Measure;
use super::look::Look;
use super::path::{mapped, paths};
use kerf_geom::fit::{self, Ellipse};
use kerf_geom::{Point2, Polyarc, Transform2, Vec2};
use roxmltree::Node;
use std::f64::consts::TAU;
use svgtypes::PointsParser;

/// Paths that an element draws.
#[derive(Debug, Default)]
pub struct Drawn {
    pub paths: Vec<Polyarc>,
    /// The mistake at which the reading of it ended.
    pub wrong: Option<String>,
    /// Number of segments without length.
    pub repeated: usize,
}

/// The class of the dots by which Kerf shows places to drill.
pub const SPOT: &str = "point";

/// A place to drill, where an element is one.
pub fn spot(look: &Look, measure: &Measure) -> Option<Result<Point2, String>> {
    let node = look.node;
    let is_spot = node.tag_name().name() == "circle" && node.attribute("class") == Some(SPOT);
    is_spot.then(|| Sized { look, measure }.point("cx", "cy"))
}

/// Returns the paths that an element draws; nothing for elements that have no outline.
///
/// # Errors
/// What is wrong with it.
pub fn drawn(
    look: &Look,
    measure: &Measure,
    map: &Transform2,
    tolerance: f64,
) -> Result<Option<Drawn>, String> {
    let (node, sized) = (look.node, Sized { look, measure });
    let name = node.tag_name().name();
    let alone = |path: Option<Polyarc>| path.map(|path| (path, 0));
    let found = match name {
        "path" => return path(look, map, tolerance).map(Some),
        "rect" => alone(rect(&sized, map, tolerance)?),
        "circle" => alone(round(&sized, "r", "r", map, tolerance)?),
        "ellipse" => alone(round(&sized, "rx", "ry", map, tolerance)?),
        "line" => alone(line(&sized, map)?),
        "polyline" => points(node, map, false),
        "polygon" => points(node, map, true),
        _ => return Ok(None),
    };
    let one = |(path, repeated)| Drawn { paths: vec![path], wrong: None, repeated };
    found.map(one).map(Some).ok_or_else(|| format!("<{name}> without a size"))
}

fn path(look: &Look, map: &Transform2, tolerance: f64) -> Result<Drawn, String> {
    let own = look.node.attribute("d").unwrap_or_default();
    let mut found = paths(look.styled("d").map_or(own, unwrapped), map, tolerance);
    found.wrong = found.wrong.map(|error| format!("<path>: {error}"));
    match found.wrong {
        Some(error) if found.paths.is_empty() => Err(error),
        _ => Ok(found),
    }
}

/// Path data as a style has them: `path("M 0 0 …")`.
fn unwrapped(text: &str) -> &str {
    let inside = text.strip_prefix("path(").and_then(|rest| rest.strip_suffix(')'));
    inside.map_or("", |data| data.trim().trim_matches(|c| matches!(c, '"' | '\'')))
}

/// An element and what its lengths refer to.
struct Sized<'s, 'a> {
    look: &'s Look<'a>,
    measure: &'s Measure,
}

impl Sized<'_, '_> {
    fn length(&self, name: &str) -> Result<Option<f64>, String> {
        self.look.length(name, self.measure)
    }

    fn point(&self, x: &str, y: &str) -> Result<Point2, String> {
        let or_zero = |name| Ok::<_, String>(self.length(name)?.unwrap_or_default());
        Ok(Point2::new(or_zero(x)?, or_zero(y)?))
    }
}

fn rect(sized: &Sized, map: &Transform2, tolerance: f64) -> Result<Option<Polyarc>, String> {
    let Some((w, h)) = sized.length("width")?.zip(sized.length("height")?) else { return Ok(None) };
    let Point2 { x, y } = sized.point("x", "y")?;
    if w <= 0.0 || h <= 0.0 {
        return Ok(None);
    }
    let (rx, ry) = (sized.length("rx")?, sized.length("ry")?);
    let within = |own: Option<f64>, other: Option<f64>, side: f64| {
        own.or(other).unwrap_or_default().clamp(0.0, 0.5 * side)
    };
    let (rx, ry) = (within(rx, ry, w), within(ry, rx, h));
    if rx == 0.0 || ry == 0.0 {
        let corners = [(x, y), (x + w, y), (x + w, y + h), (x, y + h)];
        let corners = corners.map(|(x, y)| map.apply(Point2::new(x, y)));
        return Ok(Some(Polyarc::lines(corners, true)));
    }
    // Round corners are circles where both radii are equal; else the rectangle is drawn squeezed.
    let squeeze = Transform2::scaled(Point2::new(x, y), 1.0, ry / rx);
    let (a, b) = (Point2::new(x, y), Point2::new(x + w, y + h * rx / ry));
    let round = Polyarc::rounded_rectangle(a, b, rx);
    Ok(fit::affine(&round, &squeeze.then(map), tolerance).ok())
}

/// A circle or an ellipse. One radius that is left open is the other (SVG 2, section 10.4).
fn round(
    sized: &Sized,
    x: &str,
    y: &str,
    map: &Transform2,
    tolerance: f64,
) -> Result<Option<Polyarc>, String> {
    let (rx, ry) = (sized.length(x)?, sized.length(y)?);
    let Some((rx, ry)) = rx.or(ry).zip(ry.or(rx)) else { return Ok(None) };
    if rx <= 0.0 || ry <= 0.0 {
        return Ok(None);
    }
    let centre = sized.point("cx", "cy")?;
    let (major, minor) = (Vec2::new(rx, 0.0), Vec2::new(0.0, ry));
    let ellipse = Ellipse { centre, major, minor, from_rad: 0.0, to_rad: TAU };
    let mut path = mapped(&ellipse, map, tolerance);
    if !path.closed {
        path.vertices.pop();
        path.closed = true;
    }
    // Travel is counter-clockwise whatever the map does.
    Ok(Some(if path.signed_area() < 0.0 { path.reversed() } else { path }))
}

fn line(sized: &Sized, map: &Transform2) -> Result<Option<Polyarc>, String> {
    let ends = (map.apply(sized.point("x1", "y1")?), map.apply(sized.point("x2", "y2")?));
    Ok((ends.0 != ends.1).then(|| Polyarc::lines([ends.0, ends.1], false)))
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
