//! The work that an open file has for the machine, and where it lies on the table.

use crate::file_kind::kind_of;
use crate::loader::Loader;
use crate::locks::lock;
use crate::open::Open;
use crate::refusal::problem;
use kerf_geom::Point2;
use kerf_import::job_file::{self, Choice};
use kerf_journal::Work;
use kerf_machine::Configuration;
use kerf_program::job::Job;
use kerf_wire::{FileKind, JobChoice, Problem, Why};

impl Loader {
    /// The program of an open file, named by its place on the disk.
    pub fn program(&self, open: &Open) -> kerf_part::Program {
        let name = self.files.folder.root().join(&open.name).display().to_string();
        kerf_part::read(name.into(), open.bytes.to_vec())
    }

    /// Returns the work that an open file has for the machine.
    ///
    /// # Errors
    /// It is a drawing, or a path of a job has no room for its offset.
    pub fn work(&self, open: &Open) -> Result<Work, Problem> {
        match kind_of(&open.name) {
            FileKind::Program => Ok(self.program(open).into()),
            FileKind::Job => self.job_of(open),
            FileKind::Drawing => Err(problem(Why::State, job_file::NO_TOOL_PATH)),
        }
    }

    pub fn job_of(&self, open: &Open) -> Result<Work, Problem> {
        let machine = lock(&self.left).session.configuration();
        let read = job_file::read(&open.bytes, machine.program.smoothing.factor);
        let (job, _) = read.map_err(|damaged| problem(Why::Mistake, damaged.to_string()))?;
        let name = self.files.folder.root().join(&open.name).display().to_string();
        let work = job_file::work(&job, name.into(), machine);
        let no_room = |why: kerf_toolpath::NoRoom| problem(Why::Mistake, why.to_string());
        chosen(&open.choice).of(work).map_err(no_room)
    }

    /// Returns the number of paths of an open job.
    pub fn path_count(&self, open: &Open) -> u32 {
        if kind_of(&open.name) == FileKind::Job {
            kerf_toolpath::read(&open.bytes).0.paths.len() as u32
        } else {
            0
        }
    }

    /// Returns the origin of the open job on the table, and the place of the head at its end; those of the
    /// machine where no job is open.
    pub(crate) fn lies(&self, open: &Open) -> [Point2; 2] {
        let (job, machine) = self.placed(open);
        kerf_sequence::lies(&job, &machine)
    }

    /// An open job as far as it says where it lies, and the machine.
    fn placed(&self, open: &Open) -> (Job, Configuration) {
        let (mut job, machine) = (Job::default(), lock(&self.left).session.configuration());
        if kind_of(&open.name) == FileKind::Job {
            let (read, _) = kerf_toolpath::read(&open.bytes);
            (job.origin, job.finish) = (read.origin, read.finish);
            let place = |[x, y]: [f64; 2]| Point2::new(x, y);
            job.origin = open.choice.origin.map(place).or(job.origin);
            job.finish = open.choice.finish.map(place).or(job.finish);
        }
        (job, machine)
    }

    /// The machine as it is moved by hand: its job origin and finish are those of the open job.
    pub fn machine_by_hand(&self) -> Configuration {
        let (job, machine) = self.placed(&self.open.lock().clone());
        with_job(machine, &job)
    }
}

/// A machine with the origin and finish of a job as its own.
pub fn with_job(mut machine: Configuration, job: &Job) -> Configuration {
    let lies = kerf_sequence::lies(job, &machine).map(|at| [at.x, at.y]);
    [machine.job.origin_mm, machine.job.finish_mm] = lies;
    machine
}

fn chosen(choice: &JobChoice) -> Choice {
    let JobChoice { start, offset, origin, finish, lift } = *choice;
    let place = |[x, y]: [f64; 2]| Point2::new(x, y);
    Choice {
        start: start.map(|start| start as usize),
        offset_mm: offset,
        origin: origin.map(place),
        finish: finish.map(place),
        lift_mm: lift,
    }
}
