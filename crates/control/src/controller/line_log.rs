//! Record of the lines that were sent to a controller and of its answers; the oldest go first.
//!
//! The [`Connection`](super::Connection) writes every byte that passes into it, whatever runs. Whoever wants to look, on another
//! thread, takes a portion at a time: the lock is never held for longer than it takes to copy one.

use super::line_file::LineFile;
use kerf_machine::driver::{LineKind, Said, Wired};
use std::collections::VecDeque;
use std::fmt;
use std::io;
use std::path::Path;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{SystemTime, UNIX_EPOCH};

/// Lines that are kept at most.
const MOST_LINES: usize = 30_000;

/// Bytes of their texts that are kept at most.
const MOST_BYTES: usize = 2 << 20;

/// Lines that one portion looks at, at most: the machine waits no longer than for them.
const LOOKED_AT: usize = 2000;

/// A line longer than this is cut, bytes.
const LONGEST: usize = 1024;

/// A line that was sent or came.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LoggedLine {
    /// Its number: they count up from 0, whatever is still kept.
    pub number: u64,
    /// Its time, milliseconds since 1970.
    pub at_ms: u64,
    /// It was sent; else it came.
    pub is_sent: bool,
    /// Its kind.
    pub kind: LineKind,
    /// The line itself; of a byte that is obeyed at once its code.
    pub text: String,
    /// Words beside it.
    pub words: String,
}

/// Lines behind a number.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Portion {
    /// The lines.
    pub lines: Vec<LoggedLine>,
    /// Number from which to ask on.
    pub next: u64,
    /// There are more behind them already.
    pub is_cut: bool,
    /// Lines that are not kept any more, of all that there were.
    pub gone: u64,
}

/// The record of one controller.
#[derive(Default)]
pub struct LineLog(Mutex<Kept>);

#[derive(Default)]
struct Kept {
    lines: VecDeque<LoggedLine>,
    bytes: usize,
    next: u64,
    /// Lines that are not whole: sent, and coming.
    open: [Vec<u8>; 2],
    file: Option<LineFile>,
}

impl LineLog {
    fn lock(&self) -> MutexGuard<'_, Kept> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Bytes were sent, or came; the driver tells what they are.
    pub fn passes(&self, bytes: &[u8], is_sent: bool, driver: &dyn Wired) {
        if !bytes.is_empty() {
            self.lock().passes(bytes, is_sent, driver);
        }
    }

    /// Something became of the line itself: it was opened, or lost and why.
    pub fn link(&self, words: &str) {
        let mut kept = self.lock();
        kept.open = Default::default();
        let said = Said::with(LineKind::Link, words.to_owned());
        kept.push(now_ms(), false, String::new(), said);
    }

    /// Writes each further line into a file, those that are kept first.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn writes_to(&self, path: &Path) -> io::Result<()> {
        let file = LineFile::create(path)?;
        let mut kept = self.lock();
        kept.lines.iter().for_each(|line| file.write(line));
        kept.file = Some(file);
        Ok(())
    }

    /// Returns lines from a number on, as many as are looked at once, of the kinds that are wanted.
    pub fn since(&self, number: u64, wants: impl Fn(LineKind) -> bool) -> Portion {
        let kept = self.lock();
        let gone = kept.lines.front().map_or(kept.next, |line| line.number);
        let from = number.clamp(gone, kept.next);
        let looked = kept.lines.iter().skip((from - gone) as usize).take(LOOKED_AT);
        let lines = looked.filter(|line| wants(line.kind)).cloned().collect();
        let next = kept.next.min(from + LOOKED_AT as u64);
        Portion { lines, next, is_cut: next < kept.next, gone }
    }

    /// Returns the last lines of the kinds that are wanted, at most so many, the oldest first.
    pub fn last(&self, most: usize, wants: impl Fn(LineKind) -> bool) -> Vec<LoggedLine> {
        let kept = self.lock();
        let last = kept.lines.iter().rev().filter(|line| wants(line.kind)).take(most);
        let mut lines: Vec<_> = last.cloned().collect();
        lines.reverse();
        lines
    }
}

impl fmt::Debug for LineLog {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} lines", self.lock().next)
    }
}

impl Kept {
    fn passes(&mut self, bytes: &[u8], is_sent: bool, driver: &dyn Wired) {
        let at_ms = now_ms();
        if is_sent && driver.sends_file() {
            let said = Said::with(LineKind::Line, format!("{} bytes of a file", bytes.len()));
            return self.push(at_ms, true, String::new(), said);
        }
        for byte in bytes {
            let at_once = if is_sent { driver.at_once(*byte) } else { None };
            match (at_once, byte) {
                (Some(said), _) => self.push(at_ms, true, code(*byte), said),
                (None, b'\n') => {
                    let line = std::mem::take(&mut self.open[usize::from(is_sent)]);
                    let text = printable(&line);
                    if !text.is_empty() {
                        let said = driver.said(&text, is_sent);
                        self.push(at_ms, is_sent, text, said);
                    }
                }
                (None, byte) => {
                    let open = &mut self.open[usize::from(is_sent)];
                    if open.len() < LONGEST {
                        open.push(*byte);
                    }
                }
            }
        }
    }

    fn push(&mut self, at_ms: u64, is_sent: bool, text: String, said: Said) {
        let Said { kind, words } = said;
        let words = words.into_owned();
        let line = LoggedLine { number: self.next, at_ms, is_sent, kind, text, words };
        self.file.iter().for_each(|file| file.write(&line));
        self.next += 1;
        self.bytes += line.bytes();
        self.lines.push_back(line);
        while self.lines.len() > MOST_LINES || self.bytes > MOST_BYTES {
            let Some(oldest) = self.lines.pop_front() else { break };
            self.bytes -= oldest.bytes();
        }
    }
}

impl LoggedLine {
    const fn bytes(&self) -> usize {
        self.text.len() + self.words.len()
    }
}

fn now_ms() -> u64 {
    SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |since| since.as_millis() as u64)
}

/// A byte as it is shown: itself where it can be printed, else its code.
fn code(byte: u8) -> String {
    if byte.is_ascii_graphic() { char::from(byte).to_string() } else { format!("0x{byte:02X}") }
}

/// A line without what cannot be shown.
fn printable(line: &[u8]) -> String {
    let shown = |c: char| if c.is_control() { char::REPLACEMENT_CHARACTER } else { c };
    String::from_utf8_lossy(line).trim().chars().map(shown).collect()
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use kerf_driver_grbl::Grbl;

    fn texts(lines: &[LoggedLine]) -> Vec<&str> {
        lines
            .iter()
            .map(|line| if line.text.is_empty() { &*line.words } else { &*line.text })
            .collect()
    }

    #[test]
    fn bytes_become_lines_with_those_that_are_obeyed_at_once_between_them() {
        let (log, grbl) = (LineLog::default(), Grbl::new());
        log.passes(b"G1X", true, &grbl);
        log.passes(b"<Idle|MPos:0,0,0>\r\nerr", false, &grbl);
        log.passes(b"?\x9910\n!", true, &grbl);
        log.passes(b"or:9\r\n", false, &grbl);
        let all = log.last(100, |_| true);
        assert_eq!(texts(&all), ["<Idle|MPos:0,0,0>", "?", "0x99", "G1X10", "!", "error:9"]);
        assert_eq!(all[5].words, "it is locked by an alarm");
        assert_eq!(all.iter().map(|line| line.number).collect::<Vec<_>>(), [0, 1, 2, 3, 4, 5]);
        let errors = log.last(100, |kind| kind == LineKind::Error);
        assert_eq!(texts(&errors), ["error:9"]);
    }

    #[test]
    fn the_oldest_lines_go_first_and_are_counted() {
        let (log, grbl) = (LineLog::default(), Grbl::new());
        let lines = MOST_LINES + 10;
        (0..lines).for_each(|at| log.passes(format!("N{at}\n").as_bytes(), true, &grbl));
        let first = log.since(0, |_| true);
        assert_eq!((first.gone, first.lines[0].text.as_str()), (10, "N10"));
        assert_eq!((first.lines.len(), first.is_cut), (LOOKED_AT, true));
        let (mut next, mut seen) = (first.next, first.lines.len());
        while next < lines as u64 {
            let more = log.since(next, |_| true);
            (next, seen) = (more.next, seen + more.lines.len());
        }
        assert_eq!(seen, MOST_LINES);
        assert_eq!(log.since(next, |_| true), Portion { next, gone: 10, ..Portion::default() });
        let long = vec![b'x'; LONGEST + 5];
        (0..2 * MOST_BYTES / LONGEST).for_each(|_| {
            log.passes(&long, true, &grbl);
            log.passes(b"\n", true, &grbl);
        });
        let bytes: usize = log.last(MOST_LINES, |_| true).iter().map(LoggedLine::bytes).sum();
        assert!((MOST_BYTES - LONGEST..=MOST_BYTES).contains(&bytes), "{bytes}");
    }

    #[test]
    fn a_file_has_what_was_before_it_and_what_comes_behind() {
        let folder = tempfile::tempdir().unwrap();
        let (path, log, grbl) = (folder.path().join("lines.txt"), LineLog::default(), Grbl::new());
        log.link("grbl: the line is open");
        log.writes_to(&path).unwrap();
        log.passes(b"$H\n", true, &grbl);
        log.passes(b"ALARM:8\n", false, &grbl);
        drop(log);
        let text = std::fs::read_to_string(&path).unwrap();
        let behind = |line: &str| line.get(13..).unwrap_or_default().to_owned();
        let lines: Vec<_> = text.lines().skip(1).map(behind).collect();
        let alarm = "< ALARM:8  # homing did not leave the limit switch: look at $27 and the wires of the switches";
        assert_eq!(lines, ["# grbl: the line is open", "> $H", alarm]);
    }
}
