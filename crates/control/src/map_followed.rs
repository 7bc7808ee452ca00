//! The height map that a run follows: laid below a part file or a job, or the reason for which it cannot be.
//!
//! A map lies where it was probed, at X and Y zero of the working location. A part file moves that zero itself; a job
//! has an origin of its own, and is cut above the map wherever that lies.

use crate::map_pieces::Laid;
use crate::mapped::{Mapped, outside};
use kerf_diag::{Code, Diagnostic, Severity, SourcePlace};
use kerf_machine::homing::{bounds_by_hand, table_bounds};
use kerf_machine::{Configuration, Driven};
use kerf_part::{Interpreter, Program};
use kerf_program::job::JobShape;
use kerf_program::{Axes, Axis, Frame, HeightMap, Interpreter as _, MARGIN_MM};
use kerf_sequence::Sequence;
use std::sync::Arc;

/// A part file that follows a height map, where one is in force, from where the machine stands.
pub(crate) fn mapped(
    program: Program,
    mut memory: kerf_part::Session,
    read: kerf_part::Options,
    map: Option<Arc<HeightMap>>,
    top_mm: f64,
) -> Mapped<Interpreter> {
    let zero = memory.sbp.frame.working_zero;
    memory.sbp.position = lowered(map.as_deref(), zero, memory.sbp.position);
    Mapped::new(Interpreter::new(program, memory, read), map).below(top_mm)
}

/// The place that a program names where the machine stands at a position, above a map that lies at a zero.
pub(crate) fn lowered(map: Option<&HeightMap>, zero: Axes, position: Axes) -> Axes {
    map.map_or(position, |map| Laid { map, zero, top_mm: f64::INFINITY }.lowered(position))
}

/// Returns the highest place of Z, machine frame, mm: by its length, the table limits and the controller; infinite where none
/// is known.
pub(crate) fn top_mm(machine: &Configuration, homed: bool, frame: &Frame, driven: &Driven) -> f64 {
    let (_, length) = bounds_by_hand(machine, Axis::Z, homed);
    let table = table_bounds(machine, Axis::Z).map(|(_, high)| high + frame.base_zero[Axis::Z]);
    let driven = driven.borrow();
    let own = driven.facts().travel_mm[Axis::Z.index()].filter(|_| driven.facts().homes);
    let own = own.map(|(_, high)| high);
    length.min(table.unwrap_or(f64::INFINITY)).min(own.unwrap_or(f64::INFINITY))
}

/// The reason for which a job cannot follow a map that lies at a zero: it leaves the map, or finds the surface itself.
pub(crate) fn job_leaves_map(
    sequence: &Sequence,
    map: Option<&HeightMap>,
    zero: Axes,
) -> Option<Diagnostic> {
    let (map, job) = (map?, sequence.job());
    if sequence.follows_sheet().is_some() {
        let why = "a height map is in force, and the job's height control (height.on) finds the surface itself";
        return Some(not_followed(&job.name, why.to_owned()));
    }
    let laid = Laid { map, zero, top_mm: f64::INFINITY };
    let leaves = |shape: &&JobShape| {
        let bounds = shape.path.bounds();
        let corners = [bounds.min, bounds.max].map(|corner| job.on_table(corner));
        let outside =
            |at: &kerf_geom::Point2| laid.outside_mm(Axes::xyz(at.x, at.y, 0.0)) > MARGIN_MM;
        !bounds.is_empty() && !shape.traversal && corners.iter().any(outside)
    };
    let shape = job.shapes.iter().find(leaves)?;
    Some(outside(SourcePlace::line(job.name.clone(), shape.number), map, sequence.settings()))
}

/// The note that Z follows a height map.
pub(crate) fn mapped_note(name: &Arc<str>) -> Diagnostic {
    let message = "Z follows the height map in force".to_owned();
    let note = Diagnostic::new(Code::Mapped, SourcePlace::line(name.clone(), 0), message);
    note.severity(Severity::Note).hint("kerf map off takes it off")
}

/// The error that a map cannot be followed.
pub(crate) fn not_followed(name: &Arc<str>, why: String) -> Diagnostic {
    Diagnostic::new(Code::MapNotFollowed, SourcePlace::line(name.clone(), 0), why)
        .hint("kerf map off")
}
