//! The plane that everything is drawn and cut in.
//!
//! A [`Point2`] is a place, a [`Vec2`] a displacement: subtracting places gives a displacement, and
//! only a displacement can be scaled or turned. Lengths are millimetres wherever a tolerance is
//! involved ([`tol`] has all of them). Mathematical angles are radians, counter-clockwise from +X.
//! The *clock angles* of the Cut commands (degrees, clockwise from +Y, OpenSBP command reference, CC)
//! are converted by [`clock_to_vec`] and [`vec_to_clock`] and by nothing else.
//!
//! # Polyarcs
//!
//! A drawing is made of [`Polyarc`]s: lines and circular arcs end to end, an arc told by the *bulge*
//! of the vertex it starts at, tan(sweep / 4). Arcs stay arcs through every operation, because a
//! machine can cut them and because they are shorter and more exact than any list of chords. One
//! [`Segment`] of a polyarc knows its length, its bounds, the place nearest to another and where it
//! meets another segment; everything else is built from these.
//!
//! A contour that bounds material runs counter-clockwise, a hole in it clockwise: the area lies to the
//! left of travel. *Right* of travel is the positive side of an offset, so one positive number makes a
//! part larger and a hole smaller.

mod arc;
mod boolean;
mod bounds;
mod bounds2;
pub mod edit;
mod error;
pub mod fit;
mod index;
mod indexed;
mod offset;
mod point;
mod polyarc;
mod segment;
mod stitch;
pub mod tol;
mod transform;

pub use arc::Arc2;
pub use boolean::{Combine, combine, outline};
pub use bounds::Bounds3;
pub use bounds2::Bounds2;
pub use error::GeomError;
pub use index::BoxTree;
pub use indexed::Indexed;
pub use offset::{
    CHECK_MM, Coarse, OffsetPath, Offsetter, Origin, Proposer, offset, offset_by_chords,
    offset_region, parallel_path,
};
pub use point::{Point2, Vec2, clock_to_vec, vec_to_clock};
pub use polyarc::{Crossing, Polyarc, PolyarcPlace, Position, Vertex};
pub use segment::{Contact, Contacts, Foot, Segment};
pub use transform::Transform2;
