//! Decides if two curves are the same: the distance that somebody on the one and somebody on the other keep at least
//! when both walk to the end and nobody goes back (Alt and Godau 1995, the decision on the free space of two
//! polygonal curves).
//!
//! ```text
//!   places of b   ┌────┬────┬───╱┐   a cell: a line of a against a line of b;
//!        ▲        │    │  ╱─┼─╱  │   free: places closer than the distance;
//!        │        │  ╱─┼─╱  │    │   reached: free, and there is a way that
//!        │        └╱───┴────┴────┘   only goes right and up
//!        └─────────────────► places of a
//! ```

/// A place, mm.
pub type Point = [f64; 3];

/// From and to on a line, as shares of it.
type Range = (f64, f64);

/// Longest stretches of two curves that are the same.
#[derive(Debug, Default)]
pub struct Common {
    /// To the ends of both.
    pub whole: bool,
    /// To the end of the shorter one.
    pub as_far_as_both_go: bool,
    /// The last places of both that were reached.
    pub furthest: (usize, usize),
    /// The places of the second at which the first may end: each is the end of the line of that end.
    pub first_ends: Vec<usize>,
}

/// Holds a curve against another: nowhere further apart than so many mm.
pub fn compare(a: &[Point], b: &[Point], apart: f64) -> Common {
    let mut common = Common::default();
    let (Some(first), Some(other)) = (a.first(), b.first()) else {
        let (whole, as_far_as_both_go) = (a.is_empty() && b.is_empty(), true);
        return Common { whole, as_far_as_both_go, ..common };
    };
    if distance(*first, *other) > apart {
        return common;
    }
    let mut column = first_column(*first, b, apart);
    let mut bottom_free = true;
    for i in 1..a.len() {
        common.note(i - 1, &column, b.len());
        let bottom = free([a[i - 1], a[i]], *other, apart).filter(|r| bottom_free && r.0 <= 0.0);
        bottom_free = bottom.is_some_and(|range| range.1 >= 1.0);
        column = next_column([a[i - 1], a[i]], b, &column, bottom, apart, &mut common);
    }
    let last = a.len() - 1;
    common.note(last, &column, b.len());
    common.first_ends = column.iter().map(|(j, _)| j + 1).collect();
    let end = column.iter().any(|(j, range)| j + 2 == b.len() && range.1 >= 1.0);
    common.whole = end || (b.len() == 1 && bottom_free);
    common.as_far_as_both_go |= common.whole || !column.is_empty() || bottom_free;
    common
}

impl Common {
    /// Takes note of a column of the free space: a place of the first against all of the second.
    fn note(&mut self, i: usize, column: &[(usize, Range)], others: usize) {
        for (j, range) in column {
            self.furthest = self.furthest.max((i, j + 1));
            self.as_far_as_both_go |= j + 2 == others && range.1 >= 1.0;
        }
    }
}

/// The lines of `b` that can be walked while the other stands at its first place.
fn first_column(at: Point, b: &[Point], apart: f64) -> Vec<(usize, Range)> {
    let mut column = Vec::new();
    for j in 0..b.len().saturating_sub(1) {
        let Some(range) = free([b[j], b[j + 1]], at, apart).filter(|r| r.0 <= 0.0) else { break };
        column.push((j, range));
        if range.1 < 1.0 {
            break;
        }
    }
    column
}

/// Parts of the lines of `b` that are reached at the end of a line of `a`, given those at its beginning.
fn next_column(
    line: [Point; 2],
    b: &[Point],
    column: &[(usize, Range)],
    bottom: Option<Range>,
    apart: f64,
    common: &mut Common,
) -> Vec<(usize, Range)> {
    let mut reached = Vec::new();
    let mut bottom = bottom;
    let mut left = column.iter().peekable();
    let mut j = if bottom.is_some() { 0 } else { column.first().map_or(b.len(), |(j, _)| *j) };
    while j + 1 < b.len() {
        let from = left.next_if(|(of, _)| *of == j).map(|(_, range)| *range);
        if from.is_none() && bottom.is_none() {
            let Some((next, _)) = left.peek() else { break };
            j = *next;
            continue;
        }
        // The far side of the cell: all that is free when it is entered from below, else what is not lower.
        let right = free([b[j], b[j + 1]], line[1], apart);
        let lowest = if bottom.is_some() { 0.0 } else { from.map_or(0.0, |range| range.0) };
        let right = right.map(|(low, high)| (low.max(lowest), high)).filter(|(l, h)| l <= h);
        reached.extend(right.map(|range| (j, range)));
        let top = free(line, b[j + 1], apart);
        let leftmost = if from.is_some() { 0.0 } else { bottom.map_or(0.0, |range| range.0) };
        bottom = top.map(|(low, high)| (low.max(leftmost), high)).filter(|(l, h)| l <= h);
        common.as_far_as_both_go |= bottom.is_some() && j + 2 == b.len();
        j += 1;
    }
    reached
}

/// Part of a line that is no further from a place than that.
fn free([from, to]: [Point; 2], at: Point, apart: f64) -> Option<Range> {
    let way = minus(to, from);
    let off = minus(from, at);
    let (a, b, c) = (dot(way, way), dot(off, way), dot(off, off) - apart * apart);
    if a == 0.0 {
        return (c <= 0.0).then_some((0.0, 1.0));
    }
    let root = (b * b - a * c).max(-1.0);
    if root < 0.0 {
        return None;
    }
    let (low, high) = ((-b - root.sqrt()) / a, (-b + root.sqrt()) / a);
    (high >= 0.0 && low <= 1.0).then_some((low.max(0.0), high.min(1.0)))
}

fn minus(a: Point, b: Point) -> Point {
    [0, 1, 2].map(|i| a[i] - b[i])
}

fn dot(a: Point, b: Point) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Distance between two places, mm.
pub fn distance(a: Point, b: Point) -> f64 {
    dot(minus(a, b), minus(a, b)).sqrt()
}

#[test]
fn curves_are_held_against_each_other() {
    let flat = |xy: &[(f64, f64)]| xy.iter().map(|(x, y)| [*x, *y, 0.0]).collect::<Vec<_>>();
    let there = flat(&[(0.0, 0.0), (10.0, 0.0), (10.0, 10.0)]);
    let in_parts = flat(&[(0.0, 0.01), (4.0, 0.0), (9.99, 0.0), (10.0, 3.0), (10.0, 10.0)]);
    let again = flat(&[(0.0, 0.0), (6.0, 0.0), (5.0, 0.0), (10.0, 0.0), (10.0, 10.0)]);
    let short = flat(&[(0.0, 0.0), (10.0, 0.0), (10.0, 6.0)]);
    let cut = flat(&[(0.0, 0.0), (9.9, 0.0), (10.0, 0.1), (10.0, 10.0)]);
    let whole = |a: &[Point], b: &[Point]| compare(a, b, 0.03).whole;
    assert!(whole(&there, &there) && whole(&there, &in_parts) && whole(&in_parts, &there));
    for other in [&again, &short, &cut] {
        assert!(!whole(&there, other) && !whole(other, &there), "{other:?}");
    }
    let prefix = |a: &[Point], b: &[Point]| compare(a, b, 0.03).as_far_as_both_go;
    assert!(prefix(&there, &short) && prefix(&short, &there));
    assert!(!prefix(&there, &again) && !prefix(&cut, &there));
    // There and back is not standing.
    let back = flat(&[(0.0, 0.0), (10.0, 0.0), (0.0, 0.0), (10.0, 0.0), (10.0, 10.0)]);
    assert!(!whole(&there, &back) && whole(&back, &back));
    assert_eq!(compare(&short, &there, 0.03).first_ends, [2]);
}
