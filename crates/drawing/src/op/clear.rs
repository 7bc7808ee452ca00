//! Areas cleared: engraving and pockets (Profiler reference, "Engraving").
//!
//! Each outer shape with the holes directly in it is a region; what lies in a hole is a region of its own.
//! The paths that clear them are new shapes in a group without an offset, the shapes themselves stay.

use super::region::regions;
use super::words::{WordError, Words, number};
use super::{OpError, Operation};
use crate::{Drawing, Editor, Group, GroupSettings, Lead, Shape};
use kerf_geom::{GeomError, Offsetter, Polyarc};
use kerf_pocket::{Cleared, Cutter, PocketError, Way, Zigzag};
use serde::{Deserialize, Serialize};
use std::fmt::{Display, Formatter};

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

/// How the paths of a pocket run.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "pattern", rename_all = "lowercase")]
pub enum Pattern {
    /// Ring by ring.
    Rings(Way),
    /// Line by line.
    Zigzag(Zigzag),
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

/// The words of a pocket after its name.
pub(super) fn read_pocket(w: &mut Words) -> Result<Operation, WordError> {
    let mut clearing = Clearing { all: w.takes("all"), ..Clearing::default() };
    let mut pocket = PocketWords::default();
    while w.peek().is_some() {
        if w.takes("climb") {
            pocket.climb = true;
        } else if w.takes("outward") {
            pocket.outward = true;
        } else {
            w.read("a setting", POCKET, |word| {
                pocket.word(word).or_else(|| clearing_word(word, &mut clearing))
            })?;
        }
    }
    complete(&clearing)?;
    Ok(Operation::Pocket { clearing, pattern: pocket.pattern()? })
}

/// What is said of a pocket's pattern.
#[derive(Default)]
struct PocketWords {
    climb: bool,
    outward: bool,
    angle_deg: Option<f64>,
    finish_mm: Option<f64>,
}

impl PocketWords {
    fn word(&mut self, word: &str) -> Option<()> {
        let (key, value) = word.split_once('=')?;
        let place = match key.to_ascii_lowercase().as_str() {
            "zigzag" => &mut self.angle_deg,
            "finish" => &mut self.finish_mm,
            _ => return None,
        };
        *place = Some(number(value)?);
        Some(())
    }

    fn pattern(self) -> Result<Pattern, WordError> {
        let Self { climb, outward, angle_deg, finish_mm } = self;
        match angle_deg {
            Some(_) if outward => Err(WordError::TooMany("outward".into())),
            Some(angle_deg) => {
                let finish_mm = finish_mm.unwrap_or_default();
                Ok(Pattern::Zigzag(Zigzag { angle_deg, finish_mm, climb }))
            }
            None if finish_mm.is_some() => {
                Err(WordError::Missing("zigzag=ANGLE, which finish= needs,"))
            }
            None => Ok(Pattern::Rings(Way { climb, outward })),
        }
    }
}

const CLEARING: &str = "tool=, overlap= or group= with its value, such as tool=5";
const POCKET: &str =
    "climb, outward, or tool=, overlap=, zigzag=, finish= or group= with its value, such as tool=5";

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

impl Display for Pattern {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        let (climb, outward) = match self {
            Self::Rings(way) => (way.climb, way.outward),
            Self::Zigzag(lines) => (lines.climb, false),
        };
        f.write_str(if climb { " climb" } else { "" })?;
        f.write_str(if outward { " outward" } else { "" })?;
        if let Self::Zigzag(lines) = self {
            write!(f, " zigzag={} finish={}", lines.angle_deg, lines.finish_mm)?;
        }
        Ok(())
    }
}

/// Rings or lines, whichever way the pattern says.
pub(super) fn pocket(
    draft: &mut Editor,
    clearing: &Clearing,
    pattern: &Pattern,
) -> Result<Vec<String>, OpError> {
    clear(draft, clearing, |region, cutter, offsetter| match pattern {
        Pattern::Rings(way) => kerf_pocket::rings(region, cutter, *way, offsetter),
        Pattern::Zigzag(lines) => kerf_pocket::zigzag(region, cutter, lines, offsetter),
    })
}

/// Rings from the wall to the middle, with the directions of the shapes reversed (Profiler notes, 32 to
/// 34).
pub(super) fn engrave(draft: &mut Editor, clearing: &Clearing) -> Result<Vec<String>, OpError> {
    clear(draft, clearing, |region, cutter, offsetter| {
        kerf_pocket::rings(region, cutter, Way::default(), offsetter)
    })
}

type Found = Result<Cleared, PocketError>;

fn clear(
    draft: &mut Editor,
    clearing: &Clearing,
    paths: impl Fn(&[Polyarc], &Cutter, &Offsetter) -> Found,
) -> Result<Vec<String>, OpError> {
    let cutter = Cutter::new(clearing.tool_mm, clearing.overlap_mm).map_err(OpError::Clearing)?;
    let chosen = if clearing.all { every(draft)? } else { draft.selected()? };
    let (group, other_cutter) = prepared_group(&mut draft.drawing, clearing)?;
    let (regions, mut warnings) = regions(&draft.drawing, &chosen)?;
    warnings.extend(other_cutter);
    let first = draft.drawing.shapes.len();
    let offsetter = Offsetter::default();
    for region in regions {
        let found = match paths(&region.contours, &cutter, &offsetter) {
            // Contours may touch each other; then their outline is one contour.
            Err(PocketError::Geometry(GeomError::Crosses { .. })) => {
                paths(&region.untangled()?.contours, &cutter, &offsetter)
            }
            found => found,
        };
        let found = found.map_err(|error| region.told(error))?;
        let number = region.shapes[0] + 1;
        warnings.extend(found.coarse.map(|coarse| format!("shape {number}: {coarse}")));
        if found.paths.is_empty() {
            let tool = clearing.tool_mm;
            warnings.push(format!("shape {number}: a tool of {tool} mm does not fit into it"));
        }
        let shapes = found.paths.into_iter().map(|path| Shape::flat(path).in_group(group));
        shapes.for_each(|shape| draft.drawing.add(shape));
    }
    draft.selection = (first..draft.drawing.shapes.len()).collect();
    Ok(warnings)
}

fn every(draft: &Editor) -> Result<Vec<usize>, OpError> {
    let count = draft.drawing.shapes.len();
    if count == 0 { Err(OpError::NothingSelected) } else { Ok((0..count).collect()) }
}

/// A group in which paths are cut as they are, by the cutter that clears; what is to be told when its
/// shapes had another one.
fn prepared_group(
    drawing: &mut Drawing,
    clearing: &Clearing,
) -> Result<(Group, Option<String>), OpError> {
    let used = |group: &Group| drawing.shapes.iter().any(|shape| shape.group == *group);
    let free = || Group::ALL.into_iter().find(|group| !used(group));
    let group = clearing.group.or_else(free).ok_or(OpError::NoFreeGroup)?;
    let plain = as_drawn(drawing.settings(group));
    if used(&group) && plain != *drawing.settings(group) {
        return Err(OpError::NotAsDrawn { group });
    }
    let tool = clearing.tool_mm;
    let other = plain.cutter_mm.filter(|before| used(&group) && *before != tool);
    *drawing.settings_mut(group) = GroupSettings { cutter_mm: Some(tool), ..plain };
    let told =
        |before| format!("group {group} was cut by a cutter of {before} mm, now of {tool} mm");
    Ok((group, other.map(told)))
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
