//! The outcome as a table.

use std::time::Duration;

/// Measurements under one load.
pub struct Row {
    pub load: &'static str,
    /// Time until each stop was heard, without the time that the host stood still.
    heard: Vec<Duration>,
    /// With it.
    raw: Vec<Duration>,
    /// Stops that were not heard at all.
    pub late: usize,
    /// Most memory of the server, bytes.
    pub peak: u64,
    /// Longest time that the host stood still.
    pub stall: Duration,
    pub took: Duration,
}

impl Row {
    pub fn new(load: &'static str) -> Self {
        let (heard, raw) = (Vec::new(), Vec::new());
        Self { load, heard, raw, late: 0, peak: 0, stall: Duration::ZERO, took: Duration::ZERO }
    }

    /// A stop that was heard after a time, of which the host stood still for a part.
    pub fn add(&mut self, heard: Duration, stood_still: Duration) {
        self.raw.push(heard);
        self.heard.push(heard.saturating_sub(stood_still));
        self.raw.sort();
        self.heard.sort();
    }

    /// The time that so large a share of all stops keeps.
    pub fn share(&self, share: f64) -> Duration {
        nth(&self.heard, share)
    }

    /// The time that so large a share of the stops of all rows keeps.
    pub fn share_of_all(rows: &[Self], share: f64) -> Duration {
        let mut heard: Vec<Duration> = rows.iter().flat_map(|row| row.heard.clone()).collect();
        heard.sort_unstable();
        nth(&heard, share)
    }
}

fn nth(sorted: &[Duration], share: f64) -> Duration {
    let place = (share * sorted.len() as f64).ceil() as usize;
    sorted.get(place.max(1) - 1).copied().unwrap_or_default()
}

/// Every row, as a table of Markdown.
pub fn markdown(rows: &[Row]) -> String {
    let head = "| load | stops | heard p50 / p99 / max, ms | as measured p99 / max | host stood still at most | memory | took |";
    let lines = rows.iter().map(line);
    [head.to_owned(), "|---|---|---|---|---|---|---|".to_owned()]
        .into_iter()
        .chain(lines)
        .map(|line| line + "\n")
        .collect()
}

fn line(row: &Row) -> String {
    let ms = |time: Duration| format!("{:.1}", time.as_secs_f64() * 1000.0);
    format!(
        "| {} | {} | {} / {} / {} | {} / {} | {} | {} MB | {:.1} s |",
        row.load,
        row.heard.len(),
        ms(row.share(0.5)),
        ms(row.share(0.99)),
        ms(row.share(1.0)),
        ms(nth(&row.raw, 0.99)),
        ms(nth(&row.raw, 1.0)),
        ms(row.stall),
        row.peak >> 20,
        row.took.as_secs_f64(),
    )
}
