//! Places, displacements, circular arcs and bounds.
//!
//! A [`Point2`] is a place, a [`Vec2`] a displacement: subtracting places gives a displacement, and
//! only a displacement can be scaled or turned. Lengths carry no unit here; callers keep
//! millimetres. Mathematical angles are radians, counter-clockwise from +X. The *clock angles* of
//! the Cut commands (degrees, clockwise from +Y, OpenSBP command reference, CC) are converted by
//! [`clock_to_vec`] and [`vec_to_clock`] and by nothing else.

mod arc;
mod bounds;
mod point;

pub use arc::Arc2;
pub use bounds::Bounds3;
pub use point::{Point2, Vec2, clock_to_vec, vec_to_clock};
