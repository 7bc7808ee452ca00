//! `kerf toolpath`: from a drawing to what is cut.

use crate::exit::{Exit, Usage};
use crate::{drawings, out};
use anyhow::{Context, Result, bail};
use clap::Args;
use kerf_control::files::{Disk, RealDisk};
use kerf_program::Written;
use kerf_toolpath::{Heights, Job, Pass, write};
use std::path::{Path, PathBuf};

/// Makes the tool paths of a drawing: offsets, tags, leads, arrays
///
/// What cannot be cut as it is drawn is told with the number of its shape.
#[derive(Args)]
#[command(after_help = "Example: kerf toolpath plate.rsg -o plate.rsm --report")]
pub struct ToolpathArgs {
    /// The drawing: .rsg or .dxf, or a job that was made before: .rsm
    drawing: PathBuf,
    /// The job to write, .rsm, or a part program, .sbp or .nc [default: the drawing's name with .rsm]
    #[arg(short, long, value_name = "OUT")]
    output: Option<PathBuf>,
    /// Tells how many paths there are and how long they are, group by group
    #[arg(long)]
    report: bool,
    #[command(flatten)]
    heights: HeightArgs,
}

/// Heights of the machine, as Z above its home.
#[derive(Args, Clone, Copy, Debug)]
pub struct HeightArgs {
    /// Where the tool travels
    #[arg(long, value_name = "MM", default_value_t = 10.0, allow_negative_numbers = true)]
    z_top: f64,
    /// The surface of the material; zero of Z in a part program
    #[arg(long, value_name = "MM", default_value_t = 0.0, allow_negative_numbers = true)]
    z_surface: f64,
    /// Where THRU cuts; nothing is cut below it
    #[arg(long, value_name = "MM", default_value_t = -10.0, allow_negative_numbers = true)]
    z_bottom: f64,
}

impl HeightArgs {
    fn heights(self) -> Result<Heights> {
        let Self { z_top, z_surface, z_bottom } = self;
        if !(z_bottom < z_surface && z_surface < z_top) {
            bail!(Usage("Z top must lie above Z surface, and Z bottom below it".into()));
        }
        Ok(Heights { top_mm: z_top, surface_mm: z_surface, bottom_mm: z_bottom })
    }
}

pub fn run(args: &ToolpathArgs) -> Result<Exit> {
    let output = args.output.clone().unwrap_or_else(|| args.drawing.with_extension("rsm"));
    let heights = args.heights.heights()?;
    let job = drawings::job(&args.drawing)?;
    let text = match drawings::extension(&output).as_str() {
        "rsm" => write(&job),
        "sbp" => told(&output, drawings::part_program(&args.drawing, &job, &heights)?),
        "nc" | "ngc" | "tap" | "gcode" => {
            told(&output, drawings::gcode_program(&args.drawing, &job, &heights)?)
        }
        _ => bail!(Usage(format!("{}: written are .rsm, .sbp and .nc", output.display()))),
    };
    RealDisk
        .write(&output, text.as_bytes())
        .with_context(|| format!("cannot write {}", output.display()))?;
    if args.report {
        report(&job);
    }
    Ok(Exit::Good)
}

/// The text of a program; what it does not say is told.
fn told(output: &Path, written: Written) -> String {
    for lost in &written.lost {
        eprintln!("{}: warning: not written: {}", output.display(), lost.what);
    }
    written.text
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
