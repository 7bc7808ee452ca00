//! The log of a part file: two lines a run, in a text file beside it.
//!
//! ```text
//!  box.sbp,MOVE,14:03:05,2026-11-21,00:02:10,1,1,1,0,1     name, mode, start, elapsed machine time,
//!  TERMINATED,57,user                                      proportions, offset, repetitions; how it ended
//! ```
//!
//! The line at which a run ended is where FG can take it up again.

use crate::{Session, Shelf};
use kerf_diag::Diagnostic;
use kerf_journal::Started;
use kerf_program::settings::Mode;
use kerf_program::{FileCall, Status};
use kerf_sbp::{Options, format_number};

/// Facts that are known of a run before it begins.
#[derive(Clone, Debug)]
pub(crate) struct PartLog {
    started: Started,
    /// The machine only drew when it began.
    drew: bool,
    /// Call with which the operator started it; a file that a typed line runs is called by that.
    call: Option<FileCall>,
}

impl PartLog {
    /// The log of a run that is about to begin; nothing when none is to be written (VD).
    pub fn begin(session: &Session, options: &Options, started: Option<Started>) -> Option<Self> {
        let settings = &session.memory.settings;
        let wanted = settings.display.part_log && !options.preview;
        let drew = settings.mode == Mode::Preview;
        let call = (!options.typed).then(|| options.file.call());
        Some(Self { started: started.filter(|_| wanted)?, drew, call })
    }

    /// The two lines of a run of a file that took so many seconds of machine time and ended early
    /// at a line, or did not. `draws`: in preview; `call`: how a typed line called it.
    pub fn entry(
        &self,
        file: &str,
        draws: bool,
        seconds: f64,
        call: Option<FileCall>,
        ended: Option<(u32, &str)>,
    ) -> String {
        let Started { time, date } = &self.started;
        let mode = if draws || self.drew { "PREVIEW" } else { "MOVE" };
        let elapsed = clock(seconds);
        let parameters = self.call.or(call).map_or(",,,,".into(), |call| {
            let [x, y, z] = call.proportion.map(format_number);
            format!("{x},{y},{z},{},{}", call.offset, call.repetitions)
        });
        let name = file.rsplit(['/', '\\']).next().unwrap_or(file);
        let end = match ended {
            None => "COMPLETED".into(),
            Some((line, why)) => format!("TERMINATED,{line},{why}"),
        };
        format!("{name},{mode},{time},{date},{elapsed},{parameters}\n{end}\n")
    }
}

/// Tells why a run ended early, in a word; nothing when it came to its end.
pub(crate) fn why(status: Status, error: Option<&Diagnostic>) -> Option<&'static str> {
    match status {
        Status::Ok | Status::Ended => None,
        Status::Failed => Some("error"),
        Status::Stopped if error.is_some() => Some("input"),
        Status::Stopped => Some("user"),
        Status::Limit => Some("limit"),
    }
}

/// The line at which the last run in a log ended early.
pub(crate) fn last_line(log: &str) -> Option<u32> {
    let mut fields = log.lines().next_back()?.split(',');
    (fields.next() == Some("TERMINATED")).then(|| fields.next()?.parse().ok()).flatten()
}

/// The value that says which job ended early last, and at which of its shapes.
pub(crate) const LAST_SHAPE: &str = "LastShape";

impl Shelf {
    /// The shape of a job at which its last run ended early; 0 before the first.
    pub fn last_shape(&self, job: &str) -> Option<u32> {
        let (shape, name) = self.stored.get(LAST_SHAPE)?.split_once(' ')?;
        shape.parse().ok().filter(|_| name == job)
    }

    /// Keeps at which shape a job ended early; nothing for one that came to its end.
    pub(crate) fn keep_last_shape(&mut self, ended: Option<(&str, u32)>) {
        let kept = ended.map(|(job, shape)| format!("{shape} {job}"));
        self.stored.set(LAST_SHAPE, kept.as_deref());
    }
}

/// Hours, minutes and seconds.
pub(crate) fn clock(seconds: f64) -> String {
    let whole = seconds.max(0.0).round() as u64;
    format!("{:02}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_line_of_a_log() {
        assert_eq!(last_line("a.sbp,MOVE\nTERMINATED,57,user\n"), Some(57));
        assert_eq!(last_line("TERMINATED,57,user\na.sbp,MOVE\nCOMPLETED\n"), None);
        for text in ["", "TERMINATED", "TERMINATED,x,user", "57"] {
            assert_eq!(last_line(text), None, "{text}");
        }
    }

    #[test]
    fn times_have_hours() {
        assert_eq!((clock(5.2), clock(3725.0)), ("00:00:05".into(), "01:02:05".into()));
    }
}
