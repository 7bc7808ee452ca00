//! `transform` as an attribute, in the words of SVG, and in a style, in the words of CSS.
//!
//! Sources: SVG 1.1, section 7.6; CSS Transforms 1, sections 6 and 13.

use super::length::{Along, Measure, split};
use super::look::Look;
use kerf_geom::{Point2, Transform2, Vec2};
use svgtypes::{TransformListParser, TransformListToken};

/// The map of an element into what it stands in, or why it cannot be told.
pub fn transform(look: &Look, measure: &Measure) -> Result<Transform2, String> {
    for name in ["translate", "rotate", "scale", "offset-path"] {
        if look.styled(name).is_some_and(|value| value != "none") {
            return Err(format!("the style `{name}` is not read; write it as a transform"));
        }
    }
    let map = match look.styled("transform") {
        Some("none") => return Ok(Transform2::IDENTITY),
        Some(text) => css(text, measure)?,
        None => match look.node.attribute("transform") {
            Some(text) => svg(text).map_err(|error| format!("transform: {error}"))?,
            None => return Ok(Transform2::IDENTITY),
        },
    };
    Ok(map.about(origin(look, measure)?))
}

/// The place that a transform leaves where it is, in the frame of the element.
fn origin(look: &Look, measure: &Measure) -> Result<Point2, String> {
    let Some(text) = look.value("transform-origin") else { return Ok(Point2::default()) };
    let own_box = look.value("transform-box").is_some_and(|name| name != "view-box");
    let mut words: Vec<&str> = text.split_whitespace().collect();
    if words.len() == 1 {
        words.push("center");
    }
    if matches!(words[0], "top" | "bottom") || matches!(words[1], "left" | "right") {
        words.swap(0, 1);
    }
    let place = |word: &str, along| {
        let word = match word {
            "left" | "top" => "0%",
            "center" => "50%",
            "right" | "bottom" => "100%",
            other => other,
        };
        if own_box && (word.ends_with('%') || measure.units(word, along) != Ok(0.0)) {
            return Err("a transform-origin in the element's own box is not read".to_owned());
        }
        measure.units(word, along).map_err(|why| format!("transform-origin: {why}"))
    };
    Ok(Point2::new(place(words[0], Along::Width)?, place(words[1], Along::Height)?))
}

/// A list of transforms; the last one in it is done first.
fn svg(text: &str) -> Result<Transform2, svgtypes::Error> {
    let mut map = Transform2::IDENTITY;
    for token in TransformListParser::from(text) {
        map = one(token?).then(&map);
    }
    Ok(map)
}

fn one(token: TransformListToken) -> Transform2 {
    use TransformListToken as T;
    let origin = Point2::default();
    match token {
        T::Matrix { a, b, c, d, e, f } => matrix([a, b, c, d, e, f]),
        T::Translate { tx, ty } => Transform2::moved(Vec2::new(tx, ty)),
        T::Scale { sx, sy } => Transform2::scaled(origin, sx, sy),
        T::Rotate { angle } => Transform2::turned(origin, angle.to_radians()),
        T::SkewX { angle } => skew(angle.to_radians(), 0.0),
        T::SkewY { angle } => skew(0.0, angle.to_radians()),
    }
}

fn matrix([a, b, c, d, e, f]: [f64; 6]) -> Transform2 {
    Transform2 { x_axis: Vec2::new(a, b), y_axis: Vec2::new(c, d), origin: Vec2::new(e, f) }
}

fn skew(x_rad: f64, y_rad: f64) -> Transform2 {
    matrix([1.0, y_rad.tan(), x_rad.tan(), 1.0, 0.0, 0.0])
}

/// The same in the words of CSS: `translate(10px, 50%) rotate(0.25turn)`.
fn css(text: &str, measure: &Measure) -> Result<Transform2, String> {
    let (mut map, mut rest) = (Transform2::IDENTITY, text.trim());
    while !rest.is_empty() {
        let unread = || format!("the style `transform: {}` is not read", text.trim());
        let (name, tail) = rest.split_once('(').ok_or_else(unread)?;
        let (arguments, tail) = tail.split_once(')').ok_or_else(unread)?;
        let arguments: Vec<&str> = arguments.split(',').map(str::trim).collect();
        let own = function(name.trim(), &arguments, measure).ok_or_else(unread)?;
        map = own.then(&map);
        rest = tail.trim_start();
    }
    Ok(map)
}

fn function(name: &str, arguments: &[&str], measure: &Measure) -> Option<Transform2> {
    let origin = Point2::default();
    let number = |text: &str| split(text).ok().filter(|(_, unit)| unit.is_empty()).map(|it| it.0);
    let wide = |text: &str| measure.units(text, Along::Width).ok();
    let tall = |text: &str| measure.units(text, Along::Height).ok();
    let moved = |x, y| Transform2::moved(Vec2::new(x, y));
    Some(match (name, arguments) {
        ("translate", [x]) | ("translateX", [x]) => moved(wide(x)?, 0.0),
        ("translate", [x, y]) => moved(wide(x)?, tall(y)?),
        ("translateY", [y]) => moved(0.0, tall(y)?),
        ("scale", [both]) => Transform2::scaled(origin, number(both)?, number(both)?),
        ("scale", [x, y]) => Transform2::scaled(origin, number(x)?, number(y)?),
        ("scaleX", [x]) => Transform2::scaled(origin, number(x)?, 1.0),
        ("scaleY", [y]) => Transform2::scaled(origin, 1.0, number(y)?),
        ("rotate", [angle]) => Transform2::turned(origin, radians(angle)?),
        ("skew" | "skewX", [x]) => skew(radians(x)?, 0.0),
        ("skew", [x, y]) => skew(radians(x)?, radians(y)?),
        ("skewY", [y]) => skew(0.0, radians(y)?),
        ("matrix", [a, b, c, d, e, f]) => {
            matrix([number(a)?, number(b)?, number(c)?, number(d)?, number(e)?, number(f)?])
        }
        _ => return None,
    })
}

fn radians(text: &str) -> Option<f64> {
    let (number, unit) = split(text).ok()?;
    Some(match unit.as_str() {
        "deg" => number.to_radians(),
        "grad" => (0.9 * number).to_radians(),
        "turn" => (360.0 * number).to_radians(),
        "rad" => number,
        "" if number == 0.0 => 0.0,
        _ => return None,
    })
}
