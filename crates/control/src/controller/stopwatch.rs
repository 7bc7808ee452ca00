//! The time that the motion of a run takes on a controller, beside the time that its planner says.

use crate::own_pace::OwnPace;
use kerf_motion::Move;

/// Moves whose time is computed at once: as many as a controller looks ahead are few of them.
const AT_ONCE: usize = 8192;

/// Moves at both ends of those whose speeds depend on what is before and behind.
const BESIDE: usize = 256;

/// Motion of a run, measured from stand to stand. Where somebody holds it, turns an override, or the end of a move is open, it
/// does not count.
#[derive(Debug, Default)]
pub(super) struct Stopwatch {
    pace: Option<OwnPace>,
    stretch: Option<Stretch>,
    told_s: f64,
    taken_s: f64,
}

/// Motion from one stand to the next.
#[derive(Debug)]
struct Stretch {
    since_s: f64,
    told_s: f64,
    moves: Vec<Move>,
    /// Moves at its front that are counted already.
    counted: usize,
    counts: bool,
}

impl Stopwatch {
    /// Begins to measure a run on a controller that makes moves in this way.
    pub const fn of(pace: Option<OwnPace>) -> Self {
        Self { pace, stretch: None, told_s: 0.0, taken_s: 0.0 }
    }

    /// Adds moves that are handed over at a moment.
    pub fn add_moves(&mut self, moves: &[Move], now_s: f64) {
        let Some(pace) = &self.pace else { return };
        let begin =
            || Stretch { since_s: now_s, told_s: 0.0, moves: Vec::new(), counted: 0, counts: true };
        let stretch = self.stretch.get_or_insert_with(begin);
        stretch.moves.extend(moves);
        if stretch.moves.len() >= AT_ONCE {
            stretch.count_front(pace);
        }
    }

    /// Counts the moves so far up to a stand: the controller stands for what is switched after them.
    pub fn count_to_stand(&mut self) {
        if let (Some(pace), Some(stretch)) = (&self.pace, &mut self.stretch) {
            stretch.count(pace);
        }
    }

    /// Leaves out the stretch under way, which takes a time that no planner says.
    pub const fn skip_stretch(&mut self) {
        if let Some(stretch) = &mut self.stretch {
            stretch.counts = false;
        }
    }

    /// Ends the stretch at a moment at which all moves of it are made.
    pub fn end_stretch(&mut self, now_s: f64) {
        let (Some(pace), Some(mut stretch)) = (&self.pace, self.stretch.take()) else { return };
        stretch.count(pace);
        if stretch.counts {
            self.told_s += stretch.told_s;
            self.taken_s += now_s - stretch.since_s;
        }
    }

    /// Returns the time that the planner told and the time that motion took, seconds, and measures no more.
    pub fn take_times(&mut self) -> (f64, f64) {
        let Self { told_s, taken_s, .. } = std::mem::take(self);
        (told_s, taken_s)
    }
}

impl Stretch {
    /// Counts all moves that are not counted: the machine stands behind them.
    fn count(&mut self, pace: &OwnPace) {
        let seconds = pace.seconds(std::mem::take(&mut self.moves));
        self.told_s += seconds[self.counted..].iter().sum::<f64>();
        self.counted = 0;
    }

    /// Counts moves but the last ones, and keeps as many as the speeds of those depend on.
    fn count_front(&mut self, pace: &OwnPace) {
        let until = self.moves.len() - BESIDE;
        let seconds = pace.seconds(self.moves.clone());
        self.told_s += seconds[self.counted..until].iter().sum::<f64>();
        self.moves.drain(..until - BESIDE);
        self.counted = BESIDE;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use kerf_machine::driver::Facts;
    use kerf_machine::driver::planners::{Grbl, OwnPlanner};
    use kerf_motion::Mover;
    use kerf_program::{At, Axes, Feed, Line, MoveKind, Settings};

    fn pace() -> OwnPace {
        let planner = Grbl::new(Axes::splat(100.0), Axes::splat(500.0));
        let planner = Some(OwnPlanner::Grbl(Grbl { link: None, ..planner }));
        OwnPace::of(&Facts { planner, ..Facts::default() }).expect("it has a planner")
    }

    /// A wave of so many short legs.
    fn legs(count: i32) -> Vec<Move> {
        let mut mover = Mover::new(Axes::default(), &Settings::default());
        let place = |n: i32| Axes::xyz(f64::from(n) * 2.0, f64::from(n % 7), 0.0);
        let line = |n| Line { kind: MoveKind::Cut, to: place(n), feed: Feed::Path(40.0) };
        (1..=count).filter_map(|n| mover.line(At::default(), &line(n))).collect()
    }

    fn told_s(moves: &[Move]) -> f64 {
        pace().seconds(moves.to_vec()).iter().sum()
    }

    #[test]
    fn motion_alone_is_measured_from_stand_to_stand() {
        let (moves, mut watch) = (legs(50), Stopwatch::of(Some(pace())));
        watch.add_moves(&moves[..20], 10.0);
        watch.add_moves(&moves[20..], 10.1);
        watch.end_stretch(13.0);
        // Somebody is asked meanwhile, a tool is changed.
        watch.add_moves(&moves, 500.0);
        watch.end_stretch(504.0);
        let (told, taken) = watch.take_times();
        assert!((told - 2.0 * told_s(&moves)).abs() < 1e-9, "{told}");
        assert!((taken - 7.0).abs() < 1e-9, "{taken}");
        assert_eq!(watch.take_times(), (0.0, 0.0));
    }

    #[test]
    fn what_was_held_or_turned_does_not_count() {
        let (moves, mut watch) = (legs(50), Stopwatch::of(Some(pace())));
        watch.skip_stretch();
        watch.add_moves(&moves, 0.0);
        watch.skip_stretch();
        watch.end_stretch(60.0);
        watch.add_moves(&moves, 70.0);
        watch.end_stretch(73.0);
        let (told, taken) = watch.take_times();
        assert!((told - told_s(&moves)).abs() < 1e-9 && (taken - 3.0).abs() < 1e-9);
    }

    #[test]
    fn a_switch_on_the_way_has_the_controller_stand() {
        let (moves, mut watch) = (legs(50), Stopwatch::of(Some(pace())));
        watch.add_moves(&moves[..17], 0.0);
        watch.count_to_stand();
        watch.add_moves(&moves[17..], 0.0);
        watch.end_stretch(3.0);
        let apart = told_s(&moves[..17]) + told_s(&moves[17..]);
        assert!((watch.take_times().0 - apart).abs() < 1e-9);
        assert!(apart > told_s(&moves) + 0.02);
    }

    #[test]
    fn a_long_way_is_counted_in_parts_as_at_once() {
        let (moves, mut watch) = (legs(40_000), Stopwatch::of(Some(pace())));
        moves.chunks(100).for_each(|some| watch.add_moves(some, 0.0));
        watch.end_stretch(1.0);
        let whole = told_s(&moves);
        assert!((watch.take_times().0 / whole - 1.0).abs() < 1e-6);
    }
}
