//! Jobs in files (`.rsm`) as whoever runs them reads them: the command line and the server.

use kerf_formats::{Finding, Weight};
use kerf_geom::Point2;
use kerf_journal::Work;
use kerf_machine::Configuration;
use kerf_program::Printer;
use kerf_program::job::JobShape;
use kerf_sequence::Speeds;
use kerf_toolpath::{Damaged, DrawnJob, NoRoom, too_deep};
use std::sync::Arc;

/// The extension of jobs.
pub const EXTENSION: &str = kerf_formats::JOB_ENDING;

/// Message where a drawing is started that has no tool path yet.
pub const NO_TOOL_PATH: &str = "create the tool path first";

/// Choices of the person who starts a job. The file stays as it is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Choice {
    /// The path with which it begins, counted from 1 in cutting order; that of the file for nothing.
    pub start: Option<usize>,
    /// Distance beside itself at which every path is cut, mm, to the right of travel.
    pub offset_mm: f64,
    /// Place of its origin on the table, mm from home; that of the file for nothing.
    pub origin: Option<Point2>,
    /// Place to which the head goes at the end, mm from the origin; that of the file for nothing.
    pub finish: Option<Point2>,
    /// Distance by which the paths with heights of their own lie higher, mm.
    pub lift_mm: f64,
}

/// The job in the bytes of a file, and what was noticed: also that it was made with another smoothing factor
/// than the one in force.
///
/// # Errors
/// The file is damaged: what is left of it is not cut.
pub fn read(bytes: &[u8], smoothing: f64) -> Result<(DrawnJob, Vec<Finding>), Damaged> {
    let (job, read) = kerf_toolpath::read_whole(bytes)?;
    let mut findings = read.findings;
    if let Some(made) = job.smoothing.filter(|made| *made != smoothing) {
        let text = format!(
            "tool path made with other smoothing values: the factor was {made} and is {smoothing} now; \
             make it anew from the drawing"
        );
        findings.push(Finding::of_file(Weight::Warning, text));
    }
    Ok((job, findings))
}

/// A job as it runs on a machine, under a name. People know its paths by their place in cutting order, as
/// `kerf draw --list` numbers them.
pub fn work(job: &DrawnJob, name: Arc<str>, machine: Configuration) -> Work {
    let mut machine_job = job.machine_job(name);
    let shapes = machine_job.shapes.iter().zip(1..);
    machine_job.shapes =
        shapes.map(|(shape, number)| JobShape { number, ..shape.clone() }).collect();
    Work::Job(Arc::new(machine_job), Arc::new(machine))
}

/// Writes a job as a part program, as a machine cuts it; what is noticed on the way is returned.
///
/// # Errors
/// Paths that would go below ZBottom, a sentence each.
pub fn print(
    job: &DrawnJob,
    machine: &Configuration,
    speeds: Speeds,
    printer: &mut dyn Printer,
) -> Result<Vec<String>, Vec<String>> {
    let wrong = too_deep(job, &machine.zpos);
    if !wrong.is_empty() {
        return Err(wrong.iter().map(ToString::to_string).collect());
    }
    job.drawing.comments().iter().for_each(|line| printer.comment(line));
    match kerf_sequence::print(&job.machine_job(Arc::default()), machine, speeds, printer) {
        Ok(noticed) => Ok(noticed.into_iter().map(|noticed| noticed.message).collect()),
        Err(low) => Err(vec![low.message]),
    }
}

impl Choice {
    /// The job as it was chosen to be cut.
    ///
    /// # Errors
    /// A path has no room for the offset.
    pub fn of(&self, work: Work) -> Result<Work, NoRoom> {
        let Work::Job(job, machine) = work else { return Ok(work) };
        let mut chosen = kerf_toolpath::offset_job(&job, self.offset_mm)?;
        chosen.start = self.start.unwrap_or(chosen.start).clamp(1, chosen.shapes.len().max(1));
        chosen.origin = self.origin.or(chosen.origin);
        chosen.finish = self.finish.or(chosen.finish);
        Ok(Work::Job(Arc::new(kerf_toolpath::lifted(chosen, self.lift_mm)), machine))
    }
}
