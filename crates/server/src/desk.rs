//! The drawing that is open.

use crate::acts::Done;
use crate::app::{App, lock, problem};
use crate::reading;
use kerf_drawing::{Drawing, Editor, Operation, script};
use kerf_formats::{Imported, dxf, rsg, svg};
use kerf_gcode::{Writer, Writing};
use kerf_geom::Point2;
use kerf_machine::Configuration;
use kerf_program::Printer;
use kerf_program::settings::LinearUnit;
use kerf_sbp::{Printing, SbpPrinter};
use kerf_toolpath::{Heights, Job, Shaping, shaped_job};
use kerf_wire::{Change, Op, Problem, Why};
use std::sync::Arc;

/// An editor and where its drawing lies.
#[derive(Default)]
pub struct Desk {
    pub(crate) editor: Editor,
    pub(crate) name: Option<String>,
    /// Grows with every change.
    pub(crate) revision: u32,
    /// The drawing as it was opened or saved.
    pub(crate) saved: Drawing,
    open: bool,
    pub(crate) notes: Vec<String>,
    /// Where the head goes when the job is done, from its origin.
    pub(crate) finish: Option<Point2>,
}

impl App {
    /// Changes the drawing. Files are read before anybody has to wait for the desk.
    ///
    /// # Errors
    /// Why it stays as it was.
    pub fn draw(self: &Arc<Self>, op: Op) -> Done {
        match op {
            Op::Open { name } => {
                let opened = self.read_to_open(&name)?;
                self.on_desk(|desk| Ok(self.open_drawing(desk, name, opened)))
            }
            Op::Do { clauses } => {
                let operations = self.operations(&clauses)?;
                self.on_desk(|desk| self.carry_out(desk, &operations))
            }
            Op::New => {
                self.on_desk(|desk| Ok(self.begin(desk, Drawing::default(), None, Vec::new())))
            }
            Op::Save { name } => self.on_desk(|desk| self.save_drawing(desk, name)),
            Op::Undo => self.on_desk(|desk| desk.step(Editor::undo)),
            Op::Redo => self.on_desk(|desk| desk.step(Editor::redo)),
            Op::Finish { at } => self.on_desk(|desk| desk.finish_at(at)),
            Op::Program { name } => self.on_desk(|desk| self.write_program(desk, &name)),
        }
    }

    /// Changes what lies on the desk, and tells everybody.
    fn on_desk(&self, change: impl FnOnce(&mut Desk) -> Done) -> Done {
        let mut desk = lock(&self.desk);
        let notes = change(&mut desk)?;
        desk.notes.clone_from(&notes);
        let drawing = Some(desk.state(&self.heights()));
        self.hub.change(vec![Change::Drawing { drawing }]);
        drop(desk);
        self.drawn();
        Ok(notes)
    }

    /// Draws a shape that was not drawn at a page.
    ///
    /// # Errors
    /// Why it cannot be drawn.
    pub fn draw_shape(self: &Arc<Self>, operation: Operation) -> Result<(), Problem> {
        self.on_desk(|desk| self.carry_out(desk, &[(1, operation)])).map(drop)
    }

    /// The heights that the machine is set to.
    pub fn heights(&self) -> Heights {
        let zpos = lock(&self.left).session.machine_is.zpos;
        let (top_mm, surface_mm, bottom_mm) = (zpos.top_mm, zpos.surface_mm, zpos.bottom_mm);
        Heights { top_mm, surface_mm, bottom_mm }
    }

    /// What is done to shapes before paths are made of them.
    pub fn shaping(&self) -> Shaping {
        let Configuration { program, options, .. } = lock(&self.left).session.configuration();
        Shaping { factor: program.smoothing.factor, filter_mm: options.filter_mm }
    }

    pub(crate) fn begin(
        &self,
        desk: &mut Desk,
        drawing: Drawing,
        name: Option<String>,
        notes: Vec<String>,
    ) -> Vec<String> {
        let join_mm = lock(&self.left).session.machine_is.options.join_mm;
        desk.begin(drawing, name, join_mm);
        notes
    }

    fn carry_out(&self, desk: &mut Desk, operations: &[(usize, Operation)]) -> Done {
        let before = desk.editor.join_mm;
        let notes = desk.carry_out(operations)?;
        if desk.editor.join_mm.to_bits() != before.to_bits() {
            self.keep_join(desk.editor.join_mm);
        }
        Ok(notes)
    }

    /// Reads a drawing that is to be opened; one that is still being read is given up.
    fn read_to_open(&self, name: &str) -> Result<(Imported, Option<Point2>), Problem> {
        let reading = self.reading.begin();
        Ok((self.read_drawing_until(name, &|| reading.is_given_up())?, self.finish_of(name)?))
    }

    fn open_drawing(
        &self,
        desk: &mut Desk,
        name: String,
        (read, finish): (Imported, Option<Point2>),
    ) -> Vec<String> {
        let notes = read.findings.into_iter().map(|found| found.text).collect();
        let notes = self.begin(desk, read.drawing, Some(name), notes);
        desk.finish = finish;
        notes
    }

    /// Where the head goes at the end of a job in a file; at its origin where it says nothing.
    fn finish_of(&self, name: &str) -> Result<Option<Point2>, Problem> {
        let is_job = extension(name) == "rsm";
        let job = is_job.then(|| self.parts.read(name)).transpose()?;
        Ok(job.and_then(|bytes| kerf_toolpath::read(&bytes).0.finish))
    }

    pub(crate) fn read_drawing(&self, name: &str) -> Result<Imported, Problem> {
        self.read_drawing_until(name, &|| false)
    }

    fn read_drawing_until(
        &self,
        name: &str,
        given_up: &dyn Fn() -> bool,
    ) -> Result<Imported, Problem> {
        let read = |bytes: &[u8]| match extension(name).as_str() {
            "dxf" => {
                let options = dxf::Options { scale: true, explode: true, ..Default::default() };
                Some(dxf::read_until(bytes, &options, given_up))
            }
            "rsg" => Some(rsg::read_until(bytes, given_up)),
            "rsm" => Some(rsg::read_with(bytes).0),
            "svg" => Some(svg::read_until(bytes, given_up)),
            _ => None,
        };
        let bytes = self.parts.read(name)?;
        let read = read(&bytes)
            .ok_or_else(|| problem(Why::File, "a drawing is .dxf, .svg, .rsg or .rsm"))?;
        reading::whole(name, read)
    }

    /// The operations of clauses, with what the files of the part folder hold that they name.
    fn operations(&self, clauses: &str) -> Result<Vec<(usize, Operation)>, Problem> {
        let read = script(clauses).map_err(|error| problem(Why::Mistake, error.to_string()))?;
        let with_file = |(number, operation): (usize, Operation)| {
            let Some(file) = operation.file().map(str::to_owned) else {
                return Ok((number, operation));
            };
            let Imported { drawing, .. } = self.read_drawing(&file)?;
            Ok((number, operation.with_file(drawing)))
        };
        read.into_iter().map(with_file).collect()
    }

    fn save_drawing(&self, desk: &mut Desk, name: String) -> Done {
        let drawing = &desk.editor.drawing;
        let text = match extension(&name).as_str() {
            "rsg" => rsg::write(drawing),
            "dxf" => dxf::write(drawing),
            "svg" => svg::write(drawing),
            _ => return Err(problem(Why::File, "a drawing is written as .rsg, .dxf or .svg")),
        };
        self.parts.write(&name, text.as_bytes())?;
        desk.saved = desk.editor.drawing.clone();
        desk.name = Some(name);
        self.files_changed();
        Ok(Vec::new())
    }

    /// Writes the part program of the drawing's tool paths, and opens it.
    fn write_program(self: &Arc<Self>, desk: &Desk, name: &str) -> Done {
        self.nothing_unsaved()?;
        let (job, warnings) = job(&desk.editor.drawing, self.shaping())?;
        let job = Job { finish: desk.finish, ..job };
        let title = Some(format!("Made from {}", desk.name.as_deref().unwrap_or("a drawing")));
        // In the unit that the machine is set to: a part file of the other one refuses to run.
        let inches = self.hub.read(|now| now.units.linear == LinearUnit::Inch.symbol());
        let unit = if inches { LinearUnit::Inch } else { LinearUnit::Mm };
        let printing = Printing { unit, title: title.clone(), ..Printing::default() };
        let writing = Writing { unit, title, ..Writing::default() };
        let mut printer: Box<dyn Printer> = match extension(name).as_str() {
            "sbp" => Box::new(SbpPrinter::new(&printing)),
            "nc" => Box::new(Writer::new(&writing)),
            _ => return Err(problem(Why::File, "a program is written as .sbp or .nc")),
        };
        kerf_toolpath::print(&job, &self.heights(), printer.as_mut()).map_err(|wrong| {
            let all: Vec<_> = wrong.iter().map(ToString::to_string).collect();
            problem(Why::Mistake, all.join("; "))
        })?;
        self.parts.write(name, printer.finish().text.as_bytes())?;
        self.files_changed();
        self.open_file(name)?;
        Ok(warnings)
    }
}

impl Desk {
    fn begin(&mut self, drawing: Drawing, name: Option<String>, join_mm: f64) {
        self.saved = drawing.clone();
        self.editor = Editor::of(drawing);
        self.editor.join_mm = join_mm;
        (self.name, self.open) = (name, true);
        self.finish = None;
        self.revision += 1;
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
        Ok(outcomes.into_iter().flat_map(|outcome| outcome.warnings).collect())
    }

    fn step(&mut self, step: fn(&mut Editor) -> Result<(), kerf_drawing::OpError>) -> Done {
        step(&mut self.editor).map_err(|error| problem(Why::State, error.to_string()))?;
        self.revision += 1;
        Ok(Vec::new())
    }
}

/// The job of a drawing, and what was noticed.
///
/// # Errors
/// Its arrays are out of all bounds.
pub(crate) fn job(drawing: &Drawing, shaping: Shaping) -> Result<(Job, Vec<String>), Problem> {
    let made = shaped_job(drawing, shaping);
    let (job, warnings) = made.map_err(|error| problem(Why::Mistake, error.to_string()))?;
    Ok((job, warnings.iter().map(ToString::to_string).collect()))
}

/// The extension of a name, in small letters.
pub fn extension(name: &str) -> String {
    name.rsplit_once('.').map(|(_, extension)| extension.to_ascii_lowercase()).unwrap_or_default()
}
