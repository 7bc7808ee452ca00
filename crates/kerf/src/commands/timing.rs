//! `kerf timing`: which output switches when, beside the motion.

use crate::args::RunArgs;
use crate::exit::{Exit, Usage};
use crate::report::Diagnostics;
use crate::{out, setup};
use anyhow::{Result, bail};
use clap::Args;
use kerf_control::{Company, Event, Made, Sink};
use kerf_preview::timing::{Course, Timing, Track};
use kerf_program::Axis;
use std::collections::BTreeMap;
use std::path::PathBuf;

/// Draws the timing of a job or part file: inputs and outputs under the motion
///
/// Everything is taken from a run on the simulated machine; the times are those of the trace.
#[derive(Args)]
#[command(after_help = "Examples:
  kerf timing plate.rsm -o plate.svg
  kerf timing plate.rsm --config plasma --sheet -20 --input arc@1.62=1 -o arc.svg")]
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
}

/// Pixels of a .png.
const PIXELS: u32 = 2400;

/// Between two looks at the plan, seconds.
const STEP_S: f64 = 0.005;

/// A bit's name, and when it changed to what.
type Edges = (String, Vec<(f64, bool)>);

/// What a run did, line by line.
#[derive(Default)]
struct Lines {
    /// Positions of X, Y and Z.
    motion: [Vec<(f64, f64)>; 3],
    switches: BTreeMap<(bool, u8), Edges>,
    intensity: Vec<(f64, f64)>,
    frequency: Vec<(f64, f64)>,
    end_s: f64,
}

impl Sink for Lines {
    fn event(&mut self, event: &Event) {
        match event {
            Event::Output { n, on, t, name, .. } => self.switch(false, *n, *name, *t, *on),
            Event::Input { n, on, t, name } => self.switch(true, *n, *name, *t, *on),
            Event::Intensity { value, t, .. } => step(&mut self.intensity, *t, f64::from(*value)),
            Event::LaserHz { hz, t } => step(&mut self.frequency, *t, *hz),
            Event::End(end) => self.end_s = end.t,
            _ => {}
        }
    }

    fn made(&mut self, made: &Made<'_>) {
        let (from_s, to_s) = (made.span.t0_s, made.span.t1_s);
        let looks = ((to_s - from_s) / STEP_S).ceil().max(1.0) as u32;
        for look in 0..=looks {
            let at_s = from_s + (to_s - from_s) * f64::from(look) / f64::from(looks);
            let position = made.plan.at(at_s).position;
            for (course, axis) in self.motion.iter_mut().zip([Axis::X, Axis::Y, Axis::Z]) {
                course.push((made.t0_s + at_s, position[axis]));
            }
        }
    }
}

impl Lines {
    fn switch(&mut self, input: bool, n: u8, name: Option<&str>, t: f64, on: bool) {
        let kind = if input { "input" } else { "output" };
        let named = name.map_or_else(|| format!("{kind} {n}"), |name| name.to_owned());
        let entry = self.switches.entry((input, n)).or_insert((named, Vec::new()));
        entry.1.push((t, on));
    }

    fn tracks(self) -> Vec<Track> {
        let mut tracks = Vec::new();
        for (name, points) in ["x, mm", "y, mm", "z, mm"].into_iter().zip(self.motion) {
            let moves = points.windows(2).any(|pair| pair[0].1 != pair[1].1);
            if moves {
                tracks.push(Track { name: name.into(), course: Course::Value(points) });
            }
        }
        for (name, points) in [("intensity", self.intensity), ("pulses, Hz", self.frequency)] {
            if !points.is_empty() {
                tracks.push(Track { name: name.into(), course: Course::Value(points) });
            }
        }
        let switches = self.switches.into_values();
        tracks.extend(
            switches.map(|(name, changes)| Track { name, course: Course::Switch(changes) }),
        );
        tracks
    }
}

/// What the diagram shows, as numbers: edges of switches, courses of values, seconds.
fn data(timing: &Timing) -> serde_json::Value {
    let tracks: serde_json::Map<String, serde_json::Value> = timing
        .tracks
        .iter()
        .map(|track| {
            let course = match &track.course {
                Course::Switch(edges) => serde_json::json!({ "edges": edges }),
                Course::Value(points) => serde_json::json!({ "points": points }),
            };
            (track.name.clone(), course)
        })
        .collect();
    serde_json::json!({ "title": timing.title, "end": timing.end_s, "tracks": tracks })
}

/// A value holds until it changes.
fn step(points: &mut Vec<(f64, f64)>, t: f64, value: f64) {
    let before = points.last().map_or(0.0, |(_, value)| *value);
    points.extend([(t, before), (t, value)]);
}

pub fn run(args: &TimingArgs) -> Result<Exit> {
    let extension = args.output.extension().unwrap_or_default().to_string_lossy().to_lowercase();
    if !matches!(extension.as_str(), "svg" | "png" | "json") {
        bail!(Usage(format!(
            "{}: diagrams end in .svg or .png, their data in .json",
            args.output.display()
        )));
    }
    let mut job = setup::job(&args.file, &args.run, true)?;
    let mut sink = (Diagnostics::default(), Lines::default());
    let mut pace = args.run.operator.script();
    let company = Company { sink: &mut sink, operator: &mut job.answers, pace: &mut pace };
    let summary = job.session.run(job.work, job.options, &mut job.shelf, company);
    let lines = sink.1;
    let name = || args.file.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let title = args.title.clone().unwrap_or_else(name);
    let timing = Timing { title, end_s: lines.end_s, tracks: lines.tracks() };
    let bytes = match extension.as_str() {
        "json" => format!("{}\n", data(&timing)).into_bytes(),
        "svg" => timing.svg().into_bytes(),
        _ => timing.png(PIXELS)?,
    };
    out::file(&args.output, bytes)?;
    Ok(summary.status.into())
}
