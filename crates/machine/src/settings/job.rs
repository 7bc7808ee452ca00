//! Start, place and repetition of jobs (Profiler reference, "Machining the Job").

use super::words;

words! {
    /// Which heads cut a job.
    Heads {
        /// The first alone.
        One = "z",
        /// The second head goes with it.
        Both = "both",
    }
}

/// Settings of jobs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JobSettings {
    /// Each Start takes the present position as job origin.
    pub change_origin_at_start: bool,
    /// Place of the job origin, X and Y from machine home, mm.
    pub origin_mm: [f64; 2],
    /// Place to which the head goes when a job is done, X and Y from the job origin, mm.
    pub finish_mm: [f64; 2],
    /// Number of times a job is cut.
    pub repeats: u32,
    /// The input shared with W home starts jobs, or is the door that must be shut.
    pub external_start: bool,
    /// Two jigs with a start input each.
    pub two_jigs: bool,
    /// Divider of the jigs, X from machine home, mm: jig 1 lies left of it.
    pub divider_mm: f64,
    /// Which heads cut.
    pub heads: Heads,
}

impl Default for JobSettings {
    fn default() -> Self {
        Self {
            change_origin_at_start: false,
            origin_mm: [0.0; 2],
            finish_mm: [0.0; 2],
            repeats: 1,
            external_start: false,
            two_jigs: false,
            divider_mm: 0.0,
            heads: Heads::One,
        }
    }
}
