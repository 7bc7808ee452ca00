//! Groups that ask for more than the machine's cutting speed (Profiler reference, "Maximum Machine
//! Cutting Speeds").

use crate::setup::Setup;
use crate::values::Values;
use kerf_diag::{Code, Diagnostic, SourcePlace};
use kerf_program::job::JobShape;

/// Speeds are told in mm/min, to a tenth.
fn mm_min(mm_s: f64) -> f64 {
    (mm_s * 600.0).round() / 10.0
}

/// Tells, once for each group and cutting speed of the machine, that the group is cut slower than it asks for.
pub(crate) fn slower_warning(
    setup: &Setup,
    values: &mut Values,
    shape: &JobShape,
) -> Option<Diagnostic> {
    let asked = shape.speed_mm_s.filter(|_| !shape.traversal)?;
    let (asked, most) = (mm_min(asked), mm_min(values.cut_mm_s));
    if asked <= most || values.limited.contains(&shape.group) {
        return None;
    }
    values.limited.push(shape.group.clone());
    let place = SourcePlace::line(setup.job.name.clone(), shape.number);
    let group = &shape.group;
    let message = format!("group {group}: {asked} mm/min is limited to {most} mm/min");
    let hint = "Lower the group's speed, or raise the machine's cutting speed.";
    Some(Diagnostic::new(Code::SpeedLimited, place, message).hint(hint))
}
