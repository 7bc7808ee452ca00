//! Ways down that are not as they were asked for, told before anything moves.

use crate::Sequence;
use kerf_diag::{Code, Diagnostic, Place};
use kerf_program::job::{Depths, JobShape, Plunge};
use kerf_program::{Command, Sourced};
use std::collections::BTreeSet;

impl Sequence {
    /// Tells what was changed since the job was made, and the shapes whose way down is another one than they ask
    /// for. What holds for all shapes of a group is told with the first of them.
    pub(crate) fn tell_entries(&self, out: &mut Vec<Sourced>) {
        let mut told = BTreeSet::new();
        let noted = self.job.notes.iter().map(|note| (note.shape, note.text.to_string()));
        let changed = self.job.shapes.iter().filter_map(|shape| {
            let why = self.other_entry(shape)?;
            Some((shape.number, format!("group {}: {why}", shape.group)))
        });
        for (number, message) in noted.chain(changed) {
            if told.insert(message.clone()) {
                let place = Place::line(self.job.name.clone(), number);
                let told = Diagnostic::new(Code::OtherEntry, place, message);
                self.give(Command::Diagnostic(Box::new(told)), out);
            }
        }
    }

    /// Tells what happens instead of the way down that a shape asks for, if something does.
    fn other_entry(&self, shape: &JobShape) -> Option<String> {
        let asked = match shape.plunge {
            _ if shape.traversal => return None,
            Plunge::Straight => return None,
            Plunge::Ramp { .. } => "ramp",
            Plunge::Helix { .. } => "helix",
        };
        let depths = Depths::of(shape.depth, &shape.z_mm, &self.heights).ok()?;
        let Depths::Level(levels) = depths else { return None };
        let straight = if self.machine.plasma.use_sequence {
            Some("the plasma torch starts above the sheet")
        } else if self.pierces(shape) {
            Some("the laser pierces")
        } else {
            self.height_law(shape).map(|_| "height control follows the sheet")
        };
        if let Some(why) = straight {
            return Some(format!("the tool goes straight down, without its {asked}: {why}"));
        }
        let drop_mm = self.heights.surface_mm - levels.first()?;
        shape.plunge.too_flat(&shape.path, drop_mm).map(|flat| flat.to_string())
    }
}
