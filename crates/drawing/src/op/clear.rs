//! Areas cleared: engraving and pockets (Profiler reference, "Engraving").
//!
//! Each outer shape with the holes directly in it is a region; what lies in a hole is a region of its own.
//! The paths that clear them are new shapes in a group without an offset, the shapes themselves stay.

use super::words::{WordError, Words, number};
use super::{OpError, Operation};
use crate::{Drawing, Editor, Group, GroupSettings, Kind, Lead, Nesting, Shape};
use kerf_geom::{GeomError, Polyarc};
use kerf_pocket::{Cutter, PocketError, Way};
use serde::{Deserialize, Serialize};
use std::fmt::{Display, Formatter};
use std::sync::Arc;

/// Which areas are cleared, with which tool, and where the paths go.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Clearing {
    /// Those of all shapes, not only of the selected ones.
    #[serde(default)]
    pub all: bool,
    /// Diameter of the tool, millimetres.
    pub tool_mm: f64,
    /// How much neighbouring paths overlap, millimetres.
    pub overlap_mm: f64,
    /// The group of the paths; `None` is the first one that has no shapes.
    #[serde(default)]
    pub group: Option<Group>,
}

/// The words of engraving after its name.
pub(super) fn read_engrave(w: &mut Words) -> Result<Operation, WordError> {
    let mut clearing = Clearing { all: w.takes("all"), ..Clearing::default() };
    while w.peek().is_some() {
        w.read("a setting", CLEARING, |word| clearing_word(word, &mut clearing))?;
    }
    complete(&clearing)?;
    Ok(Operation::Engrave(clearing))
}

const CLEARING: &str = "tool=, overlap= or group= with its value, such as tool=5";

fn clearing_word(word: &str, clearing: &mut Clearing) -> Option<()> {
    let (key, value) = word.split_once('=')?;
    match key.to_ascii_lowercase().as_str() {
        "tool" => clearing.tool_mm = number(value)?,
        "overlap" => clearing.overlap_mm = number(value)?,
        "group" => clearing.group = Some(Group::named(value)?),
        _ => return None,
    }
    Some(())
}

fn complete(clearing: &Clearing) -> Result<(), WordError> {
    if clearing.tool_mm == 0.0 {
        Err(WordError::Missing("the diameter of the tool"))
    } else {
        Ok(())
    }
}

impl Display for Clearing {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        let all = if self.all { "all " } else { "" };
        write!(f, "{all}tool={} overlap={}", self.tool_mm, self.overlap_mm)?;
        self.group.map_or(Ok(()), |group| write!(f, " group={group}"))
    }
}

/// Rings from the wall to the middle, with the directions of the shapes reversed (Profiler notes, 32 to
/// 34).
pub(super) fn engrave(draft: &mut Editor, clearing: &Clearing) -> Result<Vec<String>, OpError> {
    clear(draft, clearing, |region, cutter| kerf_pocket::rings(region, cutter, Way::default()))
}

type Paths = Result<Vec<Polyarc>, PocketError>;

fn clear(
    draft: &mut Editor,
    clearing: &Clearing,
    paths: impl Fn(&[Polyarc], &Cutter) -> Paths,
) -> Result<Vec<String>, OpError> {
    let cutter = Cutter::new(clearing.tool_mm, clearing.overlap_mm).map_err(OpError::Clearing)?;
    let chosen = if clearing.all { every(draft)? } else { draft.selected()? };
    let group = prepared_group(&mut draft.drawing, clearing.group)?;
    let (regions, mut warnings) = regions(&draft.drawing, &chosen)?;
    let first = draft.drawing.shapes.len();
    for region in regions {
        let found = paths(&region.contours, &cutter).map_err(|error| region.told(error))?;
        if found.is_empty() {
            let (number, tool) = (region.shapes[0] + 1, clearing.tool_mm);
            warnings.push(format!("shape {number}: a tool of {tool} mm does not fit into it"));
        }
        let shapes = found.into_iter().map(|path| Shape::flat(path).in_group(group));
        shapes.for_each(|shape| draft.drawing.add(shape));
    }
    draft.selection = (first..draft.drawing.shapes.len()).collect();
    Ok(warnings)
}

fn every(draft: &Editor) -> Result<Vec<usize>, OpError> {
    let count = draft.drawing.shapes.len();
    if count == 0 { Err(OpError::NothingSelected) } else { Ok((0..count).collect()) }
}

/// A group in which paths are cut as they are.
fn prepared_group(drawing: &mut Drawing, wanted: Option<Group>) -> Result<Group, OpError> {
    let used = |group: &Group| drawing.shapes.iter().any(|shape| shape.group == *group);
    let free = || Group::ALL.into_iter().find(|group| !used(group));
    let group = wanted.or_else(free).ok_or(OpError::NoFreeGroup)?;
    let plain = as_drawn(drawing.settings(group));
    if used(&group) && plain != *drawing.settings(group) {
        return Err(OpError::NotAsDrawn { group });
    }
    *drawing.settings_mut(group) = plain;
    Ok(group)
}

/// The same settings, but the path is the shape.
fn as_drawn(settings: &GroupSettings) -> GroupSettings {
    GroupSettings {
        offset_mm: 0.0,
        rough_mm: 0.0,
        double_line: false,
        tag_mm: 0.0,
        lead_in: Lead::default(),
        lead_out: Lead::default(),
        ..*settings
    }
}

/// An outer shape with its holes.
struct Region {
    contours: Vec<Polyarc>,
    /// The shapes they are, as places in the drawing.
    shapes: Vec<usize>,
}

impl Region {
    /// An error with the number of its shape.
    fn told(&self, error: PocketError) -> OpError {
        let contour = match error {
            PocketError::Geometry(GeomError::Crosses { second, .. }) => second,
            PocketError::Open { contour } => contour,
            _ => 0,
        };
        let shape = self.shapes.get(contour).map_or(0, |place| place + 1);
        OpError::Shape { shape, why: error.to_string() }
    }
}

/// The regions of the chosen shapes, and what cannot bound one.
fn regions(drawing: &Drawing, chosen: &[usize]) -> Result<(Vec<Region>, Vec<String>), OpError> {
    let (closed, others): (Vec<usize>, Vec<usize>) =
        chosen.iter().partition(|place| bounds_an_area(&drawing.shapes[**place]));
    let warnings = others.iter().map(|place| {
        format!("shape {}: only closed flat shapes bound an area; it is left out", place + 1)
    });
    let shapes: Vec<Arc<Shape>> =
        closed.iter().map(|place| drawing.shapes[*place].clone()).collect();
    let nesting = Nesting::of(&shapes);
    if let Some((a, b)) = nesting.across().first() {
        let why = format!("it crosses shape {}: no area is told from the other", closed[*b] + 1);
        return Err(OpError::Shape { shape: closed[*a] + 1, why });
    }
    let is_outer = |n: &usize| nesting.depth(*n).is_multiple_of(2);
    for (n, place) in closed.iter().enumerate() {
        directed(*place + 1, &shapes[n], is_outer(&n))?;
    }
    let region = |outer: usize| {
        let members: Vec<usize> =
            std::iter::once(outer).chain(nesting.children(Some(outer))).collect();
        let contours = members.iter().map(|n| shapes[*n].path.clone()).collect();
        Region { contours, shapes: members.iter().map(|n| closed[*n]).collect() }
    };
    Ok(((0..shapes.len()).filter(is_outer).map(region).collect(), warnings.collect()))
}

fn bounds_an_area(shape: &Shape) -> bool {
    shape.is_closed() && shape.z_mm.is_none() && shape.kind() == Kind::Polyarc
}

fn directed(number: usize, shape: &Shape, outer: bool) -> Result<(), OpError> {
    let counter_clockwise = shape.path.signed_area() > 0.0;
    if counter_clockwise == outer {
        return Ok(());
    }
    let (what, wanted) =
        if outer { ("an outer shape", "counter-clockwise") } else { ("a hole", "clockwise") };
    let why = format!("directions not set: {what} must run {wanted}; use `directions auto` first");
    Err(OpError::Shape { shape: number, why })
}
