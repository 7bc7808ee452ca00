//! The drawing that is being read to be opened. It may take long, and somebody may open another one meanwhile.

use crate::locks::lock;
use crate::refusal::problem;
use kerf_formats::{Ended, Finding, Imported};
use kerf_wire::{Problem, Why};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex};

/// The reading under way.
#[derive(Debug, Default)]
pub struct Readings(Mutex<Arc<Reading>>);

/// One reading of a file.
#[derive(Debug, Default)]
pub struct Reading(AtomicBool);

impl Readings {
    /// Begins another reading; the one before is given up.
    pub fn begin(&self) -> Arc<Reading> {
        let mut present = lock(&self.0);
        present.0.store(true, Ordering::Relaxed);
        *present = Arc::default();
        present.clone()
    }
}

impl Reading {
    /// Nobody waits for it any more.
    pub fn is_given_up(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}

/// A drawing that was read to its end.
///
/// # Errors
/// It was given up, or stands for more shapes than anybody cuts.
pub fn whole(name: &str, read: Imported) -> Result<Imported, Problem> {
    match read.ended {
        None => Ok(read),
        Some(Ended::GivenUp) => {
            let text = format!(
                "{name} was not read to its end: it was given up, or another drawing was opened meanwhile"
            );
            Err(problem(Why::State, text))
        }
        Some(Ended::TooMuch) => {
            let told = |found: Finding| format!("{name}:{}: {}", found.line, found.text);
            let last = read.findings.into_iter().rfind(|found| found.line > 0);
            Err(problem(Why::Mistake, last.map_or_else(|| name.to_owned(), told)))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn opening_another_drawing_gives_up_the_one_that_is_read() {
        let readings = Readings::default();
        let (first, second) = (readings.begin(), readings.begin());
        assert!(first.is_given_up() && !second.is_given_up());
    }
}
