//! A job in the words that machines understand.

use crate::depth::plunge;
use crate::job::{CutPath, DrawnJob};
use crate::shape_paths::Pass;
use kerf_drawing::GroupSettings;
use kerf_program::job;
use std::sync::Arc;

impl DrawnJob {
    /// The same job without its drawing, under a name.
    pub fn machine_job(&self, name: Arc<str>) -> job::Job {
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

fn shape(path: &CutPath, settings: &GroupSettings) -> job::JobShape {
    let shape = &path.shape;
    let z_mm = shape.z_mm.as_deref().unwrap_or_default();
    job::JobShape {
        number: u32::try_from(path.from).unwrap_or(u32::MAX),
        path: Arc::new(shape.path.clone()),
        z_mm: z_mm.into(),
        height: settings.height,
        pass_mm: settings.pass_mm,
        plunge: plunge(settings, path.room_mm),
        tool: settings.tool,
        cut: settings.cut,
        speed_mm_s: settings.speed_mm_min.map(|mm_min| mm_min / 60.0),
        pause: shape.pause,
        traversal: path.pass == Pass::Traversal,
        group: shape.group.name().into(),
    }
}
