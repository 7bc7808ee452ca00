//! Following a path: its segments as commands, and finding the place where it was left.

use crate::cut::Cut;
use crate::head::Head;
use crate::limited;
use crate::place::{Along, Followed, Here, Progress, Spot};
use crate::setup::Setup;
use crate::values::Values;
use kerf_geom::{Point2, Segment};
use kerf_machine::planning::CHORDS;
use kerf_machine::settings::axes::Z2;
use kerf_machine::settings::job::Heads;
use kerf_program::job::{Depths, Job, JobShape};
use kerf_program::{Arc, Axes, Axis, Command, Feed, Halted, Line, MoveKind, Sourced};

/// Angles closer than this are the same, degrees.
const SAME_DEG: f64 = 1e-9;

/// Gives the motions of a job: moves the head, notes how far the path is, and puts commands into `out`.
pub(crate) struct Follower<'a> {
    pub setup: &'a Setup,
    pub values: &'a mut Values,
    pub head: &'a mut Head,
    pub progress: &'a mut Progress,
    pub out: &'a mut Vec<Sourced>,
}

impl Follower<'_> {
    /// Gives the rest of the path at hand.
    pub fn follow(&mut self) {
        let setup = self.setup;
        let Some(shape) = self.progress.here.shape(&setup.job) else { return };
        let Some(spot) = self.progress.here.spot(shape) else { return };
        let at = self.progress.at(&setup.job);
        let slower = limited::slower_warning(setup, self.values, shape);
        let slower = slower.map(|told| Command::Diagnostic(Box::new(told)));
        self.out.extend(slower.map(|command| Sourced { at, command }));
        self.progress.followed = Followed { first: self.head.motions + 1, segments: Vec::new() };
        for number in spot.segment..shape.path.segment_count() {
            let segment = shape.path.segment(number);
            let share = if number == spot.segment { spot.share } else { 0.0 };
            if share < 1.0 {
                let rest = segment.part(share, 1.0);
                self.turn_into(rest.direction(0.0).y.atan2(rest.direction(0.0).x), number);
                self.segment(shape, number, &rest);
            }
        }
    }

    /// Gives the way down to the beginning of the path at hand; `true` where there is one. A stop on it leaves
    /// the path as not begun.
    pub fn slope(&mut self) -> bool {
        let setup = self.setup;
        let (Some(shape), Depths::Level(levels)) =
            (self.progress.here.shape(&setup.job), &self.progress.depths)
        else {
            return false;
        };
        let Some(to) = levels.get(self.progress.here.pass).copied() else { return false };
        self.progress.followed = Followed { first: self.head.motions + 1, segments: Vec::new() };
        let slopes = shape.plunge.slopes(&shape.path, self.head.position[Axis::Z], to);
        for slope in &slopes {
            self.motion(shape, &slope.segment, Some(slope.z_mm));
        }
        !slopes.is_empty()
    }

    fn segment(&mut self, shape: &JobShape, number: usize, segment: &Segment) {
        let along = |base: f64| base + shape.height_mm(number + 1);
        let z =
            if let Depths::Along(base) = self.progress.depths { Some(along(base)) } else { None };
        self.progress.followed.segments.push(number as u32);
        self.motion(shape, segment, z);
    }

    /// Gives a segment, to a height or at the present one.
    fn motion(&mut self, shape: &JobShape, segment: &Segment, z: Option<f64>) {
        let to = self.setup.job.on_table(segment.end());
        let mut axes = self.head.position;
        (axes[Axis::X], axes[Axis::Y]) = (to.x, to.y);
        axes[Axis::Z] = z.unwrap_or(axes[Axis::Z]);
        let kind = if shape.traversal { MoveKind::Jog } else { MoveKind::Cut };
        let feed = Feed::Path(self.feed(shape, segment, axes));
        let command = match *segment {
            Segment::Line { .. } => Command::Line(Line { kind, to: axes, feed }),
            Segment::Arc { centre, sweep_rad, .. } => {
                if self.setup.machine.misc.tangential {
                    axes[Axis::C] += sweep_rad.to_degrees();
                }
                let centre = self.setup.job.on_table(centre);
                let centre = [centre.x, centre.y];
                let chords = CHORDS;
                Command::Arc(Arc { kind, centre, sweep_rad, to: axes, feed, chords, small: false })
            }
        };
        self.move_by(command, axes);
    }

    /// The knife turns into the direction of what comes next: the short way, at once when the corner
    /// is one, else along the way (readings, Speeds).
    fn turn_into(&mut self, direction_rad: f64, number: usize) {
        if !self.setup.machine.misc.tangential {
            return;
        }
        let target = nearest_turn(self.head.position[Axis::C], direction_rad.to_degrees());
        let turn = (target - self.head.position[Axis::C]).abs();
        let mut axes = self.head.position;
        axes[Axis::C] = target;
        if turn >= self.setup.settings.smoothing.stop_angle_deg {
            let feed = Feed::Path(self.setup.settings.axis_dynamics().speed_mm_s[Axis::C]);
            self.progress.followed.segments.push(number as u32);
            self.move_by(Command::Line(Line { kind: MoveKind::Cut, to: axes, feed }), axes);
        } else {
            self.head.position = axes;
        }
    }

    fn feed(&self, shape: &JobShape, segment: &Segment, to: Axes) -> f64 {
        let cut = Cut { setup: self.setup, values: self.values, shape };
        cut.feed(segment, to.minus(self.head.position))
    }

    /// Gives a motion that ends at a position.
    pub fn move_by(&mut self, mut command: Command, to: Axes) {
        let to = self.with_second_head(to);
        match &mut command {
            Command::Line(line) => line.to = to,
            Command::Arc(arc) => arc.to = to,
            _ => {}
        }
        self.head.motions += 1;
        self.head.position = to;
        let at = self.progress.at(&self.setup.job);
        self.out.push(Sourced { at, command });
    }

    /// The same place with the second head beside the first, where both cut. What it is adjusted by is in
    /// its zero since it was homed.
    fn with_second_head(&self, mut to: Axes) -> Axes {
        if self.setup.machine.job.heads == Heads::Both && to[Axis::Z] != self.head.position[Axis::Z]
        {
            to[Z2] = to[Axis::Z];
        }
        to
    }
}

/// Remembers how far the path at hand was made when motion was stopped.
pub(crate) fn keep_place(progress: &mut Progress, job: &Job, halted: &Halted) {
    let Some(shape) = progress.here.shape(job) else { return };
    let Some(motion) = halted.motion else {
        progress.here.along = Along::After;
        return;
    };
    let index = motion.saturating_sub(progress.followed.first) as usize;
    let Some(segment) = progress.followed.segments.get(index) else { return };
    let on_table = Point2::new(halted.stands[Axis::X], halted.stands[Axis::Y]);
    let origin = job.origin.unwrap_or_default();
    let at = Point2::new(on_table.x - origin.x, on_table.y - origin.y);
    let spot = Spot::near(&shape.path, *segment as usize, at);
    progress.here = Here { along: Along::At(spot), ..progress.here };
}

/// The angle nearest to where the axis stands that means the same direction, degrees. Half a turn leads back
/// towards zero: to and fro the knife does not wind itself up.
pub(crate) fn nearest_turn(stands: f64, direction: f64) -> f64 {
    let turn = (direction - stands + 180.0).rem_euclid(360.0) - 180.0;
    let half = turn.abs() > 180.0 - SAME_DEG;
    stands + if half { 180.0_f64.copysign(if stands < 0.0 { 1.0 } else { -1.0 }) } else { turn }
}

#[cfg(test)]
mod tests {
    use super::nearest_turn;

    #[test]
    fn the_knife_turns_the_short_way() {
        let cases =
            [(0.0, 90.0, 90.0), (270.0, 0.0, 360.0), (350.0, -90.0, 270.0), (0.0, 179.0, 179.0)];
        let halves = [(0.0, 180.0, -180.0), (-180.0, 0.0, 0.0), (180.0, 0.0, 0.0)];
        for (stands, direction, expected) in cases.into_iter().chain(halves) {
            assert!((nearest_turn(stands, direction) - expected).abs() < 1e-9);
        }
    }
}
