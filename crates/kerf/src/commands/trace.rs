//! `kerf trace`: everything a run would do, an event a line.

use crate::args::RunArgs;
use crate::exit::Exit;
use crate::waveforms::VcdArgs;
use crate::{out, setup};
use anyhow::{Context, Result};
use clap::Args;
use kerf_control::RunContext;
use kerf_trace::json::JsonLines;
use std::io::{self, BufWriter};
use std::path::PathBuf;

/// Prints every event of a run as JSON, one a line
///
/// The file runs as a preview on the simulated machine: nothing outside changes. Times are seconds of
/// machine time, locations are working locations in the program's units.
#[derive(Args)]
#[command(after_help = "Example: kerf trace box.sbp | grep '\"e\":\"move\"'")]
pub struct TraceArgs {
    /// The part file
    file: PathBuf,
    /// Prints the user's variables at the end
    #[arg(long)]
    vars: bool,
    #[command(flatten)]
    vcd: VcdArgs,
    #[command(flatten)]
    run: RunArgs,
}

pub fn run(args: &TraceArgs) -> Result<Exit> {
    let mut job = setup::prepare(&args.file, &args.run, true)?;
    job.options.tell_variables = args.vars;
    let machine = VcdArgs::machine(&job.work, &job.session);
    let lines = JsonLines::new(BufWriter::with_capacity(1 << 16, io::stdout().lock()));
    let mut sink = (lines, args.vcd.sink(machine, None)?);
    let mut pace = args.run.operator.script();
    let context = RunContext {
        sink: &mut sink,
        operator: &mut job.answers,
        requests: &mut pace,
        machine: kerf_control::simulated(),
    };
    let summary = job.session.run(job.work, job.options, &mut job.workspace, context);
    let (lines, signals) = sink;
    args.vcd.finish(signals)?;
    out::unless_gone(lines.finish()).context("cannot write the trace")?;
    Ok(summary.status.into())
}
