//! Curves that are no lines and arcs, replaced by lines and arcs within a tolerance.

mod bezier;
mod biarc;
mod ellipse;
mod nurbs;
mod points;
mod sampled;
mod smooth;

pub use bezier::Bezier;
pub use ellipse::Ellipse;
pub use nurbs::{Nurbs, NurbsError};
pub use points::points;
pub use sampled::{affine, curve};
pub use smooth::smoothed;
