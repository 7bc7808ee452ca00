//! Findings that come again and again at one place: a loop finds what it finds a million times.

use crate::{Code, Diagnostic, Severity, with_commas};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Findings of one kind at one place that differ in their words, at the most; what is more is only counted.
const MOST_WORDS: usize = 20;

/// The line of a file, and the kind of finding.
type Spot = (Arc<str>, u32, Code);

/// Tells which findings are new, and counts those that are not.
#[derive(Debug, Default)]
pub struct Repetitions {
    seen: BTreeMap<Spot, Seen>,
}

#[derive(Debug)]
struct Seen {
    first: Diagnostic,
    words: Vec<String>,
    again: u64,
}

impl Repetitions {
    /// Counts a finding; true when it is to be told.
    pub fn is_new(&mut self, found: &Diagnostic) -> bool {
        let spot = (found.place.file.clone(), found.place.line, found.code);
        let seen = self.seen.entry(spot).or_insert_with(|| Seen::of(found));
        let is_new = seen.words.len() < MOST_WORDS && !seen.words.contains(&found.message);
        if is_new {
            seen.words.push(found.message.clone());
        } else {
            seen.again += 1;
        }
        is_new
    }

    /// Tells how often something was found that was not told each time; forgets it.
    pub fn diagnostics(&mut self) -> Vec<Diagnostic> {
        let seen = std::mem::take(&mut self.seen).into_values();
        seen.filter(|seen| seen.again > 0).map(Seen::told).collect()
    }
}

impl Seen {
    fn of(found: &Diagnostic) -> Self {
        Self { first: found.clone(), words: Vec::new(), again: 0 }
    }

    fn told(self) -> Diagnostic {
        let times = if self.again == 1 {
            "once more".into()
        } else {
            format!("{} more times", with_commas(self.again))
        };
        let message = format!("this line did the same {times}: {}", self.first.message);
        let told = Diagnostic { message, hint: String::new(), ..self.first };
        told.severity(Severity::Note)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::SourcePlace;

    fn found(line: u32, message: &str) -> Diagnostic {
        Diagnostic::new(Code::OutsideLimits, SourcePlace::line("a.sbp".into(), line), message)
    }

    #[test]
    fn what_a_loop_finds_is_told_once_and_counted() {
        let mut seen = Repetitions::default();
        let told = (0..1_204_333).filter(|_| seen.is_new(&found(2, "X 12 is outside"))).count();
        assert!(seen.is_new(&found(3, "X 12 is outside")));
        assert_eq!(told, 1);
        let counted = seen.diagnostics();
        let text = "this line did the same 1,204,332 more times: X 12 is outside";
        assert_eq!(counted.iter().map(|d| d.message.as_str()).collect::<Vec<_>>(), [text]);
        assert_eq!((counted[0].severity, counted[0].place.line), (Severity::Note, 2));
    }

    #[test]
    fn a_line_that_finds_something_else_each_time_is_told_so_often() {
        let mut seen = Repetitions::default();
        let told =
            (0..1000).filter(|n| seen.is_new(&found(2, &format!("X {n} is outside")))).count();
        assert_eq!(told, MOST_WORDS);
        assert!(seen.diagnostics()[0].message.starts_with("this line did the same 980 more times"));
        assert!(seen.diagnostics().is_empty());
    }
}
