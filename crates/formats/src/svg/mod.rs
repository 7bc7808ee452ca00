//! SVG: paths and shapes of drawing programs, and drawings as SVG.
//!
//! Read are `path`, `rect`, `circle`, `ellipse`, `line`, `polyline` and `polygon` under all transforms,
//! and what `use` refers to. The page's size and `viewBox` tell the scale; a file without a size in
//! physical units has 96 units to the inch, as CSS says. Y, which points down in SVG, is turned up, with
//! the lower edge of the page at 0. Circular arcs stay arcs.
//!
//! Source: SVG 1.1 (second edition), W3C.

mod arc;
mod page;
mod path;
mod read;
mod shapes;
mod write;

pub use read::read;
pub use write::write;
