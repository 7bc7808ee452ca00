//! Words and numbers for people, and standard output.

use anyhow::{Context, Result};
use kerf_files::{Disk, RealDisk};
use kerf_program::decimal;
use kerf_trace::Summary;
use std::io::{self, Write};
use std::path::Path;

/// Writes to standard output. A reader that went away (`kerf … | head`) is no error.
pub fn print(text: &str) {
    let _ = io::stdout().write_all(text.as_bytes());
}

/// Passes on how writing to standard output went: a reader that went away is no error there.
pub fn unless_gone(written: io::Result<()>) -> io::Result<()> {
    match written {
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
        written => written,
    }
}

/// Writes a file whole: where that fails half-way, what stood there stays.
///
/// # Errors
/// Names the file and what the system said.
pub fn file(path: &Path, bytes: impl AsRef<[u8]>) -> Result<()> {
    RealDisk.write(path, bytes.as_ref()).with_context(|| format!("cannot write {}", path.display()))
}

/// A duration: `12.3 s`, `4 min 05 s`, `2 h 03 min`.
pub fn duration(seconds: f64) -> String {
    if seconds < 60.0 {
        return format!("{seconds:.1} s");
    }
    let whole = seconds.round() as u64;
    let (hours, minutes, seconds) = (whole / 3600, whole / 60 % 60, whole % 60);
    if hours == 0 {
        format!("{minutes} min {seconds:02} s")
    } else {
        format!("{hours} h {minutes:02} min")
    }
}

/// So many of something: `1 arc`, `2 arcs`.
pub fn count(number: u64, thing: &str) -> String {
    let s = if number == 1 { "" } else { "s" };
    format!("{number} {thing}{s}")
}

/// Describes the bounds of the cutting moves: `X 0 … 4, Y 0 … 3, Z -0.25 … 0 in`; nothing when nothing is cut.
pub fn bounds(summary: &Summary) -> Option<String> {
    let bounds = &summary.tally.bounds;
    let mm = summary.unit.mm();
    let axis = |i: usize| {
        let [low, high] = [bounds.min[i], bounds.max[i]].map(|v| decimal(v / mm, 3));
        format!("{low} … {high}")
    };
    let unit = summary.unit.symbol();
    (!bounds.is_empty()).then(|| format!("X {}, Y {}, Z {} {unit}", axis(0), axis(1), axis(2)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn durations_read_well() {
        for (seconds, text) in [
            (0.0, "0.0 s"),
            (59.94, "59.9 s"),
            (60.0, "1 min 00 s"),
            (245.4, "4 min 05 s"),
            (7380.0, "2 h 03 min"),
        ] {
            assert_eq!(duration(seconds), text);
        }
    }

    #[test]
    fn one_is_no_plural() {
        assert_eq!((count(1, "arc"), count(0, "arc")), ("1 arc".into(), "0 arcs".into()));
    }
}
