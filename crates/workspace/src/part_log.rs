//! The log of a part file: two lines a run, in a text file beside it.
//!
//! ```text
//!  box.sbp,MOVE,14:03:05,2026-11-21,00:02:10,1,1,1,0,1     name, mode, start, elapsed machine time,
//!  TERMINATED,57,user                                      proportions, offset, repetitions; how it ended
//! ```
//!
//! The line at which a run ended is where FG can take it up again.

use crate::system_log::clock;
use kerf_diag::Diagnostic;
use kerf_journal::Started;
use kerf_program::settings::Mode;
use kerf_program::{FileCall, Settings, Status};
use kerf_sbp::{Options, format_number};

/// Facts that are known of a run before it begins.
#[derive(Clone, Debug)]
pub struct PartLog {
    started: Started,
    /// The machine only drew when it began.
    drew: bool,
    /// Call with which the operator started it; a file that a typed line runs is called by that.
    call: Option<FileCall>,
}

impl PartLog {
    /// The log of a run that is about to begin; nothing when none is to be written (VD).
    pub fn begin(settings: &Settings, options: &Options, started: Option<Started>) -> Option<Self> {
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
pub fn why(status: Status, error: Option<&Diagnostic>) -> Option<&'static str> {
    match status {
        Status::Ok | Status::Ended => None,
        Status::Failed => Some("error"),
        Status::Stopped if error.is_some() => Some("input"),
        Status::Stopped => Some("user"),
        Status::Limit => Some("limit"),
    }
}
