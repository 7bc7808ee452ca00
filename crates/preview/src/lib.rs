//! Pictures of tool paths for people.
//!
//! A [`Scene`] is the motion of one program with the facts of its legend; [`svg`], [`png`] and
//! [`html`] turn it into a file. The SVG and the PNG are one drawing, described once as a sheet of
//! marks: true to scale, arcs exact, cuts shaded by depth, jogs red and dashed, start, end and
//! direction marked, with the table and its grid, rulers and a legend beside it. The page turns the
//! same motion in 3D, from one file and without a network. A [`plot::Plot`] shows how fast the motion
//! is: speed, acceleration and jerk over time and along the path.
//!
//! Everything here is a pure function: the same scene and options give the same bytes.
//!
//! ```
//! use kerf_preview::{Options, Scene, Segment, Shape, svg};
//! use kerf_program::MoveKind;
//!
//! let cut = Segment {
//!     kind: MoveKind::Cut,
//!     from: [10.0, 0.0, -1.0],
//!     to: [-10.0, 0.0, -1.0],
//!     shape: Shape::Arc { centre: [0.0, 0.0], sweep_rad: std::f64::consts::PI },
//!     line: 1,
//! };
//! let scene = Scene { title: "Half a circle".into(), segments: vec![cut], ..Scene::default() };
//! assert!(svg(&scene, &Options::default()).contains("<path"));
//! ```

mod font;
pub mod heights;
mod html;
mod options;
mod palette;
mod picture;
pub mod plot;
mod png;
mod scene;
mod sheet;
mod svg;
pub mod timing;
mod trail;

pub use font::file as font_file;
pub use options::Options;
pub use png::PngError;
pub use scene::{Coloured, FARTHEST_MM, Finding, Scene, Segment, Shape, TableView, ToolPath, Unit};
pub use trail::Trail;

/// The picture as SVG, one user unit a millimetre.
pub fn svg(scene: &Scene, options: &Options) -> String {
    svg::write(&picture::compose(scene, options))
}

/// A page that turns the motion in 3D, plays it and names source lines; one file, no network.
///
/// Arcs are drawn as chords within [`Options::chord_mm`]. With [`Scene::times_s`] the motion plays
/// in planned time, else along the path.
pub fn html(scene: &Scene, options: &Options) -> String {
    html::write(scene, options)
}

/// The same picture as PNG, its longer side [`Options::pixels`] long.
///
/// # Errors
/// [`PngError`] when the picture would be larger than memory allows.
pub fn png(scene: &Scene, options: &Options) -> Result<Vec<u8>, PngError> {
    png::paint(&picture::compose(scene, options), options.pixels)
}
