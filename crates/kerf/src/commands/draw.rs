//! `kerf draw`: drawings opened, changed and written from a terminal.

use crate::drawings;
use crate::exit::{Exit, Usage};
use crate::out;
use crate::outputs::{ForceArgs, Outputs};
use crate::parse;
use anyhow::{Result, anyhow, bail};
use clap::Args;
use kerf_drawing::{ENTRIES, Editor, Group, Kind, Operation, Shape, script};
use kerf_program::settings::LinearUnit;
use serde_json::{Value, json};
use std::path::{Path, PathBuf};

/// Opens drawings, changes them and writes them
///
/// Several drawings are put on top of each other, in order. Operations act on the selected shapes;
/// they are carried out in order, and a mistake in one of them leaves no output file.
#[derive(Args)]
#[command(after_help = help())]
pub struct DrawArgs {
    /// The drawings: .dxf, .svg or .rsg, or programs, .nc or .sbp, as they cut; none begins an empty one
    files: Vec<PathBuf>,
    /// Operations, divided by semicolons
    #[arg(long = "do", value_name = "OP; OP; …")]
    operations: Option<String>,
    /// The drawing to write: .rsg, .dxf or .svg; .rsm when the paths of an .rsm are changed by hand
    #[arg(short, long, value_name = "OUT")]
    output: Option<PathBuf>,
    /// Prints the shapes as JSON, one a line
    #[arg(long)]
    list: bool,
    /// Puts the shapes of each layer into a group of their own, in the order of the file
    #[arg(long)]
    layers: bool,
    /// Reads a unit of the drawing as a millimetre, whatever the file says
    #[arg(long)]
    unscaled: bool,
    /// Counts the blocks that are placed in the drawing instead of drawing what they hold
    #[arg(long)]
    no_blocks: bool,
    /// Draws also what a .dxf hides: layers that are off or frozen, what is invisible
    #[arg(long)]
    hidden: bool,
    /// Units in which programs are followed, in or mm [default: as they are run; in for part files that do, else mm]
    #[arg(long, value_name = "UNIT", value_parser = parse::units)]
    units: Option<LinearUnit>,
    #[command(flatten)]
    force: ForceArgs,
}

impl DrawArgs {
    /// The files that it writes.
    pub fn outputs(&self) -> Outputs {
        Outputs::of(self.output.as_deref(), self.force.force, None)
    }
}

/// Writes the text below the options: every operation, from the table.
fn help() -> String {
    let mut text = String::from("Operations:\n");
    for entry in ENTRIES {
        let form = entry.form.split_whitespace().collect::<Vec<_>>().join(" ");
        text += &format!("  {form}\n      {}\n", entry.doc);
    }
    let groups: Vec<_> = Group::ALL.iter().map(|group| group.name()).collect();
    text += &format!("\nGroups, in order: {}\n", groups.join(" "));
    text + "\nExample: kerf draw part.dxf --do \"select all; rotate 30 about 0,0; group red\" -o part.rsg\n\n\
            Exit codes: 0 done, 1 failed, 2 the command line was wrong"
}

pub fn run(args: &DrawArgs) -> Result<Exit> {
    if args.output.is_none() && !args.list {
        let proposed = args.files.first().map(|file| file.with_extension("rsg"));
        let proposed = proposed.map_or_else(String::new, |file| format!(" {}", file.display()));
        bail!(Usage(format!(
            "nothing to do with the drawing: name an output with -o{proposed}, or --list"
        )));
    }
    if let (Some(output), [file]) = (&args.output, args.files.as_slice())
        && [output.as_path(), file].iter().all(|it| drawings::is_job(it))
    {
        return edit_job(args, file, output);
    }
    let reading = drawings::Reading {
        layers: args.layers,
        scale: !args.unscaled,
        explode: !args.no_blocks,
        hidden: args.hidden,
        units: args.units,
    };
    let mut editor = Editor::of(drawings::open(&args.files, &reading)?);
    if let Some(text) = &args.operations {
        carry_out(&mut editor, text, &reading)?;
    }
    if let Some(output) = &args.output {
        drawings::write(&editor.drawing, output)?;
    }
    if args.list {
        list(&editor);
    }
    Ok(Exit::Good)
}

/// Changes the paths of a job by hand.
fn edit_job(args: &DrawArgs, file: &Path, output: &Path) -> Result<Exit> {
    let job = drawings::job_to_edit(file)?;
    let mut editor = Editor::of(job.as_drawing());
    let reading = drawings::Reading::default();
    carry_out(&mut editor, args.operations.as_deref().unwrap_or_default(), &reading)?;
    drawings::write_edited(job, &editor.drawing, output)?;
    if args.list {
        list(&editor);
    }
    Ok(Exit::Good)
}

fn carry_out(editor: &mut Editor, text: &str, reading: &drawings::Reading) -> Result<()> {
    for (number, operation) in script(text)? {
        let clause = format!("clause {number} `{operation}`");
        // A file that a clause names is no matter of the command line.
        let operation =
            with_file(operation, reading).map_err(|why| anyhow!("{clause}: {why:#}"))?;
        let outcome = editor.apply(&operation).map_err(|error| told(number, &operation, &error))?;
        for told in outcome.warnings.iter().chain(&outcome.notes) {
            eprintln!("clause {number} `{operation}`: {told}");
        }
    }
    Ok(())
}

/// An operation with what its file holds, where it names one.
fn with_file(operation: Operation, reading: &drawings::Reading) -> Result<Operation> {
    let Some(file) = operation.file().map(PathBuf::from) else { return Ok(operation) };
    if !drawings::is_loadable(&file) {
        bail!("{}: the clipboard takes .dxf, .svg, .rsg and .rsm files", file.display());
    }
    Ok(operation.with_file(drawings::open(&[file], reading)?))
}

fn told(number: usize, operation: &Operation, why: &impl std::fmt::Display) -> anyhow::Error {
    anyhow!("clause {number} `{operation}`: {why}")
}

/// The shapes, each with its place in the order that is being picked.
fn list(editor: &Editor) {
    let drawing = &editor.drawing;
    let picked = editor.picks.shapes(drawing);
    let pick = |n: usize| picked.iter().position(|it| *it == n).map(|at| at + 1);
    let lines = drawing.shapes.iter().enumerate().map(|(n, shape)| line(n + 1, shape, pick(n)));
    out::print(&lines.map(|line| line.to_string() + "\n").collect::<String>());
}

/// A shape as `kerf draw --list` prints it.
fn line(number: usize, shape: &Shape, pick: Option<usize>) -> Value {
    let path = &shape.path;
    let points: Vec<_> = path.vertices.iter().map(|v| [v.at.x, v.at.y, v.bulge]).collect();
    let bounds = path.bounds();
    let kind = match shape.kind() {
        Kind::Point => "point",
        Kind::Polyarc => "polyarc",
    };
    let mut value = json!({
        "n": number,
        "group": shape.group.name(),
        "kind": kind,
        "closed": shape.is_closed(),
        "points": points,
        "z": shape.z_mm,
        "length": path.length(),
        "area": if shape.is_closed() { path.signed_area() } else { 0.0 },
        "bounds": { "min": bounds.min, "max": bounds.max },
        "pause": shape.pause,
    });
    if let Some(pick) = pick {
        value["pick"] = pick.into();
    }
    value
}
