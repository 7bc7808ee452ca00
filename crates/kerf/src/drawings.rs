//! Drawings from files and into files, by extension.

use crate::exit::Usage;
use anyhow::{Context, Result, bail};
use kerf_control::files::{Disk, RealDisk};
use kerf_drawing::{Drawing, Group, Shape};
use kerf_formats::{Imported, Weight, dxf, rsg};
use std::fs;
use std::path::Path;
use std::sync::Arc;

/// How drawings are read.
#[derive(Clone, Copy, Debug)]
pub struct Reading {
    /// Each layer becomes a group.
    pub layers: bool,
    /// The file's own unit is taken into account.
    pub scale: bool,
    /// Blocks are drawn.
    pub explode: bool,
}

/// Opens drawings and puts them on top of each other. What is found in them is told. The settings of
/// groups, arrays and comments are those of the first.
pub fn open(files: &[impl AsRef<Path>], reading: &Reading) -> Result<Drawing> {
    let mut all: Option<Drawing> = None;
    for file in files {
        let read = read(file.as_ref(), reading)?;
        match &mut all {
            None => all = Some(read),
            Some(first) => first.shapes.extend(read.shapes),
        }
    }
    Ok(all.unwrap_or_default())
}

fn read(file: &Path, reading: &Reading) -> Result<Drawing> {
    let extension = extension(file);
    let bytes = match fs::read(file) {
        Ok(bytes) => bytes,
        Err(error) => bail!(Usage(format!("cannot read {}: {error}", file.display()))),
    };
    let options =
        dxf::Options { scale: reading.scale, explode: reading.explode, ..dxf::Options::default() };
    let mut read = match extension.as_str() {
        "dxf" => dxf::read(&bytes, &options),
        "rsg" | "rsm" => rsg::read(&bytes),
        _ => bail!(Usage(format!("{}: a drawing is .dxf, .rsg or .rsm", file.display()))),
    };
    tell(file, &read);
    if reading.layers {
        group_by_layer(file, &mut read);
    }
    if read.drawing.shapes.is_empty() && read.findings.iter().any(|f| f.weight == Weight::Warning) {
        bail!("{}: nothing of a drawing could be read", file.display());
    }
    Ok(read.drawing)
}

fn tell(file: &Path, read: &Imported) {
    for finding in &read.findings {
        let word = match finding.weight {
            Weight::Note => "note",
            Weight::Warning => "warning",
        };
        let line = if finding.line > 0 { format!(":{}", finding.line) } else { String::new() };
        eprintln!("{}{line}: {word}: {}", file.display(), finding.text);
    }
}

/// Eight groups for any number of layers: the ninth layer begins with black again.
fn group_by_layer(file: &Path, read: &mut Imported) {
    for ((name, shapes), group) in read.layers.iter().zip(Group::ALL.into_iter().cycle()) {
        eprintln!("{}: note: layer {name} is group {group}", file.display());
        for shape in shapes {
            let old = &mut read.drawing.shapes[*shape];
            *old = Arc::new(Shape { group, ..old.as_ref().clone() });
        }
    }
}

/// Writes a drawing, whole or not at all.
pub fn write(drawing: &Drawing, file: &Path) -> Result<()> {
    let text = match extension(file).as_str() {
        "rsg" => rsg::write(drawing),
        "dxf" => {
            if loses(drawing) {
                eprintln!(
                    "{}: groups and arrays will not be saved; .rsg keeps them",
                    file.display()
                );
            }
            dxf::write(drawing)
        }
        _ => bail!(Usage(format!("{}: a drawing is written as .rsg or .dxf", file.display()))),
    };
    RealDisk
        .write(file, text.as_bytes())
        .with_context(|| format!("cannot write {}", file.display()))
}

/// Whether a drawing has something that DXF has no place for.
fn loses(drawing: &Drawing) -> bool {
    let plain = Drawing::default();
    let shapes = drawing.shapes.iter().any(|s| s.group != Group::Black || s.pause);
    shapes || drawing.groups != plain.groups || drawing.arrays != plain.arrays
}

fn extension(file: &Path) -> String {
    file.extension().map(|e| e.to_string_lossy().to_ascii_lowercase()).unwrap_or_default()
}
