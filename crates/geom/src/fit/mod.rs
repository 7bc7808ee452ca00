//! Curves that are no lines and arcs, replaced by lines and arcs within a tolerance.

mod biarc;
mod ellipse;
mod nurbs;
mod sampled;

pub use ellipse::Ellipse;
pub use nurbs::{Nurbs, NurbsError};
pub use sampled::{affine, curve};
