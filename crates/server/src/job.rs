//! Jobs: the tool paths of drawings, cut as `kerf run` cuts them, and how they come from a drawing.

use crate::awaited::Awaited;
use crate::configure::MachineSettings;
use crate::desk::{DrawingDesk, job};
use crate::digested::hash;
use crate::file_kind::kind_of;
use crate::hub::Hub;
use crate::loader::Loader;
use crate::locks::{Lock, TAKEN, lock};
use crate::machine::LastState;
use crate::open::Open;
use crate::part_files::PartFiles;
use crate::refusal::{Done, problem};
use crate::saving::Leave;
use kerf_drawing::Drawing;
use kerf_geom::Point2;
use kerf_import::job_file;
use kerf_journal::Work;
use kerf_machine::Configuration;
use kerf_program::Axis;
use kerf_program::job::JobShape;
use kerf_sequence::Sequence;
use kerf_toolpath::DrawnJob;
use kerf_wire::{FileKind, JobChoice, JobPath, JobView, Problem, ShapePath, State, Why};
use std::sync::{Arc, Mutex};

/// The job that is open, and how jobs are made from drawings.
pub struct Jobs {
    pub hub: Arc<Hub>,
    pub left: Arc<Mutex<LastState>>,
    pub files: Arc<PartFiles>,
    pub loader: Arc<Loader>,
    pub settings: Arc<MachineSettings>,
    pub drawing: Arc<DrawingDesk>,
    /// Hash of the job that runs, and the origin that it took, X and Y from home, mm.
    pub taken: Lock<TAKEN, Option<(String, [f64; 2])>>,
}

impl Jobs {
    /// Cuts the open job otherwise from now on.
    ///
    /// # Errors
    /// No job is open, one runs, or the choice makes no sense.
    pub fn choose(&self, choice: JobChoice) -> Result<(), Problem> {
        let open = self.job_at_rest()?;
        let count = self.loader.path_count(&open);
        let places = choice.origin.into_iter().chain(choice.finish).flatten();
        let numbers = places.chain([choice.offset, choice.lift]);
        if choice.start.is_some_and(|start| start == 0 || start > count) {
            return Err(problem(Why::Mistake, format!("the job has the paths 1 to {count}")));
        }
        if !numbers.into_iter().all(f64::is_finite) {
            return Err(problem(Why::Malformed, "origin, finish, offset and lift are lengths"));
        }
        self.loader.cut_with(open, choice)?;
        Ok(())
    }

    /// The job that is open while none runs.
    pub(crate) fn job_at_rest(&self) -> Result<Open, Problem> {
        let open = self.loader.open.lock().clone();
        if kind_of(&open.name) != FileKind::Job {
            return Err(problem(Why::State, "no job is open"));
        }
        if !matches!(self.hub.state(), State::Idle | State::Alarm) {
            return Err(problem(Why::State, "the machine is busy"));
        }
        Ok(open)
    }

    /// Writes the origin that was chosen into the file of the open job.
    ///
    /// # Errors
    /// None is open or was chosen, one runs, or the file is another by now or cannot be written.
    pub fn keep_origin(&self) -> Result<(), Problem> {
        let open = self.job_at_rest()?;
        let Some([x, y]) = open.choice.origin else {
            return Err(problem(Why::State, "the job lies where its file says"));
        };
        let choice = JobChoice { origin: None, ..open.choice };
        self.write_job(open, choice, |job| DrawnJob { origin: Some(Point2::new(x, y)), ..job })
    }

    /// Writes where the open job lies, where it ends and with which path it begins into its file. Its paths stay
    /// as they were made.
    ///
    /// # Errors
    /// As [`Jobs::keep_origin`].
    pub fn save_job(&self) -> Result<(), Problem> {
        let open = self.job_at_rest()?;
        let [origin, finish] = self.loader.lies(&open).map(Some);
        let chosen = open.choice.start;
        let choice = JobChoice { origin: None, finish: None, start: None, ..open.choice };
        self.write_job(open, choice, |job| {
            let start = chosen.map_or(job.start, |start| start as usize);
            DrawnJob { origin, finish, start, ..job }
        })
    }

    /// Puts another job into the file of the open one, which is cut so from now on.
    fn write_job(
        &self,
        mut open: Open,
        choice: JobChoice,
        change: impl FnOnce(DrawnJob) -> DrawnJob,
    ) -> Result<(), Problem> {
        let present = self.files.folder.read(&open.name)?;
        if !open.is_of(&present) {
            let text = "the file was changed since it was opened; open it again";
            return Err(problem(Why::Changed, text));
        }
        let (job, _) = kerf_toolpath::read(&open.bytes);
        let text = kerf_toolpath::write(&change(job));
        self.files.save(&open.name, text.as_bytes(), &Leave::Of(hash(&present)))?;
        open.bytes = text.into_bytes().into();
        open.unsaved.clear();
        self.loader.added.keep(&open);
        self.loader.cut_with(open, choice)?;
        Ok(())
    }

    /// Makes the job of a drawing, writes it beside the drawing and opens it.
    ///
    /// # Errors
    /// There is nothing to cut, the file of the job was changed by hand, or nobody waits for it any more.
    pub fn machine(&self, drawing: Option<&str>, anew: bool, awaited: &Awaited) -> Done {
        self.loader.nothing_unsaved()?;
        let (name, drawing, finish) = self.drawing_to_machine(drawing, awaited)?;
        if kind_of(&name) == FileKind::Job {
            let text = format!("{name} has tool paths already: save it, and open it as a job");
            return Err(problem(Why::State, text));
        }
        let name = format!("{}.{}", stem(&name), job_file::EXTENSION);
        if !anew && self.was_edited(&name) {
            let text =
                format!("{name}: its paths were changed by hand; making them anew loses that");
            return Err(problem(Why::Changed, text));
        }
        let (made, warnings) = job(&drawing, LastState::shaping(&self.left), awaited)?;
        if made.paths.is_empty() {
            return Err(problem(Why::Mistake, "nothing is drawn that could be cut"));
        }
        awaited.goes_on()?;
        let text = kerf_toolpath::write(&DrawnJob { finish, ..made });
        awaited.goes_on()?;
        self.files.saves.make(&self.files.folder, &name, text.as_bytes(), anew)?;
        self.files.changed();
        self.loader.open_file(&name)?;
        Ok(warnings)
    }

    /// A drawing of the part folder, or the one on the desk: name, drawing, finish position.
    fn drawing_to_machine(
        &self,
        drawing: Option<&str>,
        awaited: &Awaited,
    ) -> Result<(String, Drawing, Option<Point2>), Problem> {
        if let Some(name) = drawing {
            return Ok((name.into(), self.drawing.read_drawing(name, awaited)?.drawing, None));
        }
        let desk = self.drawing.desk.lock();
        let name = desk.name.clone().unwrap_or_else(|| "drawing".into());
        Ok((name, desk.editor.drawing.clone(), desk.finish))
    }

    fn was_edited(&self, name: &str) -> bool {
        self.files.folder.read(name).is_ok_and(|bytes| kerf_toolpath::read(&bytes).0.edited)
    }

    /// The open job as a page shows it.
    ///
    /// # Errors
    /// None is open.
    pub fn job_view(&self) -> Result<JobView, Problem> {
        let open = self.loader.open.lock().clone();
        if kind_of(&open.name) != FileKind::Job {
            return Err(problem(Why::State, "no job is open"));
        }
        let position = lock(&self.left).session.memory.position;
        let Work::Job(job, machine) = self.loader.job_of(&open)? else {
            return Err(problem(Why::State, "no job is open"));
        };
        let sequence = Sequence::new(job, machine.clone(), position);
        Ok(JobView { hash: open.hash, ..view(&sequence, &machine) })
    }
}

/// Returns a name without its extension.
fn stem(name: &str) -> &str {
    name.rsplit_once('.').map_or(name, |(stem, _)| stem)
}

fn view(sequence: &Sequence, machine: &Configuration) -> JobView {
    let (job, heights) = (sequence.job(), sequence.heights());
    let corner = |place: Option<Point2>| place.map_or([0.0; 2], |at| [at.x, at.y]);
    let reach = |axis| sequence.reach(axis).unwrap_or_default();
    JobView {
        paths: job.shapes.iter().map(path).collect(),
        origin: corner(job.origin),
        finish: corner(job.finish),
        start: u32::try_from(job.start).unwrap_or(1),
        repeats: job.repeats,
        cut_mm_s: sequence.cut_mm_s(),
        plunge_mm_s: machine.speeds.plunge_mm_s,
        heights: [heights.top_mm, heights.surface_mm, heights.bottom_mm],
        raise: machine.pause.raise,
        table: [reach(Axis::X), reach(Axis::Y)],
        origin_at_start: machine.job.change_origin_at_start,
        ..JobView::default()
    }
}

fn path(shape: &JobShape) -> JobPath {
    let points = shape.path.vertices.iter().flat_map(|v| [v.at.x, v.at.y, v.bulge]);
    let path = ShapePath {
        number: shape.number,
        group: shape.group.to_string(),
        closed: shape.path.closed,
        points: points.collect(),
        z: None,
        pause: shape.pause,
    };
    JobPath { path, traversal: shape.traversal, tool: shape.tool }
}
