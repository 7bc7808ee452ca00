//! `kerf time`: how long a part file takes.

mod controller;

use crate::args::{Format, RunArgs};
use crate::exit::{Exit, Usage};
use crate::out;
use crate::report::Diagnostics;
use crate::setup::{self, PreparedRun};
use anyhow::{Result, bail};
use clap::Args;
use controller::ControllerArgs;
use kerf_control::{Learned, OwnPace, OwnTime, RunContext, kept_pace};
use kerf_motion::controllers::Controller;
use kerf_program::RampModel;
use kerf_trace::{Sink, Summary, Tally, ToolPathTime, json};
use serde::Serialize;
use std::path::PathBuf;

/// Tells how long a part file takes: cutting, jogging, waiting, tool changes, each tool path
///
/// The times come from the plan that a run follows: speeds, ramps and corners as the settings say. Part files and
/// jobs have the same model of ramps, which is told: --ramps chooses another.
/// Other controllers plan otherwise; --controller tells what grbl or LinuxCNC would take. With --machine of a controller that
/// was driven before, the time is that of its planner by the settings that it told last, with what its runs have shown.
#[derive(Args)]
#[command(after_help = "Examples:
  kerf time box.sbp --format json
  kerf time box.sbp --controller grbl --junction-deviation 0.02 --accel 300,300,100")]
pub struct TimeArgs {
    /// The part file
    file: PathBuf,
    /// Text for people or JSON for programs
    #[arg(long, value_enum, default_value = "text")]
    format: Format,
    #[command(flatten)]
    controller: ControllerArgs,
    #[command(flatten)]
    run: RunArgs,
}

/// The times of a run, seconds.
#[derive(Serialize)]
struct Times<'a> {
    total: f64,
    cut: f64,
    jog: f64,
    wait: f64,
    tool_change: f64,
    /// The model of ramps; another controller has its own.
    #[serde(skip_serializing_if = "Option::is_none")]
    ramps: Option<&'static str>,
    /// The factor that runs on the controller of the machine have shown, in a sentence.
    #[serde(skip_serializing_if = "Option::is_none")]
    learned: Option<String>,
    toolpaths: &'a [ToolPathTime],
}

pub fn run(args: &TimeArgs) -> Result<Exit> {
    if args.controller.controller.is_some() {
        return run_elsewhere(args);
    }
    let mut job = setup::prepare(&args.file, &args.run, true)?;
    let ramps = job.session.memory.settings.model().word();
    args.controller.controller(&job.session.memory.settings.axis_dynamics())?;
    if let Some(name) = args.run.place.machine.controller().filter(|name| !name.is_board()) {
        let port = name.address.key();
        if let Some(pace) = kept_pace(&port, &job.workspace.stored) {
            let learned = Learned::of(&port, &job.workspace.stored);
            return run_there(job, &pace, learned, args);
        }
        eprintln!(
            "kerf: {name} has not been driven from this data folder: the time is that of Kerf's own plan"
        );
    }
    let mut sink = Diagnostics::default();
    let summary = follow(&mut job, &mut sink, args);
    tell(&Times { ramps: Some(ramps), ..times(summary.seconds, &summary.tally) }, args);
    Ok(summary.status.into())
}

/// The run as the controller of the machine makes it, by its settings when it was driven last and what runs have shown.
fn run_there(
    mut job: PreparedRun,
    pace: &OwnPace,
    learned: Learned,
    args: &TimeArgs,
) -> Result<Exit> {
    let mut sink = (Diagnostics::default(), OwnTime::of_run(pace));
    let summary = follow(&mut job, &mut sink, args);
    let (_, estimate) = sink;
    let learned = (learned.runs() > 0).then(|| super::pace::sentence(learned));
    tell(&Times { learned, ..times(estimate.total_s(), &estimate.tally) }, args);
    Ok(summary.status.into())
}

/// The same moves, as another controller would make them.
fn run_elsewhere(args: &TimeArgs) -> Result<Exit> {
    let mut run = args.run.clone();
    let motion = &mut run.motion;
    let axes = (motion.axis_speed.take(), motion.accel.take());
    let own = [
        ("--ramps", motion.ramps.is_some()),
        ("--tolerance", motion.tolerance.is_some()),
        ("--jerk", motion.jerk.is_some()),
    ];
    if let Some((name, _)) = own.into_iter().find(|(_, given)| *given) {
        bail!(Usage(format!("{name} is Kerf's own; it does not belong to --controller")));
    }
    let mut job = setup::prepare(&args.file, &run, true)?;
    let settings = &mut job.session.memory.settings;
    let mut dynamics = settings.axis_dynamics();
    for (own, given) in [(&mut dynamics.speed_mm_s, axes.0), (&mut dynamics.accel_mm_s2, axes.1)] {
        if let Some(given) = given {
            own.0[..3].copy_from_slice(&given);
        }
    }
    // The model does not matter for the moves, but this one leaves them as they are.
    settings.ramp_model = Some(RampModel::Shopbot);
    let Some(controller) = args.controller.controller(&dynamics)? else { return Ok(Exit::Good) };
    let controller: &dyn Controller = &*controller;
    let mut sink = (Diagnostics::default(), OwnTime::of_file(controller));
    let summary = follow(&mut job, &mut sink, args);
    let estimate = sink.1;
    tell(&times(estimate.total_s(), &estimate.tally), args);
    Ok(summary.status.into())
}

fn follow(job: &mut PreparedRun, sink: &mut dyn Sink, args: &TimeArgs) -> Summary {
    let mut pace = args.run.operator.script();
    let context = RunContext {
        sink,
        operator: &mut job.answers,
        requests: &mut pace,
        machine: kerf_control::simulated(),
    };
    let (work, options) = (std::mem::take(&mut job.work), job.options.clone());
    job.session.run(work, options, &mut job.workspace, context)
}

fn tell(times: &Times<'_>, args: &TimeArgs) {
    out::print(&match args.format {
        Format::Json => json::to_string(times) + "\n",
        Format::Text => text(times),
    });
}

fn times(total: f64, tally: &Tally) -> Times<'_> {
    Times {
        total,
        cut: tally.cut_s,
        jog: tally.jog_s,
        wait: tally.wait_s,
        tool_change: tally.tool_change_s,
        ramps: None,
        learned: None,
        toolpaths: &tally.toolpaths,
    }
}

fn text(times: &Times<'_>) -> String {
    let rows = [
        ("total", times.total),
        ("cutting", times.cut),
        ("jogging", times.jog),
        ("waiting", times.wait),
        ("tool changes", times.tool_change),
    ];
    let mut text = String::new();
    for (name, seconds) in rows {
        text += &format!("{name:<14}{:>12}\n", out::duration(seconds));
    }
    if let Some(ramps) = times.ramps {
        text += &format!("{:<14}{ramps:>12}\n", "ramps");
    }
    if let Some(learned) = &times.learned {
        text += &format!("{learned}\n");
    }
    if !times.toolpaths.is_empty() {
        text += "\n";
    }
    for path in times.toolpaths {
        text += &toolpath_line(path);
    }
    text
}

/// Time, name and tool, and how much of the time is none of cutting and jogging.
fn toolpath_line(path: &ToolPathTime) -> String {
    let tool = if path.tool.is_empty() { String::new() } else { format!("  ({})", path.tool) };
    let parts = [("waiting", path.wait), ("tool changes", path.tool_change)];
    let told = |(name, seconds): (&str, f64)| {
        (seconds >= 0.05).then(|| format!("{name} {}", out::duration(seconds)))
    };
    let of_that = parts.into_iter().filter_map(told).collect::<Vec<_>>().join(", ");
    let of_that = if of_that.is_empty() { of_that } else { format!("; {of_that}") };
    format!("{:>12}  {}{tool}{of_that}\n", out::duration(path.seconds), path.name)
}
