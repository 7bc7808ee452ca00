//! Shapes that were digitized: into the job that is open, else into the drawing, else into a new job.

use crate::file_kind::kind_of;
use crate::job::Jobs;
use crate::open::Open;
use crate::refusal::problem;
use kerf_drawing::{Operation, Shape};
use kerf_import::job_file;
use kerf_toolpath::DrawnJob;
use kerf_wire::{FileKind, Problem, Why};
use std::sync::Arc;

/// The name of a new job; with a number from 2 where there is one.
const NEW_JOB: &str = "digitized";

impl Jobs {
    /// Adds a shape, last; gives how many there are then, and where.
    ///
    /// # Errors
    /// A job runs, or nothing can be written.
    pub fn add_shape(&self, shape: Arc<Shape>) -> Result<String, Problem> {
        let open = self.loader.open.lock().clone();
        if kind_of(&open.name) == FileKind::Job {
            return self.add_to_job(shape);
        }
        if self.hub.read(|now| now.drawing.is_some()) {
            return self.add_to_drawing(&shape);
        }
        self.begin_job(shape)
    }

    /// The shapes that can be loaded: the paths of the open job, else the shapes of the drawing.
    pub fn loadable(&self, open: &Open) -> Vec<Arc<Shape>> {
        if kind_of(&open.name) == FileKind::Job {
            return kerf_toolpath::read(&open.bytes).0.as_drawing().shapes;
        }
        self.drawing.desk.lock().editor.drawing.shapes.clone()
    }

    /// The open job has a path more. Its file gets it when the job is saved.
    fn add_to_job(&self, shape: Arc<Shape>) -> Result<String, Problem> {
        let mut open = self.job_at_rest()?;
        let (bytes, count) = with_shape(kerf_toolpath::read(&open.bytes).0, shape);
        open.unsaved.push(std::mem::replace(&mut open.bytes, bytes));
        self.loader.added.keep(&open);
        let choice = open.choice;
        self.loader.cut_with(open, choice)?;
        Ok(format!("{count} in the job"))
    }

    fn add_to_drawing(&self, shape: &Shape) -> Result<String, Problem> {
        self.drawing.draw_shape(drawn(shape))?;
        let count = self.drawing.desk.lock().editor.drawing.shapes.len();
        Ok(format!("{count} in the drawing"))
    }

    /// A job without a drawing, in a file of the current folder.
    fn begin_job(&self, shape: Arc<Shape>) -> Result<String, Problem> {
        if !self.loader.open.lock().name.is_empty() {
            let text = "a part file is open: close it, or open a drawing or a job";
            return Err(problem(Why::State, text));
        }
        let folder = self.hub.read(|now| now.folder.name.clone());
        let folder = if folder.is_empty() { folder } else { folder + "/" };
        let numbered = |n: u32| match n {
            1 => format!("{folder}{NEW_JOB}.{}", job_file::EXTENSION),
            n => format!("{folder}{NEW_JOB}-{n}.{}", job_file::EXTENSION),
        };
        let free = |name: &String| self.files.folder.find(name).is_err();
        let name = (1..10_000).map(numbered).find(free);
        let name = name.ok_or_else(|| problem(Why::File, "there is no name for a new job"))?;
        let [origin, _] = self.loader.lies(&Open::default());
        let (bytes, _) =
            with_shape(DrawnJob { origin: Some(origin), start: 1, ..DrawnJob::default() }, shape);
        self.files.folder.write(&name, &bytes)?;
        self.files.changed();
        self.loader.open_file(&name)?;
        Ok(format!("in {name}"))
    }

    /// Takes the shape back that was added last to the open job.
    ///
    /// # Errors
    /// None was since the job was saved, or a job runs.
    pub fn take_shape_back(&self) -> Result<(), Problem> {
        let mut open = self.job_at_rest()?;
        let before = open.unsaved.pop();
        let text = "no shape was added since the job was saved";
        open.bytes = before.ok_or_else(|| problem(Why::State, text))?;
        self.loader.added.keep(&open);
        let choice = open.choice;
        self.loader.cut_with(open, choice)?;
        Ok(())
    }
}

/// A job with a path more, in the bytes of its file, and how many paths it has.
fn with_shape(job: DrawnJob, shape: Arc<Shape>) -> (Arc<[u8]>, usize) {
    let mut drawing = job.as_drawing();
    drawing.shapes.push(shape);
    let count = drawing.shapes.len();
    kerf_drawing::heighten(&mut drawing, count - 1..count);
    let text = kerf_toolpath::write(&job.edited(&drawing));
    (text.into_bytes().into(), count)
}

/// The operation that draws a shape.
fn drawn(shape: &Shape) -> Operation {
    let (vertices, closed) = (shape.path.vertices.clone(), shape.path.closed);
    match (&shape.z_mm, vertices.as_slice()) {
        (None, [only]) => Operation::Point { at: only.at },
        (None, _) => Operation::Polyarc { vertices, closed },
        (Some(z_mm), _) => {
            let places =
                vertices.iter().zip(z_mm).map(|(vertex, z)| [vertex.at.x, vertex.at.y, *z]);
            Operation::SpaceLine { places: places.collect(), closed }
        }
    }
}
