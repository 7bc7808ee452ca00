//! Fewer lines for pictures of very long programs, within a stated distance.
//!
//! From the last kept point a cone is held in which a straight line may leave and still pass every
//! skipped point closely enough; the first point outside the cone starts the next line. This is the
//! sleeve fitting of Zhao and Saalfeld ("Linear-time sleeve-fitting polyline simplification
//! algorithms", 1997) with a limit on turning back, so that spikes stay.

use super::{Op, Outline};
use kerf_geom::{Point2, Vec2};

/// The same path with fewer steps, nowhere farther than `tolerance` from the given one.
pub fn simplify(outline: &Outline, tolerance: f64) -> Outline {
    let mut out = Outline::default();
    let mut sleeve: Option<Sleeve> = None;
    let mut pen = Point2::default();
    for op in &outline.ops {
        let straight = match *op {
            Op::Line(to) => Some(to),
            Op::Arc { centre, to, sweep_rad } => {
                (sagitta(pen, centre, sweep_rad) <= 0.25 * tolerance).then_some(to)
            }
            Op::Move(_) | Op::Close => None,
        };
        if let Some(to) = straight {
            let current = sleeve.get_or_insert_with(|| Sleeve::new(pen, tolerance));
            if !current.takes(to) {
                let kept = current.end;
                out.line_to(kept);
                *current = Sleeve::new(kept, tolerance);
                current.takes(to);
            }
        } else {
            if let Some(done) = sleeve.take() {
                out.line_to(done.end);
            }
            copy(&mut out, *op);
        }
        pen = end_of(op).unwrap_or(pen);
    }
    if let Some(done) = sleeve {
        out.line_to(done.end);
    }
    out
}

fn copy(out: &mut Outline, op: Op) {
    match op {
        Op::Move(to) => out.move_to(to),
        Op::Line(to) => out.line_to(to),
        Op::Arc { centre, to, sweep_rad } => out.arc_to(centre, to, sweep_rad),
        Op::Close => out.close(),
    }
}

fn end_of(op: &Op) -> Option<Point2> {
    match *op {
        Op::Move(to) | Op::Line(to) | Op::Arc { to, .. } => Some(to),
        Op::Close => None,
    }
}

/// Returns the greatest distance of an arc from its chord.
fn sagitta(from: Point2, centre: Point2, sweep_rad: f64) -> f64 {
    let radius = from.distance(centre);
    if sweep_rad.abs() >= std::f64::consts::PI {
        2.0 * radius
    } else {
        radius * (1.0 - (0.5 * sweep_rad).cos())
    }
}

/// The lines that may leave `anchor`.
struct Sleeve {
    anchor: Point2,
    end: Point2,
    /// Distance that skipped points may have; half the tolerance, as the ends and arcs add theirs.
    near: f64,
    reach: f64,
    /// Rightmost and leftmost direction allowed, once a point outside `near` was seen.
    cone: Option<[Vec2; 2]>,
}

impl Sleeve {
    fn new(anchor: Point2, tolerance: f64) -> Self {
        Self { anchor, end: anchor, near: 0.5 * tolerance, reach: 0.0, cone: None }
    }

    /// Returns `true` if the line may go on to `to`; if so it ends there now.
    fn takes(&mut self, to: Point2) -> bool {
        let step = to - self.anchor;
        let distance = step.length();
        if distance < self.reach - self.near {
            return false;
        }
        if distance > self.near {
            let towards = step * (1.0 / distance);
            if self.cone.is_some_and(|[right, left]| {
                right.cross(towards) < 0.0 || towards.cross(left) < 0.0
            }) {
                return false;
            }
            let half = (self.near / distance).asin();
            let (right, left) = (towards.rotated(-half), towards.rotated(half));
            self.cone = Some(match self.cone {
                None => [right, left],
                Some([r, l]) => [
                    if r.cross(right) > 0.0 { right } else { r },
                    if left.cross(l) > 0.0 { left } else { l },
                ],
            });
        }
        self.reach = self.reach.max(distance);
        self.end = to;
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn polyline(points: impl IntoIterator<Item = (f64, f64)>) -> Outline {
        let mut outline = Outline::default();
        for (i, (x, y)) in points.into_iter().enumerate() {
            let at = Point2::new(x, y);
            if i == 0 { outline.move_to(at) } else { outline.line_to(at) }
        }
        outline
    }

    fn points(outline: &Outline) -> Vec<Point2> {
        outline.ops.iter().filter_map(end_of).collect()
    }

    fn distance_to(p: Point2, line: &[Point2]) -> f64 {
        line.windows(2)
            .map(|w| {
                let along = w[1] - w[0];
                let share = ((p - w[0]).dot(along) / along.dot(along).max(1e-300)).clamp(0.0, 1.0);
                p.distance(w[0] + along * share)
            })
            .fold(f64::INFINITY, f64::min)
    }

    /// Simplifies and checks that no given point is farther than the tolerance from what is left.
    fn kept(outline: &Outline, tolerance: f64) -> usize {
        let less = points(&simplify(outline, tolerance));
        let all = points(outline);
        for p in &all {
            let d = distance_to(*p, &less);
            assert!(d <= tolerance, "{p:?} is {d} away");
        }
        assert_eq!((all.first(), all.last()), (less.first(), less.last()));
        less.len()
    }

    #[test]
    fn collinear_points_go_and_corners_stay() {
        let l = polyline(
            (0..=10).map(|i| (f64::from(i), 0.0)).chain((1..=10).map(|i| (10.0, f64::from(i)))),
        );
        assert_eq!(kept(&l, 0.01), 3);
    }

    #[test]
    fn a_spike_that_turns_back_stays() {
        let spike = polyline([(0.0, 0.0), (5.0, 0.0), (20.0, 0.0), (6.0, 0.0), (7.0, 0.0)]);
        assert_eq!(kept(&spike, 0.1), 4);
    }

    #[test]
    fn a_fine_spiral_stays_within_the_tolerance() {
        let spiral = polyline((0..5000).map(|i| {
            let a = f64::from(i) * 0.01;
            (a * a.cos(), a * a.sin())
        }));
        let n = kept(&spiral, 0.05);
        assert!(n < 800, "{n}");
    }

    #[test]
    fn tiny_arcs_become_lines_and_large_ones_stay() {
        let mut o = Outline::default();
        o.move_to(Point2::new(1.0, 0.0));
        o.arc_to(Point2::default(), Point2::new(0.0, 1.0), std::f64::consts::FRAC_PI_2);
        assert!(matches!(simplify(&o, 0.1).ops[1], Op::Arc { .. }));
        assert!(matches!(simplify(&o, 2.0).ops[1], Op::Line(_)));
    }
}
