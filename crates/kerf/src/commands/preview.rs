//! `kerf preview`: a picture of the tool path.

use crate::args::RunArgs;
use crate::coloured::{Colours, coloured};
use crate::drawings;
use crate::exit::{Exit, Usage};
use crate::outputs::{ForceArgs, Outputs};
use crate::picture::{self, Picture};
use crate::setup;
use anyhow::{Result, bail};
use clap::Args;
use kerf_drawing::Drawing;
use std::path::PathBuf;

/// Draws the tool path of a part file
///
/// The extension of the picture says which kind: .svg, .png, or .html for a page that turns in 3D.
/// Findings of the run are printed, and listed in the picture.
#[derive(Args)]
#[command(after_help = "Example: kerf preview box.sbp -o box.html")]
pub struct PreviewArgs {
    /// The part file
    file: PathBuf,
    /// The picture to write: .svg, .png or .html
    #[arg(short, long, value_name = "OUT")]
    output: PathBuf,
    /// The colours of the cuts [default: group for a drawing or its job, depth for a program]
    #[arg(long, value_enum, value_name = "HOW")]
    colours: Option<Colours>,
    #[command(flatten)]
    run: RunArgs,
    #[command(flatten)]
    force: ForceArgs,
}

impl PreviewArgs {
    /// The files that it writes.
    pub fn outputs(&self) -> Outputs {
        Outputs::of([self.output.as_path()], self.force.force, Some(&self.run.place.data))
    }
}

pub fn run(args: &PreviewArgs) -> Result<Exit> {
    let format = picture::format_of(&args.output)?;
    if args.colours == Some(Colours::Group) && !drawings::is_drawing(&args.file) {
        bail!(Usage(format!("{} is a program: it has no groups to colour", args.file.display())));
    }
    let job = setup::prepare(&args.file, &args.run, true)?;
    let drawing = job.drawing.clone();
    let (scene, summary) = Picture::follow(job, &args.file, &args.run.operator);
    let scene = match (&drawing, args.colours) {
        (Some(drawing), how) => coloured(&scene, drawing, how.unwrap_or(Colours::Group)),
        (None, Some(how)) => coloured(&scene, &Drawing::default(), how),
        (None, None) => scene,
    };
    picture::write(&scene, format, &args.output)?;
    Ok(summary.status.into())
}
