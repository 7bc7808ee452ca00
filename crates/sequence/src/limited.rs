//! Groups that ask for more than the machine's cutting speed (Profiler reference, "Maximum Machine
//! Cutting Speeds").

use crate::Sequence;
use kerf_diag::{Code, Diagnostic, Place};
use kerf_program::job::JobShape;
use kerf_program::{Command, Sourced};

/// Speeds are told in mm/min, to a tenth.
fn mm_min(mm_s: f64) -> f64 {
    (mm_s * 600.0).round() / 10.0
}

impl Sequence {
    /// Tells, once for each group and cutting speed of the machine, that the group is cut slower than it
    /// asks for.
    pub(crate) fn tell_limited(&mut self, shape: &JobShape, out: &mut Vec<Sourced>) {
        let Some(asked) = shape.speed_mm_s.filter(|_| !shape.traversal) else { return };
        let (asked, most) = (mm_min(asked), mm_min(self.cut_mm_s));
        if asked <= most || self.limited.contains(&shape.group) {
            return;
        }
        self.limited.push(shape.group.clone());
        let place = Place::line(self.job.name.clone(), shape.number);
        let group = &shape.group;
        let message = format!("group {group}: {asked} mm/min is limited to {most} mm/min");
        let hint = "Lower the group's speed, or raise the machine's cutting speed.";
        let told = Diagnostic::new(Code::SpeedLimited, place, message).hint(hint);
        self.give(Command::Diagnostic(Box::new(told)), out);
    }

    /// From here on the machine cuts at most so fast, mm/s.
    pub(crate) fn use_cut_speed(&mut self, mm_s: f64) {
        self.cut_mm_s = mm_s;
        self.limited.clear();
    }
}
