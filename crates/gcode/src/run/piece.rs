//! One move of the tool beside the path: where it ends, where two of them cross.

use super::round;
use kerf_geom::{Point2, Vec2};
use kerf_program::{At, Axes, Command, Feed, Line, MoveKind, Settings};
use serde::{Deserialize, Serialize};

/// Lengths below this are rounding, mm.
pub(super) const TINY_MM: f64 = 1e-7;

/// A move of the tool beside the path.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Piece {
    pub(super) at: At,
    pub(super) kind: MoveKind,
    pub(super) feed: Feed,
    pub(super) from: Point2,
    pub(super) to: Axes,
    pub(super) shape: Shape,
    /// Direction of the programmed path at its start and its end.
    pub(super) heading: [Vec2; 2],
    /// Bend of the programmed path, 1/mm: above zero to the left.
    #[serde(default)]
    pub(super) bend: f64,
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(super) enum Shape {
    Line,
    Arc { centre: Point2, sweep: f64 },
}

/// X and Y of a position.
pub(super) fn xy(axes: Axes) -> Point2 {
    Point2::new(axes.0[0], axes.0[1])
}

/// A position at another X and Y.
pub(super) fn with_xy(mut axes: Axes, p: Point2) -> Axes {
    (axes.0[0], axes.0[1]) = (p.x, p.y);
    axes
}

impl Piece {
    pub(super) fn end(&self) -> Point2 {
        xy(self.to)
    }

    /// The radius about a centre. Its start may lie a hair off the circle, where the path goes on
    /// almost straight; its end does not before it is trimmed.
    fn radius(&self, centre: Point2) -> f64 {
        self.end().distance(centre)
    }

    /// The same move elsewhere.
    pub(super) fn nudge(&mut self, by: Axes) {
        let way = Vec2::new(by.0[0], by.0[1]);
        self.from += way;
        self.to = self.to.plus(by);
        if let Shape::Arc { centre, .. } = &mut self.shape {
            *centre += way;
        }
    }

    /// Direction of the tool on a straight piece; the entry move does not go along the path.
    fn direction(&self) -> Vec2 {
        (self.end() - self.from).normalized().unwrap_or(self.heading[1])
    }

    /// The same path ending elsewhere on it; `None` when the place lies behind its start.
    pub(super) fn ending_at(mut self, p: Point2) -> Option<Self> {
        let (end, direction) = (self.end(), self.direction());
        match &mut self.shape {
            Shape::Line if (p - self.from).dot(direction) < -TINY_MM => return None,
            Shape::Line => {}
            Shape::Arc { centre, sweep } => {
                let back = turn(p - *centre, end - *centre, *sweep);
                if back > sweep.abs() + TINY_MM {
                    return None;
                }
                *sweep -= back.copysign(*sweep);
            }
        }
        self.to = with_xy(self.to, p);
        Some(self)
    }

    /// The same path beginning elsewhere on it; `None` when the place lies behind its end.
    pub(super) fn starting_at(mut self, p: Point2) -> Option<Self> {
        let end = self.end();
        match &mut self.shape {
            Shape::Line if (end - p).dot(self.heading[0]) < -TINY_MM => return None,
            Shape::Line => {}
            Shape::Arc { centre, sweep } => {
                let cut = turn(self.from - *centre, p - *centre, *sweep);
                if cut > sweep.abs() + TINY_MM {
                    return None;
                }
                *sweep -= cut.copysign(*sweep);
            }
        }
        self.from = p;
        Some(self)
    }

    /// Returns `true` if an arc would have to go on beyond its end to reach a place.
    fn ends_before(&self, p: Point2) -> bool {
        match self.shape {
            Shape::Line => false,
            Shape::Arc { centre, sweep } => turn(p - centre, self.end() - centre, sweep) < -TINY_MM,
        }
    }

    /// Returns `true` if an arc would have to begin before its start to reach a place.
    fn begins_behind(&self, p: Point2) -> bool {
        match self.shape {
            Shape::Line => false,
            Shape::Arc { centre, sweep } => turn(self.from - centre, p - centre, sweep) < -TINY_MM,
        }
    }

    /// The command that makes it from a place; `None` for one that goes nowhere.
    pub(super) fn command(&self, settings: &Settings, from: Axes) -> Option<Command> {
        let Self { kind, to, feed, .. } = *self;
        Some(match self.shape {
            Shape::Line if from == to => return None,
            Shape::Line => Command::Line(Line { kind, to, feed }),
            Shape::Arc { centre, sweep } => {
                let centre = [centre.x, centre.y];
                let mut command = round::command(settings, from, centre, sweep, to, feed);
                command.kind = kind;
                Command::Arc(command)
            }
        })
    }
}

/// The angle from one radius to another in the direction of a sweep, −π … π: small and below zero
/// when the second lies just behind the first.
fn turn(a: Vec2, b: Vec2, sweep: f64) -> f64 {
    a.cross(b).atan2(a.dot(b)) * sweep.signum()
}

/// The place where two paths cross: one that shortens both before one that lengthens an arc, as happens where both
/// places are as far from the corner, then the nearest to a place.
pub(super) fn crossing(a: &Piece, b: &Piece, near: Point2) -> Option<Point2> {
    let candidates = match (a.shape, b.shape) {
        (Shape::Line, Shape::Line) => {
            // The line beside the path; an entry move itself lies aslant.
            let (d, e) = (a.heading[1], b.heading[0]);
            let cross = d.cross(e);
            let along = (b.from - a.end()).cross(e) / cross;
            [(cross.abs() > 1e-12).then(|| a.end() + d * along), None]
        }
        (Shape::Line, Shape::Arc { centre, .. }) => {
            line_circle(a.end(), a.heading[1], centre, b.radius(centre))
        }
        (Shape::Arc { centre, .. }, Shape::Line) => {
            line_circle(b.from, b.heading[0], centre, a.radius(centre))
        }
        (Shape::Arc { centre: c1, .. }, Shape::Arc { centre: c2, .. }) => {
            circles(c1, a.radius(c1), c2, b.radius(c2))
        }
    };
    let lengthened = |p: Point2| u8::from(a.ends_before(p)) + u8::from(b.begins_behind(p));
    let rank = |p: &Point2| (lengthened(*p), p.distance(near));
    let by_rank = |p: &Point2, q: &Point2| {
        let (p, q) = (rank(p), rank(q));
        p.0.cmp(&q.0).then(p.1.total_cmp(&q.1))
    };
    candidates.into_iter().flatten().min_by(by_rank)
}

fn line_circle(p: Point2, d: Vec2, centre: Point2, radius: f64) -> [Option<Point2>; 2] {
    let along = (centre - p).dot(d);
    let foot = p + d * along;
    let height = foot.distance(centre);
    if height > radius {
        return [None, None];
    }
    let half = (radius * radius - height * height).sqrt();
    [Some(foot + d * half), Some(foot + d * -half)]
}

fn circles(c1: Point2, r1: f64, c2: Point2, r2: f64) -> [Option<Point2>; 2] {
    let between = c2 - c1;
    let distance = between.length();
    let along = (distance * distance + r1 * r1 - r2 * r2) / (2.0 * distance);
    let square = r1 * r1 - along * along;
    let (Some(d), true) = (between.normalized(), square >= 0.0) else { return [None, None] };
    let (foot, height) = (c1 + d * along, square.sqrt());
    [Some(foot + d.left() * height), Some(foot + d.left() * -height)]
}
