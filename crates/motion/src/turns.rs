//! Changes of direction summed over a distance, so that a curve made of tiny segments counts as the
//! curve that it is (command reference, "Minimum Distance to Check").
//!
//! A [`Bend`] is a place where the direction changes: a joint between moves, or an arc shorter than
//! the distance. For each bend the greatest net change of direction over any stretch of path is
//! sought that begins or ends at it and is no longer than the distance. Net means that the zigzag
//! of rounded coordinates about a straight line cancels, while every wiggle is still seen by the
//! stretch that holds just one flank of it.
//!
//! The headings are unwrapped, so that net change is a difference, and the greatest difference is
//! found with the sliding minimum and maximum of a monotone queue: one step for each bend however
//! many share a window.

use std::ops::Range;

/// A place where the direction changes. Compact: a stack may have millions.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bend {
    /// Place along the path, mm.
    pub at_mm: f64,
    /// Unwrapped heading before it, radians.
    pub before_rad: f64,
    /// Turn of the direction, radians, positive to the left.
    pub turn_rad: f32,
    /// XY speed there for a speed of 1 along the reference length.
    pub xy: f32,
    /// Joint or move that it limits.
    pub place: BendAt,
}

/// Joint or move that a bend limits.
#[derive(Clone, Copy, Debug)]
pub(crate) enum BendAt {
    /// The joint before this move.
    Joint(u32),
    /// This move, a short arc.
    Arc(u32),
    /// This move, an arc so small that it rounds a corner.
    Fillet(u32),
}

impl BendAt {
    /// The move that begins there or is it.
    pub const fn number(self) -> u32 {
        match self {
            Self::Joint(number) | Self::Arc(number) | Self::Fillet(number) => number,
        }
    }

    /// The arc that it is.
    pub const fn arc(self) -> Option<u32> {
        match self {
            Self::Joint(_) => None,
            Self::Arc(number) | Self::Fillet(number) => Some(number),
        }
    }
}

impl Bend {
    fn after_rad(&self) -> f64 {
        self.before_rad + f64::from(self.turn_rad)
    }
}

/// A bend belongs to the curve in a window only if it turns at least this share of what the curve
/// turns on average over the path that the bend stands for, half the way to each neighbour. Guess. It keeps a slight bend of a long
/// straight from being taken for the sharp corner that follows it.
const OF_CURVE: f32 = 0.25;

/// For each bend, what the direction changes over a stretch of at most `window_mm` that begins or
/// ends at it, radians, not negative; `found` (one for each bend) holds what is known already and is only raised. Gives
/// the greatest change over any stretch, whether or not its ends belong to the curve.
///
/// Changes below `least_rad` do not matter to the caller and may be told too small; what is given
/// may be too great where only they are.
pub(crate) fn sum_turns(bends: &[Bend], window_mm: f64, least_rad: f64, found: &mut [f32]) -> f32 {
    let (curves, mut greatest) = curves(bends, window_mm, least_rad);
    let mut queue = Extremes::default();
    for curve in curves {
        queue.clear();
        for k in curve.clone() {
            let turn = queue.turn(bends, k, window_mm, |b| b.before_rad, Bend::after_rad) as f32;
            greatest = greatest.max(turn);
            raise(bends, k, window_mm, turn, &mut found[k]);
        }
        queue.clear();
        for k in curve.rev() {
            let turn = queue.turn(bends, k, window_mm, Bend::after_rad, |b| b.before_rad) as f32;
            raise(bends, k, window_mm, turn, &mut found[k]);
        }
    }
    greatest
}

/// Stretches of at most `window_mm`, first and last bend, on which the direction changes so much that it `is_full`, without
/// corners: joints where it does so at once, and fillets. Their ends belong to the curve.
pub(crate) fn full_stretches(
    bends: &[Bend],
    window_mm: f64,
    full_rad: f64,
    is_full: impl Fn(f64) -> bool,
) -> Vec<(usize, usize)> {
    let way_mm = |a: usize, b: usize| bends[b].at_mm - bends[a].at_mm;
    let is_corner = |bend: &Bend| match bend.place {
        BendAt::Joint(_) => is_full(f64::from(bend.turn_rad.abs())),
        BendAt::Arc(_) => false,
        BendAt::Fillet(_) => true,
    };
    // A bend at an end stands for half the way to its neighbour within.
    let belongs = |end: usize, inner: usize| {
        let share = (0.5 * way_mm(end, inner).abs() / window_mm) as f32;
        bends[end].turn_rad.abs() >= OF_CURVE * share * full_rad as f32
    };
    let mut stretches: Vec<(usize, usize)> = Vec::new();
    let mut queue = Extremes::default();
    for curve in curves(bends, window_mm, full_rad).0 {
        queue.clear();
        let mut begin = curve.start;
        for k in curve {
            if is_corner(&bends[k]) {
                queue.clear();
                begin = k + 1;
                continue;
            }
            while way_mm(begin, k) > window_mm {
                begin += 1;
            }
            let Some(latest) = queue.latest(bends, k, window_mm, &is_full) else { continue };
            let here = bends[k].after_rad();
            let ends_at = |i: &usize| {
                let full = is_full((here - bends[*i].before_rad).abs());
                full && (*i == k || belongs(*i, *i + 1) && belongs(k, k - 1))
            };
            stretches.extend((begin..=latest).find(ends_at).map(|first| (first, k)));
        }
    }
    stretches
}

/// The bends between which the direction may change by `least_rad` within the window, as far as
/// the sum of all their turns, whatever their sense, tells; and the greatest such sum of the others.
///
/// Most of a path is nearly straight, and the sum is far quicker than the search for the extremes.
fn curves(bends: &[Bend], window_mm: f64, least_rad: f64) -> (Vec<Range<usize>>, f32) {
    // An arc between two bends that is too long for one turns as well.
    let arcs = |k: usize| match k.checked_sub(1) {
        Some(last) => (bends[k].before_rad - bends[last].after_rad()).abs(),
        None => 0.0,
    };
    // Whole numbers, so that nothing adds up over a million bends.
    let turn = |k: usize| {
        let turn = f64::from(bends[k].turn_rad.abs()) + arcs(k);
        (turn / GRAIN_RAD) as u64 + 1
    };
    let least = (least_rad / GRAIN_RAD) as u64;
    let mut curves: Vec<Range<usize>> = Vec::new();
    let (mut first, mut sum, mut greatest) = (0, 0, 0);
    for k in 0..bends.len() {
        sum += turn(k);
        while bends[k].at_mm - bends[first].at_mm > window_mm {
            sum -= turn(first);
            first += 1;
        }
        if sum < least {
            greatest = greatest.max(sum);
            continue;
        }
        match curves.last_mut() {
            Some(curve) if first <= curve.end => curve.end = k + 1,
            _ => curves.push(first..k + 1),
        }
    }
    (curves, (greatest as f64 * GRAIN_RAD) as f32)
}

/// Unit of turns that are only added up, radians.
const GRAIN_RAD: f64 = 1.0 / (1u64 << 32) as f64;

fn raise(bends: &[Bend], k: usize, window_mm: f64, turn: f32, found: &mut f32) {
    if turn > *found {
        let share = (span_mm(bends, k, window_mm) / window_mm) as f32;
        if bends[k].turn_rad.abs() >= OF_CURVE * share.min(1.0) * turn {
            *found = turn;
        }
    }
}

/// Returns the length of path that a bend stands for, as far as it lies within the window on each side.
fn span_mm(bends: &[Bend], k: usize, window_mm: f64) -> f64 {
    let way = |a: usize, b: usize| match (bends.get(a), bends.get(b)) {
        (Some(a), Some(b)) => (b.at_mm - a.at_mm).min(window_mm),
        _ => window_mm,
    };
    0.5 * (way(k.wrapping_sub(1), k) + way(k, k + 1))
}

/// Bends of a window with rising and falling headings: the fronts are the lowest and the highest.
#[derive(Default)]
struct Extremes {
    low: Queue,
    high: Queue,
}

/// A queue in a vector; the front only moves on.
#[derive(Default)]
struct Queue {
    items: Vec<u32>,
    front: usize,
}

impl Extremes {
    /// Takes bend `k` into the window, drops what lies too far behind, and gives the greatest
    /// change between the far side of a bend in it and the near side of this one.
    fn turn(
        &mut self,
        bends: &[Bend],
        k: usize,
        window_mm: f64,
        far: impl Fn(&Bend) -> f64,
        near: impl Fn(&Bend) -> f64,
    ) -> f64 {
        let out = |i: u32| (bends[k].at_mm - bends[i as usize].at_mm).abs() > window_mm;
        let heading = |i: u32| far(&bends[i as usize]);
        let own = far(&bends[k]);
        self.low.push(k, out, |i| heading(i) >= own);
        self.high.push(k, out, |i| heading(i) <= own);
        let here = near(&bends[k]);
        (here - heading(self.low.first())).max(heading(self.high.first()) - here)
    }

    /// The same of the latest bend from which to bend `k` the direction changes so much that it `is_full`.
    fn latest(
        &mut self,
        bends: &[Bend],
        k: usize,
        window_mm: f64,
        is_full: impl Fn(f64) -> bool,
    ) -> Option<usize> {
        self.turn(bends, k, window_mm, |b| b.before_rad, Bend::after_rad);
        let here = bends[k].after_rad();
        let before = |i: u32| bends[i as usize].before_rad;
        let low = self.low.last_with(|i| is_full(here - before(i)));
        let high = self.high.last_with(|i| is_full(before(i) - here));
        low.max(high).map(|i| i as usize)
    }

    fn clear(&mut self) {
        self.low.clear();
        self.high.clear();
    }
}

impl Queue {
    fn push(&mut self, k: usize, out: impl Fn(u32) -> bool, beaten: impl Fn(u32) -> bool) {
        while self.items.len() > self.front && beaten(self.items[self.items.len() - 1]) {
            self.items.pop();
        }
        self.items.push(k as u32);
        while out(self.items[self.front]) {
            self.front += 1;
        }
    }

    fn first(&self) -> u32 {
        self.items[self.front]
    }

    /// The last of those at the front that are `so`; all behind it are not.
    fn last_with(&self, so: impl Fn(u32) -> bool) -> Option<u32> {
        let items = &self.items[self.front..];
        let many = items.partition_point(|&i| so(i));
        many.checked_sub(1).map(|last| items[last])
    }

    fn clear(&mut self) {
        self.items.clear();
        self.front = 0;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Bends at places with turns in degrees.
    fn bends(places: &[(f64, f32)]) -> Vec<Bend> {
        let mut heading_rad = 0.0;
        let bend = |(at_mm, degrees): &(f64, f32)| {
            let (before_rad, turn_rad) = (heading_rad, degrees.to_radians());
            heading_rad += f64::from(turn_rad);
            Bend { at_mm: *at_mm, before_rad, turn_rad, xy: 1.0, place: BendAt::Joint(0) }
        };
        places.iter().map(bend).collect()
    }

    /// Bends at places with turns in degrees; expects the sums.
    fn check(places: &[(f64, f32)], window: f64, expected: &[f32]) {
        let bends = bends(places);
        let mut found: Vec<f32> = bends.iter().map(|b| b.turn_rad.abs()).collect();
        let greatest = sum_turns(&bends, window, 0.0, &mut found);
        for (got, want) in found.iter().zip(expected) {
            assert!((got.to_degrees() - want).abs() < 1e-4, "{found:?} is not {expected:?}");
            assert!(*got <= greatest);
        }
    }

    #[test]
    fn turns_inside_the_window_add_up_in_both_directions() {
        let places = [(0.0, 30.0), (1.0, 30.0), (9.0, 20.0)];
        check(&places, 2.0, &[60.0, 60.0, 20.0]);
        check(&places, 0.5, &[30.0, 30.0, 20.0]);
        check(&places, 20.0, &[80.0, 60.0, 80.0]);
    }

    #[test]
    fn a_zigzag_cancels_and_a_wiggle_does_not() {
        let zigzag = [(0.0, 5.0), (1.0, -10.0), (2.0, 10.0), (3.0, -5.0)];
        check(&zigzag, 9.0, &[5.0, 10.0, 10.0, 5.0]);
        let wiggle = [(0.0, 20.0), (1.0, 20.0), (2.0, -20.0), (3.0, -20.0)];
        check(&wiggle, 9.0, &[40.0; 4]);
    }

    #[test]
    fn a_slight_bend_of_a_long_straight_is_not_the_corner_after_it() {
        check(&[(0.0, 0.1), (3.0, 90.0)], 4.0, &[0.1, 90.1]);
        check(&[(0.0, 40.0), (3.0, 90.0)], 4.0, &[130.0, 130.0]);
    }

    #[test]
    fn a_curve_is_full_from_its_first_bend_to_its_last() {
        let check = |places: &[(f64, f32)], expected: &[(usize, usize)]| {
            let bends = bends(places);
            let full = 45f64.to_radians();
            let found = full_stretches(&bends, 2.0, full, |turn| turn >= full - 1e-6);
            assert_eq!(found, expected, "{places:?}");
        };
        let quarter = [(0.0, 15.0), (0.5, 30.0), (1.0, 30.0), (1.5, 15.0)];
        check(&quarter, &[(0, 1), (0, 2), (0, 3)]);
        let ends = [(0.0, 6.0), (0.4, 20.0), (0.8, 20.0), (1.2, 20.0), (1.6, 6.0)];
        check(&ends, &[(0, 2), (0, 3), (0, 4)]);
        // A corner by itself is no curve.
        check(&[(0.0, 15.0), (0.5, 90.0), (1.0, 15.0)], &[]);
        check(&[(0.0, -20.0), (0.5, -20.0), (1.0, -20.0), (9.0, 20.0)], &[(0, 2)]);
        check(&[(0.0, 20.0), (0.5, -20.0), (1.0, 20.0)], &[]);
        check(&[(0.0, 20.0), (2.5, 20.0), (5.0, 20.0)], &[]);
        // A slight bend of a long straight does not belong to the corner after it.
        check(&[(0.0, 0.2), (1.9, 44.9)], &[]);
    }

    #[test]
    fn what_matters_is_found_whatever_is_left_out() {
        let (least, window) = (0.3, 2.0);
        let mut seed = 7u64;
        let mut random = move || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (seed >> 40) as f64 / (1u64 << 24) as f64
        };
        let (mut at_mm, mut before_rad, mut left_out) = (0.0, 0.0, 0);
        let bends: Vec<Bend> = (0..5000)
            .map(|k| {
                at_mm += random();
                let rough = if k / 100 % 2 == 0 { 0.05 } else { 0.4 };
                let turn_rad = ((random() - 0.5) * rough) as f32;
                let bend = Bend { at_mm, before_rad, turn_rad, xy: 1.0, place: BendAt::Joint(0) };
                before_rad += f64::from(turn_rad);
                bend
            })
            .collect();
        let mut all = vec![0.0; bends.len()];
        let mut some = all.clone();
        let greatest = sum_turns(&bends, window, 0.0, &mut all);
        assert_eq!(sum_turns(&bends, window, least, &mut some), greatest);
        for (all, some) in all.into_iter().zip(some) {
            if f64::from(all.max(some)) >= least {
                assert_eq!(all, some);
            }
            left_out += usize::from(all > 0.0 && some == 0.0);
        }
        assert!(left_out > 1000, "{left_out}");
    }
}
