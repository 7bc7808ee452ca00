//! Lines of G-code between OpenSBP lines.

use super::line::Line;
use super::moves::number;
use super::text::is_blank;
use crate::tree::Statement;

impl Line<'_, '_> {
    /// The rest of the line as G-code.
    pub(super) fn gcode(&mut self) -> Statement {
        let text = self.rest();
        self.at = self.end;
        Statement::Gcode(text.into())
    }

    /// True when the code consists of G-code words: a letter and a number each.
    pub(super) fn is_gcode(&self, start: usize) -> bool {
        self.gcode_words(start) > 0
    }

    /// `M3 S12000`: a command of a letter and a digit with another word behind it is G-code.
    pub(super) fn is_gcode_words(&self, start: usize, word: &str) -> bool {
        let numbered = word.as_bytes().get(1).is_some_and(u8::is_ascii_digit);
        numbered && self.gcode_words(start) > 1
    }

    /// How many G-code words the code consists of; 0 when it is something else.
    pub(super) fn gcode_words(&self, start: usize) -> usize {
        const LETTERS: &[u8] = b"NGMXYZABCFSTIJKRPQLHDUVWE";
        let bytes = &self.text.as_bytes()[..self.end];
        let (mut at, mut words) = (start, 0);
        while at < bytes.len() {
            if is_blank(bytes[at]) {
                at += 1;
                continue;
            }
            if matches!(bytes[at], b'(' | b';') {
                break;
            }
            let letter = bytes[at].to_ascii_uppercase();
            at += 1;
            while at < bytes.len() && is_blank(bytes[at]) {
                at += 1;
            }
            at += usize::from(matches!(bytes.get(at), Some(b'-' | b'+')));
            if !LETTERS.contains(&letter) || number(bytes, &mut at).is_none() {
                return 0;
            }
            words += 1;
        }
        // A line begins with the words that row SBP-GCODE-MIX lists.
        let first = self.byte(start).to_ascii_uppercase();
        if words > 0 && !b"NGMXYZABCFST".contains(&first) { 0 } else { words }
    }
}
