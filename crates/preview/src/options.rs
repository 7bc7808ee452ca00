//! Options of a picture, where a person may want it otherwise.

/// Choices that do not come from the program.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// Draw the width of the cutter under the path when the scene knows it.
    pub show_cutter: bool,
    /// Above so many segments the drawing is simplified within [`Options::detail`].
    pub detail_limit: usize,
    /// Allowed deviation when simplified, as a share of the drawing's longer side.
    pub detail: f64,
    /// Length of the longer side of a PNG, pixels.
    pub pixels: u32,
    /// Greatest distance between an arc and its chords in the 3D page, mm.
    pub chord_mm: f64,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            show_cutter: true,
            // About where editors and browsers start to feel slow with an SVG.
            detail_limit: 100_000,
            // A third of a pixel on a picture 1600 pixels wide.
            detail: 0.0002,
            pixels: 1600,
            chord_mm: 0.02,
        }
    }
}
