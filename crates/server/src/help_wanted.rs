//! Tells somebody who helps what they have to know.

use crate::app::App;
use crate::line_log;
use crate::locks::lock;
use crate::problems::FILE;
use crate::to_wire;
use std::fs;
use std::io;

/// Lines of the problem log that a request for help shows.
const SHOWN: usize = 100;

/// Returns what somebody who helps has to know: versions and places, the last of the problem log, and of what was sent to the controller.
///
/// # Errors
/// The files of the machine cannot be looked at.
pub fn problems(app: &App) -> io::Result<String> {
    let session = lock(&app.left).session.clone();
    let mut workspace = app.loader.preview_workspace()?;
    let facts = to_wire::named(kerf_control::diagnostics(&session, &mut workspace));
    let mut text = app.hub.read(|now| {
        let file = now.opened.as_ref().map_or("none", |opened| &opened.name);
        let job = now.job.as_ref().and_then(|job| job.ended.as_deref()).unwrap_or("none");
        let why = now.machine.why.as_deref().unwrap_or("nothing to tell");
        format!(
            "Kerf {}, machine {}\nState: {:?}, {why}\nFile: {file}\nLast job: {job}\n",
            now.kerf, now.machine.name, now.machine.state
        )
    });
    text.extend(facts.iter().map(|fact| format!("{}: {}\n", fact.name, fact.value)));
    let log = fs::read_to_string(app.options.data.join(FILE)).unwrap_or_default();
    let lines: Vec<&str> = log.lines().collect();
    text += "\nProblem log:\n";
    text.extend(lines[lines.len().saturating_sub(SHOWN)..].iter().map(|l| format!("{l}\n")));
    let sent = line_log::for_help(app);
    if !sent.is_empty() {
        text += "\nSent to the controller and answered, without reports and ok:\n";
        text += &sent;
    }
    Ok(text)
}
