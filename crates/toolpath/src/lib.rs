//! Tool paths from drawings.
//!
//! ```text
//!  Drawing ─ shape by shape ─► smooth ─► offset ─► tag ─► lead-in, lead-out ─► passes    (Profiler reference,
//!                │                                                              "Tool path")
//!                └─ arrays: every path again in each block, in cutting order ─► DrawnJob ─► RSM
//! ```
//!
//! A [`DrawnJob`] is what is cut: paths in order, each with what it comes from, and the [`Warning`]s that
//! arose. Nothing is left out silently: a shape without a path is told with its number. It keeps the groups
//! of the drawing and can be edited as one; [`DrawnJob::machine_job`] gives the [`Job`](kerf_program::job::Job)
//! that a machine cuts and that printers write, in which each path has its own settings.
//!
//! Millimetres; positive offsets lie to the right of travel, as in [`kerf_geom::offset()`].

mod bridge;
mod depth;
mod entry;
#[cfg(test)]
#[path = "../../geom/tests/families/mod.rs"]
mod families;
mod filter;
mod gouge;
mod job;
mod job_offset;
mod lead;
mod lift;
mod machine_job;
mod making;
mod neighbours;
mod order;
mod overlap;
mod path_with_leads;
mod relief;
mod rsm;
mod shape_paths;
mod table;
mod tag;
mod twice;
mod warning;

pub use depth::{Depths, Heights, LowError};
pub use entry::too_flat;
pub use filter::{filtered, too_near};
pub use job::{CutPath, DrawnJob, too_deep};
pub use job_offset::{NoRoom, offset_job};
pub use lead::{Side, lead_in, lead_out};
pub use lift::{lifted, lowest_mm};
pub use making::{
    JobError, MOST_PATHS, Shaping, job, shaped, shaped_job, shaped_job_until, smoothed_job,
};
pub use relief::{Relief, print_relief};
pub use rsm::{Damaged, read, read_until, read_whole, write};
pub use shape_paths::Pass;
pub use table::off_table;
pub use warning::Warning;
