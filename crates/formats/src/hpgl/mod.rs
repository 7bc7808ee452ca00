//! HPGL and HPGL/2: files for pen plotters, with the extensions .plt, .hpg and .hpgl.
//!
//! ```text
//!  IN;SP1;PU0,0;PD1016,0;  ─► instructions ─► a plotter that draws ─► shapes
//!                             (words)         (plotter, scale)
//! ```
//!
//! A run with the pen down is a shape; it is closed when it returns to its start. The pens become groups:
//! pen 1 the first, pen 2 the second. 40 plotter units are a millimetre (1016 an inch), unless SC and IP
//! say otherwise. Lettering, line types and fills are no paths: they are counted and told.

mod instructions;
mod packed;
mod plotter;
mod scale;

use crate::Imported;
use crate::finding::Findings;
use plotter::Plotter;

/// Reads a plotter file.
pub fn read(bytes: &[u8]) -> Imported {
    let mut findings = Findings::default();
    let mut plotter = Plotter::default();
    for instruction in instructions::instructions(bytes) {
        plotter.carry_out(&instruction, &mut findings);
    }
    let (drawing, layers) = plotter.finish(&mut findings);
    if drawing.shapes.is_empty() {
        findings.warn("empty", 0, "nothing is drawn: no move with the pen down");
    }
    let skipped = findings.skipped();
    Imported { drawing, findings: findings.finish(), layers, skipped, ended: None }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests;
