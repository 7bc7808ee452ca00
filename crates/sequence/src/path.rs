//! Following a path: its segments as commands, and finding the place where it was left.

use crate::Sequence;
use crate::place::{Along, Here, Spot};
use kerf_geom::{Point2, Segment};
use kerf_machine::planning::CHORDS;
use kerf_program::job::{Depths, JobShape};
use kerf_program::{Arc, Axes, Axis, Command, Feed, Halted, Line, MoveKind, Sourced};

/// Angles closer than this are the same, degrees.
const SAME_DEG: f64 = 1e-9;

/// The motion commands of the path at hand: which segment each of them makes.
#[derive(Clone, Debug, Default)]
pub(crate) struct Followed {
    /// Number of the first.
    first: u64,
    /// Segment of each.
    segments: Vec<u32>,
}

impl Sequence {
    /// Gives the rest of the path at hand.
    pub(crate) fn follow(&mut self, out: &mut Vec<Sourced>) {
        let job = self.job.clone();
        let Some(shape) = self.here.shape(&job) else { return };
        let Some(spot) = self.here.spot(shape) else { return };
        self.tell_limited(shape, out);
        self.followed = Followed { first: self.motions + 1, segments: Vec::new() };
        for number in spot.segment..shape.path.segment_count() {
            let segment = shape.path.segment(number);
            let share = if number == spot.segment { spot.share } else { 0.0 };
            if share < 1.0 {
                let rest = segment.part(share, 1.0);
                self.turn_into(rest.direction(0.0).y.atan2(rest.direction(0.0).x), number, out);
                self.segment(shape, number, &rest, out);
            }
        }
    }

    /// The height from which the tool goes down along the path or a helix, when it does: that of the pass
    /// before, at the beginning of a path cut at one height.
    pub(crate) fn slopes_from(&self, shape: &JobShape, spot: &Spot) -> Option<f64> {
        let Depths::Level(levels) = &self.depths else { return None };
        if self.height_law(shape).is_some() {
            return None;
        }
        let pass = self.here.pass;
        let before = if pass == 0 { Some(&self.heights.surface_mm) } else { levels.get(pass - 1) };
        let begins = spot.segment == 0 && spot.share == 0.0;
        let (from, to) = (*before?, *levels.get(pass)?);
        let slopes = begins && !shape.plunge.slopes(&shape.path, from, to).is_empty();
        slopes.then_some(from)
    }

    /// Gives the way down to the beginning of the path at hand; whether there is one. A stop on it leaves
    /// the path as not begun.
    pub(crate) fn slope(&mut self, out: &mut Vec<Sourced>) -> bool {
        let job = self.job.clone();
        let (Some(shape), Depths::Level(levels)) = (self.here.shape(&job), &self.depths) else {
            return false;
        };
        let Some(to) = levels.get(self.here.pass).copied() else { return false };
        self.followed = Followed { first: self.motions + 1, segments: Vec::new() };
        let slopes = shape.plunge.slopes(&shape.path, self.position[Axis::Z], to);
        for slope in &slopes {
            self.motion(shape, &slope.segment, Some(slope.z_mm), out);
        }
        !slopes.is_empty()
    }

    fn segment(
        &mut self,
        shape: &JobShape,
        number: usize,
        segment: &Segment,
        out: &mut Vec<Sourced>,
    ) {
        let along = |base: f64| base + shape.height_mm(number + 1);
        let z = if let Depths::Along(base) = self.depths { Some(along(base)) } else { None };
        self.followed.segments.push(number as u32);
        self.motion(shape, segment, z, out);
    }

    /// Gives a segment, to a height or at the present one.
    fn motion(
        &mut self,
        shape: &JobShape,
        segment: &Segment,
        z: Option<f64>,
        out: &mut Vec<Sourced>,
    ) {
        let to = self.job.on_table(segment.end());
        let mut axes = self.position;
        (axes[Axis::X], axes[Axis::Y]) = (to.x, to.y);
        axes[Axis::Z] = z.unwrap_or(axes[Axis::Z]);
        let kind = if shape.traversal { MoveKind::Jog } else { MoveKind::Cut };
        let feed = Feed::Path(self.feed(shape, segment, &axes));
        let command = match *segment {
            Segment::Line { .. } => Command::Line(Line { kind, to: axes, feed }),
            Segment::Arc { centre, sweep_rad, .. } => {
                if self.machine.misc.tangential {
                    axes[Axis::C] += sweep_rad.to_degrees();
                }
                let centre = self.job.on_table(centre);
                let centre = [centre.x, centre.y];
                let chords = CHORDS;
                Command::Arc(Arc { kind, centre, sweep_rad, to: axes, feed, chords, small: false })
            }
        };
        self.move_by(command, axes, out);
    }

    /// The knife turns into the direction of what comes next: the short way, at once when the corner
    /// is one, else along the way (readings, Speeds).
    fn turn_into(&mut self, direction_rad: f64, number: usize, out: &mut Vec<Sourced>) {
        if !self.machine.misc.tangential {
            return;
        }
        let target = nearest_turn(self.position[Axis::C], direction_rad.to_degrees());
        let turn = (target - self.position[Axis::C]).abs();
        let mut axes = self.position;
        axes[Axis::C] = target;
        if turn >= self.settings.smoothing.stop_angle_deg {
            let feed = Feed::Path(self.settings.axis_dynamics().speed_mm_s[Axis::C]);
            self.followed.segments.push(number as u32);
            self.move_by(Command::Line(Line { kind: MoveKind::Cut, to: axes, feed }), axes, out);
        } else {
            self.position = axes;
        }
    }

    /// Cutting speed of a segment: the least of the shape's and the machine's in its direction. What
    /// the axes allow is the planner's concern.
    fn feed(&self, shape: &JobShape, segment: &Segment, to: &Axes) -> f64 {
        if shape.traversal {
            return self.rapid_mm_s(*to);
        }
        let way = segment.end() - segment.start();
        let share = match segment {
            Segment::Line { .. } => {
                self.settings.smoothing.speed_share(way.y.abs().atan2(way.x.abs()))
            }
            Segment::Arc { .. } => 1.0,
        };
        shape.speed_mm_s.unwrap_or(f64::INFINITY).min(self.cut_mm_s * share)
    }

    /// Remembers how far the path at hand was made when motion was stopped.
    pub(crate) fn keep_place(&mut self, halted: &Halted) {
        let Some(shape) = self.here.shape(&self.job) else { return };
        let Some(motion) = halted.motion else {
            self.here.along = Along::After;
            return;
        };
        let index = motion.saturating_sub(self.followed.first) as usize;
        let Some(segment) = self.followed.segments.get(index) else { return };
        let on_table = Point2::new(halted.stands[Axis::X], halted.stands[Axis::Y]);
        let origin = self.job.origin.unwrap_or_default();
        let at = Point2::new(on_table.x - origin.x, on_table.y - origin.y);
        let spot = Spot::near(&shape.path, *segment as usize, at);
        self.here = Here { along: Along::At(spot), ..self.here };
    }

    /// Height of the tool at a spot of the path at hand, machine frame.
    pub(crate) fn height_at(&self, shape: &JobShape, spot: &Spot) -> f64 {
        match &self.depths {
            Depths::Level(levels) => {
                levels.get(self.here.pass).copied().unwrap_or(self.heights.bottom_mm)
            }
            Depths::Along(base) => {
                let (from, to) = (shape.height_mm(spot.segment), shape.height_mm(spot.segment + 1));
                base + from + (to - from) * spot.share
            }
        }
    }
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
