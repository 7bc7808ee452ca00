//! `kerf toolpath`: from a drawing to what is cut.

mod dry_run;
mod report;

use crate::args::{Format, RunArgs};
use crate::coloured::{Colours, coloured};
use crate::exit::{Exit, Usage};
use crate::outputs::Outputs;
use crate::picture;
use crate::{drawings, job_options, out, parse, setup};
use anyhow::{Result, bail};
use clap::Args;
use kerf_formats::ending;
use kerf_geom::{Bounds2, Point2};
use kerf_journal::Work;
use kerf_machine::Configuration;
use kerf_program::Written;
use kerf_sbp::Status;
use kerf_toolpath::{DrawnJob, Heights, Warning, off_table, too_deep, too_flat, write};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Makes the tool paths of a drawing: offsets, tabs, leads, arrays
///
/// What cannot be cut as it is drawn is told with the number of its shape.
#[derive(Args)]
#[command(after_help = "Examples:\n  kerf toolpath plate.rsg -o plate.rsm --report\n  \
    kerf toolpath plate.rsg -o plate.png --colours direction\n\nExit codes: 0 done, 1 failed, 2 the command line was wrong")]
pub struct ToolpathArgs {
    /// The drawing: .rsg or .dxf, a job that was made before: .rsm, or a program as it cuts: .nc or .sbp
    drawing: PathBuf,
    /// The job to write, .rsm, a part program, .sbp or .nc, or a picture, .svg or .png [default: the
    /// drawing's name with .rsm]
    #[arg(short, long, value_name = "OUT")]
    output: Option<PathBuf>,
    /// Prints paths, lengths, tool and time of each layer; the time is that of the plan
    #[arg(long)]
    report: bool,
    /// The report as text for people or JSON for programs
    #[arg(long, value_enum, default_value = "text")]
    format: Format,
    /// The colours of a picture
    #[arg(long, value_enum, value_name = "HOW", default_value = "group")]
    colours: Colours,
    /// The table that nothing may leave, mm from the origin [default: that of --machine]
    #[arg(long, value_name = "X,Y", value_parser = parse::size)]
    table: Option<[f64; 2]>,
    /// Where the drawing's origin lies on the table, mm from home [default: that of the machine that cuts it]
    #[arg(long, value_name = "X,Y", value_parser = parse::place)]
    origin: Option<[f64; 2]>,
    /// Where the head goes at the end, mm from the origin [default: that of the machine that cuts it]
    #[arg(long, value_name = "X,Y", value_parser = parse::place)]
    finish: Option<[f64; 2]>,
    /// The path with which the job begins, from 1
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    begin_with: Option<u32>,
    /// Replaces an existing output file without a question, also a job whose paths were
    /// changed by hand
    #[arg(long)]
    force: bool,
    #[command(flatten)]
    heights: HeightArgs,
    #[command(flatten)]
    run: Box<RunArgs>,
}

impl ToolpathArgs {
    /// The files that it writes.
    pub fn outputs(&self) -> Outputs {
        Outputs::of([self.written().as_path()], self.force, Some(&self.run.place.data))
    }
}

/// Heights of the machine, as Z above its home; in a part program counted from the surface. What is not said is
/// the machine's.
#[derive(Args, Clone, Copy, Debug)]
pub struct HeightArgs {
    /// Where the tool travels [default: the machine's]
    #[arg(long, value_name = "MM", value_parser = parse::number)]
    z_top: Option<f64>,
    /// The surface of the material; zero of Z in a part program [default: the machine's, in a part program 0]
    #[arg(long, value_name = "MM", value_parser = parse::number)]
    z_surface: Option<f64>,
    /// Where THRU cuts; nothing is cut below it [default: the machine's]
    #[arg(long, value_name = "MM", value_parser = parse::number)]
    z_bottom: Option<f64>,
}

impl HeightArgs {
    fn over(self, usual: Heights) -> Result<Heights> {
        let top_mm = self.z_top.unwrap_or(usual.top_mm);
        let surface_mm = self.z_surface.unwrap_or(usual.surface_mm);
        let bottom_mm = self.z_bottom.unwrap_or(usual.bottom_mm);
        // A beam cuts through from the surface: there it may be the bottom as well.
        if !(bottom_mm <= surface_mm && surface_mm < top_mm) {
            bail!(Usage(format!(
                "Z top must lie above Z surface, and Z bottom not above it: they are {top_mm}, {surface_mm} and \
                 {bottom_mm}"
            )));
        }
        Ok(Heights { top_mm, surface_mm, bottom_mm })
    }
}

pub fn run(args: &ToolpathArgs) -> Result<Exit> {
    let output = args.written();
    let kind = Kind::of(&output)?;
    job_options::refuse_all(&args.run)?;
    let mut machine = setup::machine_of(&args.run.place, true)?;
    let heights = args.heights.over(usual_heights(&machine, kind))?;
    machine.zpos = heights;
    let shaping = setup::shaping(&machine, &args.run);
    let (job, mut warnings) = drawings::job_with_warnings(&args.drawing, shaping, args.run.units)?;
    let job = args.placed(job)?;
    let [x, y] = if kind == Kind::Program { [0.0; 2] } else { machine.job.origin_mm };
    let origin = job.origin.unwrap_or(Point2::new(x, y));
    if let Some(table) = table(args, origin)? {
        warnings.extend(off_table(&job, &table));
    }
    if kind != Kind::Program {
        warnings.extend(too_deep(&job, &heights));
    }
    warnings.extend(too_flat(&job, &heights));
    tell(args, &warnings);
    if kind != Kind::Picture {
        keep(args, &output, kind, &job, &machine)?;
    }
    if kind != Kind::Picture && !args.report {
        return Ok(Exit::Good);
    }
    let dry = dry_run::follow(args, work(args, kind, &job, machine)?)?;
    if kind == Kind::Picture {
        let scene = coloured(&dry.scene, &job.drawing, args.colours);
        picture::write(&scene, picture::format_of(&output)?, &output)?;
    }
    match dry.summary.status {
        _ if !args.report => {}
        Status::Failed => {
            eprintln!("{}: it does not run to its end: no report", args.drawing.display());
        }
        _ => report::tell(&job, &dry.summary, &warnings, args.format),
    }
    Ok(dry.summary.status.into())
}

/// The heights of the machine; a part program counts them from the surface, its zero of Z.
fn usual_heights(machine: &Configuration, kind: Kind) -> Heights {
    let Heights { top_mm, surface_mm, bottom_mm } = machine.zpos;
    let zero_mm = if kind == Kind::Program { surface_mm } else { 0.0 };
    Heights {
        top_mm: top_mm - zero_mm,
        surface_mm: surface_mm - zero_mm,
        bottom_mm: bottom_mm - zero_mm,
    }
}

/// Kind of the file that is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Job,
    Program,
    Picture,
}

impl Kind {
    fn of(output: &Path) -> Result<Self> {
        match ending(output).as_str() {
            "rsm" => Ok(Self::Job),
            "sbp" | "nc" | "ngc" | "tap" | "gcode" => Ok(Self::Program),
            "svg" | "png" => Ok(Self::Picture),
            _ => bail!(Usage(format!(
                "{}: written are .rsm, .sbp, .nc, .svg and .png",
                output.display()
            ))),
        }
    }
}

/// Returns the work that a dry run follows: the part program when one is written, else the job as `kerf run` runs it.
fn work(args: &ToolpathArgs, kind: Kind, job: &DrawnJob, machine: Configuration) -> Result<Work> {
    let name = args.drawing.display().to_string();
    if kind == Kind::Program {
        let text = drawings::part_program(&args.drawing, job, &machine)?.text;
        return Ok(kerf_part::read(name.into(), text.into_bytes()).into());
    }
    Ok(Work::Job(Arc::new(job.machine_job(name.into())), Arc::new(machine)))
}

impl ToolpathArgs {
    /// The file that is written.
    fn written(&self) -> PathBuf {
        self.output.clone().unwrap_or_else(|| self.drawing.with_extension("rsm"))
    }

    /// The job where it is cut, and where it begins.
    fn placed(&self, mut job: DrawnJob) -> Result<DrawnJob> {
        let point = |[x, y]: [f64; 2]| Point2::new(x, y);
        job.origin = self.origin.map(point).or(job.origin);
        job.finish = self.finish.map(point).or(job.finish);
        job.start = self.begin_with.map_or(job.start, |first| first as usize);
        if job.start > job.paths.len().max(1) {
            let (start, count) = (job.start, job.paths.len());
            bail!(Usage(format!("--begin-with {start}: the job has {count} paths")));
        }
        Ok(job)
    }
}

/// Writes the job or its program, whole or not at all.
fn keep(
    args: &ToolpathArgs,
    output: &Path,
    kind: Kind,
    job: &DrawnJob,
    machine: &Configuration,
) -> Result<()> {
    if !args.force && args.drawing != output && drawings::is_edited(output) {
        bail!(
            "{}: its paths were changed by hand; --force makes them anew, -o names another file",
            output.display()
        );
    }
    let text = match ending(output).as_str() {
        _ if kind == Kind::Job => write(job),
        "sbp" => told(output, drawings::part_program(&args.drawing, job, machine)?),
        _ => told(output, drawings::gcode_program(&args.drawing, job, machine)?),
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
fn table(args: &ToolpathArgs, origin: Point2) -> Result<Option<Bounds2>> {
    let corners = match args.table {
        Some([x, y]) => Some((Point2::default(), Point2::new(x, y))),
        None if args.run.place.machine.configuration().is_some() => {
            let settings = setup::settings(&args.run.place, Default::default())?;
            let (low, high) = (settings.limits.low.0, settings.limits.high.0);
            Some((Point2::new(low[0], low[1]), Point2::new(high[0], high[1])))
        }
        None => None,
    };
    let origin = origin - Point2::default();
    Ok(corners.map(|(low, high)| Bounds2::of(low + origin * -1.0, high + origin * -1.0)))
}
