//! Drawings and pictures as programs: DXF, SVG, HPGL, RSG, RSM, BMP, JPEG and PNG.

use crate::job_file;
use kerf_drawing::{Drawing, Editor, Operation, Shape};
use kerf_formats::bitmap::{Bitmap, BitmapError};
use kerf_formats::{Content, Finding, Format, Imported, Opening, Weight};
use kerf_geom::{Point2, Vec2};
use kerf_machine::Configuration;
use kerf_program::job::Heights;
use kerf_program::settings::{LinearUnit, MM_PER_INCH};
use kerf_program::{CutChoice, Printer, decimal};
use kerf_sequence::Speeds;
use kerf_toolpath::{DrawnJob, Relief, print_relief};
use std::sync::Arc;
use thiserror::Error;

/// Settings that a file does not hold, given by the person who converts it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drawn {
    /// Depth of the cut, or of the deepest place of a relief, millimetres.
    pub depth_mm: f64,
    /// Height at which the tool travels, millimetres above the surface.
    pub safe_mm: f64,
    /// Factor by which a drawing becomes larger.
    pub scale: f64,
    /// Distance of the first from the last dot of a picture, millimetres; a tenth of a millimetre a dot
    /// when nothing is said.
    pub size: Option<Vec2>,
    /// White is deepest in a relief, not black.
    pub white_deepest: bool,
}

impl Drawn {
    /// Returns the settings for when nothing is said, in round numbers of a unit.
    pub fn usual(unit: LinearUnit) -> Self {
        let (depth_mm, safe_mm) = match unit {
            LinearUnit::Inch => (0.125 * MM_PER_INCH, 0.5 * MM_PER_INCH),
            LinearUnit::Mm => (3.0, 12.0),
        };
        Self { depth_mm, safe_mm, scale: 1.0, size: None, white_deepest: false }
    }

    /// Takes the settings that were chosen.
    pub fn of(cut: CutChoice) -> Self {
        Self {
            depth_mm: cut.depth_mm,
            safe_mm: cut.safe_mm,
            scale: cut.scale.unwrap_or(1.0),
            size: None,
            white_deepest: cut.white_deepest.unwrap_or(false),
        }
    }

    /// As the head of a program tells it.
    pub fn settings_line(&self, kind: &str, unit: LinearUnit) -> String {
        let length = |mm: f64| format!("{} {}", decimal(mm / unit.mm(), 4), unit.symbol());
        let (depth, safe) = (length(self.depth_mm), length(self.safe_mm));
        let more = match (is_picture(kind), self.white_deepest) {
            (true, true) => ", white deepest".to_owned(),
            (true, false) => ", black deepest".to_owned(),
            (false, _) => String::new(),
        };
        let scaled = !is_picture(kind) || self.scale != 1.0;
        let scale = if scaled { format!(", scale {}", self.scale) } else { String::new() };
        format!("Settings: depth {depth}, safe height {safe}{scale}{more}")
    }
}

/// Reason for which a drawing or a picture is no program.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum DrawnError {
    /// Nothing could be read.
    #[error("{0}")]
    Nothing(String),
    /// Things that cannot be cut, a sentence each.
    #[error("{}", .0.join("; "))]
    Uncut(Vec<String>),
    /// A job that is not what it was.
    #[error(transparent)]
    Damaged(#[from] kerf_toolpath::Damaged),
}

/// Millimetres from dot to dot of a picture when nothing is said.
const DOT_MM: f64 = 0.1;

/// The content of files with an ending.
fn content(kind: &str) -> Option<Content> {
    Format::of_ending(kind).map(Format::content)
}

fn is_picture(kind: &str) -> bool {
    content(kind) == Some(Content::Picture)
}

/// Returns the choices that a person has for a kind of file, with their usual values. A job has its own size.
pub fn usual_choice(kind: &str, unit: LinearUnit) -> CutChoice {
    let usual = Drawn::usual(unit);
    CutChoice {
        depth_mm: usual.depth_mm,
        safe_mm: usual.safe_mm,
        scale: (content(kind) != Some(Content::Job)).then_some(usual.scale),
        white_deepest: is_picture(kind).then_some(usual.white_deepest),
    }
}

/// Writes the program of a drawing or a picture, and tells what was noticed.
///
/// # Errors
/// The ending is of neither, there is nothing to cut in the file, or it cannot be cut so.
pub fn print(
    bytes: &[u8],
    kind: &str,
    how: &Drawn,
    printer: &mut dyn Printer,
) -> Result<Vec<Finding>, DrawnError> {
    let format = Format::of_ending(kind);
    let format = format.ok_or_else(|| DrawnError::Nothing(format!("{kind} is no drawing")))?;
    if let Some(dots) = format.picture(bytes) {
        return picture(dots, how, printer);
    }
    let (job, findings) = if format.content() == Content::Job {
        let (job, read) = kerf_toolpath::read_whole(bytes)?;
        (job, read.findings)
    } else {
        job(format.open(bytes, &Opening::default()).unwrap_or_default(), how)?
    };
    let zpos = Heights { top_mm: how.safe_mm, surface_mm: 0.0, bottom_mm: -how.depth_mm };
    let machine = Configuration { zpos, ..Configuration::default() };
    job_file::print(&job, &machine, Speeds::OfRun, printer).map_err(DrawnError::Uncut)?;
    Ok(findings)
}

fn job(read: Imported, how: &Drawn) -> Result<(DrawnJob, Vec<Finding>), DrawnError> {
    let Imported { drawing, mut findings, layers, .. } = read;
    if drawing.shapes.is_empty() {
        let told = findings.iter().map(|finding| finding.text.as_str()).collect::<Vec<_>>();
        let why = if told.is_empty() { "nothing is drawn in it".into() } else { told.join("; ") };
        return Err(DrawnError::Nothing(why));
    }
    let counted = layers.iter().map(|(name, shapes)| format!("{name} ({} shapes)", shapes.len()));
    if !layers.is_empty() {
        findings.push(note(format!("layers: {}", counted.collect::<Vec<_>>().join(", "))));
    }
    let (job, warnings) = kerf_toolpath::job(&scaled(drawing, how.scale)?)
        .map_err(|error| DrawnError::Nothing(error.to_string()))?;
    let warning = |text| Finding::of_file(Weight::Warning, text);
    findings.extend(warnings.iter().map(|told| warning(told.to_string())));
    Ok((job, findings))
}

fn note(text: String) -> Finding {
    Finding::of_file(Weight::Note, text)
}

fn scaled(drawing: Drawing, factor: f64) -> Result<Drawing, DrawnError> {
    if factor == 1.0 {
        return Ok(drawing);
    }
    let mut editor = Editor::of(drawing);
    editor.selection = (0..editor.drawing.shapes.len()).collect();
    let scale = Operation::Scale { factor, about: Point2::default() };
    editor.apply(&scale).map_err(|error| DrawnError::Nothing(error.to_string()))?;
    let deeper = |shape: &Arc<Shape>| {
        let z_mm = shape.z_mm.as_ref().map(|z| z.iter().map(|z| z * factor).collect());
        Arc::new(Shape { z_mm, ..shape.as_ref().clone() })
    };
    let shapes = editor.drawing.shapes.iter().map(deeper).collect();
    Ok(editor.drawing.with_shapes(shapes))
}

fn picture(
    dots: Result<Bitmap, BitmapError>,
    how: &Drawn,
    printer: &mut dyn Printer,
) -> Result<Vec<Finding>, DrawnError> {
    let read = dots.map_err(|error| DrawnError::Nothing(error.to_string()))?;
    let steps = |dots: usize| (dots.max(1) - 1) as f64 * DOT_MM;
    let plain = Vec2::new(steps(read.columns), steps(read.rows));
    let size = how.size.unwrap_or(plain * how.scale);
    let relief = Relief {
        columns: read.columns,
        grey: &read.grey,
        size,
        depth_mm: how.depth_mm,
        white_deepest: how.white_deepest,
        safe_mm: how.safe_mm,
    };
    print_relief(&relief, printer);
    let (columns, rows) = (read.columns, read.rows);
    Ok(vec![note(format!("{columns} x {rows} dots on {:.2} x {:.2} mm", size.x, size.y))])
}
