//! `kerf toolpath`: from a drawing to what is cut.

mod dry_run;
mod report;

use crate::args::{Format, RunArgs};
use crate::coloured::{Colours, coloured};
use crate::exit::{Exit, Usage};
use crate::picture::{self, Format as Picture};
use crate::{drawings, out, parse};
use anyhow::{Result, bail};
use clap::Args;
use kerf_geom::{Bounds2, Point2};
use kerf_program::Smoothing;
use kerf_program::Written;
use kerf_toolpath::{Heights, Job, Warning, off_table, write};
use std::path::{Path, PathBuf};

/// Makes the tool paths of a drawing: offsets, tags, leads, arrays
///
/// What cannot be cut as it is drawn is told with the number of its shape.
#[derive(Args)]
#[command(after_help = "Examples:\n  kerf toolpath plate.rsg -o plate.rsm --report\n  \
    kerf toolpath plate.rsg -o plate.png --colours direction")]
pub struct ToolpathArgs {
    /// The drawing: .rsg or .dxf, or a job that was made before: .rsm
    drawing: PathBuf,
    /// The job to write, .rsm, a part program, .sbp or .nc, or a picture, .svg or .png [default: the
    /// drawing's name with .rsm]
    #[arg(short, long, value_name = "OUT")]
    output: Option<PathBuf>,
    /// Tells paths, lengths, tool and time of each group; the time is that of the plan
    #[arg(long)]
    report: bool,
    /// The report as text for people or JSON for programs
    #[arg(long, value_enum, default_value = "text")]
    format: Format,
    /// The colours of a picture
    #[arg(long, value_enum, value_name = "HOW", default_value = "group")]
    colours: Colours,
    /// The table that nothing may leave, mm from the origin [default: that of --config]
    #[arg(long, value_name = "X,Y", value_parser = parse::size)]
    table: Option<[f64; 2]>,
    /// Where the drawing's origin lies on the table, mm from home
    #[arg(long, value_name = "X,Y", value_parser = parse::place, allow_hyphen_values = true)]
    origin: Option<[f64; 2]>,
    /// Where the head goes at the end, mm from the origin
    #[arg(long, value_name = "X,Y", value_parser = parse::place, allow_hyphen_values = true)]
    finish: Option<[f64; 2]>,
    /// The path with which the job begins, from 1
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    begin_with: Option<u32>,
    /// Writes over a job whose paths were changed by hand
    #[arg(long)]
    force: bool,
    #[command(flatten)]
    heights: HeightArgs,
    #[command(flatten)]
    run: Box<RunArgs>,
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
    let smoothing = args.run.motion.smoothing.unwrap_or(Smoothing::default().factor);
    let (job, mut warnings) = drawings::job_with_warnings(&args.drawing, smoothing)?;
    let job = args.placed(job)?;
    if let Some(table) = table(args, &job)? {
        warnings.extend(off_table(&job, &table));
    }
    tell(args, &warnings);
    let pictured = matches!(drawings::extension(&output).as_str(), "svg" | "png");
    let dry =
        (pictured || args.report).then(|| dry_run::follow(args, &job, &heights)).transpose()?;
    match &dry {
        Some(dry) if pictured => {
            let scene = coloured(&dry.scene, &job.drawing, args.colours);
            picture::write(&scene, Picture::of(&output)?, &output)?;
        }
        _ => keep(args, &output, &job, &heights)?,
    }
    if let Some(dry) = dry.filter(|_| args.report) {
        report::tell(&job, &dry.tally, dry.seconds, &warnings, args.format);
    }
    Ok(Exit::Good)
}

impl ToolpathArgs {
    /// The job where it is cut, and where it begins.
    fn placed(&self, mut job: Job) -> Result<Job> {
        let point = |[x, y]: [f64; 2]| Point2::new(x, y);
        job.origin = self.origin.map_or(job.origin, point);
        job.finish = self.finish.map_or(job.finish, point);
        job.start = self.begin_with.map_or(job.start, |first| first as usize);
        if job.start > job.paths.len().max(1) {
            let (start, count) = (job.start, job.paths.len());
            bail!(Usage(format!("--begin-with {start}: the job has {count} paths")));
        }
        Ok(job)
    }
}

/// Writes the job or its program, whole or not at all.
fn keep(args: &ToolpathArgs, output: &Path, job: &Job, heights: &Heights) -> Result<()> {
    if !args.force && args.drawing != output && drawings::is_edited(output) {
        bail!(
            "{}: its paths were changed by hand; --force makes them anew, -o names another file",
            output.display()
        );
    }
    let text = match drawings::extension(output).as_str() {
        "rsm" => write(job),
        "sbp" => told(output, drawings::part_program(&args.drawing, job, heights)?),
        "nc" | "ngc" | "tap" | "gcode" => {
            told(output, drawings::gcode_program(&args.drawing, job, heights)?)
        }
        _ => bail!(Usage(format!(
            "{}: written are .rsm, .sbp, .nc, .svg and .png",
            output.display()
        ))),
    };
    out::file(output, text)
}

/// The text of a program; what it does not say is told.
fn told(output: &Path, written: Written) -> String {
    for lost in &written.lost {
        eprintln!("{}: warning: not written: {}", output.display(), lost.what);
    }
    written.text
}

fn tell(args: &ToolpathArgs, warnings: &[Warning]) {
    for warning in warnings {
        eprintln!("{}: warning: {warning}", args.drawing.display());
    }
}

/// The table in the coordinates of the job, when one is named.
fn table(args: &ToolpathArgs, job: &Job) -> Result<Option<Bounds2>> {
    let corners = match args.table {
        Some([x, y]) => Some((Point2::default(), Point2::new(x, y))),
        None if args.run.place.config.is_some() => {
            let settings = crate::setup::settings(&args.run.place, Default::default())?;
            let (low, high) = (settings.limits.low.0, settings.limits.high.0);
            Some((Point2::new(low[0], low[1]), Point2::new(high[0], high[1])))
        }
        None => None,
    };
    let origin = job.origin - Point2::default();
    Ok(corners.map(|(low, high)| Bounds2::of(low + origin * -1.0, high + origin * -1.0)))
}
