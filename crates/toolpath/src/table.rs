//! Checks that a job stays on the table.

use crate::job::DrawnJob;
use crate::warning::Warning;
use kerf_geom::Bounds2;
use std::collections::BTreeSet;

/// Overhang below which it is rounding, millimetres.
const ALLOWED_MM: f64 = 1e-6;

/// Warns of shapes whose paths leave a table, given in the coordinates of the job: the centre of the tool
/// would leave it. Each shape is told once, however often arrays repeat it.
pub fn off_table(job: &DrawnJob, table: &Bounds2) -> Vec<Warning> {
    let room = table.grown(ALLOWED_MM);
    let mut told = BTreeSet::new();
    let outside = job.paths.iter().filter_map(|path| {
        let mut bounds = path.shape.path.bounds();
        job.helix(path).iter().for_each(|circle| bounds.merge(&circle.bounds()));
        (!room.holds_box(&bounds) && told.insert(path.from)).then(|| {
            let text = format!("leaves the table: {}", how_far(&bounds, table));
            Warning { at: path.shape.path.start(), ..Warning::new(path.from, text) }
        })
    });
    outside.collect()
}

/// On which sides, and by how much.
fn how_far(bounds: &Bounds2, table: &Bounds2) -> String {
    let sides = [
        ("left", table.min.x - bounds.min.x),
        ("right", bounds.max.x - table.max.x),
        ("front", table.min.y - bounds.min.y),
        ("back", bounds.max.y - table.max.y),
    ];
    let over = sides.into_iter().filter(|(_, by)| *by > ALLOWED_MM);
    over.map(|(side, by)| format!("{by:.3} mm at the {side}")).collect::<Vec<_>>().join(", ")
}
