//! Functions of the open job, and of what is kept.

use super::spec::Step::Number;
use super::spec::{Done, Function, shown, to_millionth};
use crate::{ConsoleRequest, JobRequest, View};
use kerf_program::Axis;

pub(super) const SET_ORIGIN: Function = Function {
    number: "7",
    name: "Set job origin",
    doc: "The origin of the open job is where the tool is; also that of the machine, for jobs that have none. \
         `job.origin_mm`",
    steps: &[],
    does: |_, view| Ok(placed(JobRequest::Origin(here(view)), "Origin", here(view))),
};

pub(super) const SET_FINISH: Function = Function {
    number: "8",
    name: "Set job finish",
    doc: "The finish position in the same way, counted from the origin. `job.finish_mm`",
    steps: &[],
    does: |_, view| {
        let ([x, y], [x0, y0]) = (here(view), view.machine.job.origin_mm);
        let finish = [x - x0, y - y0].map(to_millionth);
        Ok(placed(JobRequest::Finish(finish), "Finish", finish))
    },
};

pub(super) const SAVE: Function = Function {
    number: "10",
    name: "Save job",
    doc: "The open job is written into its file, with the origin, the finish position and the start shape that hold. Its \
         paths stay as they were made: neither 60 nor 300 goes into the file. Shapes that were digitized are among them",
    steps: &[],
    does: |_, _| Ok(Done::from(vec![ConsoleRequest::Job(JobRequest::Save)]).saying("Job saved")),
};

pub(super) const SAVE_MACHINE: Function = Function {
    number: "11",
    name: "Save machine",
    doc: "The settings of the machine are kept as they are now",
    steps: &[],
    does: |_, _| Ok(vec![ConsoleRequest::KeepSettings].into()),
};

pub(super) const NEAREST: Function = Function {
    number: "52",
    name: "Nearest shape",
    doc: "Which shape of the job is nearest to the tool: its number, to be typed behind Start",
    steps: &[],
    does: |_, _| Ok(vec![ConsoleRequest::Job(JobRequest::Nearest)].into()),
};

pub(super) const OFFSET: Function = Function {
    number: "60",
    name: "Offset job mm",
    doc: "Every path of the open job is cut so far to the right of travel, always from how it was made: 0 restores it",
    steps: &[Number {
        prompt: "Offset job mm:",
        now: |view| view.job.as_ref().map(|job| job.offset_mm),
    }],
    does: |typed, _| Ok(vec![ConsoleRequest::Job(JobRequest::Offset(typed[0]))].into()),
};

fn placed(request: JobRequest, what: &str, [x, y]: [f64; 2]) -> Done {
    let said = format!("{what} {},{}", shown(x), shown(y));
    Done::from(vec![ConsoleRequest::Job(request)]).saying(said)
}

/// Returns the place of the tool in the plane, from home.
fn here(view: &View) -> [f64; 2] {
    [Axis::X, Axis::Y].map(|axis| to_millionth(view.position[axis]))
}
