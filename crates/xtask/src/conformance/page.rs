//! The page for users: what works, per area and row by row.

use super::by::By;
use super::score::{Area, Entry, Score, Status};
use super::shown::{NOT_YET, Unshown};
use std::fmt::Write as _;

const INTRODUCTION: &str = "\
<!-- Written by `make conformance` from conformance.toml and conformance-notes.md. Do not edit. -->

# What works

Kerf is measured against two manuals: the command reference of OpenSBP with its programming
handbooks, and the reference of the Profiler control. Everything they describe is cut into rows, each
with an id and with something that can be seen when it works. A row counts as **done** when a test of
this project shows it and would fail without it; **partial** when something is missing, which the
note tells; **n/a** when it has no meaning for Kerf, with the reason; else **not yet**. By tells where
the tests look: `browser` on the console's page, `cli` at the command, `library` behind both.
";

/// The whole page.
pub fn write(score: &Score, unshown: &Unshown, notes: &str) -> String {
    let mut page = INTRODUCTION.to_owned();
    overview(&mut page, score);
    shown_by(&mut page, score, unshown);
    page.push('\n');
    page.push_str(notes.trim_end());
    page.push('\n');
    for area in &score.areas {
        section(&mut page, area, unshown);
    }
    page
}

fn overview(page: &mut String, score: &Score) {
    let heads: Vec<&str> = Status::ALL.iter().map(|s| s.word()).collect();
    let _ = write!(page, "\n| area | {} | rows |\n|---|", heads.join(" | "));
    page.push_str(&"--:|".repeat(Status::ALL.len() + 1));
    page.push('\n');
    let mut suite = "";
    for area in &score.areas {
        if area.suite != suite {
            suite = &area.suite;
            let all: Vec<&Area> = score.areas.iter().filter(|a| a.suite == suite).collect();
            counts(page, &format!("**{}**", suite_title(suite)), &all);
        }
        counts(page, &format!("[{}](#{})", area.title, anchor(&heading(area))), &[area]);
    }
    counts(page, "**All**", &score.areas.iter().collect::<Vec<_>>());
}

/// By what the rows that are done are shown, each counted at the best place.
fn shown_by(page: &mut String, score: &Score, unshown: &Unshown) {
    let best = |by: By| score.rows().filter(|(_, _, e)| e.by.first() == Some(&by)).count();
    let [browser, cli, library] = [By::Browser, By::Cli, By::Library].map(best);
    let _ = write!(
        page,
        "\n{browser} rows are shown in a browser, {cli} more by the command, {library} by the libraries behind \
         them. {} rows speak of the mouse, a key, a dialog, a page, a picture or a warning and are **{NOT_YET}**: \
         their notes say so.\n",
        unshown.len()
    );
}

fn counts(page: &mut String, title: &str, areas: &[&Area]) {
    let rows = || areas.iter().flat_map(|a| &a.rows);
    let cells: Vec<String> = Status::ALL
        .iter()
        .map(|status| rows().filter(|(_, e)| e.status == *status).count().to_string())
        .collect();
    let _ = writeln!(page, "| {title} | {} | {} |", cells.join(" | "), rows().count());
}

fn section(page: &mut String, area: &Area, unshown: &Unshown) {
    let _ = write!(
        page,
        "\n## {}\n\n| row | status | by | tests | note |\n|---|---|---|---|---|\n",
        heading(area)
    );
    for (id, entry) in &area.rows {
        let _ = writeln!(
            page,
            "| {id} | {} | {} | {} | {} |",
            entry.status.word(),
            by(entry),
            tests(entry),
            note(id, entry, unshown)
        );
    }
}

fn heading(area: &Area) -> String {
    format!("{}: {}", suite_title(&area.suite), area.title)
}

fn suite_title(suite: &str) -> &str {
    match suite {
        "opensbp" => "OpenSBP",
        "profiler" => "Profiler",
        other => other,
    }
}

/// The anchor that Markdown viewers make of a heading.
fn anchor(heading: &str) -> String {
    let kept = heading
        .to_lowercase()
        .chars()
        .filter(|c| c.is_alphanumeric() || " -".contains(*c))
        .collect::<String>();
    kept.replace(' ', "-")
}

fn by(entry: &Entry) -> String {
    let words: Vec<&str> = entry.by.iter().map(|by| by.word()).collect();
    words.join(", ")
}

fn tests(entry: &Entry) -> String {
    let tests: Vec<String> = entry.tests.iter().map(|test| format!("`{test}`")).collect();
    tests.join(" ")
}

fn note(id: &str, entry: &Entry, unshown: &Unshown) -> String {
    let why = entry.why.as_deref().unwrap_or_default().replace('|', "\\|");
    match unshown.contains(id) {
        true if why.is_empty() => NOT_YET.to_owned(),
        true => format!("{why}; {NOT_YET}"),
        false => why,
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn counts_and_lists_every_row() {
        let score = Score::read(
            "[opensbp.lang]\ntitle = \"The language\"\n\
             SBP-A = { status = \"done\", by = [\"cli\"], tests = [\"sbp_a\"] }\n\
             SBP-B = { status = \"partial\", why = \"a|b\" }\n",
        );
        let unshown = Unshown::from(["SBP-A".to_owned()]);
        let page = write(&score.unwrap(), &unshown, "## Notes\n");
        assert!(
            page.contains("| [The language](#opensbp-the-language) | 1 | 1 | 0 | 0 | 2 |"),
            "{page}"
        );
        assert!(page.contains("| **All** | 1 | 1 | 0 | 0 | 2 |"));
        assert!(page.contains("## OpenSBP: The language\n"));
        assert!(page.contains("| SBP-A | done | cli | `sbp_a` | not yet shown in the browser |"));
        assert!(page.contains("| SBP-B | partial |  |  | a\\|b |"));
        assert!(page.contains("\n0 rows are shown in a browser, 1 more by the command, 0 by"));
        assert!(page.contains("\n## Notes\n"));
    }
}
