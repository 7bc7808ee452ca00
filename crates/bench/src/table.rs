//! Figures as rows: the same on the terminal and in the documentation.

use crate::figure::{Figure, Goal};

const HEAD: [&str; 7] =
    ["input", "what", "processor (low–high)", "rate", "elapsed", "memory", "goal"];

/// A table in Markdown, columns aligned so that it reads well as text too.
pub fn markdown(figures: &[Figure]) -> String {
    let mut rows = vec![HEAD.map(String::from), ["---"; 7].map(String::from)];
    rows.extend(figures.iter().map(row));
    let width = |i: usize| rows.iter().map(|row| row[i].chars().count()).max().unwrap_or(0);
    let widths: [usize; 7] = std::array::from_fn(width);
    let line = |row: &[String; 7]| {
        let cells = row.iter().zip(widths).map(|(cell, width)| format!(" {cell:<width$} |"));
        format!("|{}\n", cells.collect::<String>())
    };
    rows.iter().map(line).collect()
}

fn row(figure: &Figure) -> [String; 7] {
    let cpu = figure.cpu_s;
    [
        figure.input.into(),
        figure.stage.into(),
        format!("{} ({}–{})", ms(cpu.median), ms(cpu.low), ms(cpu.high)),
        format!("{:.2} M {}/s", figure.rate() / 1e6, figure.unit),
        ms(figure.wall_s.median),
        figure.peak.map_or_else(String::new, megabytes),
        goal(figure),
    ]
}

fn goal(figure: &Figure) -> String {
    let asked = match figure.goal {
        None => return String::new(),
        Some(Goal::Rate(least)) => format!("≥ {} M/s", least / 1e6),
        Some(Goal::Within(seconds, f64::INFINITY)) => format!("< {}", ms(seconds)),
        Some(Goal::Within(seconds, bytes)) => format!("< {}, < {}", ms(seconds), megabytes(bytes)),
    };
    format!("{asked}: {}", if figure.meets() == Some(true) { "met" } else { "missed" })
}

fn ms(seconds: f64) -> String {
    let decimals = if seconds < 1e-2 { 2 } else { 0 };
    format!("{:.decimals$} ms", seconds * 1e3)
}

fn megabytes(bytes: f64) -> String {
    format!("{:.0} MB", bytes / 1e6)
}
