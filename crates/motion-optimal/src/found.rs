//! The motion that was found under a limit of jerk: nodes, and how it goes on after each.

use crate::launch::Launch;
use crate::node::{Node, Push, swing};
use crate::speed_piece::SpeedPiece;

/// Newton's steps in search of a time; each doubles the digits.
const NEWTON: u32 = 8;

/// Nodes with as many pushes.
#[derive(Clone, Debug, Default)]
pub(crate) struct Found {
    pub nodes: Vec<Node>,
    pub pushes: Vec<Push>,
}

impl Found {
    /// At rest at the beginning of a track.
    pub fn at_rest() -> Self {
        let node = Node { at_mm: 0.0, v: 0.0, t_s: 0.0 };
        Self { nodes: vec![node], pushes: vec![Push { accel: 0.0, jerk: None }] }
    }

    /// In motion at a place, where a way begins.
    pub fn in_motion(at_mm: f64, SpeedPiece { h, x }: &SpeedPiece) -> Self {
        let node = Node { at_mm, v: x[0].sqrt(), t_s: 0.0 };
        Self { nodes: vec![node], pushes: vec![Push { accel: (x[1] - x[0]) / h, jerk: None }] }
    }

    /// Goes on with constant jerk.
    pub fn push(&mut self, t: f64, jerk: f64) {
        let (Some(node), Some(push)) = (self.nodes.last(), self.pushes.last_mut()) else { return };
        let accel = push.accel;
        push.jerk = Some(jerk);
        self.nodes.push(Node {
            at_mm: node.at_mm + t * (node.v + t * (0.5 * accel + t * jerk / 6.0)),
            v: node.v + t * (accel + 0.5 * t * jerk),
            t_s: node.t_s + t,
        });
        self.pushes.push(Push { accel: accel + t * jerk, jerk: None });
    }

    /// At rest at a place, which the last node misses by no more than the rounding of sums.
    pub fn stand(&mut self, at_mm: f64) {
        if let Some(end) = self.nodes.last_mut() {
            (end.at_mm, end.v) = (at_mm, 0.0);
        }
        if let Some(last) = self.pushes.last_mut() {
            *last = Push { accel: 0.0, jerk: None };
        }
    }

    /// From rest to a squared speed.
    pub fn launch(&mut self, launch: Launch, x: f64) {
        let (Some(node), Some(push)) = (self.nodes.last(), self.pushes.last_mut()) else { return };
        push.jerk = Some(launch.jerk(x));
        let t_s = node.t_s + launch.takes_s(x);
        self.nodes.push(Node { at_mm: node.at_mm + launch.way_mm, v: x.sqrt(), t_s });
        self.pushes.push(Push { accel: 0.0, jerk: None });
    }

    /// Ways in motion.
    pub fn go(&mut self, ways: &[SpeedPiece]) {
        for way in ways {
            let (Some(node), Some(push)) = (self.nodes.last_mut(), self.pushes.last_mut()) else {
                return;
            };
            node.v = way.x[0].sqrt();
            *push = Push { accel: (way.x[1] - way.x[0]) / way.h, jerk: None };
            let (at_mm, t_s) = (node.at_mm + way.h, node.t_s + takes_s(&way.x, way.h));
            self.nodes.push(Node { at_mm, v: way.x[2].sqrt(), t_s });
            self.pushes.push(Push { accel: (way.x[2] - way.x[1]) / way.h, jerk: None });
        }
    }

    /// To rest at a place.
    pub fn land(&mut self, end: Launch, at_mm: f64) {
        let (Some(node), Some(push)) = (self.nodes.last(), self.pushes.last_mut()) else { return };
        let x = node.v * node.v;
        push.jerk = Some(end.jerk(x));
        self.nodes.push(Node { at_mm, v: 0.0, t_s: node.t_s + end.takes_s(x) });
        self.pushes.push(Push { accel: 0.0, jerk: None });
    }
}

/// Time over a piece, by Newton's method from the mean of the speeds at its ends.
fn takes_s(x: &[f64; 3], h: f64) -> f64 {
    let start = Node { at_mm: 0.0, v: x[0].sqrt(), t_s: 0.0 };
    let (a0, a1) = ((x[1] - x[0]) / h, (x[2] - x[1]) / h);
    let mut t = 2.0 * h / (start.v + x[2].sqrt());
    for _ in 0..NEWTON {
        let here = swing(&start, a0, (a1 - a0) / h, t);
        if here.v > 0.0 {
            t = (t + (h - here.at_mm) / here.v).max(0.5 * t);
        }
    }
    t
}
