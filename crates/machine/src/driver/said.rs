//! Lines between Kerf and a controller, as somebody reads them who looks for a fault.

use std::borrow::Cow;

/// Kind of a line that was sent to a controller, or came from it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
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

/// Kind of a line, with words beside it where the line itself has only a number.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Said {
    /// Its kind.
    pub kind: LineKind,
    /// The words; mostly none.
    pub words: Cow<'static, str>,
}

impl Said {
    /// A line that needs no words.
    pub const fn plain(kind: LineKind) -> Self {
        Self { kind, words: Cow::Borrowed("") }
    }

    /// A line with words beside it.
    pub fn with(kind: LineKind, words: impl Into<Cow<'static, str>>) -> Self {
        Self { kind, words: words.into() }
    }
}
