//! The options of part files as a job takes them: what makes sense is done, the rest is refused by name.

use crate::args::{FileArgs, RunArgs};
use crate::exit::Usage;
use anyhow::{Result, bail};
use kerf_program::job::Job;
use kerf_workspace::Workspace;

/// Options that say nothing of a job: the name, whether it was given, and what does what is meant.
fn foreign(args: &RunArgs) -> [(&'static str, bool, &'static str); 7] {
    let FileArgs { proportion, offset, plunge, tabs, plunge_from_zero, step, .. } = &args.file;
    [
        (
            "--proportion",
            proportion.is_some(),
            "scale its drawing (kerf draw --do 'select all; scale 2 about 0,0') and make the job anew",
        ),
        (
            "--offset",
            offset.is_some_and(|offset| offset > 0),
            "lay its origin elsewhere: kerf toolpath --origin X,Y, or job.change_origin_at_start takes the place of the tool",
        ),
        (
            "--plunge",
            plunge.is_some(),
            "its depth is that of its groups, and Z bottom of the machine (zpos.bottom_mm)",
        ),
        (
            "--tabs",
            *tabs,
            "tags of its groups leave bridges: kerf draw --do 'set black tag=2', and make the job anew",
        ),
        (
            "--plunge-from-zero",
            *plunge_from_zero,
            "a job comes down from Z top of the machine (zpos.top_mm)",
        ),
        (
            "--step",
            *step,
            "pause marks halt it before shapes: kerf draw --do 'select all; pause on'",
        ),
        (
            "--resume-at",
            !args.operator.resume_at.is_empty(),
            "answer the question of the pause: --answers FILE with paused=Continue",
        ),
    ]
}

/// Refuses options that say nothing of a job.
pub fn refuse_foreign(args: &RunArgs) -> Result<()> {
    match foreign(args).into_iter().find(|(_, given, _)| *given) {
        Some((name, _, instead)) => {
            bail!(Usage(format!("{name} is of part files, not of jobs: {instead}")))
        }
        None => Ok(()),
    }
}

/// Refuses every file parameter where no job is run.
pub fn refuse_all(args: &RunArgs) -> Result<()> {
    refuse_foreign(args)?;
    let FileArgs { repeat, from_line, .. } = &args.file;
    for (name, given) in [("--repeat", *repeat > 1), ("--from-line", from_line.is_some())] {
        if given {
            bail!(Usage(format!(
                "{name} is of a run, and not written into a job: give it to kerf run"
            )));
        }
    }
    Ok(())
}

/// Only jobs are cut beside themselves.
pub fn only_of_jobs() -> Usage {
    Usage("only a job is offset: --offset-job".into())
}

/// The choice of a job that a server cuts.
pub fn remotely(args: &RunArgs, beside_mm: Option<f64>) -> Result<Choice> {
    refuse_foreign(args)?;
    let FileArgs { repeat, from_line, .. } = &args.file;
    if *repeat > 1 {
        bail!(Usage(
            "--repeat is not passed on with a job: set job.repeats of the server's machine".into()
        ));
    }
    let number = |words: &String| match words.trim().parse() {
        Ok(shape) if shape > 0 => Ok(shape),
        _ => Err(Usage(format!(
            "--from-line {words}: of a job on a server it is the number of a shape"
        ))),
    };
    let start = from_line.as_ref().map(number).transpose()?;
    Ok(Choice { start, offset_mm: beside_mm.unwrap_or_default() })
}

/// Choice for a job that a server cuts.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Choice {
    /// The shape with which it begins, from 1.
    pub start: Option<u32>,
    /// Distance of every cut beside its path, to the right of travel, mm.
    pub offset_mm: f64,
}

/// A job as options have it run: `--repeat` is how often it is cut, `--from-line` the shape with which it begins.
pub fn of(args: &RunArgs, job: &mut Job, workspace: &Workspace) -> Result<()> {
    refuse_foreign(args)?;
    job.repeats = job.repeats.max(args.file.repeat);
    if let Some(words) = &args.file.from_line {
        job.start = first_shape(words, job, workspace)?;
    }
    Ok(())
}

/// The shape with which a job begins, from 1.
fn first_shape(words: &str, job: &Job, workspace: &Workspace) -> Result<usize> {
    let count = job.shapes.len();
    let number = match words.trim() {
        "last" => stopped_at(job, workspace)?,
        number => number.parse().ok(),
    };
    match number {
        Some(shape) if (1..=count).contains(&shape) => Ok(shape),
        Some(shape) => {
            bail!(Usage(format!("--from-line {shape}: {} has {count} shapes", job.name)))
        }
        None => bail!(Usage(format!(
            "--from-line {words}: of a job it is the number of a shape, 1 to {count}, or last"
        ))),
    }
}

/// The shape at which the last run of a job ended early: it was cut short, or stopped.
fn stopped_at(job: &Job, workspace: &Workspace) -> Result<Option<usize>> {
    let cut = workspace.journal().map(|journal| journal.runs.cut_short()).transpose()?.flatten();
    let cut = cut.filter(|cut| cut.is_job() && cut.file() == &*job.name);
    match cut.map(|cut| cut.last_move().1).or_else(|| workspace.last_shape(&job.name)) {
        Some(shape) => Ok(Some((shape as usize).max(1))),
        None => bail!(Usage(format!("no run of {} that ended early is on record", job.name))),
    }
}
