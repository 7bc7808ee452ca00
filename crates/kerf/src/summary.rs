//! The summary of a run, as it is told.

use crate::exit::Exit;
use crate::out;
use crate::remote::Ended;
use crate::report::Diagnostics;
use kerf_program::settings::LinearUnit;
use kerf_trace::Summary;

/// Prints the summary of a run.
pub fn tell(summary: &Summary) {
    out::print(&told(summary));
}

/// Tells how a server's run ended.
pub fn told_by_server(ended: &Ended, quiet: bool) -> Exit {
    let diagnostics = Diagnostics::default();
    ended.told.iter().for_each(|found| diagnostics.show(found));
    if !quiet {
        tell(&ended.summary);
    }
    ended.summary.status.into()
}

/// The summary of a run.
fn told(summary: &Summary) -> String {
    let tally = &summary.tally;
    let (mm, unit) = (summary.unit.mm(), summary.unit.symbol());
    let decimals = if summary.unit == LinearUnit::Mm { 1 } else { 2 };
    let length = |v: f64| format!("{} {unit}", kerf_program::decimal(v / mm, decimals));
    let status = match summary.status {
        kerf_sbp::Status::Ok => "ran to its end",
        kerf_sbp::Status::Ended => "ended by the program",
        kerf_sbp::Status::Failed => "FAILED",
        kerf_sbp::Status::Stopped => "STOPPED",
        kerf_sbp::Status::Limit => "STOPPED BY A LIMIT",
    };
    let seconds = summary.taken_s.unwrap_or(summary.seconds);
    let mut text = format!("{status} after {}\n", out::duration(seconds));
    text += &format!(
        "  {}, {}, {}\n  cut {}, jogged {}\n",
        out::count(summary.lines, "line"),
        out::count(tally.moves, "move"),
        out::count(tally.arcs, "arc"),
        length(tally.cut_mm),
        length(tally.jog_mm)
    );
    if let Some(bounds) = out::bounds(summary) {
        text += &format!("  cutting {bounds}\n");
    }
    text
}
