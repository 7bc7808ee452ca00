//! SVG: paths and shapes of drawing programs, and drawings as SVG.
//!
//! Read are `path`, `rect`, `circle`, `ellipse`, `line`, `polyline` and `polygon` under all transforms,
//! and what `use` refers to. The page's size and `viewBox` tell the scale; a file without a size in
//! physical units has 96 units to the inch, as CSS says. Y, which points down in SVG, is turned up, with
//! the lower edge of the page at 0. Circular arcs stay arcs.
//!
//! Style sheets are read as far as they say what is seen, where and how large. What cannot be seen is left out, what cannot
//! be read too, and both are told with line and column.
//!
//! Sources: SVG 1.1 (second edition), SVG 2, CSS 2.1, W3C.

mod arc;
mod length;
mod look;
mod page;
mod path;
mod read;
mod shapes;
mod sheet;
mod text;
mod transform;
mod unread;
mod write;

pub use read::{read, read_until};
pub use write::write;
