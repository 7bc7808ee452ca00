//! `kerf toolpath`: from a drawing to what is cut.

use crate::exit::{Exit, Usage};
use crate::{drawings, out};
use anyhow::{Context, Result, bail};
use clap::Args;
use kerf_control::files::{Disk, RealDisk};
use kerf_toolpath::{Job, Pass, job, write};
use std::path::PathBuf;

/// Makes the tool paths of a drawing: offsets, tags, leads, arrays
///
/// What cannot be cut as it is drawn is told with the number of its shape.
#[derive(Args)]
#[command(after_help = "Example: kerf toolpath plate.rsg -o plate.rsm --report")]
pub struct ToolpathArgs {
    /// The drawing: .rsg or .dxf
    drawing: PathBuf,
    /// The job to write [default: the drawing's name with .rsm]
    #[arg(short, long, value_name = "OUT")]
    output: Option<PathBuf>,
    /// Tells how many paths there are and how long they are, group by group
    #[arg(long)]
    report: bool,
}

pub fn run(args: &ToolpathArgs) -> Result<Exit> {
    let output = args.output.clone().unwrap_or_else(|| args.drawing.with_extension("rsm"));
    if output.extension().is_none_or(|extension| !extension.eq_ignore_ascii_case("rsm")) {
        bail!(Usage(format!("{}: a job is written as .rsm", output.display())));
    }
    let reading = drawings::Reading { layers: false, scale: true, explode: true };
    let drawing = drawings::open(std::slice::from_ref(&args.drawing), &reading)?;
    let (job, warnings) = job(&drawing)?;
    for warning in &warnings {
        eprintln!("{}: warning: {warning}", args.drawing.display());
    }
    RealDisk
        .write(&output, write(&job).as_bytes())
        .with_context(|| format!("cannot write {}", output.display()))?;
    if args.report {
        report(&job);
    }
    Ok(Exit::Good)
}

/// A line a group that has paths.
fn report(job: &Job) {
    out::print(&format!("{:<10} {:>6} {:>12}  tool\n", "group", "paths", "length mm"));
    for (group, length) in job.lengths() {
        let of_group = job.paths.iter().filter(|path| path.shape.group == group);
        let count = of_group.filter(|path| path.pass != Pass::Traversal).count();
        if count > 0 {
            let tool = job.drawing.settings(group).tool;
            out::print(&format!("{:<10} {count:>6} {length:>12.1}  {tool}\n", group.name()));
        }
    }
}
