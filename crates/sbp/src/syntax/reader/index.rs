//! The commands by their letters, and the lines that are surely OpenSBP.

use super::keywords::Keyword;
use super::text::{blank, is_blank};
use crate::syntax::Dialect;
use crate::syntax::table::{self, CommandSpec};

/// The commands by their letters, for one look instead of a search.
#[derive(Debug)]
pub(super) struct CommandIndex(Vec<Option<&'static CommandSpec>>);

impl CommandIndex {
    pub(super) fn new(dialect: Dialect) -> Self {
        let mut index = vec![None; 36 * 36];
        let own = table::fabmo::SPECS.iter().filter(|_| dialect == Dialect::Fabmo);
        for spec in table::tools::ADDED.iter().chain(table::commands()).chain(own) {
            let letters = spec.letters.as_bytes();
            if let (Some(a), Some(b)) = (letters.first(), letters.get(1))
                && let Some(slot) = slot(*a, *b)
            {
                index[slot] = Some(spec);
            }
        }
        // Both spellings of motors off are in use.
        if let (Some(zero), Some(letter)) = (slot(b'M', b'0'), slot(b'M', b'O')) {
            index[zero] = index[zero].or(index[letter]);
        }
        Self(index)
    }

    /// The command of a word, in any case.
    pub(super) fn find(&self, word: &str) -> Option<&'static CommandSpec> {
        let &[a, b] = word.as_bytes() else { return None };
        self.0[slot(a, b)?]
    }
}

fn slot(a: u8, b: u8) -> Option<usize> {
    let place = |byte: u8| match byte.to_ascii_uppercase() {
        letter @ b'A'..=b'Z' => Some(usize::from(letter - b'A')),
        digit @ b'0'..=b'9' => Some(usize::from(digit - b'0') + 26),
        _ => None,
    };
    Some(place(a)? * 36 + place(b)?)
}

/// Returns `true` if a line of a G-code file is surely OpenSBP: a two-letter command, a statement, a
/// variable, a label, a comment behind an apostrophe.
pub(super) fn is_opensbp(line: &str, commands: &CommandIndex) -> bool {
    if !may_be_opensbp(line.as_bytes()) {
        return false;
    }
    let line = line.trim_matches(blank);
    if line.starts_with(['&', '\'']) {
        return true;
    }
    let end = line.bytes().position(|b| !(b.is_ascii_alphanumeric() || b == b'_'));
    let (word, rest) = line.split_at(end.unwrap_or(line.len()));
    let separated = rest.is_empty() || rest.starts_with([',', ' ', '\t']);
    // Fanuc's IF [#1 LT 5] GOTO 10 is refused as what it is.
    let fanuc = rest.trim_matches(blank);
    if fanuc.starts_with('[')
        || word.eq_ignore_ascii_case("GOTO") && fanuc.starts_with(|c: char| c.is_ascii_digit())
    {
        return false;
    }
    Keyword::find(word).is_some()
        || separated && commands.find(word).is_some()
        || word.eq_ignore_ascii_case("CN") && rest.starts_with(',')
        || word.eq_ignore_ascii_case("C") && rest.starts_with("#,")
        || rest.trim_matches(blank) == ":"
}

/// Quick no to nearly every line of G-code: its first letter stands before a number.
fn may_be_opensbp(line: &[u8]) -> bool {
    let at = line.iter().position(|b| !is_blank(*b)).unwrap_or_default();
    match line.get(at) {
        Some(b'&' | b'\'') => true,
        Some(b) if b.is_ascii_alphabetic() => match line.get(at + 1) {
            Some(next) if next.is_ascii_digit() => line.get(at + 2) == Some(&b','),
            Some(next) => next.is_ascii_alphabetic() || matches!(next, b'#' | b'_' | b':'),
            None => false,
        },
        _ => false,
    }
}
