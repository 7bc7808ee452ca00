//! Outcomes of acts, and reasons why something is not done.

use kerf_wire::{Problem, Why};

/// Outcome of an act: what was noticed, or why it was not done.
pub type Done = Result<Vec<String>, Problem>;

/// A reason why something is not done.
pub fn problem(why: Why, text: impl Into<String>) -> Problem {
    Problem { why, text: text.into() }
}

/// Refuses an answer to a question that is not open any more.
pub fn not_open() -> Problem {
    problem(Why::Late, "this question is not open any more")
}
