//! A job followed as in a preview: times from the plan, and what a picture shows.

use super::ToolpathArgs;
use crate::picture::Picture;
use crate::report::Diagnostics;
use crate::{drawings, setup};
use anyhow::Result;
use kerf_control::{Company, Tally};
use kerf_preview::Scene;
use kerf_toolpath::{Heights, Job};
use std::path::Path;

/// What was seen on the way.
pub struct DryRun {
    pub scene: Scene,
    pub tally: Tally,
    /// Time of the whole, seconds.
    pub seconds: f64,
}

/// Runs the program of a job in preview, as `kerf time` and `kerf preview` do.
pub fn follow(args: &ToolpathArgs, job: &Job, heights: &Heights) -> Result<DryRun> {
    let text = drawings::part_program(&args.drawing, job, heights)?.text;
    let program = kerf_part::read(args.drawing.display().to_string().into(), text.into_bytes());
    let shelf =
        setup::shelf(args.drawing.parent().unwrap_or(Path::new("")), &args.run.place, true)?;
    let mut run = args.run.clone();
    // The program of a job is written in millimetres.
    run.units = run.units.or(Some(kerf_program::settings::LinearUnit::Mm));
    let mut prepared = setup::job_of(program, shelf, &run, true)?;
    let mut sink = (Diagnostics::default(), Picture::new(&args.drawing));
    let mut pace = run.operator.script();
    let company = Company { sink: &mut sink, operator: &mut prepared.answers, pace: &mut pace };
    let session = &mut prepared.session;
    let summary = session.run(prepared.work, prepared.options, &mut prepared.shelf, company);
    let (seconds, tally) = (summary.seconds, summary.tally.clone());
    Ok(DryRun { scene: sink.1.finish(&summary, session), tally, seconds })
}
