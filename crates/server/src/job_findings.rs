//! Tells pages of a job as soon as its file is read, before its preview is there.

use kerf_formats::Weight;
use kerf_import::job_file;
use kerf_wire::{Finding, Level, Opened};

/// An open job with what its file says: how many paths, the comments of its drawing, and what was noticed while
/// it was read.
pub fn with_file(opened: Opened, bytes: &[u8], smoothing: f64) -> Opened {
    // A damaged job is told by the preview, which fails.
    let Ok((job, noticed)) = job_file::read(bytes, smoothing) else { return opened };
    let comments = job.drawing.comments().join("\n");
    Opened {
        lines: job.paths.len() as u32,
        header: Some(comments).filter(|text| !text.is_empty()),
        findings: noticed.iter().map(finding).collect(),
        ..opened
    }
}

/// The warnings among what is noticed while the file of a job is read.
pub fn warnings(bytes: &[u8], smoothing: f64) -> Vec<String> {
    let noticed = job_file::read(bytes, smoothing).map(|(_, noticed)| noticed);
    let warns = |found: &kerf_formats::Finding| found.weight == Weight::Warning;
    noticed.unwrap_or_default().into_iter().filter(warns).map(|found| found.text).collect()
}

/// A warning about a job as a whole.
pub fn warning(message: String) -> Finding {
    finding(&kerf_formats::Finding::of_file(Weight::Warning, message))
}

fn finding(noticed: &kerf_formats::Finding) -> Finding {
    Finding {
        level: match noticed.weight {
            Weight::Warning => Level::Warning,
            Weight::Note => Level::Note,
        },
        code: String::new(),
        file: String::new(),
        line: noticed.line,
        column: noticed.column,
        length: 0,
        message: noticed.text.clone(),
        hint: String::new(),
    }
}
