//! Lines that were sent to a controller, and its answers.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use ts_rs::TS;

/// Kind of a line between Kerf and a controller.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub enum LineKind {
    /// A line that was sent.
    #[default]
    Line,
    /// A byte that is obeyed at once, wherever it stands in a line.
    AtOnce,
    /// The question for its state.
    Ask,
    /// The answer to that.
    Report,
    /// It took a line.
    Ok,
    /// It refused one.
    Error,
    /// It stopped by itself.
    Alarm,
    /// It tells something else.
    Message,
    /// It has started.
    Welcome,
    /// The line itself: opened, lost, open again.
    Link,
}

/// A line that was sent or came.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct ControllerLine {
    /// Its number; they count up.
    pub number: u32,
    /// Its time, seconds since 1970 with their thousandths.
    #[ts(type = "UnixSeconds")]
    pub at: f64,
    /// It was sent; else it came.
    pub sent: bool,
    /// Its kind.
    pub kind: LineKind,
    /// The line itself; of a byte that is obeyed at once its code.
    pub text: String,
    /// Words beside it, as those of an error's number; mostly none.
    pub words: String,
}

/// A portion of what passed.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct ControllerLines {
    /// The lines, the oldest first.
    pub lines: Vec<ControllerLine>,
    /// The number from which to ask on.
    pub next: u32,
    /// There are more behind them already.
    pub more: bool,
    /// Lines that are not kept any more, of all that there were.
    pub gone: u32,
}
