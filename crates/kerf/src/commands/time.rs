//! `kerf time`: how long a part file takes.

use crate::args::{Format, RunArgs};
use crate::exit::Exit;
use crate::report::Diagnostics;
use crate::{out, setup};
use anyhow::Result;
use clap::Args;
use kerf_control::{Company, StopAt, Summary, ToolPathTime, json};
use serde::Serialize;
use std::path::PathBuf;

/// Tells how long a part file takes: cutting, jogging, waiting, tool changes, each tool path
///
/// The times come from the plan that a run follows: speeds, ramps and corners as VS and VR set them.
#[derive(Args)]
#[command(after_help = "Example: kerf time box.sbp --format json")]
pub struct TimeArgs {
    /// The part file
    file: PathBuf,
    /// Text for people or JSON for programs
    #[arg(long, value_enum, default_value = "text")]
    format: Format,
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
    toolpaths: &'a [ToolPathTime],
}

pub fn run(args: &TimeArgs) -> Result<Exit> {
    let mut job = setup::job(&args.file, &args.run, true)?;
    let mut sink = Diagnostics::default();
    let mut pace = StopAt(args.run.stop_at.unwrap_or(f64::INFINITY));
    let company = Company { sink: &mut sink, operator: &mut job.answers, pace: &mut pace };
    let summary = job.session.run(job.program, job.options, &mut job.shelf, company);
    let times = times(&summary);
    out::print(&match args.format {
        Format::Json => json::to_string(&times) + "\n",
        Format::Text => text(&times),
    });
    Ok(summary.status.into())
}

fn times(summary: &Summary) -> Times<'_> {
    let tally = &summary.tally;
    Times {
        total: summary.seconds,
        cut: tally.cut_s,
        jog: tally.jog_s,
        wait: tally.wait_s,
        tool_change: tally.tool_change_s,
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
    if !times.toolpaths.is_empty() {
        text += "\n";
    }
    for path in times.toolpaths {
        let tool = if path.tool.is_empty() { String::new() } else { format!("  ({})", path.tool) };
        text += &format!("{:>12}  {}{tool}\n", out::duration(path.seconds), path.name);
    }
    text
}
