//! The machine and the open job as the console shows them.

use crate::app::App;
use crate::file_kind::kind_of;
use crate::locks::lock;
use crate::open::Open;
use crate::work::with_job;
use kerf_drawing::Shape;
use kerf_geom::{Bounds2, Vec2};
use kerf_handconsole::{OpenJob, View, Waits};
use kerf_journal::Work;
use kerf_program::Axes;
use kerf_wire::{Asked, FileKind, Snapshot};
use std::sync::Arc;

/// Facts about the open job that are known without reading it again, and the current folder.
#[derive(Debug, Default)]
pub struct Facts {
    /// The preview that belongs to it, which changes whenever the job does.
    key: String,
    job: Option<OpenJob>,
    /// Its origin on the table and its finish, as far as it says so.
    placed: kerf_program::job::Job,
    /// Its paths, once a key has asked for them.
    paths: Option<Vec<Arc<Shape>>>,
    /// Folder and open file when they were seen last.
    seen: (String, String),
    /// The folder that was chosen last, or that the file lies in which was opened last.
    folder: String,
}

impl Facts {
    /// Returns the view of this moment; files and shapes only for a key.
    pub fn view(&mut self, app: &Arc<App>, lists: bool) -> View {
        let open = app.loader.open.lock().clone();
        if open.key != self.key {
            (self.job, self.placed) = job(app, &open);
            self.paths = None;
            self.key.clone_from(&open.key);
        }
        self.look_where(app, &open);
        let machine = with_job(lock(&app.left).session.configuration(), &self.placed);
        let files = if lists { jobs_in(app, &self.folder) } else { Vec::new() };
        let drawn = if lists { self.drawn(app, &open) } else { Vec::new() };
        let is_job = kind_of(&open.name) == FileKind::Job;
        app.hub.read(|now| View {
            job: self.job.clone(),
            state: now.machine.state,
            why: now.machine.why.clone(),
            waits: now.asked.as_ref().map_or(Waits::No, waits),
            shape: if is_job { shape(now) } else { 0 },
            position: Axes(now.motion.at.machine),
            machine: Arc::new(machine),
            files,
            drawn,
        })
    }

    /// The shapes that can be loaded. The paths of a job are read once.
    fn drawn(&mut self, app: &App, open: &Open) -> Vec<Arc<Shape>> {
        if kind_of(&open.name) != FileKind::Job {
            return app.jobs.loadable(open);
        }
        self.paths.get_or_insert_with(|| app.jobs.loadable(open)).clone()
    }

    /// The name below the part folder, of a job of the current folder.
    pub fn named(&self, job: &str) -> String {
        if self.folder.is_empty() { job.to_owned() } else { format!("{}/{job}", self.folder) }
    }

    fn look_where(&mut self, app: &App, open: &Open) {
        let chosen = app.hub.read(|now| now.folder.name.clone());
        if chosen != self.seen.0 {
            self.folder.clone_from(&chosen);
        }
        if open.name != self.seen.1 && !open.name.is_empty() {
            self.folder = open.name.rsplit_once('/').map_or("", |(folder, _)| folder).to_owned();
        }
        self.seen = (chosen, open.name.clone());
    }
}

/// The shape that is cut, or that the job waits at.
fn shape(now: &Snapshot) -> u32 {
    let runs = now.job.as_ref().is_some_and(|job| job.ended.is_none() && job.command.is_none());
    let asked = now.asked.as_ref().map_or(0, |asked| asked.line);
    if asked > 0 { asked } else { now.motion.line * u32::from(runs) }
}

fn waits(asked: &Asked) -> Waits {
    match (asked.kind.as_str(), asked.prefill.parse()) {
        ("paused", Ok(shape)) => Waits::Start(shape),
        ("paused" | "hold", _) => Waits::Paused,
        _ => Waits::Question(Box::new(asked.clone())),
    }
}

/// The open job, and where it lies without its shapes.
fn job(app: &App, open: &Open) -> (Option<OpenJob>, kerf_program::job::Job) {
    let named = open.name.rsplit('/').next().filter(|name| !name.is_empty());
    let Some(name) = named.map(str::to_owned) else { return Default::default() };
    let offset_mm = open.choice.offset;
    if kind_of(&open.name) != FileKind::Job {
        return (Some(OpenJob { name, ..OpenJob::default() }), Default::default());
    }
    let Ok(Work::Job(job, _)) = app.loader.job_of(open) else {
        let shapes = app.loader.path_count(open);
        return (
            Some(OpenJob { name, shapes, offset_mm, ..OpenJob::default() }),
            Default::default(),
        );
    };
    let mut bounds = Bounds2::default();
    job.shapes.iter().for_each(|shape| bounds.merge(&shape.path.bounds()));
    let size = if bounds.is_empty() { Vec2::default() } else { bounds.size() };
    let (size_mm, shapes) = (Some([size.x, size.y]), job.shapes.len() as u32);
    let placed = kerf_program::job::Job { shapes: Arc::default(), ..(*job).clone() };
    (Some(OpenJob { name, size_mm, shapes, offset_mm }), placed)
}

/// The names of the jobs of a folder, as people sort them.
fn jobs_in(app: &App, folder: &str) -> Vec<String> {
    let listed = app.files.folder.list(folder).unwrap_or_default();
    let jobs =
        listed.into_iter().filter(|file| !file.folder && kind_of(&file.name) == FileKind::Job);
    let short = |name: String| name.rsplit('/').next().unwrap_or_default().to_owned();
    let mut names: Vec<String> = jobs.map(|file| short(file.name)).collect();
    names.sort_by_key(|name| (name.to_lowercase(), name.clone()));
    names
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_shape_is_the_one_that_is_cut_or_waited_at() {
        let mut now = Snapshot::default();
        now.motion.line = 7;
        assert_eq!(shape(&now), 0, "nothing runs");
        now.job = Some(kerf_wire::CurrentRun::default());
        assert_eq!(shape(&now), 7);
        now.asked = Some(Asked { line: 3, ..Asked::default() });
        assert_eq!(shape(&now), 3);
    }
}
