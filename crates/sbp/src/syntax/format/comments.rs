//! The column of the comments at line ends.
//!
//! Lines whose comments stand one below the other are a block, also where lines without a comment lie between them. A
//! block keeps its column, or gets the first one that its longest line leaves free.
//!
//! ```text
//! ms, 1 , 2    ' slowly          MS,1,2       ' slowly
//!                           ─►
//! &depth=-1    ' of a pass       &depth = -1  ' of a pass
//! ```
//!
//! A comment with a tab before it stands in no column; it keeps its distance, as one alone does.

use super::{blank, trim_end};

/// A line that is tidy but for the place of its comment.
#[derive(Debug)]
pub(super) struct Line<'a> {
    code: String,
    /// Text behind the code: the comment and the blanks before it.
    rest: &'a str,
    /// Column of the comment as it is written, in characters; `None` where it stands in none.
    column: Option<usize>,
}

impl<'a> Line<'a> {
    /// A line as it is written up to its comment, which begins behind the byte `end`, and its code, tidy.
    pub(super) fn new(code: String, written: &'a str, end: usize) -> Self {
        let rest = trim_end(&written[end..]);
        let comment = rest.trim_start_matches(blank);
        let before = &written[..end + rest.len() - comment.len()];
        let aligned = !comment.is_empty() && !before.contains('\t');
        Self { code, rest, column: aligned.then(|| before.chars().count()) }
    }

    /// A line without a comment behind its code.
    pub(super) fn plain(code: impl Into<String>) -> Self {
        Self { code: code.into(), rest: "", column: None }
    }

    fn width(&self) -> usize {
        self.code.chars().count()
    }

    /// Appends the line, its comment in a column or as far from the code as it is written, a blank at least.
    pub(super) fn push(&self, column: Option<usize>, out: &mut String) {
        out.push_str(&self.code);
        match column {
            Some(column) => {
                out.extend(std::iter::repeat_n(' ', column.saturating_sub(self.width())));
                out.push_str(self.rest.trim_start_matches(blank));
            }
            None if self.rest.starts_with('\'') => {
                out.push(' ');
                out.push_str(self.rest);
            }
            None => out.push_str(self.rest),
        }
    }
}

/// The column that the comment of each line gets; `None` where it keeps its distance.
pub(super) fn columns(lines: &[Line<'_>]) -> Vec<Option<usize>> {
    let commented: Vec<usize> = (0..lines.len()).filter(|i| !lines[*i].rest.is_empty()).collect();
    let mut columns = vec![None; lines.len()];
    for block in commented.chunk_by(|a, b| lines[*a].column == lines[*b].column) {
        let Some(written) = lines[block[0]].column.filter(|_| block.len() > 1) else { continue };
        let longest = block.iter().map(|i| lines[*i].width()).max().unwrap_or(0);
        for line in block {
            columns[*line] = Some(written.max(longest + 1));
        }
    }
    columns
}
