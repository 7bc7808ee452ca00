//! The middle of a shape and how far its edge is: what a V bit follows so that it touches both edges.
//!
//! ```text
//!   edge ──p────────            The circle that touches the edge at p and fits in: its middle is on the
//!         (  c )  r             path, its radius r is how wide the bit has to cut there.
//!   edge ───q───────            Walking p along every edge draws the whole path; what is drawn from both
//!                               sides counts once.
//! ```
//!
//! The largest circle that touches at p with the normal n has for every other point q the radius
//! |q − p|² / 2(q − p)·n at most (the "shrinking ball", Ma, Bae, Choi 2012).

/// A vertex at which the outline turns by less is one of a curve, radians.
const SMOOTH_RAD: f64 = 0.4;

/// Of its own curve a place sees only what has turned by more, radians: chords are not the curve.
const OWN_CURVE_RAD: f64 = 0.5;

/// Steps of the normal round a corner that stands into the shape, radians.
const FAN_RAD: f64 = 0.15;

/// A place of the path: where, and how far the edge is.
pub type Spot = [f64; 3];

/// An edge; the shape lies on its left.
#[derive(Clone, Copy, Debug)]
struct Edge {
    from: [f64; 2],
    to: [f64; 2],
    /// Length of the outline before it.
    before: f64,
    contour: usize,
}

/// The paths of a shape, sampled so far apart. `None` when outlines cross.
pub fn middle(contours: &[Vec<[f64; 2]>], step: f64) -> Option<Vec<Vec<Spot>>> {
    let edges = edges(contours);
    if crosses(&edges) {
        return None;
    }
    let mut paths = Vec::new();
    for contour in 0..contours.len() {
        let own: Vec<usize> = (0..edges.len()).filter(|i| edges[*i].contour == contour).collect();
        if own.len() >= 3 {
            Walk { edges: &edges, own, step, run: Vec::new(), paths: &mut paths }.go();
        }
    }
    Some(paths)
}

fn minus(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

fn mix(a: [f64; 2], b: [f64; 2], share: f64) -> [f64; 2] {
    [a[0] + (b[0] - a[0]) * share, a[1] + (b[1] - a[1]) * share]
}

impl Edge {
    fn way(&self) -> [f64; 2] {
        minus(self.to, self.from)
    }

    fn length(&self) -> f64 {
        self.way()[0].hypot(self.way()[1])
    }

    /// To its left, of length 1.
    fn normal(&self) -> [f64; 2] {
        let ([x, y], length) = (self.way(), self.length());
        [-y / length, x / length]
    }

    /// The radius of the circle that touches at `p` with the normal `n` and reaches this edge, and where
    /// it does, as a length of outline.
    fn bound(&self, p: [f64; 2], n: [f64; 2]) -> Option<(f64, f64)> {
        let length = self.length();
        let end = |q: [f64; 2], along: f64| {
            let off = minus(q, p);
            let ahead = dot(off, n);
            (ahead > 1e-9).then(|| (dot(off, off) / (2.0 * ahead), self.before + along))
        };
        let inside = || {
            let m = self.normal();
            let away = dot(minus(p, self.from), m);
            let m = if away < 0.0 { [-m[0], -m[1]] } else { m };
            let slope = 1.0 - dot(n, m);
            let r = away.abs() / slope;
            let centre = [p[0] + n[0] * r, p[1] + n[1] * r];
            let along = dot(minus(centre, self.from), self.way()) / length;
            (slope > 1e-9 && (0.0..=length).contains(&along)).then_some((r, self.before + along))
        };
        let all = [end(self.from, 0.0), end(self.to, length), inside()];
        all.into_iter().flatten().min_by(|a, b| a.0.total_cmp(&b.0))
    }
}

/// Edges with the shape on their left, whatever way the outlines run.
fn edges(contours: &[Vec<[f64; 2]>]) -> Vec<Edge> {
    let (mut edges, mut before) = (Vec::new(), 0.0);
    for (contour, points) in contours.iter().enumerate() {
        let mut points = points.clone();
        points.dedup_by(|a, b| (a[0] - b[0]).hypot(a[1] - b[1]) < 1e-9);
        if points.len() > 1 && minus(points[0], points[points.len() - 1]) == [0.0, 0.0] {
            points.pop();
        }
        if points.len() < 3 {
            continue;
        }
        if !inside_is_left(&points, contours) {
            points.reverse();
        }
        for n in 0..points.len() {
            let (from, to) = (points[n], points[(n + 1) % points.len()]);
            let edge = Edge { from, to, before, contour };
            before += edge.length();
            edges.push(edge);
        }
    }
    edges
}

fn inside_is_left(points: &[[f64; 2]], contours: &[Vec<[f64; 2]>]) -> bool {
    let edge = |n: usize| Edge {
        from: points[n],
        to: points[(n + 1) % points.len()],
        before: 0.0,
        contour: 0,
    };
    let longest = (0..points.len()).map(edge).max_by(|a, b| a.length().total_cmp(&b.length()));
    let Some(edge) = longest else { return true };
    let (middle, n) = (mix(edge.from, edge.to, 0.5), edge.normal());
    let off = edge.length() * 1e-4;
    holds(contours, [middle[0] + n[0] * off, middle[1] + n[1] * off])
}

/// Returns `true` if a place lies in the shape: within an odd number of outlines.
fn holds(contours: &[Vec<[f64; 2]>], at: [f64; 2]) -> bool {
    let mut inside = false;
    for points in contours {
        for n in 0..points.len() {
            let (a, b) = (points[n], points[(n + 1) % points.len()]);
            if (a[1] > at[1]) != (b[1] > at[1]) {
                let x = a[0] + (at[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
                inside ^= x > at[0];
            }
        }
    }
    inside
}

/// Returns `true` if any two edges cross.
fn crosses(edges: &[Edge]) -> bool {
    let side = |edge: &Edge, p: [f64; 2]| cross(edge.way(), minus(p, edge.from));
    edges.iter().enumerate().any(|(n, a)| {
        edges[n + 1..].iter().any(|b| {
            side(a, b.from) * side(a, b.to) < -1e-18 && side(b, a.from) * side(b, a.to) < -1e-18
        })
    })
}

/// The walk along one outline.
struct Walk<'a> {
    edges: &'a [Edge],
    own: Vec<usize>,
    step: f64,
    run: Vec<Spot>,
    paths: &'a mut Vec<Vec<Spot>>,
}

impl Walk<'_> {
    fn go(mut self) {
        for k in 0..self.own.len() {
            self.corner(k);
            let edge = self.edge(k);
            let count = (edge.length() / self.step).ceil().max(1.0) as u32;
            let [n0, n1] = [self.normal_at(k, false), self.normal_at(k, true)];
            for i in 0..count {
                // Never at the vertices themselves: they are corners.
                let share = (f64::from(i) + 0.5) / f64::from(count);
                let n = mix(n0, n1, share);
                let length = n[0].hypot(n[1]);
                let at = edge.before + edge.length() * share;
                self.spot(k, mix(edge.from, edge.to, share), n.map(|v| v / length), at);
            }
        }
        self.corner(0);
        self.ends();
    }

    fn edge(&self, k: usize) -> Edge {
        self.edges[self.own[k % self.own.len()]]
    }

    fn before(&self, k: usize) -> usize {
        (k + self.own.len() - 1) % self.own.len()
    }

    /// Returns the turn of the outline before an edge, radians; to the left where the corner stands out.
    fn turn(&self, k: usize) -> f64 {
        let (a, b) = (self.edge(self.before(k)).way(), self.edge(k).way());
        cross(a, b).atan2(dot(a, b))
    }

    /// The normal at an end of an edge: that of the curve where it is one.
    fn normal_at(&self, k: usize, end: bool) -> [f64; 2] {
        let (first, second) = if end { (k, k + 1) } else { (self.before(k), k) };
        let own = self.edge(k).normal();
        if self.turn(second % self.own.len()).abs() > SMOOTH_RAD {
            return own;
        }
        let sum = mix(self.edge(first).normal(), self.edge(second).normal(), 0.5);
        let length = sum[0].hypot(sum[1]);
        if length > 0.0 { sum.map(|v| v / length) } else { own }
    }

    /// The corner before an edge: the path ends in one that stands out, and goes round one that stands in.
    fn corner(&mut self, k: usize) {
        let turn = self.turn(k);
        let edge = self.edge(k);
        if turn > SMOOTH_RAD {
            self.run.push([edge.from[0], edge.from[1], 0.0]);
            self.ends();
            self.run.push([edge.from[0], edge.from[1], 0.0]);
        } else if turn < -SMOOTH_RAD {
            let n = self.edge(self.before(k)).normal();
            let count = (-turn / FAN_RAD).ceil().max(1.0);
            for i in 0..=count as u32 {
                let (sin, cos) = (turn * f64::from(i) / count).sin_cos();
                let n = [n[0] * cos - n[1] * sin, n[0] * sin + n[1] * cos];
                self.spot(k, edge.from, n, edge.before);
            }
        }
    }

    /// The largest circle that touches there, unless it is drawn from its other side.
    fn spot(&mut self, k: usize, p: [f64; 2], n: [f64; 2], at: f64) {
        let hidden = self.own_curve(k);
        let bounds = self.edges.iter().enumerate().filter(|(i, _)| !hidden.contains(i));
        let least =
            bounds.filter_map(|(_, edge)| edge.bound(p, n)).min_by(|a, b| a.0.total_cmp(&b.0));
        match least {
            Some((r, other)) if other > at => {
                let spot = [p[0] + n[0] * r, p[1] + n[1] * r, r];
                let jumps =
                    |last: &Spot| (last[0] - spot[0]).hypot(last[1] - spot[1]) > 8.0 * self.step;
                if self.run.last().is_some_and(jumps) {
                    self.ends();
                }
                self.run.push(spot);
            }
            _ => self.ends(),
        }
    }

    /// The edges of its own curve that a place on an edge does not see.
    fn own_curve(&self, k: usize) -> Vec<usize> {
        let mut hidden = vec![self.own[k]];
        let (mut turned, mut j) = (0.0, k);
        while hidden.len() < self.own.len() {
            let turn = self.turn((j + 1) % self.own.len());
            turned += turn.abs();
            if turn.abs() > SMOOTH_RAD || turned > OWN_CURVE_RAD {
                break;
            }
            j = (j + 1) % self.own.len();
            hidden.push(self.own[j]);
        }
        (turned, j) = (0.0, k);
        while hidden.len() < self.own.len() {
            let turn = self.turn(j);
            turned += turn.abs();
            // Round a corner that stands in, the edge before it is touched as well.
            if turn.abs() > SMOOTH_RAD || turned > OWN_CURVE_RAD {
                if turn < -SMOOTH_RAD {
                    hidden.push(self.own[self.before(j)]);
                }
                break;
            }
            j = self.before(j);
            hidden.push(self.own[j]);
        }
        hidden
    }

    fn ends(&mut self) {
        let run = std::mem::take(&mut self.run);
        if run.len() > 1 {
            self.paths.push(run);
        }
    }
}

/// A path in fewer places, none of which was further from it than so much.
pub fn thinned(path: &[Spot], off: f64) -> Vec<Spot> {
    let (Some(first), Some(last)) = (path.first(), path.last()) else { return Vec::new() };
    let far = |p: &Spot| {
        let way = [0, 1, 2].map(|i| last[i] - first[i]);
        let gone = [0, 1, 2].map(|i| p[i] - first[i]);
        let long: f64 = way.iter().map(|v| v * v).sum();
        let share = way.iter().zip(gone).map(|(a, b)| a * b).sum::<f64>() / long.max(1e-18);
        let share = share.clamp(0.0, 1.0);
        (0..3).map(|i| (gone[i] - way[i] * share).powi(2)).sum::<f64>().sqrt()
    };
    let worst = (1..path.len().max(1) - 1).max_by(|a, b| far(&path[*a]).total_cmp(&far(&path[*b])));
    match worst.filter(|worst| far(&path[*worst]) > off) {
        Some(worst) => {
            let mut thin = thinned(&path[..=worst], off);
            thin.pop();
            thin.extend(thinned(&path[worst..], off));
            thin
        }
        None => vec![*first, *last],
    }
}

/// Paths one after the other, each the nearest to where the one before ended, whichever way round.
pub fn ordered(mut paths: Vec<Vec<Spot>>) -> Vec<Vec<Spot>> {
    let mut at = [0.0; 3];
    let mut order = Vec::with_capacity(paths.len());
    let gap =
        |at: Spot, to: Option<&Spot>| to.map_or(0.0, |to| (to[0] - at[0]).hypot(to[1] - at[1]));
    let near = |at: Spot, path: &[Spot]| gap(at, path.first()).min(gap(at, path.last()));
    while let Some(next) =
        (0..paths.len()).min_by(|a, b| near(at, &paths[*a]).total_cmp(&near(at, &paths[*b])))
    {
        let mut path = paths.swap_remove(next);
        if gap(at, path.last()) < gap(at, path.first()) {
            path.reverse();
        }
        at = path.last().copied().unwrap_or(at);
        order.push(path);
    }
    order
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(contours: &[Vec<[f64; 2]>], off: f64) -> Vec<Vec<Spot>> {
        let paths = middle(contours, 0.02).expect("no outlines cross");
        let distance = |p: &Spot| {
            let to = |e: &Edge| {
                let share = dot(minus([p[0], p[1]], e.from), e.way()) / dot(e.way(), e.way());
                let q = mix(e.from, e.to, share.clamp(0.0, 1.0));
                (q[0] - p[0]).hypot(q[1] - p[1])
            };
            edges(contours).iter().map(to).fold(f64::INFINITY, f64::min)
        };
        for p in paths.iter().flatten() {
            assert!((distance(p) - p[2]).abs() < off, "{p:?} is {} from the edge", distance(p));
        }
        paths
    }

    #[test]
    fn a_bar_is_carved_along_its_middle_and_into_its_corners() {
        let paths = check(&[vec![[0.0, 0.0], [4.0, 0.0], [4.0, 1.0], [0.0, 1.0]]], 1e-6);
        let spots: Vec<Spot> = paths.concat();
        assert!(spots.iter().any(|p| (p[0] - 2.0).abs() < 0.02 && (p[2] - 0.5).abs() < 1e-9));
        for corner in [[0.0, 0.0], [4.0, 0.0], [4.0, 1.0], [0.0, 1.0]] {
            assert!(spots.iter().any(|p| p[0] == corner[0] && p[1] == corner[1] && p[2] == 0.0));
        }
        let length: f64 = paths
            .iter()
            .flat_map(|path| path.windows(2))
            .map(|w| (w[1][0] - w[0][0]).hypot(w[1][1] - w[0][1]))
            .sum();
        // The middle and four ways into corners, each once.
        let once = 3.0 + 4.0 * std::f64::consts::FRAC_1_SQRT_2;
        assert!((length - once).abs() < 0.2, "{length}, not {once}");
    }

    #[test]
    fn a_ring_is_carved_round_its_middle() {
        let circle = |r: f64| -> Vec<[f64; 2]> {
            (0..96)
                .map(|n| (f64::from(n) / 96.0 * std::f64::consts::TAU).sin_cos())
                .map(|(s, c)| [r * c, r * s])
                .collect()
        };
        let paths = check(&[circle(2.0), circle(1.0)], 5e-3);
        let spots: Vec<Spot> = paths.concat();
        assert!(spots.len() > 100);
        assert!(spots.iter().all(|p| (p[0].hypot(p[1]) - 1.5).abs() < 0.01), "{spots:?}");
    }

    #[test]
    fn an_angle_is_carved_round_its_inner_corner() {
        let corner = vec![[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [1.0, 1.0], [1.0, 3.0], [0.0, 3.0]];
        let paths = check(&[corner], 1e-6);
        let widest = paths.iter().flatten().map(|p| p[2]).fold(0.0, f64::max);
        // Where the circle touches both outer edges and the inner corner.
        let expected = 2.0 - std::f64::consts::SQRT_2;
        assert!((widest - expected).abs() < 0.01, "{widest}, not {expected}");
    }

    #[test]
    fn outlines_that_cross_are_refused() {
        let bow = vec![[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]];
        assert!(middle(&[bow], 0.1).is_none());
    }
}
