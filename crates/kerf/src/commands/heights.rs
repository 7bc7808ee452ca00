//! `kerf heights`: how well height control keeps the tool over a warped sheet.

use crate::args::RunArgs;
use crate::exit::{Exit, Usage};
use crate::outputs::{ForceArgs, Outputs};
use crate::picture_format::PictureFormat;
use crate::report::Diagnostics;
use crate::{out, setup};
use anyhow::{Result, bail};
use clap::Args;
use kerf_control::RunContext;
use kerf_journal::Work;
use kerf_preview::heights::{HeightPlot, Reading};
use kerf_program::{Axis, MoveKind};
use kerf_sim::Sheet;
use kerf_trace::{Event, ExecutedMove, Sink};
use std::path::PathBuf;

/// Measures height control: the error of the gap between tool and sheet
///
/// The job runs on the simulated machine over the sheet of --sheet; every reading of the sensor counts. The first 0.1 s
/// of each cut, in which the tool finds its height, is left out.
#[derive(Args)]
#[command(after_help = "Examples:
  kerf heights plate.rsm --machine mine.toml --sheet=-20,0.05
  kerf heights plate.rsm --machine mine.toml --sheet=-20,0,0,1.5,300 -o error.svg")]
pub struct HeightsArgs {
    /// The job
    file: PathBuf,
    /// The picture to write: .svg or .png
    #[arg(short, long, value_name = "OUT")]
    output: Option<PathBuf>,
    /// The heading [default: the name of the file]
    #[arg(long, value_name = "TEXT")]
    title: Option<String>,
    #[command(flatten)]
    run: RunArgs,
    #[command(flatten)]
    force: ForceArgs,
}

impl HeightsArgs {
    /// The files that it writes.
    pub fn outputs(&self) -> Outputs {
        Outputs::of(self.output.as_deref(), self.force.force, Some(&self.run.place.data))
    }
}

/// Pixels of a .png.
const PIXELS: u32 = 2400;

/// A cut settles in so long, seconds.
const SETTLED_S: f64 = 0.1;

/// A reading, and when it came.
#[derive(Clone, Copy)]
struct Timed {
    t_s: f64,
    z_mm: f64,
    error_mm: f64,
}

/// The readings of a run, and where on the path the tool was.
struct Readings {
    sheet: Sheet,
    readings: Vec<Reading>,
    /// Time of each reading, and of the beginning of its cut.
    times: Vec<[f64; 2]>,
    /// Readings of the move that was made last.
    waiting: Vec<Timed>,
    /// Length of the cuts so far, mm.
    cut_mm: f64,
    /// The cut at hand: its move, and when height control began in it.
    made: Option<SampledCut>,
    began_s: Option<f64>,
}

/// A cut that was made: where its path lies, a place a millisecond.
struct SampledCut {
    from_s: f64,
    step_s: f64,
    /// X, Y and the way along the path.
    places: Vec<[f64; 3]>,
}

impl SampledCut {
    fn of(made: &ExecutedMove<'_>, before_mm: f64) -> Self {
        let (span, t0_s) = (made.span, made.t0_s);
        let looks = ((span.t1_s - span.t0_s) / 0.001).ceil().max(1.0) as usize;
        let step_s = (span.t1_s - span.t0_s) / looks as f64;
        let look = |n: usize| {
            let state = made.plan.at(span.t0_s + n as f64 * step_s);
            let [x, y, _] = state.position.first3();
            [x, y, before_mm + state.share * span.made.length_mm]
        };
        let mut places: Vec<[f64; 3]> = (0..looks).map(look).collect();
        let [x, y, _] = span.made.to.first3();
        places.push([x, y, before_mm + span.made.length_mm]);
        Self { from_s: t0_s + span.t0_s, step_s, places }
    }

    /// The place at a moment, between the two nearest that are known.
    fn at(&self, t_s: f64) -> [f64; 3] {
        let steps = ((t_s - self.from_s) / self.step_s).clamp(0.0, (self.places.len() - 1) as f64);
        let (n, part) = (steps.floor() as usize, steps.fract());
        let next = self.places[(n + 1).min(self.places.len() - 1)];
        std::array::from_fn(|i| self.places[n][i] + part * (next[i] - self.places[n][i]))
    }
}

impl Sink for Readings {
    fn event(&mut self, event: &Event) {
        match event {
            Event::Height { z, error, t, .. } => {
                self.waiting.push(Timed { t_s: *t, z_mm: *z, error_mm: *error });
            }
            // Height control was off: the next cut settles anew.
            Event::Output { .. } | Event::State { .. } => self.began_s = None,
            _ => {}
        }
        self.take();
    }

    fn made(&mut self, made: &ExecutedMove<'_>) {
        let flat = made.span.made.from[Axis::Z] == made.span.made.to[Axis::Z];
        if made.span.made.kind == MoveKind::Cut && flat {
            self.made = Some(SampledCut::of(made, self.cut_mm));
            self.cut_mm += made.span.made.length_mm;
        } else {
            self.made = None;
        }
    }
}

impl Readings {
    fn new(sheet: Sheet) -> Self {
        Self {
            sheet,
            readings: Vec::new(),
            times: Vec::new(),
            waiting: Vec::new(),
            cut_mm: 0.0,
            made: None,
            began_s: None,
        }
    }

    /// Readings that came in the move that was made.
    fn take(&mut self) {
        let Some(place) = &self.made else { return self.waiting.clear() };
        for Timed { t_s, z_mm, error_mm } in std::mem::take(&mut self.waiting) {
            let [x, y, at_mm] = place.at(t_s);
            let sheet_mm = self.sheet.height_mm(x, y);
            self.readings.push(Reading { at_mm, z_mm, sheet_mm, error_mm });
            self.times.push([t_s, *self.began_s.get_or_insert(t_s)]);
        }
    }

    /// Errors after each cut has settled.
    fn settled(&self) -> Vec<f64> {
        let settled = |[t_s, began_s]: &[f64; 2]| t_s - began_s > SETTLED_S;
        let pairs = self.readings.iter().zip(&self.times);
        pairs.filter(|(_, times)| settled(times)).map(|(it, _)| it.error_mm.abs()).collect()
    }
}

pub fn run(args: &HeightsArgs) -> Result<Exit> {
    let Some(sheet) = args.run.sheet else {
        bail!(Usage("there is no sheet: --sheet=-20,0.05 lays one on the table".into()));
    };
    let mut job = setup::prepare(&args.file, &args.run, true)?;
    let Work::Job(_, machine) = &job.work else {
        bail!(Usage(format!("{} is no job", args.file.display())));
    };
    let (machine, speed) = (machine.clone(), machine.program.smoothing.cut_speed_mm_s);
    let mut sink = (Diagnostics::default(), Readings::new(sheet));
    let mut pace = args.run.operator.script();
    let context = RunContext {
        sink: &mut sink,
        operator: &mut job.answers,
        requests: &mut pace,
        machine: kerf_control::simulated(),
    };
    let summary = job.session.run(job.work, job.options, &mut job.workspace, context);
    let readings = sink.1;
    if readings.readings.is_empty() {
        bail!(
            "no reading came: height control reads in THRU shapes, with height.on and height.mode \
               proportional"
        );
    }
    let accuracy_mm = machine.height.display_accuracy_mm;
    let told = told(&readings.settled(), accuracy_mm);
    out::print(&format!("{told}\n"));
    let speed = speed.unwrap_or(machine.program.speeds.cut.xy) * 0.06;
    let note =
        format!("{speed} m/min, K {}, {} baud · {told}", machine.height.k, machine.height.baud);
    let name = || args.file.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let title = args.title.clone().unwrap_or_else(name);
    let plot = HeightPlot { title, note, accuracy_mm, readings: readings.readings };
    write(args, &plot)?;
    Ok(summary.status.into())
}

/// The measured numbers.
fn told(errors: &[f64], accuracy_mm: f64) -> String {
    let worst = errors.iter().copied().fold(0.0, f64::max);
    let mean = (errors.iter().map(|e| e * e).sum::<f64>() / errors.len().max(1) as f64).sqrt();
    let off = errors.iter().filter(|error| **error > accuracy_mm).count();
    format!(
        "worst error {worst:.3} mm, root mean square {mean:.3} mm, {off} of {} readings beyond {accuracy_mm} mm",
        errors.len()
    )
}

fn write(args: &HeightsArgs, plot: &HeightPlot) -> Result<()> {
    let Some(path) = &args.output else { return Ok(()) };
    let bytes =
        match PictureFormat::of(path, "diagrams", &[PictureFormat::Svg, PictureFormat::Png])? {
            PictureFormat::Svg => plot.svg().into_bytes(),
            _ => plot.png(PIXELS)?,
        };
    out::file(path, bytes)
}
