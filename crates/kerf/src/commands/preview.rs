//! `kerf preview`: a picture of the tool path.

use crate::args::RunArgs;
use crate::exit::Exit;
use crate::picture::{self, Format, Picture};
use crate::report::Diagnostics;
use crate::setup;
use anyhow::Result;
use clap::Args;
use kerf_control::Company;
use std::path::PathBuf;

/// Draws the tool path of a part file
///
/// The extension of the picture says which kind: .svg, .png, or .html for a page that turns in 3D.
/// What the run finds is told and listed in the picture.
#[derive(Args)]
#[command(after_help = "Example: kerf preview box.sbp -o box.html")]
pub struct PreviewArgs {
    /// The part file
    file: PathBuf,
    /// The picture to write: .svg, .png or .html
    #[arg(short, long, value_name = "OUT")]
    output: PathBuf,
    #[command(flatten)]
    run: RunArgs,
}

pub fn run(args: &PreviewArgs) -> Result<Exit> {
    let format = Format::of(&args.output)?;
    let mut job = setup::job(&args.file, &args.run, true)?;
    let mut sink = (Diagnostics::default(), Picture::new(&args.file));
    let mut pace = args.run.operator.script();
    let company = Company { sink: &mut sink, operator: &mut job.answers, pace: &mut pace };
    let summary = job.session.run(job.work, job.options, &mut job.shelf, company);
    let scene = sink.1.finish(&summary, &job.session);
    picture::write(&scene, format, &args.output)?;
    Ok(summary.status.into())
}
