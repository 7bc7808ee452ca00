//! DXF, the drawing exchange format, Release 12 to 2018, text and binary.
//!
//! ```text
//!  bytes ─ tag, binary ─► pairs ─ file ─► header, blocks, entities ─ import ─► shapes
//! ```
//!
//! Read are LINE, POINT, CIRCLE, ARC, ELLIPSE, POLYLINE, LWPOLYLINE, SPLINE and INSERT; everything
//! else is counted and told. Source: the DXF references of the releases, and real files.

mod binary;
mod chords;
mod curves;
mod file;
mod import;
mod importing;
mod insert;
mod map;
mod polyline;
mod skipped;
mod tag;
mod through;
mod units;
mod unseen;
mod write;

pub use import::{read, read_until};
pub use importing::Options;
pub use write::write;

pub(crate) use import::read_with_notes;
pub(crate) use write::{MARK, Notes, write_with};
