//! Kinds of files, by their extension.

use std::path::Path;

/// Returns `true` if a file is a drawing or a job made of one.
pub fn is_drawing(file: &Path) -> bool {
    matches!(extension(file).as_str(), "dxf" | "svg" | "plt" | "hpg" | "hpgl" | "rsg" | "rsm")
}

/// The extension of a file, in small letters.
pub fn extension(file: &Path) -> String {
    file.extension().map(|e| e.to_string_lossy().to_ascii_lowercase()).unwrap_or_default()
}
