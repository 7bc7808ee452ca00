//! A job in the words that machines understand.

use crate::depth::depth;
use crate::job::{CutPath, Job};
use crate::shape_paths::Pass;
use kerf_drawing::GroupSettings;
use kerf_program::job::{self, Plunge};
use std::sync::Arc;

impl Job {
    /// The same job without its drawing, under a name.
    pub fn neutral(&self, name: Arc<str>) -> job::Job {
        let shape = |path: &CutPath| shape(path, self.drawing.settings(path.shape.group));
        job::Job {
            name,
            shapes: self.paths.iter().map(shape).collect(),
            origin: self.origin,
            finish: self.finish,
            start: self.start.max(1),
            repeats: 1,
            notes: Arc::default(),
        }
    }
}

/// The way down of a path of a group. Its helices lie on the side of the leads: right, unless the offset is
/// negative. They are no larger than the path has room for; without any it is a ramp as steep.
pub(crate) fn plunge(settings: &GroupSettings, room_mm: Option<f64>) -> Plunge {
    match settings.plunge {
        Plunge::Helix { radius_mm, angle_deg } => {
            let sign = if settings.offset_mm < 0.0 { -1.0 } else { 1.0 };
            let asked_mm = radius_mm.abs();
            let fits_mm = room_mm.map_or(asked_mm, |room_mm| room_mm.min(asked_mm));
            if fits_mm > 0.0 {
                let radius_mm = sign * fits_mm.copysign(radius_mm);
                Plunge::Helix { radius_mm, angle_deg }
            } else {
                Plunge::Ramp { angle_deg }
            }
        }
        plunge => plunge,
    }
}

fn shape(path: &CutPath, settings: &GroupSettings) -> job::JobShape {
    let shape = &path.shape;
    let z_mm = shape.z_mm.as_deref().unwrap_or_default();
    job::JobShape {
        number: u32::try_from(path.from).unwrap_or(u32::MAX),
        path: Arc::new(shape.path.clone()),
        z_mm: z_mm.into(),
        depth: depth(settings),
        plunge: plunge(settings, path.room_mm),
        tool: settings.tool,
        cut: settings.cut,
        speed_mm_s: settings.speed_mm_min.map(|mm_min| mm_min / 60.0),
        pause: shape.pause,
        traversal: path.pass == Pass::Traversal,
        group: shape.group.name().into(),
    }
}
