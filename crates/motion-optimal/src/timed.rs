//! A smoothed path with its times: where every axis is at time t.

use crate::kernel::Kernel;
use crate::node::{Along, Node, Push, between, halve, pushed};
use crate::speed_piece::SpeedPiece;
use crate::track::Track;
use kerf_program::{AXES, Axes, Dynamics};

/// Place and motion of the machine at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moment {
    /// Place of the axes, machine frame.
    pub position: Axes,
    /// Speed of each axis, signed, mm/s or degrees/s.
    pub velocity: Axes,
    /// Acceleration of each axis, mm/s² or degrees/s².
    pub acceleration: Axes,
    /// The move being made.
    pub move_index: usize,
    /// Share of its path that has been made, 0 … 1.
    pub share: f64,
}

/// The law of motion of the `optimal` model.
#[derive(Clone, Debug, PartialEq)]
pub struct Timed {
    pub(crate) track: Track,
    /// Place on the track where the first move begins; the first node may lie behind.
    pub(crate) from_mm: f64,
    pub(crate) widths: Vec<f64>,
    pub(crate) kernel: Kernel,
    /// Places on the way with speed and time.
    pub nodes: Vec<Node>,
    /// One for each node where jerk is limited; else none, and s̈ is constant between nodes.
    pub(crate) pushes: Vec<Push>,
    /// Limits of the axes.
    pub dynamics: Dynamics,
}

impl Timed {
    /// Returns the time at which it ends, seconds.
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
    pub fn ways_from(&self, t_s: f64, rate: f64) -> (Vec<SpeedPiece>, bool) {
        let here = self.along(t_s);
        let square = rate * rate;
        let mut at = (here.at_mm, here.v * here.v, here.accel);
        let later = self.nodes.partition_point(|n| n.t_s <= t_s);
        let mut ways = Vec::new();
        for k in later.max(1)..self.nodes.len() {
            let (node, push) = (&self.nodes[k], &self.pushes[k]);
            let (h, x) = (node.at_mm - at.0, node.v * node.v);
            if h > 0.0 {
                ways.push(SpeedPiece { h, x: [at.1, at.1 + at.2 * h, x].map(|x| x * square) });
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

    /// Place and motion of every axis at a time.
    pub fn at(&self, t_s: f64) -> Moment {
        let along = self.along(t_s);
        let segment = self.track.segment(along.at_mm);
        let (move_index, [a, b]) = self.reach(segment);
        let geometry = self.geometry(along.at_mm);
        let [velocity, acceleration] = rates(&along, &geometry);
        let share = share_of(along.at_mm, a, b);
        Moment { position: geometry[0], velocity, acceleration, move_index, share }
    }

    /// Velocity and acceleration of every axis at a time.
    pub fn rates(&self, t_s: f64) -> [Axes; 2] {
        let along = self.along(t_s);
        rates(&along, &self.geometry(along.at_mm))
    }

    /// Length of a move on the track, mm.
    pub fn length_mm(&self, index: usize) -> f64 {
        self.start_mm(index + 1) - self.start_mm(index)
    }

    /// Speeds along the track in a move: at its start, the highest, at its end.
    pub fn speeds(&self, index: usize) -> [f64; 3] {
        let (a, b) = (self.start_mm(index), self.start_mm(index + 1));
        let (entry, exit) = (self.v_at(a), self.v_at(b));
        let first = self.nodes.partition_point(|n| n.at_mm <= a);
        let inside = self.nodes[first..].iter().take_while(|n| n.at_mm < b);
        let peak = inside.map(|n| n.v).fold(entry.max(exit), f64::max);
        [entry, peak, exit]
    }

    fn v_at(&self, at_mm: f64) -> f64 {
        self.along(self.time_at(at_mm)).v
    }

    /// Position, slope and curvature by the length at a place on the track.
    fn geometry(&self, at_mm: f64) -> [Axes; 3] {
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
}
