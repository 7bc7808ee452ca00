//! The place at which a program is taken up.

use serde::{Deserialize, Serialize};

/// The line at which a file begins or goes on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct GoTo {
    /// Counted from 1.
    pub line: u32,
    /// Settings and assignments of the lines before it are carried out on the way.
    pub settings: bool,
}

impl GoTo {
    /// Reads `120`, `120 settings`, or `last` for the line executed last, when that is known.
    pub fn read(words: &str, last: Option<u32>) -> Option<Self> {
        let mut words = words.split_whitespace();
        let first = words.next()?;
        let line = match first.parse() {
            Ok(line) => Some(line).filter(|n| *n > 0)?,
            Err(_) => last.filter(|_| first.eq_ignore_ascii_case("last"))?,
        };
        let settings = match words.next() {
            None => false,
            Some(word) if word.eq_ignore_ascii_case("settings") => true,
            Some(_) => return None,
        };
        words.next().is_none().then_some(Self { line, settings })
    }

    /// The words of a warning when a file has fewer lines than this: what is wrong, and how far it goes.
    pub fn beyond(self, file: &str, lines: u32) -> Option<(String, String)> {
        (self.line > lines).then(|| {
            (
                format!("there is no line {} in {file}", self.line),
                format!("its last line is {lines}"),
            )
        })
    }

    /// The index of the line that runs next, and the one before which lines are passed over but for what they set up.
    ///
    /// Settings on the way are those behind the line that would be next, or from the beginning when it lies further down.
    pub fn way_from(self, next: u32) -> (u32, Option<u32>) {
        let index = self.line.saturating_sub(1);
        match self.settings {
            false => (index, None),
            true => (if index < next { 0 } else { next }, Some(index)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn settings_on_the_way_are_those_not_executed_yet() {
        let way = |line, settings, next| GoTo { line, settings }.way_from(next);
        assert_eq!(way(10, false, 4), (9, None));
        assert_eq!(way(10, true, 4), (4, Some(9)));
        assert_eq!(way(10, true, 9), (9, Some(9)));
        assert_eq!(way(3, true, 4), (0, Some(2)));
    }

    #[test]
    fn a_line_is_named_by_number_or_as_the_last() {
        let to = |line, settings| Some(GoTo { line, settings });
        assert_eq!(GoTo::read("120", None), to(120, false));
        assert_eq!(GoTo::read(" 120 Settings", None), to(120, true));
        assert_eq!(GoTo::read("last", Some(57)), to(57, false));
        for wrong in ["", "0", "-1", "last", "120 x", "120 settings 1"] {
            assert_eq!(GoTo::read(wrong, None), None, "{wrong}");
        }
    }
}
