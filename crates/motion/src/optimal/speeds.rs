//! The fastest speed along the cells: a pass back for what can still be slowed from, and a pass
//! forward that takes the fastest way through it.

use super::reach::{Bounds, Gate, MOST_PARTS};

/// A place on the way, with speed and time; between two of them s̈ is constant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Node {
    /// Along the track.
    pub at_mm: f64,
    /// Speed along the track.
    pub v: f64,
    /// Time of the plan.
    pub t_s: f64,
}

/// Appends the nodes of a run from rest to rest, after the one at its start.
pub(crate) fn run<const N: usize>(
    gates: &mut [Gate<N>],
    bounds: &Bounds<N>,
    nodes: &mut Vec<Node>,
) {
    let mut most = vec![0.0; gates.len() + 1];
    for (i, gate) in gates.iter_mut().enumerate().rev() {
        most[i] = entry(gate, most[i + 1], bounds);
    }
    let mut y = 0.0;
    for (i, gate) in gates.iter().enumerate() {
        let end = if i + 1 == gates.len() { 0.0 } else { most[i + 1] };
        y = match gate.straight() {
            Some(accel) => straight(gate, accel, y, end, nodes),
            None => curved(gate, y, end, bounds, nodes),
        };
    }
}

/// The greatest entry into a cell, in parts where it is too coarse.
fn entry<const N: usize>(gate: &mut Gate<N>, most: f64, bounds: &Bounds<N>) -> f64 {
    let whole = gate.entry(most, bounds);
    gate.parts = gate.parts(whole.max(most));
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
    let parts = gate.parts(entry.max(y)).max(gate.parts);
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
    let exit = most.min(entry + 2.0 * accel * gate.h);
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

/// Adds a node reached with constant s̈.
pub(crate) fn step(nodes: &mut Vec<Node>, at_mm: f64, v: f64) {
    if let Some(before) = nodes.last() {
        let way = at_mm - before.at_mm;
        if way > 0.0 {
            let t_s = before.t_s + 2.0 * way / (before.v + v);
            nodes.push(Node { at_mm, v, t_s });
        }
    }
}
