//! Areas cleared: engraving and pockets (Profiler reference, "Engraving").
//!
//! Each outer shape with the holes directly in it is a region; what lies in a hole is a region of its own.
//! The paths that clear them are new shapes in a group without an offset. The shapes themselves stay, in a group
//! that is off: cut as well, they would take the ground out of what was engraved.

use super::clear_group::{outlines_put_away, prepared_group};
use super::region::regions;
use super::words::{WordError, Words, number};
use super::{OpError, Outcome};
use crate::{CutDepth, Editor, Group, Shape};
use kerf_geom::{GeomError, Offsetter, Polyarc};
use kerf_pocket::{Cleared, CutDirection, Cutter, PocketError, Zigzag};
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
    /// Overlap of neighbouring paths, millimetres.
    pub overlap_mm: f64,
    /// The group of the paths; `None` is the first one that has no shapes.
    #[serde(default)]
    pub group: Option<Group>,
    /// Depth to which they are cut; `None` leaves it to the group, which must not be one that cuts through.
    #[serde(default)]
    pub depth: Option<CutDepth>,
    /// The outlines stay in their group and are cut as well.
    #[serde(default)]
    pub outlines_cut: bool,
}

/// Pattern in which the paths of a pocket run.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "pattern", rename_all = "lowercase")]
pub enum Pattern {
    /// Ring by ring.
    Rings(CutDirection),
    /// Line by line.
    Zigzag(Zigzag),
}

/// The words of engraving after its name.
pub(super) fn read_engrave(w: &mut Words) -> Result<Clearing, WordError> {
    let mut clearing = Clearing { all: w.takes("all"), ..Clearing::default() };
    while w.peek().is_some() {
        if w.takes("cut-outlines") {
            clearing.outlines_cut = true;
        } else {
            w.read("a setting", CLEARING, |word| clearing_word(word, &mut clearing))?;
        }
    }
    complete(&clearing)?;
    Ok(clearing)
}

/// The words of a pocket after its name.
pub(super) fn read_pocket(w: &mut Words) -> Result<(Clearing, Pattern), WordError> {
    let mut clearing = Clearing { all: w.takes("all"), ..Clearing::default() };
    let mut pocket = PocketWords::default();
    while w.peek().is_some() {
        if w.takes("climb") {
            pocket.climb = true;
        } else if w.takes("outward") {
            pocket.outward = true;
        } else if w.takes("cut-outlines") {
            clearing.outlines_cut = true;
        } else {
            w.read("a setting", POCKET, |word| {
                pocket.word(word).or_else(|| clearing_word(word, &mut clearing))
            })?;
        }
    }
    complete(&clearing)?;
    Ok((clearing, pocket.pattern()?))
}

/// Words about a pocket's pattern.
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
            None => Ok(Pattern::Rings(CutDirection { climb, outward })),
        }
    }
}

const CLEARING: &str = "cut-outlines, or tool=, depth=, overlap= or group= with its value, such as tool=5, depth=2 \
                        (millimetres below ZSurface) or depth=thru";
const POCKET: &str = "climb, outward, cut-outlines, or tool=, depth=, overlap=, zigzag=, finish= or group= with its \
                      value, such as tool=5, depth=2 (millimetres below ZSurface) or depth=thru";

fn clearing_word(word: &str, clearing: &mut Clearing) -> Option<()> {
    let (key, value) = word.split_once('=')?;
    match key.to_ascii_lowercase().as_str() {
        "tool" => clearing.tool_mm = number(value)?,
        "overlap" => clearing.overlap_mm = number(value)?,
        "group" => clearing.group = Some(Group::named(value)?),
        "depth" => clearing.depth = Some(depth(value)?),
        _ => return None,
    }
    Some(())
}

/// `thru`, or how far below ZSurface.
fn depth(word: &str) -> Option<CutDepth> {
    if word.eq_ignore_ascii_case("thru") {
        return Some(CutDepth::Thru);
    }
    let below_mm = number(word).filter(|below_mm| *below_mm >= 0.0)?;
    Some(CutDepth::Mm(0.0 - below_mm))
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
        match self.depth {
            Some(CutDepth::Mm(depth_mm)) => write!(f, " depth={}", -depth_mm + 0.0)?,
            Some(_) => f.write_str(" depth=thru")?,
            None => {}
        }
        self.group.map_or(Ok(()), |group| write!(f, " group={group}"))?;
        f.write_str(if self.outlines_cut { " cut-outlines" } else { "" })
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
) -> Result<Outcome, OpError> {
    clear(draft, clearing, |region, cutter, offsetter| match pattern {
        Pattern::Rings(way) => kerf_pocket::rings(region, cutter, *way, offsetter),
        Pattern::Zigzag(lines) => kerf_pocket::zigzag(region, cutter, lines, offsetter),
    })
}

/// Rings from the wall to the middle, with the directions of the shapes reversed (readings, P-32 to
/// P-34).
pub(super) fn engrave(draft: &mut Editor, clearing: &Clearing) -> Result<Outcome, OpError> {
    clear(draft, clearing, |region, cutter, offsetter| {
        kerf_pocket::rings(region, cutter, CutDirection::default(), offsetter)
    })
}

type Found = Result<Cleared, PocketError>;

fn clear(
    draft: &mut Editor,
    clearing: &Clearing,
    paths: impl Fn(&[Polyarc], &Cutter, &Offsetter) -> Found,
) -> Result<Outcome, OpError> {
    let cutter = Cutter::new(clearing.tool_mm, clearing.overlap_mm).map_err(OpError::Clearing)?;
    let chosen = if clearing.all { every(draft)? } else { draft.selected()? };
    let (group, of_group) = prepared_group(&mut draft.drawing, clearing)?;
    let (regions, mut warnings) = regions(&draft.drawing, &chosen)?;
    warnings.extend(of_group);
    let first = draft.drawing.shapes.len();
    let (mut outlines, offsetter) = (Vec::new(), Offsetter::default());
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
        } else {
            outlines.extend(region.shapes);
        }
        let shapes = found.paths.into_iter().map(|path| Shape::flat(path).in_group(group));
        shapes.for_each(|shape| draft.drawing.add(shape));
    }
    draft.selection = (first..draft.drawing.shapes.len()).collect();
    let notes = match clearing.outlines_cut {
        true => Vec::new(),
        false => outlines_put_away(&mut draft.drawing, outlines, group)?.into_iter().collect(),
    };
    Ok(Outcome { warnings, notes })
}

fn every(draft: &Editor) -> Result<Vec<usize>, OpError> {
    let count = draft.drawing.shapes.len();
    if count == 0 { Err(OpError::NothingSelected) } else { Ok((0..count).collect()) }
}
