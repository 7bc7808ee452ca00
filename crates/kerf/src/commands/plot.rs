//! `kerf plot`: speed, acceleration and jerk of a run.

use crate::args::RunArgs;
use crate::curves::Curves;
use crate::exit::{Exit, Usage};
use crate::outputs::{ForceArgs, Outputs};
use crate::picture_format::PictureFormat;
use crate::report::Diagnostics;
use crate::{out, parse, setup};
use anyhow::{Result, bail};
use clap::{Args, ValueEnum};
use kerf_control::RunContext;
use kerf_preview::plot::{Plot, Sides};
use kerf_program::Axis;
use std::path::PathBuf;

/// Plots speed, acceleration and jerk of a run, over time and along the path
///
/// The curves are samples of the plan that a run follows, 1,000 a second. The programmed speed
/// stands beside the planned one; lines, tool paths, jogs and waits are marked.
#[derive(Args)]
#[command(after_help = "Examples:
  kerf plot box.sbp -o speed.svg
  kerf plot box.sbp -o corner.png --axes xy --from 2 --to 3 --over time")]
pub struct PlotArgs {
    /// The part file
    file: PathBuf,
    /// The picture to write: .svg or .png
    #[arg(short, long, value_name = "OUT")]
    output: PathBuf,
    /// Curves of these axes, as xy
    #[arg(long, value_name = "LETTERS", value_parser = parse::axes)]
    axes: Option<std::vec::Vec<Axis>>,
    /// What runs along the lower edge
    #[arg(long, value_enum, default_value = "both")]
    over: Abscissa,
    /// Begins at a time in seconds
    #[arg(long, value_name = "SECONDS", value_parser = parse::not_negative, default_value = "0")]
    from: f64,
    /// Ends at a time in seconds
    #[arg(long, value_name = "SECONDS", value_parser = parse::not_negative)]
    to: Option<f64>,
    /// Width of a .png
    #[arg(long, value_name = "PIXELS", default_value_t = 2400)]
    pixels: u32,
    #[command(flatten)]
    run: RunArgs,
    #[command(flatten)]
    force: ForceArgs,
}

impl PlotArgs {
    /// The files that it writes.
    pub fn outputs(&self) -> Outputs {
        Outputs::of([self.output.as_path()], self.force.force, Some(&self.run.place.data))
    }
}

/// What runs along the lower edge.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum Abscissa {
    Time,
    Path,
    Both,
}

pub fn run(args: &PlotArgs) -> Result<Exit> {
    let format =
        PictureFormat::of(&args.output, "plots", &[PictureFormat::Svg, PictureFormat::Png])?;
    let window = [args.from, args.to.unwrap_or(f64::INFINITY)];
    if window[1] <= window[0] {
        bail!(Usage("--to must be later than --from".into()));
    }
    let mut job = setup::prepare(&args.file, &args.run, true)?;
    let title = args.file.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let (axes, settings) = (args.axes.as_deref(), &job.session.memory.settings);
    let curves = Curves::new(title, axes.unwrap_or_default(), window, settings);
    let mut sink = (Diagnostics::default(), curves);
    let mut pace = args.run.operator.script();
    let context = RunContext {
        sink: &mut sink,
        operator: &mut job.answers,
        requests: &mut pace,
        machine: kerf_control::simulated(),
    };
    let summary = job.session.run(job.work, job.options, &mut job.workspace, context);
    write(&sink.1.plot, format, args)?;
    Ok(summary.status.into())
}

fn write(plot: &Plot, format: PictureFormat, args: &PlotArgs) -> Result<()> {
    let sides = match args.over {
        Abscissa::Time => Sides::Time,
        Abscissa::Path => Sides::Path,
        Abscissa::Both => Sides::Both,
    };
    let bytes = match format {
        PictureFormat::Svg => plot.svg(sides).into_bytes(),
        _ => plot.png(sides, args.pixels)?,
    };
    out::file(&args.output, bytes)
}
