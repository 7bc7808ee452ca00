//! Entities that drawing programs do not show: those on layers that are off or frozen, and those that are invisible.
//!
//! Nobody wants cut what is not seen. It is left out, counted by layer and told.

use super::file::{Entity, entities};
use super::tag::Tag;
use crate::finding::Findings;
use std::collections::BTreeMap;

/// Entities that would be drawn.
const DRAWN: [&[u8]; 9] = [
    b"LINE",
    b"POINT",
    b"CIRCLE",
    b"ARC",
    b"ELLIPSE",
    b"POLYLINE",
    b"LWPOLYLINE",
    b"SPLINE",
    b"INSERT",
];

/// Bit of group code 70 of a layer.
const FROZEN: i64 = 1;

/// Reason why a layer is not seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Switched {
    /// Its colour is negative. What a block that is placed on it has on other layers is seen.
    Off,
    /// Everything on it is gone, blocks placed on it as wholes.
    Frozen,
}

/// The layers of a file that are not seen, by name in capitals.
pub type Layers = BTreeMap<Vec<u8>, Switched>;

/// The layers of a row of pairs that are not seen.
pub fn layers(tables: &[Tag]) -> Layers {
    let named = |layer: &Entity| layer.tag(2).map(|tag| tag.name().to_ascii_uppercase());
    let all = entities(tables).filter(|entity| entity.name == b"LAYER");
    all.filter_map(|layer| Some((named(&layer)?, switched(&layer)?))).collect()
}

fn switched(layer: &Entity) -> Option<Switched> {
    let whole = |code| layer.tag(code).and_then(Tag::whole);
    if whole(70).is_some_and(|flags| flags & FROZEN != 0) {
        return Some(Switched::Frozen);
    }
    whole(62).is_some_and(|colour| colour < 0).then_some(Switched::Off)
}

/// Entities that were left out because nobody sees them.
#[derive(Clone, Debug, Default)]
pub struct Unseen<'a> {
    /// By layer, or without one for entities that are invisible themselves: where the first is, and how many.
    left_out: BTreeMap<Option<&'a [u8]>, (u32, usize)>,
}

impl<'a> Unseen<'a> {
    /// Tells whether an entity on a layer is not seen; then it is counted.
    pub fn hides(&mut self, entity: &Entity<'_, 'a>, layer: &'a [u8], layers: &Layers) -> bool {
        if !DRAWN.contains(&entity.name) {
            return false;
        }
        let invisible = entity.tag(60).and_then(Tag::whole) == Some(1);
        let switched = layers.get(&layer.to_ascii_uppercase());
        let hidden = match switched {
            Some(Switched::Frozen) => true,
            Some(Switched::Off) => entity.name != b"INSERT",
            None => false,
        };
        if invisible || hidden {
            let of = Some(layer).filter(|_| hidden);
            let (_, count) = self.left_out.entry(of).or_insert((entity.line, 0));
            *count += 1;
        }
        invisible || hidden
    }

    /// Tells what was left out.
    pub fn tell(&self, layers: &Layers, findings: &mut Findings) {
        for (layer, (line, count)) in &self.left_out {
            let entities = if *count == 1 { "entity" } else { "entities" };
            let text = match layer {
                None => format!("{count} {entities} left out: marked as invisible (group code 60)"),
                Some(layer) => {
                    let how = match layers.get(&layer.to_ascii_uppercase()) {
                        Some(Switched::Frozen) => "frozen",
                        _ => "off",
                    };
                    let name = super::tag::decoded(layer);
                    format!("{count} {entities} left out: layer `{name}` is {how} in the drawing")
                }
            };
            findings.warn("unseen", *line, text);
        }
    }
}
