//! Drawings from files and into files, by extension.

pub mod programs;

pub use kerf_formats::is_drawing;

use crate::exit::Usage;
use crate::given;
use crate::out;
use anyhow::{Result, anyhow, bail};
use kerf_drawing::{Drawing, Group, Shape};
use kerf_formats::{Content, Finding, Format, Imported, Opening, Weight, dxf, readable, writable};
use kerf_gcode::{Writer, Writing};
use kerf_import::job_file;
use kerf_machine::Configuration;
use kerf_program::settings::LinearUnit;
use kerf_program::{Printer, Written};
use kerf_sbp::{Printing, SbpPrinter};
use kerf_sequence::Speeds;
use kerf_toolpath::{Damaged, DrawnJob, Shaping, Warning};
use std::fs;
use std::path::Path;
use std::sync::Arc;

/// Options of reading drawings.
#[derive(Clone, Copy, Debug)]
pub struct Reading {
    /// Each layer becomes a group.
    pub layers: bool,
    /// The file's own unit is taken into account.
    pub scale: bool,
    /// Blocks are drawn.
    pub explode: bool,
    /// Hidden parts of a .dxf are drawn.
    pub hidden: bool,
    /// The unit in which programs are followed; nothing for what is usual.
    pub units: Option<LinearUnit>,
}

impl Default for Reading {
    fn default() -> Self {
        Self { layers: false, scale: true, explode: true, hidden: false, units: None }
    }
}

/// Opens drawings and puts them on top of each other. What is found in them is told. The settings of
/// groups, arrays and comments are those of the first.
pub fn open(files: &[impl AsRef<Path>], reading: &Reading) -> Result<Drawing> {
    let mut all: Option<Drawing> = None;
    for file in files {
        let read = read(file.as_ref(), reading)?;
        match &mut all {
            None => all = Some(read),
            Some(first) => {
                let before = first.shapes.len();
                first.shapes.extend(read.shapes);
                tell_heights(file.as_ref(), first, before);
            }
        }
    }
    Ok(all.unwrap_or_default())
}

fn read(file: &Path, reading: &Reading) -> Result<Drawing> {
    let bytes = given::bytes(file)?;
    let Reading { scale, explode, hidden, .. } = *reading;
    let options = dxf::Options { scale, explode, unseen: hidden, ..dxf::Options::default() };
    let opening = Opening { dxf: options, ..Opening::default() };
    let mut read = match kerf_formats::open(file, &bytes, &opening) {
        Some(read) => read,
        None if programs::is_program(file) => programs::read(file, &bytes, reading.units)?,
        None => bail!(Usage(format!(
            "{}: a drawing is {}, or a program: .nc or .sbp",
            file.display(),
            readable()
        ))),
    };
    tell(file, &read);
    if reading.layers {
        read.drawing.groups = Drawing::default().groups;
        group_by_layer(file, &mut read);
        tell_heights(file, &mut read.drawing, 0);
    }
    if read.drawing.shapes.is_empty() {
        nothing_read(file, &read.findings)?;
    }
    Ok(read.drawing)
}

/// Shapes from a place on that have heights of their own get a group that is 3D, and it is told.
fn tell_heights(file: &Path, drawing: &mut Drawing, from: usize) {
    let all = from..drawing.shapes.len();
    for made in kerf_drawing::heighten(drawing, all) {
        eprintln!("{}: note: {made}", file.display());
    }
}

/// Refuses a file of which nothing is left, where that is not as it should be.
fn nothing_read(file: &Path, findings: &[Finding]) -> Result<()> {
    if findings.iter().any(|finding| finding.weight == Weight::Warning) {
        bail!("{}: nothing of a drawing could be read", file.display());
    }
    if findings.is_empty() {
        eprintln!("{}: warning: nothing is drawn in this file", file.display());
    }
    Ok(())
}

fn tell(file: &Path, read: &Imported) {
    tell_all(file, &read.findings);
}

/// Tells what was noticed while a file was read.
pub fn tell_all(file: &Path, findings: &[Finding]) {
    for finding in findings {
        let word = match finding.weight {
            Weight::Note => "note",
            Weight::Warning => "warning",
        };
        let counted = [finding.line, finding.column].into_iter().take_while(|it| *it > 0);
        let place: String = counted.map(|it| format!(":{it}")).collect();
        eprintln!("{}{place}: {word}: {}", file.display(), finding.text);
    }
}

/// A layer named as a group is that group; the others get those that are left, in the order of the file. Eight
/// groups are for any number of layers: when none is left, they begin with black again.
fn group_by_layer(file: &Path, read: &mut Imported) {
    let named: Vec<Group> = read.layers.iter().filter_map(|(name, _)| Group::named(name)).collect();
    let left: Vec<Group> = Group::ALL.into_iter().filter(|it| !named.contains(it)).collect();
    let left = if left.is_empty() { Group::ALL.to_vec() } else { left };
    let mut left = left.into_iter().cycle();
    for (name, shapes) in &read.layers {
        let Some(group) = Group::named(name).or_else(|| left.next()) else { continue };
        eprintln!("{}: note: layer {name} is group {group}", file.display());
        for shape in shapes {
            let old = &mut read.drawing.shapes[*shape];
            *old = Arc::new(Shape { group, ..old.as_ref().clone() });
        }
    }
}

/// The job in a file: the one of an RSM, or the one that is made of a drawing, shaped like that. What is
/// noticed is told.
pub fn job(file: &Path, shaping: Shaping) -> Result<DrawnJob> {
    let (job, warnings) = job_with_warnings(file, shaping, None)?;
    for warning in &warnings {
        eprintln!("{}: warning: {warning}", file.display());
    }
    Ok(job)
}

/// The same, with what was noticed while the tool paths were made; programs are followed in a unit.
pub fn job_with_warnings(
    file: &Path,
    shaping: Shaping,
    units: Option<LinearUnit>,
) -> Result<(DrawnJob, Vec<Warning>)> {
    if is_job(file) {
        let (job, findings) =
            job_file::read(&given::bytes(file)?, shaping.factor).map_err(of_file(file))?;
        tell_all(file, &findings);
        if job.paths.is_empty() {
            nothing_read(file, &findings)?;
        }
        return Ok((job, Vec::new()));
    }
    let reading = Reading { units, ..Reading::default() };
    Ok(kerf_toolpath::shaped_job(&open(&[file], &reading)?, shaping)?)
}

/// A job that cannot be cut as it is, with the name of its file.
#[derive(Debug, thiserror::Error)]
#[error("{0}: {1}")]
pub struct DamagedFile(pub String, pub Damaged);

fn of_file(file: &Path) -> impl Fn(Damaged) -> DamagedFile {
    move |damaged| DamagedFile(file.display().to_string(), damaged)
}

/// A job as a part program of OpenSBP, millimetres, as a machine cuts it.
pub fn part_program(file: &Path, job: &DrawnJob, machine: &Configuration) -> Result<Written> {
    let printing = Printing {
        unit: LinearUnit::Mm,
        title: Some(format!("Made from {}", name(file))),
        ..Printing::default()
    };
    print(file, job, machine, Box::new(SbpPrinter::new(&printing)))
}

/// A job as G-code, as a machine cuts it.
pub fn gcode_program(file: &Path, job: &DrawnJob, machine: &Configuration) -> Result<Written> {
    let writing =
        Writing { title: Some(format!("Made from {}", name(file))), ..Writing::default() };
    print(file, job, machine, Box::new(Writer::new(&writing)))
}

fn print(
    file: &Path,
    job: &DrawnJob,
    machine: &Configuration,
    mut printer: Box<dyn Printer + '_>,
) -> Result<Written> {
    let noticed = job_file::print(job, machine, Speeds::Written, printer.as_mut());
    for noticed in noticed.map_err(|wrong| anyhow!("{}: {}", file.display(), wrong.join("\n")))? {
        eprintln!("{}: warning: {noticed}", file.display());
    }
    Ok(printer.finish())
}

fn name(file: &Path) -> String {
    file.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default()
}

/// Writes the paths of a job that were changed by hand.
pub fn write_edited(job: DrawnJob, drawing: &Drawing, file: &Path) -> Result<()> {
    eprintln!(
        "{}: caution: tool paths were changed by hand; making them anew from the drawing loses that",
        file.display()
    );
    out::file(file, kerf_toolpath::write(&job.edited(drawing)))
}

/// The job in a file, to be changed by hand.
pub fn job_to_edit(file: &Path) -> Result<DrawnJob> {
    let (job, read) = kerf_toolpath::read_whole(&given::bytes(file)?).map_err(of_file(file))?;
    tell(file, &read);
    Ok(job)
}

/// Returns `true` if a file is a job.
pub fn is_job(file: &Path) -> bool {
    Format::of_file(file).is_some_and(|format| format.content() == Content::Job)
}

/// Returns `true` if a file is a job that was changed by hand.
pub fn is_edited(file: &Path) -> bool {
    is_job(file) && fs::read(file).is_ok_and(|bytes| kerf_toolpath::read(&bytes).0.edited)
}

/// Returns `true` if the shapes of a file can be put onto the clipboard.
pub fn is_loadable(file: &Path) -> bool {
    Format::of_file(file).is_some_and(Format::is_written)
}

/// Writes a drawing, whole or not at all.
pub fn write(drawing: &Drawing, file: &Path) -> Result<()> {
    let format = Format::of_file(file);
    let Some((format, text)) = format.and_then(|format| Some((format, format.write(drawing)?)))
    else {
        bail!(Usage(format!("{}: a drawing is written as {}", file.display(), writable())))
    };
    if let Some(lost) = format.unkept(drawing) {
        eprintln!("{}: {lost}", file.display());
    }
    out::file(file, text)
}
