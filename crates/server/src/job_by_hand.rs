//! Acts of a person at the machine on the open job: where it lies, where it ends, which path is near.

use crate::app::App;
use crate::handconsole::Happening;
use crate::kind::kind_of;
use crate::locks::lock;
use crate::open::Open;
use crate::refusal::problem;
use kerf_geom::Point2;
use kerf_journal::Work;
use kerf_machine::Configuration;
use kerf_program::Axis;
use kerf_program::job::{Job, JobShape};
use kerf_wire::{FileKind, JobChoice, Problem, Why};
use std::sync::Arc;
use std::sync::mpsc::Sender;

impl App {
    /// Cuts the open job otherwise in some respect.
    ///
    /// # Errors
    /// As [`App::choose`].
    pub fn choose_anew(
        self: &Arc<Self>,
        change: impl FnOnce(JobChoice) -> JobChoice,
    ) -> Result<(), Problem> {
        let mut open = lock(&self.open).clone();
        open.choice = change(open.choice);
        // A path may have no room for the offset.
        self.work(&open)?;
        self.choose(open.choice)
    }

    /// The open job begins with this path, from 1.
    ///
    /// # Errors
    /// As [`App::choose`].
    pub fn begin_with(self: &Arc<Self>, path: u32) -> Result<(), Problem> {
        let open = self.job_at_rest()?;
        let Work::Job(job, _) = self.job_of(&open)? else { return Ok(()) };
        if job.start == path as usize {
            return Ok(());
        }
        self.choose_anew(|choice| JobChoice { start: Some(path), ..choice })
    }

    /// A job is over that took its origin where the tool was: there it lies from now on.
    pub fn keep_taken(self: &Arc<Self>) {
        let Some((key, at)) = lock(&self.taken).take() else { return };
        if lock(&self.open).key == key {
            // Whoever begins something else at this very moment has no use for it.
            drop(self.choose_anew(|choice| JobChoice { origin: Some(at), ..choice }));
        }
    }

    /// Puts the origin or finish of the machine and of the open job somewhere. That of the machine is for jobs that
    /// say nothing, and holds until Kerf ends; somebody is told when it does.
    ///
    /// # Errors
    /// The machine is busy.
    pub fn place_job(
        self: &Arc<Self>,
        key: &str,
        [x, y]: [f64; 2],
        tells: &Sender<Happening>,
        change: impl FnOnce(JobChoice) -> JobChoice,
    ) -> Result<(), Problem> {
        if kind_of(&lock(&self.open).name) == FileKind::Job {
            self.choose_anew(change)?;
        }
        self.hold(&[(key, format!("{x},{y}"))], tells)
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
        let (job, machine) = self.placed(&lock(&self.open).clone());
        with_job(machine, &job)
    }

    /// The path of the open job nearest to where the tool is in the plane, counted from 1 in cutting order, and how
    /// many there are.
    ///
    /// # Errors
    /// No job is open, or it has no path.
    pub fn nearest_path(&self) -> Result<(u32, u32), Problem> {
        let open = self.job_at_rest()?;
        let Work::Job(job, _) = self.job_of(&open)? else {
            return Err(problem(Why::State, "no job is open"));
        };
        let [origin, _] = self.lies(&open);
        let position = lock(&self.left).session.memory.position;
        let at = Point2::new(position[Axis::X] - origin.x, position[Axis::Y] - origin.y);
        let nearest = nearest(&job.shapes, at);
        let nearest = nearest.ok_or_else(|| problem(Why::State, "the job has no path"))?;
        Ok((nearest as u32 + 1, job.shapes.len() as u32))
    }

    /// Lays the 3D paths of the open job so that their lowest place is at ZBottom. Nothing where no job with such
    /// paths is open.
    ///
    /// # Errors
    /// As [`App::choose`].
    pub fn justify_bottom(self: &Arc<Self>) -> Result<(), Problem> {
        let mut open = lock(&self.open).clone();
        if kind_of(&open.name) != FileKind::Job {
            return Ok(());
        }
        open.choice.lift = 0.0;
        let Work::Job(job, machine) = self.job_of(&open)? else { return Ok(()) };
        let Some(lowest) = kerf_toolpath::lowest_mm(&job) else { return Ok(()) };
        let bottom = machine.zpos.bottom_mm - machine.zpos.surface_mm;
        self.choose_anew(|choice| JobChoice { lift: bottom - lowest, ..choice })
    }
}

/// A machine with the origin and finish of a job as its own.
pub fn with_job(mut machine: Configuration, job: &Job) -> Configuration {
    let lies = kerf_sequence::lies(job, &machine).map(|at| [at.x, at.y]);
    [machine.job.origin_mm, machine.job.finish_mm] = lies;
    machine
}

/// The place in cutting order of the path nearest to a place; the first of several.
fn nearest(shapes: &[JobShape], at: Point2) -> Option<usize> {
    let far = |shape: &JobShape| shape.path.nearest(at).map_or(f64::INFINITY, |(_, far)| far);
    let all = shapes.iter().map(far).enumerate();
    let least = all.reduce(|best, next| if next.1 < best.1 { next } else { best });
    least.map(|(place, _)| place)
}

#[cfg(test)]
mod tests {
    use super::*;
    use kerf_geom::Polyarc;

    fn line(y: f64) -> JobShape {
        let places = [Point2::new(0.0, y), Point2::new(100.0, y)];
        JobShape::through(1, Polyarc::lines(places, false))
    }

    #[test]
    fn the_nearest_path_is_the_first_of_those_as_near() {
        let shapes = [line(0.0), line(20.0), line(40.0)];
        let check = |y: f64, expected: usize| {
            assert_eq!(nearest(&shapes, Point2::new(50.0, y)), Some(expected), "{y}");
        };
        check(-5.0, 0);
        check(10.0, 0);
        check(11.0, 1);
        check(99.0, 2);
        assert_eq!(nearest(&[], Point2::default()), None);
    }
}
