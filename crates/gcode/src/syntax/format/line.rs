//! One line: the pieces its code is made of, and what stands between them.

use super::{blank, trim_end, value};
use crate::syntax::text::is_blank;
use crate::syntax::tree::{Block, Keyword, Program, Span};

/// The pieces of a line in their order.
pub(super) struct Pieces(Vec<(Span, Kind)>);

/// Kind of a piece.
#[derive(Clone, Copy)]
enum Kind {
    Word,
    Setting,
    Flow(Keyword),
}

impl Pieces {
    /// The words of a line that holds only letters and numbers.
    pub(super) fn of_move(written: &str) -> Self {
        let letters = written.bytes().enumerate().filter(|(_, b)| b.is_ascii_alphabetic());
        let starts: Vec<usize> = letters.map(|(at, _)| at).collect();
        let ends = starts.iter().copied().skip(1).chain([written.len()]);
        let spans = starts.iter().zip(ends).map(|(start, end)| {
            let length = trim_end(&written[*start..end]).len();
            Span { start: *start as u32, end: (start + length) as u32 }
        });
        Self(spans.map(|span| (span, Kind::Word)).collect())
    }

    pub(super) fn of_block(program: &Program, block: &Block) -> Self {
        let words = program.words_of(block).iter().map(|w| (w.span, Kind::Word));
        let extra = program.extra_of(block);
        let settings = extra.into_iter().flat_map(|e| &e.settings);
        let flow = extra.and_then(|e| e.flow.as_ref());
        let mut pieces: Vec<_> = words
            .chain(settings.map(|s| (s.span, Kind::Setting)))
            .chain(flow.map(|f| (f.span, Kind::Flow(f.keyword))))
            .collect();
        pieces.sort_by_key(|(span, _)| span.start);
        Self(pieces)
    }

    /// Writes the line; as it stands when it is doubtful.
    pub(super) fn push(&self, written: &str, out: &mut String) {
        let before = out.len();
        if self.write(written, out).is_none() {
            out.truncate(before);
            out.push_str(written);
        }
    }

    fn write(&self, written: &str, out: &mut String) -> Option<()> {
        let code = written.trim_start_matches(blank);
        let mut at = written.len() - code.len();
        let indentation = written.get(..at)?;
        out.push_str(indentation);
        let mut line = String::with_capacity(written.len() + 16);
        for (span, kind) in &self.0 {
            push_between(written.get(at..span.start as usize)?, &mut line)?;
            push_piece(written.get(span.start as usize..span.end as usize)?, *kind, &mut line)?;
            at = span.end as usize;
        }
        push_tail(written.get(at..)?, &mut line);
        out.push_str(&line);
        Some(())
    }
}

/// Goes on with a new piece: a blank, where one is missing.
fn push_apart(text: &str, line: &mut String) {
    // The mark of block delete stands at its word, unless a level does.
    if !line.is_empty() && !line.ends_with(' ') && line != "/" {
        line.push(' ');
    }
    line.push_str(text);
}

/// Comments and the mark of block delete, before a piece.
fn push_between(gap: &str, line: &mut String) -> Option<()> {
    let mut rest = gap.trim_start_matches(blank);
    while let Some(first) = rest.chars().next() {
        let length = match first {
            '(' => comment_length(rest)?,
            '/' => 1 + value::digits(&rest[1..]),
            _ => return None,
        };
        push_apart(&rest[..length], line);
        rest = rest[length..].trim_start_matches(blank);
    }
    Some(())
}

/// Appends the text behind the last piece: comments, with their distance.
fn push_tail(tail: &str, line: &mut String) {
    let tail = trim_end(tail);
    if !line.is_empty() && !tail.is_empty() && !tail.starts_with(blank) {
        line.push(' ');
    }
    line.push_str(tail);
}

/// Returns the length of the comment that the text begins with; `None` for one with parentheses within,
/// which controllers read differently.
fn comment_length(text: &str) -> Option<usize> {
    let end = text.find(')')?;
    (!text[1..end].contains('(')).then_some(end + 1)
}

fn push_piece(text: &str, kind: Kind, line: &mut String) -> Option<()> {
    let doubtful = text.contains(['(', ';']) || has_gap(text);
    if doubtful {
        return None;
    }
    let mut piece = String::with_capacity(text.len());
    match kind {
        Kind::Word => value::push(text, &mut piece),
        Kind::Setting => {
            let (target, value) = split_setting(text)?;
            value::push(target, &mut piece);
            piece.push_str(" = ");
            value::push(value, &mut piece);
        }
        Kind::Flow(keyword) => value::push_flow(text, keyword, &mut piece)?,
    }
    push_apart(&piece, line);
    Some(())
}

/// Returns `true` if a number goes on behind a blank.
fn has_gap(text: &str) -> bool {
    let number = |b: u8| b.is_ascii_digit() || b == b'.';
    let mut before = 0;
    let mut blanks = false;
    for byte in text.bytes() {
        if is_blank(byte) {
            blanks = true;
            continue;
        }
        if blanks && number(before) && number(byte) {
            return true;
        }
        (before, blanks) = (byte, false);
    }
    false
}

/// Splits a setting into the text before and behind its `=`; names may hold one.
fn split_setting(text: &str) -> Option<(&str, &str)> {
    let mut in_name = false;
    let at = text.bytes().position(|b| {
        in_name = b == b'<' || in_name && b != b'>';
        b == b'=' && !in_name
    })?;
    Some((text.get(..at)?, text.get(at + 1..)?))
}
