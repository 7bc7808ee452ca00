//! A smoothed path with its times: where every axis is at time t.

use super::kernel::Kernel;
use super::speeds::Node;
use super::track::Track;
use super::ways::Way;
use crate::moves::Move;
use crate::plan::State;
use kerf_program::{AXES, Axes, Dynamics};

/// Halvings in search of a time.
const HALVINGS: u32 = 50;

/// Motion after a node where jerk is limited.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Push {
    /// s̈ at the node.
    pub accel: f64,
    /// Constant over time up to the next node; `None` where s̈ is linear in s instead.
    pub jerk: Option<f64>,
}

/// The law of motion of the `optimal` model.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Timed {
    pub track: Track,
    /// Place on the track where the first move begins; the first node may lie behind.
    pub from_mm: f64,
    pub widths: Vec<f64>,
    pub kernel: Kernel,
    pub nodes: Vec<Node>,
    /// One for each node where jerk is limited; else none, and s̈ is constant between nodes.
    pub pushes: Vec<Push>,
    pub dynamics: Dynamics,
}

/// A place on the path with the motion along it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Along {
    pub at_mm: f64,
    pub v: f64,
    pub accel: f64,
}

impl Timed {
    pub fn duration_s(&self) -> f64 {
        self.nodes.last().map_or(0.0, |n| n.t_s)
    }

    /// The motion along the path at a time. Before the first node and after the last, where a piece
    /// ends in motion, it is that at the node: rounding may ask a moment too early or too late.
    pub fn along(&self, t_s: f64) -> Along {
        let Some(last) = self.nodes.last() else { return Along { at_mm: 0.0, v: 0.0, accel: 0.0 } };
        let stands = Along { at_mm: last.at_mm, v: last.v, accel: 0.0 };
        if self.nodes.len() < 2 || (t_s >= last.t_s && last.v == 0.0) {
            return stands;
        }
        let later = self.nodes.partition_point(|n| n.t_s <= t_s).clamp(1, self.nodes.len() - 1);
        let (a, b) = (&self.nodes[later - 1], &self.nodes[later]);
        let s = (t_s - a.t_s).clamp(0.0, b.t_s - a.t_s);
        if let Some(push) = self.pushes.get(later - 1) {
            return pushed(a, push, b, s);
        }
        let accel = (b.v - a.v) / (b.t_s - a.t_s);
        let at_mm = between(a, b, a.at_mm + s * (a.v + 0.5 * accel * s));
        Along { at_mm, v: a.v + accel * s, accel }
    }

    /// The motion along the path from a time on, in ways, at a rate of time; and whether they
    /// lead to the last node: phases of constant jerk are none.
    pub fn ways_from(&self, t_s: f64, rate: f64) -> (Vec<Way>, bool) {
        let here = self.along(t_s);
        let square = rate * rate;
        let mut at = (here.at_mm, here.v * here.v, here.accel);
        let later = self.nodes.partition_point(|n| n.t_s <= t_s);
        let mut ways = Vec::new();
        for k in later.max(1)..self.nodes.len() {
            let (node, push) = (&self.nodes[k], &self.pushes[k]);
            let (h, x) = (node.at_mm - at.0, node.v * node.v);
            if h > 0.0 {
                ways.push(Way { h, x: [at.1, at.1 + at.2 * h, x].map(|x| x * square) });
            }
            if push.jerk.is_some() || self.pushes[k - 1].jerk.is_some() {
                return (ways, false);
            }
            at = (node.at_mm, x, push.accel);
        }
        (ways, true)
    }

    /// Returns the time at which a place on the path is reached.
    pub fn time_at(&self, at_mm: f64) -> f64 {
        let later = self.nodes.partition_point(|n| n.at_mm < at_mm);
        let (Some(a), Some(b)) = (self.nodes.get(later.wrapping_sub(1)), self.nodes.get(later))
        else {
            return if later == 0 { self.start_s() } else { self.duration_s() };
        };
        if !self.pushes.is_empty() {
            return halve(a, &self.pushes[later - 1], b, at_mm).0.t_s;
        }
        let accel = (b.v * b.v - a.v * a.v) / (2.0 * (b.at_mm - a.at_mm));
        let way = at_mm - a.at_mm;
        let v = (a.v * a.v + 2.0 * accel * way).max(0.0).sqrt();
        let within = if way > 0.0 { 2.0 * way / (a.v + v) } else { 0.0 };
        a.t_s + within.min(b.t_s - a.t_s)
    }

    /// Returns the time at which the first node is passed; not zero for a later piece of a stack.
    fn start_s(&self) -> f64 {
        self.nodes.first().map_or(0.0, |n| n.t_s)
    }

    /// Returns the place on the track where a move begins; beyond the last, where the plan ends.
    pub fn start_mm(&self, index: usize) -> f64 {
        if index == 0 {
            return self.from_mm;
        }
        let vertex = self.track.owner.partition_point(|owner| (*owner as usize) < index);
        let past = index > self.last_move();
        let at = self.track.at_mm.get(vertex).filter(|_| !past);
        at.copied().unwrap_or_else(|| self.nodes.last().map_or(0.0, |n| n.at_mm))
    }

    fn last_move(&self) -> usize {
        self.track.owner.last().map_or(0, |owner| *owner as usize)
    }

    /// The move to which a place on the track belongs, and how much of its path lies before.
    pub fn share(&self, at_mm: f64) -> (usize, f64) {
        let (index, [a, b]) = self.reach(self.track.segment(at_mm));
        (index, share_of(at_mm, a, b))
    }

    /// The move to which a segment belongs, and from where to where it goes on the track.
    fn reach(&self, segment: usize) -> (usize, [f64; 2]) {
        let index = self.track.owner[segment] as usize;
        (index, [self.start_mm(index), self.start_mm(index + 1)])
    }

    /// Returns the state of the machine at a time.
    pub fn at(&self, t_s: f64, moves: &[Move]) -> State {
        let along = self.along(t_s);
        let segment = self.track.segment(along.at_mm);
        let (move_index, [a, b]) = self.reach(segment);
        let made = &moves[move_index.min(moves.len() - 1)];
        let geometry = self.geometry(along.at_mm);
        let [velocity, acceleration] = rates(&along, &geometry);
        State {
            position: geometry[0],
            path_speed_mm_s: made.basis.square(&velocity.0).sqrt(),
            velocity,
            acceleration,
            move_index,
            share: share_of(along.at_mm, a, b),
        }
    }

    /// Velocity and acceleration of every axis at a time.
    pub fn rates(&self, t_s: f64) -> [Axes; 2] {
        let along = self.along(t_s);
        rates(&along, &self.geometry(along.at_mm))
    }

    /// Reference length of a move for a millimetre of the track.
    fn scale(&self, index: usize, made: &Move) -> f64 {
        let length = self.start_mm(index + 1) - self.start_mm(index);
        if length > 0.0 { made.length_mm / length } else { 1.0 }
    }

    /// Speeds of a move along its reference length: at its start, the highest, at its end.
    pub fn speeds(&self, index: usize, made: &Move) -> [f64; 3] {
        let (a, b) = (self.start_mm(index), self.start_mm(index + 1));
        let (entry, exit) = (self.v_at(a), self.v_at(b));
        let first = self.nodes.partition_point(|n| n.at_mm <= a);
        let inside = self.nodes[first..].iter().take_while(|n| n.at_mm < b);
        let peak = inside.map(|n| n.v).fold(entry.max(exit), f64::max);
        let scale = self.scale(index, made);
        // Along the smoothed path, which is shorter, the tool is no faster than it may be.
        [entry, peak, exit].map(|v| (v * scale).min(made.top_mm_s()))
    }

    fn v_at(&self, at_mm: f64) -> f64 {
        self.along(self.time_at(at_mm)).v
    }

    /// Position, slope and curvature by the length at a place on the track.
    pub fn geometry(&self, at_mm: f64) -> [Axes; 3] {
        if self.track.dims == 3 { self.shape::<3>(at_mm) } else { self.shape::<AXES>(at_mm) }
    }

    /// The same, of the first axes; the others stand still.
    fn shape<const N: usize>(&self, at_mm: f64) -> [Axes; 3] {
        let at = &self.track.at_mm;
        let at_mm = at_mm.min(at[at.len() - 1]);
        let segment = self.track.segment(at_mm);
        let direction = self.track.direction::<N>(segment);
        // At its end exactly where the program says.
        let ends = at_mm >= at[at.len() - 1];
        let from = self.track.point::<AXES>(if ends { at.len() - 1 } else { segment });
        let way = if ends { 0.0 } else { at_mm - at[segment] };
        let mut out = [from, [0.0; AXES], [0.0; AXES]];
        for (k, slope) in direction.iter().enumerate() {
            (out[0][k], out[1][k]) = (from[k] + way * slope, *slope);
        }
        let mut add = |j: usize, turn: [f64; N], offset: f64| {
            let shape = self.kernel.shape(square(&turn), self.widths[j], offset);
            for (value, factor) in out.iter_mut().zip(shape) {
                (0..N).for_each(|k| value[k] += factor * turn[k]);
            }
        };
        let (mut j, mut after) = (segment, direction);
        while self.widths[j].abs() > at_mm - at[j] {
            let before = self.track.direction::<N>(j - 1);
            if self.widths[j] >= 0.0 {
                add(j, minus(&after, &before), (at_mm - at[j]).max(f64::MIN_POSITIVE));
            }
            (j, after) = (j - 1, before);
        }
        let (mut j, mut before) = (segment + 1, direction);
        while j < at.len() && self.widths[j].abs() > at[j] - at_mm {
            let after = self.track.direction::<N>(j);
            if self.widths[j] >= 0.0 {
                add(j, minus(&after, &before), -(at[j] - at_mm).max(f64::MIN_POSITIVE));
            }
            (j, before) = (j + 1, after);
        }
        out.map(Axes)
    }
}

/// Returns the share of a move from one place to another that lies before a third.
fn share_of(at_mm: f64, a: f64, b: f64) -> f64 {
    let share = if b > a { (at_mm - a) / (b - a) } else { 1.0 };
    share.clamp(0.0, 1.0)
}

/// Velocity and acceleration of a motion along a path of which slope and curvature are known.
fn rates(along: &Along, [_, slope, bend]: &[Axes; 3]) -> [Axes; 2] {
    let square = along.v * along.v;
    [Axes(slope.0.map(|p| p * along.v)), slope.zip(*bend, |p, c| p * along.accel + c * square)]
}

fn square<const N: usize>(v: &[f64; N]) -> f64 {
    v.iter().map(|x| x * x).sum()
}

fn minus<const N: usize>(a: &[f64; N], b: &[f64; N]) -> [f64; N] {
    std::array::from_fn(|k| a[k] - b[k])
}

/// The motion at a time since a node, where jerk is limited.
fn pushed(a: &Node, push: &Push, next: &Node, s: f64) -> Along {
    let here = match push.jerk {
        Some(jerk) => Along {
            at_mm: a.at_mm + s * (a.v + s * (0.5 * push.accel + s * jerk / 6.0)),
            v: a.v + s * (push.accel + 0.5 * s * jerk),
            accel: push.accel + s * jerk,
        },
        None => {
            let way = next.at_mm - a.at_mm;
            let end = (next.v * next.v - a.v * a.v) / way - push.accel;
            swing(a, push.accel, (end - push.accel) / way, s)
        }
    };
    Along { at_mm: between(a, next, here.at_mm), v: here.v.max(0.0), ..here }
}

/// A node at a place between two, where jerk is limited, and how the motion goes on after it.
pub(crate) fn halve(a: &Node, push: &Push, b: &Node, at_mm: f64) -> (Node, Push) {
    let (mut low, mut high) = (0.0, b.t_s - a.t_s);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if pushed(a, push, b, middle).at_mm < at_mm { low = middle } else { high = middle }
    }
    let Along { v, accel, .. } = pushed(a, push, b, high);
    (Node { at_mm, v, t_s: a.t_s + high }, Push { accel, jerk: push.jerk })
}

/// A place between two nodes; before the second, when it is a stop, so that rounding does not put
/// the last moments of one direction into the next.
fn between(a: &Node, b: &Node, at_mm: f64) -> f64 {
    let last = if b.v > 0.0 { b.at_mm } else { b.at_mm.next_down() };
    at_mm.min(last).max(a.at_mm)
}

/// Motion with s̈ linear in s: s̈ = accel + rate·(s − s₀).
pub(crate) fn swing(from: &Node, accel: f64, rate: f64, s: f64) -> Along {
    let w = rate.abs().sqrt();
    // c = cos or cosh, and what else the solution is made of, by series where nothing swings.
    let (c, sine, rest) = if w * s < 1e-3 {
        let q = rate * s * s;
        (1.0 + q / 2.0, s * (1.0 + q / 6.0), s * s * (0.5 + q / 24.0))
    } else if rate > 0.0 {
        let (c, sine) = ((w * s).cosh(), (w * s).sinh());
        (c, sine / w, (c - 1.0) / rate)
    } else {
        let (sine, c) = (w * s).sin_cos();
        (c, sine / w, (c - 1.0) / rate)
    };
    Along {
        at_mm: from.at_mm + from.v * sine + accel * rest,
        v: from.v * c + accel * sine,
        accel: accel * c + rate * from.v * sine,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn between_two_nodes_the_motion_goes_on() {
        let node = |at_mm, v, t_s| Node { at_mm, v, t_s };
        let free = Axes::splat(f64::INFINITY);
        let timed = Timed {
            track: Track::default(),
            from_mm: 0.0,
            widths: Vec::new(),
            kernel: Kernel::Box,
            nodes: vec![node(0.0, 10.0, 0.0), node(15.0, 20.0, 1.0)],
            pushes: Vec::new(),
            dynamics: Dynamics {
                speed_mm_s: free,
                accel_mm_s2: free,
                jerk_mm_s3: None,
                tolerance_mm: 0.0,
            },
        };
        for (t_s, at_mm, v) in [(-1.0, 0.0, 10.0), (0.5, 6.25, 15.0), (1.0, 15.0, 20.0)] {
            let along = timed.along(t_s);
            assert_eq!((along.at_mm, along.v, along.accel), (at_mm, v, 10.0), "{t_s}");
        }
    }

    #[test]
    fn a_swing_is_what_its_equation_says() {
        let from = Node { at_mm: 3.0, v: 2.0, t_s: 0.0 };
        for (rate, s) in [(4.0, 0.7), (-4.0, 0.7), (0.0, 0.7), (1e-7, 2.0), (-1e-7, 2.0)] {
            let at = |s| swing(&from, 5.0, rate, s);
            let (d, here) = (1e-4, at(s));
            let (before, after) = (at(s - d), at(s + d));
            let slope = |a: f64, b: f64| (b - a) / (2.0 * d);
            assert!((slope(before.at_mm, after.at_mm) - here.v).abs() < 1e-5, "{rate}");
            assert!((slope(before.v, after.v) - here.accel).abs() < 1e-5, "{rate}");
            let due = 5.0 + rate * (here.at_mm - from.at_mm);
            assert!((here.accel - due).abs() < 1e-9, "{rate}: {} and not {due}", here.accel);
        }
    }

    #[test]
    fn a_swing_by_series_goes_on_as_one_by_functions() {
        let from = Node { at_mm: 0.0, v: 2.0, t_s: 0.0 };
        for rate in [1e-2, -1e-2] {
            // Where the one gives way to the other.
            let [series, whole] =
                [1.0 - 1e-9, 1.0 + 1e-9].map(|k| swing(&from, 5e8, rate, k * 1e-2));
            assert!((series.at_mm / whole.at_mm - 1.0).abs() < 1e-8, "{series:?} {whole:?}");
        }
    }
}
