//! From an SVG file to a drawing.

use super::length::Measure;
use super::look::{Inherited, Look};
use super::page::{inner, page};
use super::shapes::{Drawn, drawn, spot};
use super::sheet::Sheet;
use super::text::text_of;
use super::transform::transform;
use super::unread;
use crate::Imported;
use crate::effort::{Effort, Ended};
use crate::finding::{Findings, Weight};
use crate::layers::Layers;
use crate::places::Places;
use kerf_drawing::{Drawing, Shape};
use kerf_geom::{Polyarc, Transform2, Vec2, tol};
use roxmltree::{Document, Node};
use std::collections::BTreeMap;

/// Elements within elements, at the most.
const DEEPEST: usize = 200;

/// Reads an SVG file. A file that is no SVG gives an empty drawing and a finding that says so.
pub fn read(bytes: &[u8]) -> Imported {
    read_until(bytes, &|| false)
}

/// The same, until it is given up: then nothing is read.
pub fn read_until(bytes: &[u8], given_up: &dyn Fn() -> bool) -> Imported {
    let mut findings = Findings::default();
    let text = match text_of(bytes) {
        Ok(text) => text,
        Err(why) => {
            findings.warn("xml", 1, why);
            return imported(Vec::new(), Layers::default(), findings, None);
        }
    };
    let options = roxmltree::ParsingOptions { allow_dtd: true, ..Default::default() };
    let document = match Document::parse_with_options(&text, options) {
        Ok(document) => document,
        Err(error) => {
            findings.warn("xml", error.pos().row, format!("the file is no SVG: {error}"));
            return imported(Vec::new(), Layers::default(), findings, None);
        }
    };
    if document.root_element().tag_name().name() != "svg" {
        findings.warn("xml", 1, "the file is no SVG: it does not begin with <svg>");
        return imported(Vec::new(), Layers::default(), findings, None);
    }
    let mut reading = Reading::of(&document, findings, given_up);
    reading.whole();
    let Reading { shapes, layers, findings, effort, .. } = reading;
    match effort.ended() {
        None => imported(shapes, layers, findings, None),
        ended => imported(Vec::new(), Layers::default(), findings, ended),
    }
}

fn imported(
    shapes: Vec<Shape>,
    layers: Layers,
    findings: Findings,
    ended: Option<Ended>,
) -> Imported {
    let (skipped, layers) = (findings.skipped(), layers.list);
    Imported { drawing: Drawing::of(shapes), findings: findings.finish(), layers, skipped, ended }
}

/// Place and circumstances in which an element is drawn.
#[derive(Clone, Copy)]
struct ElementContext<'a> {
    map: Transform2,
    layer: Option<&'a str>,
    depth: usize,
    inherited: Inherited,
    /// The outermost `use` by way of which it is drawn.
    user: Option<Node<'a, 'a>>,
}

struct Reading<'a, 'g> {
    document: &'a Document<'a>,
    places: Places<'a>,
    ids: BTreeMap<&'a str, Node<'a, 'a>>,
    sheet: Sheet<'a>,
    findings: Findings,
    shapes: Vec<Shape>,
    layers: Layers,
    effort: Effort<'g>,
}

impl<'a, 'g> Reading<'a, 'g> {
    fn of(document: &'a Document<'a>, findings: Findings, given_up: &'g dyn Fn() -> bool) -> Self {
        let mut ids = BTreeMap::new();
        for node in document.descendants() {
            if let Some(id) = node.attribute("id") {
                ids.entry(id).or_insert(node);
            }
        }
        let places = Places::of(document.input_text());
        let (sheet, wrong) = Sheet::of(document);
        let (shapes, layers) = (Vec::new(), Layers::default());
        let elements = document.descendants().filter(Node::is_element).count();
        let effort = Effort::of(elements, document.input_text().len(), given_up);
        let mut reading = Self { document, places, ids, sheet, findings, shapes, layers, effort };
        wrong.into_iter().for_each(|(at, text)| reading.tell(Weight::Warning, "style", at, text));
        reading
    }

    /// The page and everything on it.
    fn whole(&mut self) {
        let root = self.document.root_element();
        let look = Look::of(root, &self.sheet);
        let inherited = Inherited::default().with(&look);
        if self.is_hidden(&look) {
            return;
        }
        if look.value("transform").is_some_and(|text| text != "none") {
            self.warn("transform", root, "the transform of the page is passed over".into());
        }
        self.tell_looks(&look);
        let letter = inherited.measure.letter;
        let page = page(&look, &Measure { page_letter: letter, ..inherited.measure });
        if page.is_unsized {
            self.findings.note("size", 1, "no width in mm or inches: 96 units to the inch");
        }
        let measure = Measure { room: page.room, page: page.sheet, letter, page_letter: letter };
        let inherited = Inherited { measure, ..inherited };
        self.children(
            root,
            &ElementContext { map: page.map, layer: None, depth: 0, inherited, user: None },
        );
    }

    fn tell(&mut self, weight: Weight, kind: &'static str, at: usize, text: String) {
        if self.findings.wants(kind) {
            self.findings.add_at(kind, self.places.of_byte(at), weight, text);
        } else {
            self.findings.add_at(kind, (0, 0), weight, text);
        }
    }

    fn warn(&mut self, kind: &'static str, node: Node, text: String) {
        self.tell(Weight::Warning, kind, node.range().start, text);
    }

    fn children(&mut self, node: Node<'a, 'a>, place: &ElementContext<'a>) {
        for child in node.children().filter(Node::is_element) {
            self.element(child, place);
        }
    }

    fn element(&mut self, node: Node<'a, 'a>, place: &ElementContext<'a>) {
        if !self.goes_on(place) {
            return;
        }
        if place.depth > DEEPEST {
            let text = format!(
                "elements within elements, more than {DEEPEST}, or one within itself: left out"
            );
            return self.warn("deep", node, text);
        }
        let name = node.tag_name().name();
        let is_foreign =
            node.tag_name().namespace() != self.document.root_element().tag_name().namespace();
        if is_foreign || unread::draws_nothing(name) {
            return;
        }
        let look = Look::of(node, &self.sheet);
        if self.is_hidden(&look) {
            return;
        }
        self.tell_looks(&look);
        let Some(place) = self.place_of(&look, place) else { return };
        match name {
            "g" | "a" => self.children(node, &place),
            "switch" => self.switch(node, &place),
            "svg" => self.view(&look, &look, &place),
            "use" => self.use_again(&look, &place),
            _ => self.shape(&look, &place),
        }
    }

    /// Counts an element; nothing more is drawn when this is false.
    fn goes_on(&mut self, place: &ElementContext<'a>) -> bool {
        let goes_on = self.effort.goes_on(place.user.is_some());
        self.tell_too_much(place);
        goes_on
    }

    /// Tells of the `use` that draws too much, if that is so.
    fn tell_too_much(&mut self, place: &ElementContext<'a>) {
        let Some(user) = place.user.filter(|_| self.effort.ended().is_some()) else { return };
        let what = format!("<use> of `{}`", used_name(user));
        let at = self.places.of_byte(user.range().start);
        let mend = "use it fewer times, or draw the shapes without <use>";
        self.effort.tell(&what, at, mend, &mut self.findings);
    }

    /// Tells whether nothing of an element is seen, and if so warns of it.
    fn is_hidden(&mut self, look: &Look) -> bool {
        let Some(why) = look.hidden() else { return false };
        self.tell_hidden(look.node, why);
        true
    }

    fn tell_hidden(&mut self, node: Node, why: &str) {
        self.findings.skip("(hidden)");
        let layer = layer_name(node).map_or(String::new(), |layer| format!(" `{layer}`"));
        let name = node.tag_name().name();
        self.warn("hidden", node, format!("<{name}>{layer} is hidden ({why}): left out"));
    }

    fn tell_looks(&mut self, look: &Look) {
        for (weight, text) in unread::looks(look, &self.ids) {
            self.tell(weight, "looks", look.node.range().start, text);
        }
    }

    /// Returns the place in which an element is drawn; nothing where that cannot be told.
    fn place_of(
        &mut self,
        look: &Look<'a>,
        place: &ElementContext<'a>,
    ) -> Option<ElementContext<'a>> {
        let inherited = place.inherited.with(look);
        match transform(look, &inherited.measure) {
            Err(why) => {
                let name = look.node.tag_name().name();
                self.warn("transform", look.node, format!("{why}: <{name}> is left out"));
                None
            }
            Ok(own) => {
                let layer = place.layer.or_else(|| layer_name(look.node));
                let map = own.then(&place.map);
                Some(ElementContext {
                    map,
                    layer,
                    depth: place.depth + 1,
                    inherited,
                    user: place.user,
                })
            }
        }
    }

    /// The first of several ways to draw the same that a reader of English without extensions can take.
    fn switch(&mut self, node: Node<'a, 'a>, place: &ElementContext<'a>) {
        let ways: Vec<_> = node.children().filter(Node::is_element).collect();
        let Some(chosen) = ways.iter().position(|way| is_for_us(*way)) else {
            let text = "<switch>: nothing in it is for readers like this one: left out";
            return self.warn("switch", node, text.into());
        };
        let drawn = |way: &&Node| {
            way.tag_name().name() != "foreignObject"
                && !unread::draws_nothing(way.tag_name().name())
        };
        let others = ways.iter().filter(drawn).count().saturating_sub(1);
        if others > 0 {
            let (line, _) = self.places.of_byte(ways[chosen].range().start);
            let text =
                format!("<switch>: drawn is what line {line} has; other ways left out: {others}");
            self.tell(Weight::Note, "switch", node.range().start, text);
        }
        self.element(ways[chosen], place);
    }

    /// Draws what stands in a symbol or in an SVG within an SVG; `user` says where and how large that is.
    fn view(&mut self, look: &Look<'a>, user: &Look<'a>, place: &ElementContext<'a>) {
        match inner(look, user, &place.inherited.measure) {
            Err(why) => self.warn("shape", user.node, format!("{why}: left out")),
            Ok((map, room)) => {
                let inherited = place.inherited.within(room);
                let place = ElementContext { map: map.then(&place.map), inherited, ..*place };
                self.children(look.node, &place);
            }
        }
    }

    /// `use` draws an element again, moved by x and y.
    fn use_again(&mut self, look: &Look<'a>, place: &ElementContext<'a>) {
        let (node, name) = (look.node, used_name(look.node));
        let Some(found) = self.ids.get(name).copied() else {
            return self.warn("use", node, format!("<use> of `{name}`, which is not there"));
        };
        let measure = &place.inherited.measure;
        let (x, y) = match (look.length("x", measure), look.length("y", measure)) {
            (Ok(x), Ok(y)) => (x.unwrap_or_default(), y.unwrap_or_default()),
            (Err(why), _) | (_, Err(why)) => {
                return self.warn("shape", node, format!("{why}: left out"));
            }
        };
        let map = Transform2::moved(Vec2::new(x, y)).then(&place.map);
        let user = place.user.or(Some(node));
        self.used(found, look, &ElementContext { map, user, ..*place });
    }

    fn used(&mut self, found: Node<'a, 'a>, user: &Look<'a>, place: &ElementContext<'a>) {
        let is_view = matches!(found.tag_name().name(), "symbol" | "svg");
        if !is_view || place.depth > DEEPEST {
            return self.element(found, place);
        }
        let look = Look::of(found, &self.sheet);
        if self.is_hidden(&look) {
            return;
        }
        if let Some(place) = self.place_of(&look, place) {
            self.view(&look, user, &place);
        }
    }

    fn shape(&mut self, look: &Look<'a>, place: &ElementContext<'a>) {
        let (node, name) = (look.node, look.node.tag_name().name());
        let measure = &place.inherited.measure;
        let found = match spot(look, measure) {
            Some(at) => at.map(|at| Some(Err(place.map.apply(at)))),
            None => drawn(look, measure, &place.map, tol::FIT_MM).map(|it| it.map(Ok)),
        };
        match found {
            Ok(None) => self.left_out(node),
            Err(why) => self.warn("shape", node, format!("{why}: left out")),
            Ok(Some(_)) if !place.inherited.visible => self.tell_hidden(node, "visibility: hidden"),
            Ok(Some(Err(at))) => self.keep(Shape::point(at), place),
            Ok(Some(Ok(Drawn { paths, wrong, repeated }))) => {
                self.tell_unpainted(node, place);
                paths.into_iter().for_each(|path| self.add(node, path, place));
                if let Some(why) = wrong {
                    self.warn("shape", node, format!("{why}: the rest is left out"));
                }
                if repeated > 0 {
                    let text = format!("<{name}>: segments without length left out: {repeated}");
                    self.tell(Weight::Note, "repeated", node.range().start, text);
                }
            }
        }
    }

    /// Tells of an element that has no outline.
    fn left_out(&mut self, node: Node) {
        let name = node.tag_name().name();
        self.findings.skip(&format!("<{name}>"));
        if let Some(text) = unread::element(name) {
            self.warn("element", node, text.into());
        }
    }

    /// Tells of a shape that no viewer shows and that is cut all the same: drawings for machines are often so.
    fn tell_unpainted(&mut self, node: Node, place: &ElementContext) {
        if !place.inherited.filled && !place.inherited.stroked {
            let name = node.tag_name().name();
            let text = format!(
                "<{name}> has neither fill nor stroke and cannot be seen: drawn all the same"
            );
            self.tell(Weight::Note, "unpainted", node.range().start, text);
        }
    }

    fn add(&mut self, node: Node, path: Polyarc, place: &ElementContext<'a>) {
        if let Err(error) = path.check() {
            return self.warn("place", node, format!("{error}: left out"));
        }
        match crate::tidy::tidied(Shape::flat(path)) {
            Some(shape) => self.keep(shape, place),
            None => self.warn("length", node, "a path without length: left out".into()),
        }
    }

    fn keep(&mut self, shape: Shape, place: &ElementContext<'a>) {
        let layer = place.layer.unwrap_or("0");
        self.layers.add(layer.as_bytes(), self.shapes.len(), || layer.to_owned());
        if place.user.is_some() {
            self.effort.drew(shape.path.vertices.len());
            self.tell_too_much(place);
        }
        self.shapes.push(shape);
    }
}

/// The id of what a `use` draws.
fn used_name<'a>(user: Node<'a, 'a>) -> &'a str {
    let xlink = ("http://www.w3.org/1999/xlink", "href");
    let name = user.attribute("href").or_else(|| user.attribute(xlink)).unwrap_or_default();
    name.trim().trim_start_matches('#')
}

/// Tells whether a way of a `<switch>` asks for nothing that Kerf has not.
fn is_for_us(way: Node) -> bool {
    let english = |names: &str| {
        names.split(',').any(|name| name.trim().to_ascii_lowercase().starts_with("en"))
    };
    way.attribute("requiredExtensions").is_none()
        && way.attribute("systemLanguage").is_none_or(english)
}

/// The name of a layer of Inkscape, or of a group that has one.
fn layer_name<'a>(node: Node<'a, 'a>) -> Option<&'a str> {
    let inkscape = ("http://www.inkscape.org/namespaces/inkscape", "label");
    let is_group = node.tag_name().name() == "g";
    is_group.then(|| node.attribute(inkscape).or_else(|| node.attribute("id")))?
}
