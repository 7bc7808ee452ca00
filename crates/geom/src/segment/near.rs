//! Decides exactly whether two segments come nearer to each other than a limit.
//!
//! Two curves are nearest to each other where they cross, at an end of one of them, or where the line between
//! the nearest places is square to both. For circles that line passes through their centres.

use super::{Segment, square};
use crate::{Point2, Vec2};

/// Tells whether some place of a segment lies nearer to some place of another one than `limit`.
pub(crate) fn comes_nearer(a: &Segment, b: &Segment, limit: f64) -> bool {
    a.is_nearer(b.start(), limit)
        || a.is_nearer(b.end(), limit)
        || b.is_nearer(a.start(), limit)
        || b.is_nearer(a.end(), limit)
        || match (a, b) {
            (Segment::Line { .. }, Segment::Line { .. }) => lines_cross(a, b),
            (Segment::Line { .. }, Segment::Arc { .. }) => line_and_arc(a, b, limit),
            (Segment::Arc { .. }, Segment::Line { .. }) => line_and_arc(b, a, limit),
            (Segment::Arc { .. }, Segment::Arc { .. }) => arcs(a, b, limit),
        }
}

fn lines_cross(a: &Segment, b: &Segment) -> bool {
    let parted = |line: &Segment, other: &Segment| {
        let along = line.end() - line.start();
        let side = |at: Point2| along.cross(at - line.start());
        side(other.start()) * side(other.end()) < 0.0
    };
    parted(a, b) && parted(b, a)
}

fn line_and_arc(line: &Segment, arc: &Segment, limit: f64) -> bool {
    let Segment::Arc { centre, radius, .. } = *arc else { return false };
    let out = |at: Point2| square(at - centre).sqrt() - radius;
    let share = line.share_of(centre);
    let beside = share > 0.0 && share < 1.0;
    let foot = line.at(share);
    if beside && out(foot).abs() < limit && arc.faces(foot) {
        return true;
    }
    let (start, end) = (out(line.start()), out(line.end()));
    let may_cross = start * end < 0.0 || (start > 0.0 && beside && out(foot) < 0.0);
    may_cross && !line.meet(arc).is_empty()
}

fn arcs(a: &Segment, b: &Segment, limit: f64) -> bool {
    let (Segment::Arc { centre: ca, radius: ra, .. }, Segment::Arc { centre: cb, radius: rb, .. }) =
        (*a, *b)
    else {
        return false;
    };
    let between = cb - ca;
    let apart = square(between).sqrt();
    // Circles about one centre are equally near all the way to an end of one of them.
    if apart == 0.0 {
        return false;
    }
    let along = between / apart;
    let facing = |arc: &Segment, centre: Point2, radius: f64| {
        let both: [Vec2; 2] = [along * radius, along * -radius];
        both.map(|out| Some(centre + out).filter(|at| arc.faces(*at)))
    };
    let (mine, theirs) = (facing(a, ca, ra), facing(b, cb, rb));
    let near = |p: Point2, q: Point2| square(p - q) < limit * limit;
    let any_near = |p: Point2| theirs.iter().flatten().any(|q| near(p, *q));
    if mine.iter().flatten().any(|p| any_near(*p)) {
        return true;
    }
    let may_cross = apart <= ra + rb && apart >= (ra - rb).abs();
    may_cross && !a.meet(b).is_empty()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The least distance between many places of both.
    fn sampled(a: &Segment, b: &Segment) -> f64 {
        let places =
            |s: &Segment| (0..=400).map(|k| s.at(f64::from(k) / 400.0)).collect::<Vec<_>>();
        let far = |p: &Point2| b.distance(*p);
        places(a).iter().map(far).fold(f64::INFINITY, f64::min)
    }

    #[test]
    fn agrees_with_many_places() {
        let mut seed = 7u64;
        let mut dice = || {
            seed = seed
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (seed >> 11) as f64 / (1u64 << 53) as f64
        };
        for _ in 0..4000 {
            let mut place = || Point2::new(dice() * 10.0, dice() * 10.0);
            let (p, q, r, s) = (place(), place(), place(), place());
            let mut bulge = || if dice() < 0.4 { 0.0 } else { dice() * 1.9 - 0.95 };
            let (a, b) = (Segment::bulged(p, q, bulge()), Segment::bulged(r, s, bulge()));
            let least = sampled(&a, &b);
            assert!(comes_nearer(&a, &b, least + 1e-9), "{a:?} {b:?} {least}");
            // Between two places that were looked at it may be nearer by a little.
            let slack = 0.5 * (a.length() / 400.0);
            assert!(least < slack || !comes_nearer(&a, &b, least - slack), "{a:?} {b:?} {least}");
        }
    }
}
