//! The drawing that is open.

use crate::awaited::Awaited;
use crate::configure::MachineSettings;
use crate::counted::Counted;
use crate::digested::hash;
use crate::hub::Hub;
use crate::loader::Loader;
use crate::locks::{DESK, Lock, lock};
use crate::machine::LastState;
use crate::part_files::PartFiles;
use crate::reading;
use crate::reading::Readings;
use crate::refusal::{Done, problem};
use crate::saving::Leave;
use kerf_drawing::{Drawing, Editor, Operation, script};
use kerf_formats::{Content, Format, Imported, Opening, ending, readable, writable};
use kerf_gcode::{Writer, Writing};
use kerf_geom::Point2;
use kerf_import::job_file;
use kerf_program::Printer;
use kerf_program::settings::LinearUnit;
use kerf_sbp::{Printing, SbpPrinter};
use kerf_sequence::Speeds;
use kerf_toolpath::{DrawnJob, JobError, Shaping, shaped_job_until};
use kerf_wire::{Change, Op, Problem, Why};
use std::sync::mpsc::Sender;
use std::sync::{Arc, Mutex, OnceLock};

/// Told once when tool paths are opened to be drawn on.
const BY_HAND: &str = "These are tool paths: what is changed here is lost when they are made anew from the drawing. \
                       They are saved as .rsm.";

/// An editor and where its drawing lies.
#[derive(Default)]
pub struct OpenDrawing {
    pub(crate) editor: Editor,
    pub(crate) name: Option<String>,
    /// Grows with every change.
    pub(crate) revision: u32,
    /// The revision with which this drawing was opened or begun.
    pub(crate) begun: u32,
    /// The drawing as it was opened or saved.
    pub(crate) saved: Drawing,
    /// The hash of its file as it was opened or saved: that one may be written over.
    pub(crate) kept: Option<String>,
    /// The job whose paths are drawn on, where a job was opened.
    pub(crate) job: Option<DrawnJob>,
    open: bool,
    pub(crate) notes: Vec<String>,
    /// Place to which the head goes when the job is done, from its origin.
    pub(crate) finish: Option<Point2>,
}

/// The desk on which drawings are drawn, and its drawer of drafts.
pub struct DrawingDesk {
    pub hub: Arc<Hub>,
    pub left: Arc<Mutex<LastState>>,
    pub files: Arc<PartFiles>,
    pub loader: Arc<Loader>,
    pub settings: Arc<MachineSettings>,
    /// The drawing that is open.
    pub desk: Lock<DESK, OpenDrawing>,
    /// The drawing that is being read to be opened.
    pub reading: Readings,
    /// The drawing that is not saved, in the data folder.
    pub draft: Counted,
    /// Tells the thread that keeps drafts that the drawing changed.
    pub changed: OnceLock<Sender<()>>,
}

/// A drawing that was read to be opened.
struct Read {
    /// The job, where the file holds one.
    job: Option<DrawnJob>,
    imported: Imported,
    /// The hash of the file, where the drawing is all that it holds.
    kept: Option<String>,
}

impl DrawingDesk {
    /// Changes the drawing. Files are read before anybody has to wait for the desk.
    ///
    /// # Errors
    /// Why it stays as it was.
    pub fn draw(&self, op: Op, awaited: &Awaited) -> Done {
        match op {
            Op::Open { name } => {
                let opened = self.read_to_open(&name, awaited)?;
                self.on_desk(|desk| Ok(self.open_drawing(desk, name, opened)))
            }
            Op::Do { clauses } => {
                let operations = self.operations(&clauses, awaited)?;
                self.on_desk(|desk| self.carry_out(desk, &operations))
            }
            Op::New => {
                self.on_desk(|desk| Ok(self.begin(desk, Drawing::default(), None, Vec::new())))
            }
            Op::Save { name, replaces } => {
                self.on_desk(|desk| self.save_drawing(desk, name, replaces.as_deref()))
            }
            Op::Undo => self.on_desk(|desk| desk.step(Editor::undo)),
            Op::Redo => self.on_desk(|desk| desk.step(Editor::redo)),
            Op::Finish { at } => self.on_desk(|desk| desk.finish_at(at)),
            Op::Program { name, replaces } => {
                let leave = Leave::of(replaces.as_deref());
                self.on_desk(|desk| self.write_program(desk, &name, &leave, awaited))
            }
        }
    }

    /// Changes what lies on the desk, and tells everybody.
    fn on_desk(&self, change: impl FnOnce(&mut OpenDrawing) -> Done) -> Done {
        let mut desk = self.desk.lock();
        let notes = change(&mut desk)?;
        desk.notes.clone_from(&notes);
        let drawing = Some(desk.state(&LastState::heights(&self.left)));
        self.hub.change(vec![Change::Drawing { drawing }]);
        drop(desk);
        self.drawn();
        Ok(notes)
    }

    /// Draws a shape that was not drawn at a page.
    ///
    /// # Errors
    /// Why it cannot be drawn.
    pub fn draw_shape(&self, operation: Operation) -> Result<(), Problem> {
        self.on_desk(|desk| self.carry_out(desk, &[(1, operation)])).map(drop)
    }

    pub(crate) fn begin(
        &self,
        desk: &mut OpenDrawing,
        drawing: Drawing,
        name: Option<String>,
        notes: Vec<String>,
    ) -> Vec<String> {
        let join_mm = lock(&self.left).session.machine_is.options.join_mm;
        desk.begin(drawing, name, join_mm);
        notes
    }

    fn carry_out(&self, desk: &mut OpenDrawing, operations: &[(usize, Operation)]) -> Done {
        let before = desk.editor.join_mm;
        let notes = desk.carry_out(operations)?;
        if desk.editor.join_mm.to_bits() != before.to_bits() {
            self.settings.keep_join(desk.editor.join_mm);
        }
        Ok(notes)
    }

    /// Reads a drawing that is to be opened; one that is still being read is given up.
    fn read_to_open(&self, name: &str, awaited: &Awaited) -> Result<Read, Problem> {
        let (reading, bytes) = (self.reading.begin(), self.files.folder.read(name)?);
        let given_up = || reading.is_given_up() || awaited.is_given_up();
        let format = Format::of_file(name);
        let (job, imported) = match format.map(Format::content) {
            Some(Content::Job) => {
                let (job, read) = kerf_toolpath::read_until(&bytes, &given_up);
                let read = reading::whole(name, read)?;
                let imported = Imported { drawing: job.as_drawing(), ..read };
                (Some(job), imported)
            }
            _ => (None, drawing_until(name, &bytes, &given_up)?),
        };
        // What was imported is not what the file holds: who writes over that is asked.
        let kept = format.filter(|format| format.keeps_all).map(|_| hash(&bytes));
        Ok(Read { job, imported, kept })
    }

    fn open_drawing(&self, desk: &mut OpenDrawing, name: String, read: Read) -> Vec<String> {
        let Read { job, imported: Imported { drawing, findings, .. }, kept } = read;
        let mut notes: Vec<_> = findings.into_iter().map(|found| found.text).collect();
        notes.splice(0..0, job.is_some().then(|| BY_HAND.into()));
        let notes = self.begin(desk, drawing, Some(name), notes);
        desk.kept = kept;
        desk.finish = job.as_ref().and_then(|job| job.finish);
        desk.job = job;
        notes
    }

    pub(crate) fn read_drawing(&self, name: &str, awaited: &Awaited) -> Result<Imported, Problem> {
        drawing_until(name, &self.files.folder.read(name)?, &|| awaited.is_given_up())
    }

    /// The operations of clauses, with what the files of the part folder hold that they name.
    fn operations(
        &self,
        clauses: &str,
        awaited: &Awaited,
    ) -> Result<Vec<(usize, Operation)>, Problem> {
        let read = script(clauses).map_err(|error| problem(Why::Mistake, error.to_string()))?;
        let with_file = |(number, operation): (usize, Operation)| {
            let Some(file) = operation.file().map(str::to_owned) else {
                return Ok((number, operation));
            };
            let Imported { drawing, .. } = self.read_drawing(&file, awaited)?;
            Ok((number, operation.with_file(drawing)))
        };
        read.into_iter().map(with_file).collect()
    }

    fn save_drawing(&self, desk: &mut OpenDrawing, name: String, replaces: Option<&str>) -> Done {
        let drawing = &desk.editor.drawing;
        let format = Format::of_file(&name)
            .filter(|format| format.is_written())
            .ok_or_else(|| problem(Why::File, format!("a drawing is written as {}", writable())))?;
        let text = match format.write(drawing) {
            Some(text) => text,
            None => kerf_toolpath::write(&desk.edited_job()?),
        };
        let hash = self.files.save(&name, text.as_bytes(), &desk.leave(&name, replaces))?;
        if let Some(lost) = format.unkept(drawing) {
            return Ok(vec![format!("{name}: {lost}")]);
        }
        desk.saved = desk.editor.drawing.clone();
        (desk.name, desk.kept) = (Some(name), Some(hash));
        Ok(Vec::new())
    }

    /// Writes the part program of the drawing's tool paths, and opens it.
    fn write_program(
        &self,
        desk: &OpenDrawing,
        name: &str,
        leave: &Leave,
        awaited: &Awaited,
    ) -> Done {
        self.loader.nothing_unsaved()?;
        let (job, mut warnings) = match desk.job {
            // Tool paths are cut as they are.
            Some(_) => (desk.edited_job()?, Vec::new()),
            None => job(&desk.editor.drawing, LastState::shaping(&self.left), awaited)?,
        };
        let job = DrawnJob { finish: desk.finish, ..job };
        let title = Some(format!("Made from {}", desk.name.as_deref().unwrap_or("a drawing")));
        // In the unit that the machine is set to: a part file of the other one refuses to run.
        let inches = self.hub.read(|now| now.units.linear == LinearUnit::Inch.symbol());
        let unit = if inches { LinearUnit::Inch } else { LinearUnit::Mm };
        let printing = Printing { unit, title: title.clone(), ..Printing::default() };
        let writing = Writing { unit, title, ..Writing::default() };
        let mut printer: Box<dyn Printer> = match ending(name).as_str() {
            "sbp" => Box::new(SbpPrinter::new(&printing)),
            "nc" => Box::new(Writer::new(&writing)),
            _ => return Err(problem(Why::File, "a program is written as .sbp or .nc")),
        };
        let machine = lock(&self.left).session.configuration();
        let noticed = job_file::print(&job, &machine, Speeds::Written, printer.as_mut());
        warnings.extend(noticed.map_err(|wrong| problem(Why::Mistake, wrong.join("; ")))?);
        self.files.save(name, printer.finish().text.as_bytes(), leave)?;
        self.loader.open_file(name)?;
        Ok(warnings)
    }
}

impl OpenDrawing {
    fn begin(&mut self, drawing: Drawing, name: Option<String>, join_mm: f64) {
        self.saved = drawing.clone();
        // What was copied is pasted into another drawing.
        let clipboard = std::mem::take(&mut self.editor.clipboard);
        self.editor = Editor::of(drawing);
        (self.editor.clipboard, self.editor.join_mm) = (clipboard, join_mm);
        (self.name, self.open) = (name, true);
        (self.finish, self.kept, self.job) = (None, None, None);
        self.revision += 1;
        self.begun = self.revision;
    }

    /// Leave to write over a file: the one that was opened or saved last, as it was then, or the one that the
    /// page names.
    fn leave(&self, name: &str, replaces: Option<&str>) -> Leave {
        let own = self.kept.as_deref().filter(|_| self.name.as_deref() == Some(name));
        Leave::of(replaces.or(own))
    }

    /// The job that was opened, with the paths as they were drawn.
    fn edited_job(&self) -> Result<DrawnJob, Problem> {
        let text = "tool paths are made by Machine; as .rsm those are saved that were opened";
        let job = self.job.clone().ok_or_else(|| problem(Why::File, text))?;
        Ok(DrawnJob { finish: self.finish, ..job.edited(&self.editor.drawing) })
    }

    fn finish_at(&mut self, [x, y]: [f64; 2]) -> Done {
        if !(x.is_finite() && y.is_finite()) {
            return Err(problem(Why::Malformed, "a place has two numbers"));
        }
        self.finish = Some(Point2::new(x, y));
        Ok(Vec::new())
    }

    /// All clauses, or none.
    fn carry_out(&mut self, operations: &[(usize, Operation)]) -> Done {
        let before = self.editor.drawing.clone();
        let outcomes = self.editor.apply_all(operations).map_err(|(number, error)| {
            problem(Why::Mistake, format!("clause {number}: {error}"))
        })?;
        self.open = true;
        self.revision += u32::from(self.editor.drawing != before);
        let told = outcomes.into_iter().flat_map(|outcome| [outcome.warnings, outcome.notes]);
        Ok(told.flatten().collect())
    }

    fn step(&mut self, step: fn(&mut Editor) -> Result<(), kerf_drawing::OpError>) -> Done {
        step(&mut self.editor).map_err(|error| problem(Why::State, error.to_string()))?;
        self.revision += 1;
        Ok(Vec::new())
    }
}

/// Reads the drawing that a file holds.
pub(crate) fn drawing_in(name: &str, bytes: &[u8]) -> Result<Imported, Problem> {
    drawing_until(name, bytes, &|| false)
}

/// The same, until it is given up.
fn drawing_until(
    name: &str,
    bytes: &[u8],
    given_up: &dyn Fn() -> bool,
) -> Result<Imported, Problem> {
    let read = kerf_formats::open(name, bytes, &Opening { given_up, ..Opening::default() });
    let read = read.ok_or_else(|| problem(Why::File, format!("a drawing is {}", readable())))?;
    reading::whole(name, read)
}

/// The job of a drawing, and what was noticed.
///
/// # Errors
/// Its arrays are out of all bounds, or nobody waits for it any more.
pub(crate) fn job(
    drawing: &Drawing,
    shaping: Shaping,
    awaited: &Awaited,
) -> Result<(DrawnJob, Vec<String>), Problem> {
    let made = shaped_job_until(drawing, shaping, &|| awaited.is_given_up());
    let (job, warnings) = made.map_err(|error| {
        let why = if error == JobError::GivenUp { Why::State } else { Why::Mistake };
        problem(why, error.to_string())
    })?;
    Ok((job, warnings.iter().map(ToString::to_string).collect()))
}
