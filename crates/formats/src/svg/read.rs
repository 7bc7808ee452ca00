//! From an SVG file to a drawing.

use super::page::{inner, page};
use super::shapes::{Drawn, drawn, spot};
use crate::Imported;
use crate::finding::Findings;
use kerf_drawing::{Drawing, Shape};
use kerf_geom::{Point2, Polyarc, Transform2, Vec2, tol};
use roxmltree::{Document, Node};
use svgtypes::{TransformListParser, TransformListToken};

/// Elements within elements, at the most.
const DEEPEST: usize = 200;

/// The most shapes of a file: `use` can multiply without bound.
const MOST_SHAPES: usize = 1_000_000;

/// Reads an SVG file. A file that is no SVG gives an empty drawing and a finding that says so.
pub fn read(bytes: &[u8]) -> Imported {
    let mut findings = Findings::default();
    let text = String::from_utf8_lossy(bytes);
    let options = roxmltree::ParsingOptions { allow_dtd: true, ..Default::default() };
    let document = match Document::parse_with_options(&text, options) {
        Ok(document) => document,
        Err(error) => {
            findings.warn("xml", error.pos().row, format!("the file is no SVG: {error}"));
            return imported(Vec::new(), Vec::new(), findings);
        }
    };
    let root = document.root_element();
    if root.tag_name().name() != "svg" {
        findings.warn("xml", 1, "the file is no SVG: it does not begin with <svg>");
        return imported(Vec::new(), Vec::new(), findings);
    }
    let map = page(root, &mut findings);
    let mut reading =
        Reading { document: &document, findings, shapes: Vec::new(), layers: Vec::new() };
    reading.children(root, &Place { map, layer: None, depth: 0 });
    imported(reading.shapes, reading.layers, reading.findings)
}

fn imported(shapes: Vec<Shape>, layers: Vec<(String, Vec<usize>)>, findings: Findings) -> Imported {
    let skipped = findings.skipped();
    Imported { drawing: Drawing::of(shapes), findings: findings.finish(), layers, skipped }
}

/// Where an element is drawn.
#[derive(Clone, Copy)]
struct Place<'a> {
    map: Transform2,
    layer: Option<&'a str>,
    depth: usize,
}

struct Reading<'a> {
    document: &'a Document<'a>,
    findings: Findings,
    shapes: Vec<Shape>,
    layers: Vec<(String, Vec<usize>)>,
}

impl<'a> Reading<'a> {
    fn children(&mut self, node: Node<'a, 'a>, place: &Place<'a>) {
        for child in node.children().filter(Node::is_element) {
            self.element(child, place);
        }
    }

    fn line(&self, node: Node) -> u32 {
        self.document.text_pos_at(node.range().start).row
    }

    fn element(&mut self, node: Node<'a, 'a>, place: &Place<'a>) {
        if place.depth > DEEPEST || self.shapes.len() >= MOST_SHAPES {
            let line = self.line(node);
            self.findings.warn("deep", line, "too many elements, or one within itself: left out");
            return;
        }
        if is_hidden(node) {
            return self.findings.skip("(hidden)");
        }
        let place = self.place_of(node, place);
        match node.tag_name().name() {
            "g" | "a" | "switch" => self.children(node, &place),
            "svg" => self.children(node, &within(node, node, &place)),
            "use" => self.use_again(node, &place),
            // What these hold is drawn only where something refers to it.
            "defs" | "symbol" | "clipPath" | "mask" | "marker" | "pattern" | "style" | "title"
            | "desc" | "metadata" | "script" | "namedview" => {}
            _ => self.shape(node, &place),
        }
    }

    fn place_of(&mut self, node: Node<'a, 'a>, place: &Place<'a>) -> Place<'a> {
        let own = node.attribute("transform").map(transform);
        if let Some(Err(error)) = &own {
            let line = self.line(node);
            self.findings.warn("transform", line, format!("transform: {error}: passed over"));
        }
        let map = own.and_then(Result::ok).map_or(place.map, |own| own.then(&place.map));
        let layer = place.layer.or_else(|| layer_name(node));
        Place { map, layer, depth: place.depth + 1 }
    }

    /// `use` draws an element again, moved by x and y.
    fn use_again(&mut self, node: Node<'a, 'a>, place: &Place<'a>) {
        let xlink = ("http://www.w3.org/1999/xlink", "href");
        let name = node.attribute("href").or_else(|| node.attribute(xlink)).unwrap_or_default();
        let name = name.trim_start_matches('#');
        let found = self.document.descendants().find(|n| n.attribute("id") == Some(name));
        let Some(found) = found else {
            let line = self.line(node);
            return self.findings.warn(
                "use",
                line,
                format!("<use> of `{name}`, which is not there"),
            );
        };
        let x = super::shapes::number(node, "x").unwrap_or_default();
        let y = super::shapes::number(node, "y").unwrap_or_default();
        let map = Transform2::moved(Vec2::new(x, y)).then(&place.map);
        let place = Place { map, ..*place };
        match found.tag_name().name() {
            "symbol" => self.children(found, &within(found, node, &place)),
            _ => self.element(found, &place),
        }
    }

    fn shape(&mut self, node: Node<'a, 'a>, place: &Place<'a>) {
        if let Some(at) = spot(node) {
            return self.keep(Shape::point(place.map.apply(at)), place);
        }
        let line = self.line(node);
        match drawn(node, &place.map, tol::FIT_MM) {
            None => self.findings.skip(&format!("<{}>", node.tag_name().name())),
            Some(Err(why)) => self.findings.warn("shape", line, format!("{why}: left out")),
            Some(Ok(Drawn { paths, wrong, repeated })) => {
                paths.into_iter().for_each(|path| self.add(node, path, place));
                if let Some(why) = wrong {
                    self.findings.warn("shape", line, format!("{why}: the rest is left out"));
                }
                if repeated > 0 {
                    let name = node.tag_name().name();
                    let text = format!("<{name}>: segments without length left out: {repeated}");
                    self.findings.note("repeated", line, text);
                }
            }
        }
    }

    fn add(&mut self, node: Node, path: Polyarc, place: &Place) {
        if let Err(error) = path.check() {
            let line = self.line(node);
            return self.findings.warn("place", line, format!("{error}: left out"));
        }
        match crate::tidy::tidied(Shape::flat(path)) {
            Some(shape) => self.keep(shape, place),
            None => {
                let line = self.line(node);
                self.findings.warn("length", line, "a path without length: left out");
            }
        }
    }

    fn keep(&mut self, shape: Shape, place: &Place) {
        let (number, layer) = (self.shapes.len(), place.layer.unwrap_or("0"));
        match self.layers.iter_mut().find(|(name, _)| name == layer) {
            Some((_, shapes)) => shapes.push(number),
            None => self.layers.push((layer.to_owned(), vec![number])),
        }
        self.shapes.push(shape);
    }
}

/// The same place seen through the view of an element; `user` says how large that is.
fn within<'a>(node: Node, user: Node, place: &Place<'a>) -> Place<'a> {
    Place { map: inner(node, user).then(&place.map), ..*place }
}

fn is_hidden(node: Node) -> bool {
    let style = node.attribute("style").unwrap_or_default().replace(' ', "");
    node.attribute("display") == Some("none")
        || node.attribute("visibility") == Some("hidden")
        || style.contains("display:none")
}

/// The name of a layer of Inkscape, or of a group that has one.
fn layer_name<'a>(node: Node<'a, 'a>) -> Option<&'a str> {
    let inkscape = ("http://www.inkscape.org/namespaces/inkscape", "label");
    let is_group = node.tag_name().name() == "g";
    is_group.then(|| node.attribute(inkscape).or_else(|| node.attribute("id")))?
}

/// A list of transforms; the last one in it is done first.
fn transform(text: &str) -> Result<Transform2, svgtypes::Error> {
    let mut map = Transform2::IDENTITY;
    for token in TransformListParser::from(text) {
        map = one(token?).then(&map);
    }
    Ok(map)
}

fn one(token: TransformListToken) -> Transform2 {
    use TransformListToken as T;
    let origin = Point2::default();
    let skew = |x: f64, y: f64| Transform2 {
        x_axis: Vec2::new(1.0, y.to_radians().tan()),
        y_axis: Vec2::new(x.to_radians().tan(), 1.0),
        origin: Vec2::default(),
    };
    match token {
        T::Matrix { a, b, c, d, e, f } => {
            Transform2 { x_axis: Vec2::new(a, b), y_axis: Vec2::new(c, d), origin: Vec2::new(e, f) }
        }
        T::Translate { tx, ty } => Transform2::moved(Vec2::new(tx, ty)),
        T::Scale { sx, sy } => Transform2::scaled(origin, sx, sy),
        T::Rotate { angle } => Transform2::turned(origin, angle.to_radians()),
        T::SkewX { angle } => skew(angle, 0.0),
        T::SkewY { angle } => skew(0.0, angle),
    }
}
