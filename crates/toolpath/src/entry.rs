//! The way down into the material, where the one that was asked has no room.
//!
//! ```text
//!       ╭─────╮                 a helix lies beside the start of its path. The largest one with room
//!      ╱╭───╮  ╲   ▓▓▓▓▓▓       touches the path at the same place and ends where the tool would cut
//!      ││   │  │▓▓▓▓▓▓▓▓        into something; when that leaves next to nothing, the tool goes down
//!   ───┴┴─●─┴──┴────────►       along the path, where it cuts nothing that the path does not cut
//! ```

use crate::depth::{Depths, Heights, plunge};
use crate::gouge::{Contours, Tool};
use crate::job::{CutPath, DrawnJob};
use crate::neighbours;
use crate::shape_paths::{Pass, ShapePath};
use crate::warning::Warning;
use kerf_drawing::{CutDepth, Drawing, Group, GroupSettings};
use kerf_geom::{Polyarc, Vec2};
use kerf_program::job::{Plunge, helix_circle};
use std::collections::BTreeSet;

/// A helix made smaller than this share of what was asked is none any more: the chips need its width. A guess.
const LEAST_SHARE: f64 = 0.25;

/// Radii of helices that were made smaller are whole steps, so many a millimetre.
const STEPS: f64 = 1000.0;

/// So often the interval that holds the largest radius is halved.
const HALVINGS: usize = 40;

/// Surroundings that helices of a drawing may cut into: its contours, and those of the blocks beside it in its
/// arrays.
pub(crate) struct Surroundings<'a> {
    contours: &'a Contours,
    /// Places of the blocks, this one first.
    blocks: Vec<Vec2>,
}

/// The way down of a path for which room is sought.
struct Sought<'a> {
    around: &'a Surroundings<'a>,
    path: &'a Polyarc,
    tool: Tool,
    /// The group whose shapes are no walls: they are the ways of the tool in a cleared area.
    cleared: Option<Group>,
}

/// A shape that a helix would cut into, in the block so far away.
struct Hit {
    shape: usize,
    block: Vec2,
}

impl<'a> Surroundings<'a> {
    pub fn of(drawing: &Drawing, contours: &'a Contours) -> Self {
        Self { contours, blocks: neighbours::blocks(drawing, widest(drawing)) }
    }

    /// The largest radius of a helix that has room, millimetres, 0 for none; nothing where the one that was
    /// asked has room, or none was asked. What is done instead is told.
    pub fn room(
        &self,
        number: usize,
        path: &ShapePath,
        settings: &GroupSettings,
        group: Group,
        warnings: &mut Vec<Warning>,
    ) -> Option<f64> {
        let Plunge::Helix { radius_mm, .. } = plunge(settings, None) else { return None };
        if path.pass == Pass::Traversal || settings.height == CutDepth::ThreeD {
            return None;
        }
        let tool = Tool { radius_mm: radius(path, settings) };
        let cleared = (path.offset_mm == 0.0 && tool.radius_mm > 0.0).then_some(group);
        let sought = Sought { around: self, path: &path.path, tool, cleared };
        let hit = sought.hit(&helix_circle(&path.path, radius_mm)?)?;
        let room_mm = sought.largest(radius_mm);
        warnings.push(Warning { at: path.path.start(), ..told(number, &hit, radius_mm, room_mm) });
        Some(room_mm)
    }
}

/// Tells of a shape that is entered straight down though its group asks for another way: the heights of a 3D
/// path belong to its vertices, there is no level to go down to.
pub(crate) fn straight_down(number: usize, settings: &GroupSettings, warnings: &mut Vec<Warning>) {
    let asked = match plunge(settings, None) {
        Plunge::Straight => return,
        Plunge::Ramp { .. } => "ramp",
        Plunge::Helix { .. } => "helix",
    };
    if settings.height == CutDepth::ThreeD {
        let text = format!("a 3D path is entered straight down, without the {asked} of its group");
        warnings.push(Warning::new(number, text));
    }
}

/// Tells the shapes that are entered steeper than their group asks for, as they would go round too often; each
/// once, however often arrays repeat it.
pub fn too_flat(job: &DrawnJob, heights: &Heights) -> Vec<Warning> {
    let mut told = BTreeSet::new();
    let of = |path: &CutPath| {
        let settings = job.drawing.settings(path.shape.group);
        let Ok(Depths::Level(levels)) = job.depths(path, heights) else { return None };
        let drop_mm = heights.surface_mm - levels.first()?;
        let flat = plunge(settings, path.room_mm).too_flat(&path.shape.path, drop_mm)?;
        let at = path.shape.path.start();
        Some(Warning { at, ..Warning::new(path.from, flat.to_string()) })
    };
    let cut = job.paths.iter().filter(|path| path.pass != Pass::Traversal);
    cut.filter_map(of).filter(|warning| told.insert(warning.shape)).collect()
}

/// Returns how far from their shapes the helices of a drawing reach at the most, with the tool.
fn widest(drawing: &Drawing) -> f64 {
    let of = |settings: &GroupSettings| match plunge(settings, None) {
        Plunge::Helix { radius_mm, .. } => {
            let leads = settings.lead_in.radius_mm.abs() + settings.lead_out.radius_mm.abs();
            let beside = settings.offset_mm.abs() + settings.rough_mm.abs();
            2.0 * (radius_mm.abs() + leads + beside) + settings.cutter_mm.unwrap_or_default()
        }
        _ => 0.0,
    };
    drawing.groups.iter().filter(|settings| settings.on).map(of).fold(0.0, f64::max)
}

/// The radius of the tool, millimetres: its path lies so far beside the shape. Without an offset it is that of
/// the group's cutter; 0 where neither is known.
fn radius(path: &ShapePath, settings: &GroupSettings) -> f64 {
    let cutter = || settings.cutter_mm.map_or(0.0, |wide| 0.5 * wide);
    if path.offset_mm == 0.0 { cutter() } else { path.offset_mm.abs() }
}

impl Sought<'_> {
    fn is_wall(&self, shape: usize) -> bool {
        self.cleared.is_none_or(|group| self.around.contours.group(shape) != group)
    }

    /// Finds what a helix cuts into.
    fn hit(&self, circle: &Polyarc) -> Option<Hit> {
        let (contours, wall) = (self.around.contours, |shape| self.is_wall(shape));
        self.seek(|by| contours.cut_by_ring(&moved(circle, by), self.tool, wall))
    }

    /// Returns `true` if nothing lies in what a helix and all smaller ones cut.
    fn is_free(&self, radius_mm: f64) -> bool {
        let Some(circle) = helix_circle(self.path, radius_mm) else { return true };
        let (contours, wall) = (self.around.contours, |shape| self.is_wall(shape));
        let middle = circle.bounds().centre();
        let inside = |by| contours.cut_by_disc(middle - by, radius_mm.abs(), self.tool, wall);
        self.seek(inside).is_none()
    }

    fn seek(&self, find: impl Fn(Vec2) -> Option<usize>) -> Option<Hit> {
        let hit = |block: &Vec2| find(*block).map(|shape| Hit { shape, block: *block });
        self.around.blocks.iter().find_map(hit)
    }

    /// The largest radius with room on the side of the one that was asked; 0 when it is too small.
    fn largest(&self, asked_mm: f64) -> f64 {
        let (mut free, mut taken) = (0.0, asked_mm.abs());
        for _ in 0..HALVINGS {
            let middle = 0.5 * (free + taken);
            let fits = self.is_free(middle.copysign(asked_mm));
            *(if fits { &mut free } else { &mut taken }) = middle;
        }
        let whole = (free * STEPS).floor() / STEPS;
        if whole >= LEAST_SHARE * asked_mm.abs() { whole } else { 0.0 }
    }
}

/// A circle as the block so far away sees it.
fn moved(circle: &Polyarc, block: Vec2) -> Polyarc {
    let mut moved = circle.clone();
    moved.vertices.iter_mut().for_each(|vertex| vertex.at += block * -1.0);
    moved
}

fn told(number: usize, hit: &Hit, asked_mm: f64, room_mm: f64) -> Warning {
    let it = hit.shape + 1 == number && hit.block == Vec2::default();
    let shape = if it { "it".into() } else { format!("shape {}", hit.shape + 1) };
    let away = neighbours::away(hit.block);
    let asked = asked_mm.abs();
    let instead = if room_mm > 0.0 {
        format!("one of {room_mm} mm is cut instead")
    } else {
        "it goes down along its path instead".into()
    };
    let text = format!("its helix of {asked} mm would cut into {shape}{away}: {instead}");
    Warning::new(number, text)
}
