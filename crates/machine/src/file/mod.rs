//! The configuration file: TOML with every setting, its unit, bounds and meaning.
//!
//! What a file does not name keeps its default. Everything it gets wrong is told, each mistake with
//! its line: a key that is not known, a value of the wrong type or out of bounds, settings that
//! contradict each other.

mod edit;
mod entries;
mod read;
mod write;

pub use edit::{edit, edit_all};
pub use read::{notes, read, read_back, read_over};
pub use write::{write, write_setting};

#[cfg(test)]
mod tests;
