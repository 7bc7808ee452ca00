//! The report of a job: what each group has, how long it is and how long it takes.

use crate::args::Format;
use crate::out;
use kerf_drawing::Group;
use kerf_toolpath::{DrawnJob, Pass, Warning};
use kerf_trace::{Summary, Tally, json};
use serde::Serialize;

/// A job in numbers: millimetres and seconds.
#[derive(Serialize)]
struct Report {
    seconds: f64,
    cut_seconds: f64,
    jog_seconds: f64,
    paths: usize,
    /// Of the paths, each once.
    length_mm: f64,
    /// Way of the tool at cutting and plunging speed: every pass, and the way down to it.
    cut_mm: f64,
    travel_mm: f64,
    groups: Vec<OfGroup>,
    warnings: Vec<String>,
}

#[derive(Serialize)]
struct OfGroup {
    group: &'static str,
    tool: u8,
    paths: usize,
    length_mm: f64,
    cut_mm: f64,
    seconds: f64,
}

/// Prints the report.
pub fn tell(job: &DrawnJob, summary: &Summary, warnings: &[Warning], format: Format) {
    let tally = &summary.tally;
    let groups: Vec<OfGroup> = job
        .lengths()
        .into_iter()
        .filter_map(|(group, mm)| of_group(job, tally, group, mm))
        .collect();
    let report = Report {
        seconds: summary.seconds,
        cut_seconds: tally.cut_s,
        jog_seconds: tally.jog_s,
        paths: groups.iter().map(|group| group.paths).sum(),
        length_mm: groups.iter().map(|group| group.length_mm).sum(),
        cut_mm: tally.cut_mm,
        travel_mm: tally.jog_mm,
        groups,
        warnings: warnings.iter().map(ToString::to_string).collect(),
    };
    out::print(&match format {
        Format::Json => json::to_string(&report) + "\n",
        Format::Text => text(&report),
    });
}

/// A group that has paths.
fn of_group(job: &DrawnJob, tally: &Tally, group: Group, length_mm: f64) -> Option<OfGroup> {
    let cuts = job.paths.iter().filter(|path| path.shape.group == group);
    let paths = cuts.filter(|path| path.pass != Pass::Traversal).count();
    // A job comes back to a group as often as the sequence does.
    let parts = tally.toolpaths.iter().filter(|part| part.name.as_ref() == group.name());
    let (cut_mm, seconds) =
        parts.fold((0.0, 0.0), |(mm, seconds), part| (mm + part.cut_mm, seconds + part.seconds));
    let tool = job.drawing.settings(group).tool;
    (paths > 0).then_some(OfGroup { group: group.name(), tool, paths, length_mm, cut_mm, seconds })
}

fn text(report: &Report) -> String {
    let row = |name: &str, paths: usize, [mm, cut]: [f64; 2], seconds: f64, tool: &str| {
        let time = out::duration(seconds);
        format!("{name:<10} {paths:>6} {mm:>12.1} {cut:>12.1} {time:>12}  {tool}\n")
    };
    let mut text = format!(
        "{:<10} {:>6} {:>12} {:>12} {:>12}  tool\n",
        "group", "paths", "length mm", "cut mm", "time"
    );
    for group in &report.groups {
        let tool = group.tool.to_string();
        let lengths = [group.length_mm, group.cut_mm];
        text += &row(group.group, group.paths, lengths, group.seconds, &tool);
    }
    text += &row("all", report.paths, [report.length_mm, report.cut_mm], report.seconds, "");
    let travel = out::duration(report.jog_seconds);
    text + &format!("travel{:>37.1} {travel:>12}\n", report.travel_mm)
}
