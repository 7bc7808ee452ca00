//! Labels as they are gathered: their names, and the lines that have them.

use super::names::Names;
use super::text::blank;
use crate::syntax::tree::{Label, LabelId, LabelName};
use std::borrow::Cow;

/// Labels of a file.
#[derive(Debug, Default)]
pub(super) struct Labels {
    list: Vec<Label>,
    names: Names,
    /// The first line of each name, 0 for names that only jumps have.
    lines: Vec<u32>,
}

impl Labels {
    /// The number of a name: the same in any case, and however many blanks are in it.
    pub(super) fn id(&mut self, written: &str) -> LabelId {
        let id = self.names.id(&single_blanks(written));
        if self.lines.len() <= id as usize {
            self.lines.push(0);
        }
        LabelId(id)
    }

    /// Keeps a label; gives its number and the first line that has its name.
    pub(super) fn add(&mut self, written: &str, line: u32) -> (u32, u32) {
        let name = self.id(written);
        self.list.push(Label { name, line });
        let number = self.list.len() as u32 - 1;
        let Some(first) = self.lines.get_mut(name.0 as usize) else { return (number, line) };
        if *first == 0 {
            *first = line;
        }
        (number, *first)
    }

    /// Returns `true` if a jump misses its label.
    pub(super) fn lack_one(&self) -> bool {
        self.lines.contains(&0)
    }

    /// All labels, and their names with the lines that have them.
    pub(super) fn finish(self) -> (Vec<Label>, Vec<LabelName>) {
        let line = |first: &u32| (*first > 0).then_some(*first);
        let named = self.names.into_list().into_iter().zip(&self.lines);
        let names = named.map(|(name, first)| LabelName { name, line: line(first) }).collect();
        (self.list, names)
    }
}

/// True for text that can be the name of a label.
pub(super) fn is_label(text: &str) -> bool {
    !text.is_empty()
        && !text.bytes().any(|b| matches!(b, b',' | b'"' | b'=' | b'(' | b')' | b':' | b';'))
        && !text.starts_with(['&', '$', '%'])
}

/// A label's name with single blanks between its words.
pub(super) fn single_blanks(written: &str) -> Cow<'_, str> {
    if !written.contains(blank) {
        return written.into();
    }
    let words: Vec<&str> = written.split(blank).filter(|word| !word.is_empty()).collect();
    words.join(" ").into()
}
