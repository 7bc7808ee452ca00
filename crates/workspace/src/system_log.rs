//! The system log: a line when Kerf starts, changes between moving and drawing, has run a part file,
//! or closes (programming handbook, SbSystem Log; readings, A-118).
//!
//! ```text
//!  NFP,CUT,,,,,,14:03:05,2026-11-21,,sim,kerf-0.1.0,,,,,,,~1234567
//!  /parts/a.sbp,CUT,00:00:05,14:03:10,2026-11-21,,sim,kerf-0.1.0,,,,,,,~2345678
//!  /parts/b.sbp,CUT,00:00:02,14:04:00,2026-11-21,error in line 3,sim,kerf-0.1.0,,,,,,,~4567890
//!  uCommand,CUT,00:00:00,14:04:30,2026-11-21,one command of two letters expected …,sim,…
//!  NORMAL,Total Time,00:12:30,14:15:35,2026-11-21,,sim,kerf-0.1.0,,,,,,,~3456789
//! ```
//!
//! The item behind the date is empty but where a part file ended in an error, or a command that other
//! software passed in was refused. The last item is a check
//! number of the line before it, so that a line that was changed is noticed.

use kerf_journal::Started;
use std::time::Instant;

/// Name of the file in the data folder.
pub const SYSTEM_LOG: &str = "SbSys.log";

/// Keys of values that end each line; empty where nobody set them.
pub(crate) const OWNER: [&str; 6] = ["Serial", "Operator", "Sys1", "Sys2", "Sys3", "Sys4"];

/// Seven digits.
const CHECK_NUMBERS: u32 = 10_000_000;

/// Start of Kerf: with a part file or not, and with which words of the start-up line.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Opening {
    /// A part file was given.
    pub file: bool,
    /// Port, open, timing, close, display.
    pub words: [String; 5],
}

/// Writes the system log of one session.
#[derive(Clone, Debug)]
pub struct SystemLog {
    opening: Opening,
    now: fn() -> Started,
    began: Instant,
}

impl SystemLog {
    /// Of a session that begins now, by a clock on the wall.
    pub fn new(opening: Opening, now: fn() -> Started) -> Self {
        Self { opening, now, began: Instant::now() }
    }

    /// The line of a session that begins, or goes on in another mode.
    pub(crate) fn mode(&self, draws: bool) -> String {
        let start = if self.opening.file { "StartFile" } else { "NFP" };
        format!("{start},{},{}", mode_word(draws), self.opening.words.join(","))
    }

    /// The line of a session that is over.
    pub(crate) fn close(&self, kind: &str) -> String {
        format!("{kind},Total Time,{}", clock(self.began.elapsed().as_secs_f64()))
    }

    /// A line with time, date and the tail, of which the owner's values are a part.
    pub(crate) fn line(&self, head: &str, remark: &str, owner: [String; OWNER.len()]) -> String {
        let Started { time, date } = (self.now)();
        let version = env!("CARGO_PKG_VERSION");
        let line = format!("{head},{time},{date},{remark},sim,kerf-{version},{},", owner.join(","));
        format!("{line}{}\n", check_number(&line))
    }
}

/// The word for drawing or moving.
pub const fn mode_word(draws: bool) -> &'static str {
    if draws { "PREVIEW" } else { "CUT" }
}

/// The check number of a line.
fn check_number(line: &str) -> String {
    format!("~{:07}", crc32fast::hash(line.as_bytes()) % CHECK_NUMBERS)
}

/// Numbers of the lines of a system log that are not as they were written.
pub fn changed_lines(text: &str) -> Vec<usize> {
    let sound = |line: &str| {
        let end = line.rfind('~').unwrap_or_default();
        line[end..] == check_number(&line[..end])
    };
    text.lines().enumerate().filter(|(_, line)| !sound(line)).map(|(i, _)| i + 1).collect()
}

/// Hours, minutes and seconds.
pub fn clock(seconds: f64) -> String {
    let whole = seconds.max(0.0).round() as u64;
    format!("{:02}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_changed_line_is_noticed() {
        let line = "NFP,CUT,,,,,,14:03:05,2026-11-21,,sim,kerf-0.1.0,,,,,,,";
        let whole = format!("{line}{}\n", check_number(line));
        assert_eq!(changed_lines(&whole.repeat(3)), [0; 0]);
        let edited = whole.replace("14:03", "13:03");
        assert_eq!(changed_lines(&(whole.clone() + &edited + "\n" + &whole)), [2, 3]);
        assert_eq!(changed_lines("~\n~é\né~0000000"), [1, 2, 3]);
    }

    #[test]
    fn a_line_that_begins_has_nineteen_items() {
        let log = SystemLog::new(Opening::default(), Started::default);
        assert_eq!(log.mode(false), "NFP,CUT,,,,,");
        let words = ["1", "4", "", "2", ""].map(str::to_owned);
        let log = SystemLog::new(Opening { file: true, words }, Started::default);
        assert_eq!(log.mode(true), "StartFile,PREVIEW,1,4,,2,");
    }

    #[test]
    fn times_have_hours() {
        assert_eq!((clock(5.2), clock(3725.0)), ("00:00:05".into(), "01:02:05".into()));
    }
}
