//! Parts of a file that Kerf does not draw, in words for people.

use super::look::Look;
use crate::finding::Weight;
use roxmltree::Node;
use std::collections::BTreeMap;

/// Returns the message about an element without an outline; nothing for those that nobody expects to be cut.
pub fn element(name: &str) -> Option<&'static str> {
    Some(match name {
        "text" | "flowRoot" => "<text> is left out: turn it into paths in the program that drew it",
        "image" => "<image> is left out: a picture has no outline; trace it, or cut it as a relief",
        "foreignObject" => "<foreignObject> is left out: what it holds is not SVG",
        _ => return None,
    })
}

/// Tells whether an element draws nothing by itself.
pub fn draws_nothing(name: &str) -> bool {
    matches!(
        name,
        "defs"
            | "symbol"
            | "clipPath"
            | "mask"
            | "marker"
            | "pattern"
            | "style"
            | "title"
            | "desc"
            | "metadata"
            | "script"
            | "namedview"
            | "linearGradient"
            | "radialGradient"
            | "filter"
            | "font"
            | "font-face"
            | "view"
            | "cursor"
            | "color-profile"
            | "animate"
            | "animateMotion"
            | "animateTransform"
            | "set"
            | "hatch"
            | "solidcolor"
            | "meshgradient"
    )
}

/// Lists what of the looks of an element does not come out as it looks.
pub fn looks(look: &Look, ids: &BTreeMap<&str, Node>) -> Vec<(Weight, String)> {
    let given = |name: &str| look.value(name).filter(|it| !matches!(*it, "" | "none" | "inherit"));
    let mut all = Vec::new();
    for name in ["clip-path", "mask"] {
        if given(name).is_some() {
            let text = format!("{name} is not applied: what it would hide is drawn too");
            all.push((Weight::Warning, text));
        }
    }
    if ["marker", "marker-start", "marker-mid", "marker-end"].iter().any(|it| given(it).is_some()) {
        all.push((Weight::Warning, "markers (arrow heads) are left out".into()));
    }
    if given("fill").is_some_and(|fill| is_pattern(fill, ids)) {
        all.push((Weight::Warning, "the pattern of the fill is left out".into()));
    }
    if given("stroke-dasharray")
        .is_some_and(|dashes| dashes.chars().any(|c| c.is_ascii_digit() && c != '0'))
    {
        all.push((Weight::Note, "a dashed line is drawn whole".into()));
    }
    all
}

fn is_pattern(fill: &str, ids: &BTreeMap<&str, Node>) -> bool {
    let id = fill.strip_prefix("url(").and_then(|rest| rest.split(')').next());
    let id = id.map(|id| id.trim_matches(|c| matches!(c, '"' | '\'' | '#' | ' ')));
    let found = id.and_then(|id| ids.get(id));
    found.is_some_and(|found| matches!(found.tag_name().name(), "pattern" | "hatch"))
}
