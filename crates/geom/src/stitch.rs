//! Ends of pieces joined into loops.
//!
//! Offsets and booleans both cut curves where they meet, throw pieces away, and put the rest together
//! again. Where several pieces end in one place the way goes on with the sharpest turn to one side, so
//! that loops which touch there come out as separate loops that do not cross.
//!
//! ```text
//!        out 2  ╲ │ ╱ out 1          turning right: out 1
//!                ╲│╱
//!                 ●   ← in
//! ```

use crate::{Point2, Vec2, tol};

/// Facts about a piece of path that stitching needs.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Strand {
    pub start: Point2,
    pub end: Point2,
    /// Halfway along, to tell whether two strands between the same ends are one.
    pub middle: Point2,
    /// Unit direction at the start, looked at a little way along where pieces are tangent.
    pub leaves: Vec2,
    /// Unit direction at the end.
    pub arrives: Vec2,
    /// False for a piece that is kept only because nothing speaks clearly against it.
    pub sure: bool,
}

/// The side to which the way turns where it has a choice.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Turn {
    Left,
    Right,
}

/// Pieces in order, as numbers into the list that was given.
#[derive(Debug, Default)]
pub(crate) struct Stitched {
    pub loops: Vec<Vec<usize>>,
    /// Ways that begin or end where nothing follows.
    pub open: Vec<Vec<usize>>,
}

/// Joins strands end to start. Strands without a continuation are left out unless `keep_open`.
pub(crate) fn stitch(strands: &[Strand], turn: Turn, keep_open: bool) -> Stitched {
    let nodes = Nodes::new(strands);
    let mut walk = Walk { strands, nodes: &nodes, turn, used: vec![false; strands.len()] };
    walk.drop_coincident();
    if !keep_open {
        walk.drop_dead_ends();
    }
    walk.all()
}

/// The places where strands begin and end, those nearer than [`tol::SAME_PLACE_MM`] counted as one.
struct Nodes {
    /// Node at the start and at the end of each strand.
    ends: Vec<[usize; 2]>,
    /// Strands that leave each node, in their order: `leaving[first[n]..first[n + 1]]`.
    leaving: Vec<usize>,
    first: Vec<usize>,
}

impl Nodes {
    fn new(strands: &[Strand]) -> Self {
        let places: Vec<Point2> = strands.iter().flat_map(|s| [s.start, s.end]).collect();
        let (names, count) = named(&places);
        let ends: Vec<[usize; 2]> = names.chunks(2).map(|pair| [pair[0], pair[1]]).collect();
        let mut first = vec![0; count + 1];
        ends.iter().for_each(|e| first[e[0] + 1] += 1);
        (0..count).for_each(|n| first[n + 1] += first[n]);
        let mut next = first.clone();
        let mut leaving = vec![0; ends.len()];
        for (strand, e) in ends.iter().enumerate() {
            leaving[next[e[0]]] = strand;
            next[e[0]] += 1;
        }
        Self { ends, leaving, first }
    }

    fn leaving(&self, node: usize) -> &[usize] {
        &self.leaving[self.first[node]..self.first[node + 1]]
    }
}

/// Numbers places so that near ones, and those near to near ones, get the same number.
pub(crate) fn named(places: &[Point2]) -> (Vec<usize>, usize) {
    let cell = |v: f64| (v / (2.0 * tol::SAME_PLACE_MM)).floor() as i64;
    let mut cells: Vec<(i64, i64, usize)> =
        places.iter().enumerate().map(|(k, p)| (cell(p.x), cell(p.y), k)).collect();
    cells.sort_unstable();
    let mut leader: Vec<usize> = (0..places.len()).collect();
    for &(x, y, k) in &cells {
        // The other half of the neighbours looks here.
        for (dx, dy) in [(0, 0), (0, 1), (1, -1), (1, 0), (1, 1)] {
            let wanted = (x + dx, y + dy, 0);
            let from = cells.partition_point(|c| *c < wanted);
            for &(cx, cy, other) in &cells[from..] {
                if (cx, cy) != (x + dx, y + dy) {
                    break;
                }
                if places[k].distance(places[other]) <= tol::SAME_PLACE_MM {
                    unite(&mut leader, k, other);
                    if (dx, dy) == (0, 0) {
                        break;
                    }
                }
            }
        }
    }
    numbered(&mut leader)
}

fn find(leader: &mut [usize], mut k: usize) -> usize {
    while leader[k] != k {
        leader[k] = leader[leader[k]];
        k = leader[k];
    }
    k
}

fn unite(leader: &mut [usize], a: usize, b: usize) {
    let (a, b) = (find(leader, a), find(leader, b));
    leader[a.max(b)] = a.min(b);
}

fn numbered(leader: &mut [usize]) -> (Vec<usize>, usize) {
    let mut count = 0;
    let mut names = vec![usize::MAX; leader.len()];
    for k in 0..leader.len() {
        let first = find(leader, k);
        if names[first] == usize::MAX {
            names[first] = count;
            count += 1;
        }
        names[k] = names[first];
    }
    (names, count)
}

struct Walk<'a> {
    strands: &'a [Strand],
    nodes: &'a Nodes,
    turn: Turn,
    used: Vec<bool>,
}

impl Walk<'_> {
    /// Of strands that run along each other the same way one remains, of opposite ones none: they
    /// bound nothing between them.
    fn drop_coincident(&mut self) {
        let mut groups: Vec<(usize, usize, usize)> = Vec::with_capacity(self.strands.len());
        for (k, &[a, b]) in self.nodes.ends.iter().enumerate() {
            groups.push((a.min(b), a.max(b), k));
        }
        groups.sort_unstable();
        for group in groups.chunk_by(|x, y| (x.0, x.1) == (y.0, y.1)) {
            for (n, &(_, _, first)) in group.iter().enumerate() {
                for &(_, _, second) in &group[n + 1..] {
                    self.compare(first, second);
                }
            }
        }
    }

    fn compare(&mut self, first: usize, second: usize) {
        let (a, b) = (&self.strands[first], &self.strands[second]);
        let apart = a.middle.distance(b.middle);
        if self.used[first] || self.used[second] || apart > 2.0 * tol::SAME_PLACE_MM {
            return;
        }
        let same_way =
            self.nodes.ends[first] == self.nodes.ends[second] && a.leaves.dot(b.leaves) > 0.0;
        self.used[second] = true;
        self.used[first] = !same_way;
    }

    /// Marks strands as used that nothing precedes or nothing follows, until there are none.
    fn drop_dead_ends(&mut self) {
        let count = self.nodes.first.len() - 1;
        let (mut into, mut out) = (vec![0usize; count], vec![0usize; count]);
        let mut arriving = vec![Vec::new(); count];
        for (k, [start, end]) in self.nodes.ends.iter().copied().enumerate() {
            if self.used[k] {
                continue;
            }
            out[start] += 1;
            into[end] += 1;
            arriving[end].push(k);
        }
        let mut suspects: Vec<usize> = (0..self.strands.len()).rev().collect();
        while let Some(k) = suspects.pop() {
            let [start, end] = self.nodes.ends[k];
            if self.used[k] || (into[start] > 0 && out[end] > 0) {
                continue;
            }
            self.used[k] = true;
            out[start] -= 1;
            into[end] -= 1;
            suspects.extend(self.nodes.leaving(end).iter().chain(&arriving[start]).copied());
        }
    }

    fn all(mut self) -> Stitched {
        let mut result = Stitched::default();
        // Ways that must begin somewhere first, then loops, from sure strands before doubtful ones.
        let mut preceded = vec![false; self.nodes.first.len()];
        let unused = self.nodes.ends.iter().zip(&self.used).filter(|(_, used)| !**used);
        unused.for_each(|(e, _)| preceded[e[1]] = true);
        for k in 0..self.strands.len() {
            if !self.used[k] && !preceded[self.nodes.ends[k][0]] {
                let (way, _) = self.follow(k);
                result.open.push(way);
            }
        }
        for sure in [true, false] {
            for k in 0..self.strands.len() {
                if !self.used[k] && self.strands[k].sure == sure {
                    match self.follow(k) {
                        (way, true) => result.loops.push(way),
                        (way, false) => result.open.push(way),
                    }
                }
            }
        }
        result
    }

    /// The way from a strand, and whether it came back to where it began. Strands that lead nowhere
    /// are given up one by one; only if the first of them is, there is no loop.
    fn follow(&mut self, first: usize) -> (Vec<usize>, bool) {
        let home = self.nodes.ends[first][0];
        let mut way = vec![first];
        let mut longest = Vec::new();
        self.used[first] = true;
        while let Some(&at) = way.last() {
            let node = self.nodes.ends[at][1];
            match self.best(at, node, (node == home).then_some(first)) {
                Some(next) if next == first => return (way, true),
                Some(next) => {
                    self.used[next] = true;
                    way.push(next);
                }
                None => {
                    if longest.is_empty() {
                        longest.clone_from(&way);
                    }
                    way.pop();
                }
            }
        }
        (longest, false)
    }

    /// The unused strand that goes on from a node with the sharpest turn; sure ones before doubtful.
    fn best(&self, from: usize, node: usize, first: Option<usize>) -> Option<usize> {
        let open = |k: &usize| !self.used[*k] || Some(*k) == first;
        let key = |k: usize| (!self.strands[k].sure, self.sharpness(from, k));
        self.nodes.leaving(node).iter().copied().filter(open).min_by(|&a, &b| {
            let (a, b) = (key(a), key(b));
            a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))
        })
    }

    /// Angle from straight on, smallest for the sharpest turn to the wanted side. A turn back on the
    /// spot counts as one to the wanted side even when rounding puts it a little beyond.
    fn sharpness(&self, from: usize, to: usize) -> f64 {
        let (u, v) = (self.strands[from].arrives, self.strands[to].leaves);
        let left = u.cross(v).atan2(u.dot(v));
        let turned = if self.turn == Turn::Right { left } else { -left };
        if turned > 3.0 { turned - std::f64::consts::TAU } else { turned }
    }
}
