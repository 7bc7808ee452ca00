//! Kinds of file that pictures and diagrams are written as.

use crate::exit::Usage;
use anyhow::{Result, bail};
use std::path::Path;

/// Kind of file that a picture or a diagram is written as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PictureFormat {
    /// A drawing.
    Svg,
    /// Pixels.
    Png,
    /// A page that turns in 3D.
    Html,
    /// The numbers of a diagram.
    Json,
}

impl PictureFormat {
    /// Returns the kind that the ending of a file names.
    ///
    /// # Errors
    /// The ending is none of `written`, which are those of the command; `what` is the subject of the message, in the
    /// plural: `plots`.
    pub fn of(path: &Path, what: &str, written: &[Self]) -> Result<Self> {
        let extension = path.extension().unwrap_or_default().to_string_lossy().to_lowercase();
        let extension = if extension == "htm" { "html" } else { extension.as_str() };
        if let Some(format) = written.iter().find(|format| format.ending() == extension) {
            return Ok(*format);
        }
        let mut endings: Vec<_> =
            written.iter().map(|format| format!(".{}", format.ending())).collect();
        let last = endings.pop().unwrap_or_default();
        bail!(Usage(format!("{}: {what} end in {} or {last}", path.display(), endings.join(", "))))
    }

    /// The ending of its files, without a dot.
    fn ending(self) -> &'static str {
        match self {
            Self::Svg => "svg",
            Self::Png => "png",
            Self::Html => "html",
            Self::Json => "json",
        }
    }
}
