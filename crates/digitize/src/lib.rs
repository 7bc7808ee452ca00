//! Digitizing: a shape recorded by driving the tool to its points, one after the other (Profiler
//! reference, "Digitizing").
//!
//! ```text
//!            A                 L  line point: a straight segment ends and begins
//!          ·   ·               A  arc point: with its neighbours the one arc through the three
//!   L ─── L     L ─── L
//!   1     2  3  4     5        the current point: what is inserted, changed or deleted next
//! ```
//!
//! A [`Digitizer`] is the list of points and the edits on it. It moves nothing and knows no machine: it is
//! told where the tool [stands](Stand), gives the [way](Leg) to a point along the lines and arcs through
//! the points, and becomes a [`Shape`](kerf_drawing::Shape) of a drawing. Whatever cannot be is a
//! [`Refusal`], and then nothing is changed.
//!
//! Places are millimetres, X and Y from the job origin, Z from the machine's home. Heights of shapes count
//! from ZSurface, which is told where one is made or loaded.

mod digitizer;
mod point;
mod refusal;
mod shape;
mod way;

pub use digitizer::Digitizer;
pub use point::{Dimension, Kind, Point, Stand};
pub use refusal::Refusal;
pub use shape::nearest_shape;
pub use way::Leg;
