//! What a tool may read.

/// Folders from which a tool may read.
pub trait Folders {
    /// The text of a file in the part folder.
    fn text(&self, name: &str) -> Option<String>;

    /// The file of an installed font, by the font's name.
    ///
    /// # Errors
    /// There is none, and which there are.
    fn font(&self, name: &str) -> Result<Vec<u8>, String>;
}

/// Nothing to read.
impl Folders for () {
    fn text(&self, _: &str) -> Option<String> {
        None
    }

    fn font(&self, name: &str) -> Result<Vec<u8>, String> {
        Err(format!("there is no font {name}"))
    }
}
