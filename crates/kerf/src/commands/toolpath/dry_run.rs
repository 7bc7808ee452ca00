//! A job followed as in a preview: times from the plan, and what a picture shows.

use super::ToolpathArgs;
use crate::picture::Picture;
use crate::setup;
use anyhow::Result;
use kerf_journal::Work;
use kerf_preview::Scene;
use kerf_trace::Summary;
use std::path::Path;

/// Result of a dry run.
pub struct DryRun {
    pub scene: Scene,
    pub summary: Summary,
}

/// Runs what is written in preview, as `kerf time` and `kerf preview` do: the job itself, or the part
/// program made of it.
pub fn follow(args: &ToolpathArgs, work: Work) -> Result<DryRun> {
    let parts = args.drawing.parent().unwrap_or(Path::new(""));
    let workspace = setup::workspace(parts, &args.run.place, true)?;
    let mut run = args.run.clone();
    // The program of a job is written in millimetres, whatever the one was that it was made of.
    run.units = Some(kerf_program::settings::LinearUnit::Mm);
    if let Work::Part(_) = work {
        // Its paths are smooth already.
        run.motion.smoothing = None;
    }
    let prepared = setup::job_of(work, workspace, &run, true)?;
    let (scene, summary) = Picture::follow(prepared, &args.drawing, &run.operator);
    Ok(DryRun { scene, summary })
}
