//! Looks of an element: its properties by style sheets, by itself, and from what it stands in.

use super::length::{Along, Measure};
use super::sheet::{Declaration, Sheet};
use kerf_geom::Vec2;
use roxmltree::Node;

/// An element with what is declared of it.
#[derive(Clone, Debug)]
pub struct Look<'a> {
    pub node: Node<'a, 'a>,
    /// The weakest first.
    declared: Vec<Declaration<'a>>,
}

impl<'a> Look<'a> {
    pub fn of(node: Node<'a, 'a>, sheet: &Sheet<'a>) -> Self {
        Self { node, declared: sheet.declared(node) }
    }

    /// Returns what a style says of a property.
    pub fn styled(&self, name: &str) -> Option<&'a str> {
        let named = self.declared.iter().rev().find(|it| it.name.eq_ignore_ascii_case(name));
        named.map(|declaration| declaration.value)
    }

    /// A property: as a style says, else as an attribute says.
    pub fn value(&self, name: &str) -> Option<&'a str> {
        self.styled(name).or_else(|| self.node.attribute(name)).map(str::trim)
    }

    /// A length of the element in units of the file; nothing where it has none or leaves it open.
    pub fn length(&self, name: &str, measure: &Measure) -> Result<Option<f64>, String> {
        let Some(text) = self.value(name).filter(|text| *text != "auto") else { return Ok(None) };
        let tag = self.node.tag_name().name();
        let told = |why| format!("<{tag}> {name}: {why}");
        measure.units(text, Along::of(name)).map(Some).map_err(told)
    }

    /// Returns the reason why nothing within the element is seen, where that is so.
    pub fn hidden(&self) -> Option<&'static str> {
        if self.value("display") == Some("none") {
            return Some("display: none");
        }
        let clear = |text: &str| text.trim_end_matches('%').parse().is_ok_and(|it: f64| it <= 0.0);
        self.value("opacity").is_some_and(clear).then_some("opacity: 0")
    }
}

/// Properties that elements have from those they stand in.
#[derive(Clone, Copy, Debug)]
pub struct Inherited {
    /// Not `visibility: hidden`.
    pub visible: bool,
    /// `fill` is not `none`.
    pub filled: bool,
    /// `stroke` is a colour.
    pub stroked: bool,
    pub measure: Measure,
}

impl Default for Inherited {
    fn default() -> Self {
        Self { visible: true, filled: true, stroked: false, measure: Measure::default() }
    }
}

impl Inherited {
    /// Returns the properties that an element hands on.
    #[must_use]
    pub fn with(&self, look: &Look) -> Self {
        let set = |name| look.value(name).filter(|text| *text != "inherit");
        let paints =
            |name, before| set(name).map_or(before, |it| !matches!(it, "none" | "transparent"));
        let visible = set("visibility").map_or(self.visible, |it| it == "visible");
        let letter = font_size(look, &self.measure).unwrap_or(self.measure.letter);
        let measure = Measure { letter, ..self.measure };
        let (filled, stroked) = (paints("fill", self.filled), paints("stroke", self.stroked));
        Self { visible, filled, stroked, measure }
    }

    /// The same within another viewport.
    #[must_use]
    pub fn within(&self, room: Option<Vec2>) -> Self {
        Self { measure: Measure { room, ..self.measure }, ..*self }
    }
}

/// The size of letters that an element sets, by itself or within `font`.
fn font_size(look: &Look, around: &Measure) -> Option<f64> {
    if let Some(size) = look.value("font-size") {
        return around.letters(size);
    }
    let words = look.styled("font")?.split_whitespace();
    let mut sizes = words.map(|word| word.split('/').next().unwrap_or_default());
    // Numbers without a unit are weights.
    sizes
        .find(|word| word.parse::<f64>().is_err() && around.letters(word).is_some())
        .and_then(|it| around.letters(it))
}
