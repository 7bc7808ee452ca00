//! The drawing that is open.

use crate::acts::Done;
use crate::app::{App, lock, problem};
use kerf_drawing::{Drawing, Editor, Group, Operation, Shape, script};
use kerf_formats::{Imported, dxf, rsg, svg};
use kerf_gcode::{Writer, Writing};
use kerf_program::Printer;
use kerf_program::settings::LinearUnit;
use kerf_sbp::{Printing, SbpPrinter};
use kerf_toolpath::Heights;
use kerf_wire::{
    Change, CutHeight, DrawingState, GroupState, Op, Problem, ShapeList, ShapePath, Why,
};
use std::sync::Arc;

/// An editor and where its drawing lies.
#[derive(Default)]
pub struct Desk {
    editor: Editor,
    name: Option<String>,
    /// Grows with every change.
    revision: u32,
    /// The drawing as it was opened or saved.
    saved: Drawing,
    open: bool,
    notes: Vec<String>,
}

impl App {
    /// Changes the drawing.
    ///
    /// # Errors
    /// Why it stays as it was.
    pub fn draw(self: &Arc<Self>, op: Op) -> Done {
        let mut desk = lock(&self.desk);
        let notes = match op {
            Op::New => desk.begin(Drawing::default(), None, Vec::new()),
            Op::Open { name } => self.open_drawing(&mut desk, name)?,
            Op::Save { name } => self.save_drawing(&mut desk, name)?,
            Op::Do { clauses } => desk.carry_out(&self.operations(&clauses)?)?,
            Op::Undo => desk.step(Editor::undo)?,
            Op::Redo => desk.step(Editor::redo)?,
            Op::Program { name } => self.write_program(&desk, &name)?,
        };
        desk.notes.clone_from(&notes);
        self.hub.change(vec![Change::Drawing { drawing: Some(desk.state()) }]);
        Ok(notes)
    }

    fn open_drawing(&self, desk: &mut Desk, name: String) -> Done {
        let Imported { drawing, findings, .. } = self.read_drawing(&name)?;
        let notes = findings.into_iter().map(|found| found.text).collect();
        Ok(desk.begin(drawing, Some(name), notes))
    }

    fn read_drawing(&self, name: &str) -> Result<Imported, Problem> {
        let read = |bytes: &[u8]| match extension(name).as_str() {
            "dxf" => {
                let options = dxf::Options { scale: true, explode: true, ..Default::default() };
                Some(dxf::read(bytes, &options))
            }
            "rsg" | "rsm" => Some(rsg::read(bytes)),
            "svg" => Some(svg::read(bytes)),
            _ => None,
        };
        let bytes = self.parts.read(name)?;
        read(&bytes).ok_or_else(|| problem(Why::File, "a drawing is .dxf, .svg, .rsg or .rsm"))
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
        let (job, warnings) = desk.job()?;
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
        kerf_toolpath::print(&job, &Heights::default(), printer.as_mut()).map_err(|wrong| {
            let all: Vec<_> = wrong.iter().map(ToString::to_string).collect();
            problem(Why::Mistake, all.join("; "))
        })?;
        self.parts.write(name, printer.finish().text.as_bytes())?;
        self.files_changed();
        self.open_file(name)?;
        Ok(warnings)
    }

    /// The shapes of the drawing.
    pub fn shapes(&self) -> ShapeList {
        let desk = lock(&self.desk);
        let shapes = desk.editor.drawing.shapes.iter().zip(1..);
        ShapeList {
            revision: desk.revision,
            shapes: shapes.map(|(shape, number)| shape_path(shape, number)).collect(),
            notes: Vec::new(),
        }
    }

    /// The tool paths of the drawing.
    ///
    /// # Errors
    /// None can be made.
    pub fn tool_paths(&self) -> Result<ShapeList, Problem> {
        let desk = lock(&self.desk);
        let (job, notes) = desk.job()?;
        let paths = job
            .paths
            .iter()
            .map(|path| ShapePath { number: path.from as u32, ..shape_path(&path.shape, 0) });
        Ok(ShapeList { revision: desk.revision, shapes: paths.collect(), notes })
    }
}

impl Desk {
    fn begin(&mut self, drawing: Drawing, name: Option<String>, notes: Vec<String>) -> Vec<String> {
        self.saved = drawing.clone();
        self.editor = Editor::of(drawing);
        (self.name, self.open) = (name, true);
        self.revision += 1;
        notes
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

    fn job(&self) -> Result<(kerf_toolpath::Job, Vec<String>), Problem> {
        let made = kerf_toolpath::job(&self.editor.drawing);
        let (job, warnings) = made.map_err(|error| problem(Why::Mistake, error.to_string()))?;
        Ok((job, warnings.iter().map(ToString::to_string).collect()))
    }

    fn state(&self) -> DrawingState {
        let editor = &self.editor;
        DrawingState {
            name: self.name.clone(),
            revision: self.revision,
            shapes: editor.drawing.shapes.len() as u32,
            selection: editor.selection.iter().map(|place| *place as u32 + 1).collect(),
            can_undo: editor.can_undo(),
            can_redo: editor.can_redo(),
            changed: editor.drawing != self.saved,
            clipboard: editor.clipboard.len() as u32,
            groups: Group::ALL.map(|group| group_state(&editor.drawing, group)).into(),
            notes: self.notes.clone(),
        }
    }
}

fn group_state(drawing: &Drawing, group: Group) -> GroupState {
    let settings = drawing.settings(group);
    let lead = |lead: kerf_drawing::Lead| [lead.radius_mm, lead.angle_deg];
    GroupState {
        name: group.name().into(),
        on: settings.on,
        traversal: settings.traversal,
        double: settings.double_line,
        tool: settings.tool,
        cut: settings.cut,
        speed: settings.speed_mm_min,
        height: match settings.height {
            kerf_drawing::Height::Thru => CutHeight::Word("thru".into()),
            kerf_drawing::Height::ThreeD => CutHeight::Word("3d".into()),
            kerf_drawing::Height::Mm(mm) => CutHeight::Mm(mm),
        },
        pass: settings.pass_mm,
        offset: settings.offset_mm,
        rough: settings.rough_mm,
        tag: settings.tag_mm,
        lead_in: lead(settings.lead_in),
        lead_out: lead(settings.lead_out),
    }
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

fn extension(name: &str) -> String {
    name.rsplit_once('.').map(|(_, extension)| extension.to_ascii_lowercase()).unwrap_or_default()
}
