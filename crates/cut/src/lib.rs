//! The geometry of the Cut commands CA, CC, CG, CP and CR, and of tabs.
//!
//! Pure functions from numbers to [`Step`]s: the interpreter parses, fills defaults, calls one of
//! [`circle`], [`point_circle`], [`arc_to`], [`arch`] and [`rectangle`], and gets back the moves of
//! the whole command in order, or a [`CutError`] and no move at all. [`Tabber`] is a filter behind
//! that: it raises Z over tabs in a stream of steps, whoever made them.
//!
//! Every length is millimetres, Z grows upwards. Angles of the user are *clock degrees*: 0 is the
//! 12 o'clock point, clockwise (OpenSBP command reference, CC); they name places on the circle, not
//! directions of travel. All places are in one translated frame, the one in which
//! [`Context::start`] is given; the caller adds its offsets afterwards. Locations (the centre of CP,
//! the end of CG) come already scaled by the file's proportions; sizes (diameters, lengths, I, J,
//! plunges) come as the user wrote them and are scaled here.
//!
//! CC, CP, CG and CA are one thing in four spellings: a nominal circle, a place on it where the
//! tool begins, and an angle to sweep. Each of their files only translates its parameters into that
//! (`curve::Shape`); `curve` makes the path, `passes` the order of plunges and pull-ups.

mod arc_to;
mod arch;
mod circle;
mod context;
mod curve;
mod error;
mod passes;
mod rectangle;
mod segments;
mod step;
mod tab;

pub use arc_to::{ARC_TOLERANCE_MM, ArcTo, arc_to};
pub use arch::{Arch, arch};
pub use circle::{Circle, circle, point_circle};
pub use context::{Context, Direction, Side};
pub use error::{CutError, MAX_LENGTH_MM, MAX_STEPS};
pub use passes::{Feature, Passes};
pub use rectangle::{Corner, Rectangle, rectangle};
pub use segments::{FINE_CHORDS, MIN_CHORDS, MIN_SEGMENT_MM, chord_count};
pub use step::{Cut, Step};
pub use tab::Tabber;
