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

/// A place where the direction changes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bend {
    /// Where along the path, mm.
    pub at_mm: f64,
    /// Unwrapped heading before it, radians.
    pub before_rad: f64,
    /// Unwrapped heading after it, radians.
    pub after_rad: f64,
    /// How much of the path it stands for: half the way to each neighbour, mm.
    pub span_mm: f64,
}

/// A bend belongs to the curve in a window only if it turns at least this share of what the curve
/// turns on average over the path that the bend stands for. Guess. It keeps a slight bend of a long
/// straight from being taken for the sharp corner that follows it.
const OF_CURVE: f64 = 0.25;

/// For each bend, what the direction changes over a stretch of at most `window_mm` that begins or
/// ends at it, radians, not negative; `found` holds what is known already and is only raised.
pub(crate) fn sum_turns(bends: &[Bend], window_mm: f64, found: &mut [f64]) {
    let mut queue = Extremes::default();
    for k in 0..bends.len() {
        let turn = queue.turn(bends, k, window_mm, |b| b.before_rad, |b| b.after_rad);
        raise(&bends[k], window_mm, turn, &mut found[k]);
    }
    queue.clear();
    for k in (0..bends.len()).rev() {
        let turn = queue.turn(bends, k, window_mm, |b| b.after_rad, |b| b.before_rad);
        raise(&bends[k], window_mm, turn, &mut found[k]);
    }
}

fn raise(bend: &Bend, window_mm: f64, turn: f64, found: &mut f64) {
    let own = (bend.after_rad - bend.before_rad).abs();
    let share = bend.span_mm.min(window_mm) / window_mm;
    if turn > *found && own >= OF_CURVE * share * turn {
        *found = turn;
    }
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

    fn clear(&mut self) {
        self.items.clear();
        self.front = 0;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Bends at places with turns in degrees; expects the sums in degrees.
    fn check(places: &[(f64, f64)], window: f64, expected: &[f64]) {
        let mut heading = 0.0;
        let bends: Vec<Bend> = places
            .iter()
            .map(|(at_mm, degrees)| {
                let before_rad = heading;
                heading += degrees.to_radians();
                Bend { at_mm: *at_mm, before_rad, after_rad: heading, span_mm: 0.0 }
            })
            .collect();
        let mut found = vec![0.0; bends.len()];
        sum_turns(&bends, window, &mut found);
        for (got, want) in found.iter().zip(expected) {
            assert!((got.to_degrees() - want).abs() < 1e-9, "{found:?} is not {expected:?}");
        }
    }

    #[test]
    fn turns_inside_the_window_add_up_in_both_directions() {
        check(&[(0.0, 30.0), (1.0, 30.0), (9.0, 20.0)], 2.0, &[60.0, 60.0, 20.0]);
        check(&[(0.0, 30.0), (1.0, 30.0), (9.0, 20.0)], 0.5, &[30.0, 30.0, 20.0]);
        check(&[(0.0, 30.0), (1.0, 30.0), (9.0, 20.0)], 20.0, &[80.0, 60.0, 80.0]);
    }

    #[test]
    fn a_zigzag_cancels_and_a_wiggle_does_not() {
        check(&[(0.0, 5.0), (1.0, -10.0), (2.0, 10.0), (3.0, -5.0)], 9.0, &[5.0, 10.0, 10.0, 5.0]);
        check(&[(0.0, 20.0), (1.0, 20.0), (2.0, -20.0), (3.0, -20.0)], 9.0, &[40.0; 4]);
    }

    #[test]
    fn a_slight_bend_of_a_long_straight_is_not_the_corner_after_it() {
        let corner = Bend { at_mm: 3.0, before_rad: 0.001, after_rad: 1.571, span_mm: 50.0 };
        let slight = Bend { at_mm: 0.0, before_rad: 0.0, after_rad: 0.001, span_mm: 50.0 };
        let mut found = [0.0; 2];
        sum_turns(&[slight, corner], 4.0, &mut found);
        assert!((found[0] - 0.001).abs() < 1e-12 && found[1] > 1.57, "{found:?}");
    }
}
