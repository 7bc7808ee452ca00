//! Finding segments by place: a tree of boxes in the order of travel.
//!
//! Neighbours on a path are neighbours in the plane, so eight consecutive boxes under one make a good
//! tree without any sorting: it is built in one pass and costs a seventh of the boxes on top.
//!
//! ```text
//! level 2            ┌───────────────────┐
//! level 1      ┌────────┬────────┬───    ...
//! level 0     01234567 89...                  boxes of the segments
//! ```

use crate::{Bounds2, Point2};

/// Steps along each side when boxes are put in order of their places.
const STEPS: f64 = 65535.0;

const FAN: usize = 8;

/// Enough for more boxes than there is memory.
const MOST_LEVELS: usize = 22;

/// So few boxes are faster looked at one by one.
const FEW: usize = 16;

/// Boxes that can be asked for those near a place or meeting another box.
#[derive(Clone, Debug, Default)]
pub struct BoxTree {
    /// All levels, lowest first.
    boxes: Vec<Bounds2>,
    /// Start of each level in `boxes`; the one after the last is the end.
    levels: [usize; MOST_LEVELS + 1],
    level_count: usize,
}

impl BoxTree {
    /// The tree over boxes in the order of travel.
    pub fn new(leaves: impl IntoIterator<Item = Bounds2>) -> Self {
        Self::in_list(Vec::new(), leaves)
    }

    /// The same in an empty list that somebody has at hand.
    pub(crate) fn in_list(
        mut boxes: Vec<Bounds2>,
        leaves: impl IntoIterator<Item = Bounds2>,
    ) -> Self {
        let leaves = leaves.into_iter();
        boxes.reserve(leaves.size_hint().0 * FAN / (FAN - 1) + FAN);
        boxes.extend(leaves);
        let mut levels = [0; MOST_LEVELS + 1];
        levels[1] = boxes.len();
        let mut level_count = 1;
        let mut from = 0;
        while boxes.len() - from > 1 {
            let to = boxes.len();
            for group in (from..to).step_by(FAN) {
                let mut whole: Bounds2 = boxes[group];
                boxes[group + 1..to.min(group + FAN)].iter().for_each(|b| whole.merge(b));
                boxes.push(whole);
            }
            from = to;
            level_count += 1;
            levels[level_count] = boxes.len();
        }
        Self { boxes, levels, level_count }
    }

    /// The list, to be used again.
    pub(crate) fn into_list(self) -> Vec<Bounds2> {
        self.boxes
    }

    /// An order of boxes in which neighbours in the plane are neighbours, for those that come in none: a
    /// tree over boxes scattered at random is none. The order is that of Morton (1966).
    pub fn order(boxes: &[Bounds2]) -> Vec<usize> {
        let mut whole = Bounds2::default();
        boxes.iter().for_each(|b| whole.merge(b));
        let size = whole.size();
        let step = |value: f64, from: f64, long: f64| {
            if long > 0.0 { ((value - from) / long * STEPS).clamp(0.0, STEPS) as u32 } else { 0 }
        };
        let code = |b: &Bounds2| {
            let (x, y) = (0.5 * (b.min.x + b.max.x), 0.5 * (b.min.y + b.max.y));
            spread(step(x, whole.min.x, size.x)) | spread(step(y, whole.min.y, size.y)) << 1
        };
        let mut order: Vec<usize> = (0..boxes.len()).collect();
        order.sort_by_cached_key(|n| code(&boxes[*n]));
        order
    }

    /// Returns the number of boxes that were put in.
    pub fn len(&self) -> usize {
        self.levels[1]
    }

    /// True when nothing was put in.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Returns `true` if there are so few boxes that all of them are looked at.
    pub(crate) fn is_small(&self) -> bool {
        self.len() <= FEW
    }

    /// The box with a number.
    pub fn leaf(&self, number: usize) -> &Bounds2 {
        &self.boxes[number]
    }

    /// All boxes that were put in.
    pub fn leaves(&self) -> &[Bounds2] {
        &self.boxes[..self.len()]
    }

    /// The box around everything.
    pub fn bounds(&self) -> Bounds2 {
        self.boxes.last().copied().unwrap_or_default()
    }

    fn top(&self) -> usize {
        self.level_count.saturating_sub(1)
    }

    fn children(&self, level: usize, number: usize) -> std::ops::Range<usize> {
        let count = self.levels[level] - self.levels[level - 1];
        number * FAN..((number + 1) * FAN).min(count)
    }

    fn at(&self, level: usize, number: usize) -> &Bounds2 {
        &self.boxes[self.levels[level] + number]
    }

    /// Calls `visit` with the number of every box that `enter` lets pass, all its parents included;
    /// stops early when `visit` returns false.
    pub fn search(
        &self,
        enter: impl Fn(&Bounds2) -> bool,
        mut visit: impl FnMut(usize) -> bool,
    ) -> bool {
        if self.is_small() {
            return (0..self.len()).all(|n| !enter(&self.boxes[n]) || visit(n));
        }
        self.search_in(self.top(), 0, 0, &enter, &mut visit)
    }

    /// Calls `visit` with ranges of consecutive numbers that together hold every box that `enter` lets
    /// pass, and some of their neighbours: for those who look at all of them faster than at boxes.
    pub fn search_runs(
        &self,
        enter: impl Fn(&Bounds2) -> bool,
        mut visit: impl FnMut(std::ops::Range<usize>),
    ) {
        if self.is_small() {
            visit(0..self.len());
            return;
        }
        let mut run = |number: usize| {
            visit(number * FAN..((number + 1) * FAN).min(self.len()));
            true
        };
        self.search_in(self.top(), 0, 1, &enter, &mut run);
    }

    /// Looks at what lies under a box that was let pass, down to a level.
    fn search_in(
        &self,
        level: usize,
        number: usize,
        lowest: usize,
        enter: &impl Fn(&Bounds2) -> bool,
        visit: &mut impl FnMut(usize) -> bool,
    ) -> bool {
        let (children, boxes) = self.under(level, number);
        for (child, _) in children.zip(boxes).filter(|(_, b)| enter(b)) {
            let goes_on = if level - 1 == lowest {
                visit(child)
            } else {
                self.search_in(level - 1, child, lowest, enter, visit)
            };
            if !goes_on {
                return false;
            }
        }
        true
    }

    /// The numbers and the boxes under a box.
    fn under(&self, level: usize, number: usize) -> (std::ops::Range<usize>, &[Bounds2]) {
        let children = self.children(level, number);
        let from = self.levels[level - 1];
        (children.clone(), &self.boxes[from + children.start..from + children.end])
    }

    /// Calls `visit` with the number of every box that meets another one.
    pub fn meeting(&self, area: &Bounds2, mut visit: impl FnMut(usize)) {
        self.search(
            |b| b.meets(area),
            |n| {
                visit(n);
                true
            },
        );
    }

    /// The smallest value of `measure` over the boxes, and which one has it. `measure` must not be
    /// less than the distance of the box from `place`; values of `limit` or more are not looked for.
    pub fn nearest(
        &self,
        place: Point2,
        limit: f64,
        mut measure: impl FnMut(usize) -> f64,
    ) -> Option<(usize, f64)> {
        let mut best = (usize::MAX, limit);
        if !self.is_empty() {
            self.nearest_in(self.top(), 0, place, &mut best, &mut measure);
        }
        (best.0 != usize::MAX).then_some(best)
    }

    fn nearest_in(
        &self,
        level: usize,
        number: usize,
        place: Point2,
        best: &mut (usize, f64),
        measure: &mut impl FnMut(usize) -> f64,
    ) {
        if level == 0 {
            let value = measure(number);
            if value < best.1 {
                *best = (number, value);
            }
            return;
        }
        // Nearest children first, so that the others need not be opened.
        let mut order = [(f64::INFINITY, 0); FAN];
        let children = self.children(level, number);
        let count = children.len();
        for (slot, child) in order.iter_mut().zip(children) {
            *slot = (self.at(level - 1, child).distance_squared(place), child);
        }
        order[..count].sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
        for &(square, child) in &order[..count] {
            if square < best.1 * best.1 {
                self.nearest_in(level - 1, child, place, best, measure);
            }
        }
    }

    /// Calls `visit` with every pair of boxes, one of each tree, that meet.
    pub fn pairs(&self, other: &Self, mut visit: impl FnMut(usize, usize)) {
        let mut go_on = |a, b| {
            visit(a, b);
            true
        };
        if !self.is_empty() && !other.is_empty() && self.bounds().meets(&other.bounds()) {
            self.pairs_in((self.top(), 0), other, (other.top(), 0), &mut go_on);
        }
    }

    /// The pairs under two boxes that meet.
    fn pairs_in(
        &self,
        mine: (usize, usize),
        other: &Self,
        theirs: (usize, usize),
        visit: &mut impl FnMut(usize, usize) -> bool,
    ) -> bool {
        if mine.0 == 0 && theirs.0 == 0 {
            return visit(mine.1, theirs.1);
        }
        if mine.0 >= theirs.0 {
            let area = other.at(theirs.0, theirs.1);
            let (children, boxes) = self.under(mine.0, mine.1);
            let mut meeting = children.zip(boxes).filter(|(_, b)| b.meets(area));
            meeting.all(|(child, _)| self.pairs_in((mine.0 - 1, child), other, theirs, visit))
        } else {
            let area = self.at(mine.0, mine.1);
            let (children, boxes) = other.under(theirs.0, theirs.1);
            let mut meeting = children.zip(boxes).filter(|(_, b)| b.meets(area));
            meeting.all(|(child, _)| self.pairs_in(mine, other, (theirs.0 - 1, child), visit))
        }
    }

    /// Calls `visit` with every pair of different boxes of this tree that meet, the lower number
    /// first, each pair once.
    pub fn own_pairs(&self, mut visit: impl FnMut(usize, usize)) {
        self.own_pairs_while(|a, b| {
            visit(a, b);
            true
        });
    }

    /// As [`BoxTree::own_pairs`], until `visit` returns false; whether it never did.
    pub fn own_pairs_while(&self, mut visit: impl FnMut(usize, usize) -> bool) -> bool {
        if self.is_small() {
            let mut meets =
                |a: usize, b: usize| !self.boxes[a].meets(&self.boxes[b]) || visit(a, b);
            return (0..self.len()).all(|a| (a + 1..self.len()).all(|b| meets(a, b)));
        }
        self.own_pairs_in(self.top(), 0, &mut visit)
    }

    fn own_pairs_in(
        &self,
        level: usize,
        number: usize,
        visit: &mut impl FnMut(usize, usize) -> bool,
    ) -> bool {
        if level == 0 {
            return true;
        }
        let (children, boxes) = self.under(level, number);
        for (n, first) in children.clone().enumerate() {
            if !self.own_pairs_in(level - 1, first, visit) {
                return false;
            }
            for (m, second) in children.clone().enumerate().skip(n + 1) {
                if boxes[n].meets(&boxes[m])
                    && !self.pairs_in((level - 1, first), self, (level - 1, second), visit)
                {
                    return false;
                }
            }
        }
        true
    }
}

/// The bits of a number of 16 bits with a gap before each.
const fn spread(value: u32) -> u32 {
    let value = (value | value << 8) & 0x00FF_00FF;
    let value = (value | value << 4) & 0x0F0F_0F0F;
    let value = (value | value << 2) & 0x3333_3333;
    (value | value << 1) & 0x5555_5555
}

#[cfg(test)]
mod tests {
    use super::*;

    fn boxes(n: usize) -> Vec<Bounds2> {
        let at = |k: usize| Point2::new((k * 7 % 31) as f64, (k * 11 % 17) as f64);
        (0..n).map(|k| Bounds2::of(at(k), at(k + 1))).collect()
    }

    #[test]
    fn finds_what_looking_at_every_box_finds() {
        for n in [0, 1, 2, 5, 64, 301] {
            let all = boxes(n);
            let tree = BoxTree::new(all.clone());
            let area = Bounds2::of(Point2::new(3.0, 3.0), Point2::new(9.0, 5.0));
            let mut found = Vec::new();
            tree.meeting(&area, |k| found.push(k));
            let plain: Vec<usize> = (0..n).filter(|&k| all[k].meets(&area)).collect();
            assert_eq!(found, plain);
            let mut pairs = Vec::new();
            tree.own_pairs(|a, b| pairs.push((a, b)));
            pairs.sort_unstable();
            let plain: Vec<_> = (0..n)
                .flat_map(|a| (a + 1..n).map(move |b| (a, b)))
                .filter(|&(a, b)| all[a].meets(&all[b]))
                .collect();
            assert_eq!(pairs, plain);
            let place = Point2::new(40.0, 40.0);
            let measure = |k: usize| all[k].distance_squared(place).sqrt();
            let least = (0..n).map(measure).min_by(f64::total_cmp);
            assert_eq!(tree.nearest(place, f64::INFINITY, measure).map(|b| b.1), least);
        }
    }

    #[test]
    fn neighbours_in_order_are_neighbours_in_the_plane() {
        let at = |k: usize| Point2::new((k * 37 % 64) as f64, (k * 37 / 64 % 64) as f64);
        let boxes: Vec<Bounds2> = (0..4096).map(|k| Bounds2::of(at(k), at(k))).collect();
        let order = BoxTree::order(&boxes);
        let mut all = order.clone();
        all.sort_unstable();
        assert_eq!(all, (0..4096).collect::<Vec<_>>());
        let step = |pair: &[usize]| at(pair[0]).distance(at(pair[1]));
        let mean = order.windows(2).map(step).sum::<f64>() / 4095.0;
        assert!(mean < 3.0, "{mean}");
        assert_eq!(BoxTree::order(&[]), Vec::<usize>::new());
    }
}
