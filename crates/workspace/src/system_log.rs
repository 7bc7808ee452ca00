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

use crate::Workspace;
use kerf_journal::Started;
use kerf_program::{HostError, Settings};
use std::time::Instant;

/// Name of the file in the data folder.
pub const SYSTEM_LOG: &str = "SbSys.log";

/// Keys of values that end each line; empty where nobody set them.
const OWNER: [&str; 6] = ["Serial", "Operator", "Sys1", "Sys2", "Sys3", "Sys4"];

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
    fn mode(&self, draws: bool) -> String {
        let start = if self.opening.file { "StartFile" } else { "NFP" };
        format!("{start},{},{}", mode_word(draws), self.opening.words.join(","))
    }

    fn close(&self, kind: &str) -> String {
        format!("{kind},Total Time,{}", clock(self.began.elapsed().as_secs_f64()))
    }
}

impl Workspace {
    /// The session begins: so does the log of it, where one is wanted (VD).
    pub fn open_system_log(&mut self, log: SystemLog, settings: &Settings, draws: bool) {
        let line = log.mode(draws);
        self.system_log = Some(log);
        self.log(settings, &line);
    }

    /// Deletes what was logged so far, and begins a new log.
    pub fn begin_system_log_anew(
        &mut self,
        settings: &Settings,
        draws: bool,
    ) -> Result<(), HostError> {
        self.put_data(SYSTEM_LOG, "").map_err(HostError::Refused)?;
        self.log_mode(settings, draws);
        Ok(())
    }

    /// The session is over.
    pub fn close_system_log(&mut self, settings: &Settings, kind: &str) {
        if let Some(log) = self.system_log.take() {
            let line = log.close(kind);
            self.system_log = Some(log);
            self.log(settings, &line);
            self.system_log = None;
        }
    }

    /// From here on the machine only draws, or moves again.
    pub fn log_mode(&mut self, settings: &Settings, draws: bool) {
        if let Some(line) = self.system_log.as_ref().map(|log| log.mode(draws)) {
            self.log(settings, &line);
        }
    }

    /// A part file was run, or refused, and took so many seconds of machine time; an error ended it at
    /// a line.
    pub fn log_file(
        &mut self,
        settings: &Settings,
        file: &str,
        draws: bool,
        seconds: f64,
        error: Option<u32>,
    ) {
        // Typed lines and what comes with Kerf are no files of the user.
        if !self.is_file(file) {
            return;
        }
        let path = self.full_path(file);
        let path = if path.contains(',') { format!("\"{path}\"") } else { path };
        let remark = error.map_or_else(String::new, |line| format!("error in line {line}"));
        self.log_with(
            settings,
            &format!("{path},{},{}", mode_word(draws), clock(seconds)),
            &remark,
        );
    }

    fn log(&mut self, settings: &Settings, head: &str) {
        self.log_with(settings, head, "");
    }

    /// Adds time, date and the tail. A log that cannot be written stops nothing.
    pub fn log_with(&mut self, settings: &Settings, head: &str, remark: &str) {
        let Some(log) = self.system_log.as_ref().filter(|_| settings.display.system_log) else {
            return;
        };
        let Started { time, date } = (log.now)();
        let owner = OWNER.map(|key| self.stored.get(key).unwrap_or_default().replace(',', " "));
        let version = env!("CARGO_PKG_VERSION");
        let line = format!("{head},{time},{date},{remark},sim,kerf-{version},{},", owner.join(","));
        let line = format!("{line}{}\n", check_number(&line));
        if let Err(error) = self.add_to_data(SYSTEM_LOG, &line) {
            self.stored.tell_trouble(format!("{SYSTEM_LOG}: {error}"));
        }
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
