//! The heights of a drilled hole, as the words of a canned cycle name them.

use super::coordinates::Coordinates;
use super::state::Modal;
use super::stop::{Refused, fail};
use crate::syntax::codes::g_name;
use crate::syntax::gathered::Gathered;
use kerf_diag::Code;
use serde::{Deserialize, Serialize};

/// Pecks of one hole.
const MOST_PECKS: f64 = 10_000.0;

/// Values that hold from block to block while cycles follow each other. Lengths in mm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Cycle {
    /// Place of the drilling axis before the first of them.
    pub(super) initial: f64,
    /// The word R as written, in the unit of the plane's axis.
    r: Option<f64>,
    /// The word of the drilling axis.
    depth: Option<f64>,
    p: Option<f64>,
    q: Option<f64>,
    /// I, J and K of G87 as written.
    beside: [Option<f64>; 3],
    /// The axis that it drills along.
    pub(super) axis: usize,
}

/// One hole.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub(super) struct Hole {
    pub(super) code: i32,
    /// Axes of the plane, the drilling one last.
    pub(super) axes: [usize; 3],
    /// Which way is out of the hole: 1, or −1 where FP mirrors the drilling axis.
    out: f64,
    pub(super) r: f64,
    pub(super) bottom: f64,
    pub(super) clear: f64,
    pub(super) dwell: f64,
    pub(super) peck: f64,
    /// Place where G87 goes in, from the hole.
    pub(super) beside: [f64; 2],
    /// Place that G87 bores to.
    pub(super) middle: f64,
}

impl Cycle {
    /// A cycle that begins at a place of an axis.
    pub(super) const fn new(axis: usize, initial: f64) -> Self {
        Self { initial, r: None, depth: None, p: None, q: None, beside: [None; 3], axis }
    }

    /// Takes over the words of a block.
    pub(super) fn take(&mut self, g: &Gathered) {
        self.r = g.get(b'R').or(self.r);
        self.depth = g.get(b"XYZ"[self.axis]).or(self.depth);
        self.p = g.get(b'P').or(self.p);
        self.q = g.get(b'Q').or(self.q);
        for (word, letter) in self.beside.iter_mut().zip(*b"IJK") {
            *word = g.get(letter).or(*word);
        }
    }

    /// R and the bottom.
    fn heights(&self, code: i32, modal: &Modal, scale: f64) -> Result<(f64, f64), Refused> {
        let letter = ['X', 'Y', 'Z'][self.axis];
        let (Some(r), Some(depth)) = (self.r, self.depth) else {
            let what = if self.r.is_none() { 'R' } else { letter };
            let message = format!("{} without {what}", g_name(code));
            let hint =
                format!("a cycle needs {letter} for the bottom and R for the height it begins at");
            return Err(fail(Code::MissingWord, message, hint));
        };
        let (r, bottom) = if modal.relative {
            // R counts from where the first of the cycles began, as LinuxCNC has it.
            (self.initial + r * scale, self.initial + (r + depth) * scale)
        } else {
            (r * scale, depth * scale)
        };
        if (r - bottom) * scale < 0.0 {
            let message = format!("R lies below {letter}");
            return Err(fail(Code::OutOfRange, message, "a cycle drills down from R"));
        }
        Ok((r, bottom))
    }

    /// The depth of one peck; 0 for a hole that is drilled at once.
    fn peck(&self, code: i32, unit_mm: f64, way: f64, lenient: bool) -> Result<f64, Refused> {
        let peck = self.q.unwrap_or_default() * unit_mm;
        let one_peck = self.q == Some(0.0) && lenient;
        if matches!(code, 730 | 830) && peck <= 0.0 && !one_peck {
            let name = g_name(code);
            let message = match self.q {
                None => format!("{name} without Q"),
                Some(q) => format!("{name} with a Q of {q}"),
            };
            let hint = "Q is the depth of one peck, above 0; Q0 is one peck with --dialect generic";
            return Err(fail(Code::MissingWord, message, hint));
        }
        if peck > 0.0 && way.abs() / peck > MOST_PECKS {
            let message = "Q is far too small for this depth";
            return Err(fail(Code::OutOfRange, message, "Q is the depth of one peck"));
        }
        Ok(peck)
    }

    /// Returns the place where G87 goes in, from the hole, and the height that it bores to. The tool's
    /// nose stands where the spindle stops, so the way beside the hole is not turned by FP.
    fn beside(
        &self,
        code: i32,
        modal: &Modal,
        scale: f64,
        bottom: f64,
    ) -> Result<([f64; 2], f64), Refused> {
        if code != 870 {
            return Ok(([0.0; 2], bottom));
        }
        let [Some(i), Some(j), Some(k)] = self.beside else {
            let message = "G87 without I, J or K";
            let hint = "two of them lead beside the hole, where the tool goes in; the one along the \
                        drilling axis is the height that it bores to";
            return Err(fail(Code::MissingWord, message, hint));
        };
        let [u, v, w] = modal.plane.axes();
        let (words, unit) = ([i, j, k], modal.unit.mm());
        let height = words[w] * scale;
        let middle = if modal.relative { bottom + height } else { height };
        Ok(([words[u] * unit, words[v] * unit], middle))
    }
}

impl Hole {
    /// The hole of a cycle.
    pub(super) fn new(
        code: i32,
        cycle: &Cycle,
        modal: &Modal,
        coordinates: &Coordinates,
        lenient: bool,
    ) -> Result<Self, Refused> {
        let axes = modal.plane.axes();
        let scale = coordinates.scale[axes[2]];
        let (r, bottom) = cycle.heights(code, modal, scale)?;
        let peck = cycle.peck(code, modal.unit.mm(), r - bottom, lenient)?;
        if cycle.p.is_some_and(|p| p < 0.0) {
            let message = "P may not be negative";
            return Err(fail(Code::OutOfRange, message, "it is a time in seconds"));
        }
        let (beside, middle) = cycle.beside(code, modal, scale, bottom)?;
        let (out, dwell) = (scale.signum(), cycle.p.unwrap_or_default());
        let mut hole = Self { code, axes, out, r, bottom, clear: r, dwell, peck, beside, middle };
        if !modal.return_to_r {
            hole.clear = hole.higher(cycle.initial, r);
        }
        Ok(hole)
    }

    /// Returns `true` if a place lies farther out of the hole than another.
    pub(super) fn is_above(&self, place: f64, other: f64) -> bool {
        (place - other) * self.out > 0.0
    }

    /// A place so far below another.
    pub(super) const fn below(&self, place: f64, distance: f64) -> f64 {
        place - distance * self.out
    }

    /// The higher of two places.
    pub(super) fn higher(&self, a: f64, b: f64) -> f64 {
        if self.is_above(b, a) { b } else { a }
    }
}
