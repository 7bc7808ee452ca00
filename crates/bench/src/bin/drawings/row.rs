//! Figures as rows of a table.

/// One figure.
pub struct Row {
    /// Name of what was measured.
    pub what: String,
    /// Whose it is.
    pub by: &'static str,
    /// Result.
    pub result: String,
    /// Processor time, milliseconds.
    pub ms: f64,
    /// Goal, and whether it is met.
    pub goal: Option<(String, bool)>,
}

impl Row {
    /// A figure of which nothing is asked.
    pub fn new(what: impl Into<String>, by: &'static str, result: String, ms: f64) -> Self {
        Self { what: what.into(), by, result, ms, goal: None }
    }

    /// Sets the goal of the figure.
    #[must_use]
    pub fn asked(self, goal: impl Into<String>, met: bool) -> Self {
        Self { goal: Some((goal.into(), met)), ..self }
    }
}

/// The rows in Markdown.
pub fn table(rows: &[Row]) -> String {
    let mut text =
        String::from("| what | by | result | milliseconds | goal |\n|---|---|---|---|---|\n");
    for Row { what, by, result, ms, goal } in rows {
        let goal = goal.as_ref().map_or_else(String::new, |(asked, met)| {
            format!("{asked}: {}", if *met { "met" } else { "missed" })
        });
        text += &format!("| {what} | {by} | {result} | {ms:.0} | {goal} |\n");
    }
    text
}
