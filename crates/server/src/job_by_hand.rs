//! Acts of a person at the machine on the open job: where it lies, where it ends, which path is near.

use crate::file_kind::kind_of;
use crate::handconsole::Happening;
use crate::job::Jobs;
use crate::locks::lock;
use crate::refusal::problem;
use kerf_geom::Point2;
use kerf_journal::Work;
use kerf_program::Axis;
use kerf_program::job::JobShape;
use kerf_wire::{FileKind, JobChoice, Problem, Why};
use std::sync::mpsc::Sender;

impl Jobs {
    /// Cuts the open job otherwise in some respect.
    ///
    /// # Errors
    /// As [`Jobs::choose`].
    pub fn choose_anew(&self, change: impl FnOnce(JobChoice) -> JobChoice) -> Result<(), Problem> {
        let mut open = self.loader.open.lock().clone();
        open.choice = change(open.choice);
        // A path may have no room for the offset.
        self.loader.work(&open)?;
        self.choose(open.choice)
    }

    /// The open job begins with this path, from 1.
    ///
    /// # Errors
    /// As [`Jobs::choose`].
    pub fn begin_with(&self, path: u32) -> Result<(), Problem> {
        let open = self.job_at_rest()?;
        let Work::Job(job, _) = self.loader.job_of(&open)? else { return Ok(()) };
        if job.start == path as usize {
            return Ok(());
        }
        self.choose_anew(|choice| JobChoice { start: Some(path), ..choice })
    }

    /// A job is over that took its origin where the tool was: there it lies from now on.
    pub fn keep_taken(&self) {
        let Some((hash, at)) = self.taken.lock().take() else { return };
        if self.loader.open.lock().hash == hash {
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
        &self,
        key: &str,
        [x, y]: [f64; 2],
        tells: &Sender<Happening>,
        change: impl FnOnce(JobChoice) -> JobChoice,
    ) -> Result<(), Problem> {
        if kind_of(&self.loader.open.lock().name) == FileKind::Job {
            self.choose_anew(change)?;
        }
        self.settings.hold(&[(key, format!("{x},{y}"))], tells)
    }

    /// The path of the open job nearest to where the tool is in the plane, counted from 1 in cutting order, and how
    /// many there are.
    ///
    /// # Errors
    /// No job is open, or it has no path.
    pub fn nearest_path(&self) -> Result<(u32, u32), Problem> {
        let open = self.job_at_rest()?;
        let Work::Job(job, _) = self.loader.job_of(&open)? else {
            return Err(problem(Why::State, "no job is open"));
        };
        let [origin, _] = self.loader.lies(&open);
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
    /// As [`Jobs::choose`].
    pub fn justify_bottom(&self) -> Result<(), Problem> {
        let mut open = self.loader.open.lock().clone();
        if kind_of(&open.name) != FileKind::Job {
            return Ok(());
        }
        open.choice.lift = 0.0;
        let Work::Job(job, machine) = self.loader.job_of(&open)? else { return Ok(()) };
        let Some(lowest) = kerf_toolpath::lowest_mm(&job) else { return Ok(()) };
        let bottom = machine.zpos.bottom_mm - machine.zpos.surface_mm;
        self.choose_anew(|choice| JobChoice { lift: bottom - lowest, ..choice })
    }
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
