//! Paths of straight lines and exact arcs.

use super::Rect;
use kerf_geom::{Arc2, Point2, Vec2};

/// One step of a path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Op {
    /// Starts a new stretch.
    Move(Point2),
    /// A straight line.
    Line(Point2),
    /// Around a centre, positive sweep from +X towards +Y of its frame.
    Arc {
        /// Centre.
        centre: Point2,
        /// End; not quite on the circle when the program was not exact.
        to: Point2,
        /// Swept angle, radians.
        sweep_rad: f64,
    },
    /// Back to the start of the stretch.
    Close,
}

/// A path, possibly of several stretches.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Outline {
    /// Its steps.
    pub ops: Vec<Op>,
    pen: Option<Point2>,
}

impl Outline {
    /// Starts a new stretch, unless the pen is there already.
    pub fn move_to(&mut self, at: Point2) {
        if self.pen != Some(at) {
            self.ops.push(Op::Move(at));
            self.pen = Some(at);
        }
    }

    /// A straight line.
    pub fn line_to(&mut self, to: Point2) {
        self.ops.push(Op::Line(to));
        self.pen = Some(to);
    }

    /// An arc.
    pub fn arc_to(&mut self, centre: Point2, to: Point2, sweep_rad: f64) {
        self.ops.push(Op::Arc { centre, to, sweep_rad });
        self.pen = Some(to);
    }

    /// Closes the stretch; the next one starts anew.
    pub fn close(&mut self) {
        self.ops.push(Op::Close);
        self.pen = None;
    }

    /// A straight stretch of its own.
    pub fn segment(&mut self, from: Point2, to: Point2) {
        self.move_to(from);
        self.line_to(to);
    }

    /// A closed polygon.
    pub fn polygon(&mut self, corners: &[Point2]) {
        let Some((first, rest)) = corners.split_first() else { return };
        self.move_to(*first);
        rest.iter().for_each(|p| self.line_to(*p));
        self.close();
    }

    /// A full circle.
    pub fn circle(&mut self, centre: Point2, radius: f64) {
        let start = centre + Vec2::new(radius, 0.0);
        self.move_to(start);
        self.arc_to(centre, start, std::f64::consts::TAU);
        self.close();
    }

    /// A rectangle of the page.
    pub fn of_rect(rect: Rect) -> Self {
        let mut outline = Self::default();
        outline.polygon(&[
            Point2::new(rect.x, rect.y),
            Point2::new(rect.right(), rect.y),
            Point2::new(rect.right(), rect.bottom()),
            Point2::new(rect.x, rect.bottom()),
        ]);
        outline
    }
}

/// Cuts an arc into pieces that sweep at most `most_rad`, each given by its end and its own sweep.
///
/// The last piece ends at `to` itself. Where `to` lies off the circle the pieces between wander
/// there evenly.
pub fn arc_pieces(
    from: Point2,
    centre: Point2,
    to: Point2,
    sweep_rad: f64,
    most_rad: f64,
) -> impl Iterator<Item = (Point2, f64)> {
    let arc = Arc2 { start: from, centre, sweep_rad };
    let miss = to - arc.end();
    let count = (sweep_rad.abs() / most_rad - 1e-9).ceil().clamp(1.0, 1.0e5) as u32;
    (1..=count).map(move |k| {
        let share = f64::from(k) / f64::from(count);
        let end = if k == count { to } else { arc.at(share) + miss * share };
        (end, sweep_rad / f64::from(count))
    })
}
