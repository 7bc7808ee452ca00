//! The drawing as pages show it: its state, its shapes, the paths of the tool.

use crate::awaited::Awaited;
use crate::desk::{DrawingDesk, OpenDrawing, job};
use crate::machine::LastState;
use kerf_drawing::{ArrayLevel, CutDepth, Drawing, Group, Lead, Shape};
use kerf_geom::Vec2;
use kerf_program::job::{Depths, Heights};
use kerf_toolpath::{CutPath, Pass, Shaping, shaped, too_near};
use kerf_wire::{
    ArrayState, Block, Change, CutHeight, CutPass, CutShape, DrawingState, GroupState, ShapeList,
    ShapePath, ToolPaths,
};

impl DrawingDesk {
    /// The shapes of the drawing.
    pub fn shapes(&self) -> ShapeList {
        let desk = self.desk.lock();
        let shapes = desk.editor.drawing.shapes.iter().zip(1..);
        ShapeList {
            revision: desk.revision,
            shapes: shapes.map(|(shape, number)| shape_path(shape, number)).collect(),
        }
    }

    /// Returns what the drawing becomes when it is machined. Where there are no paths, the notes say why.
    pub fn tool_paths(&self, awaited: &Awaited) -> ToolPaths {
        let shaping = LastState::shaping(&self.left);
        // On a copy, which shares the shapes: hands need not wait for paths.
        let (drawing, revision) = {
            let desk = self.desk.lock();
            (desk.editor.drawing.clone(), desk.revision)
        };
        let (smoothed, filtered) = as_machined(&drawing, shaping);
        let (paths, notes) = match job(&drawing, shaping, awaited) {
            Ok((job, notes)) => (job.paths.iter().map(cut_shape).collect(), notes),
            Err(why) => (Vec::new(), vec![why.text]),
        };
        ToolPaths { revision, paths, smoothed, filtered, notes }
    }

    /// Tells pages of the drawing again: what its levels follow from has changed.
    pub fn tell_drawing(&self) {
        let heights = LastState::heights(&self.left);
        let desk = self.desk.lock();
        let present = self.hub.read(|now| now.drawing.clone());
        let drawing = present.is_some().then(|| desk.state(&heights));
        if drawing != present {
            self.hub.change(vec![Change::Drawing { drawing }]);
        }
    }
}

/// Shapes that machining changes, as they are then, and the vertices that it leaves out.
fn as_machined(drawing: &Drawing, shaping: Shaping) -> (Vec<ShapePath>, Vec<f64>) {
    let (mut smoothed, mut filtered) = (Vec::new(), Vec::new());
    let unfiltered = Shaping { filter_mm: 0.0, ..shaping };
    for (shape, number) in drawing.shapes.iter().zip(1..) {
        let curved = shaped(shape, unfiltered);
        if curved.path != shape.path {
            smoothed.push(shape_path(&curved, number));
        }
        if shape.z_mm.is_none() {
            let gone = too_near(&shape.path, shaping.filter_mm).into_iter();
            filtered.extend(gone.map(|n| shape.path.vertices[n].at).flat_map(|at| [at.x, at.y]));
        }
    }
    (smoothed, filtered)
}

fn cut_shape(path: &CutPath) -> CutShape {
    let pass = match path.pass {
        Pass::Rough => CutPass::Rough,
        Pass::Final => CutPass::Final,
        Pass::Traversal => CutPass::Traversal,
    };
    let number = u32::try_from(path.from).unwrap_or_default();
    CutShape { path: shape_path(&path.shape, number), pass }
}

impl OpenDrawing {
    pub(crate) fn state(&self, heights: &Heights) -> DrawingState {
        let editor = &self.editor;
        let drawing = &editor.drawing;
        DrawingState {
            name: self.name.clone(),
            revision: self.revision,
            begun: self.begun,
            shapes: drawing.shapes.len() as u32,
            selection: editor.selection.iter().map(|place| *place as u32 + 1).collect(),
            picked: editor.picks.shapes(drawing).iter().map(|place| *place as u32 + 1).collect(),
            can_undo: editor.can_undo(),
            can_redo: editor.can_redo(),
            changed: *drawing != self.saved,
            clipboard: editor.clipboard.len() as u32,
            groups: Group::ALL.map(|group| group_state(drawing, group, heights)).into(),
            block: block(drawing),
            finish: self.finish.map_or([0.0; 2], |at| [at.x, at.y]),
            join: editor.join_mm,
            comments: drawing.comments().to_vec(),
            arrays: arrays(drawing),
            notes: self.notes.clone(),
        }
    }
}

/// Both levels of its arrays: blocks in a job, then jobs on the table.
fn arrays(drawing: &Drawing) -> Vec<ArrayState> {
    let bounds = drawing.bounds();
    let block = bounds.map_or(Vec2::default(), |bounds| bounds.max - bounds.min);
    let levels = drawing.arrays;
    vec![
        array_state("block", &levels.block, block),
        array_state("job", &levels.job, levels.block.size(block)),
    ]
}

/// A level that repeats something of this size.
fn array_state(level: &str, array: &ArrayLevel, size: Vec2) -> ArrayState {
    let pitch = array.pitch(size);
    ArrayState {
        level: level.into(),
        grid: [array.rows, array.columns],
        gap: [array.column_gap_mm, array.row_gap_mm],
        pitch: [pitch.x, pitch.y],
        start: array.start.name().into(),
        order: array.order.name().into(),
    }
}

/// The basic block of data.
fn block(drawing: &Drawing) -> Option<Block> {
    let bounds = drawing.bounds()?;
    let heights = drawing.shapes.iter().filter_map(|shape| shape.z_mm.as_ref()).flatten();
    let z = heights.fold(None, |z: Option<[f64; 2]>, height| {
        let [low, high] = z.unwrap_or([*height; 2]);
        Some([low.min(*height), high.max(*height)])
    });
    let (min, max) = (bounds.min, bounds.max);
    Some(Block { min: [min.x, min.y], max: [max.x, max.y], z })
}

fn group_state(drawing: &Drawing, group: Group, heights: &Heights) -> GroupState {
    let settings = drawing.settings(group);
    let lead = |lead: Lead| [lead.radius_mm, lead.angle_deg];
    GroupState {
        name: group.name().into(),
        on: settings.on,
        traversal: settings.traversal,
        double: settings.double_line,
        tool: settings.tool,
        cut: settings.cut,
        speed_mm_min: settings.speed_mm_min,
        height: match settings.height {
            CutDepth::Thru => CutHeight::Word("thru".into()),
            CutDepth::ThreeD => CutHeight::Word("3d".into()),
            CutDepth::Mm(mm) => CutHeight::Mm(mm),
        },
        pass: settings.pass_mm,
        levels: levels(settings.height, settings.pass_mm, heights),
        offset: settings.offset_mm,
        rough: settings.rough_mm,
        tag: settings.tag_mm,
        lead_in: lead(settings.lead_in),
        lead_out: lead(settings.lead_out),
    }
}

/// Z of each pass, also where it would go below ZBottom: that is told when it is cut.
fn levels(height: CutDepth, pass_mm: Option<f64>, heights: &Heights) -> Vec<f64> {
    let free = Heights { bottom_mm: f64::NEG_INFINITY, ..*heights };
    let depths = match height {
        CutDepth::Thru => return vec![heights.bottom_mm],
        CutDepth::ThreeD => return Vec::new(),
        CutDepth::Mm(_) => Depths::of(height, pass_mm, &[], &free),
    };
    if let Ok(Depths::Level(levels)) = depths { levels } else { Vec::new() }
}

fn shape_path(shape: &Shape, number: u32) -> ShapePath {
    let points = shape.path.vertices.iter().flat_map(|v| [v.at.x, v.at.y, v.bulge]);
    ShapePath {
        number,
        group: Group::name(shape.group).into(),
        closed: shape.is_closed(),
        points: points.collect(),
        z: shape.z_mm.clone(),
        pause: shape.pause,
    }
}

#[cfg(test)]
#[allow(non_snake_case)]
mod tests {
    use super::*;

    const SIM: Heights = Heights { top_mm: -10.0, surface_mm: -20.0, bottom_mm: -30.0 };

    fn check(height: CutDepth, pass_mm: Option<f64>, heights: &Heights, expected: &[f64]) {
        assert_eq!(levels(height, pass_mm, heights), expected);
    }

    #[test]
    fn pro_display_v3d_thru__levels() {
        check(CutDepth::Thru, None, &SIM, &[-30.0]);
        check(CutDepth::Thru, None, &Heights { bottom_mm: -31.0, ..SIM }, &[-31.0]);
    }

    #[test]
    fn pro_display_v3d_mm__levels() {
        check(CutDepth::Mm(-2.0), None, &SIM, &[-22.0]);
        check(CutDepth::Mm(3.0), None, &SIM, &[-17.0]);
        check(CutDepth::Mm(-2.0), None, &Heights { surface_mm: -21.0, ..SIM }, &[-23.0]);
    }

    #[test]
    fn pro_display_v3d_multipass__levels() {
        check(CutDepth::Mm(-13.0), Some(4.0), &SIM, &[-24.0, -28.0, -32.0, -33.0]);
    }
}
