//! Commands that are carried out elsewhere because the workpiece was nudged.

use crate::{Axes, Axis, Command};

impl Command {
    /// The same command for a workpiece that lies elsewhere by so much, machine frame: places and
    /// working zero move, table base coordinates stay.
    pub fn shift(&mut self, by: Axes) {
        match self {
            Self::Line(line) => line.to = line.to.plus(by),
            Self::Arc(arc) => {
                arc.to = arc.to.plus(by);
                arc.centre[0] += by[Axis::X];
                arc.centre[1] += by[Axis::Y];
            }
            Self::Location { frame, .. } => frame.working_zero = frame.working_zero.plus(by),
            _ => {}
        }
    }
}
