//! `kerf timing`: which output switches when, beside the motion.

use crate::args::RunArgs;
use crate::exit::Exit;
use crate::outputs::{ForceArgs, Outputs};
use crate::picture_format::PictureFormat;
use crate::report::Diagnostics;
use crate::{out, setup};
use anyhow::Result;
use clap::Args;
use kerf_control::RunContext;
use kerf_preview::timing::{Course, Timing, corners};
use kerf_trace::switching::Lines;
use std::path::PathBuf;

/// Draws the timing of a job or part file: inputs and outputs under the motion
///
/// Everything is taken from a run on the simulated machine; the times are those of the trace.
#[derive(Args)]
#[command(after_help = "Examples:
  kerf timing plate.rsm -o plate.svg
  kerf timing plate.rsm --machine plasma --sheet -20 --input arc@1.62=1 -o arc.svg")]
pub struct TimingArgs {
    /// The job or part file
    file: PathBuf,
    /// The picture to write: .svg or .png; or its data: .json
    #[arg(short, long, value_name = "OUT")]
    output: PathBuf,
    /// The heading [default: the name of the file]
    #[arg(long, value_name = "TEXT")]
    title: Option<String>,
    #[command(flatten)]
    run: RunArgs,
    #[command(flatten)]
    force: ForceArgs,
}

impl TimingArgs {
    /// The files that it writes.
    pub fn outputs(&self) -> Outputs {
        Outputs::of([self.output.as_path()], self.force.force, Some(&self.run.place.data))
    }
}

/// Pixels of a .png.
const PIXELS: u32 = 2400;

/// Returns the content of the diagram as numbers: edges of switches, courses of values, seconds.
fn data(timing: &Timing) -> serde_json::Value {
    let tracks: serde_json::Map<String, serde_json::Value> = timing
        .tracks
        .iter()
        .map(|track| {
            let course = match &track.course {
                Course::Output(edges) | Course::Input(edges) => {
                    serde_json::json!({ "edges": edges })
                }
                Course::Place(points) => serde_json::json!({ "points": points }),
                Course::Value(steps) => serde_json::json!({ "points": corners(steps) }),
            };
            (track.label(), course)
        })
        .collect();
    serde_json::json!({ "title": timing.title, "end": timing.end_s, "tracks": tracks })
}

/// Kinds of file that a switching diagram is written as; as JSON its numbers.
const WRITTEN: [PictureFormat; 3] = [PictureFormat::Svg, PictureFormat::Png, PictureFormat::Json];

pub fn run(args: &TimingArgs) -> Result<Exit> {
    let format = PictureFormat::of(&args.output, "diagrams", &WRITTEN)?;
    let mut job = setup::prepare(&args.file, &args.run, true)?;
    let mut sink = (Diagnostics::default(), Lines::default());
    let mut pace = args.run.operator.script();
    let context = RunContext {
        sink: &mut sink,
        operator: &mut job.answers,
        requests: &mut pace,
        machine: kerf_control::simulated(),
    };
    let summary = job.session.run(job.work, job.options, &mut job.workspace, context);
    let name = || args.file.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let title = args.title.clone().unwrap_or_else(name);
    let timing = sink.1.timing(title);
    let bytes = match format {
        PictureFormat::Json => format!("{}\n", data(&timing)).into_bytes(),
        PictureFormat::Svg => timing.svg().into_bytes(),
        _ => timing.png(PIXELS)?,
    };
    out::file(&args.output, bytes)?;
    Ok(summary.status.into())
}
