//! The page for users: what works, per area and row by row.

use super::score::{Area, Entry, Score, Status};
use std::fmt::Write as _;

const INTRODUCTION: &str = "\
<!-- Written by `make conformance` from conformance.toml and conformance-notes.md. Do not edit. -->

# What works

Kerf is measured against two manuals: the command reference of OpenSBP with its programming
handbooks, and the reference of the Profiler control. Everything they describe is cut into rows, each
with an id and with something that can be seen when it works. A row counts as **done** when a test of
this project shows it and would fail without it; **partial** when something is missing, which the
note tells; **n/a** when it has no meaning for Kerf, with the reason; else **not yet**.
";

/// The whole page.
pub fn write(score: &Score, notes: &str) -> String {
    let mut page = INTRODUCTION.to_owned();
    overview(&mut page, score);
    page.push('\n');
    page.push_str(notes.trim_end());
    page.push('\n');
    for area in &score.areas {
        section(&mut page, area);
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

fn counts(page: &mut String, title: &str, areas: &[&Area]) {
    let rows = || areas.iter().flat_map(|a| &a.rows);
    let cells: Vec<String> = Status::ALL
        .iter()
        .map(|status| rows().filter(|(_, e)| e.status == *status).count().to_string())
        .collect();
    let _ = writeln!(page, "| {title} | {} | {} |", cells.join(" | "), rows().count());
}

fn section(page: &mut String, area: &Area) {
    let _ = write!(
        page,
        "\n## {}\n\n| row | status | shown by | note |\n|---|---|---|---|\n",
        heading(area)
    );
    for (id, entry) in &area.rows {
        let _ = writeln!(
            page,
            "| {id} | {} | {} | {} |",
            entry.status.word(),
            tests(entry),
            note(entry)
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

fn tests(entry: &Entry) -> String {
    let tests: Vec<String> = entry.tests.iter().map(|test| format!("`{test}`")).collect();
    tests.join(" ")
}

fn note(entry: &Entry) -> String {
    entry.why.as_deref().unwrap_or_default().replace('|', "\\|")
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn counts_and_lists_every_row() {
        let score = Score::read(
            "[opensbp.lang]\ntitle = \"The language\"\n\
             SBP-A = { status = \"done\", tests = [\"sbp_a\"] }\n\
             SBP-B = { status = \"partial\", why = \"a|b\" }\n",
        );
        let page = write(&score.unwrap(), "## Notes\n");
        assert!(
            page.contains("| [The language](#opensbp-the-language) | 1 | 1 | 0 | 0 | 2 |"),
            "{page}"
        );
        assert!(page.contains("| **All** | 1 | 1 | 0 | 0 | 2 |"));
        assert!(page.contains("## OpenSBP: The language\n"));
        assert!(page.contains("| SBP-A | done | `sbp_a` |  |"));
        assert!(page.contains("| SBP-B | partial |  | a\\|b |"));
        assert!(page.contains("\n## Notes\n"));
    }
}
