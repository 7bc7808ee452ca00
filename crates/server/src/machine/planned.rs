//! Progress of a run, by the plan of its preview.

use kerf_control::Clocks;
use kerf_machine::Going;
use kerf_program::MoveKind;
use kerf_trace::ExecutedMove;
use std::sync::Arc;

/// The moves of a run as they were planned in its preview.
#[derive(Clone, Debug, Default)]
pub struct Planned {
    /// Time when each is over, seconds.
    pub times: Arc<[f32]>,
    /// Part of that time that was cutting, which an override makes slower or faster.
    pub cuts: Arc<[f32]>,
    /// Which path of a job each belongs to, and where it ends in the plane; empty for a part program.
    pub ends: Arc<[PathEnd]>,
}

/// Number of a path, and where a move of it ends, X and Y of the machine frame.
pub type PathEnd = (u32, [f64; 2]);

/// Two sums of the same way may differ in the last digits, mm.
const SAME_MM: f64 = 1e-6;

/// The least share of the speed asked for that an override leaves.
const LEAST_FEED: f64 = 0.1;

impl Planned {
    /// Planned time of all of it, seconds.
    pub fn seconds(&self) -> f64 {
        self.times.last().copied().map_or(0.0, f64::from)
    }

    /// The share of it that is over when so many moves are made.
    pub fn share(&self, made: u32) -> f64 {
        let course = Course { planned: self.clone(), made, left_s: None };
        course.progress()
    }

    /// Returns the number of moves made behind one that ends there, when so many were before. What a pause
    /// adds to a job is not in its plan.
    fn behind(&self, before: u32, (path, [x, y]): PathEnd) -> u32 {
        if self.ends.is_empty() {
            return before + 1;
        }
        let same = |at: &usize| {
            let (number, [px, py]) = self.ends[*at];
            number == path && (px - x).abs() < SAME_MM && (py - y).abs() < SAME_MM
        };
        let (from, all) = ((before as usize).min(self.ends.len()), self.ends.len());
        // Behind the present place first; a jig may be cut before another.
        let found = (from..all).find(same).or_else(|| (0..from).find(same));
        found.map_or(before, |at| at as u32 + 1)
    }
}

/// Writes a plan down, move by move.
#[derive(Debug, Default)]
pub struct Planning {
    times: Vec<f32>,
    cuts: Vec<f32>,
    ends: Vec<PathEnd>,
    /// Cutting time so far, seconds.
    cut_s: f64,
}

impl Planning {
    /// A move, or a part of one.
    pub fn add(&mut self, made: &ExecutedMove<'_>) {
        let (span, step) = (made.span, made.span.made);
        if step.kind == MoveKind::Cut {
            self.cut_s += span.t1_s - span.t0_s;
        }
        if is_whole(made) {
            let [x, y, _] = step.to.first3();
            self.times.push((made.t0_s + span.t1_s) as f32);
            self.cuts.push(self.cut_s as f32);
            self.ends.push((step.at.line, [x, y]));
        }
    }

    /// Puts the times of a controller in place of those of the plan.
    pub fn retime(&mut self, clocks: &Clocks) {
        let (mut before_s, mut cut_s) = (0.0, 0.0);
        for (time, cut) in self.times.iter_mut().zip(&mut self.cuts) {
            let [end_s, cut_before_s] = [*time, *cut].map(f64::from);
            let begin_s = end_s - (cut_before_s - before_s);
            cut_s += clocks.own_s(end_s) - clocks.own_s(begin_s);
            before_s = cut_before_s;
            (*time, *cut) = (clocks.own_s(end_s) as f32, cut_s as f32);
        }
    }

    /// Moves so far.
    pub const fn moves(&self) -> u32 {
        self.times.len() as u32
    }

    /// The plan of a job, or of a part program.
    pub fn finish(self, is_job: bool) -> Planned {
        let ends = if is_job { self.ends } else { Vec::new() };
        Planned { times: self.times.into(), cuts: self.cuts.into(), ends: ends.into() }
    }
}

/// Returns `true` if a move of the program is over: those beside it are in no plan, and an override makes one in
/// several parts.
const fn is_whole(made: &ExecutedMove<'_>) -> bool {
    !made.beside && made.span.made.is_last_part
}

/// A sum of a list of sums, behind so many moves.
fn behind(sums: &[f32], made: u32) -> f64 {
    let last = (made as usize).min(sums.len()).checked_sub(1);
    last.map_or(0.0, |last| f64::from(sums[last]))
}

/// Follows a run through its plan.
#[derive(Debug)]
pub struct Course {
    planned: Planned,
    made: u32,
    /// Rest of the move under way, seconds at the speed that was planned; nothing where none of it was made.
    left_s: Option<f64>,
}

impl Course {
    /// The beginning of a plan.
    pub const fn new(planned: Planned) -> Self {
        Self { planned, made: 0, left_s: None }
    }

    /// The plan is known by now.
    pub fn plan(&mut self, planned: Planned) {
        self.planned = planned;
    }

    /// Moves that were made.
    pub const fn moves(&self) -> u32 {
        self.made
    }

    /// A move was made, or a part of one.
    pub fn made(&mut self, made: &ExecutedMove<'_>) {
        if !is_whole(made) {
            return;
        }
        let step = made.span.made;
        let [x, y, _] = step.to.first3();
        self.made = self.planned.behind(self.made, (step.at.line, [x, y]));
        self.left_s = None;
    }

    /// The machine is in a move, cuts at this share of the speed asked for.
    pub fn goes(&mut self, going: &Going<'_>, t_s: f64, feed: f64) {
        if going.part <= 0.0 {
            return;
        }
        let moves = &going.plan.moves()[going.index..];
        let Some(parts) = moves.iter().position(|part| part.is_last_part) else { return };
        let end_s = going.t0_s + going.plan.span_s(going.index + parts).1;
        let cuts = moves.first().is_some_and(|part| part.kind == MoveKind::Cut);
        let share = if cuts { feed.max(LEAST_FEED) } else { 1.0 };
        self.left_s =
            Some(((end_s - t_s).max(0.0) * share).min(self.present_s(&self.planned.times)));
    }

    /// Returns the length of the next move in a list of sums.
    fn present_s(&self, sums: &[f32]) -> f64 {
        behind(sums, self.made + 1) - behind(sums, self.made)
    }

    /// Returns the part of the move under way that is made, seconds at the speed that was planned.
    fn within_s(&self) -> f64 {
        self.left_s.map_or(0.0, |left_s| self.present_s(&self.planned.times) - left_s)
    }

    /// Planned time of the moves that were made, seconds.
    pub fn made_s(&self) -> f64 {
        behind(&self.planned.times, self.made)
    }

    /// The share of the planned time that is over.
    pub fn progress(&self) -> f64 {
        let total_s = self.planned.seconds();
        if total_s <= 0.0 {
            return 0.0;
        }
        (self.made_s() + self.within_s()) / total_s
    }

    /// Planned time that is left when cuts run at this share of the speed asked for, seconds.
    pub fn remaining_s(&self, feed: f64) -> f64 {
        let left = |sums: &[f32]| behind(sums, u32::MAX) - behind(sums, self.made);
        let Planned { times, cuts, .. } = &self.planned;
        let within_s = self.within_s();
        let is_cut = self.present_s(cuts) > 0.0;
        let cut_s = left(cuts) - if is_cut { within_s } else { 0.0 };
        let rest_s = left(times) - within_s - cut_s;
        rest_s + cut_s / feed.max(LEAST_FEED)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A jog of a second, a cut of four, a jog of one.
    fn course(made: u32, left_s: Option<f64>) -> Course {
        let planned = Planned {
            times: [1.0, 5.0, 6.0].into(),
            cuts: [0.0, 4.0, 4.0].into(),
            ends: Arc::default(),
        };
        Course { planned, made, left_s }
    }

    #[test]
    fn time_that_is_left_is_that_of_the_rest_and_an_override_is_of_cuts() {
        let check = |made, left_s, feed, progress: f64, remaining_s: f64| {
            let course = course(made, left_s);
            assert!((course.progress() - progress).abs() < 1e-6, "{}", course.progress());
            let told = course.remaining_s(feed);
            assert!((told - remaining_s).abs() < 1e-6, "{told}");
        };
        check(0, None, 1.0, 0.0, 6.0);
        check(0, Some(0.25), 1.0, 0.125, 5.25);
        check(1, None, 0.5, 1.0 / 6.0, 9.0);
        check(1, Some(1.0), 0.5, 4.0 / 6.0, 3.0);
        check(1, Some(1.0), 2.0, 4.0 / 6.0, 1.5);
        check(3, None, 0.5, 1.0, 0.0);
    }

    #[test]
    fn a_move_that_is_made_is_the_next_one_that_ends_there() {
        let ends =
            [(1, [0.0, 0.0]), (1, [5.0, 0.0]), (1, [5.0, 2.0]), (2, [5.0, 0.0]), (1, [0.0, 0.0])];
        let planned = Planned { ends: ends.into(), ..Planned::default() };
        let check =
            |before, end, behind| assert_eq!(planned.behind(before, end), behind, "{end:?}");
        check(0, (1, [0.0, 0.0]), 1);
        check(1, (1, [0.0, 0.0]), 5);
        check(0, (1, [5.0, 2.0 + 1e-9]), 3);
        check(0, (2, [5.0, 0.0]), 4);
        check(4, (1, [5.0, 0.0]), 2);
        check(3, (1, [7.0, 0.0]), 3);
        assert_eq!(
            Planned::default().behind(3, (1, [0.0, 0.0])),
            4,
            "without a plan they are counted"
        );
    }

    #[test]
    fn without_a_plan_nothing_is_told() {
        let course = Course::new(Planned::default());
        assert_eq!((course.progress(), course.remaining_s(1.0)), (0.0, 0.0));
    }
}
