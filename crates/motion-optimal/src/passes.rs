//! The fastest speed along the cells: a pass back for what can still be slowed from, and a pass
//! forward that takes the fastest way through it.

use crate::bounds::Bounds;
use crate::gate::{Gate, MOST_PARTS};
use crate::node::{Node, step};

/// The passes over cells that come one after the other.
#[derive(Clone, Debug)]
pub(crate) struct Passes<const N: usize> {
    bounds: Bounds<N>,
    /// Cells through which the speed is not final.
    pub gates: Vec<Gate<N>>,
    /// The greatest squared speed at the beginning of each, as far as is known.
    most: Vec<f64>,
    /// The squared speed at the beginning of the first.
    y: f64,
    pub nodes: Vec<Node>,
}

impl<const N: usize> Passes<N> {
    /// From rest at a place.
    pub fn new(bounds: Bounds<N>, at_mm: f64) -> Self {
        let start = Node { at_mm, v: 0.0, t_s: 0.0 };
        Self { bounds, gates: Vec::new(), most: Vec::new(), y: 0.0, nodes: vec![start] }
    }

    /// From a place that is passed with a squared speed.
    pub fn running(bounds: Bounds<N>, at_mm: f64, y: f64) -> Self {
        let mut passes = Self::new(bounds, at_mm);
        (passes.y, passes.nodes[0].v) = (y, y.sqrt());
        passes
    }

    /// The same with more axes, which stood still.
    pub fn widen<const M: usize>(&mut self, bounds: Bounds<M>) -> Passes<M> {
        Passes {
            bounds,
            gates: self.gates.iter().map(Gate::widen).collect(),
            most: Vec::new(),
            y: self.y,
            nodes: std::mem::take(&mut self.nodes),
        }
    }

    /// Finds the speed through all cells for which it does not depend on what comes after the last;
    /// `ended` when the machine stands there.
    pub fn settle(&mut self, ended: bool) {
        let last = self.gates.len();
        self.most.clear();
        self.most.resize(last + 1, if ended { 0.0 } else { f64::INFINITY });
        for i in (0..last).rev() {
            self.most[i] = entry(&mut self.gates[i], self.most[i + 1], &self.bounds);
        }
        let known = if ended { last } else { self.agreed() };
        self.forward(known);
        self.gates.drain(..known);
    }

    /// Returns the number of cells whose speeds are final, whatever comes. The speed that can be slowed from lies
    /// between its value if the machine must stand after the last cell and its value if nothing slows it there. From
    /// where both agree on, all before is final.
    fn agreed(&mut self) -> usize {
        let mut low = 0.0;
        for i in (1..self.gates.len()).rev() {
            low = entry(&mut self.gates[i], low, &self.bounds);
            if low == self.most[i] {
                return i;
            }
        }
        0
    }

    fn forward(&mut self, count: usize) {
        let mut y = self.y;
        for (gate, end) in self.gates[..count].iter().zip(&self.most[1..]) {
            y = match gate.straight() {
                Some(accel) => straight(gate, accel, y, *end, &mut self.nodes),
                None => curved(gate, y, *end, &self.bounds, &mut self.nodes),
            };
        }
        self.y = y;
    }
}

/// The greatest entry into a cell, in parts where it is too coarse.
fn entry<const N: usize>(gate: &mut Gate<N>, most: f64, bounds: &Bounds<N>) -> f64 {
    if gate.stands {
        return 0.0;
    }
    let whole = gate.entry(most, bounds);
    if gate.straight().is_some() {
        return whole;
    }
    gate.parts = gate.parts(whole, most.min(gate.cap));
    match gate.parts {
        1 => whole,
        parts => (0..parts).rev().fold(most, |most, k| gate.part(k, parts).entry(most, bounds)),
    }
}

/// Goes through a cell, in parts where it is too coarse; gives the squared speed at its end.
fn curved<const N: usize>(
    gate: &Gate<N>,
    entry: f64,
    most: f64,
    bounds: &Bounds<N>,
    nodes: &mut Vec<Node>,
) -> f64 {
    let mut y = gate.exit(entry, most, bounds);
    // A refinement of the parts of the pass back, so that what it promised holds.
    let parts = gate.parts(entry, y).max(gate.parts);
    if parts > 1 {
        let mut ends = [most; MOST_PARTS as usize];
        for k in (1..parts as usize).rev() {
            ends[k - 1] = gate.part(k as u32, parts).entry(ends[k], bounds);
        }
        y = entry;
        for k in 0..parts - 1 {
            let part = gate.part(k, parts);
            y = part.exit(y, ends[k as usize], bounds);
            step(nodes, part.at_mm + part.h, y.sqrt());
        }
        y = gate.part(parts - 1, parts).exit(y, most, bounds);
    }
    step(nodes, gate.at_mm + gate.h, y.sqrt());
    y
}

/// Rises, cruises and falls on a straight; gives the squared speed at its end.
fn straight<const N: usize>(
    gate: &Gate<N>,
    accel: f64,
    entry: f64,
    most: f64,
    nodes: &mut Vec<Node>,
) -> f64 {
    // What follows may be faster: this cell ends at its own feed.
    let exit = most.min(gate.cap).min(entry + 2.0 * accel * gate.h);
    let peak = gate.cap.min(0.5 * (entry + exit) + accel * gate.h).max(entry).max(exit);
    let rise = (peak - entry) / (2.0 * accel);
    let fall = (peak - exit) / (2.0 * accel);
    if rise > 0.0 && rise < gate.h {
        step(nodes, gate.at_mm + rise, peak.sqrt());
    }
    if fall > 0.0 && rise + fall < gate.h * (1.0 - 1e-12) {
        step(nodes, gate.at_mm + gate.h - fall, peak.sqrt());
    }
    step(nodes, gate.at_mm + gate.h, exit.sqrt());
    exit
}
